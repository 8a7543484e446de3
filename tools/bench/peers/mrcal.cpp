/* mrcal.cpp - mrcal's poseutils; double only. A pose is R, row-major, and then t. */
extern "C" {
#include <mrcal/poseutils.h>
}

#include "../library.hpp"

using vector = std::array<double, 3>;
using matrix = std::array<double, 9>;

struct pose {
  double Rt[12];
};

template <> struct codec<double, pose> {
  static constexpr int size = 16;
  static void get(const double *flat, pose &T) {
    for (int i = 0; i < 9; ++i) T.Rt[i] = flat[i / 3 * 4 + i % 3];
    for (int i = 0; i < 3; ++i) T.Rt[9 + i] = flat[4 * i + 3];
  }
  static void put(const pose &T, double *flat) {
    put_pose([&](int i, int j) { return T.Rt[3 * i + j]; }, [&](int i) { return T.Rt[9 + i]; }, flat);
  }
};

extern "C" void describe_library(library &mrcal) {
  mrcal.name = "mrcal";
  mrcal.version = BENCH_VERSION;
  add<double, matrix, vector>(mrcal, "so3_exp",
                              [](const vector &w, matrix &R) { mrcal_R_from_r(R.data(), nullptr, w.data()); });
  add<double, vector, matrix>(mrcal, "so3_log",
                              [](const matrix &R, vector &w) { mrcal_r_from_R(w.data(), nullptr, R.data()); });
  add<double, matrix, matrix>(mrcal, "so3_transpose",
                              [](const matrix &A, matrix &B) { mrcal_invert_R(B.data(), A.data()); });
  add<double, vector, matrix, vector>(mrcal, "so3_apply", [](const matrix &R, const vector &x, vector &y) {
    mrcal_rotate_point_R(y.data(), nullptr, nullptr, R.data(), x.data());
  });
  add<double, pose, pose, pose>(mrcal, "se3_compose",
                                [](const pose &A, const pose &B, pose &C) { mrcal_compose_Rt(C.Rt, A.Rt, B.Rt); });
  add<double, pose, pose>(mrcal, "se3_inverse", [](const pose &A, pose &B) { mrcal_invert_Rt(B.Rt, A.Rt); });
  add<double, vector, pose, vector>(mrcal, "se3_apply", [](const pose &T, const vector &x, vector &y) {
    mrcal_transform_point_Rt(y.data(), nullptr, nullptr, T.Rt, x.data());
  });
}
