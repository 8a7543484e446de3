/* The axis of a screw (omega; v): its line, and its pitch. */
#ifndef CHASLES_AXIS_H
#define CHASLES_AXIS_H

#include "vec3.h"

/* e = omega/|omega|, and v/|omega| = m + h e with m, the axis's moment, at a right angle to e. CHS_ERR_SINGULAR where
 * omega is 0, or so short that its length has lost digits; what overflows is left to the caller. */
static inline int axis_of(const real S[6], real e[3], real m[3], real *h) {
  real length = norm(S, 3), along;
  if (!(length >= REAL_MIN)) return CHS_ERR_SINGULAR;
  for (int i = 0; i < 3; i++) {
    e[i] = S[i] / length;
    m[i] = S[3 + i] / length;
  }
  along = dot(e, m);
  for (int i = 0; i < 3; i++) m[i] -= along * e[i];
  *h = along;
  return CHS_OK;
}

#endif
