#include "support/suite.h"

#ifdef CHS_TEST_SINGLE
typedef chs_motion_sumsf motion_sums;
typedef chs_motion_qualityf motion_quality;
#else
typedef chs_motion_sums motion_sums;
typedef chs_motion_quality motion_quality;
#endif

enum { CASES = 200, MOST = 5000 };

static const real any = (real)INFINITY;

/* n points moved by a rotation and a translation of integers, so that the images are known without rounding: the points
 * are multiples of nn, the squared length of the quaternion. */
static struct {
  turn q;
  int n, t[3];
  real initial[3 * MOST], final[3 * MOST], weights[MOST];
} body;

static void make_body(int n, int w, int reach, const int offset[3]) {
  body.n = n;
  body.q = random_turn(w);
  for (int i = 0; i < 3; i++) body.t[i] = integer(-300, 300);
  for (int k = 0; k < n; k++) {
    int x[3];
    for (int i = 0; i < 3; i++) x[i] = offset[i] + integer(-reach, reach);
    for (int i = 0; i < 3; i++) {
      long image = body.t[i];
      for (int j = 0; j < 3; j++) image += (long)turn_numerator(&body.q, i, j) * x[j];
      body.initial[3 * k + i] = (real)((long)body.q.nn * x[i]);
      body.final[3 * k + i] = (real)image;
    }
    body.weights[k] = (real)integer(1, 9);
  }
}

static void make_some_body(int n, int w) {
  const int here[3] = {0, 0, 0};
  make_body(n, w, 20, here);
}

/* What came out of one call. */
typedef struct solution {
  int status;
  screw s;
  real T[16];
  motion_quality quality;
} solution;

static solution fit_of(int n, const real *initial, const real *final, const real *weights,
                       const unsigned char *missing) {
  solution found;
  fill_with_pattern(&found, sizeof found);
  found.status =
      FN(chs_motion_fit)((size_t)n, initial, final, weights, missing, any, &found.s, found.T, &found.quality);
  return found;
}

static solution fit_body(const real *weights) { return fit_of(body.n, body.initial, body.final, weights, NULL); }

static void sum_body(motion_sums *sums, const real *weights) {
  FN(chs_motion_begin)(sums);
  for (int k = 0; k < body.n; k++)
    ASSERT_STATUS(CHS_OK, FN(chs_motion_add)(sums, body.initial + 3 * k, body.final + 3 * k, weights ? weights[k] : 1));
}

static solution stream_body(const real *weights) {
  solution found;
  motion_sums sums;
  sum_body(&sums, weights);
  fill_with_pattern(&found, sizeof found);
  found.status = FN(chs_motion_finish)(&sums, any, &found.s, found.T, &found.quality);
  return found;
}

static double reach_of_body(void) {
  double rho = 0;
  for (int k = 0; k < body.n; k++)
    rho = fmax(rho, fmax(length_of(body.initial + 3 * k, 3), length_of(body.final + 3 * k, 3)));
  return rho;
}

/* The expected numbers are rounded too. */
static const double rounding = 2;

static void assert_pose(const solution *found) {
  real R[9], p[3], expected[9], p_expected[3];
  const double k = (double)found->quality.condition;
  turn_matrix(&body.q, expected);
  for (int i = 0; i < 3; i++) p_expected[i] = (real)body.t[i];
  FN(chs_se3_to_parts)(found->T, R, p);
  ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_MOTION_FIT_ROTATION + rounding, k);
  ASSERT_NORM_WITHIN_EPS(p_expected, p, 3, CHS_EPS_MOTION_FIT_POSITION + rounding, k * reach_of_body());
  ASSERT_SAME_BITS(identity4 + 12, found->T + 12, 4);
}

static void assert_screw(const solution *found) {
  real e[3];
  const double k = (double)found->quality.condition;
  turn_axis(&body.q, e);
  ASSERT_NORM_WITHIN_EPS(e, found->s.axis, 3, CHS_EPS_MOTION_FIT_AXIS + rounding, k / sin(turn_angle(&body.q) / 2));
  ASSERT_WITHIN_EPS(turn_angle(&body.q), found->s.angle, CHS_EPS_MOTION_FIT_ANGLE + rounding, k);
}

static void assert_rigid(const solution *found) {
  const double k = (double)found->quality.condition, far = 2 * reach_of_body();
  ASSERT_WITHIN_EPS(0, found->quality.rms, CHS_EPS_MOTION_FIT_RESIDUALS, k * far);
  ASSERT_WITHIN_EPS(0, found->quality.largest, CHS_EPS_MOTION_FIT_RESIDUALS, k * far);
}

static void test_both_forms_find_rotations_of_every_size(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 12), integer(1, 9));
    const real *weights = k % 2 ? body.weights : NULL;
    const solution fit = fit_body(weights), stream = stream_body(weights);
    ASSERT_STATUS(CHS_OK, fit.status);
    ASSERT_STATUS(CHS_OK, stream.status);
    assert_pose(&fit);
    assert_pose(&stream);
    assert_screw(&fit);
    assert_screw(&stream);
    assert_rigid(&fit);
    TEST_ASSERT_EQUAL(body.n, fit.quality.points);
    TEST_ASSERT_EQUAL(0, fit.quality.missing);
    TEST_ASSERT_EQUAL(body.n, stream.quality.points);
    TEST_ASSERT_TRUE(stream.quality.largest == -1 && stream.quality.largest_at == (size_t)body.n);
  }
}

