#include <chasles/array.h>

/* Ordinary elements go through in blocks, number by number, in loops over the elements of a block without a branch: that
 * is what compilers turn into vector instructions. Where the processor has none, or size counts, one element after the
 * other is faster, smaller, and takes less stack. */
#include "vectors.h"

/* What gcc does only at -O3, or never as long as it thinks that somebody looks at errno or at the flags of floating
 * point, for then it keeps selects apart as branches. Before the headers, so that their functions can be inlined. */
#if VECTORS && defined(__OPTIMIZE__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "no-math-errno")
#endif

#include <chasles/motion.h>
#include <chasles/se3.h>
#include <chasles/tilt.h>

#include "pose.h"
#include "tilt_private.h"
#include "triangles.h"

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

/* Numbers of an element that are stored at once: as many as a vector holds. clang leaves nothing of rows and their
 * copies where it has AVX, and there is quicker one by one. */
#if defined(__clang__) && defined(__AVX__)
enum { WIDE = 1 };
#elif defined(CHS_SINGLE) || defined(__AVX__)
enum { WIDE = 4 };
#else
enum { WIDE = 2 };
#endif

/* So many columns of a full block to where they belong. Compilers make the first loop shuffles of vectors and the second
 * copies. No arithmetic beside them: gcc fuses a*b -+ c where results that lie side by side are stored together. */
static APART void scatter_some(real x[restrict][LANES], real *restrict to, size_t stride) {
  real rows[LANES][WIDE];
  for (int lane = 0; lane < LANES; lane++)
    for (int j = 0; j < WIDE; j++) rows[lane][j] = x[j][lane];
  for (int lane = 0; lane < LANES; lane++) {
    real *element = to + (size_t)lane * stride;
    OVER_ROW
    for (int j = 0; j < WIDE; j++) element[j] = rows[lane][j];
  }
}

static INLINE void scatter_all(real x[][LANES], int size, real *to, size_t stride) {
  static const real last[4] = {0, 0, 0, 1};
  int columns = size < 12 ? size : 12, k = 0;
  for (; WIDE > 1 && k + WIDE <= columns; k += WIDE) scatter_some(x + k, to + k, stride);
  for (int lane = 0; lane < LANES; lane++) {
    real *element = to + (size_t)lane * stride;
    for (int rest = k; rest < columns; rest++) element[rest] = x[rest][lane];
    OVER_ROW
    for (int j = 0; j < size - 12; j++) element[12 + j] = last[j];
  }
}

static INLINE int lanes_left(size_t n, size_t i) { return n - i < LANES ? (int)(n - i) : LANES; }

typedef int single(const real *in, real *out);

/* What a function gets and gives. */
typedef struct arrays {
  const real *x;
  size_t x_stride;
  real *y;
  size_t y_stride;
  int outputs;
} arrays;

static INLINE int all_ordinary(const real margin[LANES]) {
  int ordinary_lanes = 0;
  for (int lane = 0; lane < LANES; lane++) ordinary_lanes += margin[lane] > 0;
  return ordinary_lanes == LANES;
}

/* What a block answers where it is ordinary, else what the single function does. */
static INLINE void store(block *b, size_t i, int count, const arrays *of, single *any, answers *all) {
  if (VECTORS && count == LANES && all_ordinary(b->margin)) {
    scatter_all(b->x, of->outputs, of->y + i * of->y_stride, of->y_stride);
    if (all->each)
      for (int lane = 0; lane < LANES; lane++) all->each[i + (size_t)lane] = CHS_OK;
    return;
  }
  for (int lane = 0; lane < count; lane++) {
    size_t at = i + (size_t)lane;
    real *to = of->y + at * of->y_stride;
    int status = CHS_OK;
    if (VECTORS && b->margin[lane] > 0)
      scatter(b->x, of->outputs, lane, to);
    else
      status = any(of->x + at * of->x_stride, to);
    note(all, at, status);
  }
}

/* Reads so many elements and answers them, with a margin each. */
typedef void kernel(const real *x, size_t stride, int count, block *b);

