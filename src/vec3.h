/* Vectors of three, 3x3 matrices, norms that neither overflow nor underflow, and what kind of bad number an input
 * holds. */
#ifndef CHASLES_VEC3_H
#define CHASLES_VEC3_H

#include "real.h"
#include <chasles/status.h>

#define dot(...) FN(chs_p_dot)(__VA_ARGS__)
#define cross(...) FN(chs_p_cross)(__VA_ARGS__)
#define subtract(...) FN(chs_p_subtract)(__VA_ARGS__)
#define multiply_by(...) FN(chs_p_multiply_by)(__VA_ARGS__)
#define add_to(...) FN(chs_p_add_to)(__VA_ARGS__)
#define copy(...) FN(chs_p_copy)(__VA_ARGS__)
#define copy3(...) FN(chs_p_copy3)(__VA_ARGS__)
#define copy9(...) FN(chs_p_copy9)(__VA_ARGS__)
#define rotate(...) FN(chs_p_rotate)(__VA_ARGS__)
#define rotate_back(...) FN(chs_p_rotate_back)(__VA_ARGS__)
#define multiply(...) FN(chs_p_multiply)(__VA_ARGS__)
#define transpose(...) FN(chs_p_transpose)(__VA_ARGS__)
#define hat(...) FN(chs_p_hat)(__VA_ARGS__)
#define largest(...) FN(chs_p_largest)(__VA_ARGS__)
#define safe_to_square(...) FN(chs_p_safe_to_square)(__VA_ARGS__)
#define norm(...) FN(chs_p_norm)(__VA_ARGS__)
#define unit(...) FN(chs_p_unit)(__VA_ARGS__)
#define is_finite(...) FN(chs_p_is_finite)(__VA_ARGS__)
#define finiteness(...) FN(chs_p_finiteness)(__VA_ARGS__)
#define all_finite(...) FN(chs_p_all_finite)(__VA_ARGS__)
#define finiteness_at_a_glance(...) FN(chs_p_finiteness_at_a_glance)(__VA_ARGS__)
#define why_not_finite(...) FN(chs_p_why_not_finite)(__VA_ARGS__)

