/* Rotations between their forms: matrix, rotation vector, and the quaternion as four homogeneous numbers. */
#ifndef CHASLES_ROTATION_H
#define CHASLES_ROTATION_H

#include "angle.h"
#include "real.h"
#include "vec3.h"
#include <chasles/so3.h>

#define offsets(...) FN(chs_p_offsets)(__VA_ARGS__)
#define is_rotation(...) FN(chs_p_is_rotation)(__VA_ARGS__)
#define check_rotation(...) FN(chs_p_check_rotation)(__VA_ARGS__)
#define check_rotation_apart(...) FN(chs_p_check_rotation_apart)(__VA_ARGS__)
#define first_error(...) FN(chs_p_first_error)(__VA_ARGS__)
#define negate(...) FN(chs_p_negate)(__VA_ARGS__)
#define settle_half_turn(...) FN(chs_p_settle_half_turn)(__VA_ARGS__)
#define axis_by_selects(...) FN(chs_p_axis_by_selects)(__VA_ARGS__)
#define quaternion_by_axis(...) FN(chs_p_quaternion_by_axis)(__VA_ARGS__)
#define quaternion_of(...) FN(chs_p_quaternion_of)(__VA_ARGS__)
#define rotation_from(...) FN(chs_p_rotation_from)(__VA_ARGS__)
#define rotation_from_half_angle(...) FN(chs_p_rotation_from_half_angle)(__VA_ARGS__)
#define jacobian_times(...) FN(chs_p_jacobian_times)(__VA_ARGS__)
#define jacobian_diagonal(...) FN(chs_p_jacobian_diagonal)(__VA_ARGS__)
#define jacobian_of_ratios(...) FN(chs_p_jacobian_of_ratios)(__VA_ARGS__)
#define jacobian_from(...) FN(chs_p_jacobian_from)(__VA_ARGS__)
#define inverse_jacobian_from(...) FN(chs_p_inverse_jacobian_from)(__VA_ARGS__)
#define rotation_from_quaternion(...) FN(chs_p_rotation_from_quaternion)(__VA_ARGS__)
#define sine_decides(...) FN(chs_p_sine_decides)(__VA_ARGS__)
#define turn_near(...) FN(chs_p_turn_near)(__VA_ARGS__)
#define turn_far(...) FN(chs_p_turn_far)(__VA_ARGS__)
#define logarithm_near(...) FN(chs_p_logarithm_near)(__VA_ARGS__)
#define logarithm_far(...) FN(chs_p_logarithm_far)(__VA_ARGS__)
#define along(...) FN(chs_p_along)(__VA_ARGS__)
#define logarithm(...) FN(chs_p_logarithm)(__VA_ARGS__)
#define inverse_jacobian_times(...) FN(chs_p_inverse_jacobian_times)(__VA_ARGS__)

