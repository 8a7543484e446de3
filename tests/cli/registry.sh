# The registry calls every function of the public headers and reads every promise they state; there are vectors for all
# of its entries, those of the single function for an array form.
include=$1/include/chasles
registry=$1/tools/chasles/functions.def
calls=$1/tools/chasles/functions_calls.h
missing=0

lacks() {
  echo "functions.def lacks $1"
  missing=1
}

# All prototypes but those in float, whose names have an f more.
names=$(sed -n '/^typedef/d; s/^[a-z][a-z ]*\**chs_\([a-z0-9_]*\)(.*/\1/p' "$include"/*.h)
[ -n "$names" ] || lacks 'a function, or no prototype was found'
for name in $names; do
  case " $(echo $names) " in *" ${name%f} "*) [ "${name%f}" = "$name" ] || continue ;; esac
  case $name in
    status_text) ;;              # has no numbers
    motion_finish_covariance) ;; # chs_motion_covariance calls it
    *) grep -q "LIB($name)" "$registry" "$calls" || lacks "chs_$name" ;;
  esac
done

for name in $(sed -n 's/^FUNCTION(\([a-z0-9_]*\),.*/\1/p' "$registry"); do
  for format in f64 f32; do
    [ -f "$1/tests/vectors/${name%_array}.$format.txt" ] || lacks "vectors of $name, $format"
  done
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
