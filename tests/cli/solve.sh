# chasles solve: a known screw, gaps, and tables that are not what they should be.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

# Frame 2 to 4: a quarter turn about the line through (1, 0, 0) along z, with 2 along it. Frames 1 and 3 lack a marker,
# frame 5 is the same quarter turn once more, and in frame 6 the triangle has another shape. D never moves.
cat >trial.csv <<'END'
time_s,A_x_m,A_y_m,A_z_m,B_x_m,B_y_m,B_z_m,C_x_m,C_y_m,C_z_m,D_x_m,D_y_m,D_z_m,remark
0,,0,0,1,3,0,1,0,4,0,0,0,
0.5,2,0,0,1,3,0,1,0,4,0,0,0,
1,1,1,2,-2,0,NaN,1,0,6,0,0,0,
1.5,1,1,2,-2,0,2,1,0,6,0,0,0,
2,0,0,4,1,-3,4,1,0,8,0,0,0,
2.5,0,0,4,1,-3,9,1,0,8,0,0,0,
END

# near LINE: fields 5 to 12 of that line of out are angle, axis, point and translation of the quarter turn.
near() {
  sed -n "$1p" out | awk -F, -v angle="$2" '
    function off(a, b) { return a == "" || a - b > 1e-12 || b - a > 1e-12 }
    { exit off($5, angle) || off($6, 0) || off($7, 0) || off($8, 1) || off($9, 1) || off($10, 0) || off($11, 0) ||
      off($12, 2) || off($13, 0) }' || fail "line $1 is not the quarter turn"
}

# line N TEXT: line N of out is the text.
line() { [ "$(sed -n "$1p" out)" = "$2" ] || fail "line $1 should be: $2"; }

run 1 solve --markers A,B,C --out - trial.csv
line 1 'frame,"time_s",from,method,angle_rad,axis_x,axis_y,axis_z,point_x_m,point_y_m,point_z_m,translation_m,rms_m,status,note'
line 2 '1,0,,,,,,,,,,,,,"missing: A"'
line 3 '2,0.5,,,,,,,,,,,,,"reference"'
line 4 '3,1,,,,,,,,,,,,,"missing: B"'
near 5 1.5707963267948966
err_is 'A, B, C by least-squares: 6 frames, 2 solved, 2 with a marker missing, 1 in error'
sed -n 7p out | grep -q '^6,2.5,2,least-squares,,,,,,,,,,-10,"' || fail "frame 6 should be in error"

run 1 solve --markers A,B,C --out - --method laub-shiflett --against previous --degrees trial.csv
near 5 90
near 6 90
sed -n 6p out | grep -q '^5,2,4,laub-shiflett,90' || fail "frame 5 should be measured against frame 4"

run 1 solve --markers A,B,C --against 4 --out screws.csv trial.csv
out_has 'A, B, C by least-squares: 6 frames, 2 solved, 2 with a marker missing, 1 in error'
cp screws.csv out
near 6 1.5707963267948966
line 5 '4,1.5,,,,,,,,,,,,,"reference"'

# A list as people write it.
run 1 solve --markers 'A, B, C' trial.csv
out_has 'A, B, C by least-squares: 6 frames, 2 solved'

# The input is never overwritten.
cp trial.csv kept.csv
run 2 solve --markers A,B,C --out ./trial.csv trial.csv
err_is 'chasles: --out ./trial.csv is the input itself'
cmp -s trial.csv kept.csv || fail "trial.csv was overwritten"

