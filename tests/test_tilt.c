#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                               \
  CHECKED(tilt_error, "RR", "aa", (in[0], in[1], out[0], out[1]))               \
  CHECKED(tilt_to_rotation, "aaa", "M", (in[0][0], in[1][0], in[2][0], out[0])) \
  CHECKED(tilt_from_rotation, "R", "aaa", (in[0], out[0], out[1], out[2]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500 };

static const double exp_as_angle = 3 * CHS_EPS_SO3_EXP / 1.4142135623730951;

static void turn_about(int axis, double angle, real R[9]) {
  real w[3] = {0, 0, 0};
  w[axis] = (real)angle;
  FN(chs_so3_exp)(w, R);
}

/* The difference of two angles modulo 2 pi. */
static double apart(real a, real b) { return remainder((double)a - (double)b, 2 * PI); }

static void test_to_rotation_of_zeros_is_the_identity(void) {
  real R[9];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_to_rotation)(0, 0, 0, R));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(identity3[i] == R[i]);
}

static void test_to_rotation_turns_about_z_then_y_then_z(void) {
  for (int k = 0; k < CASES; k++) {
    double azimuth = uniform(-9, 9), tilt = k % 2 ? uniform(-9, 9) : random_angle(k / 2), torsion = uniform(-9, 9);
    real A[9], B[9], C[9], AB[9], expected[9], R[9];
    azimuth = (double)(real)azimuth;
    torsion = (double)(real)torsion;
    turn_about(2, azimuth, A);
    turn_about(1, tilt, B);
    turn_about(2, torsion - azimuth, C);
    product_of(A, B, 3, 3, AB);
    product_of(AB, C, 3, 3, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_to_rotation)((real)azimuth, (real)tilt, (real)torsion, R));
    /* Three factors, two products, and the spin of up to 18 rounded in the test. */
    ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_TILT_TO_ROTATION + 3 * sqrt(3) * CHS_EPS_SO3_EXP_BEYOND + 2 + 9,
                              1);
  }
}

static void test_to_rotation_of_a_torsion_alone_turns_about_z_whatever_the_azimuth(void) {
  for (int k = 0; k < CASES; k++) {
    double torsion = random_angle(k);
    real expected[9], R[9];
    turn_about(2, torsion, expected);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_to_rotation)((real)uniform(-9, 9), 0, (real)torsion, R));
    ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_TILT_TO_ROTATION + CHS_EPS_SO3_EXP, 1);
  }
}

static void test_angles_beyond_the_range_are_refused(void) {
  const real most = ANGLE_MAX, more = NEXT_AFTER(ANGLE_MAX, REAL_MAX);
  real R[9];
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_to_rotation)(most, -most, -most, R));
  for (int k = 0; k < 3; k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      real a[3] = {most, most, most};
      a[k] = (real)sign * more;
      ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, R, FN(chs_tilt_to_rotation)(a[0], a[1], a[2], R));
    }
}

static void test_from_rotation_takes_back_what_to_rotation_gave(void) {
  for (int k = 0; k < CASES; k++) {
    double azimuth = uniform(-PI, PI), tilt = k % 2 ? uniform(0.1, 3) : random_angle(k / 2), torsion = uniform(-PI, PI);
    if (tilt < 100 * EPS || PI - tilt < sqrt(100 * EPS)) continue; /* to_rotation promises eps of 1 */
    real R[9], a, t, s;
    FN(chs_tilt_to_rotation)((real)azimuth, (real)tilt, (real)torsion, R);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_from_rotation)(R, &a, &t, &s));
    /* The error of two entries each: of the sine of the tilt, and of the sum and the difference that make the torsion,
     * the length of which is 1 + cos(tilt). */
    const double p = CHS_EPS_TILT_TO_ROTATION, half = (double)(real)tilt / 2;
    ASSERT_WITHIN_EPS((real)tilt, t, CHS_EPS_TILT_FROM_ROTATION_TILT * tilt + sqrt(3) * p, 1);
    ASSERT_WITHIN_EPS(0, apart((real)azimuth, a), CHS_EPS_TILT_FROM_ROTATION_AZIMUTH * PI + sqrt(2) * p / sin(2 * half),
                      1);
    ASSERT_WITHIN_EPS(0, apart((real)torsion, s),
                      CHS_EPS_TILT_FROM_ROTATION_TORSION * PI + sqrt(2) * p / (cos(half) * cos(half)), 1);
  }
}

