/* A pose as its two parts, and the 6x6 matrices that act on twists as their blocks. */
#ifndef CHASLES_POSE_H
#define CHASLES_POSE_H

#include "rotation.h"

#define part(...) FN(chs_p_part)(__VA_ARGS__)
#define read_pose(...) FN(chs_p_read_pose)(__VA_ARGS__)
#define join(...) FN(chs_p_join)(__VA_ARGS__)
#define copy_row(...) FN(chs_p_copy_row)(__VA_ARGS__)
#define combine_rows(...) FN(chs_p_combine_rows)(__VA_ARGS__)
#define compose_row(...) FN(chs_p_compose_row)(__VA_ARGS__)
#define compose(...) FN(chs_p_compose)(__VA_ARGS__)
#define transform(...) FN(chs_p_transform)(__VA_ARGS__)
#define put_row(...) FN(chs_p_put_row)(__VA_ARGS__)
#define put_blocks(...) FN(chs_p_put_blocks)(__VA_ARGS__)

/* R may be T. */
SHARED void part(const real T[16], real R[9], real p[3]) {
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

/* The parts of what should be a pose, and CHS_OK or why it is none. */
LARGE int read_pose(const real T[16], real R[9], real p[3]);

int FN(chs_p_check_pose)(const real T[16]);

SHARED void join(const real R[9], const real p[3], real T[16]) {
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

/* b lies apart from a or is the same. */
SHARED void copy_row(const real a[4], real b[4]) {
  OVER_ROW
  for (int j = 0; j < 4; j++) b[j] = a[j];
}

/* row = (a b c) [R p]; row lies apart from T. */
SHARED void combine_rows(real a, real b, real c, const real T[12], real row[4]) {
  OVER_ROW
  for (int j = 0; j < 4; j++) row[j] = a * T[j] + b * T[4 + j] + c * T[8 + j];
}

/* A row of A B from that of A. To add -0 changes no number. */
static inline void compose_row(const real A[4], const real B[12], real row[4]) {
  static const real last[4] = {0, 0, 0, 1};
  real p[4];
  OVER_ROW
  for (int j = 0; j < 4; j++) {
    real entry = A[j];
    p[j] = last[j] > 0 ? entry : K(-0.0);
  }
  combine_rows(A[0], A[1], A[2], B, row);
  OVER_ROW
  for (int j = 0; j < 4; j++) row[j] += p[j];
}

/* C = A B; C may be A or B. Not SHARED: there is one copy where size counts. */
static INLINE void compose(const real A[16], const real B[16], real C[16]) {
  real rows[3][4];
  compose_row(A, B, rows[0]);
  compose_row(A + 4, B, rows[1]);
  compose_row(A + 8, B, rows[2]);
  copy_row(rows[0], C);
  copy_row(rows[1], C + 4);
  copy_row(rows[2], C + 8);
  C[12] = C[13] = C[14] = 0;
  C[15] = 1;
}

/* y = R x + p; y may be x. */
SHARED void transform(const real T[12], const real x[3], real y[3]) {
  real a = dot(T, x) + T[3], b = dot(T + 4, x) + T[7], c = dot(T + 8, x) + T[11];
  y[0] = a;
  y[1] = b;
  y[2] = c;
}

SHARED void put_row(const real a[3], const real b[3], real row[6]) {
  row[0] = a[0];
  row[1] = a[1];
  row[2] = a[2];
  row[3] = b[0];
  row[4] = b[1];
  row[5] = b[2];
}

/* M = [A 0; C A], 6x6. */
SHARED void put_blocks(const real A[9], const real C[9], real M[36]) {
  static const real zero[3] = {0};
  put_row(A, zero, M);
  put_row(A + 3, zero, M + 6);
  put_row(A + 6, zero, M + 12);
  put_row(C, A, M + 18);
  put_row(C + 3, A + 3, M + 24);
  put_row(C + 6, A + 6, M + 30);
}

#if LARGE_BODIES

LARGE int read_pose(const real T[16], real R[9], real p[3]) {
  part(T, R, p);
  return first_error(check_rotation_apart(R), finiteness_at_a_glance(p, 3));
}

#endif

#endif
