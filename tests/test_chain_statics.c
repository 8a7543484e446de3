#include "support/suite.h"

enum { CASES = 200, MOST = 9 };

static real scratch[CHS_CHAIN_SCRATCH(MOST)];

static void random_numbers(int n, real *x) {
  for (int i = 0; i < n; i++) x[i] = (real)uniform(-1, 1);
}

/* Columns at right angles and of unit length, by Gram and Schmidt in double. */
static void random_orthogonal(int n, double *Q) {
  for (int j = 0; j < n; j++) {
    double sum;
    do {
      for (int i = 0; i < n; i++) Q[n * i + j] = uniform(-1, 1);
      for (int twice = 0; twice < 2; twice++)
        for (int k = 0; k < j; k++) {
          double along = 0;
          for (int i = 0; i < n; i++) along += Q[n * i + k] * Q[n * i + j];
          for (int i = 0; i < n; i++) Q[n * i + j] -= along * Q[n * i + k];
        }
      sum = 0;
      for (int i = 0; i < n; i++) sum += Q[n * i + j] * Q[n * i + j];
    } while (sum < 0.01);
    for (int i = 0; i < n; i++) Q[n * i + j] /= sqrt(sum);
  }
}

/* J = U diag(sigma) V^T, 6 x n. */
static void matrix_with(int n, const double *sigma, real *J) {
  double U[36], V[MOST * MOST];
  random_orthogonal(6, U);
  random_orthogonal(n, V);
  for (int i = 0; i < 6; i++)
    for (int j = 0; j < n; j++) {
      double sum = 0;
      for (int k = 0; k < (n < 6 ? n : 6); k++) sum += U[6 * i + k] * sigma[k] * V[n * j + k];
      J[n * i + j] = rounded(sum);
    }
}

static const double spectrum[6] = {4, 2, 1, 0.5, 0.25, 0.125};

/* What J loses by being rounded to the format, relative to sigma[0] = 4. */
static const double of_rounding = 4;

static void test_singular_values_come_in_descending_order(void) {
  const real none[6] = {0, 0, 0, 0, 0, 0};
  for (int n = 1; n <= MOST; n++)
    for (int k = 0; k < CASES / 10; k++) {
      real J[6 * MOST], sigma[6];
      int count = n < 6 ? n : 6;
      matrix_with(n, spectrum, J);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_singular_values)(n, J, 1, scratch, sigma));
      for (int i = 0; i < count; i++)
        ASSERT_WITHIN_EPS(spectrum[i], sigma[i], CHS_EPS_CHAIN_SINGULAR_VALUES + of_rounding, spectrum[0]);
      ASSERT_SAME_BITS(none, sigma + count, 6 - count);
    }
}

static void test_singular_values_of_a_diagonal_are_exact(void) {
  const real expected[6] = {32, 16, 8, 4, 2, 1};
  real J[36] = {0}, sigma[6];
  for (int i = 0; i < 6; i++) J[6 * i + (i + 2) % 6] = expected[(i + 3) % 6];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_singular_values)(6, J, 1, scratch, sigma));
  ASSERT_SAME_BITS(expected, sigma, 6);
}

static void test_the_length_divides_the_last_three_rows(void) {
  for (int n = 1; n <= MOST; n++) {
    real J[6 * MOST], scaled_J[6 * MOST], sigma[6], expected[6];
    random_numbers(6 * n, J);
    for (int i = 0; i < 6 * n; i++) scaled_J[i] = i < 3 * n ? J[i] : J[i] / 4;
    ASSERT_STATUS(CHS_OK, FN(chs_chain_singular_values)(n, J, 4, scratch, sigma));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_singular_values)(n, scaled_J, 1, scratch, expected));
    ASSERT_SAME_BITS(expected, sigma, 6);
  }
}

static void test_rank_counts_the_directions(void) {
  for (int n = 1; n <= MOST; n++)
    for (int rank = 0; rank <= (n < 6 ? n : 6); rank++) {
      double sigma[6] = {0, 0, 0, 0, 0, 0};
      real J[6 * MOST];
      int found = -1;
      for (int i = 0; i < rank; i++) sigma[i] = spectrum[i];
      matrix_with(n, sigma, J);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_rank)(n, J, 1, scratch, &found));
      TEST_ASSERT_EQUAL_INT(rank, found);
    }
}

