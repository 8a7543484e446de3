#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                        \
  CHECKED(screw_from_pose, "T", "S", (in[0], SCREW_AT(out[0])))          \
  CHECKED(screw_to_pose, "S", "T", (CONST_SCREW_AT(in[0]), out[0]))      \
  CHECKED(screw_pitch, "H", "a", (CONST_SCREW_AT(in[0]), out[0]))        \
  CHECKED(screw_helical, "xxt", "V", (in[0], in[1], in[2][0], out[0]))   \
  CHECKED(screw_revolute, "xx", "V", (in[0], in[1], out[0]))             \
  CHECKED(screw_prismatic, "x", "V", (in[0], out[0]))                    \
  CHECKED(screw_axis_parts, "V", "xxa", (in[0], out[0], out[1], out[2])) \
  CHECKED(screw_axis_pitch, "V", "a", (in[0], out[0]))                   \
  CHECKED(screw_axis_line, "V", "L", (in[0], out[0]))                    \
  CHECKED(screw_normalize, "V", "Va", (in[0], out[0], out[1]))           \
  PLAIN(screw_twist, "Va", "V", (in[0], in[1][0], out[0]))               \
  PLAIN(screw_reciprocal, "VV", "a", (in[0], in[1], out[0]))             \
  CHECKED(screw_move_body, "TVa", "T", (in[0], in[1], in[2][0], out[0])) \
  CHECKED(screw_move_space, "TVa", "T", (in[0], in[1], in[2][0], out[0]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

static const double to_pose_in_norm = 3 * CHS_EPS_SCREW_TO_POSE_ROTATION;
static const double to_pose_as_angle = 3 * CHS_EPS_SCREW_TO_POSE_ROTATION / 1.4142135623730951;

static void pose_of(const real R[9], real x, real y, real z, real T[16]) {
  const real p[3] = {x, y, z};
  FN(chs_se3_from_parts)(R, p, T);
}

static screw screw_of(real ex, real ey, real ez, real x, real y, real z, real translation, real angle) {
  screw s = {{ex, ey, ez}, {x, y, z}, translation, angle};
  return s;
}

static void random_screw(double angle, double reach, double translation, screw *s) {
  real any[3], across[3];
  random_vector(1, s->axis);
  random_vector(1, any);
  cross_of(s->axis, any, across);
  scaled(reach / length_of(across, 3), across, 3, s->point);
  s->translation = (real)translation;
  s->angle = (real)angle;
}

static void test_the_identity_is_no_motion_along_z(void) {
  const screw expected = screw_of(0, 0, 1, 0, 0, 0, 0, 0);
  screw s;
  ASSERT_STATUS(CHS_NO_MOTION, FN(chs_screw_from_pose)(identity4, &s));
  ASSERT_SAME_BITS(expected.axis, s.axis, 8);
}

static void test_a_translation_is_a_screw_along_it_through_the_origin(void) {
  const real zero[3] = {0, 0, 0};
  for (int k = 0; k < CASES; k++) {
    real p[3], T[16], e[3];
    screw s;
    double length = log_uniform(PICK(1e-307, 1e-37), PICK(1e307, 1e37));
    random_vector(length, p);
    FN(chs_se3_from_parts)(identity3, p, T);
    ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_from_pose)(T, &s));
    length = length_of(p, 3);
    scaled(1 / length, p, 3, e);
    ASSERT_NORM_WITHIN_EPS(e, s.axis, 3, CHS_EPS_SCREW_FROM_POSE_AXIS + 1, 1);
    ASSERT_SAME_BITS(zero, s.point, 3);
    ASSERT_WITHIN_EPS(length, s.translation, CHS_EPS_SCREW_FROM_POSE_TRANSLATION, length);
    ASSERT_SAME_BITS(zero, &s.angle, 1);
  }
}

static void test_the_direction_of_subnormal_translations_is_resolved(void) {
  const real R3 = (real)(1 / sqrt(3)), expected[3] = {R3, -R3, R3};
  real T[16];
  screw s;
  pose_of(identity3, SMALLEST, -SMALLEST, SMALLEST, T);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_from_pose)(T, &s));
  ASSERT_NORM_WITHIN_EPS(expected, s.axis, 3, CHS_EPS_SCREW_FROM_POSE_AXIS + 1, 1);
}