static void test_half_turns_have_a_positive_first_component(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 12), 0);
    const solution fit = fit_body(NULL), stream = stream_body(NULL);
    ASSERT_STATUS(CHS_HALF_TURN, fit.status);
    ASSERT_STATUS(CHS_HALF_TURN, stream.status);
    assert_pose(&fit);
    assert_screw(&fit);
    assert_screw(&stream);
  }
}

/* The errors do not grow with the number of points, nor with their distance from the origin. */
static void test_many_points_far_from_the_origin(void) {
  const int offset[3] = {PICK(1000000, 2000), PICK(-700000, -1500), PICK(400000, 900)};
  const int counts[] = {10, 63, 64, 65, 100, 1000, MOST};
  for (int k = 0; k < LENGTH(counts); k++) {
    make_body(counts[k], integer(1, 5), PICK(1000, 20), offset);
    const solution fit = fit_body(NULL), stream = stream_body(NULL);
    ASSERT_STATUS(CHS_OK, fit.status);
    ASSERT_STATUS(CHS_OK, stream.status);
    TEST_ASSERT_TRUE(fit.quality.condition < 10);
    assert_pose(&fit);
    assert_pose(&stream);
  }
}

static void test_pure_translations_and_no_motion_are_exact(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 12), 1);
    for (int i = 0; i < 3 * body.n; i++) body.final[i] = body.initial[i] + (k % 2 ? (real)body.t[i % 3] : 0);
    const solution fit = fit_body(k % 3 ? body.weights : NULL), stream = stream_body(NULL);
    ASSERT_STATUS(k % 2 ? CHS_PURE_TRANSLATION : CHS_NO_MOTION, fit.status);
    ASSERT_STATUS(k % 2 ? CHS_PURE_TRANSLATION : CHS_NO_MOTION, stream.status);
    real R[9], p[3];
    FN(chs_se3_to_parts)(fit.T, R, p);
    ASSERT_SAME_BITS(identity3, R, 9);
    TEST_ASSERT_TRUE(fit.s.angle == 0);
    if (k % 2 == 0) ASSERT_SAME_BITS(identity4, fit.T, 16);
  }
}

static void assert_same_displacement(const solution *a, const solution *b) {
  const double k = fmax((double)a->quality.condition, (double)b->quality.condition), rho = reach_of_body();
  real Ra[9], pa[3], Rb[9], pb[3];
  FN(chs_se3_to_parts)(a->T, Ra, pa);
  FN(chs_se3_to_parts)(b->T, Rb, pb);
  ASSERT_ENTRIES_WITHIN_EPS(Ra, Rb, 9, 2 * CHS_EPS_MOTION_FIT_ROTATION, k);
  ASSERT_NORM_WITHIN_EPS(pa, pb, 3, 2 * CHS_EPS_MOTION_FIT_POSITION, k * rho);
  ASSERT_WITHIN_EPS(a->quality.rms, b->quality.rms, 2 * CHS_EPS_MOTION_FIT_RESIDUALS, 2 * k * rho);
}

/* Points that measuring errors have moved, in any amount. */
static void disturb_body(double size) {
  for (int i = 0; i < 3 * body.n; i++) body.final[i] = rounded((double)body.final[i] + uniform(-size, size));
}

static void test_a_whole_weight_is_as_many_points(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 9), integer(0, 5));
    disturb_body(log_uniform(1, 300));
    const solution weighted = fit_body(body.weights);
    int count = 0;
    static real before[300], after[300];
    for (int m = 0; m < body.n; m++)
      for (int copies = 0; copies < (int)body.weights[m]; copies++, count += 3) {
        memcpy(before + count, body.initial + 3 * m, 3 * sizeof(real));
        memcpy(after + count, body.final + 3 * m, 3 * sizeof(real));
      }
    const solution copied = fit_of(count / 3, before, after, NULL, NULL);
    if (weighted.status < 0 || weighted.quality.condition > 1000) continue;
    assert_same_displacement(&weighted, &copied);
    ASSERT_WITHIN_EPS(weighted.quality.size, copied.quality.size, 2 * CHS_EPS_MOTION_FIT_SIZE, weighted.quality.size);
  }
}

/* Masked, not a number, infinite or of no weight: the result is that of the others. */
static void test_missing_points_are_left_out(void) {
  for (int k = 0; k < CASES; k++) {
    static real before[300], after[300], weights[100];
    unsigned char missing[100] = {0};
    make_some_body(integer(5, 100), integer(1, 5));
    disturb_body(5);
    int left = 0, gone = 0;
    for (int m = 0; m < body.n; m++) {
      if (integer(0, 3) > 0 || body.n - gone <= 4) {
        memcpy(before + 3 * left, body.initial + 3 * m, 3 * sizeof(real));
        memcpy(after + 3 * left, body.final + 3 * m, 3 * sizeof(real));
        weights[left++] = body.weights[m];
        continue;
      }
      gone++;
      real *p = (m % 2 ? body.initial : body.final) + 3 * m + m % 3;
      if (k % 4 == 0) missing[m] = 1, *p = (real)NAN, body.weights[m] = -1;
      if (k % 4 == 1) *p = (real)NAN, body.weights[m] = (real)NAN;
      if (k % 4 == 2) *p = m % 2 ? (real)INFINITY : -(real)INFINITY;
      if (k % 4 == 3) *p = (real)NAN, body.weights[m] = 0;
    }
    const solution all = fit_of(body.n, body.initial, body.final, body.weights, k % 4 ? NULL : missing);
    const solution rest = fit_of(left, before, after, weights, NULL);
    ASSERT_STATUS(CHS_OK, rest.status);
    ASSERT_STATUS(gone > 0 && k % 4 < 3 ? CHS_POINTS_MISSING : CHS_OK, all.status);
    TEST_ASSERT_EQUAL(left, all.quality.points);
    TEST_ASSERT_EQUAL(k % 4 < 3 ? gone : 0, all.quality.missing);
    memcpy(body.initial, before, sizeof before);
    memcpy(body.final, after, sizeof after);
    body.n = left;
    assert_same_displacement(&all, &rest);
  }
}

