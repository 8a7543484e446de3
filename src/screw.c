#include <chasles/screw.h>

#include "pose.h"
#include "screw_private.h"

int FN(chs_screw_from_pose)(const real T[16], screw *out) {
  static const real origin[3] = {0, 0, 0};
  real R[9], p[3];
  part(T, R, p);
  int status = first_error(check_rotation(R), finiteness(p, 3));
  if (status != CHS_OK) return status;
  quaternion q = quaternion_of(R);
  real n = norm(q.v, 3);
  settle_half_turn(&q, 0, n);
  screw s;
  if (n == 0 || !screw_of_rotation(&q, n, origin, p, &s)) {
    /* No rotation to the format, or one whose axis lies beyond the format's range. */
    if (n > EPS * q.w) return CHS_ERR_OVERFLOW;
    status = screw_of_translation(p, &s);
    if (!is_finite(s.translation)) return CHS_ERR_OVERFLOW;
  } else if (q.w <= EPS * n)
    status = CHS_HALF_TURN;
  *out = s;
  return status;
}

int FN(chs_screw_to_pose)(const screw *in, real T[16]) {
  const real numbers[8] = {in->axis[0],  in->axis[1],  in->axis[2],     in->point[0],
                           in->point[1], in->point[2], in->translation, in->angle};
  int status = finiteness(numbers, 8);
  if (status != CHS_OK) return status;
  if (ABS(in->angle) > ANGLE_MAX) return CHS_ERR_ANGLE_RANGE;

  if (largest(in->axis, 3) == 0 && (in->angle != 0 || in->translation != 0)) return CHS_ERR_SINGULAR;

  /* R = I + sin(theta) [e] + (1 - cos(theta)) [e]^2, and (I - R) A from the same terms, so that a small rotation about
   * a far axis does not cancel. */
  real e[3], s, c, R[9], p[3], exA[3], exexA[3];
  unit(in->axis, e);
  FN(chs_p_sin_cos)(K(0.5) * in->angle, 0, &s, &c);
  real sine = K(2.0) * s * c, versine = versine_of(s, c), ee = squared_norm(e);
  if (ee == 0) ee = 1; /* no axis and nothing to do about it */
  rotation_from(e, sine / SQRT(ee), versine / ee, cosine_of(s, c), 0, R);
  cross(e, in->point, exA);
  cross(e, exA, exexA);
  for (int i = 0; i < 3; i++) p[i] = in->translation * e[i] - (sine * exA[i] + versine * exexA[i]);
  if (!all_finite(p, 3)) return CHS_ERR_OVERFLOW;
  join(R, p, T);
  return CHS_OK;
}

int FN(chs_screw_pitch)(const screw *in, real *pitch) {
  const real numbers[2] = {in->translation, in->angle};
  int status = finiteness(numbers, 2);
  if (status != CHS_OK) return status;
  if (in->angle == 0) {
    *pitch = in->translation == 0 ? 0 : in->translation / K(0.0);
    return in->translation == 0 ? CHS_NO_MOTION : CHS_PURE_TRANSLATION;
  }
  real h = in->translation / in->angle;
  if (!is_finite(h)) return CHS_ERR_OVERFLOW;
  *pitch = h;
  return CHS_OK;
}
