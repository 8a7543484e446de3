#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                                \
  PLAIN(se3_hat, "V", "T", (in[0], out[0]))                                      \
  PLAIN(se3_vee, "U", "V", (in[0], out[0]))                                      \
  PLAIN(se3_ad, "V", "A", (in[0], out[0]))                                       \
  PLAIN(se3_ad_twist, "VV", "V", (in[0], in[1], out[0]))                         \
  PLAIN(se3_ad_wrench, "VV", "V", (in[0], in[1], out[0]))                        \
  CHECKED(se3_body_twist, "TD", "V", (in[0], in[1], out[0]))                     \
  CHECKED(se3_space_twist, "TD", "V", (in[0], in[1], out[0]))                    \
  CHECKED(se3_body_twist_between, "TTa", "V", (in[0], in[1], in[2][0], out[0]))  \
  CHECKED(se3_space_twist_between, "TTa", "V", (in[0], in[1], in[2][0], out[0])) \
  CHECKED(se3_interpolate, "TTa", "T", (in[0], in[1], in[2][0], out[0]))         \
  CHECKED(se3_distance, "TT", "aa", (in[0], in[1], out[0], out[1]))              \
  CHECKED(se3_weighted_distance, "TTp", "a", (in[0], in[1], in[2][0], out[0]))   \
  CHECKED(se3_left_jacobian, "V", "A", (in[0], out[0]))                          \
  CHECKED(se3_right_jacobian, "V", "A", (in[0], out[0]))                         \
  CHECKED(se3_left_jacobian_inverse, "V", "A", (in[0], out[0]))                  \
  CHECKED(se3_right_jacobian_inverse, "V", "A", (in[0], out[0]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

/* The error of exp's rotation as a matrix, in eps: see test_so3.c. */
static const double exp_in_norm = 3 * CHS_EPS_SE3_EXP_ROTATION;

static void random_twist(double angle, double length, real V[6]) {
  random_vector(angle, V);
  random_vector(length, V + 3);
}

static void assert_equal(const real *expected, const real *actual, int n) {
  for (int i = 0; i < n; i++) TEST_ASSERT_TRUE(expected[i] == actual[i]);
}

static void test_hat_puts_the_twist_where_the_header_says_and_vee_takes_it_back(void) {
  const real V[6] = {1, 2, 3, 4, 5, 6}, expected[16] = {0, -3, 2, 4, 3, 0, -1, 5, -2, 1, 0, 6, 0, 0, 0, 0};
  real M[16], back[6];
  FN(chs_se3_hat)(V, M);
  assert_equal(expected, M, 16);
  FN(chs_se3_vee)(M, back);
  ASSERT_SAME_BITS(V, back, 6);
}

/* The sum of later! M^n / (n + later)! over n, M of `size` rows and columns: exp M where later is 0. */
static void power_series(const real *M, int size, int later, double *sum) {
  double power[36];
  for (int i = 0; i < size * size; i++) sum[i] = power[i] = i % (size + 1) == 0;
  for (int n = 1; n < 25; n++) {
    double next[36] = {0};
    for (int i = 0; i < size; i++)
      for (int j = 0; j < size; j++)
        for (int m = 0; m < size; m++)
          next[size * i + j] += power[size * i + m] * (double)M[size * m + j] / (n + later);
    for (int i = 0; i < size * size; i++) sum[i] += power[i] = next[i];
  }
}

/* exp [V] by its power series, from the 4x4 matrix. */
static void test_exp_is_the_exponential_of_the_matrix(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], M[16], T[16];
    double sum[16];
    random_twist(uniform(0, 1), 1, V);
    FN(chs_se3_hat)(V, M);
    power_series(M, 4, 0, sum);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
    for (int i = 0; i < 16; i++) ASSERT_WITHIN_EPS(sum[i], T[i], CHS_EPS_SE3_EXP_TRANSLATION + 8, 1);
  }
}