static void test_manipulability_and_condition_are_made_of_the_singular_values(void) {
  for (int n = 1; n <= MOST; n++) {
    real J[6 * MOST], w, condition;
    double product = 1, last = spectrum[n < 6 ? n - 1 : 5];
    for (int i = 0; i < (n < 6 ? n : 6); i++) product *= spectrum[i];
    matrix_with(n, spectrum, J);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_manipulability)(n, J, 1, scratch, &w));
    ASSERT_WITHIN_EPS(product, w, CHS_EPS_CHAIN_MANIPULABILITY + 6 * of_rounding, product * spectrum[0] / last);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_condition)(n, J, 1, scratch, &condition));
    double expected = spectrum[0] / last;
    ASSERT_WITHIN_EPS(expected, condition, CHS_EPS_CHAIN_CONDITION + 2 * of_rounding, expected * expected);
  }
}

static void test_manipulability_of_singular_values_whose_products_are_beyond_the_range(void) {
  const int large = PICK(400, 50), small = PICK(-100, -12);
  for (int swap = 0; swap < 2; swap++) {
    real J[36] = {0}, w;
    int first = swap ? -large : large, second = swap ? -small : small;
    for (int i = 0; i < 6; i++) J[7 * i] = (real)ldexp(1, i < 3 ? first : second);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_manipulability)(6, J, 1, scratch, &w));
    TEST_ASSERT_TRUE((double)w == ldexp(1, 3 * (first + second)));
  }
}

static void test_no_condition_number_of_a_singular_matrix(void) {
  const double sigma[6] = {3, 2, 1, 1, 1, 0};
  real J[36], zero[36] = {0}, condition;
  matrix_with(6, sigma, J);
  ASSERT_REFUSES(CHS_ERR_SINGULAR, condition, FN(chs_chain_condition)(6, J, 1, scratch, &condition));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, condition, FN(chs_chain_condition)(6, zero, 1, scratch, &condition));
}

static void test_determinant_of_known_matrices(void) {
  /* Triangular with rows exchanged three times, and singular. */
  const real J[36] = {0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 7, 0, 0, 0, K(0.5), 1, 1,
                      0, 0, 4, 1, 1, 1, 0, 1, 9, 9, 9, 9, 5, 1, 1, 1,      1, 1};
  real twice[36], det;
  ASSERT_STATUS(CHS_OK, FN(chs_chain_determinant)(J, &det));
  const real expected = -60, zero = 0;
  ASSERT_SAME_BITS(&expected, &det, 1);
  memcpy(twice, J, sizeof twice);
  memcpy(twice + 12, twice, 6 * sizeof(real));
  ASSERT_STATUS(CHS_OK, FN(chs_chain_determinant)(twice, &det));
  ASSERT_WITHIN_EPS(zero, det, 0, 1);
}

static void test_determinant_is_the_product_of_the_singular_values(void) {
  for (int k = 0; k < CASES; k++) {
    real J[36], det, w;
    double columns = 1;
    random_numbers(36, J);
    for (int j = 0; j < 6; j++) {
      const real column[6] = {J[j], J[6 + j], J[12 + j], J[18 + j], J[24 + j], J[30 + j]};
      columns *= length_of(column, 6);
    }
    ASSERT_STATUS(CHS_OK, FN(chs_chain_determinant)(J, &det));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_manipulability)(6, J, 1, scratch, &w));
    ASSERT_WITHIN_EPS(w, fabs((double)det), CHS_EPS_CHAIN_DETERMINANT + CHS_EPS_CHAIN_MANIPULABILITY * 6, columns);
  }
}

static void test_power_is_the_same_in_joints_and_at_the_tool(void) {
  for (int n = 1; n <= MOST; n++) {
    real J[6 * MOST], F[6], V[6], rates[MOST], torques[MOST];
    random_numbers(6 * n, J);
    random_numbers(6, F);
    random_numbers(n, rates);
    FN(chs_chain_torques)(n, J, F, torques);
    FN(chs_chain_twist)(n, J, rates, V);
    ASSERT_WITHIN_EPS(dot_of(V, F, 6), dot_of(torques, rates, n), 16, n);
  }
}

static void test_torques_and_twist_may_overlap_what_they_are_made_of(void) {
  real J[36], F[18], V[18], torques[6];
  random_numbers(36, J);
  for (int place = 0; place <= 12; place++) {
    random_numbers(18, F);
    memcpy(V, F, sizeof V);
    real expected[6];
    memcpy(expected, F + 6, sizeof expected);
    FN(chs_chain_torques)(6, J, expected, torques);
    FN(chs_chain_torques)(6, J, F + 6, F + place);
    ASSERT_SAME_BITS(torques, F + place, 6);
    FN(chs_chain_twist)(6, J, expected, torques);
    FN(chs_chain_twist)(6, J, V + 6, V + place);
    ASSERT_SAME_BITS(torques, V + place, 6);
  }
}

