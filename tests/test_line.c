#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                       \
  PLAIN(line_raw_from_points, "xx", "L", (in[0], in[1], out[0]))        \
  CHECKED(line_from_points, "xx", "L", (in[0], in[1], out[0]))          \
  CHECKED(line_from_direction, "xx", "L", (in[0], in[1], out[0]))       \
  CHECKED(line_normalize, "V", "L", (in[0], out[0]))                    \
  PLAIN(line_move, "TL", "L", (in[0], in[1], out[0]))                   \
  CHECKED(line_project, "Lx", "xa", (in[0], in[1], out[0], out[1]))     \
  CHECKED(line_angle, "LL", "a", (in[0], in[1], out[0]))                \
  CHECKED(line_signed_angle, "LLx", "a", (in[0], in[1], in[2], out[0])) \
  CHECKED(line_distance, "LL", "a", (in[0], in[1], out[0]))             \
  CHECKED(line_perpendicular, "LL", "Lxxaa", (in[0], in[1], out[0], out[1], out[2], out[3], out[4]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

/* The whole answer of chs_line_perpendicular. */
typedef struct perpendicular {
  real X[6], foot_a[3], foot_b[3], angle, distance;
} perpendicular;

static int perpendicular_of(const real A[6], const real B[6], perpendicular *p) {
  return FN(chs_line_perpendicular)(A, B, p->X, p->foot_a, p->foot_b, &p->angle, &p->distance);
}

static void random_line(double reach, real L[6]) {
  real p[3], d[3];
  random_vector(reach, p);
  random_vector(1, d);
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_direction)(p, d, L));
}

/* How far the point is from the line, in double. */
static double off_line(const real L[6], const real x[3]) {
  double square = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double off = (double)x[j] * (double)L[k] - (double)x[k] * (double)L[j] - (double)L[3 + i];
    square += off * off;
  }
  return sqrt(square);
}

static double sine_of(const real A[6], const real B[6]) {
  double square = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double n = (double)A[j] * (double)B[k] - (double)A[k] * (double)B[j];
    square += n * n;
  }
  return sqrt(square);
}

static void test_a_line_from_points_runs_from_the_first_to_the_second(void) {
  const real a[3] = {1, 2, 3}, b[3] = {1, 2, 5}, expected[6] = {0, 0, 1, 2, -1, 0}, raw[6] = {0, 0, 2, 4, -2, 0};
  real L[6];
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_points)(a, b, L));
  for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(expected[i] == L[i]);
  FN(chs_line_raw_from_points)(a, b, L);
  for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(raw[i] == L[i]);
}

static void test_points_of_a_line_lie_on_it(void) {
  for (int k = 0; k < CASES; k++) {
    real a[3], b[3], L[6], raw[6], made[6];
    random_vector(log_uniform(1e-3, 1e3), a);
    random_vector(log_uniform(1e-3, 1e3), b);
    ASSERT_STATUS(CHS_OK, FN(chs_line_from_points)(a, b, L));
    double reach = length_of(a, 3) + length_of(b, 3);
    double error = CHS_EPS_LINE_FROM_POINTS_MOMENT + CHS_EPS_LINE_FROM_POINTS_DIRECTION;
    ASSERT_WITHIN_EPS(0, off_line(L, a), error, reach);
    ASSERT_WITHIN_EPS(0, off_line(L, b), error, reach);
    FN(chs_line_raw_from_points)(a, b, raw);
    ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(raw, made));
    ASSERT_NORM_WITHIN_EPS(L, made, 3, CHS_EPS_LINE_NORMALIZE_DIRECTION + CHS_EPS_LINE_FROM_POINTS_DIRECTION + 1, 1);
    ASSERT_NORM_WITHIN_EPS(L + 3, made + 3, 3,
                           CHS_EPS_LINE_NORMALIZE_MOMENT + error + CHS_EPS_LINE_RAW_FROM_POINTS_MOMENT +
                               CHS_EPS_LINE_RAW_FROM_POINTS_DIRECTION,
                           reach);
  }
}

