/* Rotations between their forms: matrix, rotation vector, and the quaternion as four homogeneous numbers. */
#ifndef CHASLES_ROTATION_H
#define CHASLES_ROTATION_H

#include "angle.h"
#include "real.h"
#include "vec3.h"
#include <chasles/so3.h>

#define offsets(...) FN(chs_p_offsets)(__VA_ARGS__)
#define sum_of_offsets(...) FN(chs_p_sum_of_offsets)(__VA_ARGS__)
#define check_rotation(...) FN(chs_p_check_rotation)(__VA_ARGS__)
#define check_rotation_apart(...) FN(chs_p_check_rotation_apart)(__VA_ARGS__)
#define first_error(...) FN(chs_p_first_error)(__VA_ARGS__)
#define negate(...) FN(chs_p_negate)(__VA_ARGS__)
#define settle_half_turn(...) FN(chs_p_settle_half_turn)(__VA_ARGS__)
#define quaternion_near(...) FN(chs_p_quaternion_near)(__VA_ARGS__)
#define column_beyond(...) FN(chs_p_column_beyond)(__VA_ARGS__)
#define quaternion_of(...) FN(chs_p_quaternion_of)(__VA_ARGS__)
#define rotation_from(...) FN(chs_p_rotation_from)(__VA_ARGS__)
#define rotation_from_half_angle(...) FN(chs_p_rotation_from_half_angle)(__VA_ARGS__)
#define jacobian_times(...) FN(chs_p_jacobian_times)(__VA_ARGS__)
#define jacobian_diagonal(...) FN(chs_p_jacobian_diagonal)(__VA_ARGS__)
#define jacobian_of_ratios(...) FN(chs_p_jacobian_of_ratios)(__VA_ARGS__)
#define jacobian_from(...) FN(chs_p_jacobian_from)(__VA_ARGS__)
#define inverse_jacobian_from(...) FN(chs_p_inverse_jacobian_from)(__VA_ARGS__)
#define cotangent_ratio(...) FN(chs_p_cotangent_ratio)(__VA_ARGS__)
#define rotation_from_quaternion(...) FN(chs_p_rotation_from_quaternion)(__VA_ARGS__)
#define multiple_near(...) FN(chs_p_multiple_near)(__VA_ARGS__)
#define multiple_far(...) FN(chs_p_multiple_far)(__VA_ARGS__)
#define logarithm_near(...) FN(chs_p_logarithm_near)(__VA_ARGS__)
#define logarithm_of(...) FN(chs_p_logarithm_of)(__VA_ARGS__)
#define logarithm(...) FN(chs_p_logarithm)(__VA_ARGS__)
#define inverse_jacobian_times(...) FN(chs_p_inverse_jacobian_times)(__VA_ARGS__)

/* (v; w) proportional to (sin(theta/2) e; cos(theta/2)), of any length, w >= 0: theta in [0, pi] needs no division. */
typedef struct quaternion {
  real v[3], w;
  int near;        /* theta is at most a quarter turn, or little more, and the length about 4 cos(theta/2) */
  real short_of_4; /* 4 - w before rounding, where near */
} quaternion;

/* What is 0 in a rotation: r1.r1 - 1, r2.r2 - 1, r1.r2 and r3 - r1 x r2, r the rows. */
SHARED void offsets(const real R[9], real off[6]) {
  off[0] = dot(R, R) - K(1.0);
  off[1] = dot(R + 3, R + 3) - K(1.0);
  off[2] = dot(R, R + 3);
  cross(R, R + 3, off + 3);
  subtract(R + 6, off + 3, off + 3);
}

/* The largest of them in size; NaN where the matrix holds one. */
real FN(chs_p_deviation)(const real R[9]);

/* Why R is no rotation to within the tolerance: CHS_ERR_NAN, _INFINITE, _REFLECTION or _NOT_ROTATION; or CHS_OK. */
SELDOM int FN(chs_p_rotation_status)(const real R[9], real tolerance);

/* At least the largest of them in size. */
SHARED real sum_of_offsets(const real R[9]) {
  real off[6];
  offsets(R, off);
  return ((ABS(off[0]) + ABS(off[1])) + (ABS(off[2]) + ABS(off[3]))) + (ABS(off[4]) + ABS(off[5]));
}

