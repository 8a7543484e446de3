#include "support/suite.h"

#ifdef CHS_TEST_SINGLE
typedef chs_chainf chain;
#else
typedef chs_chain chain;
#endif

enum { CASES = 300, MOST = 9 };

/* A chain with its arrays, and joint values. */
typedef struct robot {
  int n;
  real screws[6 * MOST], home[16], q[MOST];
} robot;

static chain chain_of(const robot *r, chs_chain_form form) {
  chain c = {r->n, form, r->screws, {0}, NULL};
  memcpy(c.home, r->home, sizeof c.home);
  return c;
}

/* The screw axis of a joint about the axis w through a, with pitch. */
static void line_screw(const real w[3], const real a[3], double pitch, real S[6]) {
  cross_of(a, w, S + 3);
  for (int i = 0; i < 3; i++) {
    S[i] = w[i];
    S[3 + i] = rounded((double)S[3 + i] + pitch * (double)w[i]);
  }
}

static void random_joint(double length, real S[6]) {
  real w[3] = {0, 0, 0}, a[3];
  int kind = integer(0, 9);
  random_vector(1, w);
  random_vector(length, a);
  if (kind < 4) {
    w[0] = w[1] = w[2] = 0;
    w[integer(0, 2)] = integer(0, 1) ? 1 : -1;
  }
  line_screw(w, a, kind % 4 == 3 ? length * uniform(-1, 1) : 0, S);
  if (kind == 9) {
    set(S, 0, 0, 0);
    random_vector(1, S + 3);
  }
}

static void random_robot(int n, double length, robot *r) {
  r->n = n;
  for (int i = 0; i < n; i++) {
    random_joint(length, r->screws + 6 * i);
    r->q[i] = (real)uniform(-PI, PI);
  }
  random_pose(length, r->home);
}

/* As stated in chain.h, for joints with a unit omega or none. */
static double reach_of(const robot *r) {
  const real p[3] = {r->home[3], r->home[7], r->home[11]};
  double reach = length_of(p, 3);
  for (int i = 0; i < r->n; i++) {
    const real *S = r->screws + 6 * i;
    real moment[3];
    double travel = fmax(1, fabs((double)r->q[i]));
    cross_of(S, S + 3, moment);
    reach +=
        length_of(S, 3) > 0 ? length_of(moment, 3) + fabs(dot_of(S, S + 3, 3)) * travel : length_of(S + 3, 3) * travel;
  }
  return reach;
}

static void parts_of(const real T[16], real R[9], real p[3]) { FN(chs_se3_to_parts)(T, R, p); }

static void assert_pose(const real expected[16], const real actual[16], double rotation, double translation,
                        double reach) {
  real R[9], p[3], R_actual[9], p_actual[3];
  parts_of(expected, R, p);
  parts_of(actual, R_actual, p_actual);
  ASSERT_ENTRIES_WITHIN_EPS(R, R_actual, 9, rotation, 1);
  ASSERT_NORM_WITHIN_EPS(p, p_actual, 3, translation, reach);
  ASSERT_SAME_BITS(identity4 + 12, actual + 12, 4);
}

/* exp([S] q) by the functions that have tests of their own, and n times that. */
static void product_of_exponentials(const robot *r, chs_chain_form form, int count, real T[16]) {
  real step[16], V[6];
  memcpy(T, form == CHS_BODY_FORM ? r->home : identity4, sizeof step);
  for (int i = 0; i < count; i++) {
    scaled((double)r->q[i], r->screws + 6 * i, 6, V);
    ASSERT_STATUS(CHS_OK, FN(chs_se3_exp)(V, step));
    FN(chs_se3_compose)(T, step, T);
  }
  if (form == CHS_SPACE_FORM && count == r->n) FN(chs_se3_compose)(T, r->home, T);
}

/* What the reference by exp is off itself: the rounding of S q, of exp and of the products. */
static const double by_exp_rotation = CHS_EPS_CHAIN_FK_ROTATION + 8,
                    by_exp_translation = CHS_EPS_CHAIN_FK_TRANSLATION + 16;