static void test_points_that_coincide_make_no_line(void) {
  const real a[3] = {1, 2, 3}, next[3] = {1, 2, NEXT_AFTER(3, 4)};
  real L[6];
  ASSERT_REFUSES(CHS_ERR_COINCIDENT, L, FN(chs_line_from_points)(a, a, L));
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_points)(a, next, L)); /* as near as can be, and as exact as any */
  TEST_ASSERT_TRUE(L[0] == 0 && L[1] == 0 && L[2] == 1);
}

static void test_a_direction_of_zero_makes_no_line(void) {
  const real p[3] = {1, 2, 3}, zero[3] = {0, -K(0.0), 0}, raw[6] = {0, 0, 0, 1, 2, 3};
  real L[6];
  ASSERT_REFUSES(CHS_ERR_SINGULAR, L, FN(chs_line_from_direction)(p, zero, L));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, L, FN(chs_line_normalize)(raw, L));
}

static void test_normalize_leaves_a_unit_line_and_undoes_any_factor(void) {
  for (int k = 0; k < CASES; k++) {
    real L[6], raw[6], back[6];
    random_line(2, L);
    scaled(log_uniform(PICK(1e-200, 1e-25), PICK(1e200, 1e25)), L, 6, raw);
    ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(raw, back));
    ASSERT_NORM_WITHIN_EPS(L, back, 3, CHS_EPS_LINE_NORMALIZE_DIRECTION + CHS_EPS_LINE_FROM_DIRECTION_DIRECTION + 1, 1);
    ASSERT_NORM_WITHIN_EPS(L + 3, back + 3, 3, CHS_EPS_LINE_NORMALIZE_MOMENT + CHS_EPS_LINE_FROM_DIRECTION_MOMENT + 1,
                           2);
  }
}

static void test_normalize_resolves_subnormal_directions(void) {
  const real small[6] = {3 * SMALLEST, 0, 4 * SMALLEST, 0, 10 * SMALLEST, 0},
             expected[6] = {K(0.6), 0, K(0.8), 0, 2, 0};
  const real mixed[6] = {0, 0, 2 * SMALLEST, SMALLEST * PICK(0x1p500, 0x1p100F), 0, 0};
  real L[6];
  ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(small, L));
  ASSERT_ENTRIES_WITHIN_EPS(expected, L, 6, CHS_EPS_LINE_NORMALIZE_MOMENT, 2);
  ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(mixed, L));
  TEST_ASSERT_TRUE(L[2] == 1 && L[3] == (real)PICK(0x1p499, 0x1p99F));
}

static void test_normalize_takes_out_what_the_moment_has_along_the_line(void) {
  const real raw[6] = {0, 0, 2, 4, 6, 8}, expected[6] = {0, 0, 1, 2, 3, 0};
  real L[6];
  ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(raw, L));
  ASSERT_SAME_BITS(expected, L, 6);
}

static void test_a_moved_line_goes_through_the_moved_points(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], p[3], d[3], q[3], L[6], moved[6], twist[6], expected[6];
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-99, 99, 3, p);
    random_integers(-99, 99, 3, d);
    for (int i = 0; i < 3; i++) q[i] = p[i] + d[i];
    FN(chs_line_raw_from_points)(p, q, L);
    FN(chs_line_move)(T, L, moved);
    FN(chs_se3_apply)(T, p, p);
    FN(chs_se3_apply)(T, q, q);
    FN(chs_line_raw_from_points)(p, q, expected); /* integers: exact */
    for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(expected[i] == moved[i]);
    FN(chs_se3_adjoint_twist)(T, L, twist);
    ASSERT_SAME_BITS(twist, moved, 6);
  }
}

/* A turn about a line is the twist of its coordinates. */
static void test_a_line_is_the_twist_of_a_turn_about_it(void) {
  for (int k = 0; k < CASES; k++) {
    real L[6], V[6], T[16], x[3], y[3];
    random_line(1, L);
    scaled(2, L, 6, V);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
    random_vector(1, x);
    ASSERT_STATUS(CHS_OK, FN(chs_line_project)(L, x, x, NULL));
    FN(chs_se3_apply)(T, x, y);
    ASSERT_NORM_WITHIN_EPS(x, y, 3, 2 * CHS_EPS_LINE_PROJECT_FOOT * 2 + 40, 1);
  }
}

