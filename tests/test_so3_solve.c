#include "support/suite.h"

enum { CASES = 300 };

/* R = target, as the three angles of the rotation between them. */
static int off_target(const real R[9], void *context, real f[3]) {
  real back[9];
  FN(chs_so3_transpose)((const real *)context, back);
  FN(chs_so3_multiply)(R, back, back);
  return FN(chs_so3_log)(back, f);
}

/* The Agile Eye's legs, w_i . v_i = 0, from its joint angles: six numbers, s and c. */
static int legs_open(const real R[9], void *context, real f[3]) {
  const real *s = (const real *)context, *c = s + 3;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    f[i] = c[i] * R[3 * k + j] - s[i] * R[3 * j + j];
  }
  return CHS_OK;
}

static int never(const real R[9], void *context, real f[3]) {
  (void)R;
  (void)context;
  for (int i = 0; i < 3; i++) f[i] = 1;
  return CHS_OK;
}

static int refuses(const real R[9], void *context, real f[3]) {
  (void)R;
  (void)f;
  return *(int *)context;
}

static int writes(const real R[9], void *context, real f[3]) {
  (void)R;
  for (int i = 0; i < 3; i++) f[i] = *(real *)context;
  return CHS_OK;
}

static void test_any_rotation_is_found_from_up_to_a_half_turn_away(void) {
  for (int k = 0; k < CASES; k++) {
    real target[9], start[9], R[9], w[3], angle, rest;
    random_rotation(target);
    random_vector(uniform(0, 2.9), w); /* at a half-turn the three angles jump */
    FN(chs_so3_exp)(w, start);
    FN(chs_so3_multiply)(start, target, start);
    int status = FN(chs_so3_solve)(off_target, target, start, (real)(8 * EPS), 40, R, &rest);
    if (status != CHS_ITERATION_LIMIT) ASSERT_STATUS(CHS_OK, status);
    FN(chs_so3_angle)(R, target, &angle);
    ASSERT_WITHIN_EPS(0, angle, 16 + 4 * CHS_EPS_SO3_LOG, 1);
    TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(4 * EPS)));
  }
}

/* Newton's method takes the place of the closed form, from an orientation nearby; the distance to a singularity decides
 * what a residual of an eps means. */
static void test_newton_finds_what_the_closed_form_gives(void) {
  for (int k = 0; k < 4 * CASES; k++) {
    real q[3], sines[6], exact[9], start[9], w[3], turned[9], R[9], rest;
    double d = 1;
    for (int i = 0; i < 3; i++) {
      q[i] = (real)uniform(-PI, PI);
      sines[i] = rounded(sin((double)q[i]));
      sines[3 + i] = rounded(cos((double)q[i]));
    }
    double D = 1, E = 1;
    for (int i = 0; i < 3; i++) {
      d = fmin(d, hypot(sin((double)q[(i + 1) % 3]), cos((double)q[(i + 1) % 3]) * cos((double)q[(i + 2) % 3])));
      D *= sin((double)q[i]);
      E *= cos((double)q[i]);
    }
    if (fabs(D + E) < 0.2) continue;
    FN(chs_agile_eye_direct)(q, k % 4, exact);
    random_vector(0.1, w);
    FN(chs_so3_exp)(w, turned);
    FN(chs_so3_multiply)(turned, exact, start);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_solve)(legs_open, sines, start, (real)(4 * EPS), 20, R, &rest));
    /* The three residuals have the derivative A, of determinant D and with rows of length 1. */
    ASSERT_ENTRIES_WITHIN_EPS(exact, R, 9, 16 / fabs(D + E), 1);
  }
}

/* Equations about one axis, z, whose Newton step from 0.3 overshoots the more, the steeper they are at their root. */
typedef struct steep {
  double scale;
  double refused_below; /* angles less than this are an error */
} steep;

static int steep_about_z(const real R[9], void *context, real f[3]) {
  const steep *s = (const steep *)context;
  real w[3];
  int status = FN(chs_so3_log)(R, w);
  if (status < 0) return status;
  if ((double)w[2] < s->refused_below) return CHS_ERR_LOCKUP;
  for (int i = 0; i < 3; i++) f[i] = (real)(s->scale * (i < 2 ? (double)w[i] : atan(30 * (double)w[2])));
  return CHS_OK;
}

static void start_at(double angle, real R[9]) {
  const real w[3] = {0, 0, (real)angle};
  FN(chs_so3_exp)(w, R);
}

static void test_a_step_too_far_is_shortened(void) {
  const steep cases[] = {{1, -4}, {1, -0.1}};
  for (int k = 0; k < LENGTH(cases); k++) {
    steep s = cases[k];
    real start[9], R[9];
    start_at(0.3, start);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_solve)(steep_about_z, &s, start, (real)(16 * EPS), 30, R, NULL));
    ASSERT_ENTRIES_WITHIN_EPS(identity3, R, 9, 16, 1);
  }
}

