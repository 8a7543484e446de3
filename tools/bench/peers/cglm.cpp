/* cglm.cpp - cglm; float only, column-major. */
#include <cglm/cglm.h>
#include <cglm/version.h>

#include "../library.hpp"

struct vector {
  mutable vec3 x;
};
struct matrix {
  mutable mat3 M;
};
struct pose {
  mutable mat4 M;
};

template <> struct codec<float, vector> {
  static constexpr int size = 3;
  static void get(const double *flat, vector &v) {
    for (int i = 0; i < 3; ++i) v.x[i] = static_cast<float>(flat[i]);
  }
  static void put(const vector &v, double *flat) {
    for (int i = 0; i < 3; ++i) flat[i] = static_cast<double>(v.x[i]);
  }
};

template <> struct codec<float, matrix> {
  static constexpr int size = 9;
  static void get(const double *flat, matrix &A) {
    for (int i = 0; i < 9; ++i) A.M[i % 3][i / 3] = static_cast<float>(flat[i]);
  }
  static void put(const matrix &A, double *flat) {
    for (int i = 0; i < 9; ++i) flat[i] = static_cast<double>(A.M[i % 3][i / 3]);
  }
};

template <> struct codec<float, pose> {
  static constexpr int size = 16;
  static void get(const double *flat, pose &A) {
    for (int i = 0; i < 12; ++i) A.M[i % 4][i / 4] = static_cast<float>(flat[i]);
    for (int i = 0; i < 4; ++i) A.M[i][3] = i == 3; /* which our functions never read and cglm's do */
  }
  static void put(const pose &A, double *flat) {
    for (int i = 0; i < 16; ++i) flat[i] = static_cast<double>(A.M[i % 4][i / 4]);
  }
};

extern "C" void describe_library(library &cglm) {
  cglm.name = "cglm";
  cglm.version = std::to_string(CGLM_VERSION_MAJOR) + "." + std::to_string(CGLM_VERSION_MINOR) + "." +
                 std::to_string(CGLM_VERSION_PATCH);
  add<float, matrix, vector>(cglm, "so3_exp", [](const vector &w, matrix &R) {
    versor q;
    glm_quatv(q, glm_vec3_norm(w.x), w.x);
    glm_quat_mat3(q, R.M);
  });
  add<float, vector, matrix>(cglm, "so3_log", [](const matrix &R, vector &w) {
    versor q;
    glm_mat3_quat(R.M, q);
    glm_quat_axis(q, w.x);
    glm_vec3_scale(w.x, glm_quat_angle(q), w.x);
  });
  add<float, matrix, matrix, matrix>(cglm, "so3_multiply",
                                     [](const matrix &A, const matrix &B, matrix &C) { glm_mat3_mul(A.M, B.M, C.M); });
  add<float, matrix, matrix>(cglm, "so3_transpose",
                             [](const matrix &A, matrix &B) { glm_mat3_transpose_to(A.M, B.M); });
  add<float, vector, matrix, vector>(cglm, "so3_apply",
                                     [](const matrix &R, const vector &x, vector &y) { glm_mat3_mulv(R.M, x.x, y.x); });
  add<float, pose, pose, pose>(cglm, "se3_compose",
                               [](const pose &A, const pose &B, pose &C) { glm_mul(A.M, B.M, C.M); });
  add<float, pose, pose>(cglm, "se3_inverse", [](const pose &A, pose &B) {
    glm_mat4_copy(A.M, B.M);
    glm_inv_tr(B.M);
  });
  add<float, vector, pose, vector>(
      cglm, "se3_apply", [](const pose &T, const vector &x, vector &y) { glm_mat4_mulv3(T.M, x.x, 1.0F, y.x); });
}