static void test_plain_algebra_lets_nan_through(void) {
  for (int k = 0; k < 36; k++) {
    real J[36], F[6], torques[6], V[6];
    random_numbers(36, J);
    random_numbers(6, F);
    J[k] = (real)NAN;
    FN(chs_chain_torques)(6, J, F, torques);
    TEST_ASSERT_TRUE(isnan(torques[k % 6]));
    FN(chs_chain_twist)(6, J, F, V);
    TEST_ASSERT_TRUE(isnan(V[k / 6]));
  }
}

/* The three ways to joint rates behind one signature. */

static int by_inverse(int n, const real *J, const real *V, real *rates) {
  (void)n;
  return FN(chs_chain_rates_inverse)(J, V, rates);
}

static int by_pseudoinverse(int n, const real *J, const real *V, real *rates) {
  return FN(chs_chain_rates_pseudoinverse)(n, J, V, 1, scratch, rates);
}

static int by_damping(int n, const real *J, const real *V, real *rates) {
  return FN(chs_chain_rates_damped)(n, J, V, 1, K(1e-3), 0, scratch, rates);
}

typedef int rates_function(int n, const real *J, const real *V, real *rates);

static const struct {
  const char *name;
  rates_function *call;
} ways[] = {{"chain_rates_inverse", by_inverse},
            {"chain_rates_pseudoinverse", by_pseudoinverse},
            {"chain_rates_damped", by_damping}};

static void test_rates_give_the_twist_back(void) {
  for (int k = 0; k < CASES; k++)
    for (int n = 6; n <= MOST; n++)
      for (int w = n == 6 ? 0 : 1; w < 2; w++) {
        real J[6 * MOST], V[6], rates[MOST], back[6];
        subject = ways[w].name;
        matrix_with(n, spectrum, J);
        random_vector(1, V);
        random_vector(1, V + 3);
        ASSERT_STATUS(CHS_OK, ways[w].call(n, J, V, rates));
        FN(chs_chain_twist)(n, J, rates, back);
        ASSERT_NORM_WITHIN_EPS(V, back, 6, 2 * CHS_EPS_CHAIN_RATES_PSEUDOINVERSE,
                               spectrum[0] * spectrum[0] / (spectrum[5] * spectrum[5]));
      }
}

/* Joint rates in the null space of J are of no use: there are none in the pseudoinverse's. */
static void test_pseudoinverse_gives_the_smallest_rates(void) {
  double most = 0;
  for (int k = 0; k < CASES; k++) {
    real J[42], V[6], rates[7], some[7], used[6], projected[7];
    matrix_with(7, spectrum, J);
    random_numbers(7, some);
    FN(chs_chain_twist)(7, J, some, used);
    ASSERT_STATUS(CHS_OK, by_pseudoinverse(7, J, used, projected));
    for (int i = 0; i < 7; i++) some[i] = rounded((double)some[i] - (double)projected[i]);
    random_numbers(6, V);
    ASSERT_STATUS(CHS_OK, by_pseudoinverse(7, J, V, rates));
    ASSERT_WITHIN_EPS(0, dot_of(rates, some, 7), 4 * CHS_EPS_CHAIN_RATES_PSEUDOINVERSE,
                      spectrum[0] / (spectrum[5] * spectrum[5]) * 3);
    most = fmax(most, length_of(some, 7));
  }
  TEST_ASSERT_TRUE(most > 0.5);
}

static void test_pseudoinverse_of_a_singular_jacobian_leaves_out_what_cannot_be_done(void) {
  for (int n = 1; n <= MOST; n++)
    for (int rank = 0; rank < (n < 6 ? n : 6); rank++) {
      double sigma[6] = {0, 0, 0, 0, 0, 0};
      real J[6 * MOST], V[6], rates[MOST], done[6], missing[6], torques[MOST];
      for (int i = 0; i < rank; i++) sigma[i] = spectrum[i];
      matrix_with(n, sigma, J);
      random_numbers(6, V);
      ASSERT_STATUS(CHS_NEAR_SINGULAR, by_pseudoinverse(n, J, V, rates));
      FN(chs_chain_twist)(n, J, rates, done);
      for (int i = 0; i < 6; i++) missing[i] = rounded((double)V[i] - (double)done[i]);
      /* What is missing is at right angles to all that the joints can do. */
      FN(chs_chain_torques)(n, J, missing, torques);
      ASSERT_NORM_WITHIN_EPS(((const real[MOST]){0}), torques, n, 1e4, 1);
    }
}

