/* Rotations whose matrices, or whose effect on some points, are known without rounding. */
#ifndef CHASLES_TESTS_EXACT_H
#define CHASLES_TESTS_EXACT_H

#include <math.h>

#include "precision.h"
#include "random.h"

static const real identity3[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static const real identity4[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

enum { CUBE_ROTATIONS = 24 };

/* The k-th rotation that maps the coordinate axes to each other: a product with it is exact. */
static inline void cube_rotation(int k, real R[9]) {
  int x = k / 2 % 3, y = (x + 1 + k % 2) % 3, z = 3 - x - y, sx = k / 6 % 2 ? -1 : 1, sy = k / 12 % 2 ? -1 : 1;
  int even = (y - x + 3) % 3 == 1;
  for (int i = 0; i < 9; i++) R[i] = 0;
  R[3 * x] = (real)sx;
  R[3 * y + 1] = (real)sy;
  R[3 * z + 2] = (real)(even ? sx * sy : -sx * sy);
}

/* A cube rotation and a translation of integers. */
static inline void cube_pose(int k, int reach, real T[16]) {
  real R[9], p[3];
  cube_rotation(k, R);
  random_integers(-reach, reach, 3, p);
  FN(chs_se3_from_parts)(R, p, T);
}

/* The rotation of the quaternion (w; v) of integers, w >= 0. Times nn it is a matrix of integers. */
typedef struct turn {
  int w, v[3];
  int vv, nn; /* v.v and w w + v.v */
} turn;

static inline turn turn_of(int w, int x, int y, int z) {
  turn q = {w, {x, y, z}, x * x + y * y + z * z, w * w + x * x + y * y + z * z};
  return q;
}

static inline turn random_turn(int w) {
  turn q;
  do q = turn_of(w, integer(-3, 3), integer(-3, 3), integer(-3, 3));
  while (q.vv == 0);
  return q;
}

/* nn R, (w w - v.v) I + 2 v v^T + 2 w [v]. */
static inline int turn_numerator(const turn *q, int i, int j) {
  const int *v = q->v;
  int skew = i == j ? 0 : (j - i + 3) % 3 == 1 ? -v[3 - i - j] : v[3 - i - j];
  return (i == j ? q->w * q->w - q->vv : 0) + 2 * v[i] * v[j] + 2 * q->w * skew;
}

static inline void turn_matrix(const turn *q, real R[9]) {
  for (int i = 0; i < 9; i++) R[i] = (real)turn_numerator(q, i / 3, i % 3) / (real)q->nn;
}

/* theta = 2 atan2(|v|, w) */
static inline double turn_angle(const turn *q) { return 2 * atan2(sqrt(q->vv), q->w); }

/* v/|v|; for a half-turn with the first component that is not zero made positive. */
static inline void turn_axis(const turn *q, real e[3]) {
  int sign = 1, first = q->v[0] != 0 ? q->v[0] : q->v[1] != 0 ? q->v[1] : q->v[2];
  if (q->w == 0 && first < 0) sign = -1;
  for (int i = 0; i < 3; i++) e[i] = rounded(sign * q->v[i] / sqrt(q->vv));
}

#endif
