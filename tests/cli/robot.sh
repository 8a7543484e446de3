# chasles fk, ik and dh: the robots that come with the program, and robot files that are not what they should be.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"
ROBOTS=$3

# row N TEXT: row N of what was printed is these numbers.
row() {
  sed -n "$1p" out | awk -v text="$2" '
    { n = split(text, x, " "); wrong = n != NF
      for (i = 1; i <= n; i++) if ($i - x[i] > 1e-8 || x[i] - $i > 1e-8) wrong = 1
      exit wrong }' || fail "row $1 should be: $2"
}

run 0 fk "$ROBOTS/ur5e.robot" 0 0 0 0 0 0
row 1 '1 0 0 -0.8172'
row 2 '0 0 -1 -0.2329'
row 3 '0 1 0 0.0628'
err_empty
run 0 fk "$ROBOTS/puma560.robot" 90 0 90 0 0 0
row 1 '0 -1 0 -149.09'
row 2 '0 0 1 921.12'
row 3 '-1 0 0 20.32'
run 1 fk "$ROBOTS/panda.robot" 0 0 0 0 0 0 0
row 1 '1 0 0 0.088'
row 2 '0 -1 0 0'
row 3 '0 0 -1 0.926'
err_is 'chasles: joint 4 is beyond its limits, -3.0718 to -0.0698'
run 0 fk "$ROBOTS/scara.robot" 90 -90 100 0
row 1 '1 0 0 375'
row 2 '0 -1 0 425'
row 3 '0 0 -1 577'
run 1 fk "$ROBOTS/scara.robot" 90 -90 200 0
err_is 'chasles: joint 3 is beyond its limits, 0 to 195'

run 0 fk --jacobian body "$ROBOTS/scara.robot" 0 0 0 0
out_has 'jacobian'
row 5 '0 0 0 0'
row 7 '-1 -1 0 1'
row 8 '0 0 0 0'
row 9 '-800 -375 0 0'
row 10 '0 0 1 0'
out_has 'singular values'
out_lacks 'determinant'
run 0 fk --jacobian space --links "$ROBOTS/ur5e.robot" 0 0 0 0 0 0
out_has 'link 6'
out_has 'determinant'
run 0 fk --exact "$ROBOTS/scara.robot" 0 0 0 0
[ "$(cat out)" = "1 0 0 800
0 -1 0 0
0 0 -1 677" ] || fail 'a digit is missing or too many'

# The same arm from its screws and from both conventions of Denavit and Hartenberg.
cat >arm.screws <<'END'
robot arm
angles degrees
lengths m
rows screws
revolute  0 0 2  0 0 7  limits -90 90   # the length of a direction does not matter
revolute  0 -1 0 0 5 0.5
prismatic 1 0 0
home  0 0 1 0.25   1 0 0 0   0 1 0 0.5
END
cat >arm.standard <<'END'
robot arm
angles degrees
lengths m
rows dh-standard
revolute  0 90 0.5 0
revolute  0 90 0 90
prismatic 0 0 0.25 -90
END
run 0 fk --exact arm.screws 30 -40 0.125
cp out expected
run 0 fk --exact arm.standard 30 -40 0.125
awk 'NR == FNR { want[FNR] = $0; next } { n = split(want[FNR], x, " ")
  for (i = 1; i <= n; i++) if ($i - x[i] > 1e-12 || x[i] - $i > 1e-12) bad = 1 } END { exit bad }' expected out ||
  fail 'screws and Denavit-Hartenberg rows differ'

# same FILE: every number of FILE is that of what was printed.
same() {
  awk 'NR == FNR { want[FNR] = $0; next } { n = split(want[FNR], x, " "); if (n != NF) bad = 1
    for (i = 1; i <= n; i++) if ($i - x[i] > 1e-7 || x[i] - $i > 1e-7) bad = 1 } END { exit bad }' "$1" out ||
    fail "the numbers differ from those of $1: $(cat "$1")"
}

