/* What moves: twists of moving poses, the screw from one pose to another, and the Jacobians of the exponential. */
#include <chasles/se3.h>

#include "pose.h"

void FN(chs_se3_hat)(const real V[6], real M[16]) {
  real W[9], v[3];
  hat(V, W);
  copy3(V + 3, v);
  join(W, v, M);
  M[15] = 0;
}

void FN(chs_se3_vee)(const real M[16], real V[6]) {
  real W[9], v[3];
  part(M, W, v);
  FN(chs_so3_vee)(W, V);
  copy3(v, V + 3);
}

void FN(chs_se3_ad)(const real V[6], real ad[36]) {
  real W[9], U[9];
  hat(V, W);
  hat(V + 3, U);
  put_blocks(W, U, ad);
}

/* y = a x b, z = c x d + e x f */
static INLINE void crosses(const real a[3], const real b[3], const real c[3], const real d[3], const real e[3],
                           const real f[3], real y[3], real z[3]) {
  real ab[3], cd[3], ef[3];
  cross(a, b, ab);
  cross(c, d, cd);
  cross(e, f, ef);
  add_to(cd, ef);
  copy3(ab, y);
  copy3(cd, z);
}

void FN(chs_se3_ad_twist)(const real V[6], const real U[6], real W[6]) { crosses(V, U, V + 3, U, V, U + 3, W, W + 3); }

void FN(chs_se3_ad_wrench)(const real V[6], const real F[6], real G[6]) {
  crosses(F + 3, V, F, V, F + 3, V + 3, G + 3, G);
}

/* (omega; v), or the overflow of one of them. */
static int put_twist(const real omega[3], const real v[3], int status, real V[6]) {
  if (!all_finite(omega, 3) || !all_finite(v, 3)) return CHS_ERR_OVERFLOW;
  copy(omega, 3, V);
  copy(v, 3, V + 3);
  return status;
}

static int twist_of_rate(const real T[16], const real dT[16], int in_body, real V[6]) {
  real R[9], p[3], dR[9], dp[3], W[9], Rt[9], omega[3], lever[3];
  part(dT, dR, dp);
  int status = first_error(read_pose(T, R, p), finiteness(dT, 12));
  if (status != CHS_OK) return status;
  transpose(R, Rt);
  FN(chs_so3_multiply)(in_body ? Rt : dR, in_body ? dR : Rt, W);
  FN(chs_so3_vee)(W, omega);
  if (in_body)
    rotate_back(R, dp, dp);
  else {
    cross(omega, p, lever);
    subtract(dp, lever, dp);
  }
  return put_twist(omega, dp, CHS_OK, V);
}

int FN(chs_se3_body_twist)(const real T[16], const real dT[16], real V[6]) { return twist_of_rate(T, dT, 1, V); }

int FN(chs_se3_space_twist)(const real T[16], const real dT[16], real V[6]) { return twist_of_rate(T, dT, 0, V); }

/* log(A^T B). Where the sine decides, it comes from the differences of the columns, in which what A and B have in
 * common cancels exactly. */
static int rotation_between(const real A[9], const real B[9], real w[3]) {
  real R[9], At[9], d[9];
  transpose(A, At);
  FN(chs_so3_multiply)(At, B, R);
  real trace = (R[0] + R[4]) + R[8];
  if (!sine_decides(trace)) return logarithm_far(R, w);
  for (int i = 0; i < 9; i++) d[i] = B[i] - A[i];
  FN(chs_so3_multiply)(At, d, R);
  const real v[3] = {R[7] - R[5], R[2] - R[6], R[3] - R[1]};
  logarithm_near(v, trace, w);
  return CHS_OK;
}

/* log(A^-1 B) of two poses, or why there is none. */
static int log_between(const real A[16], const real B[16], real w[3], real v[3]) {
  real RA[9], pA[3], RB[9], pB[3], p[3];
  int status = first_error(read_pose(A, RA, pA), read_pose(B, RB, pB));
  if (status != CHS_OK) return status;
  subtract(pB, pA, p);
  rotate_back(RA, p, p);
  status = rotation_between(RA, RB, w);
  inverse_jacobian_times(w, p, v);
  return status;
}

/* The error of what has that status and of the number x, or CHS_OK. */
static int error_with(int status, real x) {
  int wrong = finiteness(&x, 1);
  return status < 0 ? first_error(status, wrong) : wrong;
}

static int twist_between(const real A[16], const real B[16], real dt, int in_body, real V[6]) {
  real twist[6];
  int status = log_between(A, B, twist, twist + 3), error = error_with(status, dt);
  if (error != CHS_OK) return error;
  if (dt == 0) return CHS_ERR_ARGUMENT;
  if (!in_body) FN(chs_se3_adjoint_twist)(A, twist, twist);
  for (int i = 0; i < 6; i++) twist[i] /= dt;
  return put_twist(twist, twist + 3, status, V);
}

int FN(chs_se3_body_twist_between)(const real A[16], const real B[16], real dt, real V[6]) {
  return twist_between(A, B, dt, 1, V);
}

int FN(chs_se3_space_twist_between)(const real A[16], const real B[16], real dt, real V[6]) {
  return twist_between(A, B, dt, 0, V);
}

