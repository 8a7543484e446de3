# chasles arm-error: one configuration, a map, and what it does not accept.
PROGRAM=$1
. "$(dirname "$0")/expect.sh"

# Two joints at right angles to the tool's axis and one along it, a metre from the tool: the errors by hand.
cat >arm.robot <<'END'
robot Wrist
angles degrees
lengths m
rows screws
revolute 1 0 0  0 0 0
revolute 0 0 1  0 0 0
prismatic 0 0 1
home 0 0 1
END
run 0 arm-error --epsilon 0.1deg arm.robot
out_has 'alpha             0.1 deg  with joint errors of -0.1'
out_has 'beta              0.1 deg  with joint errors of '
out_has 'position   0.00174533 m '
run 0 arm-error --epsilon 0.1deg --slide 0.01 arm.robot -- 10 20 0.5
out_has 'position    0.0103392 m'

# The map has a row for each pair of values; alpha does not depend on them.
run 0 arm-error --over 1,2 --step 45 --out map.csv arm.robot
out_has 'alpha            0.01 to         0.01 deg'
file_has map.csv 'q1_deg,q2_deg,alpha_deg,beta_deg,position_m,inside,status'
[ "$(wc -l <map.csv)" -eq 82 ] || fail "nine by nine configurations expected"
run 0 arm-error --over 1,2 --step 45 --threads 1 --out one.csv arm.robot
cmp -s one.csv map.csv || fail "the number of threads makes a difference"

run 2 arm-error
err_is "chasles: arm-error expects a robot file; see 'chasles help arm-error'"
run 2 arm-error --over 1,3 arm.robot
err_is 'chasles: Wrist has no joint 3 that turns'
run 2 arm-error --over 1,4 arm.robot
err_is 'chasles: Wrist has no joint 4 that turns'
for pair in 1 1,1 0,1 1.5,2 1,2,3 one,two; do
  run 2 arm-error --over "$pair" arm.robot
  err_is "chasles: --over expects the numbers of two joints, from 1, as 3,5, not '$pair'"
done
run 2 arm-error --out map.csv arm.robot
err_is 'chasles: --out is for maps: it needs --over'
run 2 arm-error --slide -1 arm.robot
err_is "chasles: --slide expects a length of at least 0, not '-1'"
run 2 arm-error --epsilon 1 arm.robot
run 2 arm-error arm.robot 1 2
run 1 arm-error --grid 101 --epsilon 1e-300rad arm.robot -- 1e300 0 0
err_is 'chasles: no errors of Wrist there: an angle is too large to be reduced modulo 2 pi'

# Nor has a map where a joint that it leaves alone is beyond the range.
sed 's/^prismatic.*/revolute 0 1 0  0 0 0/' arm.robot >turning.robot
run 1 arm-error --over 1,2 --step 90 --out map.csv turning.robot -- 0 0 1e300
err_is 'chasles: no errors of Wrist at 25 of 5 x 5 configurations'
out_lacks alpha
file_has map.csv '-180,-180,,,,,-4'

finish
