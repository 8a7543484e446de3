# What README.md and the helps show to be typed can be typed, and the robot of README.md is one.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"
SOURCE=$3
ln -s "$SOURCE/tests" tests
ln -s "$SOURCE/tools" tools
ln -s "$PROGRAM" chasles
PATH=$PWD:$PATH

# The markers that the examples name: a forearm and an arm, before and after a turn.
cat >trial.csv <<'END'
Arm1_x,Arm1_y,Arm1_z,Arm2_x,Arm2_y,Arm2_z,Arm3_x,Arm3_y,Arm3_z,Forearm1_x,Forearm1_y,Forearm1_z,Forearm2_x,Forearm2_y,Forearm2_z,Forearm3_x,Forearm3_y,Forearm3_z
0,0,0,1,0,0,0,2,0,3,0,0,4,0,0,3,1,0
0,0,0,0,1,0,-2,0,0,0,3,0,0,3,1,-1,3,0
END

{
  sed -n 's/^    \(chasles .*\)/\1/p' "$SOURCE/README.md"
  for command in compare solve study fk ik dh agile-eye arm-error hash; do
    "$PROGRAM" help "$command" | awk '
      /^examples:/ { examples = 1; next }
      examples && /^    / { line = line " " $0; next }
      examples { if (line != "") print line; line = $0 }
      END { if (line != "") print line }' | sed -n 's/^ *\(chasles .*\)/\1/p'
  done
} | sed 's/ *#.*//' | sort -u >typed
[ "$(grep -c . typed)" -ge 20 ] || fail "few examples were found"

# Not without a device, nor the pictures; and less of what takes long.
grep -v -e /dev/ -e python3 -e agile-eye typed |
  sed 's/--cases 100000/--cases 100/; s/chasles hash/& --cases 100/; s/study/& --sets 5 --noisy-sets 2/; s/--step 2/&0/' >examples
while read -r line; do
  ran=$line
  sh -c "$line" >out 2>err </dev/null
  status=$?
  [ "$status" -eq 0 ] || fail "an example fails"
done <examples

sed -n '/^    robot Example/,/^    home /s/^    //p' "$SOURCE/README.md" >example.robot
run 0 fk example.robot 90 0 0.1
run 0 dh --rows screws example.robot
out_has 'helical'

finish
