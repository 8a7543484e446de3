#include "support/suite.h"

enum { CASES = 300, MOST = 7 };

/* A chain of axes and a tool. */
typedef struct chain {
  int n;
  real axes[6 * MOST], home[16];
} chain;

/* The same as parameters. */
typedef struct table {
  chs_dh convention;
  real dh[4 * MOST], base[16], tool[16];
} table;

static const chs_dh conventions[2] = {CHS_DH_STANDARD, CHS_DH_MODIFIED};

static int table_of(const chain *c, chs_dh convention, double tolerance, table *t) {
  t->convention = convention;
  return FN(chs_line_to_dh)(c->n, convention, c->axes, c->home, (real)tolerance, t->dh, t->base, t->tool);
}

static void chain_of(int n, const table *t, chain *c) {
  c->n = n;
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_dh)(n, t->convention, t->base, t->dh, t->tool, c->axes, c->home));
}

static void assert_same_chain(const chain *expected, const chain *actual, double error, double reach) {
  for (int i = 0; i < 6 * expected->n; i++)
    ASSERT_WITHIN_EPS(expected->axes[i], actual->axes[i], error, i % 6 < 3 ? 1 : reach);
  for (int i = 0; i < 12; i++) ASSERT_WITHIN_EPS(expected->home[i], actual->home[i], error, i % 4 < 3 ? 1 : reach);
}

/* Arms by the tables of their makers and of textbooks, rows a alpha d theta. */
static const struct arm {
  const char *name;
  int n;
  chs_dh convention;
  int status;
  double dh[6][4];
} arms[] = {
    {"UR5e",
     6,
     CHS_DH_STANDARD,
     CHS_PARALLEL,
     {{0, PI / 2, 0.1625, 0},
      {-0.425, 0, 0, 0},
      {-0.3922, 0, 0, 0},
      {0, PI / 2, 0.1333, 0},
      {0, -PI / 2, 0.0997, 0},
      {0, 0, 0.0996, 0}}},
    {"PUMA 560",
     6,
     CHS_DH_STANDARD,
     CHS_PARALLEL,
     {{0, PI / 2, 0, 0},
      {0.4318, 0, 0, 0},
      {0.0203, -PI / 2, 0.15005, 0},
      {0, PI / 2, 0.4318, 0},
      {0, -PI / 2, 0, 0},
      {0, 0, 0, 0}}},
    {"PUMA 560 of Craig",
     6,
     CHS_DH_MODIFIED,
     CHS_PARALLEL,
     {{0, 0, 0, 0},
      {0, -PI / 2, 0, 0},
      {0.4318, 0, 0.15005, 0},
      {0.0203, -PI / 2, 0.4318, 0},
      {0, PI / 2, 0, 0},
      {0, -PI / 2, 0, 0}}},
    {"SCARA", 4, CHS_DH_STANDARD, CHS_COINCIDENT, {{0.25, 0, 0, 0}, {0.25, PI, 0, 0}, {0, 0, 0, 0}, {0, 0, -0.25, 0}}},
};

static void arm_table(const struct arm *a, table *t) {
  t->convention = a->convention;
  for (int i = 0; i < 4 * a->n; i++) t->dh[i] = rounded(a->dh[i / 4][i % 4]);
  memcpy(t->base, identity4, sizeof t->base);
  memcpy(t->tool, identity4, sizeof t->tool);
}

static void random_chain(int n, double parallel, chain *c) {
  c->n = n;
  for (int k = 0; k < n; k++) {
    real p[3], d[3];
    random_vector(1, p);
    random_vector(1, d);
    if (k > 0 && uniform(0, 1) < parallel) scaled(1, c->axes + 6 * (k - 1), 3, d);
    ASSERT_STATUS(CHS_OK, FN(chs_line_from_direction)(p, d, c->axes + 6 * k));
  }
  random_pose(1, c->home);
}

