#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                     \
  PLAIN(se3_from_parts, "Mx", "T", (in[0], in[1], out[0]))            \
  PLAIN(se3_to_parts, "T", "Mx", (in[0], out[0], out[1]))             \
  PLAIN(se3_compose, "TT", "T", (in[0], in[1], out[0]))               \
  PLAIN(se3_inverse, "T", "T", (in[0], out[0]))                       \
  PLAIN(se3_apply, "Tx", "x", (in[0], in[1], out[0]))                 \
  CHECKED(se3_exp, "V", "T", (in[0], out[0]))                         \
  CHECKED(se3_log, "T", "V", (in[0], out[0]))                         \
  PLAIN(se3_adjoint, "T", "A", (in[0], out[0]))                       \
  PLAIN(se3_adjoint_inverse, "T", "A", (in[0], out[0]))               \
  PLAIN(se3_adjoint_twist, "TV", "V", (in[0], in[1], out[0]))         \
  PLAIN(se3_adjoint_inverse_twist, "TV", "V", (in[0], in[1], out[0])) \
  PLAIN(se3_adjoint_wrench, "TV", "V", (in[0], in[1], out[0]))        \
  PLAIN(se3_adjoint_inverse_wrench, "TV", "V", (in[0], in[1], out[0]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

/* See test_so3.c: the error of exp's rotation as a matrix and as an angle, in eps. */
static const double exp_in_norm = 3 * CHS_EPS_SE3_EXP_ROTATION;
static const double exp_as_angle = 3 * CHS_EPS_SE3_EXP_ROTATION / 1.4142135623730951;

static void assert_equal(const real *expected, const real *actual, int n) {
  for (int i = 0; i < n; i++)
    if (!(expected[i] == actual[i])) ASSERT_SAME_BITS(expected + i, actual + i, 1);
}

/* A twist with a rotation of the angle and a velocity of the length. */
static void random_twist(double angle, double length, real V[6]) {
  random_vector(angle, V);
  random_vector(length, V + 3);
}

static void test_parts_are_put_and_found_where_the_header_says(void) {
  const real R[9] = {11, 12, 13, 21, 22, 23, 31, 32, 33}, p[3] = {1, 2, 3};
  const real expected[16] = {11, 12, 13, 1, 21, 22, 23, 2, 31, 32, 33, 3, 0, 0, 0, 1};
  real T[16], R_back[9], p_back[3];
  FN(chs_se3_from_parts)(R, p, T);
  ASSERT_SAME_BITS(expected, T, 16);
  FN(chs_se3_to_parts)(T, R_back, p_back);
  ASSERT_SAME_BITS(R, R_back, 9);
  ASSERT_SAME_BITS(p, p_back, 3);
}

static void test_every_pose_gets_its_last_row(void) {
  real A[16], B[16], V[6];
  for (int f = 0; f < LENGTH(functions); f++) {
    if (functions[f].outputs[0] != 'T') continue;
    example e;
    make_inputs(functions + f, &e);
    fill_with_pattern(e.out, sizeof e.out);
    run(functions + f, &e);
    ASSERT_SAME_BITS(identity4 + 12, e.out[0] + 12, 4);
  }
  random_pose(1, A);
  FN(chs_se3_inverse)(A, B);
  TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_se3_log)(A, V));
}

static void test_compose_and_apply_of_integers_are_exact(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], C[16], x[4], y[4], expected[16];
    random_integers(-99, 99, 16, A);
    random_integers(-99, 99, 16, B);
    random_integers(-99, 99, 3, x);
    memcpy(A + 12, identity4 + 12, 4 * sizeof(real));
    memcpy(B + 12, identity4 + 12, 4 * sizeof(real));
    x[3] = 1;
    FN(chs_se3_compose)(A, B, C);
    product_of(A, B, 4, 4, expected);
    assert_equal(expected, C, 16);
    FN(chs_se3_apply)(A, x, y);
    product_of(A, x, 4, 1, expected);
    assert_equal(expected, y, 3);
  }
}

