#include "support/suite.h"

#ifdef CHS_TEST_SINGLE
typedef chs_chainf chain;
typedef chs_ikf ik;
#else
typedef chs_chain chain;
typedef chs_ik ik;
#endif

enum { MOST = 8, CASES = 300 };

static real scratch[CHS_CHAIN_IK_SCRATCH(MOST)];

static const real tolerance = PICK(1e-10, 2e-5F);

/* The UR5 of Lynch & Park, Modern Robotics (2017), example 4.5. */
static const real ur5_screws[36] = {0, 0, 1,  0,         0,        0,        0, 1, 0, K(-0.089), 0, 0,
                                    0, 1, 0,  K(-0.089), 0,        K(0.425), 0, 1, 0, K(-0.089), 0, K(0.817),
                                    0, 0, -1, K(-0.109), K(0.817), 0,        0, 1, 0, K(0.006),  0, K(0.817)};

static chain ur5(void) {
  chain c = {
      6, CHS_SPACE_FORM, ur5_screws, {-1, 0, 0, K(0.817), 0, 0, 1, K(0.191), 0, 1, 0, K(-0.006), 0, 0, 0, 1}, NULL};
  return c;
}

/* The UR5 with a joint for its base to turn about x, through a point aside: one joint more than is needed. */
static const real seven_screws[42] = {1, 0, 0, 0,         0, K(-0.3),  0, 0, 1,  0,         0,        0,
                                      0, 1, 0, K(-0.089), 0, 0,        0, 1, 0,  K(-0.089), 0,        K(0.425),
                                      0, 1, 0, K(-0.089), 0, K(0.817), 0, 0, -1, K(-0.109), K(0.817), 0,
                                      0, 1, 0, K(0.006),  0, K(0.817)};

static chain seven_joints(void) {
  chain c = ur5();
  c.joints = 7;
  c.screws = seven_screws;
  return c;
}

/* Three slides and a wrist; one joint is a nut on a screw. */
static const real gantry_screws[36] = {0, 0, 0, 1, 0, 0,      0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1,
                                       0, 0, 1, 0, 0, K(0.1), 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0};

static chain gantry(void) {
  chain c = {6, CHS_SPACE_FORM, gantry_screws, {1, 0, 0, K(0.1), 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, NULL};
  return c;
}

static ik options_of(chs_ik_method method, int steps, int restarts) {
  ik o = {method, tolerance, tolerance, K(0.1), steps, restarts};
  return o;
}

static void random_values(int n, double size, real *q) {
  for (int i = 0; i < n; i++) q[i] = (real)uniform(-size, size);
}

/* The residual by other functions of the library. */
static void residual_of(const chain *c, const real T[16], const real *q, double residual[2]) {
  real reached[16], R[9], p[3], goal_R[9], goal_p[3], angle, way[3];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(c, q, reached));
  FN(chs_se3_to_parts)(reached, R, p);
  FN(chs_se3_to_parts)(T, goal_R, goal_p);
  ASSERT_STATUS(CHS_OK, FN(chs_so3_angle)(R, goal_R, &angle));
  for (int i = 0; i < 3; i++) way[i] = goal_p[i] - p[i];
  residual[0] = (double)angle;
  residual[1] = length_of(way, 3);
}

static void assert_solved(const chain *c, const real T[16], const real *q) {
  double residual[2];
  residual_of(c, T, q, residual);
  for (int i = 0; i < 2; i++) TEST_ASSERT_TRUE(residual[i] <= (double)tolerance + 16 * EPS);
  for (int i = 0; c->limits && i < c->joints; i++)
    TEST_ASSERT_TRUE(q[i] >= c->limits[2 * i] && q[i] <= c->limits[2 * i + 1]);
}

