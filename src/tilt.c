#include <chasles/tilt.h>

#include "exact.h"
#include "tilt_private.h"

int FN(chs_tilt_error)(const real nominal[9], const real actual[9], real *alpha, real *beta) {
  int status = first_error(check_rotation(nominal), check_rotation(actual));
  if (status != CHS_OK) return status;
  tilt_and_torsion t = tilt_and_torsion_of(nominal, actual);
  int undefined = torsion_is_undefined(t);
  *alpha = FN(chs_p_angle_of)(t.sine, t.cosine);
  *beta = undefined ? K(0.0) : FN(chs_p_angle_of)(ABS(t.turned), t.straight);
  return undefined ? CHS_TORSION_UNDEFINED : CHS_OK;
}

int FN(chs_tilt_to_rotation)(real azimuth, real tilt, real torsion, real R[9]) {
  const real angles[3] = {azimuth, tilt, torsion};
  int status = FN(chs_p_angles_status)(angles, 3);
  if (status != CHS_OK) return status;

  /* azimuth + spin = torsion, the spin to more than its own format. */
  exact_sum spin = two_sum(torsion, -azimuth);
  real sa, ca, sh, ch, st, ct, ss, cs;
  FN(chs_p_sin_cos)(azimuth, 0, &sa, &ca);
  FN(chs_p_sin_cos)(torsion, 0, &st, &ct);
  FN(chs_p_sin_cos)(spin.hi, spin.lo, &ss, &cs);
  FN(chs_p_sin_cos)(K(0.5) * tilt, 0, &sh, &ch);
  real sine = K(2.0) * sh * ch, versine = versine_of(sh, ch), cosine = cosine_of(sh, ch);

  /* cos(tilt) = 1 - versine splits the first four entries into those of the torsion and a small rest; beyond a tilt of
   * pi/3 the rest is no longer small, and the plain product is the more exact. */
  if (cosine >= K(0.5)) {
    R[0] = ct - versine * (ca * cs);
    R[1] = versine * (ca * ss) - st;
    R[3] = st - versine * (sa * cs);
    R[4] = ct + versine * (sa * ss);
  } else {
    R[0] = cosine * (ca * cs) - sa * ss;
    R[1] = -(cosine * (ca * ss)) - sa * cs;
    R[3] = cosine * (sa * cs) + ca * ss;
    R[4] = ca * cs - cosine * (sa * ss);
  }
  R[2] = ca * sine;
  R[5] = sa * sine;
  R[6] = K(0.0) - sine * cs;
  R[7] = sine * ss;
  R[8] = cosine;
  return CHS_OK;
}

/* An angle of at most 3 pi brought into [-pi, pi]. */
static real wrapped(real angle) {
  real turn = K(2.0) * CHS_PI_A;
  return angle > CHS_PI_A ? angle - turn : angle < -CHS_PI_A ? angle + turn : angle;
}

int FN(chs_tilt_from_rotation)(const real R[9], real *azimuth, real *tilt, real *torsion) {
  int status = check_rotation(R);
  if (status != CHS_OK) return status;
  real axis[2] = {R[2], R[5]}, sine = norm(axis, 2), cosine = R[8];
  real turned = R[3] - R[1], straight = R[0] + R[4];
  if (sine > 0) {
    /* Near a tilt of pi turned and straight drown in rounding, of size 1 + cos(tilt); 2 azimuth - torsion does not. */
    int far = cosine < 0 && ABS(turned) + ABS(straight) <= K(0.015625);
    real phi = signed_angle_of(axis[1], axis[0]);
    *torsion =
        far ? wrapped(K(2.0) * phi - signed_angle_of(-(R[1] + R[3]), R[4] - R[0])) : signed_angle_of(turned, straight);
    *azimuth = phi;
    *tilt = FN(chs_p_angle_of)(sine, cosine);
    return CHS_OK;
  }
  if (cosine > 0) {
    *azimuth = 0;
    *torsion = signed_angle_of(turned, straight);
    *tilt = 0;
    return CHS_AZIMUTH_UNDEFINED;
  }
  /* R = Rz(2 azimuth - torsion) Ry(pi) */
  *azimuth = K(0.5) * signed_angle_of(K(0.0) - (R[1] + R[3]), R[4] - R[0]);
  *torsion = 0;
  *tilt = CHS_PI_A;
  return CHS_TORSION_UNDEFINED;
}