static void test_compose_and_apply_keep_their_promise(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], C[16], R[9], pA[3], pB[3], expected[16];
    random_pose(log_uniform(1e-3, 1e3), A);
    random_pose(log_uniform(1e-3, 1e3), B);
    product_of(A, B, 4, 4, expected);
    FN(chs_se3_compose)(A, B, C);
    FN(chs_se3_to_parts)(B, R, pB);
    FN(chs_se3_to_parts)(A, R, pA);
    double reach = length_of(R, 9) * length_of(pB, 3) + length_of(pA, 3);
    for (int i = 0; i < 3; i++) {
      ASSERT_ENTRIES_WITHIN_EPS(expected + 4 * i, C + 4 * i, 3, CHS_EPS_SE3_COMPOSE_ROTATION, 3);
      ASSERT_WITHIN_EPS(expected[4 * i + 3], C[4 * i + 3], CHS_EPS_SE3_COMPOSE_TRANSLATION, reach);
    }
    real y[3];
    FN(chs_se3_apply)(A, pB, y);
    for (int i = 0; i < 3; i++) ASSERT_WITHIN_EPS(expected[4 * i + 3], y[i], CHS_EPS_SE3_APPLY, reach);
  }
}

static void test_pose_and_its_inverse_make_the_identity(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], C[16];
    cube_pose(k % CUBE_ROTATIONS, 99, A);
    FN(chs_se3_inverse)(A, B);
    FN(chs_se3_compose)(A, B, C);
    assert_equal(identity4, C, 16);
    FN(chs_se3_compose)(B, A, C);
    assert_equal(identity4, C, 16);
    FN(chs_se3_inverse)(B, C);
    assert_equal(A, C, 16);
  }
}

static void test_inverse_of_the_inverse_is_the_pose(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], C[16], R[9], p[3], R_back[9], p_back[3];
    random_pose(log_uniform(PICK(1e-300, 1e-30), PICK(1e300, 1e30)), A);
    FN(chs_se3_inverse)(A, B);
    FN(chs_se3_inverse)(B, C);
    FN(chs_se3_to_parts)(A, R, p);
    FN(chs_se3_to_parts)(C, R_back, p_back);
    ASSERT_SAME_BITS(R, R_back, 9);
    /* R R^T is the identity to within 2 exp_in_norm. */
    ASSERT_NORM_WITHIN_EPS(p, p_back, 3, 2 * sqrt(3) * CHS_EPS_SE3_INVERSE_TRANSLATION + 2 * exp_in_norm,
                           length_of(p, 3));
  }
}

static void test_exp_of_zero_is_the_identity_and_log_takes_it_back(void) {
  const real zeros[2][6] = {{0, 0, 0, 0, 0, 0}, {-K(0.0), -K(0.0), -K(0.0), 0, 0, 0}};
  for (int k = 0; k < 2; k++) {
    real T[16], V[6];
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(zeros[k], T));
    ASSERT_SAME_BITS(identity4, T, 16);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_log)(T, V));
    ASSERT_SAME_BITS(zeros[0], V, 6);
  }
}

static void test_exp_and_log_of_a_translation_change_nothing(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6] = {0}, T[16], R[9], p[3], back[6];
    random_vector(log_uniform(PICK(1e-307, 1e-37), PICK(1e307, 1e37)), V + 3);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
    FN(chs_se3_to_parts)(T, R, p);
    ASSERT_SAME_BITS(identity3, R, 9);
    ASSERT_SAME_BITS(V + 3, p, 3);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_log)(T, back));
    assert_equal(V, back, 6);
  }
}

static void test_rotation_parts_of_exp_and_log_are_those_of_so3(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], T[16], R[9], p[3], expected[9];
    random_twist(random_angle(k), 1, V);
    FN(chs_se3_exp)(V, T);
    FN(chs_se3_to_parts)(T, R, p);
    FN(chs_so3_exp)(V, expected);
    ASSERT_SAME_BITS(expected, R, 9);
    int status = FN(chs_so3_log)(R, expected);
    ASSERT_STATUS(status, FN(chs_se3_log)(T, V));
    ASSERT_SAME_BITS(expected, V, 3);
  }
}

