#include <chasles/tilt.h>

#include "exact.h"
#include "tilt_private.h"

int FN(chs_tilt_error)(const real nominal[9], const real actual[9], real *alpha, real *beta) {
  int status = first_error(check_rotation(nominal), check_rotation(actual));
  if (status != CHS_OK) return status;
  tilt_and_torsion t = tilt_and_torsion_of(nominal, actual);
  int undefined = torsion_is_undefined(&t);
  const real turned[3] = {t.turned, 0, 0};
  *alpha = FN(chs_p_angle_of_vector)(t.tilted, t.cosine);
  *beta = undefined ? K(0.0) : FN(chs_p_angle_of_vector)(turned, t.straight);
  return undefined ? CHS_TORSION_UNDEFINED : CHS_OK;
}

int FN(chs_tilt_to_rotation)(real azimuth, real tilt, real torsion, real R[9]) {
  const real angles[3] = {azimuth, tilt, torsion};
  int status = angles_status(angles, 3);
  if (status != CHS_OK) return status;

  /* With p = cos(tilt/2)^2 and q = sin(tilt/2)^2 the first four entries are those of turns about z by the torsion, times
   * p, and by 2 azimuth - torsion, times q. */
  sine_cosine a = sin_cos_of(azimuth), b = sin_cos_of(torsion), c = sin_cos_of(tilt);
  real ca = a.cosine, sa = a.sine, ct = b.cosine, st = b.sine, cosine = c.cosine, sine = c.sine;
  real p = K(0.5) + K(0.5) * cosine, q = K(0.5) - K(0.5) * cosine;
  real spin_sine = st * ca - ct * sa, spin_cosine = ct * ca + st * sa; /* of torsion - azimuth */
  real s2 = K(2.0) * sa * ca, c2 = (ca - sa) * (ca + sa);              /* of 2 azimuth */
  real sb = s2 * ct - c2 * st, cb = c2 * ct + s2 * st;
  R[0] = p * ct - q * cb;
  R[1] = K(0.0) - (p * st + q * sb);
  R[3] = p * st - q * sb;
  R[4] = p * ct + q * cb;
  R[2] = ca * sine;
  R[5] = sa * sine;
  R[6] = K(0.0) - sine * spin_cosine;
  R[7] = sine * spin_sine;
  R[8] = cosine;
  return CHS_OK;
}

/* An angle of at most 3 pi brought into [-pi, pi]. */
static real wrapped(real angle) {
  real turn = K(2.0) * CHS_PI_A;
  return angle > CHS_PI_A ? angle - turn : angle < -CHS_PI_A ? angle + turn : angle;
}

int FN(chs_tilt_from_rotation)(const real R[9], real *azimuth, real *tilt, real *torsion) {
  int status = check_rotation_apart(R);
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