static void test_the_axes_of_a_known_arm(void) {
  /* The UR5e at home: a shoulder, an upper arm and a forearm along -x, as its maker draws it. */
  const double axes[6][6] = {{0, 0, 1, 0, 0, 0},
                             {0, -1, 0, 0.1625, 0, 0},
                             {0, -1, 0, 0.1625, 0, 0.425},
                             {0, -1, 0, 0.1625, 0, 0.8172},
                             {0, 0, -1, 0.1333, -0.8172, 0},
                             {0, -1, 0, 0.0628, 0, 0.8172}};
  table t;
  chain c;
  arm_table(&arms[0], &t);
  chain_of(6, &t, &c);
  for (int i = 0; i < 36; i++) ASSERT_WITHIN_EPS(axes[i / 6][i % 6], c.axes[i], 6 * CHS_EPS_LINE_FROM_DH_MOMENT, 2);
  const double home[3] = {-0.8172, -0.2329, 0.0628};
  for (int i = 0; i < 3; i++) ASSERT_WITHIN_EPS(home[i], c.home[4 * i + 3], 6 * CHS_EPS_LINE_FROM_DH_POSITION, 2);
}

static void test_the_tables_of_known_arms_come_back(void) {
  for (int a = 0; a < LENGTH(arms); a++) {
    table t, back;
    chain c;
    subject = arms[a].name;
    arm_table(&arms[a], &t);
    chain_of(arms[a].n, &t, &c);
    ASSERT_STATUS(arms[a].status, table_of(&c, arms[a].convention, 0, &back));
    for (int i = 0; i < 4 * c.n; i++) ASSERT_WITHIN_EPS(t.dh[i], back.dh[i], 6 * CHS_EPS_LINE_TO_DH_LENGTHS, 4);
    ASSERT_ENTRIES_WITHIN_EPS(identity4, back.base, 16, 6 * CHS_EPS_LINE_TO_DH_POSITION, 2);
    ASSERT_ENTRIES_WITHIN_EPS(identity4, back.tool, 16, 6 * CHS_EPS_LINE_TO_DH_POSITION, 4);
  }
}

static void test_known_arms_are_the_same_in_either_convention(void) {
  for (int a = 0; a < LENGTH(arms); a++)
    for (int i = 0; i < 2; i++) {
      table t, other;
      chain c, back;
      subject = arms[a].name;
      arm_table(&arms[a], &t);
      chain_of(arms[a].n, &t, &c);
      TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, conventions[i], 1e-3, &other));
      chain_of(c.n, &other, &back);
      assert_same_chain(&c, &back, 200, 2);
    }
}

static void test_axes_come_back_from_their_parameters(void) {
  for (int k = 0; k < CASES; k++) {
    chain c, back;
    table t;
    random_chain(integer(1, MOST), k % 2 ? 0.3 : 0, &c);
    int status = table_of(&c, conventions[k / 2 % 2], 0, &t);
    TEST_ASSERT_TRUE(status == CHS_OK || status == CHS_PARALLEL);
    double s = 1, gap = 2;
    for (int i = 0; i + 1 < c.n; i++) {
      real angle, distance;
      FN(chs_line_angle)(c.axes + 6 * i, c.axes + 6 * i + 6, &angle);
      int pair = FN(chs_line_distance)(c.axes + 6 * i, c.axes + 6 * i + 6, &distance);
      if (pair == CHS_PARALLEL) gap = fmin(gap, (double)distance);
      if (pair != CHS_PARALLEL) s = fmin(s, sin((double)angle));
    }
    real z[6] = {0, 0, 1, 0, 0, 0}, tool[6], ends[2];
    FN(chs_line_move)(c.home, z, tool);
    FN(chs_line_angle)(z, c.axes, &ends[0]);
    FN(chs_line_angle)(tool, c.axes + 6 * (c.n - 1), &ends[1]);
    s = fmin(s, fmin(sin((double)ends[0]), sin((double)ends[1])));
    if (s < 0.02 || gap < 0.02) continue;
    chain_of(c.n, &t, &back);
    assert_same_chain(&c, &back, c.n * 30, fmax(1 / s, 1 / gap) * 4);
  }
}

