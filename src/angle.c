#include "angle.h"
#include "exact.h"

/* hi + lo - 2 pi k, k the integer that brings it nearest to 0, as high + low with a high whose square is exact. */
typedef struct remainder_angle {
  real high, low;
} remainder_angle;

static inline real turns_in(real angle) { return (angle * (K(0.5) / CHS_PI_A) + TO_INTEGER) - TO_INTEGER; }

static inline remainder_angle split(real x, real rest) {
  real high = on_grid(x);
  remainder_angle a = {high, (x - high) + rest};
  return a;
}

/* For |hi| up to NEAR, with an error of a few hundredths of an eps: k times the short part of pi is exact. */
static inline remainder_angle remainder_near(real hi, real lo) {
  real k = turns_in(hi);
  return split(hi - k * (K(2.0) * CHS_PI_SHORT), lo - k * (K(2.0) * CHS_PI_REST));
}

/* For every hi > pi, with an error near 2^-104 hi in double (2^-46 in float). */
SELDOM static void remainder_far(real hi, real lo, remainder_angle *a) {
  real k = turns_in(hi);
  exact_sum turns = product(k, K(2.0) * CHS_PI_A);
  *a = split(hi - turns.hi, (lo - turns.lo) - k * (K(2.0) * CHS_PI_B));
}

static inline split_square square_of(remainder_angle a) {
  real head = a.high * a.high, rest = a.low * ((a.high + a.high) + a.low);
  split_square square = {head + rest, head, rest};
  return square;
}

/* The quarter turns are counted with an error of half an eps of their number, which may be one too many or too few of
 * many; the second count finds out. The error of what is left is near 2^-104 of the angle in double, 2^-46 in float. */
sine_cosine FN(chs_p_sin_cos_to_all_digits)(real angle) {
  static const sine_cosine none = {(real)NAN, (real)NAN};
  if (!(ABS(angle) <= ANGLE_MAX)) return none;
  real k = quarter_turns_in(angle), fours = (K(0.25) * k + TO_INTEGER) - TO_INTEGER;
  exact_sum turns = product(k, CHS_HALF_PI_A);
  real x = angle - turns.hi, rest = (K(0.0) - turns.lo) - k * CHS_HALF_PI_B, more = quarter_turns_in(x);
  exact_sum left = two_sum(x - more * CHS_HALF_PI_A, rest - more * CHS_HALF_PI_B);
  return sin_cos_beyond((unsigned)(long)(k - K(4.0) * fours + more), left.hi, left.lo);
}

static INLINE exact_sum exact_square(real a) {
  real a1 = upper(a), a0 = a - a1, p = a * a;
  exact_sum x = {p, ((a1 * a1 - p) + K(2.0) * (a1 * a0)) + a0 * a0};
  return x;
}

/* |w| = theta + rest to twice the format's precision, and |w|^2. False for what is no angle or beyond the range. */
SELDOM static int length_far(const real w[3], real *theta, real *rest, real *squared) {
  exact_sum tt = {0, 0};
  for (int i = 0; i < 3; i++) add(&tt, exact_square(w[i]));
  tt = two_sum(tt.hi, tt.lo);
  real root = SQRT(tt.hi);
  if (!(root <= ANGLE_MAX)) return 0;
  exact_sum square = exact_square(root);
  *theta = root;
  *squared = tt.hi;
  *rest = (((tt.hi - square.hi) - square.lo) + tt.lo) / (K(2.0) * root);
  return 1;
}

int FN(chs_p_why_no_angle)(const real *angles, int n) {
  int status = finiteness(angles, n);
  return status == CHS_OK ? CHS_ERR_ANGLE_RANGE : status;
}

int FN(chs_p_half_angle_beyond_pi)(const real w[3], half_angle *half) {
  real x = on_grid(w[0]), y = on_grid(w[1]), z = on_grid(w[2]), head = x * x + y * y + z * z;
  real rest = (w[0] - x) * (w[0] + x) + (w[1] - y) * (w[1] + y) + (w[2] - z) * (w[2] + z);
  real tt = head + rest, theta = SQRT(tt);
  remainder_angle a = {0, 0};
  /* theta = g + (theta^2 - g^2) / (theta + g) with a short g. */
  if (theta <= NEAR) {
    real g = on_grid(theta);
    a = remainder_near(g, ((head - g * g) + rest) / (theta + g));
  }
  /* Also for a theta that is no number. */
  if (!(ABS(a.high + a.low) >= CLOSE_BY + theta * (CLOSE_BY / K(4096.0)))) {
    real hi, lo, squared;
    remainder_angle far;
    if (!length_far(w, &hi, &lo, &squared)) return FN(chs_p_why_no_angle)(w, 3);
    remainder_far(hi, lo, &far);
    theta = hi;
    tt = squared;
    a = far;
  }
  half_angle h = half_angle_within_pi(square_of(a));
  real cc = h.c * h.c;
  const real sine_squared[2] = {h.ss * h.tt, K(1.0) - cc}; /* no case, which would be mispredicted */
  half->s = h.s * ((a.high + a.low) / theta);
  half->c = h.c;
  half->a = half->s * h.c;
  half->ss = sine_squared[cc < K(0.5)] / tt;
  half->cubic = (K(1.0) - half->a) / tt;
  half->tt = tt;
  return CHS_OK;
}

real FN(chs_p_angle_of)(real y, real x) {
  arc a = arc_of(y, ABS(x));
  return x < 0 ? (CHS_PI_A - a.base) + (CHS_PI_B - a.rest) : a.base + a.rest;
}

SELDOM static real angle_of_tiny(const real y[3], real x) { return x < 0 ? CHS_PI_A : norm(y, 3) / x; }

real FN(chs_p_angle_of_vector)(const real y[3], real x) {
  real yy = dot(y, y);
  return safe_square(yy) ? angle_from_square(yy, x) : angle_of_tiny(y, x);
}
