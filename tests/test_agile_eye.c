#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                   \
  CHECKED(agile_eye_inverse, "R", "w", (in[0], 5, out[0]))          \
  CHECKED(agile_eye_inverse_all, "R", "E", (in[0], out[0]))         \
  CHECKED(agile_eye_direct, "w", "R", (in[0], 2, out[0]))           \
  CHECKED(agile_eye_direct_working, "w", "R", (in[0], 0, out[0]))   \
  CHECKED(agile_eye_direct_near, "wR", "R", (in[0], in[1], out[0])) \
  CHECKED(agile_eye_jacobian, "w", "M", (in[0], out[0]))            \
  CHECKED(agile_eye_jacobian_inverse, "R", "M", (in[0], out[0]))    \
  CHECKED(agile_eye_distance, "R", "a", (in[0], out[0]))            \
  PLAIN(agile_eye_tool, "M", "M", (in[0], out[0]))                  \
  PLAIN(agile_eye_platform, "M", "M", (in[0], out[0]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 500, MODES = 8, NON_TRIVIAL = 4 };

/* What the header says of the joints, in double whatever the precision. */
typedef struct joints {
  double s[3], c[3], d[3], D;
} joints;

static joints joints_of(const real q[3]) {
  joints l;
  for (int i = 0; i < 3; i++) {
    l.s[i] = sin((double)q[i]);
    l.c[i] = cos((double)q[i]);
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    l.d[i] = hypot(l.s[j], l.c[j] * l.c[k]);
  }
  l.D = l.s[0] * l.s[1] * l.s[2] + l.c[0] * l.c[1] * l.c[2];
  return l;
}

static double least_of(const double x[3]) { return fmin(x[0], fmin(x[1], x[2])); }

/* u, w and v of a leg. */
static void axes_of_leg(int i, const joints *l, const real R[9], double u[3], double w[3], double v[3]) {
  int j = (i + 1) % 3, k = (i + 2) % 3;
  u[i] = 1;
  u[j] = u[k] = 0;
  w[i] = 0;
  w[j] = -l->s[i];
  w[k] = l->c[i];
  for (int r = 0; r < 3; r++) v[r] = -(double)R[3 * r + j];
}

static void cross3(const double a[3], const double b[3], double c[3]) {
  for (int i = 0; i < 3; i++) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot3(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* A omega + B dq/dt = 0, and the constraints themselves. */
typedef struct constraints {
  double A[9], B[3], f[3];
} constraints;

static constraints constraints_of(const joints *l, const real R[9]) {
  constraints m;
  for (int i = 0; i < 3; i++) {
    double u[3], w[3], v[3], moved[3];
    axes_of_leg(i, l, R, u, w, v);
    cross3(v, w, m.A + 3 * i);
    cross3(u, w, moved);
    m.B[i] = dot3(moved, v);
    m.f[i] = dot3(w, v);
  }
  return m;
}

static void random_joints(real q[3]) {
  for (int i = 0; i < 3; i++) q[i] = (real)uniform(-PI, PI);
}

/* Joints all of whose d_i are at least the limit. */
static joints random_joints_away(double limit, real q[3]) {
  joints l;
  do {
    random_joints(q);
    l = joints_of(q);
  } while (least_of(l.d) < limit);
  return l;
}

/* ---- The reference, and the modes ---- */

static void test_the_reference_has_joint_angles_zero_and_pi(void) {
  real q[3], all[24];
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse_all)(identity3, all));
  for (int working = 0; working < MODES; working++) {
    real expected[3];
    for (int i = 0; i < 3; i++) expected[i] = working >> i & 1 ? REAL_PI : K(0.0);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse)(identity3, working, q));
    ASSERT_SAME_BITS(expected, q, 3);
    ASSERT_SAME_BITS(expected, all + 3 * working, 3);
  }
}

static void test_zero_joint_angles_give_the_reference(void) {
  const real zero[3] = {0, 0, 0}, locked[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0};
  real R[9];
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct)(zero, 0, R));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(identity3[i] == R[i]);
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct)(zero, 4, R));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(locked[i] == R[i]);
}