static void test_to_rotation_takes_back_what_from_rotation_gave(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], back[9], a, t, s;
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_from_rotation)(R, &a, &t, &s));
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_to_rotation)(a, t, s, back));
    /* Azimuth and spin each count by their own errors; R is 3 CHS_EPS_SO3_EXP away from a rotation, which the torsion
     * feels by 1/cos^2(tilt/2). */
    double half = (double)t / 2, drift = 3 * CHS_EPS_SO3_EXP / (cos(half) * cos(half));
    double angles =
        2 * CHS_EPS_TILT_FROM_ROTATION_AZIMUTH + CHS_EPS_TILT_FROM_ROTATION_TILT + CHS_EPS_TILT_FROM_ROTATION_TORSION;
    ASSERT_ENTRIES_WITHIN_EPS(R, back, 9, CHS_EPS_TILT_TO_ROTATION + angles * PI + 2 * drift, 1);
  }
}

static void test_azimuth_and_torsion_follow_atan2_where_an_entry_is_a_signed_zero(void) {
  const real o = K(0.0), n = -K(0.0), pi = REAL_PI, half = REAL_PI / 2;
  const struct {
    real R[9], azimuth, tilt, torsion;
    int status;
  } known[] = {
      /* the tool axis along +x, -x from above, -x from below, +y, -y */
      {{0, 0, 1, 0, 1, o, -1, 0, 0}, o, half, o, CHS_OK},
      {{0, 0, 1, 0, 1, n, -1, 0, 0}, n, half, o, CHS_OK},
      {{0, 0, -1, 0, 1, o, 1, 0, 0}, pi, half, o, CHS_OK},
      {{0, 0, -1, 0, 1, n, 1, 0, 0}, -pi, half, o, CHS_OK},
      {{1, 0, 0, 0, 0, 1, 0, -1, 0}, half, half, o, CHS_OK},
      {{1, 0, 0, 0, 0, -1, 0, 1, 0}, -half, half, o, CHS_OK},
      /* no tilt: the identity, with entries of either sign, and half a turn about z */
      {{1, 0, 0, 0, 1, 0, 0, 0, 1}, o, o, o, CHS_AZIMUTH_UNDEFINED},
      {{1, o, n, n, 1, n, 0, 0, 1}, o, o, n, CHS_AZIMUTH_UNDEFINED},
      {{-1, 0, 0, o, -1, 0, 0, 0, 1}, o, o, pi, CHS_AZIMUTH_UNDEFINED},
      {{-1, o, 0, n, -1, 0, 0, 0, 1}, o, o, -pi, CHS_AZIMUTH_UNDEFINED},
      {{0, -1, 0, 1, 0, 0, 0, 0, 1}, o, o, half, CHS_AZIMUTH_UNDEFINED},
      {{0, 1, 0, -1, 0, 0, 0, 0, 1}, o, o, -half, CHS_AZIMUTH_UNDEFINED},
      /* tilted by pi about y, about x, and about the lines between them */
      {{-1, 0, 0, 0, 1, 0, 0, 0, -1}, o, pi, o, CHS_TORSION_UNDEFINED},
      {{1, 0, 0, 0, -1, 0, 0, 0, -1}, half, pi, o, CHS_TORSION_UNDEFINED},
      {{0, -1, 0, -1, 0, 0, 0, 0, -1}, half / 2, pi, o, CHS_TORSION_UNDEFINED},
      {{0, 1, 0, 1, 0, 0, 0, 0, -1}, -half / 2, pi, o, CHS_TORSION_UNDEFINED},
  };
  for (int k = 0; k < LENGTH(known); k++) {
    char name[32];
    snprintf(name, sizeof name, "matrix %d of the table", k);
    subject = name;
    real a, t, s;
    ASSERT_STATUS(known[k].status, FN(chs_tilt_from_rotation)(known[k].R, &a, &t, &s));
    ASSERT_SAME_BITS(&known[k].azimuth, &a, 1);
    ASSERT_SAME_BITS(&known[k].tilt, &t, 1);
    ASSERT_SAME_BITS(&known[k].torsion, &s, 1);
    subject = "";
  }
}

