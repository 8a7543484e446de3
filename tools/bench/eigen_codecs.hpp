/* eigen_codecs.hpp - Eigen's types from and to flat arrays, for Eigen itself and for libraries that build on it. */
#ifndef EIGEN_CODECS_HPP
#define EIGEN_CODECS_HPP

#include <Eigen/Geometry>

#include "library.hpp"

/* Matrices and vectors, row-major in the flat array whatever they are in memory. */
template <class Real, int Rows, int Columns, int Options>
struct codec<Real, Eigen::Matrix<Real, Rows, Columns, Options> > {
  using matrix = Eigen::Matrix<Real, Rows, Columns, Options>;
  static constexpr int size = Rows * Columns;
  static void get(const double *flat, matrix &M) {
    for (int i = 0; i < size; ++i) M(i / Columns, i % Columns) = static_cast<Real>(flat[i]);
  }
  static void put(const matrix &M, double *flat) {
    for (int i = 0; i < size; ++i) flat[i] = static_cast<double>(M(i / Columns, i % Columns));
  }
};

template <class Real> struct codec<Real, Eigen::Transform<Real, 3, Eigen::Isometry> > {
  using pose = Eigen::Transform<Real, 3, Eigen::Isometry>;
  static constexpr int size = 16;
  static void get(const double *flat, pose &T) {
    codec<Real, Eigen::Matrix<Real, 4, 4> >::get(flat, T.matrix());
    T.makeAffine();
  }
  static void put(const pose &T, double *flat) { codec<Real, Eigen::Matrix<Real, 4, 4> >::put(T.matrix(), flat); }
};

#endif
