#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                \
  PLAIN(so3_hat, "w", "M", (in[0], out[0]))                      \
  PLAIN(so3_vee, "W", "w", (in[0], out[0]))                      \
  CHECKED(so3_exp, "w", "M", (in[0], out[0]))                    \
  CHECKED(so3_log, "R", "w", (in[0], out[0]))                    \
  CHECKED(so3_left_jacobian, "w", "M", (in[0], out[0]))          \
  CHECKED(so3_right_jacobian, "w", "M", (in[0], out[0]))         \
  CHECKED(so3_left_jacobian_inverse, "w", "M", (in[0], out[0]))  \
  CHECKED(so3_right_jacobian_inverse, "w", "M", (in[0], out[0])) \
  PLAIN(so3_multiply, "MM", "M", (in[0], in[1], out[0]))         \
  PLAIN(so3_transpose, "M", "M", (in[0], out[0]))                \
  PLAIN(so3_apply, "Mx", "x", (in[0], in[1], out[0]))            \
  CHECKED(so3_angle, "RR", "a", (in[0], in[1], out[0]))          \
  CHECKED(so3_nearest, "M", "Ma", (in[0], out[0], out[1]))       \
  CHECKED(so3_deviation, "M", "a", (in[0], out[0]))              \
  CHECKED(so3_check, "Rt", "", (in[0], in[1][0]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

/* Bounds of the errors in eps, from the promises. An error of p eps in each entry of a matrix is one of 3 p in its
 * Frobenius norm, and turns the rotation it is read as by at most 3 p / sqrt(2). */
static const double exp_in_norm = 3 * CHS_EPS_SO3_EXP;
static const double exp_as_angle = 3 * CHS_EPS_SO3_EXP / 1.4142135623730951;

/* A rotation turned by a small angle has a rotation vector that moves by at most (theta/2)/sin(theta/2) times it. */
static double log_stretch(double theta) { return theta < 1e-3 ? 1 : theta / 2 / fabs(sin(theta / 2)); }

static void test_hat_gives_the_matrix_of_the_cross_product(void) {
  const real w[3] = {1, 2, 3}, expected[9] = {0, -3, 2, 3, 0, -1, -2, 1, 0};
  real W[9], x[3], y[3], wxx[3];
  FN(chs_so3_hat)(w, W);
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(expected[i] == W[i]);
  random_integers(-9, 9, 3, x);
  FN(chs_so3_apply)(W, x, y);
  cross_of(w, x, wxx);
  for (int i = 0; i < 3; i++) TEST_ASSERT_TRUE(wxx[i] == y[i]);
}

static void test_vee_takes_back_what_hat_gave_at_any_size(void) {
  const real vectors[][3] = {
      {1, 2, -3}, {SMALLEST, -SMALLEST, REAL_MIN}, {REAL_MAX, -REAL_MAX, REAL_MAX}, {REAL_MAX, SMALLEST, K(-0.1)}};
  for (int k = 0; k < LENGTH(vectors); k++) {
    real W[9], w[3];
    FN(chs_so3_hat)(vectors[k], W);
    FN(chs_so3_vee)(W, w);
    ASSERT_SAME_BITS(vectors[k], w, 3);
  }
}

static void test_vee_takes_the_skew_part(void) {
  const real W[9] = {9, 1, 8, 5, 9, 2, 4, 12, 9}, expected[3] = {5, 2, 2};
  real w[3];
  FN(chs_so3_vee)(W, w);
  ASSERT_SAME_BITS(expected, w, 3);
}

static void test_exp_of_zero_is_the_identity_without_negative_zeros(void) {
  const real zeros[2][3] = {{0, 0, 0}, {-K(0.0), -K(0.0), -K(0.0)}};
  for (int k = 0; k < 2; k++) {
    real R[9];
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(zeros[k], R));
    ASSERT_SAME_BITS(identity3, R, 9);
  }
}

static void test_exp_of_subnormal_vectors_loses_nothing(void) {
  const real w[3] = {SMALLEST, -3 * SMALLEST, REAL_MIN};
  real R[9], W[9];
  ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
  FN(chs_so3_hat)(w, W);
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(R[i] == (i % 4 == 0 ? K(1.0) : W[i]));
}

static void test_exp_turns_by_the_right_hand_rule(void) {
  for (int k = 0; k < 3; k++) {
    real w[3] = {0, 0, 0}, R[9], expected[9] = {0};
    w[k] = REAL_PI / 2;
    int i = (k + 1) % 3, j = (k + 2) % 3;
    expected[4 * k] = expected[3 * j + i] = 1;
    expected[3 * i + j] = -1;
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
    ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_SO3_EXP + 0.5, 1); /* pi/2 is rounded */
  }
}

static void test_exp_gives_a_rotation_at_every_angle(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], R[9], Rt[9], RRt[9];
    double theta = k % 2 ? log_uniform(PI, (double)ANGLE_MAX / 2) : random_angle(k / 2);
    random_vector(theta, w);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
    transpose_of(R, 3, Rt);
    product_of(R, Rt, 3, 3, RRt);
    /* Two rows with an error of the norm sqrt(3) p each, and the product's own rounding. */
    double p = k % 2 ? CHS_EPS_SO3_EXP_BEYOND : CHS_EPS_SO3_EXP;
    ASSERT_ENTRIES_WITHIN_EPS(identity3, RRt, 9, 2 * sqrt(3) * p + 2, 1);
  }
}