/* (v; w) proportional to (sin(theta/2) e; cos(theta/2)), of any length, w >= 0: theta in [0, pi] needs no division. */
typedef struct quaternion {
  real v[3], w;
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

/* Whether it is certain at a glance that R is near a rotation. Singular values 1 + d have squares of the sum 3 + 2 e + q
 * and a product that is 1 + e + (e^2 - q)/2 but for d1 d2 d3, with e the sum of the d and q that of their squares. So
 * the sum less twice the product is 1 + 2 q - e^2 but for little; within these bounds q is at most 1.6e-5 and no offset
 * above 0.0081. NaN fails. */
SHARED int is_rotation(const real R[9]) {
  real third[3], determinant, squares = (dot(R, R) + dot(R + 3, R + 3)) + dot(R + 6, R + 6);
  cross(R, R + 3, third);
  determinant = dot(R + 6, third);
  return (ABS(squares - K(3.0)) <= K(1.0) / K(128.0)) &
         (squares - K(2.0) * determinant <= K(1.0) + K(1.0) / K(65536.0));
}

/* R is near enough to a rotation to be read as one; otherwise the status says why not. */
SHARED int check_rotation(const real R[9]) {
  return is_rotation(R) ? CHS_OK : FN(chs_p_rotation_status)(R, (real)CHS_SO3_FAR);
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
SELDOM void FN(chs_p_settle_half_turn)(quaternion *q, real zone, real length);

/* A matrix near a rotation is read through a column of 4 (w; v)(w; v)^T (Shepperd 1978). This is the largest on the
 * diagonal of x's, y's and z's, with w of either sign; by selects, each with a comparison of its own, because gcc makes
 * no vectors of a condition that several share. */
SHARED_INLINE quaternion axis_by_selects(const real R[9]) {
  real x = R[7] - R[5], y = R[2] - R[6], z = R[3] - R[1], xy = R[1] + R[3], xz = R[2] + R[6], yz = R[5] + R[7];
  real xx = (K(1.0) + R[0]) - (R[4] + R[8]), yy = (K(1.0) - R[0]) + (R[4] - R[8]), zz = (K(1.0) - R[0]) - (R[4] - R[8]);
  real v0 = R[4] > R[0] ? xy : xx, v1 = R[4] > R[0] ? yy : xy, v2 = R[4] > R[0] ? yz : xz, w = R[4] > R[0] ? y : x;
  real x_or_y = R[0] > R[4] ? R[0] : R[4];
  quaternion q;
  q.v[0] = R[8] > x_or_y ? xz : v0;
  q.v[1] = R[8] > x_or_y ? yz : v1;
  q.v[2] = R[8] > x_or_y ? zz : v2;
  q.w = R[8] > x_or_y ? z : w;
  return q;
}

/* The same, where processors look ahead by indices, for compilers make cases of the selects, which would be mispredicted
 * as often as not. The numbers to be picked lie apart in memory, so that no compiler loads two at once before both are
 * stored. */
SHARED_INLINE quaternion quaternion_by_axis(const real R[9]) {
#if VECTORS
  const real xy = R[1] + R[3], xz = R[2] + R[6], yz = R[5] + R[7];
  const real v[3][3] = {{(K(1.0) + R[0]) - (R[4] + R[8]), xy, xz},
                        {xy, (K(1.0) - R[0]) + (R[4] - R[8]), yz},
                        {xz, yz, (K(1.0) - R[0]) - (R[4] - R[8])}};
  const real w[3] = {R[7] - R[5], R[2] - R[6], R[3] - R[1]};
  real x_or_y = R[0] > R[4] ? R[0] : R[4];
  unsigned axis = R[8] > x_or_y ? 2 : R[4] > R[0];
  quaternion q = {{v[0][axis], v[1][axis], v[2][axis]}, w[axis]};
  return q;
#else
  return axis_by_selects(R);
#endif
}

/* That of the largest of all four columns, which agrees with the nearest rotation to a fraction of the matrix's own
 * rounding errors. */
SHARED_INLINE quaternion quaternion_of(const real R[9]) {
  static const real signs[2] = {1, -1};
  quaternion of_w = {{R[7] - R[5], R[2] - R[6], R[3] - R[1]}, (K(1.0) + R[0]) + (R[4] + R[8])};
  real trace = (R[0] + R[4]) + R[8];
  if (trace >= R[0] && trace >= R[4] && trace >= R[8]) return of_w;
  quaternion q = quaternion_by_axis(R);
  real sign = signs[q.w < 0];
  UNROLL for (int i = 0; i < 3; i++) q.v[i] = sign * q.v[i];
  q.w = ABS(q.w);
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

/* w = part v + m v */
SHARED void along(const real v[3], real part, real m, real w[3]) {
  w[0] = part * v[0] + m * v[0];
  w[1] = part * v[1] + m * v[1];
  w[2] = part * v[2] + m * v[2];
}

/* Up to 104 degrees the logarithm is that of the sine and the trace, beyond that of a quaternion. */
SHARED int sine_decides(real trace) { return trace >= K(0.5); }

/* Rotation vectors are a power of two times v plus a small multiple of v, so that little remains to be rounded. Of the
 * axis times twice the sine it takes theta/(2 sin(theta)) = 1/2 + m, a function of the trace. */
SHARED real turn_near(real trace) {
  real u = K(3.0) - trace;
  return K(0.25) * u - u * (CHS_TURN_TOP(trace) / CHS_TURN_BOTTOM(trace));
}

/* Beyond, v is the quaternion's, of length n and with w >= 0, and the vector is v + m v. */
SHARED real turn_far(real nn, real n, real w) {
  real t = K(2.0) * w / n, more = t * arc_ratio_rest(w * w, nn);
  return (((CHS_PI_A - n) - t) + (CHS_PI_B - more)) / n;
}

/* The rotation vector of v, the axis times twice the sine. */
SHARED void logarithm_near(const real v[3], real trace, real w[3]) { along(v, K(0.5), turn_near(trace), w); }

/* That of a rotation by more, and CHS_OK or CHS_HALF_TURN. */
SHARED_INLINE int logarithm_far(const real R[9], real w[3]) {
  static const real signs[2] = {1, -1};
  quaternion q = quaternion_by_axis(R);
  real sign = signs[q.w < 0], nn = q.v[0] * q.v[0] + (q.v[1] * q.v[1] + q.v[2] * q.v[2]), n = SQRT(nn);
  q.w = ABS(q.w);
  real m = turn_far(nn, n, q.w);
  if (q.w > EPS * n) {
    along(q.v, sign, sign * m, w);
    return CHS_OK;
  }
  quaternion settled = {{sign * q.v[0], sign * q.v[1], sign * q.v[2]},
                        q.w}; /* apart: the ordinary case is in registers */
  FN(chs_p_settle_half_turn)(&settled, 0, n);
  along(settled.v, 1, m, w);
  for (int i = 0; i < 3; i++) w[i] += K(0.0); /* no zero is negative */
  return CHS_HALF_TURN;
}

/* That of a matrix that has been checked. */
SHARED_INLINE int logarithm(const real R[9], real w[3]) {
  real trace = (R[0] + R[4]) + R[8];
  if (!sine_decides(trace)) return logarithm_far(R, w);
  const real v[3] = {R[7] - R[5], R[2] - R[6], R[3] - R[1]};
  logarithm_near(v, trace, w);
  return CHS_OK;
}

/* v = J_l(w)^-1 p = p - w x p / 2 + d w x (w x p) for theta up to pi, d = (1 - (theta/2) cot(theta/2))/theta^2. */
SHARED void inverse_jacobian_times(const real w[3], const real p[3], real v[3]) {
  real d = CHS_COTANGENT(dot(w, w)), dw[3] = {d * w[0], d * w[1], d * w[2]}, wxp[3], twice[3];
  cross(w, p, wxp);
  cross(dw, wxp, twice);
  v[0] = p[0] + (twice[0] - K(0.5) * wxp[0]);
  v[1] = p[1] + (twice[1] - K(0.5) * wxp[1]);
  v[2] = p[2] + (twice[2] - K(0.5) * wxp[2]);
}

#if LARGE_BODIES

LARGE int check_rotation_apart(const real R[9]) { return check_rotation(R); }

#endif

#endif
