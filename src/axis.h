/* Screws (omega; v) as their axis, a line, and their pitch. */
#ifndef CHASLES_AXIS_H
#define CHASLES_AXIS_H

#include "vec3.h"

#define per_radian(...) FN(chs_p_per_radian)(__VA_ARGS__)
#define axis_of(...) FN(chs_p_axis_of)(__VA_ARGS__)

/* e = omega/|omega| and w = v/|omega|, omega not 0, with all their digits whatever the size of either; the rate is
 * |omega|. What overflows is left to the caller. */
LARGE void per_radian(const real S[6], real e[3], real w[3], real *rate);

/* Likewise with w = m + h e, m the moment of the axis, at a right angle to e, and h the pitch; the result is the rate. */
LARGE real axis_of(const real S[6], real e[3], real m[3], real *h);

#if LARGE_BODIES

LARGE void per_radian(const real S[6], real e[3], real w[3], real *rate) {
  real scale = safe_to_square(largest(S, 3)), x[3], length;
  int first = scale == 1 || (scale > 1) == (largest(S + 3, 3) < 1); /* what brings v nearer to 1, lest it overflow */
  for (int i = 0; i < 3; i++) x[i] = scale * S[i];
  length = SQRT(dot(x, x));
  for (int i = 0; i < 3; i++) {
    e[i] = x[i] / length;
    w[i] = first ? scale * S[3 + i] / length : S[3 + i] / length * scale;
  }
  *rate = length / scale;
}

LARGE real axis_of(const real S[6], real e[3], real m[3], real *h) {
  real rate, along, rest;
  per_radian(S, e, m, &rate);
  along = dot(e, m);
  for (int i = 0; i < 3; i++) m[i] -= along * e[i];
  rest = dot(e, m); /* the length of e is off by an eps or so, of which a steep screw sees twice as much */
  for (int i = 0; i < 3; i++) m[i] -= rest * e[i];
  *h = along + rest;
  return rate;
}

#endif

#endif