# The table, and the same numbers from a file of another style.
run 1 solve --markers A,B,C trial.csv
out_has ' frame     time_s   from  angle_deg   axis_x   axis_y   axis_z   point_x_m '
sed -n 5p out | grep -q '^     4   1.500000      2   90.00000 .* 1.00000           1 ' || fail 'frame 4 is missing'
run 1 solve --markers A,B,C --out - trial.csv
cp out expected
printf '\357\273\277' >style.csv
sed -e 's/,/;/g' -e 's/0.5;2/ "0.5" ; 2.0e0 /' -e 's/$/\r/' trial.csv >>style.csv
printf '\r\n\r\n' >>style.csv
run 1 solve --markers A,B,C --out - style.csv
cmp -s out expected || fail "semicolons, quotes and line ends make a difference"
sed 's/NaN/-nan/' trial.csv | tr '\n' '\r' >style.csv
run 1 solve --markers A,B,C --out - style.csv
cmp -s out expected || fail "carriage returns alone make a difference"
tr , '\t' <trial.csv >style.csv
run 1 solve --markers A,B,C --out - - <style.csv
cmp -s out expected || fail "tabs make a difference"

run 0 solve --markers A,B,C --tolerance 2 trial.csv
run 1 solve --markers A,B,C --all-methods --out - trial.csv
line 4 '3,1,,,,,,,,,,,,,"missing: B"'
for number in 5 6 7 8 9 10; do near $number 1.5707963267948966; done
sed -n 8p out | grep -q '^4,1.5,2,bottema-roth,' || fail "line 8 should be by bottema-roth"
err_is 'A, B, C by all methods: 6 frames, 2 solved, 2 with a marker missing, 1 in error'

# A body of four markers: weights, a marker missing among them, and the standard deviations.
cat >four.csv <<'END'
A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z,D_x,D_y,D_z
2,0,0,1,3,0,1,0,4,0,1,1
1,1,2,-2,0,2,1,0,6,0,-1,3
1,1,2,-2,0,2,1,0,6,,-1,3
1,1,2,-2,0,,1,0,6,,-1,3
END
run 0 solve --points 4 --weights 1,2,0.5,3 --covariance 0.001 --out - four.csv
line 1 'frame,from,method,angle_rad,axis_x,axis_y,axis_z,point_x,point_y,point_z,translation,rms,sd_angle_rad,sd_axis_rad,sd_point,sd_translation,status,note'
line 5 '4,,,,,,,,,,,,,,,,,"missing: B D"'
sed -n 4p out | grep -q ',7,"some points are missing: the result is that of the others; missing: D"' || fail "line 4 should lack D"
sed -i 's/^\([^,]*\),/\1,0,/' out
near 3 1.5707963267948966
near 4 1.5707963267948966
sed -n 3p out | awk -F, '{ exit !($14 > 3e-4 && $14 < 3e-3 && $15 > 1e-4 && $15 < 3e-3 && $16 > 3e-4 && $16 < 1e-2) }' ||
  fail "the standard deviations should be about 0.001"
run 0 solve --points 4 --covariance 0.001 four.csv
out_has ' sd_angle_deg '
run 0 solve --all-methods --covariance 0.001 four.csv
grep -q nan out && fail "methods without standard deviations should have none"

# A forearm A, B, C relative to an arm D, E, F: a quarter turn about the line through (3, 0, 0) along y, with 0.5 along
# it, while the arm itself makes a quarter turn about z and moves by (5, 0, 0).
cat >elbow.csv <<'END'
A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z,D_x,D_y,D_z,E_x,E_y,E_z,F_x,F_y,F_z
3,0,0,4,0,0,3,1,0,0,0,0,1,0,0,0,2,0
4.5,3,0,4.5,3,-1,3.5,3,0,5,0,0,5,1,0,3,0,0
4.5,3,0,4.5,3,-1,3.5,3,0,5,0,0,5,,0,3,0,0
4.5,3,0,4.5,3,-1,3.5,3,0,5,0,0,5,1,0,3,0,9
END
run 1 solve --markers A,B,C --relative-to D,E,F --out - elbow.csv
sed -n 3p out | awk -F, '
  function off(a, b) { return a == "" || a - b > 1e-12 || b - a > 1e-12 }
  { exit off($4, 1.5707963267948966) || off($5, 0) || off($6, 1) || off($7, 0) || off($8, 3) || off($9, 0) ||
    off($10, 0) || off($11, 0.5) }' || fail "line 3 is not the quarter turn of the elbow"