static void test_fewer_joints_than_six_do_what_they_can(void) {
  const real J[12] = {0, 0, 0, 0, 1, 1, 0, 0, 2, 0, 0, 0}, V[6] = {0, 0, 3, 0, 4, 0};
  const real expected[2] = {2, 1};
  real rates[2];
  ASSERT_STATUS(CHS_OK, by_pseudoinverse(2, J, V, rates));
  ASSERT_NORM_WITHIN_EPS(expected, rates, 2, 8, 2);
}

/* Where no joint moves the tool all is 0, and nothing is divided by it. */
static void test_a_jacobian_of_zeros_moves_nothing(void) {
  const real J[6 * MOST] = {0}, V[6] = {1, 2, 3, 4, 5, 6}, zeros[MOST] = {0};
  for (int n = 1; n <= MOST; n++) {
    real sigma[6], rates[MOST], value;
    int rank;
    ASSERT_STATUS(CHS_OK, FN(chs_chain_singular_values)(n, J, 1, scratch, sigma));
    ASSERT_SAME_BITS(zeros, sigma, 6);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_rank)(n, J, 1, scratch, &rank));
    TEST_ASSERT_EQUAL(0, rank);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_manipulability)(n, J, 1, scratch, &value));
    TEST_ASSERT_TRUE(value == 0);
    ASSERT_REFUSES(CHS_ERR_SINGULAR, value, FN(chs_chain_condition)(n, J, 1, scratch, &value));
    ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_chain_rates_pseudoinverse)(n, J, V, 1, scratch, rates));
    ASSERT_SAME_BITS(zeros, rates, n);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_damped)(n, J, V, 1, K(0.1), 0, scratch, rates));
    ASSERT_SAME_BITS(zeros, rates, n);
    ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_chain_rates_damped)(n, J, V, 1, K(0.1), K(0.1), scratch, rates));
    ASSERT_SAME_BITS(zeros, rates, n);
  }
}

static void test_singular_values_beyond_the_range_are_an_overflow(void) {
  real J[6], sigma[6], value;
  for (int i = 0; i < 6; i++) J[i] = REAL_MAX;
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, sigma, FN(chs_chain_singular_values)(1, J, 1, scratch, sigma));
  ASSERT_REFUSES(CHS_ERR_OVERFLOW, value, FN(chs_chain_manipulability)(1, J, 1, scratch, &value));
  ASSERT_STATUS(CHS_OK, FN(chs_chain_condition)(1, J, 1, scratch, &value));
  TEST_ASSERT_TRUE(value == 1);
}

static void test_damping_bounds_the_rates(void) {
  for (int k = 0; k < CASES; k++) {
    const double sigma[6] = {4, 2, 1, 0.5, log_uniform(1e-6, 1), 0}, lambda = log_uniform(1e-3, 1);
    real J[42], V[6], rates[7];
    int n = integer(6, 7);
    matrix_with(n, sigma, J);
    random_numbers(6, V);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_damped)(n, J, V, 1, (real)lambda, 0, scratch, rates));
    TEST_ASSERT_TRUE(length_of(rates, n) <= length_of(V, 6) / (2 * lambda) * (1 + 64 * EPS));
  }
}

static void test_damping_solves_the_damped_equations(void) {
  for (int k = 0; k < CASES; k++)
    for (int n = 1; n <= MOST; n++) {
      const double lambda = 0.25;
      real J[6 * MOST], V[6], rates[MOST], done[6], left[6], balance[MOST];
      matrix_with(n, spectrum, J);
      random_numbers(6, V);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_damped)(n, J, V, 1, (real)lambda, 0, scratch, rates));
      FN(chs_chain_twist)(n, J, rates, done);
      for (int i = 0; i < 6; i++) left[i] = rounded((double)V[i] - (double)done[i]);
      FN(chs_chain_torques)(n, J, left, balance); /* J^T (V - J rates) = lambda^2 rates */
      for (int i = 0; i < n; i++) ASSERT_WITHIN_EPS(lambda * lambda * (double)rates[i], balance[i], 2048, 4);
    }
}

