/* What every method of motion.h does once the rotation is known: the screw, the pose, and what is special about them. */
#ifndef CHASLES_MOTION_PRIVATE_H
#define CHASLES_MOTION_PRIVATE_H

#include "pose.h"
#include "screw_private.h"

typedef struct centroid {
  real center[3]; /* of the initial points */
  real travel[3]; /* its displacement */
} centroid;

static inline int finish_translation(const centroid *at, screw *out, real T[16]) {
  static const real identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  screw s;
  int status = screw_of_translation(at->travel, &s);
  if (!is_finite(s.translation)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (T) join(identity, at->travel, T);
  return status;
}

/* The rotation q, whose error is a few eps times the condition number. */
static inline int finish_rotation(const centroid *at, real condition, quaternion *q, screw *out, real T[16]) {
  real R[9], p[3], turned[3], vv = dot(q->v, q->v), n = SQRT(vv);
  if (n == 0) return finish_translation(at, out, T);
  real zone = K(8.0) * EPS * condition;
  int half_turn = q->w <= zone * n;
  screw s;
  settle_half_turn(q, zone, n);
  rotation_from_quaternion(q, vv + q->w * q->w, R);
  if (!screw_of_rotation(q, n, at->center, at->travel, &s)) return CHS_ERR_OVERFLOW;
  rotate(R, at->center, turned);
  for (int i = 0; i < 3; i++) p[i] = (at->center[i] - turned[i]) + at->travel[i];
  if (!all_finite(p, 3)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (T) join(R, p, T);
  if (condition * SQRT(EPS) > K(1.0)) return CHS_ILL_CONDITIONED;
  return half_turn ? CHS_HALF_TURN : CHS_OK;
}

#endif