static void test_streaming_tells_of_a_missing_point_and_leaves_it_out(void) {
  const real good[3] = {1, 2, 3}, bad[3] = {1, (real)NAN, 3};
  make_some_body(6, 2);
  motion_sums sums, before;
  sum_body(&sums, NULL);
  before = sums;
  ASSERT_STATUS(CHS_POINTS_MISSING, FN(chs_motion_add)(&sums, good, bad, 1));
  ASSERT_STATUS(CHS_POINTS_MISSING, FN(chs_motion_add)(&sums, bad, good, -1));
  ASSERT_STATUS(CHS_OK, FN(chs_motion_add)(&sums, bad, good, 0));
  TEST_ASSERT_EQUAL(2, sums.missing);
  ASSERT_SAME_BITS(before.sum, sums.sum, LENGTH(sums.sum));
  ASSERT_STATUS(CHS_POINTS_MISSING, FN(chs_motion_finish)(&sums, any, NULL, NULL, NULL));
}

static void test_a_refused_point_leaves_the_sums_as_they_were(void) {
  const real good[3] = {1, 2, 3}, far[3] = {REAL_MAX, 0, 0}, farther[3] = {-REAL_MAX, 0, 0};
  const real bad_weights[] = {-1, (real)NAN, any, -any};
  motion_sums sums, before;
  make_some_body(6, 2);
  sum_body(&sums, NULL);
  before = sums;
  for (int k = 0; k < LENGTH(bad_weights); k++)
    ASSERT_STATUS(CHS_ERR_ARGUMENT, FN(chs_motion_add)(&sums, good, good, bad_weights[k]));
  TEST_ASSERT_EQUAL_MEMORY(&before, &sums, sizeof sums);
  FN(chs_motion_begin)(&sums);
  ASSERT_STATUS(CHS_OK, FN(chs_motion_add)(&sums, far, good, 1));
  before = sums;
  ASSERT_STATUS(CHS_ERR_OVERFLOW, FN(chs_motion_add)(&sums, farther, good, 1));
  TEST_ASSERT_EQUAL_MEMORY(&before, &sums, sizeof sums);
}

/* No rotation nearby fits better, whether the points are nearly rigid, a mirror image or anything. */
static void test_the_rotation_is_proper_and_the_best(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 12), integer(0, 5));
    if (k % 3 == 0)
      for (int i = 2; i < 3 * body.n; i += 3) body.final[i] = -body.final[i];
    disturb_body(log_uniform(1, 300));
    const solution found = fit_body(NULL);
    if (found.status < 0 || found.quality.condition > 1000) continue;
    real R[9], p[3], turned[9], w[3], dR[9];
    FN(chs_se3_to_parts)(found.T, R, p);
    ASSERT_STATUS(CHS_OK, FN(chs_so3_check)(R, K(16.0) * (real)EPS));
    double mean[2][3] = {{0}};
    for (int i = 0; i < 3 * body.n; i++) {
      mean[0][i % 3] += (double)body.initial[i] / body.n;
      mean[1][i % 3] += (double)body.final[i] / body.n;
    }
    double sums[7];
    for (int m = 0; m < 7; m++) {
      random_vector(m == 0 ? 0 : m < 4 ? 0.01 : 1.5, w);
      FN(chs_so3_exp)(w, dR);
      product_of(R, dR, 3, 3, turned);
      sums[m] = 0;
      for (int n = 0; n < body.n; n++)
        for (int i = 0; i < 3; i++) {
          double off = (double)body.final[3 * n + i] - mean[1][i];
          for (int j = 0; j < 3; j++) off -= (double)turned[3 * i + j] * ((double)body.initial[3 * n + j] - mean[0][j]);
          sums[m] += off * off;
        }
    }
    for (int m = 1; m < 7; m++) TEST_ASSERT_TRUE(sums[0] <= sums[m]);
    const double size = (double)found.quality.size;
    ASSERT_WITHIN_EPS(sqrt(sums[0] / body.n), found.quality.rms, CHS_EPS_MOTION_FIT_RESIDUALS + rounding,
                      (double)found.quality.condition * 3 * fmax(size, sqrt(sums[0] / body.n)));
  }
}

