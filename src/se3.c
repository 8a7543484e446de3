#include <chasles/se3.h>

#include "pose.h"
#include "rotation.h"

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
  copy3(w, V);
  copy3(v, V + 3);
  return status;
}

/* z = a x + b y */
static inline void combine(real a, const real x[3], real b, const real y[3], real z[3]) {
  z[0] = a * x[0] + b * y[0];
  z[1] = a * x[1] + b * y[1];
  z[2] = a * x[2] + b * y[2];
}

void FN(chs_se3_adjoint)(const real T[16], real Ad[36]) {
  real R[9], p[3], pR[9];
  part(T, R, p);
  combine(p[1], R + 6, -p[2], R + 3, pR);
  combine(p[2], R, -p[0], R + 6, pR + 3);
  combine(p[0], R + 3, -p[1], R, pR + 6);
  put_blocks(R, pR, Ad);
}

void FN(chs_se3_adjoint_inverse)(const real T[16], real Ad[36]) {
  real R[9], p[3], Rtp[9];
  part(T, R, p);
  transpose(R, R);
  /* Row i of -R^T [p] is p x (column i of R). */
  cross(p, R, Rtp);
  cross(p, R + 3, Rtp + 3);
  cross(p, R + 6, Rtp + 6);
  put_blocks(R, Rtp, Ad);
}

/* (u; v) = (R x; R y + p x R x): a twist as it stands, a wrench with its halves exchanged. Inline, and nothing copied
 * by a loop: what goes to the stack by numbers and comes back by vectors, or the other way, waits there for long. */
static INLINE void carry(const real T[16], const real x[3], const real y[3], real u[3], real v[3]) {
  real R[9], p[3], Rx[3], Ry[3], lever[3];
  part(T, R, p);
  rotate(R, x, Rx);
  rotate(R, y, Ry);
  cross(p, Rx, lever);
  add_to(Ry, lever);
  copy3(Rx, u);
  copy3(Ry, v);
}

/* (u; v) = (R^T x; R^T (y - p x x)), the inverse of carry. */
static INLINE void carry_back(const real T[16], const real x[3], const real y[3], real u[3], real v[3]) {
  real R[9], p[3], Rtx[3], lever[3];
  part(T, R, p);
  cross(p, x, lever);
  subtract(y, lever, lever);
  rotate_back(R, x, Rtx);
  rotate_back(R, lever, v);
  copy3(Rtx, u);
}

void FN(chs_se3_adjoint_twist)(const real T[16], const real V[6], real U[6]) { carry(T, V, V + 3, U, U + 3); }

void FN(chs_se3_adjoint_inverse_twist)(const real T[16], const real V[6], real U[6]) {
  carry_back(T, V, V + 3, U, U + 3);
}

void FN(chs_se3_adjoint_wrench)(const real T[16], const real F[6], real G[6]) { carry(T, F + 3, F, G + 3, G); }

void FN(chs_se3_adjoint_inverse_wrench)(const real T[16], const real F[6], real G[6]) {
  carry_back(T, F + 3, F, G + 3, G);
}
