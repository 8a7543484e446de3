/* The rotational error of axisymmetric tools: what a function for one and one for many have in common. */
#ifndef CHASLES_TILT_PRIVATE_H
#define CHASLES_TILT_PRIVATE_H

#include "rotation.h"

#define tilt_and_torsion_of(...) FN(chs_p_tilt_and_torsion_of)(__VA_ARGS__)
#define torsion_is_undefined(...) FN(chs_p_torsion_is_undefined)(__VA_ARGS__)

/* A vector of the tilt's sine, and its cosine; and those of torsion times a factor, which is 0 where it is undefined. */
typedef struct tilt_and_torsion {
  real tilted[3], cosine, turned, straight;
} tilt_and_torsion;

/* Columns x, y, d of both, and how far each moved. The differences are exact for near orientations; products that the
 * nominal axes' own rounding would spoil cancel before they are formed. */
SHARED tilt_and_torsion tilt_and_torsion_of(const real N[9], const real A[9]) {
  real x0[3] = {N[0], N[3], N[6]}, y0[3] = {N[1], N[4], N[7]}, d0[3] = {N[2], N[5], N[8]};
  real x1[3] = {A[0], A[3], A[6]}, y1[3] = {A[1], A[4], A[7]}, d1[3] = {A[2], A[5], A[8]};
  real dx[3], dy[3], dd[3];
  tilt_and_torsion t;
  subtract(x1, x0, dx);
  subtract(y1, y0, dy);
  subtract(d1, d0, dd);
  cross(d0, dd, t.tilted);
  t.cosine = dot(d0, d1);
  t.turned = dot(y0, dx) - dot(x0, dy);
  t.straight = dot(x0, x1) + dot(y0, y1);
  return t;
}

SHARED int torsion_is_undefined(const tilt_and_torsion *t) {
  return (t->cosine < 0) & (ABS(t->turned) + ABS(t->straight) <= K(8.0) * EPS);
}

#endif
