/* ceres.cpp - rotation.h of Ceres Solver. */
#include <ceres/rotation.h>
#include <ceres/version.h>

#include "../library.hpp"

template <class Real> static void describe_precision(library &ceres) {
  using vector = std::array<Real, 3>;
  using matrix = std::array<Real, 9>;
  add<Real, matrix, vector>(ceres, "so3_exp", [](const vector &w, matrix &R) {
    ceres::AngleAxisToRotationMatrix(w.data(), ceres::RowMajorAdapter3x3(R.data()));
  });
  add<Real, vector, matrix>(ceres, "so3_log", [](const matrix &R, vector &w) {
    ceres::RotationMatrixToAngleAxis(ceres::RowMajorAdapter3x3(R.data()), w.data());
  });
}

extern "C" void describe_library(library &ceres) {
  ceres.name = "Ceres";
  ceres.version = CERES_VERSION_STRING;
  describe_precision<double>(ceres);
  describe_precision<float>(ceres);
}