static void test_fk_is_the_product_of_exponentials_in_both_forms(void) {
  for (int k = 0; k < CASES; k++) {
    robot r;
    real expected[16], T[16];
    random_robot(integer(1, MOST), log_uniform(0.01, 100), &r);
    for (int form = 0; form < 2; form++) {
      const chain c = chain_of(&r, (chs_chain_form)form);
      product_of_exponentials(&r, c.form, r.n, expected);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, T));
      assert_pose(expected, T, by_exp_rotation * r.n, by_exp_translation * r.n, reach_of(&r));
    }
  }
}

static void test_fk_at_zero_is_the_home_pose(void) {
  for (int k = 0; k < CASES; k++) {
    robot r;
    real T[16];
    random_robot(integer(1, MOST), 2, &r);
    memset(r.q, 0, sizeof r.q);
    for (int form = 0; form < 2; form++) {
      const chain c = chain_of(&r, (chs_chain_form)form);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, T));
      ASSERT_ENTRIES_WITHIN_EPS(r.home, T, 16, 0, 1);
    }
  }
}

static void test_the_body_form_is_the_space_form_seen_from_the_tool(void) {
  for (int k = 0; k < CASES; k++) {
    robot r, b;
    real T[16], T_body[16];
    random_robot(integer(1, MOST), 2, &r);
    b = r;
    for (int i = 0; i < r.n; i++) FN(chs_se3_adjoint_inverse_twist)(r.home, r.screws + 6 * i, b.screws + 6 * i);
    const chain space = chain_of(&r, CHS_SPACE_FORM), body = chain_of(&b, CHS_BODY_FORM);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&space, r.q, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&body, r.q, T_body));
    /* The home pose is a rotation to an eps, and so are the axes that it turned. */
    assert_pose(T, T_body, (2 * CHS_EPS_CHAIN_FK_ROTATION + 8) * r.n, (2 * CHS_EPS_CHAIN_FK_TRANSLATION + 16) * r.n,
                2 * reach_of(&r));
  }
}

static void test_whole_turns_change_nothing(void) {
  const real S[12] = {0, 0, 1, 1, -2, 0, K(0.6), 0, K(-0.8), K(0.8), 5, K(0.6)};
  robot r = {2, {0}, {0}, {K(0.5), K(-1.25)}};
  real T[16], turned[16];
  memcpy(r.screws, S, sizeof S);
  memcpy(r.home, identity4, sizeof r.home);
  const chain c = chain_of(&r, CHS_SPACE_FORM);
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, T));
  for (int i = 0; i < 2; i++) {
    robot far = r;
    far.q[i] = rounded((double)r.q[i] + 2 * PI);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, far.q, turned));
    assert_pose(T, turned, 2 * CHS_EPS_CHAIN_FK_ROTATION * r.n + 8, 2 * CHS_EPS_CHAIN_FK_TRANSLATION * r.n + 8,
                reach_of(&far));
  }
}

static void test_an_odd_omega_is_a_gear_ratio(void) {
  const real S[6] = {0, 0, K(0.5), 1, 0, 0}, unit_S[6] = {0, 0, 1, 2, 0, 0}, q[1] = {3}, half[1] = {K(1.5)};
  robot r = {1, {0}, {0}, {0}}, u = r;
  real T[16], expected[16];
  memcpy(r.screws, S, sizeof S);
  memcpy(u.screws, unit_S, sizeof S);
  memcpy(r.home, identity4, sizeof r.home);
  memcpy(u.home, identity4, sizeof r.home);
  const chain geared = chain_of(&r, CHS_SPACE_FORM), plain = chain_of(&u, CHS_SPACE_FORM);
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&geared, q, T));
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&plain, half, expected));
  assert_pose(expected, T, 8, 8, 4);
}

