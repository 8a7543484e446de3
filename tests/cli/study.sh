# chasles study: the tables, the files, the same numbers for the same seed, and refusals.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

run 0 study --sets 5 --noisy-sets 3 --out results
err_empty
out_has 'Table 1. '
out_has 'theta paper               -0.34              0.49             25.43              0.29              1.00'
out_has 'Sensitivity to uniform scaling'
out_has 'Sensitivity to independent noise'
out_has '5 sets, 3 for each level of error, seed 1: 0 not solved'
for file in efficiency accuracy sensitivity angles; do [ -s results/$file.csv ] || fail "no $file.csv"; done
file_has results/efficiency.csv ',8.748,0.162,21.55'
# 5 sets, 2 precisions, 5 methods, and the titles; 2 kinds of 7 levels.
[ "$(wc -l <results/accuracy.csv)" -eq 51 ] || fail "accuracy.csv has the wrong length"
[ "$(wc -l <results/sensitivity.csv)" -eq 141 ] || fail "sensitivity.csv has the wrong length"

# All but the times is the same on every run with the same seed, into a directory that is there as well.
cp -r results first
run 0 study --sets 5 --noisy-sets 3 --out results
for file in accuracy sensitivity angles; do cmp -s first/$file.csv results/$file.csv || fail "$file.csv differs"; done
run 0 study --sets 5 --noisy-sets 3 --seed 2 --out results
cmp -s first/accuracy.csv results/accuracy.csv && fail "the seed makes no difference"

run 2 study --sets 0
err_is "chasles: --sets expects a number from 1 to 100000, not '0'"
run 2 study trial.csv
err_is "chasles: study takes no argument 'trial.csv'; see 'chasles help study'"
touch taken
run 2 study --sets 5 --out taken
err_is "chasles: cannot make the directory taken: File exists"
finish