static void test_damping_that_follows_sets_in_near_a_singularity(void) {
  const double far[6] = {4, 2, 1, 1, 1, 0.5}, close[6] = {4, 2, 1, 1, 1, 0.06};
  real J[36], V[6], rates[6], expected[6];
  random_numbers(6, V);
  matrix_with(6, far, J);
  ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_damped)(6, J, V, 1, K(0.1), K(0.1), scratch, rates));
  ASSERT_STATUS(CHS_OK, by_pseudoinverse(6, J, V, expected));
  ASSERT_NORM_WITHIN_EPS(expected, rates, 6, 64, 16);
  matrix_with(6, close, J);
  ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_chain_rates_damped)(6, J, V, 1, K(0.1), K(0.1), scratch, rates));
  const real lambda = rounded(0.1 * sqrt(1 - 0.6 * 0.6));
  ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_damped)(6, J, V, 1, lambda, 0, scratch, expected));
  ASSERT_NORM_WITHIN_EPS(expected, rates, 6, 1024, 16);
}

static void test_rates_may_overlap_the_twist(void) {
  for (int w = 0; w < LENGTH(ways); w++)
    for (int place = 0; place <= 12; place++) {
      real J[36], V[18], twist[6], expected[6];
      matrix_with(6, spectrum, J);
      random_numbers(18, V);
      memcpy(twist, V + 6, sizeof twist);
      ASSERT_STATUS(CHS_OK, ways[w].call(6, J, twist, expected));
      ASSERT_STATUS(CHS_OK, ways[w].call(6, J, V + 6, V + place));
      ASSERT_SAME_BITS(expected, V + place, 6);
    }
}

static void test_no_inverse_of_a_singular_jacobian(void) {
  real J[36], V[6], rates[6];
  random_numbers(6, V);
  for (int k = 0; k < CASES; k++) {
    const double sigma[6] = {4, 2, 1, 1, 0.5, 0};
    matrix_with(6, sigma, J);
    for (int i = 0; i < 6; i++) J[6 * i + 4] = J[6 * i + 1];
    ASSERT_REFUSES(CHS_ERR_SINGULAR, rates, FN(chs_chain_rates_inverse)(J, V, rates));
  }
  memset(J, 0, sizeof J);
  ASSERT_REFUSES(CHS_ERR_SINGULAR, rates, FN(chs_chain_rates_inverse)(J, V, rates));
}

static void test_the_inverse_is_the_same_in_every_unit_of_length(void) {
  for (int k = 0; k < CASES; k++) {
    real J[36], V[6], large_J[36], large_V[6], rates[6], expected[6];
    matrix_with(6, spectrum, J);
    random_numbers(6, V);
    const real unit = K(0x1p40);
    for (int i = 0; i < 36; i++) large_J[i] = i < 18 ? J[i] : unit * J[i];
    for (int i = 0; i < 6; i++) large_V[i] = i < 3 ? V[i] : unit * V[i];
    ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_inverse)(J, V, expected));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_rates_inverse)(large_J, large_V, rates));
    ASSERT_SAME_BITS(expected, rates, 6);
  }
}

static void assert_all_refuse(int status, int n, const real *J, const real *V, real length) {
  union {
    real numbers[MOST];
    int rank;
  } out;
  ASSERT_REFUSES(status, out, FN(chs_chain_singular_values)(n, J, length, scratch, out.numbers));
  ASSERT_REFUSES(status, out, FN(chs_chain_rank)(n, J, length, scratch, &out.rank));
  ASSERT_REFUSES(status, out, FN(chs_chain_manipulability)(n, J, length, scratch, out.numbers));
  ASSERT_REFUSES(status, out, FN(chs_chain_condition)(n, J, length, scratch, out.numbers));
  ASSERT_REFUSES(status, out, FN(chs_chain_rates_pseudoinverse)(n, J, V, length, scratch, out.numbers));
  ASSERT_REFUSES(status, out, FN(chs_chain_rates_damped)(n, J, V, length, 1, 1, scratch, out.numbers));
}

static void test_bad_arguments_are_refused(void) {
  real J[6 * MOST], V[6], rates[6];
  random_numbers(6 * MOST, J);
  random_numbers(6, V);
  assert_all_refuse(CHS_ERR_ARGUMENT, 0, J, V, 1);
  assert_all_refuse(CHS_ERR_ARGUMENT, -3, J, V, 1);
  assert_all_refuse(CHS_ERR_ARGUMENT, 6, J, V, 0);
  assert_all_refuse(CHS_ERR_ARGUMENT, 6, J, V, -1);
  assert_all_refuse(CHS_ERR_NAN, 6, J, V, (real)NAN);
  assert_all_refuse(CHS_ERR_INFINITE, 6, J, V, (real)INFINITY);
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, rates, FN(chs_chain_rates_damped)(6, J, V, 1, 0, 0, scratch, rates));
  ASSERT_REFUSES(CHS_ERR_ARGUMENT, rates, FN(chs_chain_rates_damped)(6, J, V, 1, 1, -1, scratch, rates));
  ASSERT_REFUSES(CHS_ERR_NAN, rates, FN(chs_chain_rates_damped)(6, J, V, 1, (real)NAN, -1, scratch, rates));
}

