/* A test file is compiled twice, for double as it stands and for float with CHS_TEST_SINGLE; what differs is here. */
#ifndef CHASLES_TESTS_PRECISION_H
#define CHASLES_TESTS_PRECISION_H

#include <float.h>
#include <stdint.h>

#include <chasles/chasles.h>

#ifdef CHS_TEST_SINGLE
typedef float real;
typedef chs_screwf screw;
typedef uint32_t real_bits;
#define FN(name) name##f
#define K(literal) literal##F
#define EPS ((double)FLT_EPSILON)
#define REAL_MAX FLT_MAX
#define REAL_MIN FLT_MIN
#define SMALLEST 0x1p-149F /* the least subnormal number */
#define ANGLE_MAX CHS_ANGLE_MAXF
#define NEXT_AFTER nextafterf
#define PICK(for_double, for_float) (for_float)
#else
typedef double real;
typedef chs_screw screw;
typedef uint64_t real_bits;
#define FN(name) name
#define K(literal) literal
#define EPS DBL_EPSILON
#define REAL_MAX DBL_MAX
#define REAL_MIN DBL_MIN
#define SMALLEST 0x1p-1074
#define ANGLE_MAX CHS_ANGLE_MAX
#define NEXT_AFTER nextafter
#define PICK(for_double, for_float) (for_double)
#endif

/* pi to more digits than either precision holds. */
#define PI 3.14159265358979323846
#define REAL_PI ((real)PI)

/* x rounded to the precision under test. A plain cast is not enough: gcc 12 at -O3 forgets it where it turns the loop
 * around it into vector instructions, and goes on with the double. */
static inline real rounded(double x) {
  volatile real r = (real)x;
  return r;
}

#define LENGTH(array) ((int)(sizeof(array) / sizeof(array)[0]))

#endif