int FN(chs_se3_interpolate)(const real A[16], const real B[16], real s, real T[16]) {
  real V[6], step[16], end[16];
  int near_b = s > K(0.5), status = log_between(A, B, V, V + 3), error = error_with(status, s);
  if (error != CHS_OK) return error;
  if (!all_finite(V, 6)) return CHS_ERR_OVERFLOW;
  for (int i = 0; i < 6; i++) V[i] *= near_b ? s - K(1.0) : s;
  if (!all_finite(V, 3)) return CHS_ERR_ANGLE_RANGE;
  error = all_finite(V, 6) ? FN(chs_se3_exp)(V, step) : CHS_ERR_OVERFLOW;
  if (error != CHS_OK) return error;
  FN(chs_se3_compose)(near_b ? B : A, step, end);
  if (!all_finite(end, 12)) return CHS_ERR_OVERFLOW;
  copy(end, 16, T);
  return status;
}

int FN(chs_se3_distance)(const real A[16], const real B[16], real *angle, real *length) {
  real RA[9], pA[3], RB[9], pB[3], d[3], turn;
  int status = first_error(read_pose(A, RA, pA), read_pose(B, RB, pB));
  if (status != CHS_OK) return status;
  FN(chs_so3_angle)(RA, RB, &turn);
  subtract(pB, pA, d);
  real apart = norm(d, 3);
  if (!is_finite(apart)) return CHS_ERR_OVERFLOW;
  *angle = turn;
  *length = apart;
  return CHS_OK;
}

int FN(chs_se3_weighted_distance)(const real A[16], const real B[16], real scale, real *distance) {
  real apart[2];
  int error = error_with(FN(chs_se3_distance)(A, B, apart, apart + 1), scale);
  if (error != CHS_OK) return error;
  if (scale < 0) return CHS_ERR_ARGUMENT;
  apart[0] *= scale;
  real d = norm(apart, 2);
  if (!is_finite(d)) return CHS_ERR_OVERFLOW;
  *distance = d;
  return CHS_OK;
}

/* Q = f I + [y] + x w^T + w x^T */
static void coupling_from(const real w[3], real f, const real y[3], const real x[3], real Q[9]) {
  FN(chs_so3_hat)(y, Q);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) Q[3 * i + j] += x[i] * w[j] + x[j] * w[i];
  for (int i = 0; i < 3; i++) Q[4 * i] += f;
}

/* Q, the derivative of J_l(w) along v; side is -1 for that of J_r. With a' = (c - b)/2, and -b' and -c' from kernels up
 * to pi, beyond which they do not cancel. */
static void coupling(const real w[3], const real v[3], real side, half_angle h, real Q[9]) {
  int within = h.tt <= CHS_PI_A * CHS_PI_A;
  real a = sine_ratio(h), b = cosine_ratio(h), c = cubic_ratio(h), wv = dot(w, v), x[3], y[3];
  real b_slope = within ? -CHS_COSINE_SLOPE(h.tt) : (K(0.5) * a - b) / h.tt;
  real c_slope = within ? -CHS_CUBIC_SLOPE(h.tt) : (b - K(3.0) * c) / (K(2.0) * h.tt);
  for (int i = 0; i < 3; i++) {
    y[i] = side * (b * v[i] + K(2.0) * (wv * b_slope) * w[i]);
    x[i] = c * v[i] + (wv * c_slope) * w[i];
  }
  coupling_from(w, wv * (c - b), y, x, Q);
}

/* P, the derivative of J_l(w)^-1 along v: with d = -b'/b, k' = -c/(4b) and d' = (c/(4b) - d)/t. */
static void inverse_coupling(const real w[3], const real v[3], real side, half_angle h, real P[9]) {
  int within = h.tt <= CHS_PI_A * CHS_PI_A;
  real b = cosine_ratio(h), k_slope = -cubic_ratio(h) / (K(4.0) * b), wv = dot(w, v), x[3], y[3];
  real d = within ? CHS_COTANGENT(h.tt) : (K(1.0) - half_cotangent(h)) / h.tt;
  real d_slope = within ? CHS_COTANGENT_SLOPE(h.tt) / (K(4.0) * b) : (-k_slope - d) / h.tt;
  for (int i = 0; i < 3; i++) {
    y[i] = side * K(-0.5) * v[i];
    x[i] = d * v[i] + (wv * d_slope) * w[i];
  }
  coupling_from(w, K(2.0) * (wv * k_slope), y, x, P);
}

/* The four Jacobians: that of the rotation twice, and the coupling. */
static int jacobian(const real V[6], int inverse, real side, real J[36]) {
  real block[9], Q[9];
  half_angle half;
  int status = half_angle_of(V, &half);
  if (status == CHS_OK && inverse) status = inverse_jacobian_from(V, half, side, block);
  if (status != CHS_OK) return finiteness(V, 6) == CHS_OK ? status : finiteness(V, 6);
  if (inverse)
    inverse_coupling(V, V + 3, side, half, Q);
  else {
    jacobian_from(V, half, side, block);
    coupling(V, V + 3, side, half, Q);
  }
  if (!all_finite(Q, 9)) return why_not_finite(V, 6);
  put_blocks(block, Q, J);
  return CHS_OK;
}

int FN(chs_se3_left_jacobian)(const real V[6], real J[36]) { return jacobian(V, 0, K(1.0), J); }

int FN(chs_se3_right_jacobian)(const real V[6], real J[36]) { return jacobian(V, 0, K(-1.0), J); }

int FN(chs_se3_left_jacobian_inverse)(const real V[6], real J[36]) { return jacobian(V, 1, K(1.0), J); }

int FN(chs_se3_right_jacobian_inverse)(const real V[6], real J[36]) { return jacobian(V, 1, K(-1.0), J); }
