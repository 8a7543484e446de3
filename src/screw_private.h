/* The screw of a displacement whose rotation is known as a quaternion; shared by poses and by measured points. */
#ifndef CHASLES_SCREW_PRIVATE_H
#define CHASLES_SCREW_PRIVATE_H

#include "rotation.h"
#include <chasles/screw.h>

#ifdef CHS_SINGLE
typedef chs_screwf screw;
#else
typedef chs_screw screw;
#endif

/* The screw of a displacement without rotation: CHS_PURE_TRANSLATION, or CHS_NO_MOTION along a conventional z axis. */
static inline int screw_of_translation(const real p[3], screw *s) {
  real length = norm(p, 3);
  unit(p, s->axis);
  if (length == 0) s->axis[2] = 1;
  for (int i = 0; i < 3; i++) s->point[i] = 0;
  s->translation = length;
  s->angle = 0;
  return length > 0 ? CHS_PURE_TRANSLATION : CHS_NO_MOTION;
}

/* The screw of the rotation q, of vector length n > 0, that takes the point `from` to `from + travel` (Fenton & Shi
 * 1990, eq. 10 and 24). False where the axis lies beyond the range of the format. */
static inline int screw_of_rotation(const quaternion *q, real n, const real from[3], const real travel[3], screw *s) {
  real e[3], exd[3], middle[3], cotangent = q->w / n;
  unit(q->v, e);
  for (int i = 0; i < 3; i++) middle[i] = from[i] + K(0.5) * travel[i];
  cross(e, travel, exd);
  real along = dot(e, middle);
  for (int i = 0; i < 3; i++) s->point[i] = (middle[i] - along * e[i]) + K(0.5) * (cotangent * exd[i]);
  copy(e, 3, s->axis);
  s->translation = dot(e, travel);
  s->angle = K(2.0) * FN(chs_p_angle_of)(n, q->w > 0 ? q->w : K(0.0)); /* a settled half-turn may be a hair beyond pi */
  return all_finite(s->point, 3);
}

#endif