static void test_ad_applied_is_the_bracket_and_its_transpose(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], U[6], F[6], ad[36], transposed[36], W[6], G[6], expected[6], back[6];
    random_integers(-99, 99, 6, V);
    random_integers(-99, 99, 6, U);
    random_integers(-99, 99, 6, F);
    FN(chs_se3_ad)(V, ad);
    product_of(ad, U, 6, 1, expected);
    FN(chs_se3_ad_twist)(V, U, W);
    assert_equal(expected, W, 6);
    transpose_of(ad, 6, transposed);
    product_of(transposed, F, 6, 1, expected);
    FN(chs_se3_ad_wrench)(V, F, G);
    assert_equal(expected, G, 6);
    TEST_ASSERT_TRUE(dot_of(W, F, 6) == dot_of(U, G, 6));
    FN(chs_se3_ad_twist)(U, V, back);
    for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(back[i] == -W[i]);
    FN(chs_se3_ad_twist)(V, V, W);
    for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(W[i] == 0);
  }
}

/* Ad(exp V) = exp(ad V), the terms of the series up to 2^-60 of the first. */
static void test_the_adjoint_of_exp_is_the_exponential_of_ad(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], ad[36], T[16], Ad[36];
    double sum[36];
    random_twist(uniform(0, 1), 1, V);
    FN(chs_se3_ad)(V, ad);
    power_series(ad, 6, 0, sum);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
    FN(chs_se3_adjoint)(T, Ad);
    for (int i = 0; i < 36; i++) ASSERT_WITHIN_EPS(sum[i], Ad[i], 30, 1);
  }
}

/* dT = T [V_b] and dT = [V_s] T; by cube rotations and integers without rounding. */
static void test_twists_of_a_rate_are_those_it_was_made_of(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], M[16], dT[16], V[6], found[6], in_space[6];
    cube_pose(k % CUBE_ROTATIONS, 99, T);
    random_integers(-99, 99, 6, V);
    FN(chs_se3_hat)(V, M);
    product_of(T, M, 4, 4, dT);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist)(T, dT, found));
    assert_equal(V, found, 6);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_space_twist)(T, dT, in_space));
    FN(chs_se3_adjoint_twist)(T, V, found);
    assert_equal(found, in_space, 6);
    FN(chs_se3_adjoint_inverse_twist)(T, in_space, found); /* v_b from v_s */
    assert_equal(V, found, 6);
    product_of(M, T, 4, 4, dT);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_space_twist)(T, dT, found));
    assert_equal(V, found, 6);
  }
}

static void test_rates_keep_their_promise_on_any_pose(void) {
  for (int k = 0; k < CASES; k++) {
    real T[16], M[16], dT[16], V[6], body[6], space[6], in_body[6];
    double reach = log_uniform(1e-2, 1e2);
    random_pose(reach, T);
    random_twist(log_uniform(1e-6, 1e2), log_uniform(1e-2, 1e2), V);
    FN(chs_se3_hat)(V, M);
    product_of(T, M, 4, 4, dT);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist)(T, dT, body));
    double rate = sqrt(2) * length_of(V, 3), speed = length_of(V + 3, 3);
    ASSERT_NORM_WITHIN_EPS(V, body, 3, CHS_EPS_SE3_BODY_TWIST_ROTATION + 1 + 2 * exp_in_norm, rate);
    ASSERT_NORM_WITHIN_EPS(V + 3, body + 3, 3, CHS_EPS_SE3_BODY_TWIST_TRANSLATION + 1 + 2 * exp_in_norm, speed);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_space_twist)(T, dT, space));
    FN(chs_se3_adjoint_inverse_twist)(T, space, in_body);
    ASSERT_NORM_WITHIN_EPS(V, in_body, 3, CHS_EPS_SE3_SPACE_TWIST_ROTATION + 6 + 4 * exp_in_norm, rate);
    ASSERT_NORM_WITHIN_EPS(V + 3, in_body + 3, 3, CHS_EPS_SE3_SPACE_TWIST_TRANSLATION + 10 + 4 * exp_in_norm,
                           speed + 2 * rate * reach);
  }
}

