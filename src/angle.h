/* The kernels that stand in for libm: sine and cosine of an angle and of half of one, and the angle of a point in the
 * plane. */
#ifndef CHASLES_ANGLE_H
#define CHASLES_ANGLE_H

#include "coefficients.h"
#include "real.h"
#include "vec3.h"
#include <chasles/so3.h>

#define on_grid(...) FN(chs_p_on_grid)(__VA_ARGS__)
#define squared_length(...) FN(chs_p_squared_length)(__VA_ARGS__)
#define half_angle_within_pi(...) FN(chs_p_half_angle_within_pi)(__VA_ARGS__)
#define within_pi(...) FN(chs_p_within_pi)(__VA_ARGS__)
#define half_angle_of(...) FN(chs_p_half_angle_of)(__VA_ARGS__)
#define sine_ratio(...) FN(chs_p_sine_ratio)(__VA_ARGS__)
#define cosine_ratio(...) FN(chs_p_cosine_ratio)(__VA_ARGS__)
#define cubic_ratio(...) FN(chs_p_cubic_ratio)(__VA_ARGS__)
#define half_cotangent(...) FN(chs_p_half_cotangent)(__VA_ARGS__)
#define angles_status(...) FN(chs_p_angles_status)(__VA_ARGS__)
#define sin_cos_beyond(...) FN(chs_p_sin_cos_beyond)(__VA_ARGS__)
#define quarter_turns_in(...) FN(chs_p_quarter_turns_in)(__VA_ARGS__)
#define sin_cos_of(...) FN(chs_p_sin_cos_of)(__VA_ARGS__)
#define arc_ratio_rest(...) FN(chs_p_arc_ratio_rest)(__VA_ARGS__)
#define arc_of(...) FN(chs_p_arc_of)(__VA_ARGS__)
#define angle_in_sector(...) FN(chs_p_angle_in_sector)(__VA_ARGS__)
#define angle_from_square(...) FN(chs_p_angle_from_square)(__VA_ARGS__)
#define safe_square(...) FN(chs_p_safe_square)(__VA_ARGS__)
#define signed_angle_of(...) FN(chs_p_signed_angle_of)(__VA_ARGS__)

#ifdef CHS_SINGLE
#define ANGLE_MAX CHS_ANGLE_MAXF
#else
#define ANGLE_MAX CHS_ANGLE_MAX
#endif

/* The square of an angle as head + rest, the head on a grid so coarse that what is made of it below is exact; and as
 * one number, which may be off by a few roundings more. */
typedef struct split_square {
  real t, head, rest;
} split_square;

SHARED real on_grid(real x) { return (x + GRID) - GRID; }

/* head + rest from the largest square to the least, so that but for the squares themselves hardly anything is rounded;
 * t does not wait for their order, and keeps a NaN. */
SHARED split_square squared_length(const real w[3]) {
  real x = w[0] * w[0], y = w[1] * w[1], z = w[2] * w[2];
  real more = x > y ? x : y, less = x < y ? x : y, most = more > z ? more : z, third = more < z ? more : z;
  real t = (x + y) + z, head = on_grid(t);
  split_square square = {t, head, ((most - head) + less) + third};
  return square;
}

/* What the exponentials need of a rotation by theta. Where the angle was reduced modulo 2 pi, s and c may both carry
 * the other sign: only s c, s s, c c and c / s are meant to be used. */
typedef struct half_angle {
  real s;     /* sin(theta/2) / (theta/2) */
  real c;     /* cos(theta/2) */
  real ss;    /* s^2 / 4 */
  real a;     /* s c = sin(theta) / theta */
  real cubic; /* (theta - sin(theta)) / theta^3 */
  real tt;    /* theta^2 */
} half_angle;

/* From theta^2 up to a little above pi^2. With 13/128 near the slope of c where the rounding of t counts most, c = 1 -
 * 13/128 t + t q and ss = g (1 + c) with g = 13/128 - q = (1 - c) / t. What is made of the head is exact and the rest is
 * small, so that hardly more than the last rounding of each is lost. s = 1 + t p counts less, the more so near pi. */
