/* kdl.cpp - Orocos KDL; double only. Its twists and wrenches have the angular part last. */
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_nr.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/config.h>
#include <kdl/frames.hpp>

#include "../library.hpp"
#include "../scenes.hpp"

template <> struct codec<double, KDL::Vector> {
  static constexpr int size = 3;
  static void get(const double *flat, KDL::Vector &x) { x = KDL::Vector(flat[0], flat[1], flat[2]); }
  static void put(const KDL::Vector &x, double *flat) {
    for (int i = 0; i < 3; ++i) flat[i] = x(i);
  }
};

template <> struct codec<double, KDL::Rotation> {
  static constexpr int size = 9;
  static void get(const double *flat, KDL::Rotation &R) { std::copy(flat, flat + 9, R.data); }
  static void put(const KDL::Rotation &R, double *flat) { std::copy(R.data, R.data + 9, flat); }
};

template <> struct codec<double, KDL::Frame> {
  static constexpr int size = 16;
  static void get(const double *flat, KDL::Frame &T) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) T.M(i, j) = flat[4 * i + j];
      T.p(i) = flat[4 * i + 3];
    }
  }
  static void put(const KDL::Frame &T, double *flat) { put_pose(T.M, T.p, flat); }
};

template <> struct codec<double, KDL::Twist> {
  static constexpr int size = 6;
  static void get(const double *flat, KDL::Twist &V) {
    codec<double, KDL::Vector>::get(flat, V.rot);
    codec<double, KDL::Vector>::get(flat + 3, V.vel);
  }
  static void put(const KDL::Twist &V, double *flat) {
    codec<double, KDL::Vector>::put(V.rot, flat);
    codec<double, KDL::Vector>::put(V.vel, flat + 3);
  }
};

template <> struct codec<double, KDL::Wrench> {
  static constexpr int size = 6;
  static void get(const double *flat, KDL::Wrench &F) {
    codec<double, KDL::Vector>::get(flat, F.torque);
    codec<double, KDL::Vector>::get(flat + 3, F.force);
  }
  static void put(const KDL::Wrench &F, double *flat) {
    codec<double, KDL::Vector>::put(F.torque, flat);
    codec<double, KDL::Vector>::put(F.force, flat + 3);
  }
};

template <> struct codec<double, KDL::JntArray> {
  static constexpr int size = scene_joints;
  static void get(const double *flat, KDL::JntArray &q) {
    q.resize(scene_joints);
    for (int i = 0; i < scene_joints; ++i) q.data[i] = flat[i];
  }
  static void put(const KDL::JntArray &q, double *flat) {
    for (int i = 0; i < scene_joints; ++i) flat[i] = q.data[i];
  }
};

/* KDL's Jacobian gives the velocity of the tool's origin, ours that of the point at the fixed origin. */
struct jacobian_and_pose {
  KDL::Jacobian J = KDL::Jacobian(scene_joints);
  KDL::Frame T;
};
template <> struct codec<double, jacobian_and_pose> {
  static constexpr int size = 36 + 16;
  static void put(const jacobian_and_pose &x, double *flat) {
    for (unsigned i = 0; i < scene_joints; ++i) {
      const KDL::Twist column = x.J.getColumn(i).RefPoint(-x.T.p);
      for (int k = 0; k < 3; ++k) {
        flat[6 * k + static_cast<int>(i)] = column.rot(k);
        flat[6 * (k + 3) + static_cast<int>(i)] = column.vel(k);
      }
    }
    codec<double, KDL::Frame>::put(x.T, flat + 36);
  }
};

/* The arm and its solvers. */
struct arm {
  KDL::Chain chain = make();
  KDL::ChainFkSolverPos_recursive fk{chain};
  KDL::ChainJntToJacSolver jacobian{chain};
  KDL::ChainIkSolverVel_pinv velocity{chain};
  KDL::ChainIkSolverPos_NR newton{chain, fk, velocity, 50, 1e-10};
  KDL::JntArray rates = KDL::JntArray(scene_joints);

  static KDL::Chain make() {
    KDL::Chain chain;
    for (const joint &joint : scene_arm) {
      const double turn = joint.quarter_turns;
      const KDL::Rotation alpha(1, 0, 0, 0, turn == 0, -turn, 0, turn, turn == 0);
      chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame(alpha, KDL::Vector(joint.a, 0, joint.d))));
    }
    return chain;
  }
};

