# chasles hash: the same twice, another with another seed, and one that --each accounts for.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

run 0 hash --cases 50
err_empty
cp out first
run 0 hash --cases 50
cmp -s out first || fail "two runs differ"
run 0 hash --cases 50 --seed 2
out_has 'seed 2 cases 50 hash '
[ "$(cut -d' ' -f8 out)" != "$(cut -d' ' -f8 first)" ] || fail "the seed makes no difference"

# Every function in both precisions, and the last line as before.
run 0 hash --cases 50 --each
[ "$(grep -c ' double ' out)" -eq "$(grep -c ' float ' out)" ] || fail "a precision is missing"
tail -n 1 out >last
cmp -s last first || fail "--each changes the hash"
grep '^so3_log ' out >lines

# A function's inputs do not depend on the others.
run 0 hash --cases 50 --each --only so3_log
grep '^so3_log ' out | cmp -s - lines || fail "--only changes a function's hash"

run 2 hash --only so3_lgo
err_starts "chasles: the library has no function 'so3_lgo'"
run 2 hash --cases 0
err_is "chasles: --cases expects a number from 1 to 1000000000, not '0'"
run 2 hash --seed 18446744073709551616
err_is "chasles: --seed expects a number from 0 to 18446744073709551615, not '18446744073709551616'"
run 0 hash --seed 18446744073709551615 --cases 1

finish
