#include "support/suite.h"

#define DEGREE (PI / 180)

enum { CASES = 40 };

/* The Agile Eye's tool in its working mode 0 (context NULL) or in an assembly mode. */
static int agile_eye(const real *joints, void *context, real T[16]) {
  const real origin[3] = {0, 0, 0};
  real R[9];
  int status =
      context ? FN(chs_agile_eye_direct)(joints, *(int *)context, R) : FN(chs_agile_eye_direct_working)(joints, 0, R);
  if (status < 0) return status;
  FN(chs_agile_eye_tool)(R, R);
  FN(chs_se3_from_parts)(R, origin, T);
  return status;
}

/* The same with its legs closed by Newton's method, from the orientation in the context: for robots without a closed
 * form. */
typedef struct newton_robot {
  real sines[6], start[9];
} newton_robot;

static int legs_open(const real R[9], void *context, real f[3]) {
  const real *s = ((newton_robot *)context)->sines, *c = s + 3;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    f[i] = c[i] * R[3 * k + j] - s[i] * R[3 * j + j];
  }
  return CHS_OK;
}

static int agile_eye_by_newton(const real *joints, void *context, real T[16]) {
  const real origin[3] = {0, 0, 0};
  newton_robot *robot = (newton_robot *)context;
  real R[9];
  for (int i = 0; i < 3; i++) {
    robot->sines[i] = rounded(sin((double)joints[i]));
    robot->sines[3 + i] = rounded(cos((double)joints[i]));
  }
  int status = FN(chs_so3_solve)(legs_open, robot, robot->start, (real)(4 * EPS), 10, R, NULL);
  if (status < 0) return status;
  FN(chs_agile_eye_tool)(R, R);
  FN(chs_se3_from_parts)(R, origin, T);
  return CHS_OK;
}

/* A joint that turns the tool about its axis and one that slides along x by
 * x - x^2. */
static int turn_and_slide(const real *joints, void *context, real T[16]) {
  const real axis[3] = {0, 0, joints[0]};
  real R[9], p[3] = {joints[1] - joints[1] * joints[1], 0, 0};
  (void)context;
  int status = FN(chs_so3_exp)(axis, R);
  FN(chs_se3_from_parts)(R, p, T);
  return status;
}

static int refuses(const real *joints, void *context, real T[16]) {
  (void)joints;
  (void)T;
  return *(int *)context;
}

static int cautious(const real *joints, void *context, real T[16]) {
  (void)joints;
  for (int i = 0; i < 16; i++) T[i] = identity4[i];
  return *(int *)context;
}

/* Places what the context says where the first joint is above 0. */
static int misplaced(const real *joints, void *context, real T[16]) {
  for (int i = 0; i < 16; i++) T[i] = identity4[i];
  if (joints[0] > 0) T[11] = *(const real *)context;
  return CHS_OK;
}

/* The paper's error of 0.01 degrees, on a grid of nine values a joint. */
static void test_errors_at_the_reference_of_the_agile_eye(void) {
  const real q[3] = {0, 0, 0}, e = (real)(0.01 * DEGREE), errors[3] = {e, e, e};
  real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3], where[9];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye, NULL, 3, q, errors, 9, 0, scratch, worst, where));
  TEST_ASSERT_TRUE(fabs((double)worst[0] / DEGREE - 0.01633) < 0.000005);
  TEST_ASSERT_TRUE(fabs((double)worst[1] / DEGREE - 0.01732) < 0.000005);
  TEST_ASSERT_TRUE(worst[2] == 0);
  for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(where[i] == e || where[i] == -e);
}

