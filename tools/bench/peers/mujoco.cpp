/* mujoco.cpp - MuJoCo's mju_ functions, which turn by quaternions; double only. */
#include <mujoco/mujoco.h>

#include <string>

#include "../library.hpp"
#include "../scenes.hpp"

using vector = std::array<double, 3>;
using matrix = std::array<double, 9>;

/* The arm as a tree of bodies, the tool as a site. */
struct arm {
  mjModel *model;
  mjData *data;
  arm() {
    std::string xml = "<mujoco><worldbody>";
    std::string place;
    for (const joint &joint : scene_arm) {
      xml += "<body " + place + "><joint axis='0 0 1'/><inertial pos='0 0 0' mass='1' diaginertia='1 1 1'/>";
      place = "pos='" + std::to_string(joint.a) + " 0 " + std::to_string(joint.d) + "' quat='1 " +
              std::to_string(joint.quarter_turns) + " 0 0'";
    }
    xml += "<site " + place + "/>";
    for (int i = 0; i < scene_joints; ++i) xml += "</body>";
    xml += "</worldbody></mujoco>";
    char error[256] = "";
    model = mj_compile(mj_parseXMLString(xml.c_str(), nullptr, error, sizeof error), nullptr);
    data = mj_makeData(model);
  }
};

/* A site's place after the kinematics. */
struct place {
  double x[3];
  double R[9];
};
template <> struct codec<double, place> {
  static constexpr int size = 16;
  static void put(const place &T, double *flat) {
    put_pose([&](int i, int j) { return T.R[3 * i + j]; }, [&](int i) { return T.x[i]; }, flat);
  }
};

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

  using angles = std::array<double, scene_joints>;
  const auto ur5 = std::make_shared<arm>();
  add<double, place, angles>(mujoco, "ur5_fk", [ur5](const angles &q, place &T) {
    mju_copy(ur5->data->qpos, q.data(), scene_joints);
    mj_kinematics(ur5->model, ur5->data);
    mju_copy3(T.x, ur5->data->site_xpos);
    mju_copy(T.R, ur5->data->site_xmat, 9);
  });
}