/* R is near enough to a rotation to be read as one; otherwise the status says why not. */
SHARED int check_rotation(const real R[9]) {
  const real far = (real)CHS_SO3_FAR;
  return sum_of_offsets(R) <= far ? CHS_OK : FN(chs_p_rotation_status)(R, far);
}

/* The same for those who are in no hurry. */
LARGE int check_rotation_apart(const real R[9]);

/* Of two statuses, the one that counts: NaN before infinity before anything else that is wrong. */
SHARED int first_error(int a, int b) {
  if (a == CHS_OK || b == CHS_OK) return a == CHS_OK ? b : a;
  return a > b ? a : b;
}

/* The other quaternion of the same rotation. */
SHARED void negate(quaternion *q) {
  for (int i = 0; i < 3; i++) q->v[i] = -q->v[i];
  q->w = -q->w;
}

/* At a half-turn the axis has no sign of its own: its first non-zero component is made positive. An angle counts as a
 * half-turn when pi - theta <= 2 zone; components count as zero up to zone times the length. */
SHARED void settle_half_turn(quaternion *q, real zone, real length) {
  if (q->w > zone * length) return;
  for (int i = 0; i < 3; i++) {
    if (ABS(q->v[i]) <= zone * length) continue;
    if (q->v[i] < 0) negate(q);
    return;
  }
}

/* A matrix near a rotation is read through the column of 4 (w; v)(w; v)^T that is largest on the diagonal (Shepperd
 * 1978), which agrees with the nearest rotation to a fraction of the matrix's own rounding errors. Up to a quarter turn
 * that is the column of w, and this is it. */
SHARED quaternion quaternion_near(const real R[9]) {
  real d = (K(1.0) - R[0]) + (K(1.0) - R[4]) + (K(1.0) - R[8]);
  quaternion q = {{R[7] - R[5], R[2] - R[6], R[3] - R[1]}, K(4.0) - d, d <= K(2.0), d};
  return q;
}

/* A column as it comes: the components of its vector in the places i, j and k and still to be multiplied by sign, which
 * has been taken from w. */
typedef struct largest_column {
  real vi, vj, vk, w, sign;
  unsigned i, j, k;
} largest_column;

/* The largest column beyond a quarter turn. Tables instead of cases, which would be mispredicted as often as not. */
SHARED largest_column column_beyond(const real R[9], const quaternion *near) {
  static const unsigned char axes[8][3] = {{0, 1, 2}, {1, 2, 0}, {0, 1, 2}, {1, 2, 0},
                                           {0, 1, 2}, {2, 0, 1}, {2, 0, 1}, {2, 0, 1}};
  static const real signs[2] = {K(1.0), K(-1.0)};
  int order = (R[4] > R[0]) + 2 * (R[8] > R[0]) + 4 * (R[8] > R[4]);
  unsigned i = axes[order][0], j = axes[order][1], k = axes[order][2];
  real others = R[4 * j] + R[4 * k];
  if (others >= 0) {
    largest_column of_w = {near->v[0], near->v[1], near->v[2], (K(1.0) + R[4 * i]) + others, K(1.0), 0, 1, 2};
    return of_w;
  }
  real w = R[3 * k + j] - R[3 * j + k];
  largest_column c;
  c.vi = (R[4 * i] - R[4 * j]) + (K(1.0) - R[4 * k]);
  c.vj = R[3 * i + j] + R[3 * j + i];
  c.vk = R[3 * i + k] + R[3 * k + i];
  c.w = ABS(w);
  c.sign = signs[w < 0];
  c.i = i;
  c.j = j;
  c.k = k;
  return c;
}

SHARED quaternion quaternion_of(const real R[9]) {
  quaternion q = quaternion_near(R);
  if (q.near) return q;
  largest_column c = column_beyond(R, &q);
  q.v[c.i] = c.sign * c.vi;
  q.v[c.j] = c.sign * c.vj;
  q.v[c.k] = c.sign * c.vk;
  q.w = c.w;
  return q;
}

/* R = I + a [w] + 2 ss [w]^2 with a = sin(theta)/|w|, ss = (sin(theta/2)/|w|)^2 and cc = cos(theta/2)^2. The diagonal
 * is cc + ss (w_x^2 - w_y^2 - w_z^2) and so on, which is half as sensitive to the error of ss as the usual forms. R may
 * be w: all of w is read before R is written. */
