/* What the methods of motion.h share. */
#ifndef CHASLES_MOTION_PRIVATE_H
#define CHASLES_MOTION_PRIVATE_H

#include "pose.h"
#include "screw_private.h"

/* The largest power of two not above x, for x in the format's normal range short of its ends (Rump's ufp). */
static inline real power_of_two_below(real x) {
  real q = x * (K(1.0) / EPS + K(1.0));
  return ABS(q - (K(1.0) - K(0.5) * EPS) * q);
}

static SELDOM int finish_translation(const real travel[3], screw *out, real T[16]) {
  static const real identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  screw s;
  int status = screw_of_translation(travel, &s);
  if (!is_finite(s.translation)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (T) join(identity, travel, T);
  return status;
}

#endif