SHARED half_angle half_angle_within_pi(split_square square) {
  half_angle half;
  real t = square.t, high = CHS_HIGH(t);
  real q = CHS_COSINE_LOW(t) + high * CHS_COSINE_HIGH(t), p = CHS_SINC_LOW(t) + high * CHS_SINC_HIGH(t);
  real head = K(1.0) - K(0.1015625) * square.head, rest = t * q - K(0.1015625) * square.rest, more = K(1.0) + head;
  real tp = t * p, g = K(0.1015625) - q;
  half.c = head + rest;
  half.s = K(1.0) + tp;
  half.a = half.c + half.c * tp; /* s c, but s not rounded */
  half.ss = K(0.1015625) * more + (g * rest - q * more);
  half.cubic = g - p * half.c; /* (1 - s c) / t from (1 - c) / t and (1 - s) / t */
  half.tt = t;
  return half;
}

/* Angles above pi, and everything that is not an angle: CHS_OK, CHS_ERR_NAN, _INFINITE or _ANGLE_RANGE. */
SELDOM int FN(chs_p_half_angle_beyond_pi)(const real w[3], half_angle *half);

SHARED int within_pi(split_square square) { return square.t <= CHS_PI_A * CHS_PI_A; }

SHARED int half_angle_of(const real w[3], half_angle *half) {
  split_square square = squared_length(w);
  if (within_pi(square)) {
    *half = half_angle_within_pi(square);
    return CHS_OK;
  }
  half_angle beyond; /* apart, so that the ordinary case stays in registers */
  int status = FN(chs_p_half_angle_beyond_pi)(w, &beyond);
  if (status == CHS_OK) *half = beyond;
  return status;
}

/* sin(theta)/theta, (1 - cos(theta))/theta^2, (theta - sin(theta))/theta^3 and (theta/2) cot(theta/2). */
SHARED real sine_ratio(half_angle h) { return h.a; }
SHARED real cosine_ratio(half_angle h) { return K(2.0) * h.ss; }
SHARED real cubic_ratio(half_angle h) { return h.cubic; }
SHARED real half_cotangent(half_angle h) { return h.c / h.s; }

/* CHS_ERR_NAN, _INFINITE or _ANGLE_RANGE. */
SELDOM int FN(chs_p_why_no_angle)(const real *angles, int n);

/* CHS_OK where all of the angles are within the range, or why not. */
SHARED int angles_status(const real *angles, int n) {
  int within = 1;
  UNROLL for (int i = 0; i < n; i++) within &= ABS(angles[i]) <= ANGLE_MAX; /* false for what is not a number */
  return within ? CHS_OK : FN(chs_p_why_no_angle)(angles, n);
}

typedef struct sine_cosine {
  real sine, cosine;
} sine_cosine;

/* Those of r + rest, which is within a quarter of pi of 0, and as many quarter turns, to 0.55 eps of 1; to 0.75 eps of
 * themselves, if r is that good. Which is which, and its sign, come from tables: cases would be mispredicted. */
SHARED sine_cosine sin_cos_beyond(unsigned turns, real r, real rest) {
  static const real signs[5] = {1, 1, -1, -1, 1};
  const real *sign = signs + (turns & 3);
  real t = r * r, half = K(0.5) * t;
  real s = r + ((r * t) * CHS_QUARTER_SINE(t) + rest * (K(1.0) - half));
  real c = K(1.0) - (half - ((t * t) * CHS_QUARTER_COSINE(t) - r * rest));
  real both[2];
  both[turns & 1] = s;
  both[~turns & 1] = c;
  sine_cosine of_angle = {sign[0] * both[0], sign[1] * both[1]};
  return of_angle;
}

