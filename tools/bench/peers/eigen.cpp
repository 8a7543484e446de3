/* eigen.cpp - Eigen: AngleAxis, Isometry3, umeyama. */
#include <Eigen/SVD>

#include "../eigen_codecs.hpp"
#include "../scenes.hpp"

/* Points, one a column. */
template <class Real, int Points> struct cloud { Eigen::Matrix<Real, 3, Points> points; };

template <class Real, int Points> struct codec<Real, cloud<Real, Points> > {
  static constexpr int size = 3 * Points;
  static void get(const double *flat, cloud<Real, Points> &x) {
    for (int i = 0; i < size; ++i) x.points(i % 3, i / 3) = static_cast<Real>(flat[i]);
  }
};

template <class Real> static void describe_precision(library &eigen) {
  using vector = Eigen::Matrix<Real, 3, 1>;
  using matrix = Eigen::Matrix<Real, 3, 3>;
  using pose = Eigen::Transform<Real, 3, Eigen::Isometry>;
  using axis_angle = Eigen::AngleAxis<Real>;
  using triangle = cloud<Real, 3>;
  using hundred = cloud<Real, scene_points>;

  add<Real, matrix, vector>(eigen, "so3_exp", [](const vector &w, matrix &R) {
    R = axis_angle(w.norm(), w.normalized()).toRotationMatrix();
  });
  add<Real, vector, matrix>(eigen, "so3_log", [](const matrix &R, vector &w) {
    const axis_angle turn(R);
    w = turn.angle() * turn.axis();
  });
  add<Real, matrix, matrix, matrix>(eigen, "so3_multiply",
                                    [](const matrix &A, const matrix &B, matrix &C) { C.noalias() = A * B; });
  add<Real, matrix, matrix>(eigen, "so3_transpose", [](const matrix &A, matrix &B) { B = A.transpose(); });
  add<Real, vector, matrix, vector>(eigen, "so3_apply",
                                    [](const matrix &R, const vector &x, vector &y) { y.noalias() = R * x; });
  add<Real, Real, matrix, matrix>(eigen, "so3_angle", [](const matrix &A, const matrix &B, Real &angle) {
    angle = axis_angle(matrix(A.transpose() * B)).angle();
  });
  add<Real, matrix, matrix>(eigen, "so3_nearest", [](const matrix &M, matrix &R) {
    const Eigen::JacobiSVD<matrix> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Real turned = svd.matrixU().determinant() * svd.matrixV().determinant();
    R = svd.matrixU() * vector(1, 1, turned < 0 ? -1 : 1).asDiagonal() * svd.matrixV().transpose();
  });
  add<Real, pose, matrix, vector>(eigen, "se3_from_parts", [](const matrix &R, const vector &p, pose &T) {
    T.linear() = R;
    T.translation() = p;
    T.makeAffine();
  });
  add<Real, pose, pose, pose>(eigen, "se3_compose", [](const pose &A, const pose &B, pose &C) { C = A * B; });
  add<Real, pose, pose>(eigen, "se3_inverse", [](const pose &A, pose &B) { B = A.inverse(); });
  add<Real, vector, pose, vector>(eigen, "se3_apply", [](const pose &T, const vector &x, vector &y) { y = T * x; });
  add<Real, matrix, Real, Real, Real>(eigen, "tilt_to_rotation", [](Real azimuth, Real tilt, Real torsion, matrix &R) {
    R = axis_angle(azimuth, vector::UnitZ()) * axis_angle(tilt, vector::UnitY()) *
        axis_angle(torsion - azimuth, vector::UnitZ());
  });

  constexpr int behind_the_screw = 8; /* which no library but ours gives */
  for (const char *method :
       {"motion_bottema_roth", "motion_laub_shiflett", "motion_spoor_veldpaus", "motion_angeles", "motion_beggs"}) {
    add<Real, pose, triangle, triangle>(
        eigen, method,
        [](const triangle &before, const triangle &after, pose &T) {
          T.matrix() = Eigen::umeyama(before.points, after.points, false);
        },
        behind_the_screw)
        .remark = "umeyama, the pose without the screw";
  }
  for (const char *method :
       {"pose_bottema_roth", "pose_laub_shiflett", "pose_spoor_veldpaus", "pose_angeles", "pose_beggs"}) {
    add<Real, pose, triangle, triangle>(eigen, method, [](const triangle &before, const triangle &after, pose &T) {
      T.matrix() = Eigen::umeyama(before.points, after.points, false);
    });
  }
  add<Real, pose, hundred, hundred>(eigen, "points_100", [](const hundred &before, const hundred &after, pose &T) {
    T.matrix() = Eigen::umeyama(before.points, after.points, false);
  }).remark = "umeyama";
}

extern "C" void describe_library(library &eigen) {
  eigen.name = "Eigen";
  eigen.version = std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
                  std::to_string(EIGEN_MINOR_VERSION);
  describe_precision<double>(eigen);
  describe_precision<float>(eigen);
}
