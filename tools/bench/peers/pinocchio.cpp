/* pinocchio.cpp - Pinocchio. Its motions and forces have the linear part first. */
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/spatial.hpp>

#include <Eigen/LU>

#include "../eigen_codecs.hpp"
#include "../scenes.hpp"

template <class Real> struct codec<Real, pinocchio::SE3Tpl<Real> > {
  static constexpr int size = 16;
  static void get(const double *flat, pinocchio::SE3Tpl<Real> &T) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) T.rotation()(i, j) = static_cast<Real>(flat[4 * i + j]);
      T.translation()[i] = static_cast<Real>(flat[4 * i + 3]);
    }
  }
  static void put(const pinocchio::SE3Tpl<Real> &T, double *flat) { put_pose(T.rotation(), T.translation(), flat); }
};

template <class Real, class Six> struct codec_of_six {
  static constexpr int size = 6;
  static void get(const double *flat, Six &x) {
    for (int i = 0; i < 3; ++i) {
      x.angular()[i] = static_cast<Real>(flat[i]);
      x.linear()[i] = static_cast<Real>(flat[3 + i]);
    }
  }
  static void put(const Six &x, double *flat) {
    for (int i = 0; i < 3; ++i) {
      flat[i] = static_cast<double>(x.angular()[i]);
      flat[3 + i] = static_cast<double>(x.linear()[i]);
    }
  }
};
template <class Real>
struct codec<Real, pinocchio::MotionTpl<Real> > : codec_of_six<Real, pinocchio::MotionTpl<Real> > {};
template <class Real>
struct codec<Real, pinocchio::ForceTpl<Real> > : codec_of_six<Real, pinocchio::ForceTpl<Real> > {};

/* A 6x6 matrix in Pinocchio's order of rows and columns. */
template <class Real> struct action { Eigen::Matrix<Real, 6, 6> X; };
template <class Real> struct codec<Real, action<Real> > {
  static constexpr int size = 36;
  static void put(const action<Real> &Ad, double *flat) {
    for (int i = 0; i < 36; ++i) flat[i] = static_cast<double>(Ad.X((i / 6 + 3) % 6, (i % 6 + 3) % 6));
  }
};

template <class Real> static void describe_precision(library &pin) {
  using vector = Eigen::Matrix<Real, 3, 1>;
  using matrix = Eigen::Matrix<Real, 3, 3>;
  using pose = pinocchio::SE3Tpl<Real>;
  using motion = pinocchio::MotionTpl<Real>;
  using force = pinocchio::ForceTpl<Real>;
  add<Real, matrix, vector>(pin, "so3_exp", [](const vector &w, matrix &R) { R = pinocchio::exp3(w); });
  add<Real, vector, matrix>(pin, "so3_log", [](const matrix &R, vector &w) { w = pinocchio::log3(R); });
  add<Real, Real, matrix, matrix>(pin, "so3_angle", [](const matrix &A, const matrix &B, Real &angle) {
    pinocchio::log3(matrix(A.transpose() * B), angle);
  });
  add<Real, matrix, vector>(pin, "so3_right_jacobian", [](const vector &w, matrix &J) { pinocchio::Jexp3(w, J); });
  add<Real, matrix, vector>(pin, "so3_right_jacobian_inverse",
                            [](const vector &w, matrix &J) { pinocchio::Jlog3(w.norm(), w, J); });
  add<Real, pose, pose, pose>(pin, "se3_compose", [](const pose &A, const pose &B, pose &C) { C = A * B; });
  add<Real, pose, pose>(pin, "se3_inverse", [](const pose &A, pose &B) { B = A.inverse(); });
  add<Real, vector, pose, vector>(pin, "se3_apply", [](const pose &T, const vector &x, vector &y) { y = T.act(x); });
  add<Real, pose, motion>(pin, "se3_exp", [](const motion &V, pose &T) { T = pinocchio::exp6(V); });
  add<Real, motion, pose>(pin, "se3_log", [](const pose &T, motion &V) { V = pinocchio::log6(T); });
  add<Real, action<Real>, pose>(pin, "se3_adjoint", [](const pose &T, action<Real> &Ad) { Ad.X = T.toActionMatrix(); });
  add<Real, action<Real>, pose>(pin, "se3_adjoint_inverse",
                                [](const pose &T, action<Real> &Ad) { Ad.X = T.toActionMatrixInverse(); });
  add<Real, motion, pose, motion>(pin, "se3_adjoint_twist",
                                  [](const pose &T, const motion &V, motion &U) { U = T.act(V); });
  add<Real, motion, pose, motion>(pin, "se3_adjoint_inverse_twist",
                                  [](const pose &T, const motion &V, motion &U) { U = T.actInv(V); });
  add<Real, force, pose, force>(pin, "se3_adjoint_wrench",
                                [](const pose &T, const force &F, force &G) { G = T.act(F); });
  add<Real, force, pose, force>(pin, "se3_adjoint_inverse_wrench",
                                [](const pose &T, const force &F, force &G) { G = T.actInv(F); });
}