/* At a tilt of pi only 2 azimuth - torsion is defined: R = Rz(2 azimuth - torsion) Ry(pi). */
static void test_from_rotation_at_a_tilt_of_pi_keeps_the_rotation(void) {
  for (int k = 0; k < CASES; k++) {
    double psi = uniform(-PI, PI);
    real c = (real)cos(psi), s = (real)sin(psi), R[9] = {-c, -s, 0, -s, c, 0, 0, 0, -1}, azimuth, tilt, torsion;
    ASSERT_STATUS(CHS_TORSION_UNDEFINED, FN(chs_tilt_from_rotation)(R, &azimuth, &tilt, &torsion));
    ASSERT_WITHIN_EPS(psi / 2, azimuth, (CHS_EPS_TILT_FROM_ROTATION_AZIMUTH + 1) * fabs(psi / 2) + 1, 1);
    ASSERT_WITHIN_EPS(0, torsion, 0, 1);
  }
}

/* Where the tilt is so near pi that nothing is left of the entries that make the torsion, there is still an answer. */
static void test_angles_stay_finite_however_near_the_tilt_is_to_pi(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], a, t, s, alpha, beta;
    FN(chs_tilt_to_rotation)((real)uniform(-PI, PI), (real)(PI - log_uniform(EPS, 0.1)), (real)uniform(-PI, PI), R);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_tilt_from_rotation)(R, &a, &t, &s));
    TEST_ASSERT_TRUE(fabs((double)a) <= PI + EPS && fabs((double)s) <= PI + EPS);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_tilt_error)(identity3, R, &alpha, &beta));
    TEST_ASSERT_TRUE((double)alpha >= 0 && (double)alpha <= PI + EPS);
    TEST_ASSERT_TRUE((double)beta >= 0 && (double)beta <= PI + EPS);
  }
}

static void test_error_of_equal_orientations_is_zero(void) {
  const real zero = 0;
  for (int k = 0; k < CASES; k++) {
    real R[9], alpha, beta;
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(R, R, &alpha, &beta));
    ASSERT_SAME_BITS(&zero, &alpha, 1);
    ASSERT_SAME_BITS(&zero, &beta, 1);
  }
}

static void test_error_against_the_identity_is_tilt_and_torsion(void) {
  for (int k = 0; k < CASES; k++) {
    double tilt = uniform(0.01, 3), torsion = uniform(-PI, PI);
    real R[9], alpha, beta;
    FN(chs_tilt_to_rotation)((real)uniform(-PI, PI), (real)tilt, (real)torsion, R);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(identity3, R, &alpha, &beta));
    const double p = CHS_EPS_TILT_TO_ROTATION, half = tilt / 2, total = sqrt(tilt * tilt + torsion * torsion);
    ASSERT_WITHIN_EPS((real)tilt, alpha, CHS_EPS_TILT_ERROR_ALPHA * tilt + sqrt(3) * p, 1);
    ASSERT_WITHIN_EPS(fabs((double)(real)torsion), beta,
                      (CHS_EPS_TILT_ERROR_BETA * total + sqrt(2) * p) / (cos(half) * cos(half)), 1);
  }
}