static void test_one_working_mode_is_the_row_of_all(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], q[3], all[24];
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse_all)(R, all));
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse)(R, k % MODES, q));
    ASSERT_SAME_BITS(all + 3 * (k % MODES), q, 3);
  }
}

/* In each of the eight modes the legs close, and the matrix is a rotation. */
static void test_constraints_hold_in_every_assembly_mode(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9];
    random_joints(q);
    joints l = joints_of(q);
    for (int assembly = 0; assembly < MODES; assembly++) {
      TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_agile_eye_direct)(q, assembly, R));
      constraints m = constraints_of(&l, R);
      for (int i = 0; i < 3; i++) ASSERT_WITHIN_EPS(0, m.f[i], sqrt(2) * CHS_EPS_AGILE_EYE_DIRECT + 1, 1);
      TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(4 * CHS_EPS_AGILE_EYE_DIRECT * EPS)));
    }
  }
}

static void test_assembly_modes_differ_by_half_turns_of_the_platform(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], first[9], R[9];
    random_joints(q);
    for (int assembly = 0; assembly < MODES; assembly++) {
      FN(chs_agile_eye_direct)(q, assembly - assembly % NON_TRIVIAL, first);
      FN(chs_agile_eye_direct)(q, assembly, R);
      for (int i = 0; i < 9; i++) {
        int mode = assembly % NON_TRIVIAL;
        real sign = mode == 0 || i % 3 == mode - 1 ? K(1.0) : K(-1.0);
        TEST_ASSERT_TRUE(sign * first[i] == R[i]);
      }
    }
  }
}

/* A working mode is the three signs of (u_i x w_i) . v_i; those that go with the joints are found, others refused. */
static void test_a_working_mode_has_the_signs_that_its_number_says(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9];
    random_joints(q);
    joints l = joints_of(q);
    if (fabs(l.D) < 0.01) continue;
    int found = 0;
    for (int working = 0; working < MODES; working++) {
      int odd = (working & 1) ^ (working >> 1 & 1) ^ (working >> 2 & 1);
      if (odd != (l.D < 0)) {
        ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_agile_eye_direct_working)(q, working, R));
        continue;
      }
      TEST_ASSERT_EQUAL(CHS_OK, FN(chs_agile_eye_direct_working)(q, working, R));
      constraints m = constraints_of(&l, R);
      for (int i = 0; i < 3; i++) TEST_ASSERT_EQUAL(working >> i & 1, m.B[i] < 0);
      found++;
    }
    TEST_ASSERT_EQUAL(NON_TRIVIAL, found);
  }
}

/* ---- There and back ---- */

/* What there and back may do to an orientation, in eps: the errors of the direct kinematics; those of each joint angle
 * times its column of J, 1/(d_j d_k) at most; and, since the matrix is rounded, two entries a leg that are those of no
 * rotation, an angle of 1/b_i, which the same column makes 1/|D| of. */
static double there_and_back(const joints *l) {
  double sum = CHS_EPS_AGILE_EYE_DIRECT + 3 * sqrt(2) * CHS_EPS_SO3_EXP / fabs(l->D);
  for (int i = 0; i < 3; i++) sum += CHS_EPS_AGILE_EYE_INVERSE * PI / (l->d[(i + 1) % 3] * l->d[(i + 2) % 3]);
  return sum;
}

/* From 0.2 radians off the singular curves that is 16 eps at most. */
static void test_inverse_then_direct_returns_the_orientation_in_every_mode(void) {
  for (int k = 0; k < 20000; k++) {
    real R[9], q[3], back[9], distance;
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_distance)(R, &distance));
    for (int working = 0; working < MODES; working++) {
      ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse)(R, working, q));
      ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct_working)(q, working, back));
      joints l = joints_of(q);
      ASSERT_ENTRIES_WITHIN_EPS(R, back, 9, (double)distance >= 0.2 ? 16 : there_and_back(&l), 1);
    }
  }
}