SHARED real quarter_turns_in(real angle) { return (angle * (K(1.0) / CHS_HALF_PI_A) + TO_INTEGER) - TO_INTEGER; }

/* To 0.8 eps of themselves, unless less than 8 eps of the angle: for large angles, and where digits of a sine or cosine
 * near 0 count. Both are NaN where the angle is none or beyond ANGLE_MAX. */
sine_cosine FN(chs_p_sin_cos_to_all_digits)(real angle);

/* To 0.55 eps of 1; NaN as above. */
SHARED sine_cosine sin_cos_of(real angle) {
  if (!(ABS(angle) <= CHS_RIGHT_ANGLE_LIMIT)) return FN(chs_p_sin_cos_to_all_digits)(angle);
  real k = quarter_turns_in(angle), x = angle - k * CHS_RIGHT_ANGLE_A, y = k * CHS_RIGHT_ANGLE_B, r = x - y;
  return sin_cos_beyond((unsigned)(long)k, r, (x - r) - y);
}

/* atan(t)/t - 1 where t^2 = yy/xx is at most 1.1. */
SHARED real arc_ratio_rest(real yy, real xx) {
  real z = yy / (yy + CHS_ARC_SPREAD * xx) + NEGLIGIBLE;
  return z * CHS_ARC_RATIO(z);
}

/* The angle of the point (x, y), x and y >= 0 and not both 0, as base + rest: base is the nearest of 0, pi/4 and pi/2.
 * With t the tangent of rest, low says that base = 0 and t = y / x, and p = atan(t)/t - 1. */
typedef struct arc {
  real base, rest, p;
  int low;
} arc;

SHARED arc arc_of(real y, real x) {
  int low = y <= K(0.5) * x, high = K(0.5) * y >= x;
  real c = high ? K(0.0) : K(1.0), s = low ? K(0.0) : K(1.0), eighths = (s - c) + K(1.0);
  real t = (c * y - s * x) / (c * x + s * y), u = t * t, p = u * CHS_ATAN_REST(u);
  arc a = {eighths * CHS_QUARTER_PI_A, t + (t * p + eighths * CHS_QUARTER_PI_B), p, low};
  return a;
}

/* atan2(y, x) for y >= 0 and any x, not both 0: in [0, pi]. */
real FN(chs_p_angle_of)(real y, real x);

/* The angle base + base_rest + sign atan(sqrt(less / more)), less <= more. */
SHARED real angle_in_sector(real base, real base_rest, real sign, real less, real more) {
  real t = sign * SQRT(less / more);
  return (base + t) + (base_rest + t * arc_ratio_rest(less, more));
}

/* atan2(|y|, x) from yy = |y|^2, which must not be lost if y is not 0; nor may that of x be, if y is 0. By a table, for
 * cases would be mispredicted as often as not. */
SHARED real angle_from_square(real yy, real x) {
  static const real sectors[4][3] = {
      {0, 0, 1}, {CHS_PI_A, CHS_PI_B, -1}, {CHS_HALF_PI_A, CHS_HALF_PI_B, -1}, {CHS_HALF_PI_A, CHS_HALF_PI_B, 1}};
  real xx = x * x, less = yy < xx ? yy : xx, more = yy > xx ? yy : xx;
  const real *sector = sectors[(x < 0) + 2 * (yy > xx)];
  return angle_in_sector(sector[0], sector[1], sector[2], less, more);
}

/* The square of a y that is not 0 is not lost. */
SHARED int safe_square(real yy) { return yy >= UNDERFLOWS * UNDERFLOWS; }

/* The same of a vector y down to the smallest, x and y not both that small. */
real FN(chs_p_angle_of_vector)(const real y[3], real x);

/* atan2(y, x) in [-pi, pi], the sign of y also where y is a zero. */
SHARED real signed_angle_of(real y, real x) {
  real angle = FN(chs_p_angle_of)(ABS(y), x);
  return y < 0 || (y == 0 && K(1.0) / y < 0) ? -angle : angle;
}

#endif
