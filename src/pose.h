/* A pose as its two parts. */
#ifndef CHASLES_POSE_H
#define CHASLES_POSE_H

#include "vec3.h"

static inline void part(const real T[16], real R[9], real p[3]) {
  for (int i = 0; i < 3; i++) {
    copy(T + 4 * i, 3, R + 3 * i);
    p[i] = T[4 * i + 3];
  }
}

static inline void join(const real R[9], const real p[3], real T[16]) {
  for (int i = 0; i < 3; i++) {
    copy(R + 3 * i, 3, T + 4 * i);
    T[4 * i + 3] = p[i];
  }
  T[12] = T[13] = T[14] = 0;
  T[15] = 1;
}

/* y = R x, and y = R^T x; y may be x. */
static inline void rotate(const real R[9], const real x[3], real y[3]) {
  real v[3] = {dot(R, x), dot(R + 3, x), dot(R + 6, x)};
  copy(v, 3, y);
}

static inline void rotate_back(const real R[9], const real x[3], real y[3]) {
  real v[3];
  for (int i = 0; i < 3; i++) v[i] = R[i] * x[0] + R[3 + i] * x[1] + R[6 + i] * x[2];
  copy(v, 3, y);
}

#endif
