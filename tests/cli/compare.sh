# chasles compare: verdicts, outputs, and files that are not what they should be.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

# [w] of w = (1, 2, 3) and, with a status, the exponential of a zero vector and of a NaN.
mkdir good
cat >good/so3_hat.f64.txt <<'END'
# a comment, and a blank line

chasles-vectors 1
function so3_hat
precision double
inputs 3
outputs 9
group all max 0 1 2 3 4 5 6 7 8
case whole ordinary 0
in 0x1p+0 0x1p+1 0x1.8p+1
out 0 0 -0x1.8p+1 0 0x1p+1 0 0x1.8p+1 0 -0 0 -0x1p+0 0 -0x1p+1 0 0x1p+0 0 0 0
scale 0
case infinite degenerate 0
in inf -0x0.0000000000001p-1022 nan
out 0 0 nan 0 -0x0.0000000000001p-1022 0 nan 0 0 0 -inf 0 0x0.0000000000001p-1022 0 inf 0 0 0
scale 0
END
cat >good/so3_exp.f32.txt <<'END'
chasles-vectors 1
function so3_exp
precision float
inputs 3
outputs 9
group diagonal max 0 4 8
group off_diagonal max 1 2 3 5 6 7
case zero example 0
in 0 0 -0
out 0x1p+0 0 0 0 0 0 0 0 0x1p+0 0 0 0 0 0 0 0 0x1p+0 0
scale 0x1p+0 0
case not_a_number degenerate -1|-2
in 0 nan 0
END

run 0 compare good
err_empty
out_has 'so3_hat                    double ordinary        1     0.000     0.000       0  PASS  whole'
out_has 'so3_exp.diagonal           float  example         1     0.000     0.000       2  PASS  zero'
out_has 'so3_exp.off_diagonal       float  degenerate      1         -         -       -  PASS  -'
out_has 'so3_exp_array.diagonal     float  example         1     0.000     0.000       2  PASS  zero'
out_has 'PASS: functions 3, files 2, cases 6, failed 0; '
out_has 'not compared, no vectors: so3_vee, so3_log, '
cp out all

run 0 compare good/so3_hat.f64.txt good/so3_exp.f32.txt good
cmp -s out all || fail "the order of the arguments, or a repeated one, makes a difference"
run 0 compare --quiet good
out_lacks whole
run 0 compare --only so3_hat good
out_has 'PASS: functions 1, files 1, cases 2, failed 0; '
out_lacks so3_exp
run 0 compare --only so3_exp_array good
out_has 'PASS: functions 1, files 1, cases 2, failed 0; '
sed 's/$/\r/' good/so3_hat.f64.txt >dos
run 0 compare - <dos
out_has ' cases 2, failed 0; '

run 0 compare --csv rows.csv --json report.json good
file_has rows.csv 'so3_exp,off_diagonal,float,example,1,0,0,0,2,zero,PASS'
file_has rows.csv 'so3_exp,diagonal,float,degenerate,1,0,,,,,PASS'
file_has report.json '"cases": 6,'
file_has report.json '"worst_case": "whole", "pass": true'
run 2 compare --csv nowhere/rows.csv good
err_is 'chasles: cannot write nowhere/rows.csv: No such file or directory'
if [ -c /dev/full ]; then
  run 2 compare --json /dev/full good
  err_is 'chasles: cannot write /dev/full: No space left on device'
fi

# A wrong result, a wrong status, and errors that the rest of the exact result alone makes: half as much again as the
# promise fails, the promise itself passes.
sed 's/out 0 0 -0x1.8p+1/out 0 0 -0x1.8000001p+1/' good/so3_hat.f64.txt >wrong.f64.txt
run 1 compare --worst 1 --json report.json --csv rows.csv wrong.f64.txt
out_has 'so3_hat  double ordinary        1       inf       inf       0  FAIL  whole'
out_has '   largest error: inf eps in all, promise 0'
out_has '   in[2]  0x1.8p+1 (3)'
out_has '   out[1]  got -0x1.8p+1 (-3)  expected -0x1.8000001p+1 (-3.0000000074505806) + 0x0p+0'
out_has 'FAIL: functions 1, files 1, cases 2, failed 1; '
file_has report.json '"largest_eps": "inf"'
file_has rows.csv 'so3_hat,all,double,ordinary,1,1,inf,inf,0,whole,FAIL'

sed 's/case zero example 0/case zero example 2/' good/so3_exp.f32.txt >status.f32.txt
run 1 compare --json report.json status.f32.txt
out_has 'status.f32.txt:8: so3_exp float zero: wrong status, expected 2 ('
out_has '), got 0 ('
out_has 'so3_exp.diagonal           float  example         1     0.000     0.000       2  FAIL  zero'
file_has report.json '"fault": "wrong status", "expected": [2], "got": 0}'

sed 's/out 0x1p+0 0 /out 0x1p+0 0x1.8p-22 /' good/so3_exp.f32.txt >near.f32.txt
run 1 compare near.f32.txt
out_has 'so3_exp.diagonal           float  example         1     3.000     3.000       2  FAIL  zero'
sed 's/out 0x1p+0 0 /out 0x1p+0 -0x1p-22 /' good/so3_exp.f32.txt >near.f32.txt
run 0 compare near.f32.txt
out_has 'so3_exp.diagonal           float  example         1     2.000     2.000       2  PASS  zero'