static void test_a_quarter_turn_about_a_line_parallel_to_z(void) {
  const real R[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  const screw expected = screw_of(0, 0, 1, 1, 2, 0, 5, REAL_PI / 2);
  real T[16];
  screw s;
  pose_of(R, 3, 1, 5, T); /* takes (1, 2, 0) to (1, 2, 5) */
  ASSERT_STATUS(CHS_OK, FN(chs_screw_from_pose)(T, &s));
  double p = sqrt(35);
  ASSERT_NORM_WITHIN_EPS(expected.axis, s.axis, 3, CHS_EPS_SCREW_FROM_POSE_AXIS, 1);
  ASSERT_NORM_WITHIN_EPS(expected.point, s.point, 3, CHS_EPS_SCREW_FROM_POSE_POINT, p / (2 * sin(PI / 4)));
  ASSERT_WITHIN_EPS(5, s.translation, CHS_EPS_SCREW_FROM_POSE_TRANSLATION, p);
  ASSERT_WITHIN_EPS(PI / 2, s.angle, CHS_EPS_SCREW_FROM_POSE_ANGLE, PI / 2);
}

static void test_a_half_turn_has_an_axis_whose_first_component_is_positive(void) {
  for (int k = 0; k < CASES; k++) {
    turn q = random_turn(0);
    real R[9], T[16], e[3], p[3];
    screw s;
    turn_matrix(&q, R);
    turn_axis(&q, e);
    random_integers(-9, 9, 3, p);
    FN(chs_se3_from_parts)(R, p, T);
    ASSERT_STATUS(CHS_HALF_TURN, FN(chs_screw_from_pose)(T, &s));
    double along = dot_of(e, p, 3), length = length_of(p, 3);
    /* R is rounded by eps/2 in each entry: the axis turns by 3/2 eps / (2 sqrt(2)). */
    double axis = CHS_EPS_SCREW_FROM_POSE_AXIS + 1.5 / (2 * sqrt(2)) + 1;
    ASSERT_NORM_WITHIN_EPS(e, s.axis, 3, axis, 1);
    real point[3];
    for (int i = 0; i < 3; i++) point[i] = rounded(((double)p[i] - along * (double)e[i]) / 2);
    ASSERT_NORM_WITHIN_EPS(point, s.point, 3, CHS_EPS_SCREW_FROM_POSE_POINT + axis + 1, length / 2);
    ASSERT_WITHIN_EPS(along, s.translation, CHS_EPS_SCREW_FROM_POSE_TRANSLATION + axis, length);
    ASSERT_WITHIN_EPS(PI, s.angle, CHS_EPS_SCREW_FROM_POSE_ANGLE + 1, PI);
    TEST_ASSERT_TRUE((double)s.angle <= (double)REAL_PI);
  }
}

/* pi - theta = skew, about x or against it: the status is that of chs_so3_log, the sense that of the skew part. */
static void test_next_to_a_half_turn_the_skew_part_decides(void) {
  for (int k = 0; k < 2 * 12; k++) {
    real skew = (real)((k / 2 + 1) * 0.25 * EPS), sign = k % 2 ? -1 : 1;
    const real R[9] = {1, 0, 0, 0, -1, -sign * skew, 0, sign * skew, -1};
    real T[16], w[3];
    screw s;
    pose_of(R, 1, 2, 3, T);
    ASSERT_STATUS((double)skew <= 2 * EPS ? CHS_HALF_TURN : CHS_OK, FN(chs_screw_from_pose)(T, &s));
    ASSERT_STATUS((double)skew <= 2 * EPS ? CHS_HALF_TURN : CHS_OK, FN(chs_so3_log)(R, w));
    TEST_ASSERT_TRUE(s.axis[0] == sign);
    TEST_ASSERT_TRUE(sign * w[0] > 3);
    ASSERT_WITHIN_EPS(1, s.translation * sign, CHS_EPS_SCREW_FROM_POSE_TRANSLATION, sqrt(14));
  }
}

static void test_the_point_is_the_one_nearest_to_the_origin(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16];
    screw s;
    double reach = log_uniform(PICK(1e-250, 1e-25), PICK(1e250, 1e25));
    random_pose(reach, T);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_screw_from_pose)(T, &s));
    double scale = reach / (2 * sin((double)s.angle / 2));
    real unit_point[3];
    scaled(1 / scale, s.point, 3, unit_point);
    ASSERT_WITHIN_EPS(0, dot_of(s.axis, unit_point, 3),
                      CHS_EPS_SCREW_FROM_POSE_POINT + CHS_EPS_SCREW_FROM_POSE_AXIS + 1, 1);
    ASSERT_WITHIN_EPS(1, length_of(s.axis, 3), CHS_EPS_SCREW_FROM_POSE_AXIS, 1);
  }
}

static void test_rotation_about_an_axis_out_of_range_is_a_pure_translation(void) {
  const real w[3] = {0, PICK(1e-300, 1e-35F), 0}, p[3] = {K(3e10), 0, 0};
  const screw expected = screw_of(1, 0, 0, 0, 0, 0, K(3e10), 0);
  real R[9], T[16];
  screw s;
  FN(chs_so3_exp)(w, R);
  FN(chs_se3_from_parts)(R, p, T);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_from_pose)(T, &s));
  ASSERT_SAME_BITS(expected.axis, s.axis, 8);
}

static void test_to_pose_takes_back_what_from_pose_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], back[16], R[9], p[3], R_back[9], p_back[3];
    screw s;
    random_pose(log_uniform(PICK(1e-250, 1e-25), PICK(1e250, 1e25)), T);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_screw_from_pose)(T, &s));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&s, back));
    FN(chs_se3_to_parts)(T, R, p);
    FN(chs_se3_to_parts)(back, R_back, p_back);
    double theta = (double)s.angle, chord = 2 * sin(theta / 2), length = length_of(p, 3);
    /* The axis's error counts by the chord 2 sin(theta/2); T is 3 CHS_EPS_SO3_EXP away from a rotation. */
    double rotation =
        CHS_EPS_SCREW_FROM_POSE_AXIS * chord + CHS_EPS_SCREW_FROM_POSE_ANGLE * theta + 3 * CHS_EPS_SO3_EXP;
    ASSERT_ENTRIES_WITHIN_EPS(R, R_back, 9, CHS_EPS_SCREW_TO_POSE_ROTATION + rotation, 1);
    /* p = (I - R) A + u e, where A is no longer than |p| / chord. */
    double promised = CHS_EPS_SCREW_TO_POSE_TRANSLATION * (1 + fmin(theta, 2) / chord) + CHS_EPS_SCREW_FROM_POSE_POINT +
                      CHS_EPS_SCREW_FROM_POSE_TRANSLATION + CHS_EPS_SCREW_FROM_POSE_AXIS;
    ASSERT_NORM_WITHIN_EPS(p, p_back, 3, promised + sqrt(3) * rotation / chord, length);
  }
}