static void test_exp_of_the_opposite_vector_is_the_transpose(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], minus[3], R[9], Rt[9], back[9];
    random_vector(k % 2 ? uniform(PI, 100) : random_angle(k / 2), w);
    scaled(-1, w, 3, minus);
    FN(chs_so3_exp)(w, R);
    FN(chs_so3_exp)(minus, back);
    transpose_of(R, 3, Rt);
    ASSERT_SAME_BITS(Rt, back, 9);
  }
}

/* Angles that both formats hold; cosine and sine computed with 60 digits. */
static void test_exp_reduces_large_angles_modulo_2_pi(void) {
  const struct {
    double angle, cosine, sine;
  } known[] = {{355, -0.9999999995456589801659358, -0.00003014435335948844921433028},
               {0x1p20, 0.9438083939013119840061631, 0.330493140021734671639731},
               {0x1p48, 0.9915799420065793066320683, 0.1294960177388819127802101}};
  for (int k = 0; k < LENGTH(known) && known[k].angle <= (double)ANGLE_MAX; k++)
    for (int axis = 0; axis < 3; axis++) {
      real w[3] = {0, 0, 0}, R[9];
      int i = (axis + 1) % 3, j = (axis + 2) % 3;
      w[axis] = (real)known[k].angle;
      ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
      ASSERT_WITHIN_EPS(known[k].cosine, R[4 * i], CHS_EPS_SO3_EXP_BEYOND, 1);
      ASSERT_WITHIN_EPS(known[k].cosine, R[4 * j], CHS_EPS_SO3_EXP_BEYOND, 1);
      ASSERT_WITHIN_EPS(known[k].sine, R[3 * j + i], CHS_EPS_SO3_EXP_BEYOND, 1);
      ASSERT_WITHIN_EPS(-known[k].sine, R[3 * i + j], CHS_EPS_SO3_EXP_BEYOND, 1);
    }
}

/* Axes that are not unit vectors of the frame, so that the length of the vector is rounded as well. */
static void test_exp_reduces_the_exact_length_of_the_vector(void) {
  const struct {
    real w[3];
    double cosine, sine_ratio; /* cos(theta) and sin(theta)/theta, computed with 40 digits */
  } known[] = {{{7, -11, 13}, 0.90576992045646742587, -0.023016016687903032787},
               {{100, 200, -300}, -0.95041990317257826118, -0.00083110085194030867075},
               {{70000, -30000, 40000}, 0.98680489013748216401, 1.8822107760575047038e-6},
               {{600000, 500000, -400000}, 0.79311439819744914942, -6.9410275762693967852e-7}};
  for (int k = 0; k < LENGTH(known); k++) {
    const real *w = known[k].w;
    real R[9], expected[9];
    FN(chs_so3_hat)(w, expected);
    double b = (1 - known[k].cosine) / dot_of(w, w, 3);
    for (int i = 0; i < 9; i++)
      expected[i] = rounded((i % 4 == 0 ? known[k].cosine : known[k].sine_ratio * (double)expected[i]) +
                            b * (double)w[i / 3] * (double)w[i % 3]);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
    ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_SO3_EXP_BEYOND + 2, 1); /* 2: the test's own rounding */
  }
}

static void test_exp_of_twice_the_vector_is_the_square(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], twice[3], R[9], RR[9], square[9];
    random_vector(log_uniform(1e-3, (double)ANGLE_MAX / 2), w);
    scaled(2, w, 3, twice);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(w, R));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_exp)(twice, square));
    product_of(R, R, 3, 3, RR);
    double p = CHS_EPS_SO3_EXP_BEYOND; /* of the square, and of both factors of each product of rows and columns */
    ASSERT_ENTRIES_WITHIN_EPS(RR, square, 9, p + 2 * sqrt(3) * p + 1, 1);
  }
}

static void test_angles_beyond_the_range_are_refused(void) {
  const real most = ANGLE_MAX, more = NEXT_AFTER(ANGLE_MAX, REAL_MAX), part = K(0.75) * ANGLE_MAX;
  const real within[][3] = {{0, most, 0}, {0, 0, -most}, {K(0.6) * most, 0, K(0.75) * most}};
  const real beyond[][3] = {{more, 0, 0}, {0, -more, 0}, {part, 0, part}, {REAL_MAX, REAL_MAX, -REAL_MAX}};
  for (int f = 0; f < LENGTH(functions); f++) {
    if (functions[f].inputs[0] != 'w' || !functions[f].checked) continue;
    example e;
    subject = functions[f].name;
    for (int k = 0; k < LENGTH(within); k++) {
      memcpy(e.in[0], within[k], sizeof within[k]);
      run(functions + f, &e);
      if (e.status != CHS_ERR_SINGULAR) ASSERT_STATUS(CHS_OK, e.status); /* some inverses do not exist there */
    }
    for (int k = 0; k < LENGTH(beyond); k++) {
      memcpy(e.in[0], beyond[k], sizeof beyond[k]);
      assert_refused(functions + f, &e, CHS_ERR_ANGLE_RANGE);
    }
  }
}