/* The arm, with what Pinocchio computes in. */
template <class Real> struct arm {
  using pose = pinocchio::SE3Tpl<Real>;
  pinocchio::ModelTpl<Real> model;
  pinocchio::DataTpl<Real> data;
  pose tool;

  arm() {
    pose next = pose::Identity();
    pinocchio::JointIndex parent = 0;
    for (const joint &joint : scene_arm) {
      parent = model.addJoint(parent, pinocchio::JointModelRevoluteTpl<Real, 0, 2>(), next,
                              "joint " + std::to_string(parent));
      next.translation() << static_cast<Real>(joint.a), 0, static_cast<Real>(joint.d);
      next.rotation() << 1, 0, 0, 0, joint.quarter_turns == 0, -joint.quarter_turns, 0, joint.quarter_turns,
          joint.quarter_turns == 0;
    }
    tool = next;
    data = pinocchio::DataTpl<Real>(model);
  }
};

template <class Real> struct jacobian_and_pose {
  Eigen::Matrix<Real, 6, scene_joints> J;
  pinocchio::SE3Tpl<Real> T;
};
template <class Real> struct codec<Real, jacobian_and_pose<Real> > {
  static constexpr int size = 36 + 16;
  static void put(const jacobian_and_pose<Real> &x, double *flat) {
    for (int i = 0; i < 36; ++i) flat[i] = static_cast<double>(x.J((i / 6 + 3) % 6, i % 6));
    codec<Real, pinocchio::SE3Tpl<Real> >::put(x.T, flat + 36);
  }
};

template <class Real> static void describe_arm(library &pin) {
  using pose = pinocchio::SE3Tpl<Real>;
  using angles = Eigen::Matrix<Real, scene_joints, 1>;
  using any_angles = typename pinocchio::ModelTpl<Real>::ConfigVectorType;
  using jacobian = Eigen::Matrix<Real, 6, scene_joints>;
  const auto ur5 = std::make_shared<arm<Real> >();
  /* One step of Newton's, as its users write it: the error in the tool's frame, the Jacobian there, a 6x6 solution. */
  const auto step = [ur5](const pose &goal, any_angles &q) {
    jacobian J;
    pinocchio::computeJointJacobians(ur5->model, ur5->data, q);
    const pose T = ur5->data.oMi[scene_joints] * ur5->tool;
    const Eigen::Matrix<Real, 6, 1> error = pinocchio::log6(T.actInv(goal)).toVector();
    J = T.toActionMatrixInverse() * ur5->data.J;
    q += J.partialPivLu().solve(error);
    return error.norm();
  };
  add<Real, pose, angles>(pin, "ur5_fk", [ur5](const angles &q, pose &T) {
    pinocchio::forwardKinematics(ur5->model, ur5->data, q);
    T = ur5->data.oMi[scene_joints] * ur5->tool;
  });
  add<Real, jacobian_and_pose<Real>, angles>(pin, "ur5_fk_jacobian",
                                             [ur5](const angles &q, jacobian_and_pose<Real> &out) {
                                               pinocchio::computeJointJacobians(ur5->model, ur5->data, q);
                                               out.J = ur5->data.J;
                                               out.T = ur5->data.oMi[scene_joints] * ur5->tool;
                                             });
  for (const char *name : {"ur5_newton_step", "ur5_ik_step"}) {
    add<Real, angles, pose, angles>(pin, name, [step](const pose &goal, const angles &start, angles &end) {
      any_angles q = start;
      step(goal, q);
      end = q;
    });
  }
  add<Real, angles, pose, angles>(pin, "ur5_ik", [step](const pose &goal, const angles &start, angles &end) {
    constexpr Real enough = std::is_same_v<Real, float> ? Real(1e-5) : Real(1e-10);
    any_angles q = start;
    for (int i = 0; i < 50 && step(goal, q) > enough; ++i) continue;
    end = q;
  });
}

extern "C" void describe_library(library &pin) {
  pin.name = "Pinocchio";
  pin.version = PINOCCHIO_VERSION;
  describe_precision<double>(pin);
  describe_precision<float>(pin);
  describe_arm<double>(pin);
}