static void test_the_foot_is_the_nearest_point_of_the_line(void) {
  for (int k = 0; k < CASES; k++) {
    real L[6], x[3], foot[3], distance, apart[3];
    double reach = log_uniform(1e-2, 1e2), away = log_uniform(1e-2, 1e2), both = reach + away;
    random_line(reach, L);
    random_vector(away, x);
    ASSERT_STATUS(CHS_OK, FN(chs_line_project)(L, x, foot, &distance));
    ASSERT_WITHIN_EPS(0, off_line(L, foot), CHS_EPS_LINE_PROJECT_FOOT + 3, both);
    for (int i = 0; i < 3; i++) apart[i] = foot[i] - x[i];
    ASSERT_WITHIN_EPS(0, dot_of(L, apart, 3), 2 * CHS_EPS_LINE_PROJECT_FOOT, both);
    ASSERT_WITHIN_EPS(off_line(L, x), distance, CHS_EPS_LINE_PROJECT_DISTANCE + 3, both);
    ASSERT_WITHIN_EPS(length_of(apart, 3), distance, CHS_EPS_LINE_PROJECT_DISTANCE + CHS_EPS_LINE_PROJECT_FOOT + 1,
                      both);
  }
}

static void test_the_angle_of_lines_is_that_of_their_directions(void) {
  for (int k = 0; k < CASES; k++) {
    double theta = k % 6 == 5 ? PI : random_angle(k);
    const real A[6] = {1, 0, 0, 0, 1, 2}, B[6] = {rounded(cos(theta)), rounded(sin(theta)), 0, 0, 0, 5};
    const real up[3] = {0, 0, 1}, down[3] = {3, 0, -1}, none[3] = {0, 0, 0}, aside[3] = {1, 2, 0};
    real angle;
    /* B's entries are rounded: near pi by what a sine of PI is. */
    double expected = atan2((double)B[1], (double)B[0]);
    ASSERT_STATUS(CHS_OK, FN(chs_line_angle)(A, B, &angle));
    ASSERT_WITHIN_EPS(expected, angle, CHS_EPS_LINE_ANGLE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, up, &angle));
    ASSERT_WITHIN_EPS(expected, angle, CHS_EPS_LINE_ANGLE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, down, &angle));
    ASSERT_WITHIN_EPS(-expected, angle, CHS_EPS_LINE_ANGLE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(B, A, up, &angle));
    ASSERT_WITHIN_EPS(-expected, angle, CHS_EPS_LINE_ANGLE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, none, &angle));
    ASSERT_WITHIN_EPS(expected, angle, CHS_EPS_LINE_ANGLE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, aside, &angle));
    ASSERT_WITHIN_EPS(expected, angle, CHS_EPS_LINE_ANGLE, expected);
  }
}

static void test_a_vector_in_the_plane_of_two_lines_counts_as_positive_however_it_is_rounded(void) {
  for (int k = 0; k < 10 * CASES; k++) {
    real A[6], B[6], between[3], angle;
    random_line(1, A);
    random_line(1, B);
    if (k % 2) {
      real a[3], step[3];
      random_vector(log_uniform(4 * EPS, 1), step);
      for (int i = 0; i < 3; i++) a[i] = A[i] + step[i];
      ASSERT_STATUS(CHS_OK, FN(chs_line_from_direction)(A + 3, a, B));
    }
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, A, &angle));
    TEST_ASSERT_TRUE(angle >= 0);
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(A, B, B, &angle));
    TEST_ASSERT_TRUE(angle >= 0);
    for (int i = 0; i < 3; i++) between[i] = A[i] + B[i];
    ASSERT_STATUS(CHS_OK, FN(chs_line_signed_angle)(B, A, between, &angle));
    if (length_of(between, 3) > 0.5) TEST_ASSERT_TRUE(angle >= 0);
  }
}