static void describe_arm(library &kdl) {
  using KDL::Frame;
  using KDL::JntArray;
  const auto ur5 = std::make_shared<arm>();
  add<double, Frame, JntArray>(kdl, "ur5_fk", [ur5](const JntArray &q, Frame &T) { ur5->fk.JntToCart(q, T); });
  add<double, jacobian_and_pose, JntArray>(kdl, "ur5_fk_jacobian", [ur5](const JntArray &q, jacobian_and_pose &out) {
    ur5->jacobian.JntToJac(q, out.J);
    ur5->fk.JntToCart(q, out.T);
  });
  add<double, JntArray, Frame, JntArray>(kdl, "ur5_newton_step",
                                         [ur5](const Frame &goal, const JntArray &start, JntArray &q) {
                                           Frame T;
                                           ur5->fk.JntToCart(start, T);
                                           ur5->velocity.CartToJnt(start, KDL::diff(T, goal), ur5->rates);
                                           KDL::Add(start, ur5->rates, q);
                                         });
  add<double, JntArray, Frame, JntArray>(kdl, "ur5_ik", [ur5](const Frame &goal, const JntArray &start, JntArray &q) {
    q = start; /* and with it its size, which the solver asks for */
    ur5->newton.CartToJnt(start, goal, q);
  });
}

extern "C" void describe_library(library &kdl) {
  using KDL::Frame;
  using KDL::Rotation;
  using KDL::Twist;
  using KDL::Vector;
  using KDL::Wrench;
  kdl.name = "KDL";
  kdl.version = KDL_VERSION_STRING;
  add<double, Rotation, Vector>(kdl, "so3_exp", [](const Vector &w, Rotation &R) { R = Rotation::Rot(w, w.Norm()); });
  add<double, Vector, Rotation>(kdl, "so3_log", [](const Rotation &R, Vector &w) { w = R.GetRot(); });
  add<double, Rotation, Rotation, Rotation>(kdl, "so3_multiply",
                                            [](const Rotation &A, const Rotation &B, Rotation &C) { C = A * B; });
  add<double, Rotation, Rotation>(kdl, "so3_transpose", [](const Rotation &A, Rotation &B) { B = A.Inverse(); });
  add<double, Vector, Rotation, Vector>(kdl, "so3_apply",
                                        [](const Rotation &R, const Vector &x, Vector &y) { y = R * x; });
  add<double, double, Rotation, Rotation>(
      kdl, "so3_angle", [](const Rotation &A, const Rotation &B, double &angle) { angle = KDL::diff(A, B).Norm(); });
  add<double, Frame, Rotation, Vector>(kdl, "se3_from_parts",
                                       [](const Rotation &R, const Vector &p, Frame &T) { T = Frame(R, p); });
  add<double, Frame, Frame, Frame>(kdl, "se3_compose", [](const Frame &A, const Frame &B, Frame &C) { C = A * B; });
  add<double, Frame, Frame>(kdl, "se3_inverse", [](const Frame &A, Frame &B) { B = A.Inverse(); });
  add<double, Vector, Frame, Vector>(kdl, "se3_apply", [](const Frame &T, const Vector &x, Vector &y) { y = T * x; });
  add<double, Twist, Frame, Twist>(kdl, "se3_adjoint_twist",
                                   [](const Frame &T, const Twist &V, Twist &U) { U = T * V; });
  add<double, Twist, Frame, Twist>(kdl, "se3_adjoint_inverse_twist",
                                   [](const Frame &T, const Twist &V, Twist &U) { U = T.Inverse(V); });
  add<double, Wrench, Frame, Wrench>(kdl, "se3_adjoint_wrench",
                                     [](const Frame &T, const Wrench &F, Wrench &G) { G = T * F; });
  add<double, Wrench, Frame, Wrench>(kdl, "se3_adjoint_inverse_wrench",
                                     [](const Frame &T, const Wrench &F, Wrench &G) { G = T.Inverse(F); });
  add<double, Rotation, double, double, double>(kdl, "tilt_to_rotation",
                                                [](double azimuth, double tilt, double torsion, Rotation &R) {
                                                  R = Rotation::EulerZYZ(azimuth, tilt, torsion - azimuth);
                                                });
  describe_arm(kdl);
}