static INLINE int for_all(size_t n, const arrays *of, int *statuses, kernel *ordinarily, single *any) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    block b;
    int count = lanes_left(n, i);
    if (VECTORS) ordinarily(of->x + i * of->x_stride, of->x_stride, count, &b);
    store(&b, i, count, of, any, &all);
  }
  return all.worst;
}

/* Three numbers of a lane, from number `first`. */
static INLINE void get(real x[][LANES], int lane, int first, real v[3]) {
  v[0] = x[first][lane];
  v[1] = x[first + 1][lane];
  v[2] = x[first + 2][lane];
}

static INLINE void put(const real v[3], int lane, int first, real x[][LANES]) {
  x[first][lane] = v[0];
  x[first + 1][lane] = v[1];
  x[first + 2][lane] = v[2];
}

/* Nine numbers in rows of three, which start so far apart: 3 in a rotation, 4 in a pose. */
static INLINE void get_rows(real x[][LANES], int lane, int apart, real R[9]) {
  get(x, lane, 0, R);
  get(x, lane, apart, R + 3);
  get(x, lane, 2 * apart, R + 6);
}

static INLINE void put_rows(const real R[9], int lane, int apart, real x[][LANES]) {
  put(R, lane, 0, x);
  put(R + 3, lane, apart, x);
  put(R + 6, lane, 2 * apart, x);
}

/* 0, or NaN where a number is not finite. */
static INLINE real nothing(const real v[3]) { return K(0.0) * v[0] + K(0.0) * v[1] + K(0.0) * v[2]; }

/* gcc puts numbers that lie apart into vectors one by one, which is quicker than to copy them to columns and to wait for
 * those; clang has instructions gather them, which is slower. So exponentials read elements as they lie, or columns. */
#if defined(__GNUC__) && !defined(__clang__)
enum { FROM_ELEMENTS = 1 };
#else
enum { FROM_ELEMENTS = 0 };
#endif

static INLINE void get_from(const real *x, size_t stride, int lane, int first, real v[3]) {
  const real *from = FROM_ELEMENTS ? x + (size_t)lane * stride + first : x + first * LANES + lane;
  const int apart = FROM_ELEMENTS ? 1 : LANES;
  v[0] = from[0];
  v[1] = from[apart];
  v[2] = from[2 * apart];
}

static APART void so3_exp(const real *restrict x, size_t stride, real y[restrict][LANES], real margin[restrict]) {
  for (int lane = 0; lane < LANES; lane++) {
    real w[3], R[9];
    get_from(x, stride, lane, 0, w);
    half_angle half = half_angle_within_pi(squared_length(w));
    rotation_from_half_angle(w, half, R);
    put_rows(R, lane, 3, y);
    margin[lane] = CHS_PI_A * CHS_PI_A - half.tt;
  }
}

static APART void se3_exp(const real *restrict x, size_t stride, real y[restrict][LANES], real margin[restrict]) {
  for (int lane = 0; lane < LANES; lane++) {
    real w[3], v[3], R[9], p[3];
    get_from(x, stride, lane, 0, w);
    get_from(x, stride, lane, 3, v);
    half_angle half = half_angle_within_pi(squared_length(w));
    rotation_from_half_angle(w, half, R);
    jacobian_times(w, half, v, p);
    put_rows(R, lane, 4, y);
    y[3][lane] = p[0];
    y[7][lane] = p[1];
    y[11][lane] = p[2];
    margin[lane] = (CHS_PI_A * CHS_PI_A - half.tt) + nothing(p);
  }
}

/* The lanes are those of x, whose elements are so far apart if there are elements. */
typedef void exponential(const real *restrict x, size_t stride, real y[restrict][LANES], real margin[restrict]);

/* A block that is not full, as elements and with zeros for what is missing. */
static INLINE void fill_up(const real *from, size_t stride, int size, int count, real *elements) {
  for (int lane = 0; lane < LANES; lane++)
    for (int k = 0; k < size; k++)
      elements[lane * size + k] = lane < count ? from[(size_t)lane * stride + (size_t)k] : K(0.0);
}

static APART void exp_block(const real *x, size_t stride, int inputs, int count, exponential *ordinarily, block *b) {
  real copies[6][LANES];
  if (!FROM_ELEMENTS)
    gather(x, stride, inputs, count, copies);
  else if (count < LANES)
    fill_up(x, stride, inputs, count, copies[0]);
  if (FROM_ELEMENTS && count == LANES)
    ordinarily(x, stride, b->x, b->margin);
  else
    ordinarily(copies[0], (size_t)inputs, b->x, b->margin);
}