/* Two rounded directions that differ in their last bits: the angle has all its digits. */
static void test_the_smallest_angle_of_rounded_directions_is_exact(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], B[6], angle;
    random_line(1, A);
    memcpy(B, A, sizeof A);
    int i = k % 3, j = (i + 1) % 3, m = (i + 2) % 3;
    B[i] = NEXT_AFTER(B[i], 2);
    /* |A x (B - A)| = |step| hypot(A_j, A_m), and |A| |B| = 1 to eps */
    double expected = fabs((double)B[i] - (double)A[i]) * hypot((double)A[j], (double)A[m]);
    ASSERT_STATUS(CHS_OK, FN(chs_line_angle)(A, B, &angle));
    ASSERT_WITHIN_EPS(expected, angle, CHS_EPS_LINE_ANGLE + 2 * CHS_EPS_LINE_FROM_DIRECTION_DIRECTION, expected);
  }
}

static void test_known_perpendiculars(void) {
  const struct {
    const char *name;
    int status;
    real A[6], B[6], X[3], foot_a[3], foot_b[3];
    double angle, distance;
  } known[] = {
      {"skew", CHS_OK, {1, 0, 0, 0, 0, 0}, {0, 1, 0, -2, 0, 3}, {0, 0, 1}, {3, 0, 0}, {3, 0, 2}, PI / 2, 2},
      {"skew, the other way",
       CHS_OK,
       {0, 1, 0, -2, 0, 3},
       {1, 0, 0, 0, 0, 0},
       {0, 0, -1},
       {3, 0, 2},
       {3, 0, 0},
       PI / 2,
       2},
      {"skew, below", CHS_OK, {1, 0, 0, 0, 0, 0}, {0, 1, 0, 2, 0, 3}, {0, 0, -1}, {3, 0, 0}, {3, 0, -2}, -PI / 2, 2},
      {"meeting",
       CHS_INTERSECTING,
       {1, 0, 0, 0, 3, -2},
       {0, 1, 0, -3, 0, 1},
       {0, 0, 1},
       {1, 2, 3},
       {1, 2, 3},
       PI / 2,
       0},
      {"meeting in the origin",
       CHS_INTERSECTING,
       {0, 1, 0, 0, 0, 0},
       {1, 0, 0, 0, 0, 0},
       {0, 0, -1},
       {0, 0, 0},
       {0, 0, 0},
       PI / 2,
       0},
      {"parallel", CHS_PARALLEL, {0, 0, 1, 0, -1, 0}, {0, 0, 1, 0, -4, 0}, {1, 0, 0}, {1, 0, 0}, {4, 0, 0}, 0, 3},
      {"antiparallel", CHS_PARALLEL, {0, 0, 1, 0, -1, 0}, {0, 0, -1, -2, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 2, 0}, PI, 2},
      {"coincident", CHS_COINCIDENT, {0, 0, 1, 0, -1, 0}, {0, 0, 1, 0, -1, 0}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, 0, 0},
      {"coincident, back",
       CHS_COINCIDENT,
       {1, 0, 0, 0, 0, 0},
       {-1, 0, 0, 0, 0, 0},
       {0, 1, 0},
       {0, 0, 0},
       {0, 0, 0},
       PI,
       0},
  };
  for (int k = 0; k < LENGTH(known); k++) {
    perpendicular p;
    real distance;
    subject = known[k].name;
    ASSERT_STATUS(known[k].status, perpendicular_of(known[k].A, known[k].B, &p));
    ASSERT_STATUS(known[k].status, FN(chs_line_distance)(known[k].A, known[k].B, &distance));
    ASSERT_SAME_BITS(&distance, &p.distance, 1);
    ASSERT_NORM_WITHIN_EPS(known[k].X, p.X, 3, 0, 1);
    ASSERT_NORM_WITHIN_EPS(known[k].foot_a, p.foot_a, 3, 0, 1);
    ASSERT_NORM_WITHIN_EPS(known[k].foot_b, p.foot_b, 3, 0, 1);
    ASSERT_WITHIN_EPS(known[k].angle, p.angle, 1, fabs(known[k].angle));
    ASSERT_WITHIN_EPS(known[k].distance, p.distance, 0, 1);
  }
}