static void test_the_twist_between_poses_takes_one_to_the_other(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], body[6], space[6], step[16], end[16], dt = rounded(log_uniform(1e-3, 1e3));
    double reach = log_uniform(1e-1, 1e1);
    random_pose(reach, A);
    random_pose(reach, B);
    if (k % 2 == 0) { /* a small step */
      real V[6];
      random_twist(log_uniform(1e-8, 1e-1), log_uniform(1e-8, 1e-1), V);
      FN(chs_se3_exp)(V, step);
      FN(chs_se3_compose)(A, step, B);
    }
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist_between)(A, B, dt, body));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_space_twist_between)(A, B, dt, space));
    FN(chs_screw_move_body)(A, body, dt, end);
    ASSERT_ENTRIES_WITHIN_EPS(B, end, 12, 60, 1 + 2 * reach);
    FN(chs_screw_move_space)(A, space, dt, end);
    ASSERT_ENTRIES_WITHIN_EPS(B, end, 12, 90, 1 + 2 * reach);
    real opposite[6];
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist_between)(A, B, -dt, opposite));
    for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(opposite[i] == -body[i]);
  }
}

/* Two orientations that differ by a few units in the last place, where log(A^T B) would be noise. */
static void test_the_twist_of_the_smallest_turns_has_its_digits(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], V[6], Ra[9], Rb[9], p[3] = {1, 2, 3}, turned[9];
    double theta = log_uniform(PICK(1e-13, 1e-4), PICK(1e-7, 1e-2));
    random_rotation(Ra);
    for (int i = 0; i < 9; i++) {
      int column = i % 3;
      /* R + theta R [z], columns (x + theta y, y - theta x, z), rounded */
      double other = column == 0 ? (double)Ra[i + 1] : column == 1 ? -(double)Ra[i - 1] : 0;
      turned[i] = rounded((double)Ra[i] + theta * other);
    }
    memcpy(Rb, turned, sizeof Rb);
    FN(chs_se3_from_parts)(Ra, p, A);
    FN(chs_se3_from_parts)(Rb, p, B);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist_between)(A, B, 1, V));
    /* What the rounding of B's columns, half an eps an entry, makes of the turn, against the exact sum of products. */
    double expected[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
      double x = (double)Ra[3 * i], y = (double)Ra[3 * i + 1], z = (double)Ra[3 * i + 2];
      double dx = (double)Rb[3 * i] - x, dy = (double)Rb[3 * i + 1] - y, dz = (double)Rb[3 * i + 2] - z;
      expected[0] += z * dy - y * dz;
      expected[1] += x * dz - z * dx;
      expected[2] += y * dx - x * dy;
    }
    for (int i = 0; i < 3; i++)
      ASSERT_WITHIN_EPS(expected[i] / 2, V[i], CHS_EPS_SE3_BODY_TWIST_BETWEEN_ROTATION + 3 + theta / EPS * theta,
                        sqrt(2) * theta);
  }
}

static void test_no_time_has_no_twist_and_a_half_turn_a_conventional_one(void) {
  const real half[16] = {-1, 0, 0, 0, 0, -1, 0, 4, 0, 0, 1, 0, 0, 0, 0, 1};
  real V[6], T[16];
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, V, FN(chs_se3_body_twist_between)(identity4, half, 0, V));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, V, FN(chs_se3_space_twist_between)(identity4, half, -K(0.0), V));
  ASSERT_STATUS(CHS_HALF_TURN, FN(chs_se3_space_twist_between)(identity4, half, 2, V));
  ASSERT_WITHIN_EPS(PI / 2, V[2], CHS_EPS_SE3_SPACE_TWIST_BETWEEN_ROTATION, 2);
  ASSERT_STATUS(CHS_HALF_TURN, FN(chs_se3_interpolate)(identity4, half, K(0.5), T));
  /* About the line parallel to z through (0, 2, 0): half of the way the origin is at (2, 2, 0). */
  const real expected[16] = {0, -1, 0, 2, 1, 0, 0, 2, 0, 0, 1, 0, 0, 0, 0, 1};
  ASSERT_ENTRIES_WITHIN_EPS(expected, T, 16, CHS_EPS_SE3_INTERPOLATE_TRANSLATION, 3 * PI / 2);
}