static void test_log_takes_back_what_exp_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], T[16], back[6];
    random_twist(random_angle(k), log_uniform(PICK(1e-280, 1e-30), PICK(1e280, 1e30)), V);
    double theta = length_of(V, 3), v = length_of(V + 3, 3);
    FN(chs_se3_exp)(V, T);
    if (FN(chs_se3_log)(T, back) != CHS_OK) continue; /* so near to a half-turn that the sign is not resolved */
    /* log stretches an error of p by at most pi/2, and 1.3 |p| times that of the rotation vector are added: the norm of
     * the derivative of J^-1 grows from 1/2 at 0 to 1.29 at pi. */
    double rotation = CHS_EPS_SE3_LOG_ROTATION_VECTOR + PI / 2 * exp_as_angle;
    ASSERT_NORM_WITHIN_EPS(V, back, 3, rotation, theta);
    ASSERT_NORM_WITHIN_EPS(V + 3, back + 3, 3,
                           CHS_EPS_SE3_LOG_TRANSLATION + PI / 2 * CHS_EPS_SE3_EXP_TRANSLATION + 1.3 * rotation * theta,
                           v);
  }
}

static void test_exp_takes_back_what_log_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], V[6], back[16], R[9], p[3], R_back[9], p_back[3];
    random_pose(log_uniform(PICK(1e-280, 1e-30), PICK(1e280, 1e30)), T);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_se3_log)(T, V));
    FN(chs_se3_exp)(V, back);
    FN(chs_se3_to_parts)(T, R, p);
    FN(chs_se3_to_parts)(back, R_back, p_back);
    double rotation = CHS_EPS_SE3_LOG_ROTATION_VECTOR * PI, v = length_of(V + 3, 3);
    ASSERT_ENTRIES_WITHIN_EPS(R, R_back, 9, CHS_EPS_SE3_EXP_ROTATION + rotation + exp_in_norm, 1);
    /* exp stretches nothing, and its derivative is at most |v|/2 by each unit of the rotation vector. */
    ASSERT_NORM_WITHIN_EPS(
        p, p_back, 3, CHS_EPS_SE3_EXP_TRANSLATION + CHS_EPS_SE3_LOG_TRANSLATION + 0.5 * (rotation + exp_as_angle), v);
  }
}

static void test_exp_of_the_opposite_twist_is_the_inverse(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], minus[6], T[16], inverse[16], back[16], R[9], p[3], R_back[9], p_back[3];
    int beyond = k % 2;
    random_twist(beyond ? uniform(PI, 1000) : random_angle(k / 2), log_uniform(1e-3, 1e3), V);
    scaled(-1, V, 6, minus);
    FN(chs_se3_exp)(V, T);
    FN(chs_se3_inverse)(T, inverse);
    FN(chs_se3_exp)(minus, back);
    FN(chs_se3_to_parts)(inverse, R, p);
    FN(chs_se3_to_parts)(back, R_back, p_back);
    ASSERT_SAME_BITS(R, R_back, 9);
    double translation = beyond ? CHS_EPS_SE3_EXP_TRANSLATION_BEYOND : CHS_EPS_SE3_EXP_TRANSLATION;
    double rotation = 3 * (beyond ? CHS_EPS_SE3_EXP_ROTATION_BEYOND : CHS_EPS_SE3_EXP_ROTATION);
    ASSERT_NORM_WITHIN_EPS(p, p_back, 3, 2 * translation + rotation + sqrt(3) * CHS_EPS_SE3_INVERSE_TRANSLATION,
                           length_of(V + 3, 3));
  }
}

static void test_exp_of_twice_the_twist_is_the_square(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], twice[6], T[16], square[16], back[16], R[9], p[3], R_back[9], p_back[3];
    random_twist(log_uniform(1e-8, 1000), 1, V);
    scaled(2, V, 6, twice);
    FN(chs_se3_exp)(V, T);
    product_of(T, T, 4, 4, square);
    FN(chs_se3_exp)(twice, back);
    FN(chs_se3_to_parts)(square, R, p);
    FN(chs_se3_to_parts)(back, R_back, p_back);
    /* Errors of two factors and of the square, whose translation is at most twice as long. */
    double rotation = CHS_EPS_SE3_EXP_ROTATION_BEYOND, translation = CHS_EPS_SE3_EXP_TRANSLATION_BEYOND;
    ASSERT_ENTRIES_WITHIN_EPS(R, R_back, 9, rotation + 2 * sqrt(3) * rotation + 1, 1);
    ASSERT_NORM_WITHIN_EPS(p, p_back, 3, 2 * translation + 2 * translation + 3 * rotation + 2, 1);
  }
}

