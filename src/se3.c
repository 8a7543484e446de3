#include <chasles/se3.h>

#include "pose.h"
#include "rotation.h"

void FN(chs_se3_from_parts)(const real R[9], const real p[3], real T[16]) {
  real r[9], t[3];
  copy(R, 9, r);
  copy(p, 3, t);
  join(r, t, T);
}

void FN(chs_se3_to_parts)(const real T[16], real R[9], real p[3]) {
  real r[9], t[3];
  part(T, r, t);
  copy(r, 9, R);
  copy(t, 3, p);
}

void FN(chs_se3_compose)(const real A[16], const real B[16], real C[16]) {
  real RA[9], pA[3], RB[9], pB[3], R[9], p[3];
  part(A, RA, pA);
  part(B, RB, pB);
  multiply(RA, RB, R);
  rotate(RA, pB, p);
  add_to(p, pA);
  join(R, p, C);
}

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

void FN(chs_se3_apply)(const real T[16], const real x[3], real y[3]) { transform(T, x, y); }

/* T = exp [V] given what there is to know about omega's angle. */
static INLINE int exp_from_half_angle(const real V[6], half_angle half, real T[16]) {
  real R[9], p[3];
  jacobian_times(V, half, V + 3, p);
  if (!all_finite(p, 3)) return why_not_finite(V, 6);
  rotation_from_half_angle(V, half, R);
  join(R, p, T);
  return CHS_OK;
}

SELDOM static int exp_beyond_pi(const real V[6], real T[16]) {
  half_angle half;
  int status = FN(chs_p_half_angle_beyond_pi)(V, &half);
  if (status == CHS_OK) return exp_from_half_angle(V, half, T);
  return finiteness(V, 6) == CHS_OK ? status : finiteness(V, 6);
}

int FN(chs_se3_exp)(const real V[6], real T[16]) {
  split_square square = squared_length(V);
  return within_pi(square) ? exp_from_half_angle(V, half_angle_within_pi(square), T) : exp_beyond_pi(V, T);
}

int FN(chs_se3_log)(const real T[16], real V[6]) {
  real R[9], p[3], w[3], v[3], k;
  part(T, R, p);
  int status = first_error(check_rotation(R), finiteness(p, 3));
  if (status != CHS_OK) return status;
  status = logarithm(R, w, &k);
  inverse_jacobian_times(w, k, p, v);
  if (!all_finite(v, 3)) return CHS_ERR_OVERFLOW;
  copy(w, 3, V);
  copy(v, 3, V + 3);
  return status;
}

void FN(chs_se3_adjoint)(const real T[16], real Ad[36]) {
  static const real zero[9] = {0};
  real R[9], p[3], pR[9];
  part(T, R, p);
  for (int j = 0; j < 3; j++) {
    real column[3] = {R[j], R[3 + j], R[6 + j]};
    cross(p, column, column);
    for (int i = 0; i < 3; i++) pR[3 * i + j] = column[i];
  }
  put_block(R, 0, 0, Ad);
  put_block(zero, 0, 3, Ad);
  put_block(pR, 3, 0, Ad);
  put_block(R, 3, 3, Ad);
}

void FN(chs_se3_adjoint_inverse)(const real T[16], real Ad[36]) {
  static const real zero[9] = {0};
  real R[9], p[3], Rt[9], Rtp[9];
  part(T, R, p);
  for (int i = 0; i < 3; i++) {
    /* Row i of -R^T [p] is p x (column i of R). */
    real column[3] = {R[i], R[3 + i], R[6 + i]};
    copy(column, 3, Rt + 3 * i);
    cross(p, column, Rtp + 3 * i);
  }
  put_block(Rt, 0, 0, Ad);
  put_block(zero, 0, 3, Ad);
  put_block(Rtp, 3, 0, Ad);
  put_block(Rt, 3, 3, Ad);
}

/* (x; y) <- (R x; R y + p x R x): a twist as it stands, a wrench with its halves exchanged. */
static void carry(const real T[16], real x[3], real y[3]) {
  real R[9], p[3], lever[3];
  part(T, R, p);
  rotate(R, x, x);
  rotate(R, y, y);
  cross(p, x, lever);
  for (int i = 0; i < 3; i++) y[i] += lever[i];
}

/* (x; y) <- (R^T x; R^T (y - p x x)), the inverse of carry. */
static void carry_back(const real T[16], real x[3], real y[3]) {
  real R[9], p[3], lever[3];
  part(T, R, p);
  cross(p, x, lever);
  subtract(y, lever, y);
  rotate_back(R, x, x);
  rotate_back(R, y, y);
}

void FN(chs_se3_adjoint_twist)(const real T[16], const real V[6], real U[6]) {
  real u[6];
  copy(V, 6, u);
  carry(T, u, u + 3);
  copy(u, 6, U);
}

void FN(chs_se3_adjoint_inverse_twist)(const real T[16], const real V[6], real U[6]) {
  real u[6];
  copy(V, 6, u);
  carry_back(T, u, u + 3);
  copy(u, 6, U);
}

void FN(chs_se3_adjoint_wrench)(const real T[16], const real F[6], real G[6]) {
  real g[6];
  copy(F, 6, g);
  carry(T, g + 3, g);
  copy(g, 6, G);
}

void FN(chs_se3_adjoint_inverse_wrench)(const real T[16], const real F[6], real G[6]) {
  real g[6];
  copy(F, 6, g);
  carry_back(T, g + 3, g);
  copy(g, 6, G);
}