static void test_tiny_errors_are_resolved_to_their_own_size(void) {
  for (int k = 0; k < CASES; k++) {
    real w[3], R[9], alpha, beta;
    random_vector(log_uniform(PICK(1e-300, 1e-36), PICK(1e-9, 1e-4)), w);
    double total = length_of(w, 3), tilt = length_of(w, 2), torsion = fabs((double)w[2]);
    FN(chs_so3_exp)(w, R);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(identity3, R, &alpha, &beta));
    double series = total * total / EPS; /* alpha and beta are those of w but for terms of a higher order */
    ASSERT_WITHIN_EPS(tilt, alpha, (CHS_EPS_TILT_ERROR_ALPHA + exp_as_angle + series) * total, 1);
    ASSERT_WITHIN_EPS(torsion, beta, (CHS_EPS_TILT_ERROR_BETA + exp_as_angle + series) * total, 1);
  }
}

/* The actual orientation is the nominal one and a tiny difference, which is exact: with x, y, d the nominal's columns,
 * alpha is |d x dd| and beta |y . dx - x . dy| / 2. */
static void test_tiny_errors_are_resolved_at_any_orientation(void) {
  for (int k = 0; k < CASES; k++) {
    real N[9], A[9], w[3], small[9], column[3][3], change[3][3], tilted[3], alpha, beta;
    random_rotation(N);
    random_vector(log_uniform(8 * EPS, PICK(1e-9, 1e-5)), w);
    FN(chs_so3_exp)(w, small);
    FN(chs_so3_multiply)(N, small, A);
    for (int i = 0; i < 9; i++) {
      column[i % 3][i / 3] = N[i];
      change[i % 3][i / 3] = A[i] - N[i];
    }
    cross_of(column[2], change[2], tilted);
    double tilt = length_of(tilted, 3);
    double torsion = fabs(dot_of(column[1], change[0], 3) - dot_of(column[0], change[1], 3)) / 2;
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(N, A, &alpha, &beta));
    /* 3: the test's own rounding */
    ASSERT_WITHIN_EPS(tilt, alpha, CHS_EPS_TILT_ERROR_ALPHA + 3, tilt);
    ASSERT_WITHIN_EPS(torsion, beta, CHS_EPS_TILT_ERROR_BETA + 3, sqrt(tilt * tilt + torsion * torsion));
  }
}

static void test_angles_near_a_tilt_of_pi_give_the_orientation_back(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], again[9], azimuth, tilt, torsion;
    double short_of_pi = log_uniform(PICK(1e-15, 1e-6), 0.5);
    ASSERT_STATUS(
        CHS_OK, FN(chs_tilt_to_rotation)((real)uniform(-PI, PI), (real)(PI - short_of_pi), (real)uniform(-PI, PI), R));
    if (R[2] == 0 && R[5] == 0) continue;
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_from_rotation)(R, &azimuth, &tilt, &torsion));
    FN(chs_tilt_to_rotation)(azimuth, tilt, torsion, again);
    /* Each angle's error turns R; the torsion's is relative to 2 pi, and just before the change-over, at 1/64, the
     * small sine and cosine that give it carry the rounding of R's entries, 64 times as large. */
    double promise = CHS_EPS_TILT_TO_ROTATION + PI * CHS_EPS_TILT_FROM_ROTATION_TILT +
                     2 * PI * (CHS_EPS_TILT_FROM_ROTATION_AZIMUTH + CHS_EPS_TILT_FROM_ROTATION_TORSION);
    ASSERT_ENTRIES_WITHIN_EPS(R, again, 9, promise + 64 * CHS_EPS_TILT_TO_ROTATION, 1);
  }
}