static void test_log_of_the_identity_is_zero_without_negative_zeros(void) {
  const real zero[3] = {0, 0, 0};
  real w[3];
  ASSERT_STATUS(CHS_OK, FN(chs_so3_log)(identity3, w));
  ASSERT_SAME_BITS(zero, w, 3);
}

static void test_log_at_half_turn_makes_the_first_component_positive(void) {
  const int axes[][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, -1, 0}, {0, 1, 1},
                         {0, 1, -1}, {1, 0, 1},  {1, 0, -1}, {1, 1, 1},  {1, -1, 1}, {1, 1, -1},
                         {1, 2, 2},  {2, -1, 2}, {2, 3, -6}, {0, 3, -4}, {1, -2, -3}};
  for (int k = 0; k < LENGTH(axes); k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      turn q = turn_of(0, sign * axes[k][0], sign * axes[k][1], sign * axes[k][2]);
      real R[9], w[3], axis[3], expected[3];
      turn_matrix(&q, R);
      turn_axis(&q, axis);
      scaled(PI, axis, 3, expected);
      ASSERT_STATUS(CHS_HALF_TURN, FN(chs_so3_log)(R, w));
      /* R is rounded by eps/2 at most, expected by eps. */
      ASSERT_NORM_WITHIN_EPS(expected, w, 3, CHS_EPS_SO3_LOG + (PI / 2) * 1.5 / sqrt(2) / PI + 1, PI);
      for (int i = 0; i < 3; i++)
        if (axes[k][i] == 0) ASSERT_SAME_BITS(axis + i, w + i, 1);
    }
}

static void test_log_says_half_turn_only_where_the_sign_is_not_resolved(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], R[9], back[3];
    random_vector(PI - log_uniform(40 * EPS, 0.1), w);
    FN(chs_so3_exp)(w, R);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_log)(R, back));
    TEST_ASSERT_TRUE(dot_of(w, back, 3) > 0);
  }
  for (int k = 0; k < 3; k++) { /* pi as the format has it: less than an eps from a half-turn, in one direction */
    real w[3] = {0, 0, 0}, R[9], back[3];
    w[k] = -REAL_PI;
    FN(chs_so3_exp)(w, R);
    ASSERT_STATUS(CHS_HALF_TURN, FN(chs_so3_log)(R, back));
  }
}

static void test_log_takes_back_what_exp_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], R[9], back[3];
    random_vector(random_angle(k), w);
    double theta = length_of(w, 3);
    FN(chs_so3_exp)(w, R);
    int status = FN(chs_so3_log)(R, back);
    if (status == CHS_HALF_TURN && dot_of(w, back, 3) < 0) scaled(-1, back, 3, back);
    ASSERT_NORM_WITHIN_EPS(w, back, 3, CHS_EPS_SO3_LOG + PI / 2 * exp_as_angle, theta);
  }
}

static void test_exp_takes_back_what_log_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real u[3], A[9], B[9], R[9], w[3], back[9];
    random_vector(random_angle(k), u);
    FN(chs_so3_exp)(u, A);
    cube_rotation(k % CUBE_ROTATIONS, B);
    FN(chs_so3_multiply)(A, B, R);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_so3_log)(R, w));
    FN(chs_so3_exp)(w, back);
    /* R itself is exp_in_norm away from the rotation that is found. */
    ASSERT_ENTRIES_WITHIN_EPS(R, back, 9, CHS_EPS_SO3_EXP + CHS_EPS_SO3_LOG * PI + exp_in_norm, 1);
  }
}

static void test_log_finds_axis_and_angle_of_rational_rotations(void) {
  for (int k = 0; k < CASES; k++) {
    turn q = random_turn(integer(1, 9));
    real R[9], w[3], expected[3];
    turn_matrix(&q, R);
    turn_axis(&q, expected);
    double theta = turn_angle(&q);
    scaled(theta, expected, 3, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_log)(R, w));
    /* R is rounded by eps/2 at most in each entry, expected twice. */
    ASSERT_NORM_WITHIN_EPS(expected, w, 3, CHS_EPS_SO3_LOG * theta + log_stretch(theta) * 1.5 / sqrt(2) + theta, 1);
  }
}

typedef int (*jacobian)(const real w[3], real J[9]);

static void test_jacobians_at_zero_are_the_identity(void) {
  const jacobian all[] = {FN(chs_so3_left_jacobian), FN(chs_so3_right_jacobian), FN(chs_so3_left_jacobian_inverse),
                          FN(chs_so3_right_jacobian_inverse)};
  const real zeros[2][3] = {{0, 0, 0}, {-K(0.0), -K(0.0), -K(0.0)}};
  for (int k = 0; k < LENGTH(all); k++)
    for (int z = 0; z < 2; z++) {
      real J[9];
      ASSERT_STATUS(CHS_OK, all[k](zeros[z], J));
      ASSERT_SAME_BITS(identity3, J, 9);
    }
}

/* (theta/2) cot(theta/2) at 0.016 rad from 4903 turns, or in float at 0.26 from 45, where little is left of the angle. */
static void test_an_inverse_jacobian_near_many_turns_keeps_its_digits(void) {
  const real w[3] = {0, 0, (real)PICK(0x1.e159e4b8c5c8cp+14, 283.0)};
  const double k = PICK(1949736.2331881734337, 1096.5614040145073882);
  real J[9];
  ASSERT_STATUS(CHS_OK, FN(chs_so3_left_jacobian_inverse)(w, J));
  ASSERT_WITHIN_EPS(k, J[0], CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE_BEYOND, k);
  ASSERT_WITHIN_EPS(k, J[4], CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE_BEYOND, k);
}