static void solve_many(const chain *c, chs_ik_method method, double from, double near, int restarts) {
  const ik o = options_of(method, 100, restarts);
  for (int k = 0; k < CASES; k++) {
    real q[MOST], start[MOST], found[MOST], T[16];
    random_values(c->joints, from, q);
    for (int i = 0; i < c->joints; i++) start[i] = rounded((double)q[i] + uniform(-near, near));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(c, q, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(c, T, start, &o, scratch, found, NULL));
    assert_solved(c, T, found);
  }
}

static void test_six_joints_find_what_is_near(void) {
  const chain c = ur5();
  solve_many(&c, CHS_IK_NEWTON, PI, 0.2, 8);
  solve_many(&c, CHS_IK_DAMPED, PI, 0.2, 8);
}

static void test_six_joints_find_what_is_far(void) {
  const chain c = ur5();
  solve_many(&c, CHS_IK_NEWTON, PI, PI, 60);
}

static void test_seven_joints_find_what_is_near(void) {
  const chain c = seven_joints();
  solve_many(&c, CHS_IK_NEWTON, PI, 0.2, 8);
  solve_many(&c, CHS_IK_DAMPED, PI, 0.2, 8);
}

static void test_slides_and_nuts_find_what_is_near(void) {
  const chain c = gantry();
  solve_many(&c, CHS_IK_NEWTON, 1, 0.2, 8);
  solve_many(&c, CHS_IK_DAMPED, 1, 0.2, 8);
}

static void test_fewer_than_six_joints_find_what_they_can_reach(void) {
  chain c = ur5();
  for (c.joints = 1; c.joints < 6; c.joints++) {
    solve_many(&c, CHS_IK_NEWTON, 1, 0.2, 8);
    solve_many(&c, CHS_IK_DAMPED, 1, 0.2, 8);
  }
}

static void test_the_body_form_finds_the_same(void) {
  const ik o = options_of(CHS_IK_NEWTON, 30, 0);
  real body_screws[36];
  const chain c = ur5();
  chain b = c;
  for (int i = 0; i < 6; i++) FN(chs_se3_adjoint_inverse_twist)(c.home, c.screws + 6 * i, body_screws + 6 * i);
  b.form = CHS_BODY_FORM;
  b.screws = body_screws;
  const real q[6] = {K(0.3), -1, K(1.2), K(-0.7), K(0.9), K(0.2)}, start[6] = {K(0.4), K(-0.9), K(1.1), K(-0.6), 1, 0};
  real T[16], found[6];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(&b, T, start, &o, scratch, found, NULL));
  for (int i = 0; i < 6; i++) TEST_ASSERT_DOUBLE_WITHIN(100 * (double)tolerance, (double)q[i], (double)found[i]);
}

/* The examples in the comments of the book's own software, IKinSpace and IKinBody: the digits printed there are those
 * of its tolerances, the exact solution is (pi/2, 3, pi). */
static void test_modern_robotics_inverse_kinematics(void) {
  const real S[18] = {0, 0, 1, 4, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, -1, -6, 0, K(-0.1)};
  const real B[18] = {0, 0, -1, 2, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, K(0.1)};
  const real T[16] = {0, 1, 0, -5, 1, 0, 0, 4, 0, 0, -1, K(1.6858), 0, 0, 0, 1}, start[3] = {K(1.5), K(2.5), 3};
  const double printed[3] = {1.57073783, 2.99966384, 3.1415342}, exact[3] = {PI / 2, 3, PI};
  const ik o = {CHS_IK_NEWTON, K(0.01), K(0.001), 1, 20, 0};
  chain c = {3, CHS_SPACE_FORM, S, {-1, 0, 0, 0, 0, 1, 0, 6, 0, 0, -1, 2, 0, 0, 0, 1}, NULL};
  real q[3];
  for (int form = 0; form < 2; form++) {
    c.form = (chs_chain_form)form;
    c.screws = form == 0 ? S : B;
    ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(&c, T, start, &o, scratch, q, NULL));
    for (int i = 0; i < 3; i++) {
      TEST_ASSERT_DOUBLE_WITHIN(0.0015, printed[i], (double)q[i]);
      TEST_ASSERT_DOUBLE_WITHIN(0.0015, exact[i], (double)q[i]);
    }
  }
}