static void test_where_gives_the_errors_again(void) {
  const real e = (real)(0.3 * DEGREE), errors[3] = {e, e / 2, e};
  for (int k = 0; k < CASES; k++) {
    int mode = k % 4;
    real q[3] = {(real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7)};
    real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3], where[9], T[16], nominal[9], R[9], p[3], alpha, beta;
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye, &mode, 3, q, errors, 3, 6, scratch, worst, where));
    agile_eye(q, &mode, T);
    FN(chs_se3_to_parts)(T, nominal, p);
    for (int m = 0; m < 2; m++) {
      agile_eye(where + 3 * m, &mode, T);
      FN(chs_se3_to_parts)(T, R, p);
      FN(chs_tilt_error)(nominal, R, &alpha, &beta);
      ASSERT_SAME_BITS(worst + m, m == 0 ? &alpha : &beta, 1);
      for (int i = 0; i < 3; i++)
        TEST_ASSERT_TRUE(fabs((double)(where[3 * m + i] - q[i])) <= (double)errors[i] * 1.00001);
    }
  }
}

static void test_no_random_point_of_the_box_is_worse_than_the_worst(void) {
  const real e = (real)(1 * DEGREE), errors[3] = {e, e, e};
  for (int k = 0; k < CASES; k++) {
    int mode = 0;
    real q[3] = {(real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7)};
    real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3], T[16], nominal[9], R[9], p[3], alpha, beta;
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye, &mode, 3, q, errors, 3, 10, scratch, worst, NULL));
    agile_eye(q, &mode, T);
    FN(chs_se3_to_parts)(T, nominal, p);
    for (int n = 0; n < 200; n++) {
      real off[3];
      for (int i = 0; i < 3; i++) off[i] = q[i] + errors[i] * (real)uniform(-1, 1);
      agile_eye(off, &mode, T);
      FN(chs_se3_to_parts)(T, R, p);
      FN(chs_tilt_error)(nominal, R, &alpha, &beta);
      TEST_ASSERT_TRUE((double)alpha <= (double)worst[0] + 32 * EPS);
      TEST_ASSERT_TRUE((double)beta <= (double)worst[1] + 32 * EPS);
    }
  }
}

static void test_each_measure_has_a_worst_of_its_own(void) {
  const real q[2] = {0, K(0.5)}, errors[2] = {K(0.125), K(0.25)};
  real scratch[CHS_TILT_WORST_SCRATCH(2)], worst[3];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(turn_and_slide, NULL, 2, q, errors, 4, 0, scratch, worst, NULL));
  TEST_ASSERT_TRUE(worst[0] == 0);
  ASSERT_WITHIN_EPS(0.125, worst[1], 4, 1);
  ASSERT_WITHIN_EPS(0.0625, worst[2], 4, 1);
}

/* The torsion is the sine of the joint, whose summit lies between the points of the grid. */
static int swing(const real *joints, void *context, real T[16]) {
  const real axis[3] = {0, 0, (real)sin((double)joints[0])}, origin[3] = {0, 0, 0};
  real R[9];
  (void)context;
  int status = FN(chs_so3_exp)(axis, R);
  FN(chs_se3_from_parts)(R, origin, T);
  return status;
}

static void test_the_search_climbs_to_a_summit_inside(void) {
  const real q[1] = {0}, errors[1] = {2};
  real scratch[CHS_TILT_WORST_SCRATCH(1)], coarse[3], fine[3], where[3];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(swing, NULL, 1, q, errors, 6, 0, scratch, coarse, NULL));
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(swing, NULL, 1, q, errors, 6, 20, scratch, fine, where));
  TEST_ASSERT_TRUE((double)coarse[1] < 0.94);
  TEST_ASSERT_TRUE(fabs((double)fine[1] - 1) < 1e-6);
  TEST_ASSERT_TRUE(fabs(fabs((double)where[1]) - PI / 2) < 1e-3);
}

/* The torsion is the sine of 20 times the second joint; the first one does nothing. */
static int fast_swing(const real *joints, void *context, real T[16]) {
  const real faster = 20 * joints[1];
  return swing(&faster, context, T);
}