static void test_from_pose_takes_back_what_to_pose_gave(void) {
  for (int k = 0; k < CASES; k++) {
    screw s, back;
    real T[16];
    double scale = log_uniform(PICK(1e-250, 1e-25), PICK(1e250, 1e25));
    random_screw(k % 2 ? uniform(0.1, 3) : random_angle(k / 2), scale * uniform(0.1, 2), scale * uniform(-2, 2), &s);
    if ((double)s.angle < 100 * EPS || (double)s.angle > PI - 100 * EPS) continue; /* to_pose promises eps of 1 */
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&s, T));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_from_pose)(T, &back));
    double theta = (double)s.angle, sine = sin(theta / 2), u = fabs((double)s.translation);
    double p = u + 2 * sine * length_of(s.point, 3), off = u + fmin(theta, 2) * length_of(s.point, 3);
    double axis = CHS_EPS_SCREW_FROM_POSE_AXIS + to_pose_as_angle / (2 * sine) + 1; /* 1: |s.axis| is rounded */
    ASSERT_NORM_WITHIN_EPS(s.axis, back.axis, 3, axis, 1);
    ASSERT_WITHIN_EPS(theta, back.angle, CHS_EPS_SCREW_FROM_POSE_ANGLE * theta + to_pose_as_angle, 1);
    ASSERT_WITHIN_EPS(s.translation, back.translation,
                      (CHS_EPS_SCREW_FROM_POSE_TRANSLATION + axis) * p + CHS_EPS_SCREW_TO_POSE_TRANSLATION * off, 1);
    /* A = 1/2 (p_perp + cot(theta/2) e x p): its derivatives by p, e and theta. */
    double point = CHS_EPS_SCREW_FROM_POSE_POINT * p / (2 * sine) +
                   CHS_EPS_SCREW_TO_POSE_TRANSLATION * off / (2 * sine) + 3 * axis * p / (2 * sine) +
                   to_pose_as_angle * p / (4 * sine * sine);
    ASSERT_NORM_WITHIN_EPS(s.point, back.point, 3, point, 1);
  }
}

static void test_to_pose_leaves_the_points_of_the_axis_on_it(void) {
  for (int k = 0; k < CASES; k++) {
    screw s;
    real T[16], y[3], expected[3];
    random_screw(uniform(-20, 20), uniform(0, 10), uniform(-5, 5), &s);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&s, T));
    FN(chs_se3_apply)(T, s.point, y);
    double u = (double)s.translation, reach = length_of(s.point, 3);
    for (int i = 0; i < 3; i++) expected[i] = rounded((double)s.point[i] + u * (double)s.axis[i]);
    ASSERT_NORM_WITHIN_EPS(expected, y, 3,
                           CHS_EPS_SCREW_TO_POSE_TRANSLATION * (fabs(u) + 2 * reach) + (to_pose_in_norm + 2) * reach +
                               CHS_EPS_SE3_APPLY * (sqrt(3) * reach + fabs(u) + 2 * reach) + fabs(u) + reach,
                           1);
  }
}

static void test_to_pose_is_the_same_for_every_length_of_the_axis(void) {
  for (int k = 0; k < CASES; k++) {
    screw s, longer;
    real T[16], other[16];
    random_screw(uniform(-20, 20), 2, 1, &s);
    longer = s;
    int power = integer(PICK(-1000, -110), PICK(1000, 110));
    for (int i = 0; i < 3; i++) longer.axis[i] = (real)ldexp((double)s.axis[i], power);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&s, T));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&longer, other));
    ASSERT_ENTRIES_WITHIN_EPS(T, other, 16, 2 * CHS_EPS_SCREW_TO_POSE_TRANSLATION, 1 + 2 * 2);
  }
}

static void test_to_pose_is_the_same_for_every_point_of_the_axis(void) {
  for (int k = 0; k < CASES; k++) {
    screw s, shifted;
    real T[16], other[16];
    random_screw(uniform(-20, 20), 1, 1, &s);
    shifted = s;
    double t = uniform(-10, 10);
    for (int i = 0; i < 3; i++) shifted.point[i] += rounded(t * (double)s.axis[i]);
    FN(chs_screw_to_pose)(&s, T);
    FN(chs_screw_to_pose)(&shifted, other);
    double reach = 1 + 2 * length_of(s.point, 3), far = 1 + 2 * length_of(shifted.point, 3);
    ASSERT_ENTRIES_WITHIN_EPS(T, other, 16, CHS_EPS_SCREW_TO_POSE_TRANSLATION, reach + far);
  }
}

static void test_a_screw_seen_from_the_other_end_is_the_same_motion(void) {
  for (int k = 0; k < CASES; k++) {
    screw s, opposite;
    real T[16], other[16];
    random_screw(uniform(0, 20), 1, 1, &s);
    opposite =
        screw_of(-s.axis[0], -s.axis[1], -s.axis[2], s.point[0], s.point[1], s.point[2], -s.translation, -s.angle);
    FN(chs_screw_to_pose)(&s, T);
    FN(chs_screw_to_pose)(&opposite, other);
    ASSERT_SAME_BITS(T, other, 16);
  }
}

static void test_to_pose_agrees_with_exp_of_the_twist(void) {
  for (int k = 0; k < CASES; k++) {
    screw s;
    real T[16], V[6], moment[3], E[16];
    double theta = uniform(0, PI);
    random_screw(theta, 1, 1, &s);
    scaled(theta, s.axis, 3, V);
    cross_of(s.point, s.axis, moment);
    for (int i = 0; i < 3; i++) V[3 + i] = rounded(theta * (double)moment[i] + (double)s.axis[i]);
    FN(chs_screw_to_pose)(&s, T);
    FN(chs_se3_exp)(V, E);
    double twist = 2 * (1 + theta); /* rounding of the twist's entries */
    ASSERT_ENTRIES_WITHIN_EPS(E, T, 16,
                              CHS_EPS_SCREW_TO_POSE_TRANSLATION * (1 + 2) + CHS_EPS_SE3_EXP_TRANSLATION * (1 + theta) +
                                  twist * (1 + theta),
                              1);
  }
}

