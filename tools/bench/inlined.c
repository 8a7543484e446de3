/* inlined.c - the shortest functions as part of the loops around them, as those of peers that are header files are: the
 * library's own source, included, its functions under other names and with internal linkage.
 */
#include "calls.h"

#define SUMS_ALONE
#include "../../src/pose.h"
#include <chasles/se3.h>
#include <chasles/so3.h>

#ifndef CHS_SINGLE
#define chs_so3_multiply inlined_so3_multiply
#define chs_so3_transpose inlined_so3_transpose
#define chs_so3_apply inlined_so3_apply
#define chs_se3_from_parts inlined_se3_from_parts
#define chs_se3_to_parts inlined_se3_to_parts
#define chs_se3_compose inlined_se3_compose
#define chs_se3_inverse inlined_se3_inverse
#define chs_se3_apply inlined_se3_apply
#else
#define chs_so3_multiplyf inlined_so3_multiplyf
#define chs_so3_transposef inlined_so3_transposef
#define chs_so3_applyf inlined_so3_applyf
#define chs_se3_from_partsf inlined_se3_from_partsf
#define chs_se3_to_partsf inlined_se3_to_partsf
#define chs_se3_composef inlined_se3_composef
#define chs_se3_inversef inlined_se3_inversef
#define chs_se3_applyf inlined_se3_applyf
#endif

static INLINE void FN(chs_so3_multiply)(const real A[9], const real B[9], real C[9]);
static INLINE void FN(chs_so3_transpose)(const real A[9], real B[9]);
static INLINE void FN(chs_so3_apply)(const real R[9], const real x[3], real y[3]);
static INLINE void FN(chs_se3_from_parts)(const real R[9], const real p[3], real T[16]);
static INLINE void FN(chs_se3_to_parts)(const real T[16], real R[9], real p[3]);
static INLINE void FN(chs_se3_compose)(const real A[16], const real B[16], real C[16]);
static INLINE void FN(chs_se3_inverse)(const real A[16], real B[16]);
static INLINE void FN(chs_se3_apply)(const real T[16], const real x[3], real y[3]);

#include "../../src/algebra.c"

#define LOOPS                                     \
  LOOP(so3_multiply, 18, 9, (in, in + 9, out))    \
  LOOP(so3_transpose, 9, 9, (in, out))            \
  LOOP(so3_apply, 12, 3, (in, in + 9, out))       \
  LOOP(se3_from_parts, 12, 16, (in, in + 9, out)) \
  LOOP(se3_compose, 32, 16, (in, in + 16, out))   \
  LOOP(se3_inverse, 16, 16, (in, out))            \
  LOOP(se3_apply, 19, 3, (in, in + 16, out))

#define LOOP(name, inputs, outputs, arguments)                                                   \
  int FN(loop_inlined_##name)(const real *in, real *out, long cases);                            \
  int FN(loop_inlined_##name)(const real *in, real *out, long cases) {                           \
    for (long i = 0; i < cases; ++i, in += (inputs), out += (outputs)) FN(chs_##name) arguments; \
    return CHS_OK;                                                                               \
  }
LOOPS
#undef LOOP

#ifndef CHS_SINGLE
#define LOOP(name, inputs, outputs, arguments) int loop_inlined_##name##f(const float *in, float *out, long cases);
LOOPS
#undef LOOP

#define LOOP(name, inputs, outputs, arguments) {#name, inputs, outputs, loop_inlined_##name, loop_inlined_##name##f},
const struct calls inlined[] = {LOOPS};

const int inlined_count = (int)(sizeof inlined / sizeof inlined[0]);
#endif