static void test_the_search_keeps_inside_the_box_and_knows_its_joints_apart(void) {
  const real q[2] = {3, 0}, errors[2] = {K(0.25), K(0.12)};
  real scratch[CHS_TILT_WORST_SCRATCH(2)], worst[3], where[6];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(fast_swing, NULL, 2, q, errors, 4, 20, scratch, worst, where));
  TEST_ASSERT_TRUE(fabs((double)worst[1] - 1) < 1e-6);
  TEST_ASSERT_TRUE(fabs(fabs((double)where[3]) - PI / 40) < 1e-4);
}

/* A pose far out, half of it rounding, and more of that at the upper end: neither joint matters. */
static int far_out(const real *joints, void *context, real T[16]) {
  const double noise = (double)joints[1] * (joints[1] > 0 ? 3 : 1);
  const real axis[3] = {K(0.3), K(-0.4), K(0.5)}, p[3] = {K(1e6) + joints[0] * 0, (real)(1e6 * (1 + EPS * noise)), 0};
  real R[9];
  (void)context;
  int status = FN(chs_so3_exp)(axis, R);
  FN(chs_se3_from_parts)(R, p, T);
  return status;
}

static void test_a_joint_that_does_not_matter_stays_at_its_lower_end(void) {
  const real q[2] = {3, 0}, errors[2] = {K(0.25), 4};
  real scratch[CHS_TILT_WORST_SCRATCH(2)], worst[3], where[6];
  for (int steps = 2; steps <= 3; steps++) {
    fill_with_pattern(scratch, sizeof scratch);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(far_out, NULL, 2, q, errors, steps, 4, scratch, worst, where));
    for (int m = 0; m < 3; m++) {
      TEST_ASSERT_TRUE(where[2 * m] == q[0] - errors[0]);
      TEST_ASSERT_TRUE(where[2 * m + 1] == q[1] - errors[1]);
    }
  }
}

static void test_a_joint_without_error_stays_where_it_is(void) {
  const real q[3] = {K(0.1), K(0.2), K(0.3)}, errors[3] = {K(0.01), 0, K(0.01)};
  real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3], where[9];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye, NULL, 3, q, errors, 3, 4, scratch, worst, where));
  for (int m = 0; m < 3; m++) TEST_ASSERT_TRUE(where[3 * m + 1] == q[1]);
}

/* Of the positive statuses the first is the answer: that of the nominal pose. */
static int two_statuses(const real *joints, void *context, real T[16]) {
  (void)context;
  for (int i = 0; i < 16; i++) T[i] = identity4[i];
  return joints[0] == 0 ? CHS_NEAR_SINGULAR : CHS_ILL_CONDITIONED;
}

static void test_the_first_positive_status_is_the_answer(void) {
  const real q[1] = {0}, errors[1] = {1};
  real scratch[CHS_TILT_WORST_SCRATCH(1)], worst[3];
  ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_tilt_worst)(two_statuses, NULL, 1, q, errors, 2, 2, scratch, worst, NULL));
}

static void test_a_robot_without_closed_form_is_studied_by_newton(void) {
  const real e = (real)(0.1 * DEGREE), errors[3] = {e, e, e};
  for (int k = 0; k < CASES; k++) {
    newton_robot newton;
    int mode = k % 4;
    real q[3] = {(real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7), (real)uniform(-0.7, 0.7)};
    real scratch[CHS_TILT_WORST_SCRATCH(3)], closed[3], found[3];
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct)(q, mode, newton.start));
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye, &mode, 3, q, errors, 3, 0, scratch, closed, NULL));
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_worst)(agile_eye_by_newton, &newton, 3, q, errors, 3, 0, scratch, found, NULL));
    for (int m = 0; m < 3; m++) ASSERT_WITHIN_EPS(closed[m], found[m], 200, 1);
  }
}