static void test_no_axis_is_needed_where_nothing_moves(void) {
  const screw still = screw_of(0, 0, 0, 1, 2, 3, 0, 0);
  real T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&still, T));
  for (int i = 0; i < 16; i++) TEST_ASSERT_TRUE(identity4[i] == T[i]);
}

static void test_a_motion_without_an_axis_is_refused(void) {
  const screw turning = screw_of(0, 0, 0, 1, 2, 3, 0, 1), sliding = screw_of(0, 0, 0, 1, 2, 3, SMALLEST, 0);
  real T[16];
  ASSERT_REFUSES(CHS_ERR_SINGULAR, T, FN(chs_screw_to_pose)(&turning, T));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, T, FN(chs_screw_to_pose)(&sliding, T));
}

static void test_angles_beyond_the_range_are_refused(void) {
  screw s = screw_of(0, 0, 1, 0, 0, 0, 0, ANGLE_MAX);
  real T[16];
  for (int sign = 1; sign >= -1; sign -= 2) {
    s.angle = (real)sign * ANGLE_MAX;
    ASSERT_STATUS(CHS_OK, FN(chs_screw_to_pose)(&s, T));
    s.angle = NEXT_AFTER(s.angle, (real)sign * REAL_MAX);
    ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_screw_to_pose)(&s, T));
  }
}

static void test_lengths_beyond_the_range_are_an_overflow(void) {
  const screw far = screw_of(0, 0, 1, REAL_MAX, 0, 0, 0, REAL_PI);
  real T[16];
  screw s;
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, T, FN(chs_screw_to_pose)(&far, T));
  pose_of(identity3, REAL_MAX, REAL_MAX, 0, T);
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, s, FN(chs_screw_from_pose)(T, &s));

  /* A rotation that is no rounding, about an axis that is out of reach. */
  real w[3] = {0, 0, K(0.01)}, R[9];
  FN(chs_so3_exp)(w, R);
  pose_of(R, REAL_MAX / 2, 0, 0, T);
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, s, FN(chs_screw_from_pose)(T, &s));

  /* A point within the range, and a way along the axis that is not. */
  const real third[9] = {0, -1, 0, 0, 0, -1, 1, 0, 0};
  pose_of(third, -REAL_MAX, REAL_MAX, 0, T);
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, s, FN(chs_screw_from_pose)(T, &s));
}

static void test_pitch_is_translation_over_angle(void) {
  for (int k = 0; k < CASES; k++) {
    screw s = screw_of(0, 0, 1, 0, 0, 0, (real)uniform(-9, 9), (real)uniform(-9, 9));
    real pitch;
    ASSERT_STATUS(CHS_OK, FN(chs_screw_pitch)(&s, &pitch));
    double expected = (double)s.translation / (double)s.angle;
    ASSERT_WITHIN_EPS(expected, pitch, CHS_EPS_SCREW_PITCH, fabs(expected));
  }
}

static void test_pitch_without_rotation_is_infinite_with_the_sign_of_the_translation(void) {
  const real infinite = (real)INFINITY, zero = 0;
  const struct {
    real translation, angle, pitch;
    int status;
  } known[] = {{1, 0, infinite, CHS_PURE_TRANSLATION},
               {-SMALLEST, 0, -infinite, CHS_PURE_TRANSLATION},
               {1, -zero, infinite, CHS_PURE_TRANSLATION},
               {-1, -zero, -infinite, CHS_PURE_TRANSLATION},
               {0, 0, 0, CHS_NO_MOTION},
               {-zero, 0, 0, CHS_NO_MOTION},
               {0, -zero, 0, CHS_NO_MOTION},
               {0, 1, 0, CHS_OK}};
  for (int k = 0; k < LENGTH(known); k++) {
    screw s = screw_of(0, 0, 1, 0, 0, 0, known[k].translation, known[k].angle);
    real pitch;
    ASSERT_STATUS(known[k].status, FN(chs_screw_pitch)(&s, &pitch));
    ASSERT_SAME_BITS(&known[k].pitch, &pitch, 1);
  }
}

static void test_pitch_beyond_the_range_is_an_overflow(void) {
  const screw s = screw_of(0, 0, 1, 0, 0, 0, REAL_MAX, K(0.5));
  real pitch;
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, pitch, FN(chs_screw_pitch)(&s, &pitch));
}

static void test_worked_example_pose_to_screw(void) {
  const real T[16] = {0, -1, 0, 3, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  const double axis[3] = {0.577350269, -0.577350269, 0.577350269};
  screw s;
  real pitch;
  ASSERT_STATUS(CHS_OK, FN(chs_screw_from_pose)(T, &s));
  ASSERT_STATUS(CHS_OK, FN(chs_screw_pitch)(&s, &pitch));
  for (int i = 0; i < 3; i++) TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, axis[i], (double)s.axis[i]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, 2 * PI / 3, (double)s.angle);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, 0.826993343, (double)pitch);
}

static void test_worked_example_twist_to_screw(void) {
  const real V[6] = {0, 2, 2, 4, 0, 0};
  const double axis[3] = {0, 0.7071067812, 0.7071067812}, point[3] = {0, 1, -1};
  real T[16], pitch;
  screw s;
  ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
  ASSERT_STATUS(CHS_OK, FN(chs_screw_from_pose)(T, &s));
  ASSERT_STATUS(CHS_OK, FN(chs_screw_pitch)(&s, &pitch));
  for (int i = 0; i < 3; i++) {
    TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 32 * EPS, axis[i], (double)s.axis[i]);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 32 * EPS, point[i], (double)s.point[i]);
  }
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 32 * EPS, 2.828427125, (double)s.angle);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 32 * EPS, 0, (double)pitch);
}

