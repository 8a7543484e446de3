#include <chasles/array.h>

/* Ordinary elements go through in blocks, number by number, in loops over the elements of a block without a branch: that
 * is what compilers turn into vector instructions. Where the processor has none, or size counts, one element after the
 * other is faster, smaller, and takes less stack. */
#if !defined(__OPTIMIZE_SIZE__) && (defined(__SSE2__) || defined(_M_X64) || defined(__ARM_NEON) || \
                                    defined(_M_ARM64) || defined(__VSX__) || defined(__riscv_vector))
#define VECTORS 1
#else
#define VECTORS 0
#endif

/* What gcc does only at -O3, or never as long as it thinks that somebody looks at errno or at the flags of floating
 * point, for then it keeps selects apart as branches. Before the headers, so that their functions can be inlined. */
#if VECTORS && defined(__OPTIMIZE__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "no-math-errno")
#endif

#include <chasles/se3.h>
#include <chasles/tilt.h>

#include "pose.h"
#include "rotation.h"

enum { LANES = 16 };

typedef struct block {
  real x[12][LANES];  /* the inputs, then the results */
  real margin[LANES]; /* positive where the results are those of the single function, which answers CHS_OK */
} block;

/* The answer to several elements: the first error, else the first positive status. */
typedef struct answers {
  int *each, worst;
} answers;

static INLINE void note(answers *a, size_t i, int status) {
  if (a->each) a->each[i] = status;
  if (a->worst >= 0 && status != CHS_OK && (status < 0 || a->worst == CHS_OK)) a->worst = status;
}

/* Zeros for what is missing from a full block. */
static INLINE void gather(const real *from, size_t stride, int size, int count, real x[][LANES]) {
  for (int lane = 0; lane < LANES; lane++)
    for (int k = 0; k < size; k++) x[k][lane] = lane < count ? from[(size_t)lane * stride + (size_t)k] : K(0.0);
}

/* The last row of a pose is always the same. */
static INLINE void scatter(real x[][LANES], int size, int lane, real *to) {
  for (int k = 0; k < size; k++) to[k] = k < 12 ? x[k][lane] : k < 15 ? K(0.0) : K(1.0);
}

typedef void kernel(block *b);
typedef int single(const real *in, real *out);

/* Each element by the kernel where it is ordinary, else by the single function. */
static INLINE int for_all(size_t n, const real *x, size_t x_stride, int inputs, real *y, size_t y_stride, int outputs,
                          int *statuses, kernel *ordinary, single *any) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    block b;
    int count = n - i < LANES ? (int)(n - i) : LANES;
    if (VECTORS) {
      gather(x + i * x_stride, x_stride, inputs, count, b.x);
      ordinary(&b);
    }
    for (int lane = 0; lane < count; lane++) {
      size_t at = i + (size_t)lane;
      real *to = y + at * y_stride;
      int status = CHS_OK;
      if (VECTORS && b.margin[lane] > 0)
        scatter(b.x, outputs, lane, to);
      else
        status = any(x + at * x_stride, to);
      note(&all, at, status);
    }
  }
  return all.worst;
}

/* Three numbers of a lane, from number `first`. */
static INLINE void put(block *b, int lane, int first, const real x[3]) {
  b->x[first][lane] = x[0];
  b->x[first + 1][lane] = x[1];
  b->x[first + 2][lane] = x[2];
}

static void so3_exp(block *b) {
  for (int lane = 0; lane < LANES; lane++) {
    real w[3] = {b->x[0][lane], b->x[1][lane], b->x[2][lane]}, R[9];
    half_angle half = half_angle_within_pi(squared_length(w));
    rotation_from_half_angle(w, half, R);
    put(b, lane, 0, R);
    put(b, lane, 3, R + 3);
    put(b, lane, 6, R + 6);
    b->margin[lane] = CHS_PI_A * CHS_PI_A - half.tt;
  }
}

static void se3_exp(block *b) {
  for (int lane = 0; lane < LANES; lane++) {
    real w[3] = {b->x[0][lane], b->x[1][lane], b->x[2][lane]}, R[9];
    real v[3] = {b->x[3][lane], b->x[4][lane], b->x[5][lane]}, p[3];
    half_angle half = half_angle_within_pi(squared_length(w));
    rotation_from_half_angle(w, half, R);
    jacobian_times(w, half, v, p);
    put(b, lane, 0, R);
    b->x[3][lane] = p[0];
    put(b, lane, 4, R + 3);
    b->x[7][lane] = p[1];
    put(b, lane, 8, R + 6);
    b->x[11][lane] = p[2];
    /* A translation beyond the format's range makes a NaN here. */
    b->margin[lane] = CHS_PI_A * CHS_PI_A - half.tt - (K(0.0) * p[0] + K(0.0) * p[1] + K(0.0) * p[2]);
  }
}

static void so3_log(block *b) {
  for (int lane = 0; lane < LANES; lane++) {
    real R[9] = {b->x[0][lane], b->x[1][lane], b->x[2][lane], b->x[3][lane], b->x[4][lane],
                 b->x[5][lane], b->x[6][lane], b->x[7][lane], b->x[8][lane]};
    real w[3], k;
    quaternion q = quaternion_of(R);
    real length = SQRT(dot(q.v, q.v)), off = sum_of_offsets(R), margin = q.w - EPS * length;
    rotation_vector_of(&q, length, w, &k);
    put(b, lane, 0, w);
    b->margin[lane] = off <= (real)CHS_SO3_FAR ? margin : K(0.0);
  }
}

static void se3_log(block *b) {
  for (int lane = 0; lane < LANES; lane++) {
    real R[9] = {b->x[0][lane], b->x[1][lane], b->x[2][lane], b->x[4][lane], b->x[5][lane],
                 b->x[6][lane], b->x[8][lane], b->x[9][lane], b->x[10][lane]};
    real p[3] = {b->x[3][lane], b->x[7][lane], b->x[11][lane]}, w[3], v[3], k;
    quaternion q = quaternion_of(R);
    real length = SQRT(dot(q.v, q.v)), off = sum_of_offsets(R), margin = q.w - EPS * length;
    rotation_vector_of(&q, length, w, &k);
    inverse_jacobian_times(w, k, p, v);
    put(b, lane, 0, w);
    put(b, lane, 3, v);
    margin -= K(0.0) * v[0] + K(0.0) * v[1] + K(0.0) * v[2];
    b->margin[lane] = off <= (real)CHS_SO3_FAR ? margin : K(0.0);
  }
}

int FN(chs_so3_exp_array)(size_t n, const real *w, size_t w_stride, real *R, size_t R_stride, int *statuses) {
  return for_all(n, w, w_stride, 3, R, R_stride, 9, statuses, so3_exp, FN(chs_so3_exp));
}

int FN(chs_se3_exp_array)(size_t n, const real *V, size_t V_stride, real *T, size_t T_stride, int *statuses) {
  return for_all(n, V, V_stride, 6, T, T_stride, 16, statuses, se3_exp, FN(chs_se3_exp));
}

int FN(chs_so3_log_array)(size_t n, const real *R, size_t R_stride, real *w, size_t w_stride, int *statuses) {
  return for_all(n, R, R_stride, 9, w, w_stride, 3, statuses, so3_log, FN(chs_so3_log));
}

int FN(chs_se3_log_array)(size_t n, const real *T, size_t T_stride, real *V, size_t V_stride, int *statuses) {
  return for_all(n, T, T_stride, 12, V, V_stride, 6, statuses, se3_log, FN(chs_se3_log));
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