/* A cloud grown by a quarter about its centroid: every residual is a quarter of a distance from it. */
static void test_growth_is_told_with_the_residuals(void) {
  const real initial[12] = {4, 0, 0, -4, 0, 0, 0, 8, 0, 0, -8, 0}; /* mean square 40 */
  real final[12];
  solution found;
  scaled(1.25, initial, 12, final);
  found = fit_of(4, initial, final, NULL, NULL);
  ASSERT_STATUS(CHS_NO_MOTION, found.status);
  ASSERT_WITHIN_EPS(sqrt(40), found.quality.size, CHS_EPS_MOTION_FIT_SIZE, sqrt(40));
  ASSERT_WITHIN_EPS(sqrt(40) / 4, found.quality.rms, CHS_EPS_MOTION_FIT_RESIDUALS, sqrt(40));
  ASSERT_WITHIN_EPS(2, found.quality.largest, CHS_EPS_MOTION_FIT_RESIDUALS, 8);
  TEST_ASSERT_EQUAL(2, found.quality.largest_at);
  ASSERT_WITHIN_EPS(0.25, found.quality.growth, CHS_EPS_MOTION_FIT_GROWTH, 1.25);
  ASSERT_WITHIN_EPS(0.25, found.quality.rigidity, CHS_EPS_MOTION_FIT_RIGIDITY, 1);
  /* Refused below a tolerance of 0.25, by either form and whether or not the quality is asked for. */
  motion_sums sums;
  FN(chs_motion_begin)(&sums);
  for (int k = 0; k < 4; k++) FN(chs_motion_add)(&sums, initial + 3 * k, final + 3 * k, 2);
  const real refused[] = {K(0.2499), 0, -1, (real)NAN}, accepted[] = {K(0.2501), 1, any};
  for (int k = 0; k < LENGTH(refused); k++) {
    solution out;
    ASSERT_REFUSES(CHS_ERR_NOT_RIGID, out,
                   FN(chs_motion_fit)(4, initial, final, NULL, NULL, refused[k], &out.s, out.T, &out.quality));
    ASSERT_REFUSES(CHS_ERR_NOT_RIGID, out,
                   FN(chs_motion_fit)(4, initial, final, NULL, NULL, refused[k], &out.s, out.T, NULL));
    ASSERT_REFUSES(CHS_ERR_NOT_RIGID, out, FN(chs_motion_finish)(&sums, refused[k], &out.s, out.T, &out.quality));
  }
  for (int k = 0; k < LENGTH(accepted); k++) {
    ASSERT_STATUS(CHS_NO_MOTION, FN(chs_motion_fit)(4, initial, final, NULL, NULL, accepted[k], NULL, NULL, NULL));
    ASSERT_STATUS(CHS_NO_MOTION, FN(chs_motion_finish)(&sums, accepted[k], NULL, NULL, NULL));
  }
}

static void test_scaling_by_a_power_of_two_scales_the_lengths_and_nothing_else(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(integer(4, 12), integer(1, 5));
    disturb_body(1);
    const solution found = fit_body(NULL), stream = stream_body(NULL);
    const int power = k % 2 ? integer(PICK(-480, -45), PICK(480, 45)) : k % 4 ? PICK(900, 100) : PICK(-900, -100);
    for (int i = 0; i < 3 * body.n; i++) {
      body.initial[i] = (real)ldexp((double)body.initial[i], power);
      body.final[i] = (real)ldexp((double)body.final[i], power);
    }
    const solution large = fit_body(NULL), large_stream = stream_body(NULL);
    ASSERT_STATUS(found.status, large.status);
    real R[9], p[3], R_large[9], p_large[3];
    FN(chs_se3_to_parts)(found.T, R, p);
    FN(chs_se3_to_parts)(large.T, R_large, p_large);
    if (k % 2) ASSERT_SAME_BITS(R, R_large, 9);
    ASSERT_ENTRIES_WITHIN_EPS(R, R_large, 9, 2 * CHS_EPS_MOTION_FIT_ROTATION, found.quality.condition);
    ASSERT_WITHIN_EPS(ldexp((double)found.quality.size, power), large.quality.size, 2 * CHS_EPS_MOTION_FIT_SIZE,
                      large.quality.size);
    FN(chs_se3_to_parts)(stream.T, R, p);
    FN(chs_se3_to_parts)(large_stream.T, R_large, p_large);
    ASSERT_ENTRIES_WITHIN_EPS(R, R_large, 9, 2 * CHS_EPS_MOTION_FIT_ROTATION, stream.quality.condition);
  }
}

/* A point that is far away or weighs much, at any place of the queue. */
static void test_outliers_do_no_harm_wherever_they_come(void) {
  for (int k = 0; k < CASES; k++) {
    make_some_body(40, integer(1, 5));
    const int at = integer(0, 39);
    for (int i = 0; i < 3; i++) {
      const int x[3] = {PICK(1 << 20, 1 << 12), -7, 99};
      long image = body.t[i];
      for (int j = 0; j < 3; j++) image += (long)turn_numerator(&body.q, i, j) * x[j];
      body.initial[3 * at + i] = (real)((long)body.q.nn * x[i]);
      body.final[3 * at + i] = (real)image;
    }
    body.weights[at] = rounded(ldexp(1, k % 2 ? -PICK(40, 24) : PICK(20, 10)));
    const solution fit = fit_body(body.weights), stream = stream_body(body.weights);
    TEST_ASSERT_TRUE(fit.status >= 0 && stream.status >= 0);
    assert_pose(&fit);
    assert_pose(&stream);
  }
}

