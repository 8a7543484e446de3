# chasles agile-eye: the map of errors, the singular curves, and what it does not accept.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

# The reference, with the paper's error and a grid of nine values a joint: 0.01633 and 0.01732 degrees.
run 0 agile-eye --sigma 60 --tilt 0 --step 90 --grid 9 --refine 0 --out -
out_has '60,0,0,0.01633'
out_has ',0.01732'
[ "$(wc -l <out)" -eq 5 ] || fail "four orientations expected"
grep -q '^ *60 ' err || fail "the summary is missing on standard error"

# However many threads, the same map, and the table on standard output when the rows go to a file.
run 0 agile-eye --step 30 --threads 1 --out one.csv
out_has 'largest errors in degrees for joint errors of 0.01 degrees'
err_empty
run 0 agile-eye --step 30 --threads 5 --out five.csv
cmp -s one.csv five.csv || fail "the number of threads makes a difference"
[ "$(wc -l <one.csv)" -eq $((1 + 7 * 7 * 12)) ] || fail "a row for each orientation expected"

# An orientation on a singular curve has no errors, but a status.
run 0 agile-eye --sigma 120 --tilt 90 --step 15 --out curve.csv
file_has curve.csv '120,15,90,,,'

# Lists, and both units of the joint error.
run 0 agile-eye --sigma 0,20,...,120 --step 90 --epsilon 0.01deg --out list.csv
[ "$(cut -d, -f1 list.csv | sort -u | wc -l)" -eq 8 ] || fail "seven torsions expected"
run 0 agile-eye --sigma 60 --step 90 --epsilon 1e-4rad
out_has 'for joint errors of 0.00572958 degrees'

# Six curves, a point a degree; half of them have the torsion 120.
run 0 agile-eye --curves -
[ "$(wc -l <out)" -eq $((1 + 6 * 361)) ] || fail "a point a degree expected"
[ "$(grep -c ',120$' out)" -ge $((3 * 361)) ] || fail "three curves have the torsion 120"

run 2 agile-eye --sigma 0,20,...
err_is "chasles: --sigma expects up to 64 numbers from -360 to 360 as 0,60 or 0,20,...,120, not '0,20,...'"
for list in '' 1,, ,1 1,...,2 1,2,...,0 nan 0x10 1e999 1,2,...,1000 0,361 -361; do
  run 2 agile-eye --sigma "$list"
done
for angle in 0.01 1degrees -1deg 0deg 1rad nandeg deg; do
  run 2 agile-eye --epsilon "$angle"
  err_is "chasles: --epsilon expects an angle above 0 and up to 0.5rad, as 0.01deg or 1e-4rad, not '$angle'"
done
run 2 agile-eye --step 0
err_is "chasles: --step expects degrees from 0.1 to 90, not '0'"
run 2 agile-eye --tilt 181
run 2 agile-eye --grid 1
err_is "chasles: --grid expects a number from 2 to 101, not '1'"
run 2 agile-eye --threads 0
run 2 agile-eye --refine -1
run 2 agile-eye map
err_is "chasles: agile-eye takes options only, not 'map'; see 'chasles help agile-eye'"
run 2 agile-eye --step 90 --out nowhere/errors.csv
err_is 'chasles: cannot write nowhere/errors.csv: No such file or directory'

finish