static void test_exp_carries_a_point_along_the_screw(void) {
  /* A full turn about z through (1, 0, 0) with a pitch of 2 a radian: nothing but a translation of 2 theta along z. */
  const real V[6] = {0, 0, 2 * REAL_PI, 0, -2 * REAL_PI, 4 * REAL_PI};
  const real x[3] = {1, 2, 3}, expected[3] = {1, 2, (real)(3 + 4 * PI)};
  real T[16], y[3];
  ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
  FN(chs_se3_apply)(T, x, y);
  /* 2 pi and 4 pi are rounded by half an eps of themselves. */
  ASSERT_NORM_WITHIN_EPS(expected, y, 3,
                         CHS_EPS_SE3_EXP_TRANSLATION_BEYOND * length_of(V + 3, 3) +
                             (exp_in_norm + CHS_EPS_SE3_APPLY) * length_of(x, 3) + PI * 3 + 2 * PI,
                         1);
}

/* The worked examples of a lecture on screws, with more digits than it prints. */
static void test_worked_example_pose_to_exponential_coordinates(void) {
  const real T[16] = {0, -1, 0, 3, 0, 0, -1, 0, 1, 0, 0, 0, 0, 0, 0, 1};
  const double S[6] = {0.5773502692, -0.5773502692, 0.5773502692, 1.0548150985, -1.0548150985, -0.6772357091};
  real V[6];
  ASSERT_STATUS(CHS_OK, FN(chs_se3_log)(T, V));
  for (int i = 0; i < 6; i++) TEST_ASSERT_DOUBLE_WITHIN(1e-10 + 8 * EPS, S[i], (double)V[i] / (2 * PI / 3));
}

static void test_worked_example_exponential_coordinates_to_pose(void) {
  const real V[6] = {0, 1, 2, 3, 0, 0};
  const double expected[16] = {-0.6172728765,
                               -0.7036898158,
                               0.3518449079,
                               1.0555347236,
                               0.7036898158,
                               -0.2938183012,
                               0.6469091506,
                               1.9407274517,
                               -0.3518449079,
                               0.6469091506,
                               0.6765454247,
                               -0.9703637259,
                               0,
                               0,
                               0,
                               1};
  real T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
  for (int i = 0; i < 16; i++) TEST_ASSERT_DOUBLE_WITHIN(1e-10 + 8 * EPS, expected[i], (double)T[i]);
}

static void test_angles_beyond_the_range_are_refused_and_bad_numbers_count_more(void) {
  const real most[6] = {0, ANGLE_MAX, 0, 1, 2, 3};
  real V[6] = {0, NEXT_AFTER(ANGLE_MAX, REAL_MAX), 0, 1, 2, 3}, T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(most, T));
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_se3_exp)(V, T));
  V[5] = (real)INFINITY;
  ASSERT_REFUSES(CHS_ERR_INFINITE, T, FN(chs_se3_exp)(V, T));
  V[4] = (real)NAN;
  ASSERT_REFUSES(CHS_ERR_NAN, T, FN(chs_se3_exp)(V, T));
}

static void test_translations_beyond_the_range_are_an_overflow(void) {
  const real V[6] = {0, 0, 1, REAL_MAX, -REAL_MAX, 0}, w[3] = {0, 0, 3}, p[3] = {REAL_MAX, REAL_MAX, 0};
  real T[16], R[9], U[6];
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, T, FN(chs_se3_exp)(V, T));
  FN(chs_so3_exp)(w, R);
  FN(chs_se3_from_parts)(R, p, T);
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, U, FN(chs_se3_log)(T, U));
}

static void test_log_at_half_turn_has_the_sign_of_so3(void) {
  for (int k = 0; k < CASES; k++) {
    turn q = random_turn(0);
    real R[9], p[3], T[16], V[6], w[3], back[16];
    turn_matrix(&q, R);
    random_vector(1, p);
    FN(chs_se3_from_parts)(R, p, T);
    ASSERT_STATUS(CHS_HALF_TURN, FN(chs_se3_log)(T, V));
    ASSERT_STATUS(CHS_HALF_TURN, FN(chs_so3_log)(R, w));
    ASSERT_SAME_BITS(w, V, 3);
    FN(chs_se3_exp)(V, back);
    for (int i = 0; i < 12; i++)
      ASSERT_WITHIN_EPS(
          T[i], back[i],
          PI / 2 * (CHS_EPS_SE3_EXP_TRANSLATION + CHS_EPS_SE3_LOG_TRANSLATION + CHS_EPS_SE3_LOG_ROTATION_VECTOR * PI),
          1);
  }
}

