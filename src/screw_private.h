/* The screw of a displacement whose rotation is known as a quaternion; shared by poses and by measured points. */
#ifndef CHASLES_SCREW_PRIVATE_H
#define CHASLES_SCREW_PRIVATE_H

#include "rotation.h"
#include <chasles/screw.h>

#define screw_of_translation(...) FN(chs_p_screw_of_translation)(__VA_ARGS__)
#define screw_through(...) FN(chs_p_screw_through)(__VA_ARGS__)
#define angle_of_half(...) FN(chs_p_angle_of_half)(__VA_ARGS__)
#define screw_about(...) FN(chs_p_screw_about)(__VA_ARGS__)
#define screw_of_rotation(...) FN(chs_p_screw_of_rotation)(__VA_ARGS__)
#define is_finite_screw(...) FN(chs_p_is_finite_screw)(__VA_ARGS__)

#ifdef CHS_SINGLE
typedef chs_screwf screw;
#else
typedef chs_screw screw;
#endif

/* The screw of a displacement without rotation: CHS_PURE_TRANSLATION, or CHS_NO_MOTION along a conventional z axis. */
LARGE int screw_of_translation(const real p[3], screw *s);

/* Axis, point and translation of the screw that turns about the direction v and takes the point `from` to `from +
 * travel`, by eq. 10 and 24 of Fenton & Shi 1990: e = scale v is a unit vector, cotangent that of half the angle. */
SHARED void screw_through(const real from[3], const real travel[3], const real v[3], real scale, real cotangent,
                          screw *s) {
  real x = scale * v[0] + K(0.0), y = scale * v[1] + K(0.0), z = scale * v[2] + K(0.0);
  real mx = from[0] + K(0.5) * travel[0], my = from[1] + K(0.5) * travel[1], mz = from[2] + K(0.5) * travel[2];
  real along = x * mx + y * my + z * mz, half = K(0.5) * cotangent;
  s->translation = x * travel[0] + y * travel[1] + z * travel[2];
  s->point[0] = (mx - along * x) + half * (y * travel[2] - z * travel[1]);
  s->point[1] = (my - along * y) + half * (z * travel[0] - x * travel[2]);
  s->point[2] = (mz - along * z) + half * (x * travel[1] - y * travel[0]);
  s->axis[0] = x;
  s->axis[1] = y;
  s->axis[2] = z;
}

/* Is what screw_through made of finite numbers within the format? */
SHARED int is_finite_screw(const screw *s) { return all_finite(s->point, 3) && is_finite(s->translation); }

/* The angle of a rotation of which n and w, times any number, are the sine and the cosine of the half. */
SHARED real angle_of_half(real n, real w) {
  arc half = arc_of(n, w > 0 ? w : K(0.0)); /* a settled half-turn may be a hair beyond pi */
  return K(2.0) * (half.base + half.rest);
}

/* The screw about the unit vector e that takes the point `from` to `from + travel`; n and w as above. */
SHARED void screw_about(const real e[3], real n, real w, const real from[3], const real travel[3], screw *s) {
  screw_through(from, travel, e, 1, w / n, s);
  s->angle = angle_of_half(n, w);
}

/* That of the rotation q, of vector length n > 0. False where the axis or the way along it is beyond the format. */
SHARED int screw_of_rotation(const quaternion *q, real n, const real from[3], const real travel[3], screw *s) {
  real e[3];
  unit(q->v, e);
  screw_about(e, n, q->w, from, travel, s);
  return is_finite_screw(s);
}

#if LARGE_BODIES

LARGE int screw_of_translation(const real p[3], screw *s) {
  real length = unit(p, s->axis);
  if (length == 0) s->axis[2] = 1;
  for (int i = 0; i < 3; i++) s->point[i] = 0;
  s->translation = length;
  s->angle = 0;
  return length > 0 ? CHS_PURE_TRANSLATION : CHS_NO_MOTION;
}

#endif

#endif