# Each robot in each of the three ways, and back again.
again() {
  robot=$1
  shift
  run 0 fk --exact "$ROBOTS/$robot.robot" "$@"
  cp out expected
  for rows in screws dh-standard dh-modified; do
    run 0 dh --rows $rows "$ROBOTS/$robot.robot"
    cp out $rows.robot
    file_has $rows.robot "rows $rows"
    file_has $rows.robot limits
    run 0 fk --exact $rows.robot "$@"
    same expected
    for back in screws dh-standard dh-modified; do
      run 0 dh --rows $back $rows.robot
      cp out back.robot
      run 0 fk --exact back.robot "$@"
      same expected
    done
  done
}
again ur5e 10 -80 70 20 60 5
again puma560 10 -80 70 20 60 5
again panda 0.1 -0.2 0.3 -1.4 0.5 0.6 0.7
again scara 10 -80 70 20
run 0 dh "$ROBOTS/scara.robot"
out_has 'revolute 425 0 0 0  limits -150 150'
out_has 'revolute 375 180 0 0  limits -140 140'
run 2 dh --rows four "$ROBOTS/ur5e.robot"
err_is "chasles: --rows expects dh-standard, dh-modified or screws, not 'four'"
run 2 dh --tolerance -1 "$ROBOTS/ur5e.robot"
err_is "chasles: --tolerance expects a number of at least 0, not '-1'"
run 2 dh
err_is "chasles: dh expects one file of a robot; see 'chasles help dh'"
sed '6s/revolute  0 -1 0 0 5 0.5/helical 0 -1 0 0 5 0.5 0.01/' arm.screws >nut.robot
run 2 dh nut.robot
err_is "chasles: joint 2 of arm is helical, which Denavit and Hartenberg's parameters cannot tell"
run 0 dh --rows screws nut.robot
out_has 'helical 0 -1 0 0 0 0.5 0.01'


# A file without a name and a unit, and what is rounded to zero.
cat >bare.robot <<'END'
angles degrees
rows screws
revolute  0 0 1  0 0 0
home  1 0 0
END
run 0 dh bare.robot
cp out bare.dh
run 0 fk bare.dh -360
out_lacks '-0.0'
run 2 fk bare.robot
err_is 'chasles: unnamed has 1 joint, and 0 values are given'
run 0 ik bare.robot 0 1 0 0 0 90
grep -q '^left: [^ ]* rad, [^ ]*: ok$' out || fail 'a unit is missing or too many'

# What forward kinematics gave, inverse kinematics takes back.
for robot in 'ur5e 10 -80 70 20 60 5' 'puma560 10 -80 70 20 60 5' 'scara 10 -80 70 20'; do
  set -- $robot
  name=$1
  shift
  run 0 fk --exact "$ROBOTS/$name.robot" "$@"
  pose=$(cat out)
  for method in newton damped; do
    run 0 ik --exact --method $method "$ROBOTS/$name.robot" $pose
    run 0 fk --exact "$ROBOTS/$name.robot" $(cat out)
    echo "$pose" >expected
    same expected
  done
  run 0 ik --start "$(echo "$*" | tr ' ' ,)" --exact "$ROBOTS/$name.robot" $pose
  echo "$*" >expected
  same expected
done
run 0 ik "$ROBOTS/ur5e.robot" 0.4 -0.2 0.3 0 180 0
out_has ': ok'
run 1 ik "$ROBOTS/ur5e.robot" 1.4 -0.2 0.3 0 180 0
out_has ' m: no joint moves the tool nearer, as where it is out of reach'
run 1 ik --exact --restarts 2 "$ROBOTS/scara.robot" 3000 0 100 0 180 0
run 1 ik --steps 0 --restarts 0 "$ROBOTS/ur5e.robot" 0.4 -0.2 0.3 0 180 0
out_has 'not converged in the steps allowed'
run 2 ik "$ROBOTS/ur5e.robot" 1 2 3
err_is "chasles: a pose has 6 or 12 numbers, and 3 are given; see 'chasles help ik'"
run 2 ik "$ROBOTS/ur5e.robot" 1 2 3 4 5 x
err_is "chasles: expected a number of a pose, not 'x'"
run 2 ik "$ROBOTS/ur5e.robot" 1 0 0 0 0 1 0 0 0 0 -1 0
err_is 'chasles: a matrix is a reflection'
run 2 ik --start 1,2 "$ROBOTS/ur5e.robot" 1 2 3 0 0 0
err_is "chasles: --start expects 6 numbers parted by commas, not '1,2'"
run 2 ik --method guess "$ROBOTS/ur5e.robot" 1 2 3 0 0 0
err_is "chasles: --method expects newton or damped, not 'guess'"
run 2 ik --angle 1 "$ROBOTS/ur5e.robot" 1 2 3 0 0 0
err_is "chasles: --angle expects an angle above 0 with rad or deg behind it, not '1'"
run 2 ik --length 0 "$ROBOTS/ur5e.robot" 1 2 3 0 0 0
err_is "chasles: --length expects a number above 0, not '0'"
run 2 ik "$ROBOTS/ur5e.robot" 1 2 3 0 0 0 --exact
err_is "chasles: options stand before the file of the robot, and '--exact' behind it"
run 2 ik --steps many "$ROBOTS/ur5e.robot" 1 2 3 0 0 0
err_is "chasles: --steps expects a number from 0 to 1000000, not 'many'"
run 2 ik
err_is "chasles: ik expects the file of a robot; see 'chasles help ik'"