static void test_interpolation_has_its_ends_exactly(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], T[16];
    random_pose(log_uniform(1e-3, 1e3), A);
    random_pose(log_uniform(1e-3, 1e3), B);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, B, 0, T));
    assert_equal(A, T, 16);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, B, 1, T));
    assert_equal(B, T, 16);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, A, rounded(uniform(-3, 3)), T));
    ASSERT_ENTRIES_WITHIN_EPS(A, T, 16, 0, 1);
  }
}

/* The twist from A to T is s times that from A to B; and the two halves of the way meet. */
static void test_interpolation_goes_at_constant_twist(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], T[16], V[6], part[6], scaled_twist[6], s = rounded(uniform(-0.9, 0.9));
    real step[16];
    random_pose(1, A);
    random_twist(uniform(0.1, 3), 1, V);
    FN(chs_se3_exp)(V, step);
    FN(chs_se3_compose)(A, step, B);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist_between)(A, B, 1, V));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, B, s, T));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_body_twist_between)(A, T, 1, part));
    scaled((double)s, V, 6, scaled_twist);
    ASSERT_NORM_WITHIN_EPS(scaled_twist, part, 6, 80, 4);
    real before[16], after[16];
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, B, K(0.5), before));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_interpolate)(A, B, NEXT_AFTER(K(0.5), 1), after));
    ASSERT_ENTRIES_WITHIN_EPS(before, after, 16, 30, 4);
  }
}

static void test_interpolation_beyond_the_range_is_refused(void) {
  const real quarter[16] = {0, -1, 0, 1, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const real far[16] = {1, 0, 0, REAL_MAX, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const real back[16] = {1, 0, 0, -REAL_MAX, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  real T[16], V[6], length, angle;
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_se3_interpolate)(identity4, quarter, ANGLE_MAX, T));
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, T, FN(chs_se3_interpolate)(identity4, quarter, REAL_MAX, T));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, T, FN(chs_se3_interpolate)(identity4, far, 2, T));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, T, FN(chs_se3_interpolate)(far, back, 0, T));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, V, FN(chs_se3_body_twist_between)(far, back, 1, V));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, V, FN(chs_se3_space_twist_between)(identity4, far, K(0.5), V));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, length, FN(chs_se3_distance)(far, back, &angle, &length));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, length, FN(chs_se3_weighted_distance)(far, back, 1, &length));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, length, FN(chs_se3_weighted_distance)(identity4, quarter, REAL_MAX, &length));
}

static void test_distances_are_those_of_the_parts(void) {
  for (int k = 0; k < CASES; k++) {
    real A[16], B[16], Ra[9], Rb[9], pa[3], pb[3], angle, length, theta, weighted, scale = rounded(uniform(0, 5));
    random_pose(log_uniform(1e-3, 1e3), A);
    random_pose(log_uniform(1e-3, 1e3), B);
    FN(chs_se3_to_parts)(A, Ra, pa);
    FN(chs_se3_to_parts)(B, Rb, pb);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_distance)(A, B, &angle, &length));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(Ra, Rb, &theta));
    ASSERT_SAME_BITS(&theta, &angle, 1);
    for (int i = 0; i < 3; i++) pb[i] -= pa[i];
    double expected = length_of(pb, 3);
    ASSERT_WITHIN_EPS(expected, length, CHS_EPS_SE3_DISTANCE_LENGTH, expected);
    expected = hypot((double)scale * (double)angle, (double)length);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_weighted_distance)(A, B, scale, &weighted));
    ASSERT_WITHIN_EPS(expected, weighted, CHS_EPS_SE3_WEIGHTED_DISTANCE, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_weighted_distance)(A, A, scale, &weighted));
    TEST_ASSERT_TRUE(weighted == 0);
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, weighted, FN(chs_se3_weighted_distance)(A, B, -K(1.0), &weighted));
  }
}