/* Screw axes. */

static void assert_axis(const real expected[6], const real S[6], double error) {
  ASSERT_NORM_WITHIN_EPS(expected, S, 6, error, 1 + length_of(expected + 3, 3));
}

static void test_joints_are_screws_of_pitch_zero_some_and_infinity(void) {
  const real q[3] = {1, 2, 3}, s[3] = {0, 0, 5}, infinite = (real)INFINITY;
  const real revolute[6] = {0, 0, 1, 2, -1, 0}, helical[6] = {0, 0, 1, 2, -1, 4}, prismatic[6] = {0, 0, 0, 0, 0, 1},
             back[6] = {0, 0, 0, 0, 0, -1};
  real S[6];
  ASSERT_STATUS(CHS_OK, FN(chs_screw_revolute)(q, s, S));
  ASSERT_SAME_BITS(revolute, S, 6);
  ASSERT_STATUS(CHS_OK, FN(chs_screw_helical)(q, s, 4, S));
  ASSERT_SAME_BITS(helical, S, 6);
  ASSERT_STATUS(CHS_OK, FN(chs_screw_prismatic)(s, S));
  ASSERT_SAME_BITS(prismatic, S, 6);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_helical)(q, s, infinite, S));
  ASSERT_SAME_BITS(prismatic, S, 6);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_helical)(q, s, -infinite, S));
  ASSERT_ENTRIES_WITHIN_EPS(back, S, 6, 0, 1);
}

static void test_a_joint_without_a_direction_or_with_a_pitch_that_is_no_number_is_refused(void) {
  const real q[3] = {1, 2, 3}, zero[3] = {0, -K(0.0), 0}, s[3] = {0, 1, 0}, bad[3] = {(real)INFINITY, 0, 0};
  real S[6];
  ASSERT_REFUSES(CHS_ERR_SINGULAR, S, FN(chs_screw_revolute)(q, zero, S));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, S, FN(chs_screw_helical)(q, zero, (real)INFINITY, S));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, S, FN(chs_screw_prismatic)(zero, S));
  ASSERT_REFUSES(CHS_ERR_NAN, S, FN(chs_screw_helical)(q, s, (real)NAN, S));
  ASSERT_REFUSES(CHS_ERR_NAN, S, FN(chs_screw_helical)(bad, s, (real)NAN, S));
  ASSERT_REFUSES(CHS_ERR_INFINITE, S, FN(chs_screw_helical)(bad, s, (real)INFINITY, S));
}

static void test_axis_parts_take_back_what_helical_made(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], s[3], S[6], point[3], e[3], h, pitch, V[6], L[6];
    double reach = log_uniform(PICK(1e-100, 1e-10), PICK(1e100, 1e10));
    random_vector(reach, q);
    random_vector(1, s);
    real given = k % 3 ? rounded(reach * uniform(-2, 2)) : 0;
    ASSERT_STATUS(CHS_OK, FN(chs_screw_helical)(q, s, given, S));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_parts)(S, point, e, &pitch));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_pitch)(S, &h));
    ASSERT_SAME_BITS(&pitch, &h, 1);
    double scale = reach + fabs((double)given), made = CHS_EPS_SCREW_HELICAL_TRANSLATION;
    ASSERT_NORM_WITHIN_EPS(s, e, 3, CHS_EPS_SCREW_AXIS_PARTS_DIRECTION + CHS_EPS_SCREW_HELICAL_ROTATION + 1, 1);
    ASSERT_WITHIN_EPS(given, h, CHS_EPS_SCREW_AXIS_PITCH + made + CHS_EPS_SCREW_HELICAL_ROTATION, scale);
    /* The point is the one of the axis nearest to the origin. */
    double along = dot_of(q, s, 3), parts = CHS_EPS_SCREW_AXIS_PARTS_POINT + made + 6;
    real nearest[3];
    for (int i = 0; i < 3; i++) nearest[i] = rounded((double)q[i] - along * (double)s[i]);
    ASSERT_NORM_WITHIN_EPS(nearest, point, 3, parts, scale);
    /* The line's coordinates are those of the pure rotation; a longer twist has the same axis. */
    scaled(uniform(2, 3), S, 6, V);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_line)(V, L));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_revolute)(q, s, S));
    ASSERT_NORM_WITHIN_EPS(S, L, 3, CHS_EPS_SCREW_AXIS_LINE_DIRECTION + CHS_EPS_SCREW_REVOLUTE_ROTATION + 3, 1);
    ASSERT_NORM_WITHIN_EPS(S + 3, L + 3, 3, CHS_EPS_SCREW_AXIS_LINE_MOMENT + 2 * made + 6, scale);
  }
}

static void test_a_screw_without_rotation_has_infinite_pitch_and_no_line(void) {
  const real S[6] = {0, -K(0.0), 0, 0, 0, -3}, still[6] = {0}, origin[3] = {0, 0, 0}, down[3] = {0, 0, -1};
  real q[3], s[3], h, L[6];
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_axis_parts)(S, q, s, &h));
  ASSERT_SAME_BITS(origin, q, 3);
  ASSERT_SAME_BITS(down, s, 3);
  TEST_ASSERT_TRUE(h == (real)INFINITY);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_axis_pitch)(S, &h));
  TEST_ASSERT_TRUE(h == (real)INFINITY);
  ASSERT_REFUSES(CHS_ERR_SINGULAR, L, FN(chs_screw_axis_line)(S, L));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, L, FN(chs_screw_axis_line)(still, L));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, h, FN(chs_screw_axis_pitch)(still, &h));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, h, FN(chs_screw_axis_parts)(still, q, s, &h));
}