static void test_direct_then_inverse_returns_the_joints(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9], back[3];
    joints l = random_joints_away(0.05, q);
    if (fabs(l.D) < 0.05) continue;
    for (int working = 0; working < MODES; working++) {
      if (FN(chs_agile_eye_direct_working)(q, working, R) != CHS_OK) continue;
      ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse)(R, working, back));
      /* The angle is that of a point at a distance b_i = |D| / (d_j d_k) of which either coordinate is off. */
      double nearest = fabs(l.D);
      for (int i = 0; i < 3; i++)
        ASSERT_WITHIN_EPS(0, remainder((double)back[i] - (double)q[i], 2 * PI),
                          CHS_EPS_AGILE_EYE_INVERSE * PI + sqrt(2) * CHS_EPS_AGILE_EYE_DIRECT / nearest, 1);
    }
  }
}

static void test_direct_near_picks_the_nearest_of_the_four(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], last[9], R[9], other[9], angle, nearest;
    random_joints(q);
    random_rotation(last);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_agile_eye_direct_near)(q, last, R));
    FN(chs_so3_angle)(last, R, &nearest);
    int equal = 0;
    for (int assembly = 0; assembly < NON_TRIVIAL; assembly++) {
      FN(chs_agile_eye_direct)(q, assembly, other);
      FN(chs_so3_angle)(last, other, &angle);
      TEST_ASSERT_TRUE((double)angle >= (double)nearest - 16 * EPS);
      equal += memcmp(other, R, sizeof R) == 0;
    }
    TEST_ASSERT_EQUAL(1, equal);
  }
}

/* A controller that follows the joints from orientation to orientation stays in its assembly mode, through D = 0 too,
 * where the working mode changes. */
/* At the reference all four are diagonal, and equally far from a rotation without a diagonal. */
static void test_direct_near_takes_the_first_of_modes_equally_far(void) {
  const real q[3] = {0, 0, 0}, last[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0};
  real R[9];
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct_near)(q, last, R));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(R[i] == identity3[i]);
}

static void test_direct_near_follows_a_path_through_the_locked_orientation(void) {
  const real from[3] = {K(0.3), K(0.4), K(-0.5)}, to[3] = {K(1.2), K(1.1), K(-1.3)};
  real last[9], R[9], moved;
  int signs = 0;
  FN(chs_agile_eye_direct)(from, 2, last);
  for (int k = 0; k <= 200; k++) {
    real q[3], expected[9];
    for (int i = 0; i < 3; i++) q[i] = from[i] + (to[i] - from[i]) * (real)k / 200;
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_agile_eye_direct_near)(q, last, R));
    FN(chs_agile_eye_direct)(q, 2, expected);
    for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(expected[i] == R[i]);
    FN(chs_so3_angle)(last, R, &moved);
    TEST_ASSERT_TRUE((double)moved < 0.1);
    memcpy(last, R, sizeof last);
    signs |= joints_of(q).D > 0 ? 1 : 2;
  }
  TEST_ASSERT_EQUAL(3, signs);
}

/* Turning a leg the other way round changes nothing but the assembly mode, also off the nominal joint angles: whatever
 * joint errors do to the orientation, they do in every working mode. */
static void test_all_working_modes_answer_joint_errors_alike(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], q[24], first[9], other[9];
    double off[3];
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_inverse_all)(R, q));
    for (int i = 0; i < 3; i++) off[i] = uniform(-0.05, 0.05);
    double least = 1;
    for (int working = 0; working < MODES; working++) {
      real *here = q + 3 * working;
      for (int i = 0; i < 3; i++) here[i] = rounded((double)here[i] + off[i]);
      joints l = joints_of(here);
      least = fmin(least, least_of(l.d));
      if (least < 0.1) break;
      ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct_near)(here, R, other));
      if (working == 0) memcpy(first, other, sizeof first);
      /* The angles differ by pi to within their own rounding. */
      ASSERT_ENTRIES_WITHIN_EPS(first, other, 9, 2 * CHS_EPS_AGILE_EYE_DIRECT + 3 * 2 * PI / (least * least), 1);
    }
  }
}

/* ---- Rates ---- */

static void test_the_platform_side_has_the_determinant_of_the_header(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9];
    random_joints(q);
    joints l = joints_of(q);
    for (int assembly = 0; assembly < MODES; assembly++) {
      FN(chs_agile_eye_direct)(q, assembly, R);
      constraints m = constraints_of(&l, R);
      double bc[3];
      cross3(m.A + 3, m.A + 6, bc);
      double determinant = dot3(m.A, bc);
      /* Each entry of A has the error of an entry of R, and the rows have length 1. */
      ASSERT_WITHIN_EPS(assembly < NON_TRIVIAL ? -l.D : l.D, determinant, 6 * CHS_EPS_AGILE_EYE_DIRECT, 1);
    }
  }
}

