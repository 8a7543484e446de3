/* mujoco.cpp - MuJoCo's mju_ functions, which turn by quaternions; double only. */
#include <mujoco/mujoco.h>

#include "../library.hpp"

using vector = std::array<double, 3>;
using matrix = std::array<double, 9>;

extern "C" void describe_library(library &mujoco) {
  mujoco.name = "MuJoCo";
  mujoco.version = mj_versionString();
  add<double, matrix, vector>(mujoco, "so3_exp", [](const vector &w, matrix &R) {
    double axis[3] = {w[0], w[1], w[2]}, q[4];
    const double angle = mju_normalize3(axis);
    mju_axisAngle2Quat(q, axis, angle);
    mju_quat2Mat(R.data(), q);
  });
  add<double, vector, matrix>(mujoco, "so3_log", [](const matrix &R, vector &w) {
    double q[4];
    mju_mat2Quat(q, R.data());
    mju_quat2Vel(w.data(), q, 1.0);
  });
  add<double, matrix, matrix, matrix>(mujoco, "so3_multiply", [](const matrix &A, const matrix &B, matrix &C) {
    mju_mulMatMat(C.data(), A.data(), B.data(), 3, 3, 3);
  });
  add<double, matrix, matrix>(mujoco, "so3_transpose",
                              [](const matrix &A, matrix &B) { mju_transpose(B.data(), A.data(), 3, 3); });
  add<double, vector, matrix, vector>(mujoco, "so3_apply", [](const matrix &R, const vector &x, vector &y) {
    mju_mulMatVec3(y.data(), R.data(), x.data());
  });
}
