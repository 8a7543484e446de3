/* The kernels that stand in for libm: sine and cosine of half an angle, and the angle of a point in the plane. */
#ifndef CHASLES_ANGLE_H
#define CHASLES_ANGLE_H

#include "coefficients.h"
#include "real.h"
#include "vec3.h"
#include <chasles/so3.h>

#ifdef CHS_SINGLE
#define ANGLE_MAX CHS_ANGLE_MAXF
#else
#define ANGLE_MAX CHS_ANGLE_MAX
#endif

/* Half the rotation angle of a rotation vector w, theta = |w|. Where the angle was reduced modulo 2 pi, s and c may
 * both carry the other sign: only s c, s s, c c and c / s are meant to be used. */
typedef struct half_angle {
  real s, s_lo; /* sin(theta/2) / (theta/2), and what rounding took from it */
  real c, c_lo; /* cos(theta/2), likewise */
  real tt;      /* theta^2 */
} half_angle;

/* Both are good for h = x^2 up to a little above (pi/2)^2. */
static inline real sinc_kernel(real h) { return K(1.0) + h * CHS_SINC_REST(h); }

/* cos(x) less its head, 1 - h/2 rounded: half an eps at the end where cos is near 0. */
static inline real cos_rest(real h) {
  real half = K(0.5) * h, head = K(1.0) - half;
  return ((K(1.0) - head) - half) + (h * h) * CHS_COS_REST(h);
}

static inline real cos_kernel(real h) { return (K(1.0) - K(0.5) * h) + cos_rest(h); }

/* (theta - sin theta) / theta^3 for tt = theta^2 up to a little above pi^2. */
static inline real cubic_kernel(real tt) { return CHS_CUBIC(tt); }

/* w.w rounded once for |w| up to 4: the parts on a coarse grid have exact squares with an exact sum. */
static inline real squared_norm(const real w[3]) {
  real x = (w[0] + GRID) - GRID, y = (w[1] + GRID) - GRID, z = (w[2] + GRID) - GRID;
  real rest = (w[0] - x) * (w[0] + x) + (w[1] - y) * (w[1] + y) + (w[2] - z) * (w[2] + z);
  return (x * x + y * y + z * z) + rest;
}

/* Angles above pi, and everything that is not an angle: CHS_OK, CHS_ERR_NAN, _INFINITE or _ANGLE_RANGE. */
int FN(chs_p_half_angle_beyond_pi)(const real w[3], half_angle *half);

static inline int half_angle_of(const real w[3], half_angle *half) {
  real tt = squared_norm(w);
  if (!(tt <= CHS_PI_A * CHS_PI_A)) return FN(chs_p_half_angle_beyond_pi)(w, half);
  real h = K(0.25) * tt, s_rest = h * CHS_SINC_REST(h), c_head = K(1.0) - K(0.5) * h, c_rest = cos_rest(h);
  half->s = K(1.0) + s_rest;
  half->s_lo = (K(1.0) - half->s) + s_rest;
  half->c = c_head + c_rest;
  half->c_lo = (c_head - half->c) + c_rest;
  half->tt = tt;
  return CHS_OK;
}

/* sin and cos of hi + lo, |lo| at most half a unit in the last place of hi, |hi| up to twice CHS_ANGLE_MAX. */
void FN(chs_p_sin_cos)(real hi, real lo, real *sine, real *cosine);

/* 1 - cos(x) and cos(x) from s = sin(x/2) and c = cos(x/2), each from the smaller of the two squares. */
static inline real versine_of(real s, real c) {
  real ss = s * s, cc = c * c;
  return K(2.0) * (cc < ss ? K(1.0) - cc : ss);
}

static inline real cosine_of(real s, real c) {
  real ss = s * s, cc = c * c;
  return cc < ss ? K(2.0) * cc - K(1.0) : K(1.0) - K(2.0) * ss;
}

/* sin(q) and 1 - cos(q), by way of the half angle, which is in the kernels' range for |q| up to pi. False where q is no
 * angle or beyond ANGLE_MAX. */
static inline int sine_and_versine(real q, real *sine, real *versine) {
  real x = K(0.5) * q, s, c;
  if (ABS(q) <= CHS_PI_A) {
    real h = x * x;
    s = x * sinc_kernel(h);
    c = cos_kernel(h);
  } else {
    if (!(ABS(q) <= ANGLE_MAX)) return 0;
    FN(chs_p_sin_cos)(x, 0, &s, &c);
  }
  *sine = K(2.0) * (s * c);
  *versine = versine_of(s, c);
  return 1;
}

/* The angle of the point (x, y), x and y >= 0 and not both 0, as base + rest. With t the tangent of rest, low says
 * that base = 0 and t = y / x, and p = atan(t)/t - 1. */
typedef struct arc {
  real base, rest, p;
  int low;
} arc;

static inline arc arc_of(real y, real x) {
  arc a;
  int low = y <= K(0.5) * x, high = K(0.5) * y >= x;
  real t = (low ? y : high ? -x : y - x) / (low ? x : high ? y : y + x);
  real tail = low ? K(0.0) : high ? CHS_HALF_PI_B : CHS_QUARTER_PI_B;
  real u = t * t;
  a.p = u * CHS_ATAN_REST(u);
  a.base = low ? K(0.0) : high ? CHS_HALF_PI_A : CHS_QUARTER_PI_A;
  a.rest = t + (t * a.p + tail);
  a.low = low;
  return a;
}

/* atan2(y, x) for y >= 0 and any x, not both 0: in [0, pi]. */
real FN(chs_p_angle_of)(real y, real x);

/* atan2(y, x) in [-pi, pi], the sign of y also where y is a zero. */
static inline real signed_angle_of(real y, real x) {
  real angle = FN(chs_p_angle_of)(ABS(y), x);
  return y < 0 || (y == 0 && K(1.0) / y < 0) ? -angle : angle;
}

#endif