/* A J + B = 0, in every non-trivial assembly mode with the same J. */
static void test_jacobian_solves_the_derivatives_of_the_constraints(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9], J[9];
    random_joints(q);
    joints l = joints_of(q);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_agile_eye_jacobian)(q, J));
    for (int assembly = 0; assembly < NON_TRIVIAL; assembly++) {
      FN(chs_agile_eye_direct)(q, assembly, R);
      constraints m = constraints_of(&l, R);
      for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
          double size = 1 / (l.d[(j + 1) % 3] * l.d[(j + 2) % 3]), sum = i == j ? m.B[i] : 0;
          for (int r = 0; r < 3; r++) sum += m.A[3 * i + r] * (double)J[3 * r + j];
          ASSERT_WITHIN_EPS(0, sum, sqrt(3) * (CHS_EPS_AGILE_EYE_JACOBIAN + 2 * CHS_EPS_AGILE_EYE_DIRECT), size);
        }
    }
  }
}

/* The rotation between neighbouring joint angles, divided by their difference. */
static void test_jacobian_is_the_derivative_in_the_base_frame(void) {
  const double h = PICK(1e-5, 1e-2);
  for (int k = 0; k < CASES; k++) {
    real q[3], J[9], before[9], after[9], between[9], w[3];
    random_joints_away(0.3, q);
    TEST_ASSERT_GREATER_OR_EQUAL(0, FN(chs_agile_eye_jacobian)(q, J));
    int j = k % 3;
    real middle = q[j];
    q[j] = (real)((double)middle - h);
    double from = (double)q[j];
    FN(chs_agile_eye_direct)(q, 0, before);
    q[j] = (real)((double)middle + h);
    double to = (double)q[j];
    FN(chs_agile_eye_direct)(q, 0, after);
    FN(chs_so3_transpose)(before, before);
    FN(chs_so3_multiply)(after, before, between);
    FN(chs_so3_log)(between, w);
    /* third derivatives of size 1/d^3 or so, and rounding divided by h */
    double allowed = h * h * 100 + 16 * EPS / h;
    for (int r = 0; r < 3; r++)
      TEST_ASSERT_TRUE(fabs((double)w[r] / (to - from) - (double)J[3 * r + j]) <= allowed * 4);
  }
}

static void test_the_inverse_jacobian_undoes_the_jacobian(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9], J[9], inverse[9];
    joints l = random_joints_away(0.05, q);
    if (fabs(l.D) < 0.05) continue;
    FN(chs_agile_eye_direct)(q, k % NON_TRIVIAL, R);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_jacobian)(q, J));
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_jacobian_inverse)(R, inverse));
    real product[9];
    product_of(inverse, J, 3, 3, product);
    /* A row of the inverse has the length d_j d_k / |D|, and its relative change with R is 1/b_i as well. */
    double size = 1 / pow(l.D * least_of(l.d), 2);
    double promise = CHS_EPS_AGILE_EYE_JACOBIAN + CHS_EPS_AGILE_EYE_JACOBIAN_INVERSE + 3 * CHS_EPS_AGILE_EYE_DIRECT;
    ASSERT_ENTRIES_WITHIN_EPS(identity3, product, 9, promise, size);
  }
}

static void test_jacobians_at_the_reference(void) {
  const real zero[3] = {0, 0, 0};
  real J[9];
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_jacobian)(zero, J));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(identity3[i] == J[i]);
  ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_jacobian_inverse)(identity3, J));
  for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(identity3[i] == J[i]);
}

/* ---- Singular configurations ---- */

/* The platform with v_i along u_i or against it, turned about it: column j of R is u_i or -u_i. */
static void singular_orientation(int i, int sign, double angle, real R[9]) {
  int j = (i + 1) % 3, k = (i + 2) % 3;
  real c = rounded(cos(angle)), s = rounded(sin(angle));
  for (int e = 0; e < 9; e++) R[e] = 0;
  R[3 * i + j] = (real)sign;
  R[3 * j + k] = c; /* the column after it, and the one before it, their cross product */
  R[3 * k + k] = s;
  R[3 * j + i] = (real)-sign * s;
  R[3 * k + i] = (real)sign * c;
}

