#include "support/suite.h"

/* More than two blocks of 16, and not whole ones. */
enum { N = 37, ROUNDS = 40 };

/* Rotation vectors and twists of every band, and in some places what the single function refuses. */
static void make_twists(real *V, int stride, int size) {
  for (int i = 0; i < N; i++) {
    real *twist = V + i * stride;
    random_vector(i % 9 == 8 ? uniform(3.2, 40) : random_angle(i), twist);
    if (size == 6) random_vector(i % 5 ? 2 : 1e-3, twist + 3);
    if (integer(0, 20) == 0) twist[integer(0, size - 1)] = integer(0, 1) ? (real)NAN : (real)INFINITY;
    if (integer(0, 20) == 0) twist[integer(0, 2)] = K(1e30);
    if (integer(0, 20) == 0) twist[0] = twist[1] = twist[2] = 0;
  }
}

/* Poses of every band, some of them a half-turn to within 0 to 3 eps, and what the single function refuses. */
static void make_poses(real *T, int stride, int rows) {
  for (int i = 0; i < N; i++) {
    real w[3], R[9], skew = (real)(integer(-12, 12) * 0.25 * EPS);
    const real nearly_half[9] = {1, 0, 0, 0, -1, -skew, 0, skew, -1};
    random_vector(random_angle(i), w);
    FN(chs_so3_exp)(w, R);
    if (integer(0, 8) == 0) memcpy(R, nearly_half, sizeof R);
    for (int k = 0; k < 9; k++) T[i * stride + k / 3 * rows + k % 3] = R[k];
    for (int k = 0; k < 3 && rows == 4; k++) T[i * stride + 4 * k + 3] = (real)uniform(-2, 2);
    if (integer(0, 20) == 0) T[i * stride + integer(0, 2)] = (real)NAN;
    if (integer(0, 20) == 0) T[i * stride] += 1;
  }
}

static void fill(real *x, int n) {
  for (int i = 0; i < n; i++) x[i] = K(123.0) + (real)i;
}

/* The first error, else the first positive status. */
static int worst_of(const int *statuses) {
  for (int i = 0; i < N; i++)
    if (statuses[i] < 0) return statuses[i];
  for (int i = 0; i < N; i++)
    if (statuses[i] != CHS_OK) return statuses[i];
  return CHS_OK;
}

enum { MOST_STRIDE = 20 };

static real in[MOST_STRIDE * N], out[MOST_STRIDE * N], expected[MOST_STRIDE * N];
static int statuses[N], wanted[N];

