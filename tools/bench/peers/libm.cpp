/* libm.cpp - not a library but the yardstick: the textbook's formulas with libm's functions. */
#include <cmath>

#include "../library.hpp"

template <class Real> static void describe_precision(library &libm) {
  using vector = std::array<Real, 3>;
  using matrix = std::array<Real, 9>;
  using pair = std::array<Real, 2>;

  add<Real, matrix, vector>(libm, "so3_exp", [](const vector &w, matrix &R) {
    const Real theta = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    if (theta == 0) {
      R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
      return;
    }
    const Real x = w[0] / theta, y = w[1] / theta, z = w[2] / theta;
    const Real s = std::sin(theta), c = std::cos(theta), v = 1 - c;
    R = {c + x * x * v,     x * y * v - z * s, x * z * v + y * s, x * y * v + z * s, c + y * y * v,
         y * z * v - x * s, x * z * v - y * s, y * z * v + x * s, c + z * z * v};
  }).remark = "Rodrigues";

  add<Real, vector, matrix>(libm, "so3_log", [](const matrix &R, vector &w) {
    const Real theta = std::acos((R[0] + R[4] + R[8] - 1) / 2);
    const Real k = theta == 0 ? Real(0.5) : theta / (2 * std::sin(theta));
    w = {k * (R[7] - R[5]), k * (R[2] - R[6]), k * (R[3] - R[1])};
  }).remark = "arccos of the trace";

  add<Real, Real, matrix, matrix>(libm, "so3_angle", [](const matrix &A, const matrix &B, Real &angle) {
    Real trace = 0;
    for (std::size_t i = 0; i < 9; ++i) trace += A[i] * B[i];
    angle = std::acos((trace - 1) / 2);
  }).remark = "arccos of the trace";

  /* Briot & Bonev, eq. 1 and 2: the angle of the axes, and the difference of the torsions' two cases. */
  add<Real, pair, matrix, matrix>(libm, "tilt_error", [](const matrix &A, const matrix &B, pair &error) {
    error[0] = std::acos(A[2] * B[2] + A[5] * B[5] + A[8] * B[8]);
    matrix R{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) R[3 * i + j] = A[i] * B[j] + A[3 + i] * B[3 + j] + A[6 + i] * B[6 + j];
    error[1] = std::fabs(std::atan2(R[3] - R[1], R[0] + R[4]));
  }).remark = "arccos and arctan";
}

extern "C" void describe_library(library &libm) {
  libm.name = "libm";
  libm.version = "(textbook formulas)";
  describe_precision<double>(libm);
  describe_precision<float>(libm);
}