/* By integers that need no rounding. */
static double size_of_body(const real *points) {
  double sum[3] = {0}, squares = 0;
  for (int i = 0; i < 3 * body.n; i++) {
    const double x = (double)points[i] / body.q.nn;
    sum[i % 3] += x;
    squares += x * x;
  }
  return body.q.nn * sqrt(body.n * squares - (sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2])) / body.n;
}

/* The sixteen points that say where the others may be, all of them somewhere else. */
static void test_a_sample_that_is_none_of_the_rest_costs_no_digits(void) {
  const int here[3] = {0, 0, 0};
  for (int c = 0; c < CASES; c++) {
    make_body(128, integer(1, 5), PICK(1 << 16, 1 << 8), here);
    for (int k = 0; k < 16; k++) {
      const int at = k + k * (k + 1) / 2 * 112 / 128;
      for (int i = 0; i < 3; i++) {
        const int x[3] = {PICK(1 << 19, 1 << 11), -PICK(1 << 18, 1 << 10) + k, 99 + c};
        long image = body.t[i];
        for (int j = 0; j < 3; j++) image += (long)turn_numerator(&body.q, i, j) * x[j];
        body.initial[3 * at + i] = (real)((long)body.q.nn * x[i]);
        body.final[3 * at + i] = (real)image;
      }
    }
    const solution fit = fit_body(NULL), stream = stream_body(NULL);
    const double size = size_of_body(body.initial);
    TEST_ASSERT_TRUE(fit.status >= 0 && stream.status >= 0);
    assert_pose(&fit);
    assert_pose(&stream);
    ASSERT_WITHIN_EPS(size, fit.quality.size, CHS_EPS_MOTION_FIT_SIZE, size);
    ASSERT_WITHIN_EPS(size, stream.quality.size, CHS_EPS_MOTION_FIT_SIZE, size);
    ASSERT_WITHIN_EPS(0, fit.quality.growth, CHS_EPS_MOTION_FIT_GROWTH, 1);
    ASSERT_WITHIN_EPS(0, stream.quality.growth, CHS_EPS_MOTION_FIT_GROWTH, 1);
  }
}

static void assert_fit_refuses(int status, int n, const real *initial, const real *final, const real *weights) {
  solution out;
  motion_sums sums;
  ASSERT_REFUSES(status, out,
                 FN(chs_motion_fit)((size_t)n, initial, final, weights, NULL, any, &out.s, out.T, &out.quality));
  FN(chs_motion_begin)(&sums);
  int added = CHS_OK;
  for (int k = 0; k < n && added >= 0; k++)
    added = FN(chs_motion_add)(&sums, initial + 3 * k, final + 3 * k, weights ? weights[k] : 1);
  if (added < 0) {
    ASSERT_STATUS(status, added);
    return;
  }
  ASSERT_REFUSES(status, out, FN(chs_motion_finish)(&sums, any, &out.s, out.T, &out.quality));
}

static void test_clouds_without_a_rotation_are_refused(void) {
  const real good[12] = {1, 0, 0, 0, 2, 0, 0, 0, 1, 1, 1, 3}, point[12] = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
  const real near = K(3.0) + K(2.0) * (real)EPS; /* the next number: 2 eps apart are less than 4 eps of 3 */
  const real rounded_point[12] = {3, 3, 3, near, 3, 3, 3, near, 3, 3, 3, near};
  const real line[12] = {0, 0, 0, 1, 2, 3, 2, 4, 6, -1, -2, -3}, nan[12] = {(real)NAN, 0, 0, 0, (real)INFINITY};
  const real weights[4] = {1, 0, 2, 0}, bad[4] = {1, 1, -1, 1};
  const real corners[18] = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1};
  const real wide[12] = {REAL_MAX, 0, 0, -REAL_MAX, 0, 0, 0, 1, 0, 0, 0, 1};
  real mirror[18];
  scaled(-1, corners, 18, mirror);
  assert_fit_refuses(CHS_ERR_TOO_FEW_POINTS, 0, good, good, NULL);
  assert_fit_refuses(CHS_ERR_TOO_FEW_POINTS, 2, good, good, NULL);
  assert_fit_refuses(CHS_ERR_TOO_FEW_POINTS, 4, good, good, weights);
  assert_fit_refuses(CHS_ERR_TOO_FEW_POINTS, 4, good, nan, NULL);
  assert_fit_refuses(CHS_ERR_ARGUMENT, 4, good, good, bad);
  assert_fit_refuses(CHS_ERR_COINCIDENT, 4, point, good, NULL);
  assert_fit_refuses(CHS_ERR_COINCIDENT, 4, good, point, NULL);
  assert_fit_refuses(CHS_ERR_COINCIDENT, 4, point, point, NULL);
  assert_fit_refuses(CHS_ERR_COINCIDENT, 4, rounded_point, good, NULL);
  assert_fit_refuses(CHS_ERR_COINCIDENT, 4, good, rounded_point, NULL);
  assert_fit_refuses(CHS_ERR_COLLINEAR, 4, line, good, NULL);
  assert_fit_refuses(CHS_ERR_COLLINEAR, 4, good, line, NULL);
  assert_fit_refuses(CHS_ERR_COLLINEAR, 4, line, line, NULL);
  assert_fit_refuses(CHS_ERR_SINGULAR, 6, corners, mirror, NULL);
  assert_fit_refuses(CHS_ERR_OVERFLOW, 4, wide, good, NULL);

  /* A third of a turn about (1, 1, 1), and a way along it that is longer than any of its coordinates. */
  const real most = K(0.45) * REAL_MAX, off = K(0.05) * REAL_MAX;
  const real low[12] = {-most, -most,      -most, off - most, -most, -most,
                        -most, off - most, -most, -most,      -most, off - most};
  const real high[12] = {most, most, most, most, off + most, most, most, most, off + most, off + most, most, most};
  assert_fit_refuses(CHS_ERR_OVERFLOW, 4, low, high, NULL);
}