/* The perpendicular meets both lines at a right angle, at its feet, and takes one to the other. */
static void test_the_perpendicular_is_one(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], B[6], moved[6], V[6] = {0}, screw_motion[16], p3[3];
    perpendicular p;
    double reach = log_uniform(1e-2, 1e2);
    random_line(reach, A);
    random_line(log_uniform(1e-2, 1e2), B);
    double far = length_of(A + 3, 3) + length_of(B + 3, 3), s = sine_of(A, B), scale = far / s;
    int status = perpendicular_of(A, B, &p);
    if (s < 0.01) continue;
    ASSERT_STATUS(CHS_OK, status);
    const double foot = CHS_EPS_LINE_PERPENDICULAR_FOOT, direction = CHS_EPS_LINE_PERPENDICULAR_DIRECTION;
    ASSERT_WITHIN_EPS(0, dot_of(p.X, A, 3), direction + 1, 1);
    ASSERT_WITHIN_EPS(0, dot_of(p.X, B, 3), direction + 1, 1);
    ASSERT_WITHIN_EPS(0, off_line(A, p.foot_a), foot + 4, scale);
    ASSERT_WITHIN_EPS(0, off_line(B, p.foot_b), foot + 4, scale);
    ASSERT_WITHIN_EPS(0, off_line(p.X, p.foot_a), foot + CHS_EPS_LINE_PERPENDICULAR_MOMENT + direction, 2 * scale);
    ASSERT_WITHIN_EPS(0, off_line(p.X, p.foot_b), foot + CHS_EPS_LINE_PERPENDICULAR_MOMENT + direction, 2 * scale);
    TEST_ASSERT_TRUE(p.distance >= 0);
    for (int i = 0; i < 3; i++) p3[i] = rounded((double)p.foot_a[i] + (double)p.distance * (double)p.X[i]);
    ASSERT_NORM_WITHIN_EPS(p.foot_b, p3, 3, 2 * foot + direction + CHS_EPS_LINE_PERPENDICULAR_DISTANCE + 2, 2 * scale);

    /* A screw about X by the angle, along it by the distance, moves A onto B. */
    scaled((double)p.angle, p.X, 6, V);
    for (int i = 0; i < 3; i++) V[3 + i] += p.distance * p.X[i];
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, screw_motion));
    FN(chs_line_move)(screw_motion, A, moved);
    ASSERT_NORM_WITHIN_EPS(B, moved, 3, 40, 1);
    ASSERT_NORM_WITHIN_EPS(B + 3, moved + 3, 3, 120, scale);
  }
}

static void test_the_perpendicular_turns_round_with_the_lines_exchanged(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], B[6];
    perpendicular p, q;
    random_line(1, A);
    random_line(1, B);
    if (perpendicular_of(A, B, &p) != CHS_OK) continue;
    ASSERT_STATUS(CHS_OK, perpendicular_of(B, A, &q));
    for (int i = 0; i < 6; i++) q.X[i] = -q.X[i];
    double scale = 2 / sine_of(A, B);
    ASSERT_NORM_WITHIN_EPS(p.X, q.X, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_DIRECTION, 1);
    ASSERT_NORM_WITHIN_EPS(p.X + 3, q.X + 3, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_MOMENT, scale);
    ASSERT_NORM_WITHIN_EPS(p.foot_a, q.foot_b, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_FOOT, scale);
    ASSERT_SAME_BITS(&p.angle, &q.angle, 1);
    ASSERT_SAME_BITS(&p.distance, &q.distance, 1);
  }
}

/* Nearly parallel lines are skew all the same, down to eps. */
static void test_nearly_parallel_lines_have_their_perpendicular(void) {
  for (int k = 0; k < CASES; k++) {
    double tilt = log_uniform(32 * EPS, 1e-3), at = uniform(-2, 2), height = uniform(0.5, 2);
    /* The x axis, and a line that passes over it at x = at and the height, the directions apart by the tilt. */
    const real A[6] = {1, 0, 0, 0, 0, 0};
    real B[6];
    perpendicular p;
    B[0] = rounded(cos(tilt));
    B[1] = rounded(sin(tilt));
    B[2] = 0;
    B[3] = rounded(-height * (double)B[1]);
    B[4] = rounded(height * (double)B[0]);
    B[5] = rounded(at * (double)B[1]);
    ASSERT_STATUS(CHS_OK, perpendicular_of(A, B, &p));
    double scale = height / (double)B[1];
    ASSERT_WITHIN_EPS(height, p.distance, CHS_EPS_LINE_PERPENDICULAR_DISTANCE + 1, scale);
    ASSERT_WITHIN_EPS(at, p.foot_a[0], CHS_EPS_LINE_PERPENDICULAR_FOOT + 1, scale);
    ASSERT_WITHIN_EPS(tilt, p.angle, CHS_EPS_LINE_PERPENDICULAR_ANGLE + 1, tilt);
  }
}