static void test_opposite_tools_have_no_torsion(void) {
  const real upside_down[9] = {-1, 0, 0, 0, 1, 0, 0, 0, -1}, zero = 0;
  for (int k = 0; k < CUBE_ROTATIONS; k++) {
    real N[9], A[9], alpha, beta;
    cube_rotation(k, N);
    FN(chs_so3_multiply)(N, upside_down, A);
    ASSERT_STATUS(CHS_TORSION_UNDEFINED, FN(chs_tilt_error)(N, A, &alpha, &beta));
    ASSERT_WITHIN_EPS(PI, alpha, CHS_EPS_TILT_ERROR_ALPHA, PI);
    ASSERT_SAME_BITS(&zero, &beta, 1);
  }
}

/* Entries that are multiples of 2^-24, of which double has products and their sums exactly. */
static void coarse(const real from[9], double drift, real R[9]) {
  for (int i = 0; i < 9; i++) R[i] = rounded(0x1p-24 * round(0x1p24 * ((double)from[i] + uniform(-drift, drift))));
}

/* Nearer to pi than 1e-6 too, and of matrices whose drift counts for more than the tilt does. */
static void test_torsion_near_a_tilt_of_pi_keeps_its_promise(void) {
  for (int k = 0; k < 10 * CASES; k++) {
    const double short_of_pi = log_uniform(1e-7, k % 3 ? 1 : 2e-6), drift = k % 2 ? 0 : log_uniform(1e-7, 1e-3);
    real N[9], A[9], turned[9], alpha, beta;
    double sine = 0, cosine = 0, squares = 0;
    random_rotation(N);
    FN(chs_tilt_to_rotation)((real)uniform(-PI, PI), (real)(PI - short_of_pi), (real)uniform(-PI, PI), turned);
    FN(chs_so3_multiply)(N, turned, A);
    coarse(N, drift, N);
    coarse(A, drift, A);
    for (int i = 0; i < 9; i += 3) {
      sine += (double)N[i + 1] * (double)A[i] - (double)N[i] * (double)A[i + 1];
      cosine += (double)N[i] * (double)A[i] + (double)N[i + 1] * (double)A[i + 1];
    }
    for (int i = 0; i < 9; i++) squares += pow((double)A[i] - (double)N[i], 2);
    const double r = hypot(sine, cosine);
    const int status = FN(chs_tilt_error)(N, A, &alpha, &beta);
    if (r < 4 * EPS) ASSERT_STATUS(CHS_TORSION_UNDEFINED, status);
    if (r > 12 * EPS) ASSERT_STATUS(CHS_OK, status);
    if (status != CHS_OK) {
      ASSERT_STATUS(CHS_TORSION_UNDEFINED, status);
      TEST_ASSERT_TRUE(beta == 0);
    } else
      ASSERT_WITHIN_EPS(fabs(atan2(sine, cosine)), beta, CHS_EPS_TILT_ERROR_BETA, sqrt(squares) * fmax(1, 1 / r));
  }
}

/* Two orientations, their error, and the same again after changes that must not matter. */
typedef struct orientations {
  real nominal[9], actual[9], alpha, beta;
} orientations;

static orientations random_orientations(int k) {
  orientations o;
  real w[3];
  random_vector(fmin(random_angle(k), 3), w);
  FN(chs_so3_exp)(w, o.actual);
  if (k % 2) {
    random_rotation(o.nominal);
    FN(chs_so3_multiply)(o.nominal, o.actual, o.actual); /* near each other, wherever they are, as often as not */
  } else {
    memcpy(o.nominal, identity3, sizeof o.nominal);
  }
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(o.nominal, o.actual, &o.alpha, &o.beta));
  return o;
}

static void assert_same_error(const orientations *o, const real nominal[9], const real actual[9]) {
  real alpha, beta;
  ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(nominal, actual, &alpha, &beta));
  double a = (double)o->alpha, b = (double)o->beta;
  ASSERT_WITHIN_EPS(a, alpha, 2 * CHS_EPS_TILT_ERROR_ALPHA, a);
  ASSERT_WITHIN_EPS(b, beta, 2 * CHS_EPS_TILT_ERROR_BETA, sqrt(a * a + b * b) * fmax(1, 1 / (1 + cos(a))));
}