static void so3_exps(const real *x, size_t stride, int count, block *b) { exp_block(x, stride, 3, count, so3_exp, b); }

static void se3_exps(const real *x, size_t stride, int count, block *b) { exp_block(x, stride, 6, count, se3_exp, b); }

/* What angle_from_square in angle.h answers, bit for bit, by selects. */
static INLINE real angle_by_selects(real yy, real x) {
  real xx = x * x, less = yy > xx ? xx : yy, more = yy > xx ? yy : xx;
  real base = x < 0 ? CHS_PI_A : K(0.0), rest = x < 0 ? CHS_PI_B : K(0.0), sign = x < 0 ? K(-1.0) : K(1.0);
  base = yy > xx ? CHS_HALF_PI_A : base;
  rest = yy > xx ? CHS_HALF_PI_B : rest;
  sign = yy > xx ? -sign : sign;
  return angle_in_sector(base, rest, sign, less, more);
}

/* What quaternion_of in rotation.h reads, bit for bit by selects, each by a comparison of its own because gcc makes no
 * vectors of a condition that several share. */
static INLINE quaternion quaternion_by_selects(const real R[9]) {
  real trace = (R[0] + R[4]) + R[8], of_w = (K(1.0) + R[0]) + (R[4] + R[8]), x_or_y = R[0] > R[4] ? R[0] : R[4];
  real x = R[7] - R[5], y = R[2] - R[6], z = R[3] - R[1], most = R[8] > x_or_y ? R[8] : x_or_y;
  quaternion q = axis_by_selects(R);
  real sign = q.w < 0 ? K(-1.0) : K(1.0), size = ABS(q.w);
  q.v[0] = trace >= most ? x : sign * q.v[0];
  q.v[1] = trace >= most ? y : sign * q.v[1];
  q.v[2] = trace >= most ? z : sign * q.v[2];
  q.w = trace >= most ? of_w : size;
  return q;
}

/* What logarithm in rotation.h answers to a rotation. The result is positive where the answer is CHS_OK, if R is a
 * rotation. */
static INLINE real logarithm_by_selects(const real R[9], real w[3]) {
  quaternion q = axis_by_selects(R);
  real x = R[7] - R[5], y = R[2] - R[6], z = R[3] - R[1], trace = (R[0] + R[4]) + R[8];
  real sign = q.w < 0 ? K(-1.0) : K(1.0), size = ABS(q.w);
  real nn = q.v[0] * q.v[0] + (q.v[1] * q.v[1] + q.v[2] * q.v[2]), n = SQRT(nn);
  real near_m = turn_near(trace), far_m = sign * turn_far(nn, n, size);
  real part = sine_decides(trace) ? K(0.5) : sign, m = sine_decides(trace) ? near_m : far_m;
  q.v[0] = sine_decides(trace) ? x : q.v[0];
  q.v[1] = sine_decides(trace) ? y : q.v[1];
  q.v[2] = sine_decides(trace) ? z : q.v[2];
  along(q.v, part, m, w);
  return sine_decides(trace) ? K(1.0) : size - EPS * n;
}

/* The logarithm of what may be a rotation; positive where it is one, and not beside a half-turn. */
static INLINE real log_of(const real R[9], real w[3]) {
  real margin = logarithm_by_selects(R, w);
  return is_rotation(R) ? margin : K(0.0);
}

static void so3_logs(const real *x, size_t stride, int count, block *b) {
  gather(x, stride, 9, count, b->x);
  for (int lane = 0; lane < LANES; lane++) {
    real R[9], w[3];
    get_rows(b->x, lane, 3, R);
    b->margin[lane] = log_of(R, w);
    put(w, lane, 0, b->x);
  }
}

static void se3_logs(const real *x, size_t stride, int count, block *b) {
  gather(x, stride, 12, count, b->x);
  for (int lane = 0; lane < LANES; lane++) {
    real R[9], p[3] = {b->x[3][lane], b->x[7][lane], b->x[11][lane]}, w[3], v[3];
    get_rows(b->x, lane, 4, R);
    real margin = log_of(R, w);
    inverse_jacobian_times(w, p, v);
    put(w, lane, 0, b->x);
    put(v, lane, 3, b->x);
    b->margin[lane] = margin + nothing(v);
  }
}