/* a I + b [w] + c w w^T with the first terms of the series in theta^2, enough up to 0.01 rad. */
static void test_jacobians_of_small_vectors_are_as_exact_off_the_diagonal_as_the_vector(void) {
  const struct {
    jacobian of;
    double a[3], b[3], c[3], promise;
  } all[] = {{FN(chs_so3_left_jacobian),
              {1, -1. / 6, 1. / 120},
              {1. / 2, -1. / 24, 1. / 720},
              {1. / 6, -1. / 120, 1. / 5040},
              CHS_EPS_SO3_LEFT_JACOBIAN},
             {FN(chs_so3_right_jacobian),
              {1, -1. / 6, 1. / 120},
              {-1. / 2, 1. / 24, -1. / 720},
              {1. / 6, -1. / 120, 1. / 5040},
              CHS_EPS_SO3_RIGHT_JACOBIAN},
             {FN(chs_so3_left_jacobian_inverse),
              {1, -1. / 12, -1. / 720},
              {-1. / 2, 0, 0},
              {1. / 12, 1. / 720, 1. / 30240},
              CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE},
             {FN(chs_so3_right_jacobian_inverse),
              {1, -1. / 12, -1. / 720},
              {1. / 2, 0, 0},
              {1. / 12, 1. / 720, 1. / 30240},
              CHS_EPS_SO3_RIGHT_JACOBIAN_INVERSE}};
  for (int k = 0; k < CASES; k++)
    for (int m = 0; m < LENGTH(all); m++) {
      real w[3], J[9], W[9];
      double theta = k % 2 ? log_uniform(1e-9, 1e-2) : log_uniform(PICK(1e-300, 1e-36), 1e-9);
      random_vector(theta, w);
      ASSERT_STATUS(CHS_OK, all[m].of(w, J));
      FN(chs_so3_hat)(w, W);
      const double tt = dot_of(w, w, 3), *p = all[m].a, *q = all[m].b, *r = all[m].c;
      double a = p[0] + tt * (p[1] + tt * p[2]), b = q[0] + tt * (q[1] + tt * q[2]), c = r[0] + tt * (r[1] + tt * r[2]);
      for (int i = 0; i < 9; i++) {
        double rest = b * (double)W[i] + c * (double)w[i / 3] * (double)w[i % 3];
        if (i % 4 == 0)
          ASSERT_WITHIN_EPS(a + rest, J[i], all[m].promise + 1, 1);
        else
          ASSERT_WITHIN_EPS(rest, J[i], all[m].promise + 1, theta); /* 1: the test's own rounding */
      }
    }
}

static void test_right_jacobian_is_the_left_one_of_the_opposite_vector_and_its_transpose(void) {
  const jacobian pairs[][2] = {{FN(chs_so3_left_jacobian), FN(chs_so3_right_jacobian)},
                               {FN(chs_so3_left_jacobian_inverse), FN(chs_so3_right_jacobian_inverse)}};
  for (int k = 0; k < CASES; k++)
    for (int m = 0; m < 2; m++) {
      real w[3], minus[3], left[9], right[9], opposite[9], transposed[9];
      random_vector(k % 2 ? uniform(PI, 100) : random_angle(k / 2), w);
      scaled(-1, w, 3, minus);
      int status = pairs[m][0](w, left);
      ASSERT_STATUS(status, pairs[m][1](w, right));
      ASSERT_STATUS(status, pairs[m][0](minus, opposite));
      if (status == CHS_ERR_SINGULAR) continue; /* too near to a multiple of 2 pi */
      ASSERT_STATUS(CHS_OK, status);
      transpose_of(left, 3, transposed);
      ASSERT_SAME_BITS(opposite, right, 9);
      ASSERT_SAME_BITS(transposed, right, 9);
    }
}

static void test_jacobian_times_its_inverse_is_the_identity(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], J[9], inverse[9], product[9];
    int beyond = k % 3 == 0;
    random_vector(beyond ? uniform(PI, 50) : random_angle(k / 2), w);
    double theta = length_of(w, 3), stretch = fmax(1, log_stretch(theta)); /* of the inverse; J does not stretch */
    ASSERT_STATUS(CHS_OK, FN(chs_so3_left_jacobian)(w, J));
    if (FN(chs_so3_left_jacobian_inverse)(w, inverse) == CHS_ERR_SINGULAR)
      continue; /* too near to a multiple of 2 pi */
    product_of(J, inverse, 3, 3, product);
    double p = beyond ? CHS_EPS_SO3_LEFT_JACOBIAN_BEYOND : CHS_EPS_SO3_LEFT_JACOBIAN;
    double q = beyond ? CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE_BEYOND : CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE;
    ASSERT_ENTRIES_WITHIN_EPS(identity3, product, 9, 3 * p + 3 * q + 1, stretch);
  }
}

