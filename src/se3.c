#include <chasles/se3.h>

#include "pose.h"
#include "rotation.h"

/* T = exp [V] given what there is to know about omega's angle. */
static INLINE int exp_from_half_angle(const real V[6], half_angle half, real T[16]) {
  real R[9], p[3];
  jacobian_times(V, half, V + 3, p);
  if (!is_finite(p[0] + p[1] + p[2]) && !all_finite(p, 3)) return why_not_finite(V, 6);
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
  real R[9], p[3], w[3], v[3];
  part(T, R, p);
  int status = first_error(check_rotation(R), finiteness_at_a_glance(p, 3));
  if (status != CHS_OK) return status;
  status = logarithm(R, w);
  inverse_jacobian_times(w, p, v);
  if (!all_finite(v, 3)) return CHS_ERR_OVERFLOW;
  copy3(w, V);
  copy3(v, V + 3);
  return status;
}

/* z = a x - b y */
static inline void difference(real a, const real x[4], real b, const real y[4], real z[4]) {
  OVER_ROW
  for (int j = 0; j < 4; j++) z[j] = a * x[j] - b * y[j];
}

/* Three rows (R p) of T as [p] (R p). */
static inline void moments(const real T[12], real pR[12]) {
  difference(T[7], T + 8, T[11], T + 4, pR);
  difference(T[11], T, T[3], T + 8, pR + 4);
  difference(T[3], T + 4, T[7], T, pR + 8);
}

/* Row i of the upper and of the lower half of Ad: (r 0) and (m r). Four numbers go at once where the fourth is
 * overwritten, and r comes in both ways, so that none of them has to be taken apart. */
static inline void put_halves(const real row[4], const real r[3], const real moment[4], real Ad[24]) {
  copy_row(row, Ad);
  Ad[3] = Ad[4] = Ad[5] = 0;
  copy_row(moment, Ad + 18);
  copy3(r, Ad + 21);
}

void FN(chs_se3_adjoint)(const real T[16], real Ad[36]) {
  real rows[12], pR[12], R[9], p[3];
  part(T, R, p);
  copy_row(T, rows);
  copy_row(T + 4, rows + 4);
  copy_row(T + 8, rows + 8);
  moments(T, pR);
  put_halves(rows, R, pR, Ad);
  put_halves(rows + 4, R + 3, pR + 4, Ad + 6);
  put_halves(rows + 8, R + 6, pR + 8, Ad + 12);
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
  real p[3] = {T[3], T[7], T[11]}, lever[3], Rtx[4], Rty[4];
  cross(p, x, lever);
  subtract(y, lever, lever);
  combine_rows(x[0], x[1], x[2], T, Rtx);
  combine_rows(lever[0], lever[1], lever[2], T, Rty);
  copy3(Rtx, u);
  copy3(Rty, v);
}

void FN(chs_se3_adjoint_twist)(const real T[16], const real V[6], real U[6]) { carry(T, V, V + 3, U, U + 3); }

void FN(chs_se3_adjoint_inverse_twist)(const real T[16], const real V[6], real U[6]) {
  carry_back(T, V, V + 3, U, U + 3);
}

void FN(chs_se3_adjoint_wrench)(const real T[16], const real F[6], real G[6]) { carry(T, F + 3, F, G + 3, G); }

void FN(chs_se3_adjoint_inverse_wrench)(const real T[16], const real F[6], real G[6]) {
  carry_back(T, F + 3, F, G + 3, G);
}