static void test_links_are_the_partial_products(void) {
  for (int k = 0; k < CASES; k++) {
    robot r;
    real D[16 * MOST], T[16], expected[16], back[16];
    random_robot(integer(1, MOST), 2, &r);
    double reach = 2 * reach_of(&r);
    for (int form = 0; form < 2; form++) {
      const chain c = chain_of(&r, (chs_chain_form)form);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_links)(&c, r.q, D));
      for (int i = 0; i < r.n; i++) {
        robot part = r;
        part.n = i + 1;
        if (form == CHS_SPACE_FORM) memcpy(part.home, identity4, sizeof part.home);
        product_of_exponentials(&part, c.form, i + 1, expected);
        FN(chs_se3_inverse)(r.home, back);
        if (form == CHS_BODY_FORM) FN(chs_se3_compose)(expected, back, expected);
        assert_pose(expected, D + 16 * i, (by_exp_rotation + 4) * r.n, (by_exp_translation + 4) * r.n, reach);
      }
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, T));
      FN(chs_se3_compose)(D + 16 * (r.n - 1), r.home, expected);
      assert_pose(expected, T, (2 * CHS_EPS_CHAIN_FK_ROTATION + 2) * r.n, (2 * CHS_EPS_CHAIN_FK_TRANSLATION + 4) * r.n,
                  reach);
    }
  }
}

static void column_at(const real *J, int n, int i, real column[6]) {
  for (int row = 0; row < 6; row++) column[row] = J[n * row + i];
}

static void test_columns_are_the_screws_carried_by_the_joints_before(void) {
  for (int k = 0; k < CASES; k++) {
    robot r;
    real J[6 * MOST], T[16], fk[16], before[16], expected[6], column[6];
    random_robot(integer(1, MOST), 2, &r);
    double reach = reach_of(&r);
    for (int form = 0; form < 2; form++) {
      const chain c = chain_of(&r, (chs_chain_form)form);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_space_jacobian)(&c, r.q, J, T));
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, fk));
      ASSERT_SAME_BITS(fk, T, 16);
      for (int i = 0; i < r.n; i++) {
        robot part = r;
        part.n = i;
        if (form == CHS_SPACE_FORM) memcpy(part.home, identity4, sizeof part.home);
        product_of_exponentials(&part, c.form, i, before);
        FN(chs_se3_adjoint_twist)(before, r.screws + 6 * i, expected);
        column_at(J, r.n, i, column);
        ASSERT_ENTRIES_WITHIN_EPS(expected, column, 3, by_exp_rotation * r.n, 1);
        ASSERT_ENTRIES_WITHIN_EPS(expected + 3, column + 3, 3, (by_exp_translation + 4) * r.n, reach);
      }
    }
  }
}

static void test_the_body_jacobian_is_the_space_jacobian_seen_from_the_tool(void) {
  for (int k = 0; k < CASES; k++) {
    robot r;
    real J[6 * MOST], B[6 * MOST], T[16], T_body[16], expected[6], column[6];
    random_robot(integer(1, MOST), 2, &r);
    const chain c = chain_of(&r, (chs_chain_form)(k % 2));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_space_jacobian)(&c, r.q, J, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_body_jacobian)(&c, r.q, B, T_body));
    ASSERT_SAME_BITS(T, T_body, 16);
    for (int i = 0; i < r.n; i++) {
      column_at(J, r.n, i, column);
      FN(chs_se3_adjoint_inverse_twist)(T, column, expected);
      column_at(B, r.n, i, column);
      ASSERT_ENTRIES_WITHIN_EPS(expected, column, 3, 4, 1);
      ASSERT_ENTRIES_WITHIN_EPS(expected + 3, column + 3, 3, 8 * r.n, reach_of(&r));
    }
  }
}

/* A joint moved by a little moves the tool by a little along its column. */
static void test_the_space_jacobian_is_the_derivative_of_fk(void) {
  const double step = PICK(1e-6, 1e-2), most = PICK(1e-8, 1e-3);
  for (int k = 0; k < CASES; k++) {
    robot r;
    real J[6 * MOST], T[16], less[16], more[16], V[6];
    random_robot(integer(1, MOST), 0.5, &r);
    const chain c = chain_of(&r, (chs_chain_form)(k % 2));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_space_jacobian)(&c, r.q, J, T));
    for (int i = 0; i < r.n; i++) {
      robot low = r, high = r;
      low.q[i] = rounded((double)r.q[i] - step);
      high.q[i] = rounded((double)r.q[i] + step);
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, low.q, less));
      ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, high.q, more));
      FN(chs_se3_inverse)(less, less);
      FN(chs_se3_compose)(more, less, more);
      ASSERT_STATUS(CHS_OK, FN(chs_se3_log)(more, V));
      double both = (double)high.q[i] - (double)low.q[i];
      for (int row = 0; row < 6; row++)
        TEST_ASSERT_DOUBLE_WITHIN(most, (double)J[r.n * row + i], (double)V[row] / both);
    }
  }
}

