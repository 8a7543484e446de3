# chasles compare --device: the same table as without, bad lines, dead devices, and devices that are wrong.
PROGRAM=$1
device=$2
hollow=$3
python=$4
vectors=$5
here=$(cd "$(dirname "$0")" && pwd)
. "$here/expect.sh"

# The same rows as without a device, but for the added columns.
run 0 compare --csv here.csv --only so3_exp,so3_check,tilt_error "$vectors"
run 0 compare --csv there.csv --json there.json --counts counts.csv --device "exec:$device" --only so3_exp,so3_check,tilt_error "$vectors"
err_empty
out_has ' PASS  same bits '
out_has 'same bits 3'
out_has ', other bits 0; requests repeated 0 (0 damaged lines, 0 silences)'
cut -d, -f1-11 there.csv | cmp -s - here.csv || fail "the table differs from the one without a device"
file_has there.csv ',result,other_bits,least_instructions,most_instructions'
file_has there.json '"other_bits": 0,'
file_has counts.csv 'function,precision,band,case,status,count'
[ "$(grep -c '^[a-z]' counts.csv)" -eq $(($(grep -c '^case' "$vectors"/so3_exp.f*.txt "$vectors"/so3_check.f*.txt \
  "$vectors"/tilt_error.f*.txt | awk -F: '{n += $2} END {print n}') + 1)) ] || fail "a line for each call"
run 2 compare --counts counts.csv "$vectors"
err_is 'chasles: --counts needs --device: only a device counts'

# Every third line damaged: repeated, counted, and nothing lost.
run 0 compare --csv noisy.csv --device "exec:$python $here/noisy.py 0.002 1 $device" --only so3_exp "$vectors"
err_empty
out_has ', other bits 0; requests repeated '
out_lacks 'requests repeated 0 '
sed -n '1p;/^so3_exp/p' there.csv | cmp -s - noisy.csv || fail "the table differs over a noisy line"

# The same behind a TCP port and behind a serial one, at a rate of its own.
for kind in tcp pty; do
  "$python" "$here/attach.py" $kind $kind.name "$device" &
  relay=$!
  for second in 1 2 3 4 5 6 7 8 9 10; do [ -f $kind.name ] || sleep 1; done
  rate=$([ $kind = pty ] && echo :230400)
  run 0 compare --csv $kind.csv --device "$(cat $kind.name)$rate" --only so3_exp "$vectors"
  err_empty
  out_has ', other bits 0; requests repeated 0 (0 damaged lines, 0 silences)'
  sed -n '1p;/^so3_exp/p' there.csv | cmp -s - $kind.csv || fail "the table differs behind $kind"
  kill $relay 2>/dev/null
done

# A device that computes something else.
run 1 compare --device "exec:$hollow" --only so3_hat "$vectors"
err_empty
out_has ' differ  '
out_has ' on the device, 0x0p+0 here'
out_has ', same bits 0, other bits '
out_has '... and '

# No device there: a clear error within seconds, and no table.
dead() {
  start=$(date +%s)
  run 2 compare --device "$1" --only so3_hat "$vectors"
  err_is "$2"
  [ ! -s out ] || fail "nothing should be reported as compared"
  [ $(($(date +%s) - start)) -le 15 ] || fail "that took too long"
}
dead 'exec:exec sleep 60' 'chasles: the device exec:exec sleep 60 does not answer (asked for its version)'
dead 'exec:exit 3' 'chasles: the device exec:exit 3 ended with exit status 3 (asked for its version)'
dead 'exec:exec yes' 'chasles: the device exec:exec yes sends nothing that makes sense (asked for its version)'
dead 'exec:exec yes :' 'chasles: the device exec:exec yes : cannot be understood: the line is too noisy (asked for its version)'
dead /dev/no_such_port 'chasles: cannot open the device /dev/no_such_port: No such file or directory'
dead /dev/null 'chasles: cannot open the device /dev/null: Inappropriate ioctl for device'
dead /dev/null:1200 'chasles: cannot open the device /dev/null:1200: not one of the usual baud rates'
dead tcp:127.0.0.1:1 'chasles: cannot open the device tcp:127.0.0.1:1: Connection refused'
dead tcp:127.0.0.1 'chasles: cannot open the device tcp:127.0.0.1: expected tcp:HOST:PORT'
dead com1 'chasles: cannot open the device com1: expected tcp:HOST:PORT, exec:COMMAND or /dev/NAME[:BAUD]'

# A device that dies on the way: the first answers are there, and are not reported.
command="exec:dd bs=1 count=3000 status=none | $device"
dead "$command" "chasles: the device $command ended with exit status 0 (so3_hat)"

# Another library, or another version of it.
command="exec:$device | sed -u s/hello.01/hello.02/"
dead "$command" "chasles: the device $command cannot be understood: the line is too noisy (asked for its version)"
cat >other.py <<'END'
import zlib
text = input()[1:9] + " hello 01 0.0.9 00000000 other"
print(f":{text}*{zlib.crc32(text.encode()):08x}")
END
dead "exec:$python other.py" "chasles: the device exec:$python other.py has chasles 0.0.9, protocol 1; this program is $("$PROGRAM" --version | cut -d' ' -f2), protocol 1"

finish
