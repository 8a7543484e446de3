# The registry holds every function of the public headers and reads every promise they state; there are vectors for all,
# those of the single function for an array form.
include=$1/include/chasles
registry=$1/tools/chasles/functions.def
missing=0

lacks() {
  echo "functions.def lacks $1"
  missing=1
}

# The double one of each pair of prototypes: its first argument is a double, an array of them, or a screw of them.
functions=$(sed -n 's/^[a-z]* chs_\([a-z0-9_]*\)(\(const \)\{0,1\}\(double\|chs_screw\|chs_chain\|int joints, const double\) .*/\1/p' "$include"/*.h)
[ -n "$functions" ] || lacks 'a function, or no prototype was found'
for name in $functions; do
  grep -q "^FUNCTION($name, " "$registry" || lacks "chs_$name"
  [ -f "$1/tests/vectors/${name%_array}.f64.txt" ] || lacks "vectors of chs_$name"
done

promises=$(sed -n 's/^#define CHS_EPS_\([A-Z0-9_]*\) .*/\1/p' "$include"/*.h)
[ -n "$promises" ] || lacks 'a promise, or none was found'
for promise in $promises; do
  case $promise in
    *_BEYOND) pattern="PROMISE_BEYOND([a-z0-9_]*, ${promise%_BEYOND})" ;;
    *) pattern="PROMISE\(_BEYOND\)\?([a-z0-9_]*, $promise)" ;;
  esac
  grep -q "$pattern" "$registry" || lacks "CHS_EPS_$promise"
done

exit $missing