int FN(chs_so3_exp_array)(size_t n, const real *w, size_t w_stride, real *R, size_t R_stride, int *statuses) {
  const arrays of = {w, w_stride, R, R_stride, 9};
  return for_all(n, &of, statuses, so3_exps, FN(chs_so3_exp));
}

int FN(chs_se3_exp_array)(size_t n, const real *V, size_t V_stride, real *T, size_t T_stride, int *statuses) {
  const arrays of = {V, V_stride, T, T_stride, 16};
  return for_all(n, &of, statuses, se3_exps, FN(chs_se3_exp));
}

int FN(chs_so3_log_array)(size_t n, const real *R, size_t R_stride, real *w, size_t w_stride, int *statuses) {
  const arrays of = {R, R_stride, w, w_stride, 3};
  return for_all(n, &of, statuses, so3_logs, FN(chs_so3_log));
}

int FN(chs_se3_log_array)(size_t n, const real *T, size_t T_stride, real *V, size_t V_stride, int *statuses) {
  const arrays of = {T, T_stride, V, V_stride, 6};
  return for_all(n, &of, statuses, se3_logs, FN(chs_se3_log));
}

void FN(chs_se3_compose_array)(size_t n, const real *A, size_t A_stride, const real *B, size_t B_stride, real *C,
                               size_t C_stride) {
  /* Not in blocks: taking 24 numbers apart and putting 16 together costs more than the products. */
  for (size_t i = 0; i < n; i++) {
    const real *a = A + i * A_stride, *b = B + i * B_stride;
    real *c = C + i * C_stride;
    if (VECTORS)
      compose(a, b, c);
    else
      FN(chs_se3_compose)(a, b, c);
  }
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
    for (size_t i = 0; i < n; i++) FN(chs_se3_apply)(T + i * T_stride, x + i * x_stride, y + i * y_stride);
  else if (x_stride == 3 && y_stride == 3)
    move_points(n, pose, x, 3, y, 3); /* which compilers turn into vector instructions */
  else
    move_points(n, pose, x, x_stride, y, y_stride);
}

/* Two rotations; then alpha, beta and what a block calls margin take the place of the first one's first row. */
typedef struct pairs {
  real nominal[9][LANES], actual[9][LANES];
} pairs;

enum { ALPHA, BETA, MARGIN };

static APART void tilt_error(pairs *b) {
  for (int lane = 0; lane < LANES; lane++) {
    real N[9], A[9];
    get_rows(b->nominal, lane, 3, N);
    get_rows(b->actual, lane, 3, A);
    tilt_and_torsion t = tilt_and_torsion_of(N, A);
    real tilted = dot(t.tilted, t.tilted), turned = t.turned * t.turned;
    b->nominal[ALPHA][lane] = angle_by_selects(tilted, t.cosine);
    b->nominal[BETA][lane] = angle_by_selects(turned, t.straight);
    int defined = safe_square(tilted) & safe_square(turned) & !torsion_is_undefined(&t);
    int usual = is_rotation(N) & is_rotation(A) & defined;
    b->nominal[MARGIN][lane] = usual ? K(1.0) : K(0.0);
  }
}

int FN(chs_tilt_error_array)(size_t n, const real *nominal, size_t nominal_stride, const real *actual,
                             size_t actual_stride, real *alpha, real *beta, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    pairs b;
    int count = lanes_left(n, i);
    if (VECTORS) {
      gather(nominal + i * nominal_stride, nominal_stride, 9, count, b.nominal);
      gather(actual + i * actual_stride, actual_stride, 9, count, b.actual);
      tilt_error(&b);
    }
    for (int lane = 0; lane < count; lane++) {
      size_t at = i + (size_t)lane;
      int status = CHS_OK;
      if (VECTORS && b.nominal[MARGIN][lane] > 0) {
        alpha[at] = b.nominal[ALPHA][lane];
        beta[at] = b.nominal[BETA][lane];
      } else
        status = FN(chs_tilt_error)(nominal + at * nominal_stride, actual + at * actual_stride, alpha + at, beta + at);
      note(&all, at, status);
    }
  }
  return all.worst;
}