/* Where an arccos of the trace would see no rotation left, below 2e-8 rad (2e-4 in float). */
static void test_a_small_rotation_is_no_convergence(void) {
  const double off = PICK(1e-9, 1e-4);
  const ik o = options_of(CHS_IK_NEWTON, 0, 0);
  const chain c = ur5();
  const real q[6] = {K(0.3), -1, K(1.2), K(-0.7), K(0.9), K(0.2)};
  real T[16], found[6], residual[2];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  for (int i = 0; i < 6; i++) {
    real start[6];
    memcpy(start, q, sizeof start);
    start[i] = rounded((double)q[i] + off);
    ASSERT_STATUS(CHS_ITERATION_LIMIT, FN(chs_chain_ik)(&c, T, start, &o, scratch, found, residual));
    TEST_ASSERT_DOUBLE_WITHIN(16 * EPS, fabs((double)start[i] - (double)q[i]), (double)residual[0]);
    ASSERT_SAME_BITS(start, found, 6);
  }
}

static void test_the_residual_is_what_is_left(void) {
  const chain c = ur5();
  for (int k = 0; k < CASES; k++) {
    const ik o = options_of(CHS_IK_NEWTON, integer(0, 3), 0);
    real q[6], start[6], found[6], T[16], residual[2];
    double expected[2];
    random_values(6, PI, q);
    random_values(6, PI, start);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
    TEST_ASSERT_TRUE(FN(chs_chain_ik)(&c, T, start, &o, scratch, found, residual) >= 0);
    residual_of(&c, T, found, expected);
    for (int i = 0; i < 2; i++) TEST_ASSERT_DOUBLE_WITHIN(64 * EPS, expected[i], (double)residual[i]);
  }
}

/* The square of the error, to the last bit: lengths count as radians, as both tolerances are the same here. Products
 * that are stored cannot be fused with the sum. */
static real error_of(const real residual[2]) {
  volatile const real a = residual[0] * residual[0], b = residual[1] * residual[1];
  return a + b;
}

static void test_no_step_does_harm_and_steps_make_a_search(void) {
  const chain robots[3] = {ur5(), seven_joints(), gantry()};
  for (int k = 0; k < CASES; k++) {
    const chain *c = robots + k % 3;
    const ik one = options_of((chs_ik_method)(k / 3 % 2), 0, 0);
    ik all = one;
    all.steps = 20;
    real q[MOST], step_q[MOST], found[MOST], T[16], residual[2];
    random_values(c->joints, PI, q);
    random_values(c->joints, PI, step_q);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(c, q, T));
    int status = FN(chs_chain_ik)(c, T, step_q, &all, scratch, found, NULL);
    real before = (real)INFINITY;
    int last = CHS_ITERATION_LIMIT;
    for (int i = 0; i < all.steps && last == CHS_ITERATION_LIMIT; i++) {
      last = FN(chs_chain_ik_step)(c, T, step_q, &one, scratch, step_q, residual);
      TEST_ASSERT_TRUE(error_of(residual) <= before);
      before = error_of(residual);
    }
    ASSERT_STATUS(status, last);
    ASSERT_SAME_BITS(found, step_q, c->joints);
  }
}

static void test_joints_stay_within_their_limits(void) {
  const real limits[12] = {-1, 1, -1, 1, -1, 1, -1, 1, -1, 1, -1, 1};
  const ik o = options_of(CHS_IK_NEWTON, 40, 3);
  chain c = ur5();
  c.limits = limits;
  int solved = 0, held = 0;
  for (int k = 0; k < CASES; k++) {
    real q[6], start[6], found[6], T[16];
    random_values(6, k % 2 ? 1 : 2, q);
    random_values(6, 2, start);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
    int status = FN(chs_chain_ik)(&c, T, start, &o, scratch, found, NULL);
    for (int i = 0; i < 6; i++) TEST_ASSERT_TRUE(found[i] >= -1 && found[i] <= 1);
    if (status == CHS_OK) assert_solved(&c, T, found);
    solved += status == CHS_OK;
    held += status == CHS_AT_JOINT_LIMIT;
  }
  TEST_ASSERT_TRUE(solved > CASES / 3);
  TEST_ASSERT_TRUE(held > CASES / 10);
}