static void test_thin_clouds_are_called_ill_conditioned(void) {
  const int length = PICK(100000, 200);
  real initial[12] = {0, 0, 0, (real)length, 0, 0, (real)(length / 2), 1, 0, (real)(length / 4), 0, 1};
  real final[12]; /* a quarter turn about z */
  for (int k = 0; k < 4; k++) set(final + 3 * k, -initial[3 * k + 1], initial[3 * k], initial[3 * k + 2]);
  const solution found = fit_of(4, initial, final, NULL, NULL);
  const real expected[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  real R[9], p[3];
  ASSERT_STATUS(CHS_ILL_CONDITIONED, found.status);
  FN(chs_se3_to_parts)(found.T, R, p);
  ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, CHS_EPS_MOTION_FIT_ROTATION, found.quality.condition);
}

static void test_outputs_may_overlap_inputs_or_be_left_out(void) {
  make_some_body(8, 2);
  disturb_body(5);
  const solution apart = fit_body(body.weights);
  ASSERT_STATUS(apart.status,
                FN(chs_motion_fit)(8, body.initial, body.final, body.weights, NULL, any, NULL, NULL, NULL));
  for (int k = 0; k < 4; k++) {
    real initial[24], final[24], weights[16];
    memcpy(initial, body.initial, sizeof initial);
    memcpy(final, body.final, sizeof final);
    memcpy(weights, body.weights, 8 * sizeof(real));
    real *T = k == 0 ? initial : k == 1 ? final + 3 : k == 2 ? weights : final;
    screw *s = SCREW_AT(k == 0 ? final : k == 3 ? weights : initial);
    motion_quality quality;
    ASSERT_STATUS(apart.status, FN(chs_motion_fit)(8, initial, final, weights, NULL, any, s, T, &quality));
    ASSERT_SAME_BITS(apart.T, T, 16);
    ASSERT_SAME_BITS(apart.s.axis, s->axis, 8);
    TEST_ASSERT_TRUE(quality.rms == apart.quality.rms);
  }
}

/* More points may follow an answer, and the sums may be copied. */
static void test_streaming_goes_on_after_an_answer(void) {
  make_some_body(20, 3);
  motion_sums sums, copied;
  FN(chs_motion_begin)(&sums);
  for (int k = 0; k < 20; k++) {
    ASSERT_STATUS(CHS_OK, FN(chs_motion_add)(&sums, body.initial + 3 * k, body.final + 3 * k, 1));
    if (k < 2) ASSERT_STATUS(CHS_ERR_TOO_FEW_POINTS, FN(chs_motion_finish)(&sums, any, NULL, NULL, NULL));
  }
  copied = sums;
  solution found;
  found.status = FN(chs_motion_finish)(&copied, any, &found.s, found.T, &found.quality);
  ASSERT_STATUS(CHS_OK, found.status);
  assert_pose(&found);
  FN(chs_motion_begin)(&copied);
  ASSERT_STATUS(CHS_ERR_TOO_FEW_POINTS, FN(chs_motion_finish)(&copied, any, NULL, NULL, NULL));
}

/* ---- Covariance ---- */

enum { TRIALS = 4000, MARKERS = 6 };

static double gaussian(void) { return sqrt(-2 * log(1 - uniform(0, 1))) * cos(2 * PI * uniform(0, 1)); }

/* Markers of an arm's size in metres about one away from the origin, their images, and the errors of each. */
typedef struct experiment {
  real initial[3 * MARKERS], final[3 * MARKERS], weights[MARKERS], T[16];
  double sigma_initial, sigma_final;
} experiment;

static void make_experiment(experiment *e, double angle) {
  real w[3], R[9], p[3], centre[3];
  random_vector(angle, w);
  FN(chs_so3_exp)(w, R);
  random_vector(0.3, p);
  random_vector(1, centre);
  FN(chs_se3_from_parts)(R, p, e->T);
  for (int k = 0; k < MARKERS; k++) {
    random_vector(uniform(0.05, 0.2), e->initial + 3 * k);
    for (int i = 0; i < 3; i++) e->initial[3 * k + i] += centre[i];
    FN(chs_se3_apply)(e->T, e->initial + 3 * k, e->final + 3 * k);
    e->weights[k] = rounded(uniform(0.5, 4));
  }
}

static void measure(const experiment *e, real initial[3 * MARKERS], real final[3 * MARKERS]) {
  for (int i = 0; i < 3 * MARKERS; i++) {
    const double spread = 1 / sqrt((double)e->weights[i / 3]);
    initial[i] = rounded((double)e->initial[i] + spread * e->sigma_initial * gaussian());
    final[i] = rounded((double)e->final[i] + spread * e->sigma_final * gaussian());
  }
}