/* Where elimination ends before it has seen them. */
static void test_bad_numbers_beside_a_column_of_zeros_are_refused(void) {
  for (int zeros = 0; zeros < 6; zeros++)
    for (int k = 0; k < 36; k++) {
      real J[36], det;
      if (k % 6 == zeros) continue;
      random_numbers(36, J);
      for (int i = 0; i < 6; i++) J[6 * i + zeros] = 0;
      J[k] = (real)INFINITY;
      ASSERT_REFUSES(CHS_ERR_INFINITE, det, FN(chs_chain_determinant)(J, &det));
      J[k] = (real)NAN;
      ASSERT_REFUSES(CHS_ERR_NAN, det, FN(chs_chain_determinant)(J, &det));
    }
}

static void test_bad_numbers_are_refused(void) {
  for (int k = 0; k < 36; k++) {
    real J[36], V[6], rates[6], det;
    random_numbers(36, J);
    random_numbers(6, V);
    for (int nan = 0; nan < 2; nan++) {
      int status = nan ? CHS_ERR_NAN : CHS_ERR_INFINITE;
      J[k] = nan ? (real)NAN : -(real)INFINITY;
      assert_all_refuse(status, 6, J, V, 1);
      ASSERT_REFUSES(status, det, FN(chs_chain_determinant)(J, &det));
      ASSERT_REFUSES(status, rates, FN(chs_chain_rates_inverse)(J, V, rates));
      V[k % 6] = (real)INFINITY;
      ASSERT_REFUSES(status, rates, FN(chs_chain_rates_inverse)(J, V, rates));
      V[k % 6] = 0;
    }
    J[k] = 1;
    V[k % 6] = (real)NAN;
    for (int w = 0; w < LENGTH(ways); w++) ASSERT_REFUSES(CHS_ERR_NAN, rates, ways[w].call(6, J, V, rates));
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_singular_values_come_in_descending_order);
  RUN_TEST(test_singular_values_of_a_diagonal_are_exact);
  RUN_TEST(test_the_length_divides_the_last_three_rows);
  RUN_TEST(test_rank_counts_the_directions);
  RUN_TEST(test_manipulability_and_condition_are_made_of_the_singular_values);
  RUN_TEST(test_manipulability_of_singular_values_whose_products_are_beyond_the_range);
  RUN_TEST(test_no_condition_number_of_a_singular_matrix);
  RUN_TEST(test_determinant_of_known_matrices);
  RUN_TEST(test_determinant_is_the_product_of_the_singular_values);
  RUN_TEST(test_power_is_the_same_in_joints_and_at_the_tool);
  RUN_TEST(test_torques_and_twist_may_overlap_what_they_are_made_of);
  RUN_TEST(test_plain_algebra_lets_nan_through);
  RUN_TEST(test_rates_give_the_twist_back);
  RUN_TEST(test_pseudoinverse_gives_the_smallest_rates);
  RUN_TEST(test_pseudoinverse_of_a_singular_jacobian_leaves_out_what_cannot_be_done);
  RUN_TEST(test_fewer_joints_than_six_do_what_they_can);
  RUN_TEST(test_a_jacobian_of_zeros_moves_nothing);
  RUN_TEST(test_singular_values_beyond_the_range_are_an_overflow);
  RUN_TEST(test_damping_bounds_the_rates);
  RUN_TEST(test_damping_solves_the_damped_equations);
  RUN_TEST(test_damping_that_follows_sets_in_near_a_singularity);
  RUN_TEST(test_rates_may_overlap_the_twist);
  RUN_TEST(test_no_inverse_of_a_singular_jacobian);
  RUN_TEST(test_the_inverse_is_the_same_in_every_unit_of_length);
  RUN_TEST(test_bad_arguments_are_refused);
  RUN_TEST(test_bad_numbers_beside_a_column_of_zeros_are_refused);
  RUN_TEST(test_bad_numbers_are_refused);
  return SUITE_END();
}