static void test_the_six_curves_are_told_by_status(void) {
  for (int i = 0; i < 3; i++)
    for (int sign = -1; sign <= 1; sign += 2)
      for (int k = 0; k < 50; k++) {
        real R[9], q[3], distance, rates[9];
        singular_orientation(i, sign, uniform(0.1, 1.4) + PI / 2 * (k % 4), R);
        TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(8 * EPS)));
        ASSERT_STATUS(CHS_SELF_MOTION, FN(chs_agile_eye_inverse)(R, k % MODES, q));
        TEST_ASSERT_TRUE(q[i] == 0);
        ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_distance)(R, &distance));
        TEST_ASSERT_TRUE(distance == 0);
        ASSERT_REFUSES(CHS_ERR_SINGULAR, rates, FN(chs_agile_eye_jacobian_inverse)(R, rates));
        /* Whatever the free joint is, the platform can turn about u_i. */
        q[i] = (real)uniform(-3, 3);
        joints l = joints_of(q);
        constraints m = constraints_of(&l, R);
        for (int f = 0; f < 3; f++) ASSERT_WITHIN_EPS(0, m.f[f], 2, 1);
        real J[9];
        ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_agile_eye_direct)(q, k % NON_TRIVIAL, R));
        ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_agile_eye_direct_working)(q, k % MODES, R));
        ASSERT_REFUSES(CHS_ERR_SINGULAR, R, FN(chs_agile_eye_direct_near)(q, identity3, R));
        ASSERT_REFUSES(CHS_ERR_SINGULAR, J, FN(chs_agile_eye_jacobian)(q, J));
      }
}

/* A sine of the angle between v_i and u_i of 4 eps, the header's limit, from below and from above. */
static void test_a_leg_turns_freely_up_to_four_eps(void) {
  for (int k = 1; k <= 8; k++) {
    int i = k % 3, j = (i + 1) % 3;
    real R[9], q[3], rates[9];
    if (k == 4) continue;
    singular_orientation(i, 1, 0.7, R);
    R[3 * j + j] = (real)(k * EPS);
    ASSERT_STATUS(k < 4 ? CHS_SELF_MOTION : CHS_OK, FN(chs_agile_eye_inverse)(R, 0, q));
    ASSERT_STATUS(k < 4 ? CHS_ERR_SINGULAR : CHS_OK, FN(chs_agile_eye_jacobian_inverse)(R, rates));
  }
}

static void test_the_locked_platform_is_told_by_status(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9], all[24], rates[9], distance;
    random_joints(q);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_direct)(q, NON_TRIVIAL + k % 4, R));
    ASSERT_REFUSES(CHS_ERR_LOCKUP, q, FN(chs_agile_eye_inverse)(R, k % MODES, q));
    ASSERT_REFUSES(CHS_ERR_LOCKUP, all, FN(chs_agile_eye_inverse_all)(R, all));
    ASSERT_REFUSES(CHS_ERR_LOCKUP, rates, FN(chs_agile_eye_jacobian_inverse)(R, rates));
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_distance)(R, &distance));
    TEST_ASSERT_TRUE(distance == 0);
  }
}

/* Where D = 0 all joints lead to a locked platform, in every working mode. */
static void test_the_orientation_is_a_locked_one_where_d_vanishes(void) {
  for (int k = 0; k < CASES; k++) {
    real q[3], R[9], locked[9];
    double a = uniform(0.3, 1.2), b = uniform(0.3, 1.2);
    q[0] = (real)a;
    q[1] = (real)b;
    q[2] = (real)-atan(1 / (tan((double)q[0]) * tan((double)q[1])));
    for (int working = 0; working < MODES; working++) {
      ASSERT_STATUS(CHS_SELF_MOTION, FN(chs_agile_eye_direct_working)(q, working, R));
      double nearest = 1;
      for (int assembly = NON_TRIVIAL; assembly < MODES; assembly++) {
        FN(chs_agile_eye_direct)(q, assembly, locked);
        double far = 0;
        for (int i = 0; i < 9; i++) far = fmax(far, fabs((double)locked[i] - (double)R[i]));
        nearest = fmin(nearest, far);
      }
      double d = least_of(joints_of(q).d);
      ASSERT_WITHIN_EPS(0, nearest, 4 / (d * d) + CHS_EPS_AGILE_EYE_DIRECT, 1);
    }
  }
}