static void test_a_step_turns_by_half_a_radian_at_most(void) {
  for (int k = 0; k < CASES; k++) {
    real target[9], R[9], w[3], moved;
    random_vector(uniform(0.6, 2.5), w);
    FN(chs_so3_exp)(w, target);
    ASSERT_STATUS(CHS_ITERATION_LIMIT, FN(chs_so3_solve)(off_target, target, identity3, 0, 1, R, NULL));
    FN(chs_so3_angle)(identity3, R, &moved);
    TEST_ASSERT_TRUE(fabs((double)moved - 0.5) < 1e-3);
  }
}

static void test_the_size_of_the_equations_does_not_matter(void) {
  const double scales[] = {1e-6, 1e-3, 1e3, 1e6};
  for (int k = 0; k < LENGTH(scales); k++) {
    steep s = {scales[k], -4};
    real start[9], R[9];
    start_at(0.02, start);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_solve)(steep_about_z, &s, start, (real)(64 * EPS * scales[k]), 30, R, NULL));
    ASSERT_ENTRIES_WITHIN_EPS(identity3, R, 9, 64, 1);
  }
}

static void test_a_solved_start_is_kept_and_no_step_is_a_status(void) {
  real R[9], rest, other[9];
  random_rotation(other);
  ASSERT_STATUS(CHS_OK, FN(chs_so3_solve)(off_target, other, other, 0, 0, R, &rest));
  ASSERT_ENTRIES_WITHIN_EPS(other, R, 9, CHS_EPS_SO3_NEAREST_ROTATION, 1);
  TEST_ASSERT_TRUE(rest == 0);
  ASSERT_STATUS(CHS_ITERATION_LIMIT, FN(chs_so3_solve)(off_target, other, identity3, 0, 0, R, NULL));
  ASSERT_ENTRIES_WITHIN_EPS(identity3, R, 9, CHS_EPS_SO3_NEAREST_ROTATION, 1);
}

/* Of a start that has drifted and of an end that has not: what is left is that of the rotation that comes out. */
static void test_rest_is_that_of_the_rotation(void) {
  for (int k = 0; k < CASES; k++) {
    real target[9], start[9], R[9], f[3], rest, tolerance = (real)uniform(0, 0.01);
    random_rotation(target);
    for (int i = 0; i < 9; i++) start[i] = target[i] + (real)uniform(-0.002, 0.002);
    int status = FN(chs_so3_solve)(off_target, target, start, tolerance, k % 4, R, &rest);
    TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(4 * EPS)));
    ASSERT_STATUS(CHS_OK, off_target(R, target, f));
    const double left = length_of(f, 3);
    ASSERT_WITHIN_EPS(left, rest, 4, left);
    ASSERT_STATUS(rest <= tolerance ? CHS_OK : CHS_ITERATION_LIMIT, status);
  }
}

static void test_output_may_be_the_start(void) {
  real target[9], apart[9], R[9];
  random_rotation(target);
  random_rotation(R);
  int status = FN(chs_so3_solve)(off_target, target, R, (real)(64 * EPS), 30, apart, NULL);
  TEST_ASSERT_EQUAL(status, FN(chs_so3_solve)(off_target, target, R, (real)(64 * EPS), 30, R, NULL));
  ASSERT_SAME_BITS(apart, R, 9);
}

static void test_what_cannot_be_solved_is_refused(void) {
  real R[9], bad = (real)NAN, far = (real)INFINITY;
  int error = CHS_ERR_LOCKUP;
  ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_so3_solve)(never, NULL, identity3, 0, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_LOCKUP, R, FN(chs_so3_solve)(refuses, &error, identity3, 0, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_NAN, R, FN(chs_so3_solve)(writes, &bad, identity3, 0, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_INFINITE, R, FN(chs_so3_solve)(writes, &far, identity3, 0, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, R, FN(chs_so3_solve)(never, NULL, identity3, -1, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, R, FN(chs_so3_solve)(never, NULL, identity3, (real)NAN, 5, R, NULL));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, R, FN(chs_so3_solve)(never, NULL, identity3, 0, -1, R, NULL));
  for (int b = 0; b < LENGTH(bad_rotations); b++)
    ASSERT_REFUSES(bad_rotations[b].status, R, FN(chs_so3_solve)(never, NULL, bad_rotations[b].R, 0, 5, R, NULL));
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_any_rotation_is_found_from_up_to_a_half_turn_away);
  RUN_TEST(test_newton_finds_what_the_closed_form_gives);
  RUN_TEST(test_a_step_too_far_is_shortened);
  RUN_TEST(test_a_step_turns_by_half_a_radian_at_most);
  RUN_TEST(test_the_size_of_the_equations_does_not_matter);
  RUN_TEST(test_a_solved_start_is_kept_and_no_step_is_a_status);
  RUN_TEST(test_rest_is_that_of_the_rotation);
  RUN_TEST(test_output_may_be_the_start);
  RUN_TEST(test_what_cannot_be_solved_is_refused);
  return SUITE_END();
}
