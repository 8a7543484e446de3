/* The robots of tools/robots, and inverse kinematics on each of them: poses that it has at random joint values within
 * its limits, from starts within 0.2 rad (or 0.2 of a metre) and from random ones. CHASLES_IK_TARGETS tells
 * how many of each. */
#include "../tools/chasles/robot.h"
#include "support/suite.h"

#ifndef CHASLES_ROBOTS
#error "CHASLES_ROBOTS is the directory of the robots"
#endif

static const double tolerance = 1e-10; /* radians, and metres */

static double scratch[CHS_CHAIN_IK_SCRATCH(MOST_JOINTS)];

static long targets(long usual) {
  const char *text = getenv("CHASLES_IK_TARGETS");
  return text ? strtol(text, NULL, 10) : usual;
}

static void read_robot(const char *name, struct robot *robot) {
  char path[512];
  snprintf(path, sizeof path, "%s/%s.robot", CHASLES_ROBOTS, name);
  TEST_ASSERT_TRUE_MESSAGE(robot_read(robot, path), path);
  subject = name;
}

static double metre(const struct robot *robot) { return strcmp(robot->unit, "mm") == 0 ? 1000 : 1; }

static void random_values(const struct robot *robot, double *q) {
  for (int i = 0; i < robot->joints; i++) q[i] = uniform(robot->limits[2 * i], robot->limits[2 * i + 1]);
}

static chs_ik options_of(const struct robot *robot, chs_ik_method method, int restarts) {
  chs_ik o = {method, tolerance, tolerance * metre(robot), 0.1, 100, restarts};
  return o;
}

/* By functions that inverse kinematics does not use. */
static void assert_reached(const struct robot *robot, const double T[16], const double *q) {
  const chs_chain c = robot_chain(robot);
  double reached[16], R[9], p[3], goal_R[9], goal_p[3], angle, way[3];
  ASSERT_STATUS(CHS_OK, chs_chain_fk(&c, q, reached));
  chs_se3_to_parts(reached, R, p);
  chs_se3_to_parts(T, goal_R, goal_p);
  ASSERT_STATUS(CHS_OK, chs_so3_angle(R, goal_R, &angle));
  for (int i = 0; i < 3; i++) way[i] = goal_p[i] - p[i];
  TEST_ASSERT_TRUE(angle <= tolerance * (1 + 1e-4));
  TEST_ASSERT_TRUE(sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]) <= tolerance * metre(robot) * (1 + 1e-4));
  for (int i = 0; i < robot->joints; i++)
    TEST_ASSERT_TRUE(q[i] >= robot->limits[2 * i] && q[i] <= robot->limits[2 * i + 1]);
}

static void find_near(const char *name, chs_ik_method method) {
  struct robot robot;
  read_robot(name, &robot);
  const chs_chain c = robot_chain(&robot);
  const chs_ik o = options_of(&robot, method, 20);
  for (long k = 0; k < targets(10000); k++) {
    double q[MOST_JOINTS], start[MOST_JOINTS], found[MOST_JOINTS], T[16];
    random_values(&robot, q);
    for (int i = 0; i < c.joints; i++) start[i] = q[i] + uniform(-0.2, 0.2) * (robot.turns[i] ? 1 : metre(&robot));
    ASSERT_STATUS(CHS_OK, chs_chain_fk(&c, q, T));
    ASSERT_STATUS(CHS_OK, chs_chain_ik(&c, T, start, &o, scratch, found, NULL));
    assert_reached(&robot, T, found);
  }
}

/* From random joint values, and from others once the restarts are used up, five times in all: 99.9 percent or more. */
static void find_far(const char *name) {
  struct robot robot;
  read_robot(name, &robot);
  const chs_chain c = robot_chain(&robot);
  const chs_ik o = options_of(&robot, CHS_IK_NEWTON, 40);
  long missed = 0, all = targets(1000);
  for (long k = 0; k < all; k++) {
    double q[MOST_JOINTS], start[MOST_JOINTS], found[MOST_JOINTS], T[16];
    int status = CHS_ITERATION_LIMIT;
    random_values(&robot, q);
    ASSERT_STATUS(CHS_OK, chs_chain_fk(&c, q, T));
    for (int again = 0; again < 5 && status != CHS_OK; again++) {
      random_values(&robot, start);
      status = chs_chain_ik(&c, T, start, &o, scratch, found, NULL);
    }
    missed += status != CHS_OK;
    if (status == CHS_OK) assert_reached(&robot, T, found);
  }
  printf("%s: %ld of %ld found from random starts\n", name, all - missed, all);
  TEST_ASSERT_TRUE(missed * 1000 <= all);
}

static void test_ur5e_finds_what_is_near(void) { find_near("ur5e", CHS_IK_NEWTON); }
static void test_puma560_finds_what_is_near(void) { find_near("puma560", CHS_IK_NEWTON); }
static void test_panda_finds_what_is_near(void) { find_near("panda", CHS_IK_NEWTON); }
static void test_scara_finds_what_is_near(void) { find_near("scara", CHS_IK_NEWTON); }
static void test_ur5e_finds_what_is_near_by_damping(void) { find_near("ur5e", CHS_IK_DAMPED); }
static void test_puma560_finds_what_is_near_by_damping(void) { find_near("puma560", CHS_IK_DAMPED); }
static void test_ur5e_finds_what_is_far(void) { find_far("ur5e"); }
static void test_puma560_finds_what_is_far(void) { find_far("puma560"); }
static void test_panda_finds_what_is_far(void) { find_far("panda"); }
static void test_scara_finds_what_is_far(void) { find_far("scara"); }

int main(void) {
  SUITE_BEGIN();
  RUN_TEST(test_ur5e_finds_what_is_near);
  RUN_TEST(test_puma560_finds_what_is_near);
  RUN_TEST(test_panda_finds_what_is_near);
  RUN_TEST(test_scara_finds_what_is_near);
  RUN_TEST(test_ur5e_finds_what_is_near_by_damping);
  RUN_TEST(test_puma560_finds_what_is_near_by_damping);
  RUN_TEST(test_ur5e_finds_what_is_far);
  RUN_TEST(test_puma560_finds_what_is_far);
  RUN_TEST(test_panda_finds_what_is_far);
  RUN_TEST(test_scara_finds_what_is_far);
  return SUITE_END();
}