SHARED void rotation_from(const real w[3], real a, real ss, real cc, real R[9]) {
  real xx = w[0] * w[0], yy = w[1] * w[1], zz = ss * (w[2] * w[2]), sum = ss * (xx + yy), difference = ss * (xx - yy);
  real x = w[0] + w[0], xy = ss * (x * w[1]), xz = ss * (x * w[2]), yz = ss * ((w[1] + w[1]) * w[2]);
  real ax = a * w[0], ay = a * w[1], az = a * w[2], common = cc - zz;
  R[0] = common + difference;
  R[4] = common - difference;
  R[8] = (cc + zz) - sum;
  R[1] = xy - az;
  R[3] = xy + az;
  R[2] = xz + ay;
  R[6] = xz - ay;
  R[5] = yz - ax;
  R[7] = yz + ax;
}

SHARED void rotation_from_half_angle(const real w[3], half_angle h, real R[9]) {
  rotation_from(w, sine_ratio(h), h.ss, h.c * h.c, R);
}

/* p = J_l(w) v. */
SHARED void jacobian_times(const real w[3], half_angle h, const real v[3], real p[3]) {
  real a = sine_ratio(h), b = cosine_ratio(h), c = cubic_ratio(h) * dot(w, v), wxv[3];
  cross(w, v, wxv);
  p[0] = a * v[0] + (b * wxv[0] + c * w[0]);
  p[1] = a * v[1] + (b * wxv[1] + c * w[1]);
  p[2] = a * v[2] + (b * wxv[2] + c * w[2]);
}

/* An entry on the diagonal of what follows: the smaller share of c |w|^2 is added to a or taken from 1. No case, which
 * would be mispredicted. */
SHARED real jacobian_diagonal(real a, real c, real own, real others) {
  const real either[2] = {K(1.0) - c * others, a + c * own};
  return either[own < others];
}

/* J = a I + b [w] + c w w^T with a + c |w|^2 = 1, the shape that all four Jacobians share. J may be w: all of w is read
 * before J is written. */
SHARED void jacobian_of_ratios(const real w[3], real a, real b, real c, real J[9]) {
  real xx = w[0] * w[0], yy = w[1] * w[1], zz = w[2] * w[2];
  real xy = c * (w[0] * w[1]), xz = c * (w[0] * w[2]), yz = c * (w[1] * w[2]);
  real bx = b * w[0], by = b * w[1], bz = b * w[2];
  J[0] = jacobian_diagonal(a, c, xx, yy + zz);
  J[4] = jacobian_diagonal(a, c, yy, xx + zz);
  J[8] = jacobian_diagonal(a, c, zz, xx + yy);
  J[1] = xy - bz;
  J[3] = xy + bz;
  J[2] = xz + by;
  J[6] = xz - by;
  J[5] = yz - bx;
  J[7] = yz + bx;
}

/* J_l(w), or with side = -1 J_r(w). */
SHARED void jacobian_from(const real w[3], half_angle h, real side, real J[9]) {
  jacobian_of_ratios(w, sine_ratio(h), side * cosine_ratio(h), cubic_ratio(h), J);
}

/* The inverse of that, and CHS_OK or CHS_ERR_SINGULAR. */
SHARED int inverse_jacobian_from(const real w[3], half_angle h, real side, real J[9]) {
  /* Nearer to a multiple of 2 pi the rounding of w alone decides the result. */
  if (ABS(h.s) <= K(8.0) * EPS) return CHS_ERR_SINGULAR;
  real k = half_cotangent(h);
  /* (1 - k)/theta^2, below 1 rad from terms that do not cancel: (s^2 - (theta - sin(theta))/theta^3) / (2 s c). */
  real d = h.tt < 1 ? (h.ss - cubic_ratio(h)) / sine_ratio(h) : (K(1.0) - k) / h.tt;
  jacobian_of_ratios(w, k, side * K(-0.5), d, J);
  return CHS_OK;
}

/* (1 - k)/theta^2 with k = (theta/2) cot(theta/2); 1/12 where the difference would be nothing but rounding. */
SHARED real cotangent_ratio(real k, real tt) { return tt < EPS ? K(1.0) / K(12.0) : (K(1.0) - k) / tt; }