line 4 '3,,,,,,,,,,,,,"missing: E"'
line 5 '4,1,least-squares,,,,,,,,,,-10,"the body it is relative to: the points have changed their shape"'
err_is 'A, B, C relative to D, E, F by least-squares: 4 frames, 1 solved, 1 with a marker missing, 1 in error'
for against in previous 1; do
  run 1 solve --markers A,B,C --relative-to D,E,F --method laub-shiflett --against $against --out - elbow.csv
  sed -n 3p out | grep -q '^2,1,laub-shiflett,1.57' || fail "frame 2 should be solved against frame 1"
done

# Which frame is to blame: the reference, whose points lie on a line, or the last.
cat >blame.csv <<'END'
A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z
0,0,0,1,0,0,3,0,0
0,0,0,1,0,0,0,2,0
0,0,0,0,1,0,-2,0,0
END
run 1 solve blame.csv
out_has 'the reference, frame 1, coordinates up to 3: the points lie on a line'
err_is 'chasles: all frames fail against the reference, frame 1: it may be to blame; try --against another frame'
run 1 solve --against 2 --out - blame.csv
line 2 '1,2,least-squares,,,,,,,,,,-9,"frame 1, coordinates up to 3: the points lie on a line to within the rounding of the coordinates"'
sed -n 4p out | grep -q '^3,2,least-squares,1.57' || fail "frame 3 should be solved against frame 2"

# Numbers as no camera gives them: told of the frame that has them, and the others are solved all the same.
cat >absurd.csv <<'END'
A_x,A_y,A_z,B_x,B_y,B_z,C_x,C_y,C_z
0,0,0,1,0,0,0,1,0
1e300,0,0,0,1,0,-1,0,0
0,0,0,0,1e300,0,-1e300,0,0
1e-300,0,0,0,1,0,-1,1e-400,0
END
run 1 solve --out - absurd.csv
line 3 '2,1,least-squares,,,,,,,,,,-8,"frame 2, coordinates up to 1e+300: two points coincide to within the rounding of the coordinates"'
line 4 '3,1,least-squares,,,,,,,,,,-8,"frames 1 and 3 beside each other, coordinates up to 1e+300: two points coincide to within the rounding of the coordinates"'
sed -n 5p out | grep -q '^4,1,least-squares,1.57' || fail "frame 4 should be solved"
for unit in 1e-300 1e300; do
  head -n 2 absurd.csv >unit.csv
  echo '0,0,0,0,1,0,-1,0,0' >>unit.csv
  sed -i "2,\$s/1/$unit/g" unit.csv
  run 0 solve --out - unit.csv
  sed -n 3p out | grep -q '^2,1,least-squares,1.57' || fail "$unit is a length as good as any"
done
run 1 solve --against 2 absurd.csv
out_has 'the reference, frame 2, coordinates up to 1e+300: two points coincide'

run 1 solve trial.csv
err_is 'chasles: no --markers given: the first 3 are taken of
 A B C D'
head -n 2 trial.csv >short.csv
run 1 solve --markers A,B,C short.csv
err_is 'chasles: no frame has all markers'

# Arguments.
run 2 solve --markers A,B,E trial.csv
err_is "chasles: trial.csv has no marker 'E'; it has
 A B C D"