/* The angle, a multiple of 2 pi, is rounded by eps/2 of itself; 64 eps farther on it is resolved. */
static void test_jacobian_inverse_is_refused_where_only_rounding_keeps_it_from_being_singular(void) {
  const jacobian inverses[] = {FN(chs_so3_left_jacobian_inverse), FN(chs_so3_right_jacobian_inverse)};
  for (int k = 1; k < CASES; k++)
    for (int m = 0; m < 2; m++) {
      real w[3] = {0, 0, 0}, J[9];
      w[k % 3] = rounded(2 * PI * k);
      ASSERT_REFUSES(CHS_ERR_SINGULAR, J, inverses[m](w, J));
      w[k % 3] *= (real)(1 + 64 * EPS);
      ASSERT_STATUS(CHS_OK, inverses[m](w, J));
    }
}

/* (exp(w + h u) - exp(w - h u)) / 2h = [J u] exp(w) to within h^2/6, since the third derivative along a unit vector u
 * is a mean of products of three [u] and rotations; and exp's error in the norm is divided by h. */
static void test_left_jacobian_is_the_derivative_of_exp(void) {
  const double h = PICK(0x1p-17, 0x1p-8);
  for (int k = 0; k < CASES; k++)
    for (int axis = 0; axis < 3; axis++) {
      real w[3], ahead[3], behind[3], R[9], Rt[9], there[9], before[9], change[9], derivative[9], J[9], column[3],
          expected[9];
      random_vector(uniform(0.01, 3), w);
      for (int i = 0; i < 3; i++) w[i] = ahead[i] = behind[i] = rounded(h * floor((double)w[i] / h));
      ahead[axis] += (real)h;
      behind[axis] -= (real)h;
      FN(chs_so3_exp)(w, R);
      FN(chs_so3_exp)(ahead, there);
      FN(chs_so3_exp)(behind, before);
      for (int i = 0; i < 9; i++) change[i] = rounded((double)(there[i] - before[i]) / (2 * h));
      transpose_of(R, 3, Rt);
      product_of(change, Rt, 3, 3, derivative);
      FN(chs_so3_left_jacobian)(w, J);
      set(column, J[axis], J[3 + axis], J[6 + axis]);
      FN(chs_so3_hat)(column, expected);
      double truncated = h * h / 6 / EPS, rounded = exp_in_norm / h + exp_in_norm + 2;
      ASSERT_ENTRIES_WITHIN_EPS(expected, derivative, 9, CHS_EPS_SO3_LEFT_JACOBIAN + truncated + rounded, 1);
    }
}

static void test_products_of_integers_are_exact(void) {
  for (int k = 0; k < CASES; k++) {
    real A[9], B[9], C[9], At[9], x[3], y[3], expected[9];
    random_integers(-99, 99, 9, A);
    random_integers(-99, 99, 9, B);
    random_integers(-99, 99, 3, x);
    FN(chs_so3_multiply)(A, B, C);
    product_of(A, B, 3, 3, expected);
    for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(expected[i] == C[i]);
    FN(chs_so3_apply)(A, x, y);
    product_of(A, x, 3, 1, expected);
    for (int i = 0; i < 3; i++) TEST_ASSERT_TRUE(expected[i] == y[i]);
    FN(chs_so3_transpose)(A, At);
    transpose_of(A, 3, expected);
    ASSERT_SAME_BITS(expected, At, 9);
  }
}

static void test_products_keep_their_promise(void) {
  for (int k = 0; k < CASES; k++) {
    real A[9], B[9], C[9], x[3], y[3], expected[9];
    random_rotation(A);
    random_rotation(B);
    random_vector(log_uniform(1e-3, 1e3), x);
    FN(chs_so3_multiply)(A, B, C);
    product_of(A, B, 3, 3, expected);
    ASSERT_ENTRIES_WITHIN_EPS(expected, C, 9, CHS_EPS_SO3_MULTIPLY, length_of(A, 9) * length_of(B, 9));
    FN(chs_so3_apply)(A, x, y);
    product_of(A, x, 3, 1, expected);
    ASSERT_NORM_WITHIN_EPS(expected, y, 3, CHS_EPS_SO3_APPLY, length_of(A, 9) * length_of(x, 3));
  }
}

static void test_angle_between_equal_rotations_is_zero(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], angle, zero = 0;
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(R, R, &angle));
    ASSERT_SAME_BITS(&zero, &angle, 1);
  }
}

static void test_angle_from_the_identity_is_the_length_of_the_rotation_vector(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], R[9], angle;
    random_vector(random_angle(k), w);
    double theta = length_of(w, 3);
    FN(chs_so3_exp)(w, R);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(identity3, R, &angle));
    ASSERT_WITHIN_EPS(theta, angle, CHS_EPS_SO3_ANGLE + exp_as_angle, theta);
  }
}

static void test_angle_of_half_turns_is_pi(void) {
  for (int axis = 0; axis < 3; axis++)
    for (int k = 0; k < CUBE_ROTATIONS; k++) {
      real A[9], B[9], half_turn[9], angle;
      cube_rotation(k, A);
      for (int i = 0; i < 9; i++) half_turn[i] = i % 4 == 0 ? (i == 4 * axis ? K(1.0) : -K(1.0)) : 0;
      FN(chs_so3_multiply)(A, half_turn, B);
      ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(A, B, &angle));
      ASSERT_WITHIN_EPS(PI, angle, CHS_EPS_SO3_ANGLE, PI);
    }
}