static void test_normalize_parts_a_twist_into_axis_and_rate(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], S[6], rate, back[6];
    int turning = k % 3 > 0;
    if (turning) random_vector(log_uniform(PICK(1e-150, 1e-15), PICK(1e150, 1e15)), V);
    random_vector(log_uniform(PICK(1e-150, 1e-15), PICK(1e150, 1e15)), V + 3);
    if (!turning) V[0] = V[1] = V[2] = 0;
    ASSERT_STATUS(turning ? CHS_OK : CHS_PURE_TRANSLATION, FN(chs_screw_normalize)(V, S, &rate));
    ASSERT_WITHIN_EPS(1, length_of(turning ? S : S + 3, 3), CHS_EPS_SCREW_NORMALIZE_ROTATION, 1);
    FN(chs_screw_twist)(S, rate, back);
    double parts = CHS_EPS_SCREW_NORMALIZE_RATE + CHS_EPS_SCREW_NORMALIZE_TRANSLATION + CHS_EPS_SCREW_TWIST;
    ASSERT_NORM_WITHIN_EPS(V, back, 3, parts, length_of(V, 3));
    ASSERT_NORM_WITHIN_EPS(V + 3, back + 3, 3, parts, length_of(V + 3, 3));
  }
}

static void test_normalize_of_what_hardly_turns_or_does_not_move(void) {
  const real still[6] = {0}, up[6] = {0, 0, 0, 0, 0, 1};
  const real hardly[6] = {SMALLEST, 0, 0, 0, 0, 3}, slow[6] = {0, 3 * SMALLEST, 4 * SMALLEST, 0, 0, 5 * SMALLEST},
             expected[6] = {0, K(0.6), K(0.8), 0, 0, 1};
  real S[6], rate;
  ASSERT_STATUS(CHS_NO_MOTION, FN(chs_screw_normalize)(still, S, &rate));
  ASSERT_SAME_BITS(up, S, 6);
  TEST_ASSERT_TRUE(rate == 0);
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_normalize)(hardly, S, &rate));
  ASSERT_SAME_BITS(up, S, 6);
  TEST_ASSERT_TRUE(rate == 3);
  ASSERT_STATUS(CHS_OK, FN(chs_screw_normalize)(slow, S, &rate));
  ASSERT_ENTRIES_WITHIN_EPS(expected, S, 6, CHS_EPS_SCREW_NORMALIZE_TRANSLATION, 1);
  TEST_ASSERT_TRUE(rate == 5 * (real)SMALLEST);
}

/* What may not be squared, beside a v that is as large or as small as can be: nothing is lost on the way. */
static void test_axes_of_rates_of_any_size_have_all_their_digits(void) {
  const double least = PICK(-1000, -120), most = PICK(1000, 120);
  for (int k = 0; k < 10 * CASES; k++) {
    double rotation = floor(uniform(least, most)), translation = floor(uniform(least, most));
    double ratio = translation - rotation;
    if (ratio < least || ratio > most) continue;
    const real V[6] = {K(0.6) * (real)ldexp(1, (int)rotation),    0, K(0.8) * (real)ldexp(1, (int)rotation), 0,
                       K(1.5) * (real)ldexp(1, (int)translation), 0};
    const real unit[6] = {K(0.6), 0, K(0.8), 0, K(1.5) * (real)ldexp(1, (int)ratio), 0};
    real S[6], rate;
    ASSERT_STATUS(CHS_OK, FN(chs_screw_normalize)(V, S, &rate));
    ASSERT_NORM_WITHIN_EPS(unit, S, 3, CHS_EPS_SCREW_NORMALIZE_ROTATION, 1);
    ASSERT_WITHIN_EPS((double)unit[4], S[4], CHS_EPS_SCREW_NORMALIZE_TRANSLATION, (double)unit[4]);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_line)(V, S));
    ASSERT_WITHIN_EPS((double)unit[4], S[4], CHS_EPS_SCREW_AXIS_LINE_MOMENT, (double)unit[4]);
  }
}

static void test_values_beyond_the_range_of_screw_axes_are_an_overflow(void) {
  const real V[6] = {REAL_MAX, REAL_MAX, 0, 1, 2, 3}, far[6] = {0, 0, K(0.1), REAL_MAX, 0, 0},
             steep[6] = {0, 0, K(0.1), 0, 0, REAL_MAX}, corner[3] = {REAL_MAX, -REAL_MAX, 0}, s[3] = {1, 1, 0};
  real S[6], q[3], e[3], h, rate;
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, rate, FN(chs_screw_normalize)(V, S, &rate));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, h, FN(chs_screw_axis_parts)(far, q, e, &h));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, h, FN(chs_screw_axis_parts)(steep, q, e, &h));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, h, FN(chs_screw_axis_pitch)(far, &h));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, h, FN(chs_screw_axis_pitch)(steep, &h));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, S, FN(chs_screw_axis_line)(far, S));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, S, FN(chs_screw_revolute)(corner, s, S));
}

/* S_a = Ad(T_ab) S_b: the axis of a moved joint. */
static void test_the_adjoint_changes_the_frame_of_a_screw(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], R[9], p[3], q[3], s[3], S[6], moved[6], expected[6];
    random_pose(1, T);
    FN(chs_se3_to_parts)(T, R, p);
    random_vector(1, q);
    random_vector(1, s);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_helical)(q, s, 2, S));
    FN(chs_se3_adjoint_twist)(T, S, moved);
    FN(chs_se3_apply)(T, q, q);
    FN(chs_so3_apply)(R, s, s);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_helical)(q, s, 2, expected));
    assert_axis(expected, moved, 20);
  }
}