SHARED real dot(const real a[3], const real b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* c may be a or b. */
SHARED void cross(const real a[3], const real b[3], real c[3]) {
  real x = a[1] * b[2] - a[2] * b[1];
  real y = a[2] * b[0] - a[0] * b[2];
  real z = a[0] * b[1] - a[1] * b[0];
  c[0] = x;
  c[1] = y;
  c[2] = z;
}

/* Written out, here and below, because compilers leave a loop of three a loop at -O2. c may be a or b. */
SHARED void subtract(const real a[3], const real b[3], real c[3]) {
  c[0] = a[0] - b[0];
  c[1] = a[1] - b[1];
  c[2] = a[2] - b[2];
}

/* a *= x. */
SHARED void multiply_by(real x, real a[3]) {
  a[0] *= x;
  a[1] *= x;
  a[2] *= x;
}

/* c += a. */
SHARED void add_to(real c[3], const real a[3]) {
  c[0] += a[0];
  c[1] += a[1];
  c[2] += a[2];
}

SHARED void copy(const real *from, int n, real *to) {
  for (int i = 0; i < n; i++) to[i] = from[i];
}

/* Of what lies apart or is the same. */
SHARED void copy3(const real a[3], real b[3]) {
  b[0] = a[0];
  b[1] = a[1];
  b[2] = a[2];
}

SHARED void copy9(const real A[9], real B[9]) {
  copy3(A, B);
  copy3(A + 3, B + 3);
  copy3(A + 6, B + 6);
}

/* y = R x, and y = R^T x; y may be x. */
SHARED void rotate(const real R[9], const real x[3], real y[3]) {
  real v0 = dot(R, x), v1 = dot(R + 3, x), v2 = dot(R + 6, x);
  y[0] = v0;
  y[1] = v1;
  y[2] = v2;
}

SHARED void rotate_back(const real R[9], const real x[3], real y[3]) {
  real v0 = R[0] * x[0] + R[3] * x[1] + R[6] * x[2];
  real v1 = R[1] * x[0] + R[4] * x[1] + R[7] * x[2];
  real v2 = R[2] * x[0] + R[5] * x[1] + R[8] * x[2];
  y[0] = v0;
  y[1] = v1;
  y[2] = v2;
}

/* C = A B and B = A^T; the result may overlap the inputs. */
SHARED void multiply(const real A[9], const real B[9], real C[9]) {
  real c[9];
  rotate_back(B, A, c);
  rotate_back(B, A + 3, c + 3);
  rotate_back(B, A + 6, c + 6);
  copy9(c, C);
}

SHARED void transpose(const real A[9], real B[9]) {
  real a0 = A[0], a1 = A[1], a2 = A[2], a3 = A[3], a4 = A[4], a5 = A[5], a6 = A[6], a7 = A[7], a8 = A[8];
  B[0] = a0;
  B[1] = a3;
  B[2] = a6;
  B[3] = a1;
  B[4] = a4;
  B[5] = a7;
  B[6] = a2;
  B[7] = a5;
  B[8] = a8;
}

/* W = [w] */
SHARED void hat(const real w[3], real W[9]) {
  real x = w[0], y = w[1], z = w[2];
  W[0] = W[4] = W[8] = 0;
  W[1] = -z;
  W[2] = y;
  W[3] = z;
  W[5] = -x;
  W[6] = -y;
  W[7] = x;
}

SHARED real largest(const real *v, int n) {
  real m = 0;
  for (int i = 0; i < n; i++) {
    real x = ABS(v[i]);
    m = x > m ? x : m;
  }
  return m;
}

/* The factor that makes a vector's entries safe to square; dividing by it afterwards is exact. */
SHARED real safe_to_square(real largest_entry) {
  return largest_entry < UNDERFLOWS ? ENLARGE : largest_entry > OVERFLOWS ? REDUCE : K(1.0);
}

LARGE real norm(const real *v, int n);

/* e = v/|v|, or 0 for a zero vector, to full precision also where v is subnormal or huge. Its zeros are positive. The
 * result is |v|, with the bits of norm. e may be v. */
LARGE real unit(const real v[3], real e[3]);

/* False for NaN and infinities. */
SHARED int is_finite(real x) { return ABS(x) <= REAL_MAX; }

/* CHS_OK, CHS_ERR_NAN or CHS_ERR_INFINITE; NaN takes precedence. */
LARGE int finiteness(const real *v, int n);

/* By a sum of zeros, of which NaN and infinities make a NaN. */
SHARED int all_finite(const real *v, int n) {
  real zero = 0;
  for (int i = 0; i < n; i++) zero += K(0.0) * v[i];
  return zero == 0;
}

/* finiteness() of what hardly ever is anything but finite. */
SHARED int finiteness_at_a_glance(const real *v, int n) { return all_finite(v, n) ? CHS_OK : finiteness(v, n); }

/* The answer to a result that came out non-finite: the input's fault or the range's. */
LARGE int why_not_finite(const real *input, int n);

#if LARGE_BODIES

LARGE real norm(const real *v, int n) {
  real scale = safe_to_square(largest(v, n)), sum = 0;
  for (int i = 0; i < n; i++) {
    real x = scale * v[i];
    sum += x * x;
  }
  return SQRT(sum) / scale;
}

LARGE real unit(const real v[3], real e[3]) {
  real scale = safe_to_square(largest(v, 3));
  real x[3] = {scale * v[0], scale * v[1], scale * v[2]}, length = SQRT(dot(x, x));
  for (int i = 0; i < 3; i++) e[i] = length > 0 ? x[i] / length + K(0.0) : K(0.0);
  return length / scale;
}

LARGE int finiteness(const real *v, int n) {
  int status = CHS_OK;
  for (int i = 0; i < n; i++) {
    if (v[i] != v[i]) return CHS_ERR_NAN;
    if (!is_finite(v[i])) status = CHS_ERR_INFINITE;
  }
  return status;
}

LARGE int why_not_finite(const real *input, int n) {
  int status = finiteness(input, n);
  return status == CHS_OK ? CHS_ERR_OVERFLOW : status;
}

#endif

#endif
