/* Vectors of three, 3x3 matrices, norms that neither overflow nor underflow, and what kind of bad number an input
 * holds. */
#ifndef CHASLES_VEC3_H
#define CHASLES_VEC3_H

#include "real.h"
#include <chasles/status.h>

static inline real dot(const real a[3], const real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* c may be a or b. */
static inline void cross(const real a[3], const real b[3], real c[3]) {
  real x = a[1] * b[2] - a[2] * b[1];
  real y = a[2] * b[0] - a[0] * b[2];
  real z = a[0] * b[1] - a[1] * b[0];
  c[0] = x;
  c[1] = y;
  c[2] = z;
}

/* Written out, here and below, because compilers leave a loop of three a loop at -O2. c may be a or b. */
static inline void subtract(const real a[3], const real b[3], real c[3]) {
  c[0] = a[0] - b[0];
  c[1] = a[1] - b[1];
  c[2] = a[2] - b[2];
}

/* a *= x. */
static inline void multiply_by(real x, real a[3]) {
  a[0] *= x;
  a[1] *= x;
  a[2] *= x;
}

/* c += a. */
static inline void add_to(real c[3], const real a[3]) {
  c[0] += a[0];
  c[1] += a[1];
  c[2] += a[2];
}

static inline void copy(const real *from, int n, real *to) {
  for (int i = 0; i < n; i++) to[i] = from[i];
}

/* y = R x, and y = R^T x; y may be x. */
static inline void rotate(const real R[9], const real x[3], real y[3]) {
  real v0 = dot(R, x), v1 = dot(R + 3, x), v2 = dot(R + 6, x);
  y[0] = v0;
  y[1] = v1;
  y[2] = v2;
}

static inline void rotate_back(const real R[9], const real x[3], real y[3]) {
  real v[3];
  for (int i = 0; i < 3; i++) v[i] = R[i] * x[0] + R[3 + i] * x[1] + R[6 + i] * x[2];
  copy(v, 3, y);
}

/* C = A B and B = A^T; the result may overlap the inputs. */
static inline void multiply(const real A[9], const real B[9], real C[9]) {
  real c[9];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) c[3 * i + j] = A[3 * i] * B[j] + A[3 * i + 1] * B[3 + j] + A[3 * i + 2] * B[6 + j];
  copy(c, 9, C);
}

static inline void transpose(const real A[9], real B[9]) {
  real b[9];
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) b[3 * i + j] = A[3 * j + i];
  copy(b, 9, B);
}

static inline real largest(const real *v, int n) {
  real m = 0;
  for (int i = 0; i < n; i++) {
    real x = ABS(v[i]);
    m = x > m ? x : m;
  }
  return m;
}

/* The factor that makes a vector's entries safe to square; dividing by it afterwards is exact. */
static inline real safe_to_square(real largest_entry) {
  return largest_entry < UNDERFLOWS ? ENLARGE : largest_entry > OVERFLOWS ? REDUCE : K(1.0);
}

static inline real norm(const real *v, int n) {
  real scale = safe_to_square(largest(v, n)), sum = 0;
  for (int i = 0; i < n; i++) {
    real x = scale * v[i];
    sum += x * x;
  }
  return SQRT(sum) / scale;
}

/* e = v/|v|, or 0 for a zero vector, to full precision also where v is subnormal or huge. Its zeros are positive. */
static inline void unit(const real v[3], real e[3]) {
  real scale = safe_to_square(largest(v, 3));
  real x[3] = {scale * v[0], scale * v[1], scale * v[2]}, length = SQRT(dot(x, x));
  for (int i = 0; i < 3; i++) e[i] = length > 0 ? x[i] / length + K(0.0) : K(0.0);
}

/* False for NaN and infinities. */
static inline int is_finite(real x) { return ABS(x) <= REAL_MAX; }

/* CHS_OK, CHS_ERR_NAN or CHS_ERR_INFINITE; NaN takes precedence. */
static inline int finiteness(const real *v, int n) {
  int status = CHS_OK;
  for (int i = 0; i < n; i++) {
    if (v[i] != v[i]) return CHS_ERR_NAN;
    if (!is_finite(v[i])) status = CHS_ERR_INFINITE;
  }
  return status;
}

/* By a sum of zeros, of which NaN and infinities make a NaN. */
static inline int all_finite(const real *v, int n) {
  real zero = 0;
  for (int i = 0; i < n; i++) zero += K(0.0) * v[i];
  return zero == 0;
}

/* The answer to a result that came out non-finite: the input's fault or the range's. */
static inline int why_not_finite(const real *input, int n) {
  int status = finiteness(input, n);
  return status == CHS_OK ? CHS_ERR_OVERFLOW : status;
}

#endif