static void test_a_joint_that_cannot_go_on_is_at_its_limit(void) {
  const real S[6] = {0, 0, 1, 0, 0, 0}, limits[2] = {K(-0.5), K(0.5)}, start[1] = {0}, wanted[1] = {1};
  const ik o = options_of(CHS_IK_NEWTON, 20, 0);
  chain c = {1, CHS_SPACE_FORM, S, {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, limits};
  real T[16], q[1], residual[2];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, wanted, T));
  ASSERT_STATUS(CHS_AT_JOINT_LIMIT, FN(chs_chain_ik)(&c, T, start, &o, scratch, q, residual));
  ASSERT_SAME_BITS(limits + 1, q, 1);
  TEST_ASSERT_DOUBLE_WITHIN(8 * EPS, 0.5, (double)residual[0]);
}

static void test_a_joint_that_has_room_winds_back(void) {
  const real S[6] = {0, 0, 1, 0, 0, 0}, limits[2] = {-REAL_PI - K(0.01), REAL_PI + K(0.01)};
  const ik o = options_of(CHS_IK_NEWTON, 20, 0);
  chain c = {1, CHS_SPACE_FORM, S, {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, limits};
  for (int sign = -1; sign <= 1; sign += 2) {
    const real start[1] = {(real)(3 * sign)}, wanted[1] = {K(-2.5) * (real)sign};
    real T[16], q[1];
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, wanted, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(&c, T, start, &o, scratch, q, NULL));
    TEST_ASSERT_DOUBLE_WITHIN(2 * (double)tolerance, (double)wanted[0], (double)q[0]);
  }
}

/* Two links of length 1 in the plane. */
static const real planar_screws[12] = {0, 0, 1, 0, 0, 0, 0, 0, 1, 0, -1, 0};

static void test_beyond_its_reach_an_arm_is_outstretched(void) {
  const chain c = {2, CHS_SPACE_FORM, planar_screws, {1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, NULL};
  const real T[16] = {1, 0, 0, 3, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, start[2] = {K(0.4), K(-0.3)};
  for (int method = 0; method < 2; method++) {
    const ik o = options_of((chs_ik_method)method, 200, 0);
    real q[2], residual[2];
    ASSERT_STATUS(CHS_NEAR_SINGULAR, FN(chs_chain_ik)(&c, T, start, &o, scratch, q, residual));
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, 1, (double)residual[1]);
    TEST_ASSERT_DOUBLE_WITHIN(2e-2, 0, (double)q[0]);
    TEST_ASSERT_DOUBLE_WITHIN(2e-2, 0, (double)q[1]);
  }
}

/* All joints at zero, the wrist and the elbow of the UR5 are singular. */
static void test_a_search_may_start_in_a_singular_place(void) {
  const ik o = options_of(CHS_IK_NEWTON, 100, 8);
  const chain c = ur5();
  for (int k = 0; k < CASES; k++) {
    const real start[6] = {0, 0, 0, 0, 0, 0};
    real q[6], found[6], T[16];
    random_values(6, 1, q);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(&c, T, start, &o, scratch, found, NULL));
    assert_solved(&c, T, found);
  }
}

static void test_a_solution_is_left_as_it_is(void) {
  const ik o = options_of(CHS_IK_NEWTON, 10, 2);
  const chain c = ur5();
  for (int k = 0; k < CASES; k++) {
    real q[6], found[6], T[16];
    random_values(6, PI, q);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
    ASSERT_STATUS(CHS_OK, FN(chs_chain_ik)(&c, T, q, &o, scratch, found, NULL));
    ASSERT_SAME_BITS(q, found, 6);
  }
}

