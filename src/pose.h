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

#endif