/* The errors of one measurement, (w; d) and those of the screw. */
static void errors_of(const experiment *e, const screw *right, const screw *s, const real T[16], double error[14]) {
  real R[9], R0[9], p[3], p0[3], w[3], apart[9];
  FN(chs_se3_to_parts)(T, R, p);
  FN(chs_se3_to_parts)(e->T, R0, p0);
  FN(chs_so3_transpose)(R0, R0);
  FN(chs_so3_multiply)(R, R0, apart);
  TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_so3_log)(apart, w));
  for (int i = 0; i < 3; i++) {
    error[i] = (double)w[i];
    error[3 + i] = (double)p[i] - (double)p0[i];
    error[6 + i] = (double)s->axis[i] - (double)right->axis[i];
    error[9 + i] = (double)s->point[i] - (double)right->point[i];
  }
  error[12] = (double)s->translation - (double)right->translation;
  error[13] = (double)s->angle - (double)right->angle;
}

/* Entry (i, j) of the two matrices, for i and j both of the pose, below 6, or both of the screw. */
static double predicted(const real pose[36], const real of_screw[64], int i, int j) {
  return (double)(i < 6 ? pose[6 * i + j] : of_screw[8 * (i - 6) + j - 6]);
}

/* The sample covariance of N measurements differs from the true one by its own standard deviation, ((c_ii c_jj +
 * c_ij^2)/N)^1/2 as the chi-square distribution has it, times a standard normal number: five of them are not exceeded
 * by 57 entries but once in 30000 runs, and the seed is fixed. The first order leaves out (error/size)^2, 1e-4. */
static void check_by_monte_carlo(const char *name, double angle, double sigma_initial, double sigma_final) {
  experiment e;
  real pose[36], of_screw[64], initial[3 * MARKERS], final[3 * MARKERS], T[16];
  screw right, s;
  double sum[14] = {0}, square[14][14] = {{0}}, worst = 0;
  make_experiment(&e, angle);
  e.sigma_initial = sigma_initial;
  e.sigma_final = sigma_final;
  const real sigma = rounded(hypot(sigma_initial, sigma_final));
  TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_screw_from_pose)(e.T, &right));
  ASSERT_STATUS(CHS_OK, FN(chs_motion_covariance)(MARKERS, e.initial, e.final, e.weights, NULL, sigma, pose, of_screw));
  for (int n = 0; n < TRIALS; n++) {
    double error[14];
    measure(&e, initial, final);
    int status = FN(chs_motion_fit)(MARKERS, initial, final, e.weights, NULL, any, &s, T, NULL);
    TEST_ASSERT_GREATER_OR_EQUAL(0, status);
    errors_of(&e, &right, &s, T, error);
    for (int i = 0; i < 14; i++) {
      sum[i] += error[i];
      for (int j = 0; j < 14; j++) square[i][j] += error[i] * error[j];
    }
  }
  for (int i = 0; i < 14; i++)
    for (int j = i < 6 ? 0 : 6; j <= i; j++) {
      const double sample = (square[i][j] - sum[i] * sum[j] / TRIALS) / (TRIALS - 1);
      const double c = predicted(pose, of_screw, i, j);
      const double variances = predicted(pose, of_screw, i, i) * predicted(pose, of_screw, j, j);
      worst = fmax(worst, fabs(sample - c) / sqrt((variances + c * c) / TRIALS));
    }
  printf("covariance by Monte Carlo, %s: %d trials, worst of 57 entries off by %.2f standard deviations\n", name,
         TRIALS, worst);
  if (!(worst < 5)) fail(__LINE__, "%s: off by %g standard deviations", name, worst);
}

static void test_covariance_is_that_of_many_measurements(void) {
  check_by_monte_carlo("errors after, 1 rad", 1, 0, 1e-3);
  check_by_monte_carlo("errors before and after, 2.5 rad", 2.5, 5e-4, 8e-4);
  check_by_monte_carlo("errors before, 0.3 rad", 0.3, 3e-4, 0);
}

static void test_both_forms_give_the_same_covariance(void) {
  for (int k = 0; k < CASES; k++) {
    real pose[36], of_screw[64], stream_pose[36], stream_screw[64], only[64];
    motion_sums sums;
    make_some_body(integer(4, 12), integer(1, 5));
    sum_body(&sums, body.weights);
    int status = FN(chs_motion_covariance)((size_t)body.n, body.initial, body.final, body.weights, NULL, K(0.001), pose,
                                           of_screw);
    ASSERT_STATUS(CHS_OK, status);
    ASSERT_STATUS(CHS_OK, FN(chs_motion_finish_covariance)(&sums, K(0.001), stream_pose, stream_screw));
    const double allowed = 1000 * CHS_EPS_MOTION_COVARIANCE;
    for (int i = 0; i < 6; i++) ASSERT_WITHIN_EPS(pose[7 * i], stream_pose[7 * i], allowed, pose[7 * i]);
    for (int i = 0; i < 8; i++) {
      const int part = i < 3 ? 0 : i < 6 ? 3 : i; /* a component of a vector may have no variance at all */
      double of_part = 0;
      for (int j = part; j < (i < 6 ? part + 3 : i + 1); j++) of_part += (double)of_screw[9 * j];
      ASSERT_WITHIN_EPS(of_screw[9 * i], stream_screw[9 * i], 1000 * allowed, of_part);
    }
    ASSERT_STATUS(CHS_OK, FN(chs_motion_finish_covariance)(&sums, K(0.001), NULL, only));
    ASSERT_SAME_BITS(stream_screw, only, 64);
    ASSERT_STATUS(CHS_OK, FN(chs_motion_finish_covariance)(&sums, K(0.001), only, NULL));
    ASSERT_SAME_BITS(stream_pose, only, 36);
    for (int i = 0; i < 8; i++)
      for (int j = 0; j < 8; j++) {
        const double variances = (double)of_screw[9 * i] * (double)of_screw[9 * j];
        ASSERT_WITHIN_EPS(of_screw[8 * i + j], of_screw[8 * j + i], 1000, sqrt(variances));
      }
  }
}