/* What the header says of the free choices. */
static void test_the_free_choices_are_those_of_the_header(void) {
  for (int k = 0; k < CASES; k++) {
    chain c;
    table t;
    random_chain(4, k % 2 ? 0.5 : 0, &c);
    TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, CHS_DH_STANDARD, 0, &t));
    for (int i = 0; i < 4; i++) TEST_ASSERT_TRUE(fabs((double)t.dh[4 * i + 3]) <= PI / 2 + 16 * EPS);
    /* The tool is a turn about z and a travel along it. */
    const int off_z[6] = {2, 6, 8, 9, 3, 7};
    for (int i = 0; i < 6; i++) ASSERT_WITHIN_EPS(0, t.tool[off_z[i]], 2000, 10);
    for (int i = 1; i < 4; i++)
      if (t.dh[4 * i + 1] == 0) ASSERT_WITHIN_EPS(0, t.dh[4 * i + 2], i == 3 ? 0 : 100, 100); /* parallel: no d */
    TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, CHS_DH_MODIFIED, 0, &t));
    for (int i = 0; i < 3; i++) TEST_ASSERT_TRUE(fabs((double)t.dh[4 * i + 3]) <= PI / 2 + 16 * EPS);
    for (int i = 0; i < 6; i++) ASSERT_WITHIN_EPS(0, t.base[off_z[i]], 0, 1);
  }
}

static void test_parallel_and_coincident_neighbours_are_told(void) {
  const real z[6] = {0, 0, 1, 0, 0, 0}, beside[6] = {0, 0, -1, 0, 1, 0}, across[6] = {1, 0, 0, 0, 0, 0};
  const struct {
    const real *axes[3];
    int status;
  } known[] = {
      {{z, across, z}, CHS_OK},         {{z, beside, across}, CHS_PARALLEL},   {{across, z, beside}, CHS_PARALLEL},
      {{z, z, beside}, CHS_COINCIDENT}, {{z, beside, beside}, CHS_COINCIDENT}, {{across, z, across}, CHS_OK}};
  for (int k = 0; k < LENGTH(known); k++)
    for (int i = 0; i < 2; i++) {
      chain c = {3, {0}, {0}}, back;
      table t;
      for (int j = 0; j < 3; j++) memcpy(c.axes + 6 * j, known[k].axes[j], sizeof z);
      memcpy(c.home, identity4, sizeof c.home);
      ASSERT_STATUS(known[k].status, table_of(&c, conventions[i], 0, &t));
      chain_of(3, &t, &back);
      assert_same_chain(&c, &back, 30, 1);
    }
}

/* Axes that are parallel or meet but for the errors of a drawing. */
static void test_a_tolerance_makes_alpha_and_a_exact(void) {
  const double off = PICK(1e-9, 1e-5);
  table t;
  chain c;
  arm_table(&arms[0], &t);
  chain_of(6, &t, &c);
  for (int i = 0; i < 36; i++) c.axes[i] = rounded((double)c.axes[i] + off * uniform(-1, 1));
  for (int i = 0; i < 6; i++) ASSERT_STATUS(CHS_OK, FN(chs_line_normalize)(c.axes + 6 * i, c.axes + 6 * i));
  ASSERT_STATUS(CHS_PARALLEL, table_of(&c, CHS_DH_STANDARD, 10 * off, &t));
  const int zero_a[4] = {0, 3, 4, 5}, zero_alpha[2] = {1, 2};
  for (int i = 0; i < 4; i++) TEST_ASSERT_TRUE(t.dh[4 * zero_a[i]] == 0);
  for (int i = 0; i < 2; i++) TEST_ASSERT_TRUE(t.dh[4 * zero_alpha[i] + 1] == 0);
  for (int i = 0; i < 24; i++) TEST_ASSERT_DOUBLE_WITHIN(100 * off, arms[0].dh[i / 4][i % 4], (double)t.dh[i]);
}

/* Joint values added to theta move the tool as the product of exponentials says. */
static void test_joints_turn_about_the_axes(void) {
  for (int k = 0; k < CASES; k++)
    for (int i = 0; i < 2; i++) {
      chain c, moved;
      table t;
      real q[4], T[16];
      random_chain(4, 0, &c);
      for (int j = 0; j < 4; j++) q[j] = rounded(uniform(-3, 3));
      TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, conventions[i], 0, &t));
      double longest = 1;
      for (int j = 0; j < 16; j += 2) longest = fmax(longest, fabs((double)t.dh[j]));
      if (longest > 20) continue;
      for (int j = 0; j < 4; j++) t.dh[4 * j + 3] += q[j];
      chain_of(4, &t, &moved);
      memcpy(T, c.home, sizeof T);
      for (int j = 3; j >= 0; j--) ASSERT_STATUS(CHS_OK, FN(chs_screw_move_space)(T, c.axes + 6 * j, q[j], T));
      ASSERT_ENTRIES_WITHIN_EPS(T, moved.home, 12, 400 * longest, 4);
    }
}