/* The header's limits, 8 eps of the sine and 8 eps M of the distance, from below and from above. */
static void test_parallel_meeting_and_coincident_lines_are_told_to_eight_eps(void) {
  for (int k = 1; k <= 16; k++) {
    if (k == 8) continue;
    const real off = (real)(k * EPS), x_axis[6] = {1, 0, 0, 0, 0, 0}, beside[6] = {1, 0, 0, 0, 0, -1};
    const real leaning[6] = {1, off, 0, 0, 0, -1};         /* through (0, 1, 0), where M = 1 */
    const real above[6] = {0, 1, 0, -off, 0, 1};           /* through (1, 0, off), where M = 1 */
    const real farther[6] = {1, 0, 0, 0, 0, -1 - 2 * off}; /* M = 2 */
    const struct {
      const real *A, *B;
      int below;
    } pairs[] = {{x_axis, leaning, CHS_PARALLEL}, {x_axis, above, CHS_INTERSECTING}, {beside, farther, CHS_COINCIDENT}};
    for (int i = 0; i < LENGTH(pairs); i++) {
      int expected = k < 8 ? pairs[i].below : i == 0 ? CHS_INTERSECTING : i == 1 ? CHS_OK : CHS_PARALLEL;
      perpendicular p;
      real distance;
      ASSERT_STATUS(expected, FN(chs_line_distance)(pairs[i].A, pairs[i].B, &distance));
      ASSERT_STATUS(expected, perpendicular_of(pairs[i].A, pairs[i].B, &p));
      ASSERT_SAME_BITS(&distance, &p.distance, 1);
    }
  }
}

static void test_lines_with_a_direction_that_is_not_of_unit_length_are_refused(void) {
  const real bad[4][6] = {{2, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 1, 0}, {0, K(0.98), 0, 0, 0, 0}, {REAL_MAX, 0, 0, 0, 0, 0}};
  const real good[6] = {0, 0, 1, 1, 0, 0}, x[3] = {1, 2, 3};
  for (int k = 0; k < LENGTH(bad); k++) {
    perpendicular p;
    real foot[3], angle, distance;
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, foot, FN(chs_line_project)(bad[k], x, foot, NULL));
    for (int side = 0; side < 2; side++) {
      const real *A = side ? good : bad[k], *B = side ? bad[k] : good;
      ASSERT_REFUSES(CHS_ERR_ARGUMENT, angle, FN(chs_line_angle)(A, B, &angle));
      ASSERT_REFUSES(CHS_ERR_ARGUMENT, angle, FN(chs_line_signed_angle)(A, B, x, &angle));
      ASSERT_REFUSES(CHS_ERR_ARGUMENT, distance, FN(chs_line_distance)(A, B, &distance));
      ASSERT_REFUSES(CHS_ERR_ARGUMENT, p, perpendicular_of(A, B, &p));
    }
  }
}

static void test_a_direction_that_is_a_little_long_counts_as_the_unit_one(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], B[6], longer[6];
    perpendicular p, q;
    random_line(1, A);
    random_line(1, B);
    scaled(uniform(0.996, 1.004), B, 6, longer);
    if (perpendicular_of(A, B, &p) != CHS_OK) continue;
    ASSERT_STATUS(CHS_OK, perpendicular_of(A, longer, &q));
    double s = sine_of(A, B), scale = 2 / s;
    ASSERT_NORM_WITHIN_EPS(p.X, q.X, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_DIRECTION + 2 / s, 1);
    ASSERT_NORM_WITHIN_EPS(p.foot_b, q.foot_b, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_FOOT + 4 / s, scale);
    ASSERT_WITHIN_EPS(p.angle, q.angle, 2 * CHS_EPS_LINE_PERPENDICULAR_ANGLE + 2 / s, PI);
    ASSERT_WITHIN_EPS(p.distance, q.distance, 2 * CHS_EPS_LINE_PERPENDICULAR_DISTANCE + 4 / s, scale);
  }
}