/* Cube rotations, because products with them are exact, so that even tiny angles survive. */
static void test_angle_is_symmetric_and_the_same_for_a_common_rotation_on_either_side(void) {
  for (int k = 0; k < CASES; k++) {
    real A[9], B[9], Q[9], QA[9], QB[9], AQ[9], BQ[9], w[3], angle, other;
    random_vector(random_angle(k), w);
    FN(chs_so3_exp)(w, B);
    if (k % 2) {
      random_rotation(A);
      FN(chs_so3_multiply)(A, B, B); /* near each other, wherever they are, as often as not */
    } else {
      memcpy(A, identity3, sizeof A);
    }
    cube_rotation(k % CUBE_ROTATIONS, Q);
    FN(chs_so3_multiply)(Q, A, QA);
    FN(chs_so3_multiply)(Q, B, QB);
    FN(chs_so3_multiply)(A, Q, AQ);
    FN(chs_so3_multiply)(B, Q, BQ);
    double apart = distance_of(A, B, 9);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(A, B, &angle));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(B, A, &other));
    ASSERT_WITHIN_EPS(angle, other, 2 * CHS_EPS_SO3_ANGLE, apart);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(QA, QB, &other));
    ASSERT_WITHIN_EPS(angle, other, 2 * CHS_EPS_SO3_ANGLE, apart);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(AQ, BQ, &other));
    ASSERT_WITHIN_EPS(angle, other, 2 * CHS_EPS_SO3_ANGLE, apart);
  }
}

/* B = A + D with a tiny D, the difference being exact: twice the angle is |sum a_k x d_k|, k the columns. */
static void test_angle_between_near_orientations_is_resolved_to_its_own_size(void) {
  for (int k = 0; k < CASES; k++) {
    real A[9], B[9], w[3], small[9], s[3] = {0, 0, 0}, angle;
    random_rotation(A);
    random_vector(log_uniform(8 * EPS, PICK(1e-9, 1e-5)), w);
    FN(chs_so3_exp)(w, small);
    FN(chs_so3_multiply)(small, A, B);
    for (int j = 0; j < 3; j++) {
      real a[3] = {A[j], A[3 + j], A[6 + j]}, d[3] = {B[j] - A[j], B[3 + j] - A[3 + j], B[6 + j] - A[6 + j]}, axd[3];
      cross_of(a, d, axd);
      for (int i = 0; i < 3; i++) s[i] += axd[i];
    }
    ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(A, B, &angle));
    ASSERT_WITHIN_EPS(length_of(s, 3) / 2, angle, CHS_EPS_SO3_ANGLE + 2, distance_of(A, B, 9)); /* 2: the test's */
  }
}

static void test_nearest_to_a_rotation_is_that_rotation(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], nearest[9], distance;
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(R, nearest, &distance));
    ASSERT_ENTRIES_WITHIN_EPS(R, nearest, 9, CHS_EPS_SO3_NEAREST_ROTATION + exp_in_norm, 1);
    ASSERT_WITHIN_EPS(0, distance, CHS_EPS_SO3_NEAREST_DISTANCE * 2 * sqrt(3) + exp_in_norm, 1);
  }
  for (int k = 0; k < CUBE_ROTATIONS; k++) {
    real R[9], nearest[9], distance;
    cube_rotation(k, R);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(R, nearest, &distance));
    ASSERT_ENTRIES_WITHIN_EPS(R, nearest, 9, CHS_EPS_SO3_NEAREST_ROTATION, 1);
  }
}

/* R S with S diagonal of powers of two, so that nothing is rounded; also of rank 2. */
static void test_nearest_takes_stretching_away(void) {
  const struct {
    real s[3];
    double condition, square; /* 2 s1/(s2 + s3) and |S - I|^2 */
  } stretches[] = {{{4, 2, 1}, 8.0 / 3, 10}, {{1, 4, 2}, 8.0 / 3, 10}, {{K(0.25), 4, K(0.5)}, 8 / 0.75, 9.8125},
                   {{1, 1, 0}, 2, 1},        {{0, 2, 1}, 4, 2},        {{8, 0, 8}, 2, 99}};
  for (int k = 0; k < CASES; k++) {
    real R[9], M[9], nearest[9], distance;
    const real *s = stretches[k % LENGTH(stretches)].s;
    double condition = stretches[k % LENGTH(stretches)].condition;
    random_rotation(R);
    for (int i = 0; i < 9; i++) M[i] = R[i] * s[i % 3];
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, nearest, &distance));
    /* R is exp_in_norm away from a rotation, M up to s1 times that; the nearest rotation turns by 2/(s2 + s3) of it. */
    ASSERT_ENTRIES_WITHIN_EPS(R, nearest, 9, CHS_EPS_SO3_NEAREST_ROTATION * condition + 2 * condition * exp_in_norm, 1);
    double most = fmax((double)s[0], fmax((double)s[1], (double)s[2]));
    ASSERT_WITHIN_EPS(sqrt(stretches[k % LENGTH(stretches)].square), distance,
                      CHS_EPS_SO3_NEAREST_DISTANCE * (length_of(M, 9) + sqrt(3)) + exp_in_norm * (most + 1), 1);
  }
}