static void test_millimetres_find_what_metres_find(void) {
  const chain c = ur5();
  chain mm = c;
  real screws[36];
  memcpy(screws, c.screws, sizeof screws);
  for (int i = 0; i < 36; i++) screws[i] *= i % 6 < 3 ? 1 : 1024;
  for (int i = 3; i < 12; i += 4) mm.home[i] *= 1024;
  mm.screws = screws;
  const ik o = options_of(CHS_IK_NEWTON, 50, 2);
  ik o_mm = o;
  o_mm.length *= 1024;
  for (int k = 0; k < CASES; k++) {
    real q[6], start[6], found[6], found_mm[6], T[16];
    random_values(6, PI, q);
    random_values(6, PI, start);
    ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
    int status = FN(chs_chain_ik)(&c, T, start, &o, scratch, found, NULL);
    for (int i = 3; i < 12; i += 4) T[i] *= 1024;
    ASSERT_STATUS(status, FN(chs_chain_ik)(&mm, T, start, &o_mm, scratch, found_mm, NULL));
    ASSERT_SAME_BITS(found, found_mm, 6);
  }
}

static void test_the_joint_values_may_overlap_the_start(void) {
  const ik o = options_of(CHS_IK_NEWTON, 30, 1);
  const chain c = ur5();
  real q[6], start[6], expected[6], arena[18], T[16];
  random_values(6, PI, q);
  random_values(6, PI, start);
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, q, T));
  int status = FN(chs_chain_ik)(&c, T, start, &o, scratch, expected, NULL);
  for (int place = 0; place <= 12; place++) {
    memcpy(arena + 6, start, sizeof start);
    ASSERT_STATUS(status, FN(chs_chain_ik)(&c, T, arena + 6, &o, scratch, arena + place, NULL));
    ASSERT_SAME_BITS(expected, arena + place, 6);
  }
}

static void assert_ik_refuses(int status, const chain *c, const real *T, const real *start, const ik *o) {
  struct {
    real q[6], residual[2];
  } out;
  ASSERT_REFUSES(status, out, FN(chs_chain_ik)(c, T, start, o, scratch, out.q, out.residual));
  ASSERT_REFUSES(status, out, FN(chs_chain_ik_step)(c, T, start, o, scratch, out.q, out.residual));
}

/* Nothing can be that near; the search still has to end where the tool is, as near as numbers go. */
static void test_a_length_beyond_all_digits_spoils_nothing(void) {
  const chain c = ur5();
  ik o = options_of(CHS_IK_NEWTON, 100, 0);
  o.length = PICK(1e-300, 1e-37F);
  const real goal[6] = {K(0.3), -1, K(1.2), K(0.4), K(-0.9), K(0.2)};
  real start[6], T[16], q[6], residual[2];
  ASSERT_STATUS(CHS_OK, FN(chs_chain_fk)(&c, goal, T));
  for (int i = 0; i < 6; i++) start[i] = goal[i] + K(0.125);
  int status = FN(chs_chain_ik)(&c, T, start, &o, scratch, q, residual);
  TEST_ASSERT_TRUE(status == CHS_OK || status == CHS_ITERATION_LIMIT);
  TEST_ASSERT_TRUE(residual[0] <= tolerance && residual[1] <= tolerance);
}