/* J is the sum of ad^n / (n + 1)!. */
static void test_the_left_jacobian_is_its_power_series(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], ad[36], J[36];
    double sum[36];
    random_twist(k % 2 ? uniform(0, 1) : random_angle(k / 2 % 3), 1, V);
    FN(chs_se3_ad)(V, ad);
    power_series(ad, 6, 1, sum);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian)(V, J));
    for (int i = 0; i < 36; i++) ASSERT_WITHIN_EPS(sum[i], J[i], CHS_EPS_SE3_LEFT_JACOBIAN_COUPLING + 2, 1);
  }
}

static void test_jacobians_and_their_inverses_make_the_identity(void) {
  static int (*const pairs[2][2])(const real *,
                                  real *) = {{FN(chs_se3_left_jacobian), FN(chs_se3_left_jacobian_inverse)},
                                             {FN(chs_se3_right_jacobian), FN(chs_se3_right_jacobian_inverse)}};
  for (int k = 0; k < CASES; k++)
    for (int side = 0; side < 2; side++) {
      real V[6], J[36], inverse[36], product[36];
      random_twist(k % 3 ? random_angle(k / 3) : uniform(PI, 6), log_uniform(1e-2, 1e2), V);
      double theta = length_of(V, 3), v = length_of(V + 3, 3), growth = fmax(1, theta / 2 / fabs(sin(theta / 2)));
      ASSERT_STATUS(CHS_OK, pairs[side][0](V, J));
      ASSERT_STATUS(CHS_OK, pairs[side][1](V, inverse));
      product_of(J, inverse, 6, 6, product);
      double coupling = CHS_EPS_SE3_LEFT_JACOBIAN_COUPLING + CHS_EPS_SE3_LEFT_JACOBIAN_INVERSE_COUPLING;
      double rotation = CHS_EPS_SO3_LEFT_JACOBIAN + CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE_BEYOND;
      for (int i = 0; i < 36; i++)
        ASSERT_WITHIN_EPS(i % 7 == 0, product[i], 3 * (coupling + rotation) + 2, growth * growth * (1 + v));
    }
}

static void test_the_right_jacobian_is_the_left_one_of_the_opposite_twist(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], minus[6], left[36], right[36];
    random_twist(k % 2 ? random_angle(k / 2) : uniform(PI, 6), 1, V);
    scaled(-1, V, 6, minus);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian)(minus, left));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_right_jacobian)(V, right));
    assert_equal(left, right, 36);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian_inverse)(minus, left));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_right_jacobian_inverse)(V, right));
    assert_equal(left, right, 36);
  }
}

/* J_l = Ad(exp V) J_r */
static void test_the_left_jacobian_is_the_right_one_seen_from_the_other_frame(void) {
  for (int k = 0; k < CASES; k++) {
    real V[6], T[16], Ad[36], left[36], right[36], product[36];
    random_twist(uniform(0, 6), 1, V);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, T));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian)(V, left));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_right_jacobian)(V, right));
    FN(chs_se3_adjoint)(T, Ad);
    product_of(Ad, right, 6, 6, product);
    ASSERT_ENTRIES_WITHIN_EPS(left, product, 36, 60, 1);
  }
}

/* exp(V + h U) = exp(h J_l U) exp(V) to first order: a central difference, whose error is of the order of h^2. */
static void test_the_left_jacobian_is_the_derivative_of_exp(void) {
  const double h = PICK(1e-5, 1e-2);
  for (int k = 0; k < CASES; k++) {
    real V[6], U[6], J[36], rate[6], ahead[6], behind[6], A[16], B[16], found[6];
    random_twist(uniform(0.1, 3), 1, V);
    random_twist(1, 1, U);
    for (int i = 0; i < 6; i++) {
      ahead[i] = rounded((double)V[i] + h * (double)U[i]);
      behind[i] = rounded((double)V[i] - h * (double)U[i]);
    }
    ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian)(V, J));
    product_of(J, U, 6, 1, rate);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(ahead, A));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(behind, B));
    ASSERT_STATUS(CHS_OK, FN(chs_se3_space_twist_between)(B, A, rounded(2 * h), found));
    for (int i = 0; i < 6; i++) TEST_ASSERT_DOUBLE_WITHIN(PICK(1e-9, 1e-3), (double)rate[i], (double)found[i]);
  }
}