/* Lynch & Park, Modern Robotics (2017), example 4.5: the UR5 at (0, -pi/2, 0, 0, pi/2, 0). */
static void test_modern_robotics_example_4_5(void) {
  const real S[36] = {0, 0, 1,  0,         0,        0,        0, 1, 0, K(-0.089), 0, 0,
                      0, 1, 0,  K(-0.089), 0,        K(0.425), 0, 1, 0, K(-0.089), 0, K(0.817),
                      0, 0, -1, K(-0.109), K(0.817), 0,        0, 1, 0, K(0.006),  0, K(0.817)};
  const real q[6] = {0, -REAL_PI / 2, 0, 0, REAL_PI / 2, 0};
  const double expected[12] = {0, -1, 0, 0.095, 1, 0, 0, 0.109, 0, 0, 1, 0.988};
  chain c = {6, CHS_SPACE_FORM, S, {-1, 0, 0, K(0.817), 0, 0, 1, K(0.191), 0, 1, 0, K(-0.006), 0, 0, 0, 1}, NULL};
  real T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  for (int i = 0; i < 12; i++) TEST_ASSERT_DOUBLE_WITHIN(16 * EPS, expected[i], (double)T[i]);
}

/* The examples in the comments of the book's own software: FKinSpace and FKinBody, JacobianSpace and JacobianBody. */
static void test_modern_robotics_forward_kinematics(void) {
  const real S[18] = {0, 0, 1, 4, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1, -6, 0, K(-0.1)};
  const real B[18] = {0, 0, -1, 2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, K(0.1)};
  const real q[3] = {REAL_PI / 2, 3, REAL_PI};
  const double expected[12] = {0, 1, 0, -5, 1, 0, 0, 4, 0, 0, -1, 1.68584073};
  chain c = {3, CHS_SPACE_FORM, S, {-1, 0, 0, 0, 0, 1, 0, 6, 0, 0, -1, 2, 0, 0, 0, 1}, NULL};
  real T[16];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  for (int i = 0; i < 12; i++) TEST_ASSERT_DOUBLE_WITHIN(5e-9 + 32 * EPS, expected[i], (double)T[i]);
  c.form = CHS_BODY_FORM;
  c.screws = B;
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  for (int i = 0; i < 12; i++) TEST_ASSERT_DOUBLE_WITHIN(5e-9 + 32 * EPS, expected[i], (double)T[i]);
}

static void test_modern_robotics_jacobians(void) {
  const real S[24] = {0, 0, 1, 0, K(0.2), K(0.2), 1, 0, 0, 2, 0, 3, 0, 1, 0, 0, 2, 1, 1, 0, 0, K(0.2), K(0.3), K(0.4)};
  const real q[4] = {K(0.2), K(1.1), K(0.1), K(1.2)};
  const double space[24] = {0,   0.98006658, -0.09011564, 0.95749426,  0,   0.19866933, 0.4445544,   0.28487557,
                            1,   0,          0.89120736,  -0.04528405, 0,   1.95218638, -2.21635216, -0.51161537,
                            0.2, 0.43654132, -2.43712573, 2.77535713,  0.2, 2.96026613, 3.23573065,  2.22512443};
  const double body[24] = {-0.04528405, 0.99500417, 0,           1,   0.74359313,  0.09304865, 0.36235775,  0,
                           -0.66709716, 0.03617541, -0.93203909, 0,   2.32586047,  1.66809,    0.56410831,  0.2,
                           -1.44321167, 2.94561275, 1.43306521,  0.3, -2.06639565, 1.82881722, -1.58868628, 0.4};
  chain c = {4, CHS_SPACE_FORM, S, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, NULL};
  real J[24];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_space_jacobian)(&c, q, J, NULL));
  for (int i = 0; i < 24; i++) TEST_ASSERT_DOUBLE_WITHIN(5e-9 + 32 * EPS, space[i], (double)J[i]);
  c.form = CHS_BODY_FORM;
  ASSERT_STATUS(CHS_OK, FN(chs_chain_body_jacobian)(&c, q, J, NULL));
  for (int i = 0; i < 24; i++) TEST_ASSERT_DOUBLE_WITHIN(5e-9 + 32 * EPS, body[i], (double)J[i]);
}