static void test_near_a_curve_most_digits_of_the_joints_are_lost_and_a_status_says_so(void) {
  for (int k = 0; k < CASES; k++) {
    double d = log_uniform(64 * EPS, 0.25 * sqrt(EPS)), a = uniform(0, 2 * PI);
    real q[3] = {(real)uniform(-3, 3), (real)(d * cos(a)), (real)(PI / 2 + d * sin(a))}, R[9], J[9];
    joints l = joints_of(q);
    if (least_of(l.d) < 32 * EPS || fabs(l.D) < 64 * EPS) continue;
    ASSERT_STATUS(CHS_ILL_CONDITIONED, FN(chs_agile_eye_direct)(q, k % NON_TRIVIAL, R));
    ASSERT_STATUS(CHS_ILL_CONDITIONED, FN(chs_agile_eye_jacobian)(q, J));
    TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(R, (real)(4 * CHS_EPS_AGILE_EYE_DIRECT * EPS)));
    for (int i = 0; i < 9; i++) TEST_ASSERT_TRUE(isfinite((double)J[i]));
  }
}

static void test_the_distance_is_the_least_angle_to_a_curve(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], distance, other[9], angle, turned[9], w[3];
    random_rotation(R);
    ASSERT_STATUS(CHS_OK, FN(chs_agile_eye_distance)(R, &distance));
    /* No singular orientation is nearer. */
    for (int n = 0; n < 20; n++) {
      singular_orientation(n % 3, n % 2 ? 1 : -1, uniform(0, 2 * PI), other);
      FN(chs_so3_angle)(R, other, &angle);
      TEST_ASSERT_TRUE((double)angle >= (double)distance - 8 * EPS);
    }
    /* One is as near: turning about v_i x u_i, either way, brings one v_i to its u_i. */
    double best = 1;
    for (int i = 0; i < 3; i++)
      for (int sign = -1; sign <= 1; sign += 2) {
        real v[3] = {R[(i + 1) % 3], R[3 + (i + 1) % 3], R[6 + (i + 1) % 3]}, u[3] = {0, 0, 0}, axis[3], moved[3];
        u[i] = (real)sign;
        cross_of(v, u, axis);
        scaled((double)distance / length_of(axis, 3), axis, 3, w);
        FN(chs_so3_exp)(w, turned);
        FN(chs_so3_apply)(turned, v, moved);
        for (int r = 0; r < 3; r++) moved[r] -= u[r];
        best = fmin(best, length_of(moved, 3));
      }
    ASSERT_WITHIN_EPS(0, best, 16, 1);
  }
}

static void test_modes_that_do_not_exist_are_refused(void) {
  const real q[3] = {K(0.1), K(0.2), K(0.3)};
  const int none[] = {-1, 8, 100, -100};
  for (int k = 0; k < LENGTH(none); k++) {
    real R[9], joint[3];
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, R, FN(chs_agile_eye_direct)(q, none[k], R));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, R, FN(chs_agile_eye_direct_working)(q, none[k], R));
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, joint, FN(chs_agile_eye_inverse)(identity3, none[k], joint));
  }
}

static void test_angles_beyond_the_range_are_refused(void) {
  const real more = NEXT_AFTER(ANGLE_MAX, REAL_MAX);
  for (int k = 0; k < 6; k++) {
    real q[3] = {K(0.1), K(0.2), K(0.3)}, R[9];
    q[k / 2] = k % 2 ? more : -more;
    for (int assembly = 0; assembly < MODES; assembly++)
      ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, R, FN(chs_agile_eye_direct)(q, assembly, R));
    ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, R, FN(chs_agile_eye_direct_working)(q, 0, R));
    ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, R, FN(chs_agile_eye_direct_near)(q, identity3, R));
    ASSERT_REFUSES(CHS_ERR_ANGLE_RANGE, R, FN(chs_agile_eye_jacobian)(q, R));
  }
}