static void test_jacobians_of_nothing_are_the_identity_and_of_a_translation_half_its_cross_product(void) {
  const real zero[6] = {0}, travel[6] = {0, 0, 0, 2, 4, 6};
  static int (*const all[4])(const real *, real *) = {FN(chs_se3_left_jacobian), FN(chs_se3_right_jacobian),
                                                      FN(chs_se3_left_jacobian_inverse),
                                                      FN(chs_se3_right_jacobian_inverse)};
  for (int f = 0; f < 4; f++) {
    real J[36], sign = f == 0 || f == 3 ? 1 : -1;
    ASSERT_STATUS(CHS_OK, all[f](zero, J));
    for (int i = 0; i < 36; i++) TEST_ASSERT_TRUE(J[i] == (i % 7 == 0));
    ASSERT_STATUS(CHS_OK, all[f](travel, J));
    TEST_ASSERT_TRUE(J[19] == -3 * sign && J[20] == 2 * sign && J[24] == 3 * sign && J[26] == -1 * sign);
    TEST_ASSERT_TRUE(J[30] == -2 * sign && J[31] == 1 * sign && J[18] == 0 && J[25] == 0 && J[32] == 0);
  }
}

static void test_jacobians_out_of_range_are_refused(void) {
  const real whole[6] = {0, 0, 2 * REAL_PI, 1, 0, 0}, far[6] = {0, NEXT_AFTER(ANGLE_MAX, REAL_MAX), 0, 1, 2, 3};
  const real fast[6] = {0, 0, 100, REAL_MAX, REAL_MAX, REAL_MAX};
  real J[36], V[6] = {0, 2 * ANGLE_MAX, 0, 1, 2, (real)NAN};
  ASSERT_REFUSES(CHS_ERR_SINGULAR, J, FN(chs_se3_left_jacobian_inverse)(whole, J));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, J, FN(chs_se3_right_jacobian_inverse)(whole, J));
  ASSERT_STATUS(CHS_OK, FN(chs_se3_left_jacobian)(whole, J));
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, J, FN(chs_se3_left_jacobian)(far, J));
  ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, J, FN(chs_se3_left_jacobian_inverse)(far, J));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, J, FN(chs_se3_right_jacobian)(fast, J));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, J, FN(chs_se3_right_jacobian_inverse)(fast, J));
  ASSERT_REFUSES(CHS_ERR_NAN, J, FN(chs_se3_left_jacobian)(V, J));
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_hat_puts_the_twist_where_the_header_says_and_vee_takes_it_back);
  RUN_TEST(test_exp_is_the_exponential_of_the_matrix);
  RUN_TEST(test_ad_applied_is_the_bracket_and_its_transpose);
  RUN_TEST(test_the_adjoint_of_exp_is_the_exponential_of_ad);
  RUN_TEST(test_twists_of_a_rate_are_those_it_was_made_of);
  RUN_TEST(test_rates_keep_their_promise_on_any_pose);
  RUN_TEST(test_the_twist_between_poses_takes_one_to_the_other);
  RUN_TEST(test_the_twist_of_the_smallest_turns_has_its_digits);
  RUN_TEST(test_no_time_has_no_twist_and_a_half_turn_a_conventional_one);
  RUN_TEST(test_interpolation_has_its_ends_exactly);
  RUN_TEST(test_interpolation_goes_at_constant_twist);
  RUN_TEST(test_interpolation_beyond_the_range_is_refused);
  RUN_TEST(test_distances_are_those_of_the_parts);
  RUN_TEST(test_the_left_jacobian_is_its_power_series);
  RUN_TEST(test_jacobians_and_their_inverses_make_the_identity);
  RUN_TEST(test_the_right_jacobian_is_the_left_one_of_the_opposite_twist);
  RUN_TEST(test_the_left_jacobian_is_the_right_one_seen_from_the_other_frame);
  RUN_TEST(test_the_left_jacobian_is_the_derivative_of_exp);
  RUN_TEST(test_jacobians_of_nothing_are_the_identity_and_of_a_translation_half_its_cross_product);
  RUN_TEST(test_jacobians_out_of_range_are_refused);
  return SUITE_END();
}
