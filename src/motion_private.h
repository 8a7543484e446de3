/* What the methods of motion.h share. */
#ifndef CHASLES_MOTION_PRIVATE_H
#define CHASLES_MOTION_PRIVATE_H

#include "pose.h"
#include "screw_private.h"

#define power_of_two_below(...) FN(chs_p_power_of_two_below)(__VA_ARGS__)

/* The largest power of two not above x, for x in the format's normal range short of its ends (Rump's ufp). */
SHARED real power_of_two_below(real x) {
  real q = x * (K(1.0) / EPS + K(1.0));
  return ABS(q - (K(1.0) - K(0.5) * EPS) * q);
}

/* The screw and the pose, either of which may be NULL, of a displacement without rotation. */
SELDOM int FN(chs_p_finish_translation)(const real travel[3], screw *out, real T[16]);

#endif