# Arguments.
run 2 fk
err_is "chasles: fk expects the file of a robot; see 'chasles help fk'"
run 2 fk nothing.robot 0
err_is 'chasles: cannot read nothing.robot: No such file or directory'
run 2 fk arm.screws 0 0
err_is 'chasles: arm has 3 joints, and 2 values are given'
run 2 fk arm.screws 0 0 0 --links
err_is "chasles: options stand before the file of the robot, and '--links' behind it"
run 2 fk arm.screws 0 zero 0
err_is "chasles: expected a number as value of joint 2, not 'zero'"
run 2 fk --jacobian tool arm.screws 0 0 0
err_is "chasles: --jacobian expects space or body, not 'tool'"
run 2 fk arm.screws 1e300 0 0
err_is 'chasles: an angle is too large to be reduced modulo 2 pi'

# Malformed files: a sed command, the line of the complaint, and what it says.
malformed() {
  sed "$1" arm.screws >bad
  run 2 fk bad 0 0 0
  err_is "bad:$2: expected $3"
}
malformed 's/robot arm/robot/' 1 'a name, found nothing'
malformed 's/lengths m/lengths of an arm and of a leg/' 3 "at most 15 characters, found 'of an arm and of a leg'"
malformed 's/^angles/angels/' 2 "robot, angles, lengths, rows, revolute, prismatic, helical, home, base or tool, found 'angels'"
malformed 's/degrees/grad/' 2 "degrees or radians, found 'grad'"
malformed 's/angles degrees//' 5 "'angles degrees' or 'angles radians' before the joints, found 'revolute'"
malformed 's/rows screws//' 5 "'rows screws', 'rows dh-standard' or 'rows dh-modified' first, found 'revolute'"
malformed 's/rows screws/rows dh/' 4 "screws, dh-standard or dh-modified, found 'dh'"
malformed 's/0 0 7/0 0/' 5 "a number with a decimal point, found 'limits'"
malformed 's/0 0 7/0 0 7 8/' 5 "'limits' or the end of the line, found '8'"
malformed 's/0 0 2/0 0 0/' 5 "the direction of an axis, found '0 0 0'"
malformed 's/-90 90/90 -90/' 5 "the lower limit first, found '90'"
malformed 's/-90 90/-90/' 5 'a number with a decimal point, found nothing'
malformed 's/-90 90/-90 90 1/' 5 "nothing more on this line, found '1'"
malformed 's/0.25 /0.25 0x1/' 8 "a number with a decimal point, found '0x1'"
malformed 's/0.25 /0.25 1/' 8 "nothing more on this line, found '0.5'"
malformed 's/0 0 1 0.25/0.25/' 8 '3 or 12 numbers of a pose, found nothing'
malformed 's/0 0 1 0.25/0 0 -1 0.25/' 8 "a pose, found 'a matrix is a reflection'"
malformed '$s/home/tool/' 8 "'tool' behind 'rows dh-standard' or 'rows dh-modified' only, found 'tool'"
malformed '3s/.*/base 0 0 1/' 3 "'base' behind 'rows dh-standard' or 'rows dh-modified' only, found 'base'"
malformed '6s/.*/rows dh-standard/' 6 "no second 'rows', found 'rows'"
malformed '6s/.*/angles radians/' 6 "no second 'angles', found 'angles'"
malformed '$p' 9 "no second 'home', found 'home'"
malformed '$d' 7 "'home', found the end of the file"
malformed '5,7d' 5 'a joint, found the end of the file'
malformed 's/rows screws/rows dh-modified/; s/prismatic/helical/' 5 "'limits' or the end of the line, found '0'"
malformed '7s/prismatic/helical/; 5,6d; s/screws/dh-standard/' 5 "a revolute or prismatic joint, found 'helical'"

finish