/* What all functions of a chain and its joint values promise alike. */

typedef int chain_function(const chain *c, const real *q, real *out);

static int space_jacobian(const chain *c, const real *q, real *J) {
  return FN(chs_chain_space_jacobian)(c, q, J, NULL);
}
static int body_jacobian(const chain *c, const real *q, real *J) { return FN(chs_chain_body_jacobian)(c, q, J, NULL); }
static int space_jacobian_pose(const chain *c, const real *q, real *T) {
  real J[6 * MOST];
  int status = FN(chs_chain_space_jacobian)(c, q, J, T);
  return status;
}

static const struct {
  const char *name;
  chain_function *call;
  int outputs, outputs_per_joint;
} walks[] = {{"chain_fk", FN(chs_chain_fk), 16, 0},
             {"chain_links", FN(chs_chain_links), 0, 16},
             {"chain_space_jacobian", space_jacobian, 0, 6},
             {"chain_body_jacobian", body_jacobian, 0, 6},
             {"the pose of chain_space_jacobian", space_jacobian_pose, 16, 0}};

enum { MOST_OUTPUTS = 16 * MOST };

static void test_outputs_may_overlap_the_joint_values(void) {
  for (int f = 0; f < LENGTH(walks); f++)
    for (int n = 1; n <= MOST; n++) {
      robot r;
      real expected[MOST_OUTPUTS], arena[MOST_OUTPUTS + 2 * MOST];
      int outputs = walks[f].outputs + n * walks[f].outputs_per_joint;
      subject = walks[f].name;
      random_robot(n, 2, &r);
      const chain c = chain_of(&r, (chs_chain_form)(n % 2));
      ASSERT_STATUS(CHS_OK, walks[f].call(&c, r.q, expected));
      for (int place = 0; place <= outputs + MOST; place++) {
        memcpy(arena + place, r.q, (size_t)n * sizeof(real));
        ASSERT_STATUS(CHS_OK, walks[f].call(&c, arena + place, arena + MOST));
        ASSERT_SAME_BITS(expected, arena + MOST, outputs);
      }
    }
}

static void assert_walks_refuse(int status, const chain *c, const real *q) {
  real out[MOST_OUTPUTS];
  for (int f = 0; f < LENGTH(walks); f++) {
    subject = walks[f].name;
    ASSERT_REFUSES(status, out, walks[f].call(c, q, out));
  }
}

static void assert_bad_number_is_refused(const robot *r, chs_chain_form form, real *place) {
  real good = *place;
  chain c;
  *place = (real)NAN;
  c = chain_of(r, form);
  assert_walks_refuse(CHS_ERR_NAN, &c, r->q);
  *place = -(real)INFINITY;
  c = chain_of(r, form);
  assert_walks_refuse(CHS_ERR_INFINITE, &c, r->q);
  *place = good;
}

static void test_bad_numbers_are_refused(void) {
  for (int k = 0; k < 12; k++) {
    robot r;
    random_robot(4, 2, &r);
    chs_chain_form form = (chs_chain_form)(k % 2);
    for (int i = 0; i < 24; i++) assert_bad_number_is_refused(&r, form, r.screws + i);
    for (int i = 0; i < 12; i++) assert_bad_number_is_refused(&r, form, r.home + i);
    for (int i = 0; i < 4; i++) assert_bad_number_is_refused(&r, form, r.q + i);
    r.q[1] = (real)INFINITY;
    r.screws[20] = (real)NAN;
    const chain c = chain_of(&r, form);
    assert_walks_refuse(CHS_ERR_NAN, &c, r.q);
  }
}