static void test_the_reciprocal_product_of_lines_is_their_moment(void) {
  for (int k = 0; k < CASES; k++) {
    const real x[3] = {1, 0, 0}, origin[3] = {0, 0, 0};
    double angle = uniform(0.1, 3), height = uniform(0.1, 3);
    const real over[3] = {0, 0, rounded(height)}, turned[3] = {rounded(cos(angle)), rounded(sin(angle)), 0};
    real A[6], B[6], product, other;
    ASSERT_STATUS(CHS_OK, FN(chs_screw_revolute)(origin, x, A));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_revolute)(over, turned, B));
    FN(chs_screw_reciprocal)(A, B, &product);
    ASSERT_WITHIN_EPS(-sin(angle) * height, product, CHS_EPS_SCREW_RECIPROCAL + 3, height);
    FN(chs_screw_reciprocal)(B, A, &other);
    ASSERT_SAME_BITS(&product, &other, 1);
  }
}

/* The same wherever both are seen from. */
static void test_the_reciprocal_product_does_not_depend_on_the_frame(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], A[6], B[6], moved_a[6], moved_b[6], before, after;
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-9, 9, 6, A);
    random_integers(-9, 9, 6, B);
    FN(chs_screw_reciprocal)(A, B, &before);
    FN(chs_se3_adjoint_twist)(T, A, moved_a);
    FN(chs_se3_adjoint_twist)(T, B, moved_b);
    FN(chs_screw_reciprocal)(moved_a, moved_b, &after);
    TEST_ASSERT_TRUE(before == after);
  }
}

static void test_moving_along_a_screw_of_either_frame(void) {
  /* The body frame lies at (1, 2, 0), its x axis along y; a quarter turn about its own z axis, and the space's. */
  const real T[16] = {0, -1, 0, 1, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 1}, z[6] = {0, 0, 1, 0, 0, 0};
  const real body[16] = {-1, 0, 0, 1, 0, -1, 0, 2, 0, 0, 1, 0, 0, 0, 0, 1},
             space[16] = {-1, 0, 0, -2, 0, -1, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1};
  real moved[16];
  ASSERT_STATUS(CHS_OK, FN(chs_screw_move_body)(T, z, REAL_PI / 2, moved));
  ASSERT_ENTRIES_WITHIN_EPS(body, moved, 16, CHS_EPS_SCREW_MOVE_TRANSLATION, 3);
  ASSERT_STATUS(CHS_OK, FN(chs_screw_move_space)(T, z, REAL_PI / 2, moved));
  ASSERT_ENTRIES_WITHIN_EPS(space, moved, 16, CHS_EPS_SCREW_MOVE_TRANSLATION, 3);
}

static void test_a_screw_of_the_body_is_one_of_the_space_by_the_adjoint(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], S[6], in_space[6], A[16], B[16], theta = rounded(uniform(-3, 3));
    random_pose(1, T);
    random_vector(1, S);
    random_vector(1, S + 3);
    FN(chs_se3_adjoint_twist)(T, S, in_space);
    ASSERT_STATUS(CHS_OK, FN(chs_screw_move_body)(T, S, theta, A));
    ASSERT_STATUS(CHS_OK, FN(chs_screw_move_space)(T, in_space, theta, B));
    ASSERT_ENTRIES_WITHIN_EPS(A, B, 16, 2 * CHS_EPS_SCREW_MOVE_TRANSLATION + 10, 3 * (1 + 3));
  }
}

static void test_moving_by_an_angle_beyond_the_range_is_refused(void) {
  const real z[6] = {0, 0, 1, 1, 0, 0}, twice[6] = {0, 0, 4, 0, 0, 0}, up[6] = {0, 0, 0, 0, 0, 2};
  real T[16];
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_screw_move_body)(identity4, z, NEXT_AFTER(ANGLE_MAX, REAL_MAX), T));
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_screw_move_space)(identity4, twice, REAL_MAX, T));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, T, FN(chs_screw_move_space)(identity4, up, REAL_MAX, T));
}

/* The worked examples of the lecture on screws, with digits that it rounds (the first's pitch is printed 0.8275). */
static void test_worked_example_screw_axis_of_a_pose(void) {
  const real T[16] = {0, -1, 0, 3, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  const double S_expected[6] = {0.577350269, -0.577350269, 0.577350269, 1.0548150985, -1.0548150985, -0.6772357091};
  real V[6], S[6], rate, q[3], s[3], h, on_axis[3] = {1, 1, 0}, moment[3];
  ASSERT_STATUS(CHS_OK, FN(chs_se3_log)(T, V));
  ASSERT_STATUS(CHS_OK, FN(chs_screw_normalize)(V, S, &rate));
  ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_parts)(S, q, s, &h));
  for (int i = 0; i < 6; i++) TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, S_expected[i], (double)S[i]);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, 2 * PI / 3, (double)rate);
  TEST_ASSERT_DOUBLE_WITHIN(1e-9 + 8 * EPS, 0.826993343, (double)h);
  /* The lecture's q = (1, 1, 0) is a point of the axis as well. */
  for (int i = 0; i < 3; i++) on_axis[i] -= q[i];
  cross_of(on_axis, s, moment);
  ASSERT_WITHIN_EPS(0, length_of(moment, 3), 16, 1);
}