# The norm of a group, and the wider promise beyond pi.
sed -e 's/diagonal max/diagonal norm/' -e 's/0x1p+0 0 /0x1p+0 0x1.8p-22 /' -e 's/ 0x1p+0 0 / 0x1p+0 0x1p-21 /' \
  good/so3_exp.f32.txt >norm.f32.txt
run 1 compare norm.f32.txt
out_has 'so3_exp.diagonal           float  example         1     5.000     5.000       2  FAIL  zero'
sed -e 's/zero example/zero far/' -e 's/out 0x1p+0 0 /out 0x1p+0 0x1.8p-22 /' good/so3_exp.f32.txt >far.f32.txt
run 0 compare far.f32.txt
out_has 'so3_exp.diagonal           float  far             1     3.000     3.000       4  PASS  zero'

# Nothing to read.
run 2 compare nowhere
err_is 'chasles: cannot read nowhere: No such file or directory'
mkdir empty
run 2 compare empty
err_is 'chasles: empty holds no vector file: none of its names ends in .f64.txt or .f32.txt'
run 2 compare --only so3_ex good
err_starts "chasles: the library has no function 'so3_ex'"
run 2 compare --only so3_log good
err_is 'chasles: no vectors of so3_log in what was given'

# Malformed files: a sed command, the line of the complaint, and what it says.
malformed() {
  sed "$1" good/so3_exp.f32.txt >bad
  run 2 compare bad
  err_is "bad:$2: expected $3"
}
malformed 1d 1 "'chasles-vectors', found 'function'"
malformed '1s/1/2/' 1 "chasles-vectors 1, found '2'"
malformed '2s/exp/expo/' 2 "a function of chasles $("$PROGRAM" --version | cut -d' ' -f2), found 'so3_expo'"
malformed '3s/float/half/' 3 "'double' or 'float', found 'half'"
malformed '4s/3/4/' 4 "inputs 3, found '4'"
malformed '5s/9/99999999999999999999/' 5 "outputs 9, found '99999999999999999999'"
malformed '6s/diagonal/axis/' 6 "a group that so3_exp has a promise for, found 'axis'"
malformed '6s/max/mean/' 6 "'max' or 'norm', found 'mean'"
malformed '6s/8/9/' 6 "an output from 0 to 8 that no group has yet, found '9'"
malformed '7s/1/0/' 7 "an output from 0 to 8 that no group has yet, found '0'"
malformed 7d 7 "'group', found 'case'"
malformed '8,$d' 7 "'case', found the end of the file"
malformed '8s/zero/ze"ro/' 8 "a case's name of at most 63 letters and digits, found 'ze\"ro'"
malformed '8s/ 0$//' 8 "the status of case zero, found nothing"
malformed '8s/ 0$/ ok/' 8 "a status, or up to 4 parted by |, found 'ok'"
malformed '8s/ 0$/ 0|1|2|3|4/' 8 "a status, or up to 4 parted by |, found '4'"
malformed '9s/ -0$//' 9 "input 2: a hexadecimal float, 0, -0, nan, inf or -inf, found nothing"
malformed '9s/-0/1.5/' 9 "input 2: a hexadecimal float, 0, -0, nan, inf or -inf, found '1.5'"
malformed '9s/-0/0x1p+0z/' 9 "input 2: a hexadecimal float, 0, -0, nan, inf or -inf, found '0x1p+0z'"
malformed '9s/-0/0x1p+9999/' 9 "input 2: a hexadecimal float, 0, -0, nan, inf or -inf, found '0x1p+9999'"
malformed '9s/-0/0x1.0000001p+0/' 9 'input 2: a number that a float holds, found 0x1.0000001p+0'
malformed '9s/$/ 0/' 9 "the end of the line, found '0'"
malformed 10d 10 "'out', found 'scale'"
malformed '10s/ 0 / nan /' 10 'the rest of an output: a finite number, found nan'
malformed '11s/ 0$/ -0x1p+0/' 11 "a group's scale: a finite number of at least 0, found -0x1p+0"
malformed '11s/ 0$//' 11 "a group's scale: a hexadecimal float, 0, -0, nan, inf or -inf, found nothing"
malformed '13d' 12 "'in', found the end of the file"
malformed '13s/.*/in 0 nan 0\nout 0/' 14 "'case', found 'out'"

{ cat good/so3_exp.f32.txt; head -c 20000 /dev/zero | tr '\0' x; echo; } >bad
run 2 compare bad
err_is 'bad:14: expected a line of at most 16384 characters, found a longer one'
{ cat good/so3_exp.f32.txt; printf 'case a\0b'; } >bad
run 2 compare bad
err_is 'bad:14: expected text, found a zero byte'
printf '\033[2J\377\001' >bad
run 2 compare bad
err_is 'bad:1: expected a line feed after the last line, found the end of the file'
printf '\033[2J\377\001\n' >bad
run 2 compare bad
err_is "bad:1: expected 'chasles-vectors', found '\\x1b[2J\\xff\\x01'"

# A file cut anywhere is read as far as it is whole, or refused; never does it look better than it is.
length=$(wc -c <good/so3_exp.f32.txt)
cut=0
while [ "$cut" -lt "$length" ]; do
  head -c "$cut" good/so3_exp.f32.txt >cut
  ran="compare a file cut after $cut bytes"
  "$PROGRAM" compare cut >out 2>err
  status=$?
  case $status in
    0) [ "$(tail -c 15 cut)" = 'scale 0x1p+0 0' ] || fail "only a file cut behind a case can pass" ;;
    2) [ -s err ] || fail "a message is missing" ;;
    *) fail "exit status 2 expected" ;;
  esac
  cut=$((cut + 5))
done

finish