/* R^T M is symmetric and positive: that is what makes R the nearest. */
static void test_nearest_satisfies_the_condition_of_a_minimum(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], M[9], nearest[9], transposed[9], S[9];
    random_rotation(R);
    for (int i = 0; i < 9; i++) M[i] = R[i] + (real)uniform(-0.2, 0.2); /* |noise| <= 0.6: s1 <= 1.6, s3 >= 0.4 */
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, nearest, NULL));
    transpose_of(nearest, 3, transposed);
    product_of(transposed, M, 3, 3, S);
    double allowed = 2 * 3 * CHS_EPS_SO3_NEAREST_ROTATION * (2 * 1.6 / 0.8) + 2;
    ASSERT_WITHIN_EPS(S[1], S[3], allowed, length_of(M, 9));
    ASSERT_WITHIN_EPS(S[2], S[6], allowed, length_of(M, 9));
    ASSERT_WITHIN_EPS(S[5], S[7], allowed, length_of(M, 9));
    TEST_ASSERT_TRUE(S[0] > 0 && S[4] > 0 && S[8] > 0);
  }
}

static void test_nearest_is_the_same_at_any_scale(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], M[9], N[9], nearest[9], other[9], distance;
    random_rotation(R);
    for (int i = 0; i < 9; i++) {
      M[i] = R[i] + (real)uniform(-0.2, 0.2);
      N[i] = (real)ldexp((double)M[i], k % 2 ? PICK(-900, -90) : PICK(1000, 120));
    }
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, nearest, NULL));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(N, other, &distance));
    ASSERT_SAME_BITS(nearest, other, 9);
    double expected = k % 2 ? sqrt(3) : length_of(N, 9); /* one of the two is lost in the other */
    ASSERT_WITHIN_EPS(expected, distance, CHS_EPS_SO3_NEAREST_DISTANCE, expected);
  }
}

static void test_nearest_is_the_same_without_the_distance(void) {
  real M[9], with[9], without[9], distance;
  random_rotation(M);
  M[3] += K(0.5);
  ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, with, &distance));
  ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, without, NULL));
  ASSERT_SAME_BITS(with, without, 9);
}

static void test_nearest_refuses_reflections_and_what_has_no_single_nearest_rotation(void) {
  const struct {
    int status;
    real M[9];
  } refused[] = {
      {CHS_ERR_REFLECTION, {1, 0, 0, 0, 1, 0, 0, 0, -1}}, {CHS_ERR_REFLECTION, {-3, 0, 0, 0, -2, 0, 0, 0, -1}},
      {CHS_ERR_REFLECTION, {0, 1, 0, 1, 0, 0, 0, 0, 1}},  {CHS_ERR_SINGULAR, {0}},
      {CHS_ERR_SINGULAR, {1, 0, 0, 0, 0, 0, 0, 0, 0}},    {CHS_ERR_SINGULAR, {1, 2, 3, 2, 4, 6, 3, 6, 9}},
  };
  for (int k = 0; k < LENGTH(refused); k++) {
    struct {
      real R[9], distance;
    } out;
    ASSERT_REFUSES(refused[k].status, out, FN(chs_so3_nearest)(refused[k].M, out.R, &out.distance));
  }
}

/* Correlation matrices of points in a plane or on a line, whose determinants and cofactors are nothing but rounding. */
static void test_nearest_takes_rank_two_and_no_less_whatever_rounding_left(void) {
  for (int k = 0; k < CASES; k++) {
    real a[4][3], M[9], flat[9];
    for (int i = 0; i < 4; i++) random_vector(1, a[i]);
    for (int i = 0; i < 9; i++) {
      flat[i] = rounded((double)a[0][i / 3] * (double)a[1][i % 3]);
      M[i] = rounded((double)flat[i] + (double)a[2][i / 3] * (double)a[3][i % 3]);
    }
    real R[9];
    ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_so3_nearest)(flat, R, NULL));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_nearest)(M, R, NULL));
    TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(8 * EPS)));
  }
}

/* Exactly as defined at CHS_SO3_FAR; numbers of few bits. */
static void test_deviation_is_the_largest_of_the_defects(void) {
  const real d = K(0x1p-8);
  const struct {
    real R[9], deviation;
  } known[] = {
      {{1, 0, 0, 0, 1, 0, 0, 0, 1}, 0},
      {{1 + d, 0, 0, 0, 1, 0, 0, 0, 1}, 2 * d + d * d},
      {{1, 0, 0, 0, 1 - d, 0, 0, 0, 1}, 2 * d - d * d},
      {{1, 0, 0, 0, 1, 0, 0, 0, 1 + d}, d},
      {{1, 0, 0, d, 1, 0, 0, -d, 1}, d},
      {{1, 0, 0, 0, 1, 0, 2 * d, 0, 1}, 2 * d},
      {{1, 0, 0, 0, 1, 0, 0, 0, -1}, 2},
      {{2, 0, 0, 0, 2, 0, 0, 0, 2}, 3},
      {{0}, 1},
  };
  for (int k = 0; k < LENGTH(known); k++) {
    real deviation;
    ASSERT_STATUS(CHS_OK, FN(chs_so3_deviation)(known[k].R, &deviation));
    ASSERT_SAME_BITS(&known[k].deviation, &deviation, 1);
  }
}

static void test_deviation_beyond_the_range_is_an_overflow(void) {
  const real huge[9] = {REAL_MAX, 0, 0, 0, 1, 0, 0, 0, 1};
  real deviation;
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, deviation, FN(chs_so3_deviation)(huge, &deviation));
}

