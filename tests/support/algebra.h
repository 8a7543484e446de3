/* The plain algebra of the tests themselves, in double whatever the precision under test. */
#ifndef CHASLES_TESTS_ALGEBRA_H
#define CHASLES_TESTS_ALGEBRA_H

#include <math.h>

#include "precision.h"

static inline double length_of(const real *v, int n) {
  double most = 0, sum = 0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs((double)v[i]));
  for (int i = 0; i < n && most > 0; i++) sum += pow((double)v[i] / most, 2);
  return most * sqrt(sum);
}

/* |a - b|, n at most 16. */
static inline double distance_of(const real *a, const real *b, int n) {
  real difference[16];
  for (int i = 0; i < n; i++) difference[i] = a[i] - b[i];
  return length_of(difference, n);
}

static inline double dot_of(const real *a, const real *b, int n) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += (double)a[i] * (double)b[i];
  return sum;
}

static inline void cross_of(const real a[3], const real b[3], real c[3]) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = rounded((double)a[j] * (double)b[k] - (double)a[k] * (double)b[j]);
  }
}

/* C = A B for a matrix of n x n and one of n x m. */
static inline void product_of(const real *A, const real *B, int n, int m, real *C) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < m; j++) {
      double sum = 0;
      for (int k = 0; k < n; k++) sum += (double)A[n * i + k] * (double)B[m * k + j];
      C[m * i + j] = rounded(sum);
    }
}

static inline void transpose_of(const real *A, int n, real *B) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) B[n * i + j] = A[n * j + i];
}

static inline void scaled(double factor, const real *v, int n, real *result) {
  for (int i = 0; i < n; i++) result[i] = rounded(factor * (double)v[i]);
}

static inline void set(real *v, real x, real y, real z) {
  v[0] = x;
  v[1] = y;
  v[2] = z;
}

#endif