/* The eight numbers of a screw. */
static INLINE void put_screw(const screw *s, int lane, real x[][LANES]) {
  put(s->axis, lane, 0, x);
  put(s->point, lane, 3, x);
  x[6][lane] = s->translation;
  x[7][lane] = s->angle;
}

static APART void scatter_screws(real x[][LANES], const real margin[LANES], int count, screw *screws) {
  for (int lane = 0; lane < count; lane++) {
    if (!(margin[lane] > 0)) continue;
    get(x, lane, 0, screws[lane].axis);
    get(x, lane, 3, screws[lane].point);
    screws[lane].translation = x[6][lane];
    screws[lane].angle = x[7][lane];
  }
}

/* What norm and unit in vec3.h make of a vector that need not be scaled, by the same operations. */
static APART void screw_from_pose(block *b) {
  for (int lane = 0; lane < LANES; lane++) {
    const real origin[3] = {0, 0, 0};
    real R[9], p[3] = {b->x[3][lane], b->x[7][lane], b->x[11][lane]};
    screw s;
    get_rows(b->x, lane, 4, R);
    quaternion q = quaternion_by_selects(R);
    real vv = dot(q.v, q.v), n = SQRT(vv), e[3] = {q.v[0] / n + K(0.0), q.v[1] / n + K(0.0), q.v[2] / n + K(0.0)};
    screw_about(e, n, q.w, origin, p, &s);
    put_screw(&s, lane, b->x);
    int usual = is_rotation(R) & (vv >= K(4.0) * UNDERFLOWS * UNDERFLOWS) & (q.w > EPS * n);
    b->margin[lane] = (usual ? K(1.0) : K(0.0)) + (nothing(s.point) + K(0.0) * s.translation);
  }
}

int FN(chs_screw_from_pose_array)(size_t n, const real *T, size_t T_stride, screw *screws, int *statuses) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    block b;
    int count = lanes_left(n, i);
    if (VECTORS) {
      gather(T + i * T_stride, T_stride, 12, count, b.x);
      screw_from_pose(&b);
      scatter_screws(b.x, b.margin, count, screws + i);
    }
    for (int lane = 0; lane < count; lane++) {
      size_t at = i + (size_t)lane;
      int usual = VECTORS && b.margin[lane] > 0;
      note(&all, at, usual ? CHS_OK : FN(chs_screw_from_pose)(T + at * T_stride, screws + at));
    }
  }
  return all.worst;
}

/* Three points before and after; of ordinary ones then the rotation and place, with these the screw, and in the end the
 * pose in place of all. */
typedef struct displacements {
  real x[18][LANES];
  real margin[LANES]; /* as in a block */
} displacements;

enum { VECTOR = 0, SCALAR = 3, CENTER = 4, TRAVEL = 7, SCREW = 10 };

static INLINE void bottema_roth(const triangles *t, quaternion *q) {
  real R[9];
  quaternion direct;
  rodrigues(t, &direct);
  real told = clear(t, &direct) ? K(1.0) : K(0.0); /* compared once a select, which vectorisers take */
  laub_shiflett_rotation(t, R);
  *q = quaternion_by_selects(R);
  q->v[0] = told > 0 ? direct.v[0] : q->v[0];
  q->v[1] = told > 0 ? direct.v[1] : q->v[1];
  q->v[2] = told > 0 ? direct.v[2] : q->v[2];
  q->w = told > 0 ? direct.w : q->w;
}

static INLINE void laub_shiflett(const triangles *t, quaternion *q) {
  real R[9];
  laub_shiflett_rotation(t, R);
  *q = quaternion_by_selects(R);
}

static INLINE void spoor_veldpaus(const triangles *t, quaternion *q) {
  real R[9];
  spoor_veldpaus_rotation(t, R);
  *q = quaternion_by_selects(R);
}