static void test_bad_options_are_refused(void) {
  const ik good = options_of(CHS_IK_DAMPED, 5, 1);
  const real start[6] = {0, 0, 0, 0, 0, 0}, crossed[12] = {-1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, 1};
  chain c = ur5();
  ik o = good;
  o.steps = -1;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &o);
  o = good;
  o.restarts = -1;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &o);
  o = good;
  o.method = (chs_ik_method)2;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &o);
  c.form = (chs_chain_form)2;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &good);
  c.form = CHS_SPACE_FORM;
  real *const numbers[3] = {&o.angle, &o.length, &o.damping};
  for (int i = 0; i < 3; i++) {
    o = good;
    *numbers[i] = 0;
    assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &o);
    *numbers[i] = (real)NAN;
    assert_ik_refuses(CHS_ERR_NAN, &c, identity4, start, &o);
    *numbers[i] = (real)INFINITY;
    assert_ik_refuses(CHS_ERR_INFINITE, &c, identity4, start, &o);
  }
  c.limits = crossed;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &good);
  c.limits = NULL;
  c.joints = 0;
  assert_ik_refuses(CHS_ERR_ARGUMENT, &c, identity4, start, &good);
}

static void test_bad_numbers_are_refused(void) {
  const ik o = options_of(CHS_IK_NEWTON, 5, 1);
  for (int i = 0; i < 6 + 12 + 36 + 12 + 12; i++) {
    real start[6] = {0, 1, -1, 1, 1, 0}, T[16], screws[36], limits[12] = {-2, 2, -2, 2, -2, 2, -2, 2, -2, 2, -2, 2};
    chain c = ur5();
    memcpy(screws, c.screws, sizeof screws);
    memcpy(T, identity4, sizeof T);
    c.screws = screws;
    c.limits = limits;
    real *place = i < 6    ? start + i
                  : i < 18 ? T + i - 6
                  : i < 54 ? screws + i - 18
                  : i < 66 ? c.home + i - 54
                           : limits + i - 66;
    *place = (real)NAN;
    assert_ik_refuses(CHS_ERR_NAN, &c, T, start, &o);
    if (i >= 66) continue; /* a limit may be infinite */
    *place = (real)INFINITY;
    assert_ik_refuses(CHS_ERR_INFINITE, &c, T, start, &o);
  }
}

static void test_a_pose_must_be_a_pose(void) {
  const ik o = options_of(CHS_IK_NEWTON, 5, 1);
  const real start[6] = {0, 1, -1, 1, 1, 0};
  const chain c = ur5();
  for (int k = 0; k < LENGTH(bad_rotations); k++) {
    real T[16];
    memcpy(T, identity4, sizeof T);
    put_rotation('T', bad_rotations[k].R, T);
    subject = bad_rotations[k].name;
    assert_ik_refuses(bad_rotations[k].status, &c, T, start, &o);
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_six_joints_find_what_is_near);
  RUN_TEST(test_six_joints_find_what_is_far);
  RUN_TEST(test_seven_joints_find_what_is_near);
  RUN_TEST(test_slides_and_nuts_find_what_is_near);
  RUN_TEST(test_fewer_than_six_joints_find_what_they_can_reach);
  RUN_TEST(test_the_body_form_finds_the_same);
  RUN_TEST(test_modern_robotics_inverse_kinematics);
  RUN_TEST(test_a_small_rotation_is_no_convergence);
  RUN_TEST(test_the_residual_is_what_is_left);
  RUN_TEST(test_no_step_does_harm_and_steps_make_a_search);
  RUN_TEST(test_joints_stay_within_their_limits);
  RUN_TEST(test_a_joint_that_cannot_go_on_is_at_its_limit);
  RUN_TEST(test_a_joint_that_has_room_winds_back);
  RUN_TEST(test_beyond_its_reach_an_arm_is_outstretched);
  RUN_TEST(test_a_search_may_start_in_a_singular_place);
  RUN_TEST(test_a_solution_is_left_as_it_is);
  RUN_TEST(test_millimetres_find_what_metres_find);
  RUN_TEST(test_the_joint_values_may_overlap_the_start);
  RUN_TEST(test_a_length_beyond_all_digits_spoils_nothing);
  RUN_TEST(test_bad_options_are_refused);
  RUN_TEST(test_bad_numbers_are_refused);
  RUN_TEST(test_a_pose_must_be_a_pose);
  return SUITE_END();
}