/* [R 0; [p]R R], for any R: the 6x6 product that the twist forms stand for. */
static void adjoint_by_definition(const real T[16], real Ad[36]) {
  real R[9], p[3], P[9], PR[9];
  FN(chs_se3_to_parts)(T, R, p);
  FN(chs_so3_hat)(p, P);
  product_of(P, R, 3, 3, PR);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) {
      Ad[6 * i + j] = Ad[6 * (i + 3) + j + 3] = R[3 * i + j];
      Ad[6 * i + j + 3] = 0;
      Ad[6 * (i + 3) + j] = PR[3 * i + j];
    }
}

static void test_adjoint_of_integers_is_exact(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], inverse[16], Ad[36], expected[36], V[6], U[6];
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-99, 99, 6, V);
    adjoint_by_definition(T, expected);
    FN(chs_se3_adjoint)(T, Ad);
    assert_equal(expected, Ad, 36);
    FN(chs_se3_adjoint_twist)(T, V, U);
    product_of(Ad, V, 6, 1, expected);
    assert_equal(expected, U, 6);

    FN(chs_se3_inverse)(T, inverse);
    adjoint_by_definition(inverse, expected);
    FN(chs_se3_adjoint_inverse)(T, Ad);
    assert_equal(expected, Ad, 36);
    FN(chs_se3_adjoint_inverse_twist)(T, V, U);
    product_of(Ad, V, 6, 1, expected);
    assert_equal(expected, U, 6);
  }
}

/* A wrench goes from b to a by the transpose of the adjoint that takes twists from a to b. */
static void test_wrenches_change_frame_by_the_transposed_inverse(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], Ad[36], transposed[36], F[6], G[6], expected[6];
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-99, 99, 6, F);
    FN(chs_se3_adjoint_inverse)(T, Ad);
    transpose_of(Ad, 6, transposed);
    product_of(transposed, F, 6, 1, expected);
    FN(chs_se3_adjoint_wrench)(T, F, G);
    assert_equal(expected, G, 6);
    FN(chs_se3_adjoint)(T, Ad);
    transpose_of(Ad, 6, transposed);
    product_of(transposed, F, 6, 1, expected);
    FN(chs_se3_adjoint_inverse_wrench)(T, F, G);
    assert_equal(expected, G, 6);
  }
}

static void test_adjoint_forms_keep_their_promise(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], Ad[36], expected[36], V[6], U[6];
    double reach = log_uniform(1e-3, 1e3);
    random_pose(reach, T);
    random_twist(1, 1, V);
    double scale = sqrt(3) * (1 + reach), size = length_of(V, 6);
    adjoint_by_definition(T, expected);
    FN(chs_se3_adjoint)(T, Ad);
    ASSERT_ENTRIES_WITHIN_EPS(expected, Ad, 36, CHS_EPS_SE3_ADJOINT, scale);
    FN(chs_se3_adjoint_twist)(T, V, U);
    product_of(expected, V, 6, 1, Ad);
    ASSERT_NORM_WITHIN_EPS(Ad, U, 6, CHS_EPS_SE3_ADJOINT_TWIST + 1, scale * size);
    FN(chs_se3_adjoint_inverse_twist)(T, U, U);
    /* There and back; R^T R is the identity to within 2 exp_in_norm, and the way back lengthens by 1 + reach. */
    ASSERT_NORM_WITHIN_EPS(V, U, 6, CHS_EPS_SE3_ADJOINT_TWIST + CHS_EPS_SE3_ADJOINT_INVERSE_TWIST + 2 * exp_in_norm,
                           scale * (1 + reach) * size);
  }
}