static INLINE void rotations(displacements *b, real tolerance, void method(const triangles *t, quaternion *q)) {
  for (int lane = 0; lane < LANES; lane++) {
    real initial[9], final[9];
    triangles t;
    place p;
    quaternion q;
    get_rows(b->x, lane, 3, initial);
    get_rows(b->x + 9, lane, 3, final);
    read_sides(initial, final, &t);
    read_rest(initial, final, &t, &p);
    method(&t, &q);
    put(q.v, lane, VECTOR, b->x);
    b->x[SCALAR][lane] = q.w;
    put(p.center, lane, CENTER, b->x);
    put(p.travel, lane, TRAVEL, b->x);
    b->margin[lane] = ordinary(&t, tolerance) && moves(&t) && plain(&t, &q) ? K(1.0) : K(0.0);
  }
}

static INLINE void get_rotation(real x[][LANES], int lane, quaternion *q, place *p) {
  get(x, lane, VECTOR, q->v);
  q->w = x[SCALAR][lane];
  get(x, lane, CENTER, p->center);
  get(x, lane, TRAVEL, p->travel);
}

static APART void find_screws(displacements *b) {
  for (int lane = 0; lane < LANES; lane++) {
    quaternion q;
    place p;
    screw s;
    get_rotation(b->x, lane, &q, &p);
    write_screw(&p, &q, SQRT(dot(q.v, q.v)), q.w < 0 ? K(-1.0) : K(1.0), &s);
    put_screw(&s, lane, b->x + SCREW);
  }
}

static APART void find_poses(displacements *b) {
  for (int lane = 0; lane < LANES; lane++) {
    quaternion q;
    place p;
    real R[9], shift[3];
    get_rotation(b->x, lane, &q, &p);
    pose_of(&p, &q, dot(q.v, q.v) + q.w * q.w, R, shift);
    put_rows(R, lane, 4, b->x);
    b->x[3][lane] = shift[0];
    b->x[7][lane] = shift[1];
    b->x[11][lane] = shift[2];
  }
}

static APART void scatter_poses(displacements *b, int count, real *T, size_t stride) {
  for (int lane = 0; lane < count; lane++)
    if (b->margin[lane] > 0) scatter(b->x, 16, lane, T + (size_t)lane * stride);
}

typedef void finder(displacements *b, real tolerance);
typedef int solver(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]);

static INLINE int solve_all(size_t n, const real *initial, size_t initial_stride, const real *final,
                            size_t final_stride, real tolerance, screw *screws, real *T, size_t T_stride, int *statuses,
                            finder *find_rotations, solver *any) {
  answers all = {statuses, CHS_OK};
  for (size_t i = 0; i < n; i += LANES) {
    displacements b;
    int count = lanes_left(n, i);
    if (VECTORS) {
      gather(initial + i * initial_stride, initial_stride, 9, count, b.x);
      gather(final + i * final_stride, final_stride, 9, count, b.x + 9);
      find_rotations(&b, tolerance);
      if (screws) {
        find_screws(&b);
        scatter_screws(b.x + SCREW, b.margin, count, screws + i);
      }
      if (T) {
        find_poses(&b);
        scatter_poses(&b, count, T + i * T_stride, T_stride);
      }
    }
    for (int lane = 0; lane < count; lane++) {
      size_t at = i + (size_t)lane;
      int status = CHS_OK;
      if (!(VECTORS && b.margin[lane] > 0))
        status = any(initial + at * initial_stride, final + at * final_stride, tolerance, screws ? screws + at : NULL,
                     T ? T + at * T_stride : NULL);
      note(&all, at, status);
    }
  }
  return all.worst;
}

/* A method for three points, of which each function below names one, so that a program holds no other. */
#define METHOD(name)                                                                                              \
  static APART void name##_rotations(displacements *b, real tolerance) { rotations(b, tolerance, name); }         \
  int FN(chs_motion_##name##_array)(size_t n, const real *initial, size_t initial_stride, const real *final,      \
                                    size_t final_stride, real tolerance, screw *screws, real *T, size_t T_stride, \
                                    int *statuses) {                                                              \
    return solve_all(n, initial, initial_stride, final, final_stride, tolerance, screws, T, T_stride, statuses,   \
                     name##_rotations, FN(chs_motion_##name));                                                    \
  }

METHOD(bottema_roth)
METHOD(laub_shiflett)
METHOD(spoor_veldpaus)