static void test_the_last_row_of_the_home_pose_is_not_read(void) {
  robot r;
  real T[16], expected[16];
  random_robot(3, 2, &r);
  chain c = chain_of(&r, CHS_SPACE_FORM);
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, expected));
  for (int i = 12; i < 16; i++) c.home[i] = (real)NAN;
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, r.q, T));
  ASSERT_SAME_BITS(expected, T, 16);
}

static void test_a_chain_without_joints_is_refused(void) {
  robot r;
  random_robot(1, 2, &r);
  for (r.n = -1; r.n <= 0; r.n++) {
    const chain c = chain_of(&r, CHS_SPACE_FORM);
    assert_walks_refuse(CHS_ERR_ARGUMENT, &c, r.q);
  }
}

static void test_a_form_that_is_none_is_refused(void) {
  const int none[] = {2, 7, 100};
  robot r;
  random_robot(1, 2, &r);
  for (int k = 0; k < LENGTH(none); k++) {
    const chain c = chain_of(&r, (chs_chain_form)none[k]);
    assert_walks_refuse(CHS_ERR_ARGUMENT, &c, r.q);
  }
}

static void test_angles_beyond_the_range_are_refused_and_lengths_are_not(void) {
  const real S[3][6] = {{0, 0, 1, 0, 0, 0}, {K(0.6), 0, K(0.8), 0, 0, 0}, {0, 2, 0, 0, 0, 0}};
  real q[1] = {NEXT_AFTER(ANGLE_MAX, REAL_MAX)}, T[16];
  chain c = {1, CHS_SPACE_FORM, NULL, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, NULL};
  for (int i = 0; i < 3; i++) {
    c.screws = S[i];
    assert_walks_refuse(CHS_ERR_ANGLE_RANGE, &c, q);
    q[0] = -q[0];
  }
  q[0] = ANGLE_MAX;
  c.screws = S[0];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  const real slide[6] = {0, 0, 0, 0, 0, 1};
  c.screws = slide;
  q[0] = REAL_MAX;
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  ASSERT_SAME_BITS(q, T + 11, 1);
}

static void test_lengths_beyond_the_range_are_an_overflow(void) {
  const real S[12] = {0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1}, q[2] = {REAL_MAX, REAL_MAX};
  const chain c = {2, CHS_SPACE_FORM, S, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, NULL};
  assert_walks_refuse(CHS_ERR_OVERFLOW, &c, q);
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_fk_is_the_product_of_exponentials_in_both_forms);
  RUN_TEST(test_fk_at_zero_is_the_home_pose);
  RUN_TEST(test_the_body_form_is_the_space_form_seen_from_the_tool);
  RUN_TEST(test_whole_turns_change_nothing);
  RUN_TEST(test_an_odd_omega_is_a_gear_ratio);
  RUN_TEST(test_links_are_the_partial_products);
  RUN_TEST(test_columns_are_the_screws_carried_by_the_joints_before);
  RUN_TEST(test_the_body_jacobian_is_the_space_jacobian_seen_from_the_tool);
  RUN_TEST(test_the_space_jacobian_is_the_derivative_of_fk);
  RUN_TEST(test_modern_robotics_example_4_5);
  RUN_TEST(test_modern_robotics_forward_kinematics);
  RUN_TEST(test_modern_robotics_jacobians);
  RUN_TEST(test_outputs_may_overlap_the_joint_values);
  RUN_TEST(test_bad_numbers_are_refused);
  RUN_TEST(test_the_last_row_of_the_home_pose_is_not_read);
  RUN_TEST(test_a_chain_without_joints_is_refused);
  RUN_TEST(test_a_form_that_is_none_is_refused);
  RUN_TEST(test_angles_beyond_the_range_are_refused_and_lengths_are_not);
  RUN_TEST(test_lengths_beyond_the_range_are_an_overflow);
  return SUITE_END();
}
