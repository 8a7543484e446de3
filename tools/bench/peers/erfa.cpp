/* erfa.cpp - ERFA's vector and matrix functions; double only. Its rotation vectors turn the frame, not the body, so
 * that its matrices are the transposes of ours; its arguments are not const.
 */
#include <erfa.h>
#include <erfaextra.h>
#include <erfam.h>

#include "../library.hpp"

struct vector {
  mutable double x[3];
};
struct matrix {
  mutable double M[3][3];
};
struct transposed {
  mutable double M[3][3];
};

template <> struct codec<double, vector> {
  static constexpr int size = 3;
  static void get(const double *flat, vector &v) {
    for (int i = 0; i < 3; ++i) v.x[i] = flat[i];
  }
  static void put(const vector &v, double *flat) {
    for (int i = 0; i < 3; ++i) flat[i] = v.x[i];
  }
};

template <> struct codec<double, matrix> {
  static constexpr int size = 9;
  static void get(const double *flat, matrix &A) {
    for (int i = 0; i < 9; ++i) A.M[i / 3][i % 3] = flat[i];
  }
  static void put(const matrix &A, double *flat) {
    for (int i = 0; i < 9; ++i) flat[i] = A.M[i / 3][i % 3];
  }
};

template <> struct codec<double, transposed> {
  static constexpr int size = 9;
  static void get(const double *flat, transposed &A) {
    for (int i = 0; i < 9; ++i) A.M[i % 3][i / 3] = flat[i];
  }
  static void put(const transposed &A, double *flat) {
    for (int i = 0; i < 9; ++i) flat[i] = A.M[i % 3][i / 3];
  }
};

extern "C" void describe_library(library &erfa) {
  erfa.name = "ERFA";
  erfa.version = eraVersion();
  add<double, transposed, vector>(erfa, "so3_exp", [](const vector &w, transposed &R) { eraRv2m(w.x, R.M); });
  add<double, vector, transposed>(erfa, "so3_log", [](const transposed &R, vector &w) { eraRm2v(R.M, w.x); });
  add<double, matrix, matrix, matrix>(erfa, "so3_multiply",
                                      [](const matrix &A, const matrix &B, matrix &C) { eraRxr(A.M, B.M, C.M); });
  add<double, matrix, matrix>(erfa, "so3_transpose", [](const matrix &A, matrix &B) { eraTr(A.M, B.M); });
  add<double, vector, matrix, vector>(erfa, "so3_apply",
                                      [](const matrix &R, const vector &x, vector &y) { eraRxp(R.M, x.x, y.x); });
}