static void test_a_nearest_rotation_at_a_distance_beyond_the_range_is_an_overflow(void) {
  const real huge[9] = {REAL_MAX, 0, 0, 0, REAL_MAX, 0, 0, 0, REAL_MAX};
  real distance, R[9];
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, distance, FN(chs_so3_nearest)(huge, R, &distance));
}

static void test_check_compares_the_deviation_with_the_tolerance(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], deviation;
    random_rotation(R);
    R[integer(0, 8)] += (real)uniform(-0.3, 0.3);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_deviation)(R, &deviation));
    ASSERT_STATUS(CHS_OK, FN(chs_so3_check)(R, deviation));
    ASSERT_STATUS(CHS_ERR_NOT_ROTATION, FN(chs_so3_check)(R, NEXT_AFTER(deviation, 0)));
  }
}

static void test_check_calls_a_reflection_so_whatever_the_tolerance(void) {
  for (int k = 0; k < LENGTH(bad_rotations); k++)
    if (bad_rotations[k].status == CHS_ERR_REFLECTION)
      for (int t = 0; t < 4; t++)
        ASSERT_STATUS(CHS_ERR_REFLECTION, FN(chs_so3_check)(bad_rotations[k].R, (real)(0.1 * pow(10, t))));
}

static void test_check_with_a_tolerance_that_is_nan_accepts_nothing(void) {
  ASSERT_STATUS(CHS_ERR_NOT_ROTATION, FN(chs_so3_check)(identity3, (real)NAN));
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_hat_gives_the_matrix_of_the_cross_product);
  RUN_TEST(test_vee_takes_back_what_hat_gave_at_any_size);
  RUN_TEST(test_vee_takes_the_skew_part);
  RUN_TEST(test_exp_of_zero_is_the_identity_without_negative_zeros);
  RUN_TEST(test_exp_of_subnormal_vectors_loses_nothing);
  RUN_TEST(test_exp_turns_by_the_right_hand_rule);
  RUN_TEST(test_exp_gives_a_rotation_at_every_angle);
  RUN_TEST(test_exp_of_the_opposite_vector_is_the_transpose);
  RUN_TEST(test_exp_reduces_large_angles_modulo_2_pi);
  RUN_TEST(test_exp_reduces_the_exact_length_of_the_vector);
  RUN_TEST(test_exp_of_twice_the_vector_is_the_square);
  RUN_TEST(test_angles_beyond_the_range_are_refused);
  RUN_TEST(test_log_of_the_identity_is_zero_without_negative_zeros);
  RUN_TEST(test_log_at_half_turn_makes_the_first_component_positive);
  RUN_TEST(test_log_says_half_turn_only_where_the_sign_is_not_resolved);
  RUN_TEST(test_log_takes_back_what_exp_gave);
  RUN_TEST(test_exp_takes_back_what_log_gave);
  RUN_TEST(test_log_finds_axis_and_angle_of_rational_rotations);
  RUN_TEST(test_jacobians_at_zero_are_the_identity);
  RUN_TEST(test_an_inverse_jacobian_near_many_turns_keeps_its_digits);
  RUN_TEST(test_jacobians_of_small_vectors_are_as_exact_off_the_diagonal_as_the_vector);
  RUN_TEST(test_right_jacobian_is_the_left_one_of_the_opposite_vector_and_its_transpose);
  RUN_TEST(test_jacobian_times_its_inverse_is_the_identity);
  RUN_TEST(test_jacobian_inverse_is_refused_where_only_rounding_keeps_it_from_being_singular);
  RUN_TEST(test_left_jacobian_is_the_derivative_of_exp);
  RUN_TEST(test_products_of_integers_are_exact);
  RUN_TEST(test_products_keep_their_promise);
  RUN_TEST(test_angle_between_equal_rotations_is_zero);
  RUN_TEST(test_angle_from_the_identity_is_the_length_of_the_rotation_vector);
  RUN_TEST(test_angle_of_half_turns_is_pi);
  RUN_TEST(test_angle_is_symmetric_and_the_same_for_a_common_rotation_on_either_side);
  RUN_TEST(test_angle_between_near_orientations_is_resolved_to_its_own_size);
  RUN_TEST(test_nearest_to_a_rotation_is_that_rotation);
  RUN_TEST(test_nearest_takes_stretching_away);
  RUN_TEST(test_nearest_satisfies_the_condition_of_a_minimum);
  RUN_TEST(test_nearest_is_the_same_at_any_scale);
  RUN_TEST(test_nearest_is_the_same_without_the_distance);
  RUN_TEST(test_nearest_refuses_reflections_and_what_has_no_single_nearest_rotation);
  RUN_TEST(test_nearest_takes_rank_two_and_no_less_whatever_rounding_left);
  RUN_TEST(test_deviation_is_the_largest_of_the_defects);
  RUN_TEST(test_a_nearest_rotation_at_a_distance_beyond_the_range_is_an_overflow);
  RUN_TEST(test_deviation_beyond_the_range_is_an_overflow);
  RUN_TEST(test_check_compares_the_deviation_with_the_tolerance);
  RUN_TEST(test_check_calls_a_reflection_so_whatever_the_tolerance);
  RUN_TEST(test_check_with_a_tolerance_that_is_nan_accepts_nothing);
  return SUITE_END();
}
