#include "angle.h"
#include "exact.h"

/* x - k pi for the integer k that brings it nearest to 0, as an unevaluated sum; returns whether k is odd. pi in three
 * parts and exact products keep the error near 2^-104 |x| in double (2^-46 in float) plus half an eps of the result. */
static int reduce(real hi, real lo, real *r, real *r_lo) {
  real k = (hi * (K(1.0) / CHS_PI_A) + TO_INTEGER) - TO_INTEGER;
  real half_k = (K(0.5) * k + TO_INTEGER) - TO_INTEGER;
  exact_sum x = {hi, lo};
  add(&x, product(-k, CHS_PI_A));
  add(&x, product(-k, CHS_PI_B));
  add(&x, product(-k, CHS_PI_C));
  x = two_sum(x.hi, x.lo);
  *r = x.hi;
  *r_lo = x.lo;
  return K(2.0) * half_k != k;
}

void FN(chs_p_sin_cos)(real hi, real lo, real *sine, real *cosine) {
  real r, r_lo;
  int odd = reduce(hi, lo, &r, &r_lo);
  half_angle half = half_angle_within_pi(split_square_of(K(2.0) * r));
  real s = K(2.0) * r * half.s, c = half.c - r_lo * s;
  s = s + r_lo * half.c;
  *sine = odd ? -s : s;
  *cosine = odd ? -c : c;
}

int FN(chs_p_half_angle_beyond_pi)(const real w[3], half_angle *half) {
  int status = finiteness(w, 3);
  if (status != CHS_OK) return status;
  if (largest(w, 3) > ANGLE_MAX) return CHS_ERR_ANGLE_RANGE;

  exact_sum tt = product(w[0], w[0]);
  add(&tt, product(w[1], w[1]));
  add(&tt, product(w[2], w[2]));
  tt = two_sum(tt.hi, tt.lo);
  real theta = SQRT(tt.hi);
  exact_sum rest = tt;
  add(&rest, product(-theta, theta));
  real theta_lo = (rest.hi + rest.lo) / (K(2.0) * theta);
  if (theta > ANGLE_MAX) return CHS_ERR_ANGLE_RANGE;

  real sine;
  FN(chs_p_sin_cos)(K(0.5) * theta, K(0.5) * theta_lo, &sine, &half->c);
  real s = sine / theta, cc = half->c * half->c;
  half->s = s - s * (theta_lo / theta);
  half->ss = cc < K(0.5) ? (K(1.0) - cc) / tt.hi : half->s * half->s;
  half->cubic = (K(1.0) - sine_ratio(*half)) / tt.hi;
  half->tt = tt.hi;
  return CHS_OK;
}

real FN(chs_p_angle_of)(real y, real x) { return angle_from(y, x); }

int FN(chs_p_angles_status)(const real *angles, int n) {
  int status = finiteness(angles, n);
  if (status != CHS_OK) return status;
  return largest(angles, n) > ANGLE_MAX ? CHS_ERR_ANGLE_RANGE : CHS_OK;
}