static void test_power_is_the_same_in_both_frames(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], V[6], F[6], Va[6], Fa[6];
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-9, 9, 6, V);
    random_integers(-9, 9, 6, F);
    FN(chs_se3_adjoint_twist)(T, V, Va);
    FN(chs_se3_adjoint_wrench)(T, F, Fa);
    TEST_ASSERT_TRUE(dot_of(V, F, 6) == dot_of(Va, Fa, 6));
    FN(chs_se3_adjoint_inverse_twist)(T, V, Va);
    FN(chs_se3_adjoint_inverse_wrench)(T, F, Fa);
    TEST_ASSERT_TRUE(dot_of(V, F, 6) == dot_of(Va, Fa, 6));

    double reach = log_uniform(1e-3, 1e3);
    random_pose(reach, T);
    FN(chs_se3_adjoint_twist)(T, V, Va);
    FN(chs_se3_adjoint_wrench)(T, F, Fa);
    double scale = 3 * (1 + reach) * (1 + reach) * length_of(V, 6) * length_of(F, 6);
    ASSERT_WITHIN_EPS(dot_of(V, F, 6), dot_of(Va, Fa, 6),
                      CHS_EPS_SE3_ADJOINT_TWIST + CHS_EPS_SE3_ADJOINT_WRENCH + exp_in_norm, scale);
  }
}

/* T exp(V) T^-1 = exp(Ad(T) V); with a cube rotation T only exp rounds what matters. */
static void test_adjoint_moves_a_displacement_to_another_frame(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], inverse[16], V[6], U[6], E[16], TE[16], expected[16], actual[16];
    cube_pose(k % CUBE_ROTATIONS, 9, T);
    random_twist(uniform(0.1, 3), 1, V);
    FN(chs_se3_exp)(V, E);
    product_of(T, E, 4, 4, TE);
    FN(chs_se3_inverse)(T, inverse);
    product_of(TE, inverse, 4, 4, expected);
    FN(chs_se3_adjoint_twist)(T, V, U);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(U, actual));
    double v = length_of(U + 3, 3), p = length_of(inverse, 12); /* of the moved frame, and no shorter than its origin */
    double twist = sqrt(3) * CHS_EPS_SE3_ADJOINT_TWIST * (1 + p) * length_of(V, 6);
    for (int i = 0; i < 12; i++)
      ASSERT_WITHIN_EPS(expected[i], actual[i],
                        i % 4 < 3 ? 2 * CHS_EPS_SE3_EXP_ROTATION
                                  : CHS_EPS_SE3_EXP_TRANSLATION * (v + 1) + (exp_in_norm + 4) * p + twist,
                        1);
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_parts_are_put_and_found_where_the_header_says);
  RUN_TEST(test_every_pose_gets_its_last_row);
  RUN_TEST(test_compose_and_apply_of_integers_are_exact);
  RUN_TEST(test_compose_and_apply_keep_their_promise);
  RUN_TEST(test_pose_and_its_inverse_make_the_identity);
  RUN_TEST(test_inverse_of_the_inverse_is_the_pose);
  RUN_TEST(test_exp_of_zero_is_the_identity_and_log_takes_it_back);
  RUN_TEST(test_exp_and_log_of_a_translation_change_nothing);
  RUN_TEST(test_rotation_parts_of_exp_and_log_are_those_of_so3);
  RUN_TEST(test_log_takes_back_what_exp_gave);
  RUN_TEST(test_exp_takes_back_what_log_gave);
  RUN_TEST(test_exp_of_the_opposite_twist_is_the_inverse);
  RUN_TEST(test_exp_of_twice_the_twist_is_the_square);
  RUN_TEST(test_exp_carries_a_point_along_the_screw);
  RUN_TEST(test_worked_example_pose_to_exponential_coordinates);
  RUN_TEST(test_worked_example_exponential_coordinates_to_pose);
  RUN_TEST(test_angles_beyond_the_range_are_refused_and_bad_numbers_count_more);
  RUN_TEST(test_translations_beyond_the_range_are_an_overflow);
  RUN_TEST(test_log_at_half_turn_has_the_sign_of_so3);
  RUN_TEST(test_adjoint_of_integers_is_exact);
  RUN_TEST(test_wrenches_change_frame_by_the_transposed_inverse);
  RUN_TEST(test_adjoint_forms_keep_their_promise);
  RUN_TEST(test_power_is_the_same_in_both_frames);
  RUN_TEST(test_adjoint_moves_a_displacement_to_another_frame);
  return SUITE_END();
}