static void test_a_base_and_a_tool_may_be_left_out(void) {
  const real dh[4] = {1, 0, 2, 0}, axis[6] = {0, 0, 1, 0, 0, 0},
             expected[16] = {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 2, 0, 0, 0, 1};
  real axes[6], home[16], rows[4];
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_dh)(1, CHS_DH_STANDARD, NULL, dh, NULL, axes, home));
  ASSERT_SAME_BITS(axis, axes, 6);
  ASSERT_SAME_BITS(expected, home, 16);
  ASSERT_STATUS(CHS_OK, FN(chs_line_from_dh)(1, CHS_DH_MODIFIED, NULL, dh, NULL, axes, NULL));
  ASSERT_STATUS(CHS_OK, FN(chs_line_to_dh)(1, CHS_DH_STANDARD, axis, expected, 0, rows, NULL, NULL));
  ASSERT_SAME_BITS(dh, rows, 4);
}

static void test_poses_may_overlap_poses(void) {
  for (int i = 0; i < 2; i++) {
    chain c, back;
    table t;
    real T[16], other[16];
    random_chain(3, 0, &c);
    TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, conventions[i], 0, &t));
    memcpy(T, c.home, sizeof T);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_line_to_dh)(3, conventions[i], c.axes, T, 0, t.dh, T, other));
    ASSERT_SAME_BITS(t.base, T, 16);
    memcpy(T, c.home, sizeof T);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_line_to_dh)(3, conventions[i], c.axes, T, 0, t.dh, other, T));
    ASSERT_SAME_BITS(t.tool, T, 16);
    chain_of(3, &t, &back);
    memcpy(T, t.base, sizeof T);
    ASSERT_STATUS(CHS_OK, FN(chs_line_from_dh)(3, conventions[i], T, t.dh, t.tool, c.axes, T));
    ASSERT_SAME_BITS(back.home, T, 16);
  }
}

static void test_wrong_arguments_are_refused_and_nothing_is_written(void) {
  const real bad_axis[6] = {0, 2, 0, 0, 0, 0};
  chain c, out;
  table t, wrong;
  random_chain(3, 0, &c);
  for (int i = 0; i < 2; i++) {
    const chs_dh convention = conventions[i];
    TEST_ASSERT_GREATER_OR_EQUAL(0, table_of(&c, convention, 0, &t));
    table spare = t;
    chain bent = c;
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, wrong,
                   FN(chs_line_to_dh)(0, convention, c.axes, c.home, 0, wrong.dh, wrong.base, wrong.tool));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, wrong,
                   FN(chs_line_to_dh)(3, (chs_dh)0, c.axes, c.home, 0, wrong.dh, wrong.base, wrong.tool));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, wrong,
                   FN(chs_line_to_dh)(3, convention, c.axes, c.home, -1, wrong.dh, wrong.base, wrong.tool));
    ASSERT_REFUSES(CHS_ERR_NAN, wrong,
                   FN(chs_line_to_dh)(3, convention, c.axes, c.home, (real)NAN, wrong.dh, wrong.base, wrong.tool));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, out,
                   FN(chs_line_from_dh)(-1, convention, t.base, t.dh, t.tool, out.axes, out.home));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, out, FN(chs_line_from_dh)(3, (chs_dh)3, t.base, t.dh, t.tool, out.axes, out.home));
    memcpy(bent.axes + 12, bad_axis, sizeof bad_axis);
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, wrong,
                   FN(chs_line_to_dh)(3, convention, bent.axes, c.home, 0, wrong.dh, wrong.base, wrong.tool));
    for (int k = 0; k < 18; k++) {
      bent = c;
      bent.axes[k] = (real)INFINITY;
      ASSERT_REFUSES(CHS_ERR_INFINITE, wrong,
                     FN(chs_line_to_dh)(3, convention, bent.axes, c.home, 0, wrong.dh, wrong.base, wrong.tool));
      bent.axes[k] = (real)NAN;
      ASSERT_REFUSES(CHS_ERR_NAN, wrong,
                     FN(chs_line_to_dh)(3, convention, bent.axes, c.home, 0, wrong.dh, wrong.base, wrong.tool));
    }
    for (int k = 0; k < 12; k++) {
      spare = t;
      spare.dh[k] = (real)NAN;
      ASSERT_REFUSES(CHS_ERR_NAN, out,
                     FN(chs_line_from_dh)(3, convention, t.base, spare.dh, t.tool, out.axes, out.home));
      spare.dh[k] = k % 2 ? NEXT_AFTER(ANGLE_MAX, REAL_MAX) : REAL_MAX;
      if (k % 2)
        ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, out,
                       FN(chs_line_from_dh)(3, convention, t.base, spare.dh, t.tool, out.axes, out.home));
    }
    for (int b = 0; b < LENGTH(bad_rotations); b++) {
      subject = bad_rotations[b].name;
      bent = c;
      put_rotation('T', bad_rotations[b].R, bent.home);
      ASSERT_REFUSES(bad_rotations[b].status, wrong,
                     FN(chs_line_to_dh)(3, convention, c.axes, bent.home, 0, wrong.dh, wrong.base, wrong.tool));
      ASSERT_REFUSES(bad_rotations[b].status, out,
                     FN(chs_line_from_dh)(3, convention, bent.home, t.dh, t.tool, out.axes, out.home));
      ASSERT_REFUSES(bad_rotations[b].status, out,
                     FN(chs_line_from_dh)(3, convention, t.base, t.dh, bent.home, out.axes, out.home));
    }
    subject = "";
  }
}

