/* Rotations and poses put together, turned round and applied: sums of products alone. */
#define SUMS_ALONE
#include <chasles/se3.h>
#include <chasles/so3.h>

#include "pose.h"

/* A row of three goes as one vector of four, where vectors are that long. The fourth number is none: the next row takes its
 * place. That of B's last row is one that compilers have at hand, so that they need not go through memory for it. */
#if VECTORS && defined(CHS_SINGLE)
static inline void multiply_row(const real A[3], const real B[7], const real last[4], real row[4]) {
  OVER_ROW
  for (int j = 0; j < 4; j++) row[j] = A[0] * B[j] + A[1] * B[3 + j] + A[2] * last[j];
}

void FN(chs_so3_multiply)(const real A[9], const real B[9], real C[9]) {
  const real last[4] = {B[6], B[7], B[8], B[5]};
  real rows[3][4];
  multiply_row(A, B, last, rows[0]);
  multiply_row(A + 3, B, last, rows[1]);
  multiply_row(A + 6, B, last, rows[2]);
  copy_row(rows[0], C);
  copy_row(rows[1], C + 3);
  copy3(rows[2], C + 6);
}
#else
void FN(chs_so3_multiply)(const real A[9], const real B[9], real C[9]) { multiply(A, B, C); }
#endif

void FN(chs_so3_transpose)(const real A[9], real B[9]) { transpose(A, B); }

void FN(chs_so3_apply)(const real R[9], const real x[3], real y[3]) { rotate(R, x, y); }

void FN(chs_se3_from_parts)(const real R[9], const real p[3], real T[16]) {
  real r[9], t[3];
  copy9(R, r);
  copy3(p, t);
  join(r, t, T);
}

void FN(chs_se3_to_parts)(const real T[16], real R[9], real p[3]) {
  real r[9], t[3];
  part(T, r, t);
  copy9(r, R);
  copy3(t, p);
}

void FN(chs_se3_compose)(const real A[16], const real B[16], real C[16]) { compose(A, B, C); }

/* Turning rows into columns is quick where each is one vector, and slower than number by number where it is two. */
#if defined(CHS_SINGLE) || defined(__AVX__)
void FN(chs_se3_inverse)(const real A[16], real B[16]) {
  real rows[3][4], p[4];
  combine_rows(A[3], A[7], A[11], A, p);
  copy_row(A, rows[0]);
  copy_row(A + 4, rows[1]);
  copy_row(A + 8, rows[2]);
  OVER_ROW
  for (int j = 0; j < 4; j++) {
    B[4 * j] = rows[0][j];
    B[4 * j + 1] = rows[1][j];
    B[4 * j + 2] = rows[2][j];
    B[4 * j + 3] = -p[j];
  }
  B[12] = B[13] = B[14] = 0;
  B[15] = 1;
}
#else
void FN(chs_se3_inverse)(const real A[16], real B[16]) {
  real R[9], p[3];
  part(A, R, p);
  rotate_back(R, p, p);
  p[0] = -p[0];
  p[1] = -p[1];
  p[2] = -p[2];
  transpose(R, R);
  join(R, p, B);
}
#endif

void FN(chs_se3_apply)(const real T[16], const real x[3], real y[3]) { transform(T, x, y); }