/* The rotation of a quaternion of squared length nn. */
SHARED void rotation_from_quaternion(const quaternion *q, real nn, real R[9]) {
  real scale = K(2.0) / nn, x = scale * q->v[0], y = scale * q->v[1], z = scale * q->v[2];
  real xx = x * q->v[0], yy = y * q->v[1], zz = z * q->v[2];
  real xy = x * q->v[1], xz = x * q->v[2], yz = y * q->v[2];
  real wx = x * q->w, wy = y * q->w, wz = z * q->w;
  R[0] = K(1.0) - (yy + zz);
  R[4] = K(1.0) - (xx + zz);
  R[8] = K(1.0) - (xx + yy);
  R[1] = xy - wz;
  R[3] = xy + wz;
  R[2] = xz + wy;
  R[6] = xz - wy;
  R[5] = yz - wx;
  R[7] = yz + wx;
}

/* Rotation vectors are a power of two times v plus a small multiple of v, so that little remains to be rounded. Near,
 * w = v/2 + m v; the result is m, and k = (theta/2) cot(theta/2). rest is arc_ratio_rest of the half-angle's tangent. */
SHARED real multiple_near(const quaternion *q, real rest, real *k) {
  *k = K(1.0) + rest;
  return (K(0.5) * q->short_of_4 + K(2.0) * rest) * (K(1.0) / q->w);
}

/* Beyond a quarter turn w = v + m v. n = |v|, w >= 0, and rest is that of the cotangent. */
SHARED real multiple_far(real n, real w, real rest, real *k) {
  real t = K(2.0) * w / n, more = t * rest;
  *k = K(0.25) * t * ((CHS_PI_A - t) - more);
  return (((CHS_PI_A - n) - t) + (CHS_PI_B - more)) * (K(1.0) / n);
}

SHARED void logarithm_near(const quaternion *q, real w[3], real *k) {
  real m = multiple_near(q, arc_ratio_rest(dot(q->v, q->v), q->w * q->w), k);
  w[0] = K(0.5) * q->v[0] + m * q->v[0];
  w[1] = K(0.5) * q->v[1] + m * q->v[1];
  w[2] = K(0.5) * q->v[2] + m * q->v[2];
}

/* The rotation vector of a quaternion, k as above, and CHS_OK or CHS_HALF_TURN. */
SHARED int logarithm_of(quaternion q, real w[3], real *k) {
  if (q.near) {
    logarithm_near(&q, w, k);
    return CHS_OK;
  }
  real nn = dot(q.v, q.v), n = SQRT(nn), m = multiple_far(n, q.w, arc_ratio_rest(q.w * q.w, nn), k);
  settle_half_turn(&q, 0, n);
  w[0] = q.v[0] + m * q.v[0];
  w[1] = q.v[1] + m * q.v[1];
  w[2] = q.v[2] + m * q.v[2];
  return q.w <= EPS * n ? CHS_HALF_TURN : CHS_OK;
}

SELDOM int FN(chs_p_half_turn)(real w, real vector[3]);

/* That of a matrix that has been checked. */
SHARED int logarithm(const real R[9], real w[3], real *k) {
  quaternion q = quaternion_near(R);
  if (q.near) {
    logarithm_near(&q, w, k);
    return CHS_OK;
  }
  largest_column c = column_beyond(R, &q);
  real nn = c.vi * c.vi + (c.vj * c.vj + c.vk * c.vk), n = SQRT(nn);
  real m = c.sign * multiple_far(n, c.w, arc_ratio_rest(c.w * c.w, nn), k);
  w[c.i] = c.sign * c.vi + m * c.vi;
  w[c.j] = c.sign * c.vj + m * c.vj;
  w[c.k] = c.sign * c.vk + m * c.vk;
  return c.w <= EPS * n ? FN(chs_p_half_turn)(c.w, w) : CHS_OK;
}

/* v = J_l(w)^-1 p, k as above. */
SHARED void inverse_jacobian_times(const real w[3], real k, const real p[3], real v[3]) {
  real d = cotangent_ratio(k, dot(w, w)) * dot(w, p), wxp[3];
  cross(w, p, wxp);
  v[0] = k * p[0] + (d * w[0] - K(0.5) * wxp[0]);
  v[1] = k * p[1] + (d * w[1] - K(0.5) * wxp[1]);
  v[2] = k * p[2] + (d * w[2] - K(0.5) * wxp[2]);
}

#if LARGE_BODIES

LARGE int check_rotation_apart(const real R[9]) { return check_rotation(R); }

#endif

#endif
