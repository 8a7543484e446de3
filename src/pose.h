/* A pose as its two parts, and the 6x6 matrices that act on twists as their blocks. */
#ifndef CHASLES_POSE_H
#define CHASLES_POSE_H

#include "vec3.h"

static inline void part(const real T[16], real R[9], real p[3]) {
  R[0] = T[0];
  R[1] = T[1];
  R[2] = T[2];
  p[0] = T[3];
  R[3] = T[4];
  R[4] = T[5];
  R[5] = T[6];
  p[1] = T[7];
  R[6] = T[8];
  R[7] = T[9];
  R[8] = T[10];
  p[2] = T[11];
}

static inline void join(const real R[9], const real p[3], real T[16]) {
  T[0] = R[0];
  T[1] = R[1];
  T[2] = R[2];
  T[3] = p[0];
  T[4] = R[3];
  T[5] = R[4];
  T[6] = R[5];
  T[7] = p[1];
  T[8] = R[6];
  T[9] = R[7];
  T[10] = R[8];
  T[11] = p[2];
  T[12] = T[13] = T[14] = 0;
  T[15] = 1;
}

/* y = R x + p; y may be x. */
static inline void transform(const real T[12], const real x[3], real y[3]) {
  real a = dot(T, x) + T[3], b = dot(T + 4, x) + T[7], c = dot(T + 8, x) + T[11];
  y[0] = a;
  y[1] = b;
  y[2] = c;
}

/* Writes a 3x3 block of a 6x6 matrix. */
static inline void put_block(const real block[9], int row, int column, real M[36]) {
  for (int i = 0; i < 3; i++) copy(block + 3 * i, 3, M + 6 * (row + i) + column);
}

#endif