/* Runs both forms on `in`, with room between the elements, and compares outputs, what is between them, and statuses. */
#define ASSERT_SAME_AS_SINGLE(name, in_stride, out_stride)                                                     \
  do {                                                                                                         \
    fill(out, MOST_STRIDE *N);                                                                                 \
    fill(expected, MOST_STRIDE *N);                                                                            \
    for (int i = 0; i < N; i++) wanted[i] = FN(chs_##name)(in + i * (in_stride), expected + i * (out_stride)); \
    int worst = FN(chs_##name##_array)(N, in, (size_t)(in_stride), out, (size_t)(out_stride), statuses);       \
    ASSERT_SAME_BITS(expected, out, MOST_STRIDE *N);                                                           \
    for (int i = 0; i < N; i++) ASSERT_STATUS(wanted[i], statuses[i]);                                         \
    ASSERT_STATUS(worst_of(wanted), worst);                                                                    \
    fill(out, MOST_STRIDE *N);                                                                                 \
    ASSERT_STATUS(worst, FN(chs_##name##_array)(N, in, (size_t)(in_stride), out, (size_t)(out_stride), NULL)); \
    ASSERT_SAME_BITS(expected, out, MOST_STRIDE *N);                                                           \
  } while (0)

static void test_so3_exp_is_the_single_one_for_every_element(void) {
  for (int round = 0; round < ROUNDS; round++) {
    make_twists(in, 3 + round % 3, 3);
    ASSERT_SAME_AS_SINGLE(so3_exp, 3 + round % 3, 9 + round % 4);
  }
}

static void test_se3_exp_is_the_single_one_for_every_element(void) {
  for (int round = 0; round < ROUNDS; round++) {
    make_twists(in, 6 + round % 3, 6);
    ASSERT_SAME_AS_SINGLE(se3_exp, 6 + round % 3, 16 + round % 4);
  }
}

/* Whole blocks without an exception are stored in another way. */
static void test_exps_of_nothing_but_ordinary_elements_are_the_single_ones(void) {
  for (int round = 0; round < ROUNDS; round++) {
    for (int i = 0; i < MOST_STRIDE * N; i++) in[i] = (real)uniform(-1.8, 1.8);
    ASSERT_SAME_AS_SINGLE(so3_exp, 3 + round % 3, 9 + round % 4);
    ASSERT_STATUS(CHS_OK, worst_of(wanted));
    ASSERT_SAME_AS_SINGLE(se3_exp, 6 + round % 3, 16 + round % 4);
    ASSERT_SAME_AS_SINGLE(so3_exp, 0, 9);
  }
}

static void test_se3_exp_says_overflow_where_the_translation_does(void) {
  make_twists(in, 6, 6);
  for (int k = 0; k < 6; k++) in[k] = k < 3 ? K(1.0) : REAL_MAX;
  ASSERT_SAME_AS_SINGLE(se3_exp, 6, 16);
  ASSERT_STATUS(CHS_ERR_OVERFLOW, statuses[0]);
}

static void test_logs_are_the_single_ones_for_every_element(void) {
  for (int round = 0; round < ROUNDS; round++) {
    make_poses(in, 9 + round % 3, 3);
    ASSERT_SAME_AS_SINGLE(so3_log, 9 + round % 3, 3 + round % 4);
    make_poses(in, 16 + round % 3, 4);
    ASSERT_SAME_AS_SINGLE(se3_log, 16 + round % 3, 6 + round % 4);
  }
}

static void test_compose_and_apply_are_the_single_ones_also_in_place_and_with_one_pose_for_all(void) {
  real other[16 * N], points[4 * N], x[4 * N];
  for (int i = 0; i < N; i++) {
    random_pose(2, in + 16 * i);
    random_pose(2, other + 16 * i);
  }
  for (int i = 0; i < 4 * N; i++) x[i] = (real)uniform(-2, 2);
  for (int one = 0; one < 2; one++) {
    int stride = one ? 0 : 16;
    for (int i = 0; i < N; i++) FN(chs_se3_compose)(in + i * stride, other + 16 * i, expected + 16 * i);
    memcpy(out, other, sizeof(real) * (16 * N));
    FN(chs_se3_compose_array)(N, in, (size_t)stride, out, 16, out, 16);
    ASSERT_SAME_BITS(expected, out, 16 * N);
    for (int room = 3; room <= 4; room++) {
      memcpy(points, x, sizeof(real) * (4 * N));
      memcpy(expected, x, sizeof(real) * (4 * N));
      for (int i = 0; i < N; i++) FN(chs_se3_apply)(in + i * stride, x + room * i, expected + room * i);
      FN(chs_se3_apply_array)(N, in, (size_t)stride, points, (size_t)room, points, (size_t)room);
      ASSERT_SAME_BITS(expected, points, 4 * N);
      int other_room = 7 - room; /* strides that differ */
      fill(points, 4 * N);
      fill(expected, 4 * N);
      for (int i = 0; i < N; i++) FN(chs_se3_apply)(in + i * stride, x + room * i, expected + other_room * i);
      FN(chs_se3_apply_array)(N, in, (size_t)stride, x, (size_t)room, points, (size_t)other_room);
      ASSERT_SAME_BITS(expected, points, 4 * N);
    }
  }
}

static void test_tilt_error_is_the_single_one_also_with_one_nominal_for_all(void) {
  const real upside_down[9] = {-1, 0, 0, 0, 1, 0, 0, 0, -1};
  real nominal[9 * N], alpha[N], beta[N];
  for (int round = 0; round < ROUNDS; round++) {
    size_t stride = round % 2 ? 0 : 9;
    make_poses(nominal, 9, 3);
    make_poses(in, 9, 3);
    for (int i = 0; i < N; i += 7) FN(chs_so3_multiply)(nominal + (size_t)i * stride, upside_down, in + 9 * i);
    fill(alpha, N);
    fill(beta, N);
    fill(out, N);
    fill(expected, N);
    for (int i = 0; i < N; i++)
      wanted[i] = FN(chs_tilt_error)(nominal + (size_t)i * stride, in + 9 * i, expected + i, out + i);
    int worst = FN(chs_tilt_error_array)(N, nominal, stride, in, 9, alpha, beta, statuses);
    ASSERT_SAME_BITS(expected, alpha, N);
    ASSERT_SAME_BITS(out, beta, N);
    for (int i = 0; i < N; i++) ASSERT_STATUS(wanted[i], statuses[i]);
    ASSERT_STATUS(worst_of(wanted), worst);
  }
}

static void put_screw(const screw *s, real *flat) {
  memcpy(flat, s->axis, sizeof s->axis);
  memcpy(flat + 3, s->point, sizeof s->point);
  flat[6] = s->translation;
  flat[7] = s->angle;
}

/* The screws of the array form and of the single one, number by number, and the statuses. */
static void assert_same_screws(const screw *one, const screw *other, int worst) {
  for (int i = 0; i < N; i++) {
    put_screw(one + i, expected + 8 * i);
    put_screw(other + i, out + 8 * i);
    ASSERT_STATUS(wanted[i], statuses[i]);
  }
  ASSERT_SAME_BITS(expected, out, 8 * N);
  ASSERT_STATUS(worst_of(wanted), worst);
}

static void test_screw_from_pose_is_the_single_one_for_every_element(void) {
  static screw one[N], other[N];
  for (int round = 0; round < ROUNDS; round++) {
    size_t stride = 16 + (size_t)round % 3;
    make_poses(in, (int)stride, 4);
    for (int i = 0; i < N; i++) wanted[i] = FN(chs_screw_from_pose)(in + (size_t)i * stride, one + i);
    int worst = FN(chs_screw_from_pose_array)(N, in, stride, other, statuses);
    assert_same_screws(one, other, worst);
  }
}

static void test_screw_from_pose_says_overflow_where_the_way_along_the_axis_does(void) {
  static screw one[N], other[N];
  const real third[9] = {0, -1, 0, 0, 0, -1, 1, 0, 0}, p[3] = {-REAL_MAX, REAL_MAX, 0};
  for (int i = 0; i < N; i++) FN(chs_se3_from_parts)(third, p, in + 16 * i);
  for (int i = 0; i < N; i++) wanted[i] = FN(chs_screw_from_pose)(in + 16 * i, one + i);
  memcpy(other, one, sizeof other); /* untouched, both of them */
  int worst = FN(chs_screw_from_pose_array)(N, in, 16, other, statuses);
  ASSERT_STATUS(CHS_ERR_OVERFLOW, worst);
  assert_same_screws(one, other, worst);
}

typedef int method(const real initial[9], const real final[9], real tolerance, screw *s, real T[16]);
typedef int array_method(size_t n, const real *initial, size_t initial_stride, const real *final, size_t final_stride,
                         real tolerance, screw *screws, real *T, size_t T_stride, int *all);

static void check_method(method *single, array_method *array, const real *initial, size_t initial_stride) {
  static screw one[N], other[N];
  static real T[16 * N], U[16 * N];
  fill(T, 16 * N);
  fill(U, 16 * N);
  for (int i = 0; i < N; i++)
    wanted[i] = single(initial + (size_t)i * initial_stride, in + 9 * i, K(1e-3), one + i, T + 16 * i);
  int worst = array(N, initial, initial_stride, in, 9, K(1e-3), other, U, 16, statuses);
  ASSERT_SAME_BITS(T, U, 16 * N);
  assert_same_screws(one, other, worst);
  fill(U, 16 * N);
  ASSERT_STATUS(worst, array(N, initial, initial_stride, in, 9, K(1e-3), NULL, U, 16, NULL));
  ASSERT_SAME_BITS(T, U, 16 * N);
  ASSERT_STATUS(worst, array(N, initial, initial_stride, in, 9, K(1e-3), other, NULL, 0, statuses));
  assert_same_screws(one, other, worst);
}

static void test_methods_for_three_points_are_the_single_ones_also_with_one_triangle_for_all(void) {
  static real initial[9 * N];
  for (int round = 0; round < ROUNDS; round++) {
    size_t stride = round % 2 ? 0 : 9;
    for (int i = 0; i < N; i++) {
      real T[16];
      random_pose(random_angle(i), T);
      for (int k = 0; k < 9; k++) initial[9 * i + k] = (real)uniform(-1, 1);
      for (int k = 0; k < 3; k++) FN(chs_se3_apply)(T, initial + (size_t)i * stride + 3 * k, in + 9 * i + 3 * k);
      if (integer(0, 20) == 0) in[9 * i + integer(0, 8)] = integer(0, 1) ? (real)NAN : 2;
    }
    check_method(FN(chs_motion_bottema_roth), FN(chs_motion_bottema_roth_array), initial, stride);
    check_method(FN(chs_motion_laub_shiflett), FN(chs_motion_laub_shiflett_array), initial, stride);
    check_method(FN(chs_motion_spoor_veldpaus), FN(chs_motion_spoor_veldpaus_array), initial, stride);
  }
}

static void test_no_elements_are_ok(void) {
  fill(out, N);
  fill(expected, N);
  ASSERT_STATUS(CHS_OK, FN(chs_so3_exp_array)(0, in, 3, out, 9, NULL));
  ASSERT_STATUS(CHS_OK, FN(chs_se3_exp_array)(0, in, 6, out, 16, NULL));
  FN(chs_se3_apply_array)(0, in, 0, in, 3, out, 3);
  ASSERT_SAME_BITS(expected, out, N);
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_so3_exp_is_the_single_one_for_every_element);
  RUN_TEST(test_se3_exp_is_the_single_one_for_every_element);
  RUN_TEST(test_exps_of_nothing_but_ordinary_elements_are_the_single_ones);
  RUN_TEST(test_se3_exp_says_overflow_where_the_translation_does);
  RUN_TEST(test_logs_are_the_single_ones_for_every_element);
  RUN_TEST(test_compose_and_apply_are_the_single_ones_also_in_place_and_with_one_pose_for_all);
  RUN_TEST(test_tilt_error_is_the_single_one_also_with_one_nominal_for_all);
  RUN_TEST(test_screw_from_pose_is_the_single_one_for_every_element);
  RUN_TEST(test_screw_from_pose_says_overflow_where_the_way_along_the_axis_does);
  RUN_TEST(test_methods_for_three_points_are_the_single_ones_also_with_one_triangle_for_all);
  RUN_TEST(test_no_elements_are_ok);
  return SUITE_END();
}