/* Twice the errors are four times the covariance, to the last bit; twice the weights half of it, but for rounding. */
static void test_covariance_scales_with_errors_and_weights(void) {
  real pose[36], of_screw[64], larger_pose[36], larger_screw[64], heavy[MOST];
  make_some_body(8, 3);
  ASSERT_STATUS(CHS_OK, FN(chs_motion_covariance)(8, body.initial, body.final, NULL, NULL, K(0.25), pose, of_screw));
  ASSERT_STATUS(CHS_OK,
                FN(chs_motion_covariance)(8, body.initial, body.final, NULL, NULL, K(0.5), larger_pose, larger_screw));
  for (int i = 0; i < 36; i++) TEST_ASSERT_TRUE(4 * pose[i] == larger_pose[i]);
  for (int i = 0; i < 64; i++) TEST_ASSERT_TRUE(4 * of_screw[i] == larger_screw[i]);
  for (int i = 0; i < 8; i++) heavy[i] = 4;
  ASSERT_STATUS(CHS_OK, FN(chs_motion_covariance)(8, body.initial, body.final, heavy, NULL, K(0.5), larger_pose, NULL));
  for (int i = 0; i < 6; i++) ASSERT_WITHIN_EPS(pose[7 * i], larger_pose[7 * i], 1000, pose[7 * i]);
}

static void test_covariance_of_small_angles_is_called_ill_conditioned_or_refused(void) {
  struct {
    real pose[36], of_screw[64];
  } out;
  experiment e;
  make_experiment(&e, 0.05);
  ASSERT_STATUS(CHS_OK,
                FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, K(1e-4), NULL, out.of_screw));
  ASSERT_STATUS(CHS_ILL_CONDITIONED,
                FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, K(0.01), NULL, out.of_screw));
  ASSERT_STATUS(CHS_OK, FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, K(0.001), out.pose, NULL));
  ASSERT_STATUS(CHS_ILL_CONDITIONED,
                FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, K(0.1), out.pose, NULL));
  ASSERT_REFUSES(CHS_ERR_SINGULAR, out,
                 FN(chs_motion_covariance)(MARKERS, e.initial, e.initial, NULL, NULL, 1, out.pose, out.of_screw));
  ASSERT_STATUS(CHS_NO_MOTION,
                FN(chs_motion_covariance)(MARKERS, e.initial, e.initial, NULL, NULL, K(1e-4), out.pose, NULL));
  const real bad[] = {-1, (real)NAN, any};
  for (int k = 0; k < LENGTH(bad); k++)
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, out,
                   FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, bad[k], out.pose, out.of_screw));
  ASSERT_REFUSES(CHS_ERR_TOO_FEW_POINTS, out,
                 FN(chs_motion_covariance)(2, e.initial, e.final, NULL, NULL, 1, out.pose, out.of_screw));
  e.final[4] = (real)NAN;
  ASSERT_STATUS(CHS_POINTS_MISSING,
                FN(chs_motion_covariance)(MARKERS, e.initial, e.final, NULL, NULL, K(1e-4), out.pose, out.of_screw));
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_both_forms_find_rotations_of_every_size);
  RUN_TEST(test_half_turns_have_a_positive_first_component);
  RUN_TEST(test_many_points_far_from_the_origin);
  RUN_TEST(test_pure_translations_and_no_motion_are_exact);
  RUN_TEST(test_a_whole_weight_is_as_many_points);
  RUN_TEST(test_missing_points_are_left_out);
  RUN_TEST(test_streaming_tells_of_a_missing_point_and_leaves_it_out);
  RUN_TEST(test_a_refused_point_leaves_the_sums_as_they_were);
  RUN_TEST(test_the_rotation_is_proper_and_the_best);
  RUN_TEST(test_growth_is_told_with_the_residuals);
  RUN_TEST(test_scaling_by_a_power_of_two_scales_the_lengths_and_nothing_else);
  RUN_TEST(test_outliers_do_no_harm_wherever_they_come);
  RUN_TEST(test_a_sample_that_is_none_of_the_rest_costs_no_digits);
  RUN_TEST(test_clouds_without_a_rotation_are_refused);
  RUN_TEST(test_thin_clouds_are_called_ill_conditioned);
  RUN_TEST(test_outputs_may_overlap_inputs_or_be_left_out);
  RUN_TEST(test_streaming_goes_on_after_an_answer);
  RUN_TEST(test_covariance_is_that_of_many_measurements);
  RUN_TEST(test_both_forms_give_the_same_covariance);
  RUN_TEST(test_covariance_scales_with_errors_and_weights);
  RUN_TEST(test_covariance_of_small_angles_is_called_ill_conditioned_or_refused);
  return SUITE_END();
}