run 2 solve --markers A,B trial.csv
err_is "chasles: --markers expects 3 to 32 different names parted by commas, not 'A,B'"
run 2 solve --markers A,B,A trial.csv
err_is "chasles: --markers expects 3 to 32 different names parted by commas, not 'A,B,A'"
run 2 solve --method guess trial.csv
err_is "chasles: --method expects least-squares, spoor-veldpaus, laub-shiflett, angeles, beggs or bottema-roth, not 'guess'"
run 2 solve --markers A,B,C,D --method bottema-roth trial.csv
err_is "chasles: 4 markers: only --method least-squares takes more than three"
run 2 solve --points 2 trial.csv
err_is "chasles: --points expects a number from 3 to 32, not '2'"
run 2 solve --points 5 trial.csv
err_is "trial.csv:1: expected columns NAME_x, NAME_y, NAME_z of at least 5 markers, found 'A'"
run 2 solve --weights 1,2 trial.csv
err_is "chasles: --weights has 2 numbers for 3 markers"
run 2 solve --weights 1,-2,1 trial.csv
err_is "chasles: --weights expects numbers of at least 0, parted by commas, not '1,-2,1'"
run 2 solve --weights 1,2,3 --method bottema-roth trial.csv
err_is "chasles: --weights needs --method least-squares"
run 2 solve --covariance 1 --method bottema-roth trial.csv
err_is "chasles: --covariance needs --method least-squares"
run 2 solve --covariance 1 --markers A,B,C --relative-to B,C,D trial.csv
err_is "chasles: --covariance knows the errors of one body and does not go with --relative-to"
run 2 solve --tolerance -1 trial.csv
err_is "chasles: --tolerance expects a number of at least 0, not '-1'"
run 2 solve --against last trial.csv
err_is "chasles: --against expects first, previous or the number of a frame, not 'last'"
run 2 solve --markers A,B,C --against 3 trial.csv
err_is 'chasles: trial.csv:4: frame 3 cannot be the reference, a marker is missing in it'
run 2 solve --markers A,B,C --against 9 trial.csv
err_is 'chasles: trial.csv has no frame 9: it ends with frame 6'
run 2 solve --against 2 - <trial.csv
err_is "chasles: --against a frame's number reads the file twice, which standard input does not allow"
run 2 solve --markers A,B,C --out nowhere/screws.csv trial.csv
err_is 'chasles: cannot write nowhere/screws.csv: No such file or directory'
if [ -c /dev/full ]; then
  run 2 solve --markers A,B,C --out /dev/full trial.csv
  err_is 'chasles: cannot write /dev/full: No space left on device'
fi

# Malformed files: a sed command, the line of the complaint, and what it says.
malformed() {
  sed "$1" trial.csv >bad
  run 2 solve --markers A,B,C bad
  err_is "bad:$2: expected $3"
}
malformed '1s/C_z_m/C_w_m/' 1 'a column z of marker C, found nothing'
malformed '1s/C_z_m/C_x_m/' 1 "one column x for each marker, found 'C'"
malformed '1s/C_z_m/C_z_mm/' 1 "the unit 'm' in all columns of marker C, found 'mm'"
malformed '1s/C_\(.\)_m/C_\1_mm/g' 1 "the unit 'm' of marker A for C as well, found 'mm'"
malformed '1s/[ABC]_//g' 1 "columns NAME_x, NAME_y, NAME_z of at least 3 markers, found 'D'"
malformed '1s/_\([xyz]\)_/ \1 /g' 1 "columns NAME_x, NAME_y, NAME_z of at least 3 markers, found 'A x m'"
malformed '1,$d' 1 'a row of column names, found the end of the file'
malformed '4s/,$//' 4 '14 cells parted by commas, found 13'
malformed '4s/$/,/' 4 '14 cells parted by commas, found 15'
malformed '4s/,/;/g' 4 '14 cells parted by commas, found 1'
malformed '4s/,/;/' 4 '14 cells parted by commas, found 13'
malformed '4,$s/$/\x00/' 4 'text, found a zero byte'
malformed '3s/2/2 m/' 3 "a position in column 2: a number with a decimal point, found '2 m'"
malformed '3s/2/inf/' 3 "a position in column 2: a number with a decimal point, found 'inf'"
malformed '3s/2/0x2/' 3 "a position in column 2: a number with a decimal point, found '0x2'"
malformed '3s/2/1e999/' 3 "a position in column 2: a number with a decimal point, found '1e999'"
malformed '3s/2/"2,5"/' 3 "a position in column 2: a number with a decimal point, found '2,5'"
malformed '3s/2/"2/' 3 'a closing quote at the end of a cell, found nothing'
malformed '3s/2/"2"5/' 3 "a closing quote at the end of a cell, found '5,0,0,1,3,0,1,0,4,0,0,0,'"

finish