static void test_error_is_symmetric(void) {
  for (int k = 0; k < CASES; k++) {
    orientations o = random_orientations(k);
    assert_same_error(&o, o.actual, o.nominal);
  }
}

static void test_error_is_the_same_in_every_frame(void) {
  for (int k = 0; k < CASES; k++) {
    orientations o = random_orientations(k);
    real Q[9], nominal[9], actual[9];
    cube_rotation(k % CUBE_ROTATIONS, Q);
    FN(chs_so3_multiply)(Q, o.nominal, nominal);
    FN(chs_so3_multiply)(Q, o.actual, actual);
    assert_same_error(&o, nominal, actual);
  }
}

static void test_error_is_the_same_when_both_turn_about_their_tool_axis(void) {
  const real quarters[3][9] = {
      {0, -1, 0, 1, 0, 0, 0, 0, 1}, {-1, 0, 0, 0, -1, 0, 0, 0, 1}, {0, 1, 0, -1, 0, 0, 0, 0, 1}};
  for (int k = 0; k < CASES; k++) {
    orientations o = random_orientations(k);
    real nominal[9], actual[9];
    FN(chs_so3_multiply)(o.nominal, quarters[k % 3], nominal);
    FN(chs_so3_multiply)(o.actual, quarters[k % 3], actual);
    assert_same_error(&o, nominal, actual);
  }
}

static void test_error_keeps_alpha_when_one_turns_about_its_tool_axis(void) {
  for (int k = 0; k < CASES; k++) {
    orientations o = random_orientations(k);
    real Z[9], actual[9], alpha, beta;
    turn_about(2, uniform(-3, 3), Z);
    Z[8] = 1; /* not only to within rounding */
    FN(chs_so3_multiply)(o.actual, Z, actual);
    ASSERT_STATUS(CHS_OK, FN(chs_tilt_error)(o.nominal, actual, &alpha, &beta));
    ASSERT_SAME_BITS(&o.alpha, &alpha, 1);
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_to_rotation_of_zeros_is_the_identity);
  RUN_TEST(test_to_rotation_turns_about_z_then_y_then_z);
  RUN_TEST(test_to_rotation_of_a_torsion_alone_turns_about_z_whatever_the_azimuth);
  RUN_TEST(test_angles_beyond_the_range_are_refused);
  RUN_TEST(test_from_rotation_takes_back_what_to_rotation_gave);
  RUN_TEST(test_to_rotation_takes_back_what_from_rotation_gave);
  RUN_TEST(test_azimuth_and_torsion_follow_atan2_where_an_entry_is_a_signed_zero);
  RUN_TEST(test_from_rotation_at_a_tilt_of_pi_keeps_the_rotation);
  RUN_TEST(test_angles_stay_finite_however_near_the_tilt_is_to_pi);
  RUN_TEST(test_error_of_equal_orientations_is_zero);
  RUN_TEST(test_error_against_the_identity_is_tilt_and_torsion);
  RUN_TEST(test_tiny_errors_are_resolved_to_their_own_size);
  RUN_TEST(test_tiny_errors_are_resolved_at_any_orientation);
  RUN_TEST(test_angles_near_a_tilt_of_pi_give_the_orientation_back);
  RUN_TEST(test_torsion_near_a_tilt_of_pi_keeps_its_promise);
  RUN_TEST(test_opposite_tools_have_no_torsion);
  RUN_TEST(test_error_is_symmetric);
  RUN_TEST(test_error_is_the_same_in_every_frame);
  RUN_TEST(test_error_is_the_same_when_both_turn_about_their_tool_axis);
  RUN_TEST(test_error_keeps_alpha_when_one_turns_about_its_tool_axis);
  return SUITE_END();
}