static void test_worked_example_screw_axis_of_a_twist(void) {
  const real V[6] = {0, 2, 2, 4, 0, 0};
  const double root = sqrt(0.5), S_expected[6] = {0, root, root, 2 * root, 0, 0}, q_expected[3] = {0, 1, -1};
  real S[6], rate, q[3], s[3], h;
  ASSERT_STATUS(CHS_OK, FN(chs_screw_normalize)(V, S, &rate));
  ASSERT_WITHIN_EPS(2 * sqrt(2), rate, CHS_EPS_SCREW_NORMALIZE_RATE, 2 * sqrt(2));
  for (int i = 0; i < 6; i++) ASSERT_WITHIN_EPS(S_expected[i], S[i], CHS_EPS_SCREW_NORMALIZE_TRANSLATION, 2);
  ASSERT_STATUS(CHS_OK, FN(chs_screw_axis_parts)(S, q, s, &h));
  ASSERT_WITHIN_EPS(0, h, CHS_EPS_SCREW_AXIS_PARTS_PITCH, 2);
  for (int i = 0; i < 3; i++) {
    ASSERT_WITHIN_EPS(q_expected[i], q[i], CHS_EPS_SCREW_AXIS_PARTS_POINT + 4, 2);
    ASSERT_WITHIN_EPS(S_expected[i], s[i], CHS_EPS_SCREW_AXIS_PARTS_DIRECTION + 2, 1);
  }
}

static void test_worked_example_motion_along_a_screw(void) {
  const real V[6] = {0, 1, 2, 3, 0, 0};
  const double expected[12] = {-0.6172728765, -0.7036898158, 0.3518449079,  1.0555347236, 0.7036898158, -0.2938183012,
                               0.6469091506,  1.9407274517,  -0.3518449079, 0.6469091506, 0.6765454247, -0.9703637259};
  real S[6], theta, T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_screw_normalize)(V, S, &theta));
  TEST_ASSERT_DOUBLE_WITHIN(1e-10 + 2 * EPS, 2.2360679775, (double)theta); /* the lecture rounds it to 2.23 */
  ASSERT_STATUS(CHS_OK, FN(chs_screw_move_space)(identity4, S, theta, T));
  for (int i = 0; i < 12; i++) TEST_ASSERT_DOUBLE_WITHIN(1e-10 + 16 * EPS, expected[i], (double)T[i]);
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_the_identity_is_no_motion_along_z);
  RUN_TEST(test_a_translation_is_a_screw_along_it_through_the_origin);
  RUN_TEST(test_the_direction_of_subnormal_translations_is_resolved);
  RUN_TEST(test_a_quarter_turn_about_a_line_parallel_to_z);
  RUN_TEST(test_a_half_turn_has_an_axis_whose_first_component_is_positive);
  RUN_TEST(test_next_to_a_half_turn_the_skew_part_decides);
  RUN_TEST(test_the_point_is_the_one_nearest_to_the_origin);
  RUN_TEST(test_rotation_about_an_axis_out_of_range_is_a_pure_translation);
  RUN_TEST(test_to_pose_takes_back_what_from_pose_gave);
  RUN_TEST(test_from_pose_takes_back_what_to_pose_gave);
  RUN_TEST(test_to_pose_leaves_the_points_of_the_axis_on_it);
  RUN_TEST(test_to_pose_is_the_same_for_every_length_of_the_axis);
  RUN_TEST(test_to_pose_is_the_same_for_every_point_of_the_axis);
  RUN_TEST(test_a_screw_seen_from_the_other_end_is_the_same_motion);
  RUN_TEST(test_to_pose_agrees_with_exp_of_the_twist);
  RUN_TEST(test_no_axis_is_needed_where_nothing_moves);
  RUN_TEST(test_a_motion_without_an_axis_is_refused);
  RUN_TEST(test_angles_beyond_the_range_are_refused);
  RUN_TEST(test_lengths_beyond_the_range_are_an_overflow);
  RUN_TEST(test_pitch_is_translation_over_angle);
  RUN_TEST(test_pitch_without_rotation_is_infinite_with_the_sign_of_the_translation);
  RUN_TEST(test_pitch_beyond_the_range_is_an_overflow);
  RUN_TEST(test_worked_example_pose_to_screw);
  RUN_TEST(test_worked_example_twist_to_screw);
  RUN_TEST(test_joints_are_screws_of_pitch_zero_some_and_infinity);
  RUN_TEST(test_a_joint_without_a_direction_or_with_a_pitch_that_is_no_number_is_refused);
  RUN_TEST(test_axis_parts_take_back_what_helical_made);
  RUN_TEST(test_a_screw_without_rotation_has_infinite_pitch_and_no_line);
  RUN_TEST(test_normalize_parts_a_twist_into_axis_and_rate);
  RUN_TEST(test_normalize_of_what_hardly_turns_or_does_not_move);
  RUN_TEST(test_axes_of_rates_of_any_size_have_all_their_digits);
  RUN_TEST(test_values_beyond_the_range_of_screw_axes_are_an_overflow);
  RUN_TEST(test_the_adjoint_changes_the_frame_of_a_screw);
  RUN_TEST(test_the_reciprocal_product_of_lines_is_their_moment);
  RUN_TEST(test_the_reciprocal_product_does_not_depend_on_the_frame);
  RUN_TEST(test_moving_along_a_screw_of_either_frame);
  RUN_TEST(test_a_screw_of_the_body_is_one_of_the_space_by_the_adjoint);
  RUN_TEST(test_moving_by_an_angle_beyond_the_range_is_refused);
  RUN_TEST(test_worked_example_screw_axis_of_a_pose);
  RUN_TEST(test_worked_example_screw_axis_of_a_twist);
  RUN_TEST(test_worked_example_motion_along_a_screw);
  return SUITE_END();
}