/* Two axes along z, where |m| is beyond the range and nothing else. */
static void test_axes_as_far_as_can_be_do_not_coincide(void) {
  const real far = K(0.9) * REAL_MAX, home[16] = {1, 0, 0, -far, 0, 1, 0, far, 0, 0, 1, 0, 0, 0, 0, 1};
  const real axes[12] = {0, 0, 1, far, far / 2, 0, 0, 0, 1, far, far, 0};
  real dh[8];
  ASSERT_STATUS(CHS_PARALLEL, FN(chs_line_to_dh)(2, CHS_DH_STANDARD, axes, home, 0, dh, NULL, NULL));
  ASSERT_WITHIN_EPS(-far / 2, dh[0], 1, far);
}

static void test_lengths_beyond_the_range_are_an_overflow(void) {
  const real dh[8] = {REAL_MAX, 0, 0, 0, REAL_MAX, 0, 0, 0};
  const real axes[12] = {0, 0, 1, 0, -REAL_MAX, 0, 0, 0, 1, 0, REAL_MAX, 0};
  chain out;
  table wrong;
  for (int i = 0; i < 2; i++) {
    ASSERT_REFUSES(CHS_ERR_OVERFLOW, out, FN(chs_line_from_dh)(2, conventions[i], NULL, dh, NULL, out.axes, out.home));
    ASSERT_REFUSES(CHS_ERR_OVERFLOW, wrong,
                   FN(chs_line_to_dh)(2, conventions[i], axes, identity4, 0, wrong.dh, wrong.base, wrong.tool));
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_the_axes_of_a_known_arm);
  RUN_TEST(test_the_tables_of_known_arms_come_back);
  RUN_TEST(test_known_arms_are_the_same_in_either_convention);
  RUN_TEST(test_axes_come_back_from_their_parameters);
  RUN_TEST(test_the_free_choices_are_those_of_the_header);
  RUN_TEST(test_parallel_and_coincident_neighbours_are_told);
  RUN_TEST(test_a_tolerance_makes_alpha_and_a_exact);
  RUN_TEST(test_joints_turn_about_the_axes);
  RUN_TEST(test_a_base_and_a_tool_may_be_left_out);
  RUN_TEST(test_poses_may_overlap_poses);
  RUN_TEST(test_wrong_arguments_are_refused_and_nothing_is_written);
  RUN_TEST(test_axes_as_far_as_can_be_do_not_coincide);
  RUN_TEST(test_lengths_beyond_the_range_are_an_overflow);
  return SUITE_END();
}
