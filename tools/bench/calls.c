/* calls.c - see calls.h. The registry's source is included, because its calls are static functions: they vanish into
 * the loops around them, so that what is timed calls the library as a user's own loop would.
 */
#include "calls.h"

#include "functions.c"

#define LOOP(name, real, inputs, outputs)                                  \
  static int loop_##name##_##real(const real *in, real *out, long cases) { \
    int status = CHS_OK;                                                   \
    for (long i = 0; i < cases; ++i, in += (inputs), out += (outputs)) {   \
      status = call_##name##_##real(in, out);                              \
    }                                                                      \
    return status;                                                         \
  }
#define FUNCTION(name, kinds, inputs, outputs, call, ...) \
  LOOP(name, double, inputs, outputs) LOOP(name, float, inputs, outputs)
#include "functions.def"
#undef FUNCTION

#define FUNCTION(name, kinds, inputs, outputs, call, ...) \
  {#name, inputs, outputs, loop_##name##_double, loop_##name##_float},
const struct calls calls[] = {
#include "functions.def"
};

const int calls_count = (int)(sizeof calls / sizeof calls[0]);
