#include <chasles/array.h>

#include <chasles/se3.h>
#include <chasles/tilt.h>

#include "pose.h"
#include "rotation.h"

enum { LANES = 16 };

/* The answer to several elements: the first error, else the first positive status. */
typedef struct answers {
  int *each, worst;
} answers;

static void note(answers *a, size_t i, int status) {
  if (a->each) a->each[i] = status;
  if (a->worst >= 0 && status != CHS_OK && (status < 0 || a->worst == CHS_OK)) a->worst = status;
}

static int lanes_left(size_t n, size_t i) { return n - i < LANES ? (int)(n - i) : LANES; }

/* in[k][lane] = number k of element `lane`; zeros for what is missing from a full block. */
static void gather(const real *from, size_t stride, int count, int size, real in[][LANES]) {
  for (int lane = 0; lane < LANES; lane++)
    for (int k = 0; k < size; k++) in[k][lane] = lane < count ? from[(size_t)lane * stride + (size_t)k] : K(0.0);
}

int FN(chs_so3_exp_array)(size_t n, const real *w, size_t w_stride, real *R, size_t R_stride, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    real in[3][LANES], out[9][LANES], *tt = in[0]; /* that of a lane once its input is used */
    int count = lanes_left(n, i);
    gather(w + i * w_stride, w_stride, count, 3, in);
    for (int lane = 0; lane < LANES; lane++) {
      real x[3] = {in[0][lane], in[1][lane], in[2][lane]}, r[9];
      half_angle half = half_angle_within_pi(squared_length(x));
      rotation_from_half_angle(x, half, r);
      out[0][lane] = r[0];
      out[1][lane] = r[1];
      out[2][lane] = r[2];
      out[3][lane] = r[3];
      out[4][lane] = r[4];
      out[5][lane] = r[5];
      out[6][lane] = r[6];
      out[7][lane] = r[7];
      out[8][lane] = r[8];
      tt[lane] = half.tt;
    }
    for (int lane = 0; lane < count; lane++) {
      real *to = R + (i + (size_t)lane) * R_stride;
      if (tt[lane] <= CHS_PI_A * CHS_PI_A) {
        for (int k = 0; k < 9; k++) to[k] = out[k][lane];
        note(&all, i + (size_t)lane, CHS_OK);
      } else
        note(&all, i + (size_t)lane, FN(chs_so3_exp)(w + (i + (size_t)lane) * w_stride, to));
    }
  }
  return all.worst;
}

int FN(chs_se3_exp_array)(size_t n, const real *V, size_t V_stride, real *T, size_t T_stride, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    real in[6][LANES], out[12][LANES], *tt = in[0];
    int count = lanes_left(n, i);
    gather(V + i * V_stride, V_stride, count, 6, in);
    for (int lane = 0; lane < LANES; lane++) {
      real w[3] = {in[0][lane], in[1][lane], in[2][lane]}, v[3] = {in[3][lane], in[4][lane], in[5][lane]}, r[9], p[3];
      half_angle half = half_angle_within_pi(squared_length(w));
      rotation_from_half_angle(w, half, r);
      jacobian_times(w, half, v, p);
      out[0][lane] = r[0];
      out[1][lane] = r[1];
      out[2][lane] = r[2];
      out[3][lane] = p[0];
      out[4][lane] = r[3];
      out[5][lane] = r[4];
      out[6][lane] = r[5];
      out[7][lane] = p[1];
      out[8][lane] = r[6];
      out[9][lane] = r[7];
      out[10][lane] = r[8];
      out[11][lane] = p[2];
      /* A translation beyond the format's range makes a NaN here, which is not within pi. */
      tt[lane] = half.tt + (K(0.0) * p[0] + K(0.0) * p[1] + K(0.0) * p[2]);
    }
    for (int lane = 0; lane < count; lane++) {
      real *to = T + (i + (size_t)lane) * T_stride;
      if (tt[lane] <= CHS_PI_A * CHS_PI_A) {
        for (int k = 0; k < 12; k++) to[k] = out[k][lane];
        to[12] = to[13] = to[14] = 0;
        to[15] = 1;
        note(&all, i + (size_t)lane, CHS_OK);
      } else
        note(&all, i + (size_t)lane, FN(chs_se3_exp)(V + (i + (size_t)lane) * V_stride, to));
    }
  }
  return all.worst;
}

int FN(chs_so3_log_array)(size_t n, const real *R, size_t R_stride, real *w, size_t w_stride, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i++) note(&all, i, FN(chs_so3_log)(R + i * R_stride, w + i * w_stride));
  return all.worst;
}

int FN(chs_se3_log_array)(size_t n, const real *T, size_t T_stride, real *V, size_t V_stride, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i++) note(&all, i, FN(chs_se3_log)(T + i * T_stride, V + i * V_stride));
  return all.worst;
}

void FN(chs_se3_compose_array)(size_t n, const real *A, size_t A_stride, const real *B, size_t B_stride, real *C,
                               size_t C_stride) {
  for (size_t i = 0; i < n; i++) FN(chs_se3_compose)(A + i * A_stride, B + i * B_stride, C + i * C_stride);
}

static inline void move_points(size_t n, const real pose[12], const real *x, size_t x_stride, real *y,
                               size_t y_stride) {
  for (size_t i = 0; i < n; i++) transform(pose, x + i * x_stride, y + i * y_stride);
}

void FN(chs_se3_apply_array)(size_t n, const real *T, size_t T_stride, const real *x, size_t x_stride, real *y,
                             size_t y_stride) {
  real pose[12]; /* one for all stays in registers, where y cannot reach it */
  if (n > 0) copy(T, 12, pose);
  if (T_stride != 0)
    for (size_t i = 0; i < n; i++) transform(T + i * T_stride, x + i * x_stride, y + i * y_stride);
  else if (x_stride == 3 && y_stride == 3)
    move_points(n, pose, x, 3, y, 3); /* which compilers turn into vector instructions */
  else
    move_points(n, pose, x, x_stride, y, y_stride);
}

int FN(chs_tilt_error_array)(size_t n, const real *nominal, size_t nominal_stride, const real *actual,
                             size_t actual_stride, real *alpha, real *beta, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i++)
    note(&all, i, FN(chs_tilt_error)(nominal + i * nominal_stride, actual + i * actual_stride, alpha + i, beta + i));
  return all.worst;
}