static void test_coincident_lines_that_are_a_little_long_have_their_perpendicular_at_a_right_angle(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], longer[6];
    perpendicular p, q;
    random_line(1, A);
    scaled(uniform(0.996, 1.004), A, 6, longer);
    ASSERT_STATUS(CHS_COINCIDENT, perpendicular_of(A, A, &p));
    ASSERT_STATUS(CHS_COINCIDENT, perpendicular_of(longer, longer, &q));
    ASSERT_WITHIN_EPS(0, dot_of(A, q.X, 3), 2 * CHS_EPS_LINE_PERPENDICULAR_DIRECTION, 1);
    ASSERT_NORM_WITHIN_EPS(p.X, q.X, 3, 2 * CHS_EPS_LINE_PERPENDICULAR_DIRECTION + 2, 1);
  }
}

static void test_outputs_of_the_perpendicular_may_be_left_out(void) {
  real A[6], B[6], X[6];
  perpendicular p;
  random_line(1, A);
  random_line(1, B);
  ASSERT_STATUS(CHS_OK, perpendicular_of(A, B, &p));
  ASSERT_STATUS(CHS_OK, FN(chs_line_perpendicular)(A, B, X, NULL, NULL, NULL, NULL));
  ASSERT_SAME_BITS(p.X, X, 6);
}

/* Eq. 9 of the notes gives the moment times s^2, as the sines it is made of show. */
static void test_the_moment_is_that_of_equation_9_over_the_squared_sine(void) {
  for (int k = 0; k < CASES; k++) {
    real A[6], B[6], m[3];
    perpendicular p;
    random_line(1, A);
    random_line(1, B);
    double s = sine_of(A, B), c = dot_of(A, B, 3);
    if (s < 0.1 || perpendicular_of(A, B, &p) != CHS_OK) continue;
    double xa = dot_of(p.X, A + 3, 3), xb = dot_of(p.X, B + 3, 3);
    for (int i = 0; i < 3; i++) m[i] = rounded(((c * xb - xa) * (double)A[i] + (c * xa - xb) * (double)B[i]) / (s * s));
    ASSERT_NORM_WITHIN_EPS(m, p.X + 3, 3, 10 * CHS_EPS_LINE_PERPENDICULAR_MOMENT, 2 / (s * s));
  }
}

/* A line of |m| = reach, no entry of m above 1.9, and the same with its moment enlarged. */
static void line_and_large(double reach, const real d[3], real L[6], real large[6]) {
  const real up = (real)PICK(0x1p+1023, 0x1p+127);
  do {
    real p[3];
    random_vector(reach, p);
    ASSERT_STATUS(CHS_OK, FN(chs_line_from_direction)(p, d, L));
  } while (fabs((double)L[3]) > 1.9 || fabs((double)L[4]) > 1.9 || fabs((double)L[5]) > 1.9);
  for (int i = 0; i < 6; i++) large[i] = i < 3 ? L[i] : L[i] * up;
}

/* Where |m| is beyond the range the answer is that of small lines, enlarged, or an overflow. */
static void test_the_largest_moments_are_told_like_small_ones(void) {
  int beyond = 0;
  for (int k = 0; k < 10 * CASES; k++) {
    real A[6], B[6], large_A[6], large_B[6], d[3], e[3], small, distance;
    random_vector(1, d);
    random_vector(1, e);
    line_and_large(uniform(0.1, 3), d, A, large_A);
    line_and_large(uniform(0.1, 3), k % 3 == 1 ? d : e, B, large_B);
    if (k % 3 == 2) memcpy(B, A, sizeof B), memcpy(large_B, large_A, sizeof large_B);
    double M = length_of(A + 3, 3) + length_of(B + 3, 3);
    int status = FN(chs_line_distance)(A, B, &small), answer = FN(chs_line_distance)(large_A, large_B, &distance);
    if (answer == CHS_ERR_OVERFLOW && (M > 1 || small >= 2)) continue;
    ASSERT_STATUS(status, answer);
    small *= (real)PICK(0x1p+1023, 0x1p+127);
    ASSERT_SAME_BITS(&small, &distance, 1);
    beyond += length_of(A + 3, 3) > 2;
  }
  TEST_ASSERT_GREATER_THAN(0, beyond);
}

