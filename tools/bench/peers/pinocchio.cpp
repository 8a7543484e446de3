/* pinocchio.cpp - Pinocchio. Its motions and forces have the linear part first. */
#include <pinocchio/multibody.hpp>
#include <pinocchio/spatial.hpp>

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

extern "C" void describe_library(library &pin) {
  pin.name = "Pinocchio";
  pin.version = PINOCCHIO_VERSION;
  describe_precision<double>(pin);
  describe_precision<float>(pin);
}