/* ---- The tool ---- */

static void test_the_reference_has_tilt_zero_and_torsion_sixty_degrees(void) {
  real tool[9], azimuth, tilt, torsion;
  FN(chs_agile_eye_tool)(identity3, tool);
  ASSERT_STATUS(CHS_AZIMUTH_UNDEFINED, FN(chs_tilt_from_rotation)(tool, &azimuth, &tilt, &torsion));
  ASSERT_WITHIN_EPS(PI / 3, torsion, 2, PI / 3);
}

static void test_tool_and_platform_are_inverse_and_keep_rotations(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], tool[9], back[9];
    random_rotation(R);
    FN(chs_agile_eye_tool)(R, tool);
    TEST_ASSERT_EQUAL(CHS_OK, FN(chs_so3_check)(tool, (real)(16 * EPS)));
    FN(chs_agile_eye_platform)(tool, back);
    ASSERT_ENTRIES_WITHIN_EPS(R, back, 9, CHS_EPS_AGILE_EYE_TOOL * 2 + CHS_EPS_AGILE_EYE_PLATFORM, sqrt(3));
  }
}

/* The tool's axis is (1,1,1) of the platform, seen from a base whose z is (1,1,1): alpha of a rotation of the base. */
static void test_the_tool_axis_is_the_diagonal_of_the_platform(void) {
  for (int k = 0; k < CASES; k++) {
    real R[9], tool[9];
    random_rotation(R);
    FN(chs_agile_eye_tool)(R, tool);
    double sum = 0;
    for (int i = 0; i < 9; i++) sum += (double)R[i];
    ASSERT_WITHIN_EPS(sum / 3, tool[8], CHS_EPS_AGILE_EYE_TOOL + 1, sqrt(3));
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_the_reference_has_joint_angles_zero_and_pi);
  RUN_TEST(test_zero_joint_angles_give_the_reference);
  RUN_TEST(test_one_working_mode_is_the_row_of_all);
  RUN_TEST(test_constraints_hold_in_every_assembly_mode);
  RUN_TEST(test_assembly_modes_differ_by_half_turns_of_the_platform);
  RUN_TEST(test_a_working_mode_has_the_signs_that_its_number_says);
  RUN_TEST(test_inverse_then_direct_returns_the_orientation_in_every_mode);
  RUN_TEST(test_direct_then_inverse_returns_the_joints);
  RUN_TEST(test_direct_near_picks_the_nearest_of_the_four);
  RUN_TEST(test_direct_near_takes_the_first_of_modes_equally_far);
  RUN_TEST(test_direct_near_follows_a_path_through_the_locked_orientation);
  RUN_TEST(test_all_working_modes_answer_joint_errors_alike);
  RUN_TEST(test_the_platform_side_has_the_determinant_of_the_header);
  RUN_TEST(test_jacobian_solves_the_derivatives_of_the_constraints);
  RUN_TEST(test_jacobian_is_the_derivative_in_the_base_frame);
  RUN_TEST(test_the_inverse_jacobian_undoes_the_jacobian);
  RUN_TEST(test_jacobians_at_the_reference);
  RUN_TEST(test_the_six_curves_are_told_by_status);
  RUN_TEST(test_a_leg_turns_freely_up_to_four_eps);
  RUN_TEST(test_the_locked_platform_is_told_by_status);
  RUN_TEST(test_the_orientation_is_a_locked_one_where_d_vanishes);
  RUN_TEST(test_near_a_curve_most_digits_of_the_joints_are_lost_and_a_status_says_so);
  RUN_TEST(test_the_distance_is_the_least_angle_to_a_curve);
  RUN_TEST(test_modes_that_do_not_exist_are_refused);
  RUN_TEST(test_angles_beyond_the_range_are_refused);
  RUN_TEST(test_the_reference_has_tilt_zero_and_torsion_sixty_degrees);
  RUN_TEST(test_tool_and_platform_are_inverse_and_keep_rotations);
  RUN_TEST(test_the_tool_axis_is_the_diagonal_of_the_platform);
  return SUITE_END();
}