static void test_lengths_beyond_the_range_are_an_overflow(void) {
  const real A[6] = {0, 0, 1, REAL_MAX, 0, 0}, B[6] = {0, 0, 1, -REAL_MAX, 0, 0};
  const real a[3] = {REAL_MAX, 0, 0}, b[3] = {-REAL_MAX, 0, 0}, x[3] = {0, -REAL_MAX, 0};
  const real d[3] = {1, 1, 0}, corner[3] = {REAL_MAX, -REAL_MAX, 0}, raw[6] = {K(0.25), 0, 0, 0, REAL_MAX, 0};
  perpendicular p;
  real L[6], distance, foot[3];
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, L, FN(chs_line_from_points)(a, b, L));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, L, FN(chs_line_from_direction)(corner, d, L));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, L, FN(chs_line_normalize)(raw, L));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, distance, FN(chs_line_distance)(A, B, &distance));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, p, perpendicular_of(A, B, &p));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, foot, FN(chs_line_project)(A, x, foot, NULL));

  /* Two lines that meet in (0.9, 0.9, 0) REAL_MAX: all is within the range but the moment of their perpendicular. */
  const real slope = K(0.714), side = K(0.495), reach = K(0.9) * slope * REAL_MAX;
  const real up[6] = {side, side, slope, reach, -reach, 0}, down[6] = {side, side, -slope, -reach, reach, 0};
  ASSERT_STATUS(CHS_INTERSECTING, FN(chs_line_distance)(up, down, &distance));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, p, perpendicular_of(up, down, &p));
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_a_line_from_points_runs_from_the_first_to_the_second);
  RUN_TEST(test_points_of_a_line_lie_on_it);
  RUN_TEST(test_points_that_coincide_make_no_line);
  RUN_TEST(test_a_direction_of_zero_makes_no_line);
  RUN_TEST(test_normalize_leaves_a_unit_line_and_undoes_any_factor);
  RUN_TEST(test_normalize_resolves_subnormal_directions);
  RUN_TEST(test_normalize_takes_out_what_the_moment_has_along_the_line);
  RUN_TEST(test_a_moved_line_goes_through_the_moved_points);
  RUN_TEST(test_a_line_is_the_twist_of_a_turn_about_it);
  RUN_TEST(test_the_foot_is_the_nearest_point_of_the_line);
  RUN_TEST(test_the_angle_of_lines_is_that_of_their_directions);
  RUN_TEST(test_a_vector_in_the_plane_of_two_lines_counts_as_positive_however_it_is_rounded);
  RUN_TEST(test_the_smallest_angle_of_rounded_directions_is_exact);
  RUN_TEST(test_known_perpendiculars);
  RUN_TEST(test_the_perpendicular_is_one);
  RUN_TEST(test_the_perpendicular_turns_round_with_the_lines_exchanged);
  RUN_TEST(test_nearly_parallel_lines_have_their_perpendicular);
  RUN_TEST(test_parallel_meeting_and_coincident_lines_are_told_to_eight_eps);
  RUN_TEST(test_lines_with_a_direction_that_is_not_of_unit_length_are_refused);
  RUN_TEST(test_a_direction_that_is_a_little_long_counts_as_the_unit_one);
  RUN_TEST(test_coincident_lines_that_are_a_little_long_have_their_perpendicular_at_a_right_angle);
  RUN_TEST(test_outputs_of_the_perpendicular_may_be_left_out);
  RUN_TEST(test_the_moment_is_that_of_equation_9_over_the_squared_sine);
  RUN_TEST(test_the_largest_moments_are_told_like_small_ones);
  RUN_TEST(test_lengths_beyond_the_range_are_an_overflow);
  return SUITE_END();
}