static void test_a_box_that_reaches_a_singularity_is_told(void) {
  const real q[3] = {K(0.3), 0, REAL_PI / 2}, errors[3] = {K(0.1), K(0.1), K(0.1)};
  real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3];
  int mode = 0;
  ASSERT_REFUSES(CHS_ERR_SINGULAR, worst,
                 FN(chs_tilt_worst)(agile_eye, &mode, 3, q, errors, 3, 0, scratch, worst, NULL));
}

static void test_the_robot_s_own_statuses_come_through(void) {
  const real q[3] = {0, 0, 0}, errors[3] = {K(0.1), K(0.1), K(0.1)};
  real scratch[CHS_TILT_WORST_SCRATCH(3)], worst[3], bad[3];
  int status = CHS_ERR_LOCKUP;
  ASSERT_REFUSES(CHS_ERR_LOCKUP, worst, FN(chs_tilt_worst)(refuses, &status, 3, q, errors, 3, 2, scratch, worst, NULL));
  status = CHS_NEAR_SINGULAR;
  ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_tilt_worst)(cautious, &status, 3, q, errors, 3, 2, scratch, worst, NULL));
  status = CHS_OK;
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, worst,
                 FN(chs_tilt_worst)(cautious, &status, 0, q, errors, 3, 2, scratch, worst, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, worst,
                 FN(chs_tilt_worst)(cautious, &status, 3, q, errors, 1, 2, scratch, worst, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, worst,
                 FN(chs_tilt_worst)(cautious, &status, 3, q, errors, 3, -1, scratch, worst, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, worst,
                 FN(chs_tilt_worst)(cautious, &status, 3, q, errors, 1025, 2, scratch, worst, NULL));
  set(bad, K(0.1), K(-0.1), K(0.1));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, worst, FN(chs_tilt_worst)(cautious, &status, 3, q, bad, 3, 2, scratch, worst, NULL));
  for (int i = 0; i < 3; i++) {
    set(bad, K(0.1), K(0.1), K(0.1));
    bad[i] = (real)INFINITY;
    ASSERT_REFUSES(CHS_ERR_INFINITE, worst,
                   FN(chs_tilt_worst)(cautious, &status, 3, q, bad, 3, 2, scratch, worst, NULL));
    ASSERT_REFUSES(CHS_ERR_INFINITE, worst,
                   FN(chs_tilt_worst)(cautious, &status, 3, bad, errors, 3, 2, scratch, worst, NULL));
    bad[i] = (real)NAN;
    ASSERT_REFUSES(CHS_ERR_NAN, worst, FN(chs_tilt_worst)(cautious, &status, 3, q, bad, 3, 2, scratch, worst, NULL));
  }
  real place = (real)NAN;
  ASSERT_REFUSES(CHS_ERR_NAN, worst, FN(chs_tilt_worst)(misplaced, &place, 3, q, errors, 3, 2, scratch, worst, NULL));
  place = (real)INFINITY;
  ASSERT_REFUSES(CHS_ERR_INFINITE, worst,
                 FN(chs_tilt_worst)(misplaced, &place, 3, q, errors, 3, 2, scratch, worst, NULL));
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_errors_at_the_reference_of_the_agile_eye);
  RUN_TEST(test_where_gives_the_errors_again);
  RUN_TEST(test_no_random_point_of_the_box_is_worse_than_the_worst);
  RUN_TEST(test_each_measure_has_a_worst_of_its_own);
  RUN_TEST(test_the_search_climbs_to_a_summit_inside);
  RUN_TEST(test_the_search_keeps_inside_the_box_and_knows_its_joints_apart);
  RUN_TEST(test_a_joint_that_does_not_matter_stays_at_its_lower_end);
  RUN_TEST(test_a_joint_without_error_stays_where_it_is);
  RUN_TEST(test_the_first_positive_status_is_the_answer);
  RUN_TEST(test_a_robot_without_closed_form_is_studied_by_newton);
  RUN_TEST(test_a_box_that_reaches_a_singularity_is_told);
  RUN_TEST(test_the_robot_s_own_statuses_come_through);
  return SUITE_END();
}
