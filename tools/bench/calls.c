/* calls.c - see calls.h. The registry's calls are static functions, which vanish into the loops around them, so that
 * what is timed calls the library as a user's own loop would.
 */
#include "calls.h"

#include <chasles/chasles.h>

#define LOOP(name, inputs, outputs)                                      \
  static int LOCAL(loop_##name)(const REAL *in, REAL *out, long cases) { \
    int status = CHS_OK;                                                 \
    for (long i = 0; i < cases; ++i, in += (inputs), out += (outputs)) { \
      status = LOCAL(call_##name)(in, out);                              \
    }                                                                    \
    return status;                                                       \
  }

#define REAL double
#define SCREW chs_screw
#define LIB(name) chs_##name
#define LOCAL(name) name##_double
#include "functions_calls.h"
#define FUNCTION(name, kinds, inputs, outputs, call, ...) LOOP(name, inputs, outputs)
#include "functions.def"
#undef FUNCTION
#undef REAL
#undef SCREW
#undef LIB
#undef LOCAL

#define REAL float
#define SCREW chs_screwf
#define LIB(name) chs_##name##f
#define LOCAL(name) name##_float
#include "functions_calls.h"
#define FUNCTION(name, kinds, inputs, outputs, call, ...) LOOP(name, inputs, outputs)
#include "functions.def"
#undef FUNCTION

#define FUNCTION(name, kinds, inputs, outputs, call, ...) \
  {#name, inputs, outputs, loop_##name##_double, loop_##name##_float},
const struct calls calls[] = {
#include "functions.def"
};

const int calls_count = (int)(sizeof calls / sizeof calls[0]);
