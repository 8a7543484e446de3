#include "support/suite.h"

#define FUNCTIONS(PLAIN, CHECKED)                                                                 \
  CHECKED(motion_bottema_roth, "PFt", "ST", (in[0], in[1], in[2][0], SCREW_AT(out[0]), out[1]))   \
  CHECKED(motion_laub_shiflett, "PFt", "ST", (in[0], in[1], in[2][0], SCREW_AT(out[0]), out[1]))  \
  CHECKED(motion_angeles, "PFt", "ST", (in[0], in[1], in[2][0], SCREW_AT(out[0]), out[1]))        \
  CHECKED(motion_spoor_veldpaus, "PFt", "ST", (in[0], in[1], in[2][0], SCREW_AT(out[0]), out[1])) \
  CHECKED(motion_beggs, "PFt", "ST", (in[0], in[1], in[2][0], SCREW_AT(out[0]), out[1]))

DEFINE_FUNCTIONS(FUNCTIONS)
DEFINE_CONTRACT_TESTS()

enum { CASES = 300 };

/* A solver and what it promises, in eps. */
typedef struct solver {
  const char *name;
  int (*solve)(const real initial[9], const real final[9], real tolerance, screw *s, real T[16]);
  double axis, point, translation, angle, rotation, position;
} solver;

#define SOLVER(name, NAME)                                                                                    \
  {                                                                                                           \
#name, FN(chs_motion_##name), CHS_EPS_MOTION_##NAME##_AXIS, CHS_EPS_MOTION_##NAME##_POINT,                \
        CHS_EPS_MOTION_##NAME##_TRANSLATION, CHS_EPS_MOTION_##NAME##_ANGLE, CHS_EPS_MOTION_##NAME##_ROTATION, \
        CHS_EPS_MOTION_##NAME##_POSITION                                                                      \
  }

static const solver solvers[] = {SOLVER(bottema_roth, BOTTEMA_ROTH), SOLVER(laub_shiflett, LAUB_SHIFLETT),
                                 SOLVER(angeles, ANGELES), SOLVER(spoor_veldpaus, SPOOR_VELDPAUS),
                                 SOLVER(beggs, BEGGS)};

static const real tolerance = K(0.001);

/* A displacement of integers, times a power of two: the rotation of a quaternion and a translation, of three points
 * that are multiples of nn, so that points, images and results are all known without rounding. */
typedef struct displacement {
  turn q;
  int x[3][3]; /* the initial points are nn x */
  int t[3];
  double unit;
} displacement;

static void points_of(const displacement *d, real initial[9], real final[9]) {
  for (int k = 0; k < 3; k++)
    for (int i = 0; i < 3; i++) {
      long image = d->t[i];
      for (int j = 0; j < 3; j++) image += (long)turn_numerator(&d->q, i, j) * d->x[k][j];
      initial[3 * k + i] = rounded(d->unit * (double)((long)d->q.nn * d->x[k][i]));
      final[3 * k + i] = rounded(d->unit * (double)image);
    }
}

static void side_of(const real points[9], int k, real side[3]) {
  for (int i = 0; i < 3; i++) side[i] = points[3 * ((k + 2) % 3) + i] - points[3 * ((k + 1) % 3) + i];
}

/* What the promises are relative to. */
typedef struct scales {
  double kappa; /* longest side over smallest height */
  double rho;   /* largest distance of a point from the origin */
  double centers, travel;
} scales;

static scales scales_of(const real initial[9], const real final[9]) {
  scales s = {0, 0, 0, 0};
  real a[3], c[3], N[3], center[3], moved[3], travel[3];
  double longest = 0, unit = length_of(initial, 9);
  for (int k = 0; k < 3; k++) {
    side_of(initial, k, a);
    longest = fmax(longest, length_of(a, 3) / unit);
    s.rho = fmax(s.rho, fmax(length_of(initial + 3 * k, 3), length_of(final + 3 * k, 3)));
  }
  side_of(initial, 0, a);
  side_of(initial, 1, c);
  scaled(1 / unit, a, 3, a);
  scaled(1 / unit, c, 3, c);
  cross_of(a, c, N);
  s.kappa = longest * longest / length_of(N, 3);
  for (int i = 0; i < 3; i++) {
    center[i] = rounded(((double)initial[i] + (double)initial[3 + i] + (double)initial[6 + i]) / 3);
    moved[i] = rounded(((double) final[i] + (double) final[3 + i] + (double) final[6 + i]) / 3);
    travel[i] = rounded((double)moved[i] - (double)center[i]);
  }
  s.centers = length_of(center, 3) + length_of(moved, 3);
  s.travel = length_of(travel, 3);
  return s;
}

/* The screw in doubles: p = unit t, A = 1/2 (p - v (v.p)/v.v + w/(v.v) v x p), u = e.p. */
static void screw_of(const displacement *d, screw *s) {
  const int *v = d->q.v, *t = d->t;
  double vt = v[0] * t[0] + v[1] * t[1] + v[2] * t[2], vv = d->q.vv;
  turn_axis(&d->q, s->axis);
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    double vxt = v[j] * t[k] - v[k] * t[j];
    s->point[i] = rounded(d->unit * (vv * t[i] - vt * v[i] + d->q.w * vxt) / (2 * vv));
  }
  s->angle = (real)turn_angle(&d->q);
  double sign = (double)s->axis[0] * v[0] + (double)s->axis[1] * v[1] + (double)s->axis[2] * v[2] < 0 ? -1 : 1;
  s->translation = (real)(d->unit * sign * vt / sqrt(vv));
}

/* The expected numbers are rounded too, twice at most. */
static const double rounding = 2;

static void assert_solution(const solver *m, const displacement *d, const real initial[9], const real final[9],
                            const screw *s, const real T[16]) {
  const scales by = scales_of(initial, final);
  const double sine = sin(turn_angle(&d->q) / 2);
  screw expected;
  real R[9], p[3], R_expected[9], p_expected[3];
  screw_of(d, &expected);
  turn_matrix(&d->q, R_expected);
  for (int i = 0; i < 3; i++) p_expected[i] = rounded(d->unit * d->t[i]);
  FN(chs_se3_to_parts)(T, R, p);
  ASSERT_ENTRIES_WITHIN_EPS(R_expected, R, 9, m->rotation + rounding, by.kappa);
  ASSERT_NORM_WITHIN_EPS(p_expected, p, 3, m->position + rounding, by.kappa * by.rho);
  ASSERT_SAME_BITS(identity4 + 12, T + 12, 4);
  ASSERT_NORM_WITHIN_EPS(expected.axis, s->axis, 3, m->axis + rounding, by.kappa / sine);
  ASSERT_WITHIN_EPS(expected.angle, s->angle, m->angle + rounding, by.kappa);
  ASSERT_WITHIN_EPS(expected.translation, s->translation, m->translation + rounding,
                    by.centers + by.kappa * by.travel / sine);
  ASSERT_NORM_WITHIN_EPS(expected.point, s->point, 3, m->point + rounding,
                         by.kappa * (by.rho / sine + by.travel / (sine * sine)));
}

/* All solvers find the displacement. */
static void assert_found(const displacement *d) {
  real initial[9], final[9], T[16];
  points_of(d, initial, final);
  for (int m = 0; m < LENGTH(solvers); m++) {
    screw s;
    subject = solvers[m].name;
    ASSERT_STATUS(d->q.w == 0 ? CHS_HALF_TURN : CHS_OK, solvers[m].solve(initial, final, tolerance, &s, T));
    assert_solution(solvers + m, d, initial, final, &s, T);
  }
}

static double condition_of(const displacement *d) {
  real initial[9], final[9];
  points_of(d, initial, final);
  return scales_of(initial, final).kappa;
}

static int collinear(const displacement *d) {
  real a[3], c[3], N[3];
  for (int i = 0; i < 3; i++) {
    a[i] = rounded(d->x[1][i] - d->x[0][i]);
    c[i] = rounded(d->x[2][i] - d->x[0][i]);
  }
  cross_of(a, c, N);
  return length_of(N, 3) == 0;
}

static displacement random_displacement(int w) {
  displacement d;
  do {
    d.q = random_turn(w);
    d.unit = 1;
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) d.x[k][i] = integer(-20, 20);
      d.t[i] = integer(-300, 300);
    }
  } while (collinear(&d) || condition_of(&d) > 10);
  return d;
}

static void test_solvers_find_rotations_of_every_size(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(1, 9));
    assert_found(&d);
    d.q.w = PICK(1000, 100); /* small angles */
    d.q.nn = d.q.w * d.q.w + d.q.vv;
    assert_found(&d);
  }
}

static void test_solvers_find_half_turns_with_a_positive_first_component(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(0);
    assert_found(&d);
  }
}

/* Within its error of a half-turn, on either side of it: an angle of at most pi, and the sign of the convention. */
static void test_rotations_within_their_error_of_a_half_turn_count_as_one(void) {
  for (int k = 0; k < CASES; k++) {
    real initial[9], final[9], T[16], w[3];
    screw s;
    for (int m = 0; m < 9; m += 3) random_vector(1, initial + m);
    double kappa = scales_of(initial, initial).kappa;
    random_vector(PI + uniform(-4, 4) * EPS * kappa, w);
    if (kappa > 100 || fabs((double)w[0]) < 0.1) continue;
    FN(chs_se3_from_parts)(identity3, w, T); /* any translation */
    FN(chs_so3_exp)(w, final);
    for (int i = 0; i < 9; i++) T[4 * (i / 3) + i % 3] = final[i];
    for (int m = 0; m < 9; m += 3) FN(chs_se3_apply)(T, initial + m, final + m);
    for (int m = 0; m < LENGTH(solvers); m++) {
      subject = solvers[m].name;
      ASSERT_STATUS(CHS_HALF_TURN, solvers[m].solve(initial, final, tolerance, &s, NULL));
      TEST_ASSERT_TRUE(s.angle <= REAL_PI && s.axis[0] > 0);
    }
  }
}

/* Farther from it, the angle is told from pi. */
static void test_rotations_beyond_their_error_of_a_half_turn_are_none(void) {
  for (int k = 0; k < CASES; k++) {
    real initial[9], final[9], T[16], w[3];
    screw s;
    for (int m = 0; m < 9; m += 3) random_vector(1, initial + m);
    double kappa = scales_of(initial, initial).kappa, gap = uniform(32, 100) * EPS * kappa;
    random_vector(PI - gap, w);
    if (kappa > 100) continue;
    FN(chs_se3_from_parts)(identity3, w, T);
    FN(chs_so3_exp)(w, final);
    for (int i = 0; i < 9; i++) T[4 * (i / 3) + i % 3] = final[i];
    for (int m = 0; m < 9; m += 3) FN(chs_se3_apply)(T, initial + m, final + m);
    for (int m = 0; m < LENGTH(solvers); m++) {
      subject = solvers[m].name;
      ASSERT_STATUS(CHS_OK, solvers[m].solve(initial, final, tolerance, &s, NULL));
      ASSERT_WITHIN_EPS(PI - gap, s.angle, solvers[m].angle + 8, kappa); /* 8: the rounding of the points */
    }
  }
}

static void test_solvers_find_a_rotation_about_the_line_through_two_points(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    int at = k % 3, on = (at + 1) % 3;
    for (int i = 0; i < 3; i++) d.x[on][i] = d.x[at][i] + 9 * d.q.v[i];
    for (int i = 0; i < 3; i++) { /* t = c - R c */
      d.t[i] = d.q.nn * d.x[at][i];
      for (int j = 0; j < 3; j++) d.t[i] -= turn_numerator(&d.q, i, j) * d.x[at][j];
    }
    if (!collinear(&d) && condition_of(&d) < 20) assert_found(&d);
  }
}

static void test_solvers_find_an_axis_parallel_to_the_plane_of_the_points(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    int y[3] = {integer(-5, 5), integer(-5, 5), integer(-5, 5)};
    for (int i = 0; i < 3; i++) {
      d.x[1][i] = d.x[0][i] + 2 * y[i] + d.q.v[i];
      d.x[2][i] = d.x[0][i] + (k % 2 ? y[i] + 2 * d.q.v[i] : 2 * y[i] + 5 * d.q.v[i]); /* or parallel to a side */
    }
    if (!collinear(&d) && condition_of(&d) < 20) assert_found(&d);
  }
}

static void test_solvers_do_not_mind_the_origin_in_the_plane_of_the_points(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    for (int i = 0; i < 3; i++) d.x[2][i] = k % 2 ? 0 : d.x[0][i] - d.x[1][i]; /* a point at it, or not */
    if (!collinear(&d) && condition_of(&d) < 20) assert_found(&d);
  }
}

static void test_solvers_lose_no_more_than_the_condition_number_on_thin_triangles(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(1, 5));
    int along[3] = {integer(-9, 9), integer(-9, 9), 10}, foot = integer(1, 9);
    for (int i = 0; i < 3; i++) {
      d.x[1][i] = d.x[0][i] + PICK(10000, 100) * along[i];
      d.x[2][i] = d.x[0][i] + foot * PICK(1000, 10) * along[i] + integer(-1, 1);
    }
    if (!collinear(&d) && condition_of(&d) < PICK(1e6, 1e3)) assert_found(&d);
  }
}

static void test_solvers_work_far_from_the_origin(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    int offset[3] = {integer(-1, 1), integer(-1, 1), 1};
    for (int m = 0; m < 3; m++)
      for (int i = 0; i < 3; i++) d.x[m][i] += PICK(100000, 500) * offset[i];
    assert_found(&d);
  }
}

static void test_scaling_by_a_power_of_two_scales_the_lengths_and_nothing_else(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5)), large = d;
    int power = k % 2 ? integer(PICK(-332, -40), PICK(332, 40)) : PICK(332, 40) * (k % 4 - 1);
    large.unit = ldexp(1, power);
    assert_found(&large);
    for (int m = 0; m < LENGTH(solvers); m++) {
      real initial[9], final[9], T[16], large_T[16];
      screw s, large_s;
      points_of(&d, initial, final);
      solvers[m].solve(initial, final, tolerance, &s, T);
      points_of(&large, initial, final);
      solvers[m].solve(initial, final, tolerance, &large_s, large_T);
      for (int i = 0; i < 3; i++) {
        T[4 * i + 3] = (real)ldexp((double)T[4 * i + 3], power);
        s.point[i] = (real)ldexp((double)s.point[i], power);
      }
      s.translation = (real)ldexp((double)s.translation, power);
      ASSERT_SAME_BITS(T, large_T, 16);
      ASSERT_SAME_BITS(s.axis, large_s.axis, 8);
    }
  }
}

static void test_a_translation_added_leaves_the_rotation_as_it_is(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5)), moved = d;
    for (int i = 0; i < 3; i++) moved.t[i] += integer(-999, 999);
    assert_found(&moved);
    for (int m = 0; m < LENGTH(solvers); m++) {
      real initial[9], final[9], T[16], other[16], R[9], p[3], R_other[9];
      screw s, other_s;
      points_of(&d, initial, final);
      solvers[m].solve(initial, final, tolerance, &s, T);
      points_of(&moved, initial, final);
      solvers[m].solve(initial, final, tolerance, &other_s, other);
      FN(chs_se3_to_parts)(T, R, p);
      FN(chs_se3_to_parts)(other, R_other, p);
      ASSERT_SAME_BITS(R, R_other, 9);
      ASSERT_SAME_BITS(s.axis, other_s.axis, 3);
      ASSERT_SAME_BITS(&s.angle, &other_s.angle, 1);
    }
  }
}

static void test_the_order_of_the_points_does_not_matter(void) {
  const int orders[5][3] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    for (int m = 0; m < LENGTH(orders); m++) {
      displacement reordered = d;
      for (int i = 0; i < 3; i++) memcpy(reordered.x[i], d.x[orders[m][i]], sizeof d.x[i]);
      assert_found(&reordered);
    }
  }
}

static void test_backwards_is_the_inverse(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(1, 5));
    real initial[9], final[9], T[16], expected[16], R[9], p[3], R_back[9], p_back[3];
    points_of(&d, initial, final);
    for (int m = 0; m < LENGTH(solvers); m++) {
      const solver *f = solvers + m;
      screw s, back;
      ASSERT_STATUS(CHS_OK, f->solve(initial, final, tolerance, &s, T));
      FN(chs_se3_inverse)(T, expected);
      ASSERT_STATUS(CHS_OK, f->solve(final, initial, tolerance, &back, T));
      const scales by = scales_of(initial, final);
      const double sine = sin(turn_angle(&d.q) / 2);
      FN(chs_se3_to_parts)(expected, R, p);
      FN(chs_se3_to_parts)(T, R_back, p_back);
      ASSERT_ENTRIES_WITHIN_EPS(R, R_back, 9, 2 * f->rotation, by.kappa);
      /* The inverse adds the error of R^T p; |p| is at most 2 rho. */
      ASSERT_NORM_WITHIN_EPS(p, p_back, 3, 2 * f->position + 2 * 3 * f->rotation + 2 * CHS_EPS_SE3_INVERSE_TRANSLATION,
                             by.kappa * by.rho);
      scaled(-1, back.axis, 3, back.axis);
      ASSERT_NORM_WITHIN_EPS(s.axis, back.axis, 3, 2 * f->axis, by.kappa / sine);
      ASSERT_NORM_WITHIN_EPS(s.point, back.point, 3, 2 * f->point,
                             by.kappa * (by.rho / sine + by.travel / (sine * sine)));
      ASSERT_WITHIN_EPS(s.angle, back.angle, 2 * f->angle, by.kappa);
      ASSERT_WITHIN_EPS(s.translation, back.translation, 2 * f->translation, by.centers + by.kappa * by.travel / sine);
    }
  }
}

/* With G the change of frame, the displacement is G T G^-1. */
static void test_in_another_frame_the_displacement_is_conjugated(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5)), moved = d;
    real G[9], v[3], Gv[3];
    int shift[3] = {integer(-5, 5), integer(-5, 5), integer(-5, 5)};
    cube_rotation(k % CUBE_ROTATIONS, G);
    int *vectors[5] = {moved.x[0], moved.x[1], moved.x[2], moved.t, moved.q.v};
    for (int m = 0; m < 5; m++) {
      set(v, (real)vectors[m][0], (real)vectors[m][1], (real)vectors[m][2]);
      product_of(G, v, 3, 1, Gv);
      for (int i = 0; i < 3; i++) vectors[m][i] = (int)Gv[i];
    }
    for (int i = 0; i < 3; i++) { /* the points by nn shift, and so p by nn (I - R) shift */
      for (int m = 0; m < 3; m++) moved.x[m][i] += shift[i];
      moved.t[i] += moved.q.nn * shift[i];
      for (int j = 0; j < 3; j++) moved.t[i] -= turn_numerator(&moved.q, i, j) * shift[j];
    }
    assert_found(&d);
    assert_found(&moved);
  }
}

/* Points as they come, their images rounded: the pose that moved them is found by both. */
static void test_solvers_find_the_pose_that_moved_the_points(void) {
  for (int k = 0; k < CASES; k++) {
    real initial[9], final[9], T[16], R[9], p[3], expected[9], w[3], image[3], found[LENGTH(solvers)][16];
    double theta = k % 2 ? uniform(0.1, 3) : random_angle(k / 2);
    do random_vector(1, initial), random_vector(1, initial + 3), random_vector(1, initial + 6);
    while (scales_of(initial, initial).kappa > 5);
    random_vector(theta, w);
    FN(chs_so3_exp)(w, expected);
    random_vector(uniform(0, 2), p);
    FN(chs_se3_from_parts)(expected, p, T);
    for (int m = 0; m < 9; m += 3) FN(chs_se3_apply)(T, initial + m, final + m);
    const scales by = scales_of(initial, final);
    /* An image is off by delta: by apply, and because T is 3 CHS_EPS_SO3_EXP away from a rotation. Both ends of two
     * sides, and with them the plane, turn by 4 delta over the smallest height, kappa / longest side, at most. */
    real side[3];
    double longest = 0;
    for (int m = 0; m < 3; m++) {
      side_of(initial, m, side);
      longest = fmax(longest, length_of(side, 3));
    }
    double delta = CHS_EPS_SE3_APPLY * (sqrt(3) + length_of(p, 3)) + 3 * CHS_EPS_SO3_EXP;
    double turned = 4 * delta * by.kappa / longest;
    for (int m = 0; m < LENGTH(solvers); m++) {
      const solver *f = solvers + m;
      subject = f->name;
      screw s;
      TEST_ASSERT_GREATER_OR_EQUAL(0, f->solve(initial, final, tolerance, &s, found[m]));
      FN(chs_se3_to_parts)(found[m], R, p);
      ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, f->rotation * by.kappa + turned + 3 * CHS_EPS_SO3_EXP, 1);
      for (int n = 0; n < 9; n += 3) {
        FN(chs_se3_apply)(found[m], initial + n, image);
        double allowed = (f->position + 3 * f->rotation) * by.kappa * by.rho + turned + delta;
        ASSERT_NORM_WITHIN_EPS(final + n, image, 3, allowed + CHS_EPS_SE3_APPLY * (sqrt(3) + length_of(p, 3)), 1);
      }
    }
    ASSERT_ENTRIES_WITHIN_EPS(found[0], found[1], 16, 2 * (8 * by.kappa * fmax(1, by.rho) + turned + delta), 1);
  }
}

static void test_the_screw_is_that_of_the_pose(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(1, 5));
    real initial[9], final[9], T[16];
    points_of(&d, initial, final);
    for (int m = 0; m < LENGTH(solvers); m++) {
      const solver *f = solvers + m;
      screw s, of_pose;
      ASSERT_STATUS(CHS_OK, f->solve(initial, final, tolerance, &s, T));
      ASSERT_STATUS(CHS_OK, FN(chs_screw_from_pose)(T, &of_pose));
      const scales by = scales_of(initial, final);
      const double sine = sin(turn_angle(&d.q) / 2);
      /* The pose's entries are off by what they promise, and that is turned into errors of the screw. */
      double turned = CHS_EPS_SCREW_FROM_POSE_ANGLE * PI + 3 / sqrt(2) * f->rotation * by.kappa;
      ASSERT_WITHIN_EPS(s.angle, of_pose.angle, f->angle * by.kappa + turned, 1);
      ASSERT_NORM_WITHIN_EPS(s.axis, of_pose.axis, 3,
                             (f->axis * by.kappa + CHS_EPS_SCREW_FROM_POSE_AXIS + turned) / sine, 1);
    }
  }
}

static void test_pure_translations_are_exact(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(1);
    d.q = turn_of(1, 0, 0, 0);
    d.unit = ldexp(1, integer(PICK(-332, -40), PICK(332, 40)));
    real initial[9], final[9], expected[16], T[16], p[3];
    points_of(&d, initial, final);
    for (int i = 0; i < 3; i++) p[i] = rounded(d.unit * d.t[i]);
    FN(chs_se3_from_parts)(identity3, p, expected);
    for (int m = 0; m < LENGTH(solvers); m++) {
      screw s, of_pose;
      ASSERT_STATUS(CHS_PURE_TRANSLATION, solvers[m].solve(initial, final, tolerance, &s, T));
      for (int i = 0; i < 16; i++) TEST_ASSERT_TRUE(expected[i] == T[i]);
      ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_screw_from_pose)(T, &of_pose));
      ASSERT_SAME_BITS(of_pose.axis, s.axis, 8);
    }
  }
}

/* Sides whose ends were rounded have not turned. */
static void test_a_translation_that_rounding_disturbs_is_still_pure(void) {
  for (int k = 0; k < CASES; k++) {
    real initial[9], final[9], p[3], T[16];
    random_vector(log_uniform(0.1, 10), p);
    for (int m = 0; m < 9; m += 3) random_vector(1, initial + m);
    if (scales_of(initial, initial).kappa > 100) continue;
    for (int i = 0; i < 9; i++) final[i] = initial[i] + p[i % 3];
    for (int m = 0; m < LENGTH(solvers); m++) {
      screw s;
      subject = solvers[m].name;
      ASSERT_STATUS(CHS_PURE_TRANSLATION, solvers[m].solve(initial, final, tolerance, &s, T));
      TEST_ASSERT_TRUE(s.angle == 0 && T[0] == 1 && T[1] == 0);
    }
  }
}

static void test_no_motion_is_the_identity(void) {
  const screw expected = {{0, 0, 1}, {0, 0, 0}, 0, 0};
  for (int k = 0; k < CASES; k++) {
    real points[9], T[16];
    double scale = log_uniform(PICK(1e-100, 1e-12), PICK(1e100, 1e12));
    for (int m = 0; m < 9; m += 3) random_vector(scale, points + m);
    if (scales_of(points, points).kappa > 100) continue;
    for (int m = 0; m < LENGTH(solvers); m++) {
      screw s;
      ASSERT_STATUS(CHS_NO_MOTION, solvers[m].solve(points, points, 0, &s, T));
      ASSERT_SAME_BITS(identity4, T, 16);
      ASSERT_SAME_BITS(expected.axis, s.axis, 8);
    }
  }
}

/* A body at rest, one coordinate of which is off by far more than rounding and less than the tolerance: the answer
 * takes every point to where it is, but for a few times as much. */
static void test_a_body_at_rest_with_one_coordinate_off_has_not_moved_far(void) {
  const real triangles[][9] = {{0, 0, 0, 4, 0, 0, 0, 4, 0},
                               {K(0.3), K(0.1), K(0.2), K(4.1), K(0.7), K(0.4), K(0.5), K(3.9), K(1.1)}};
  const real off = K(0.001);
  for (int n = 0; n < LENGTH(triangles); n++)
    for (int k = 0; k < 18; k++)
      for (int m = 0; m < LENGTH(solvers); m++) {
        real final[9], T[16], image[3];
        char name[64];
        snprintf(name, sizeof name, "%s, triangle %d, coordinate %d", solvers[m].name, n, k / 2);
        subject = name;
        memcpy(final, triangles[n], sizeof final);
        final[k / 2] += k % 2 ? off : -off;
        TEST_ASSERT_GREATER_OR_EQUAL_MESSAGE(0, solvers[m].solve(triangles[n], final, K(0.01), NULL, T), name);
        for (int i = 0; i < 9; i += 3) {
          FN(chs_se3_apply)(T, triangles[n] + i, image);
          ASSERT_NORM_WITHIN_EPS(final + i, image, 3, 100 * (double)off / EPS, 1);
        }
        subject = "";
      }
}

/* The rotation read from such points is the identity to the last bit, although no side has stayed as it was. */
static void test_laub_shiflett_sees_growth_without_rotation_as_a_translation(void) {
  const real initial[9] = {0, 0, 0, 4, 0, 0, 1, 2, 0}, final[9] = {0, 0, 0, 5, 0, 0, K(1.25), K(2.5), 0};
  real T[16], R[9], p[3];
  screw s;
  ASSERT_STATUS(CHS_PURE_TRANSLATION, FN(chs_motion_laub_shiflett)(initial, final, K(0.5), &s, T));
  FN(chs_se3_to_parts)(T, R, p);
  ASSERT_SAME_BITS(identity3, R, 9);
  TEST_ASSERT_TRUE(s.angle == 0);
}

/* A flat triangle whose middle point is all but on the longest side, and an axis near that side: what a pair of a side
 * and the plane's normal, or of two sides, tells about the rotation is worth k^1.5 or k^2 there. */
static void test_solvers_lose_no_more_on_flat_triangles_that_turn_near_their_longest_side(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d;
    do {
      int along[3] = {integer(-9, 9), integer(-9, 9), 10}, length = PICK(1000, 10);
      d.unit = 1;
      for (int i = 0; i < 3; i++) {
        d.x[0][i] = 0;
        d.x[1][i] = 2 * length * along[i];
        d.x[2][i] = length * along[i] + integer(-2, 2);
        d.t[i] = integer(-300, 300);
        d.q.v[i] = along[i] + integer(-2, 2);
      }
      d.q = turn_of(integer(1, 40), d.q.v[0], d.q.v[1], d.q.v[2]);
    } while (collinear(&d) || condition_of(&d) > PICK(1e6, 1e2));
    assert_found(&d);
  }
}

static void test_solvers_find_turns_about_coordinate_axes_of_triangles_in_coordinate_planes(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    int v[3] = {0, 0, 0};
    v[k % 3] = integer(1, 5);
    d.q = turn_of(d.q.w, v[0], v[1], v[2]);
    for (int m = 0; m < 3; m++) d.x[m][(k / 3) % 3] = 7;
    if (!collinear(&d) && condition_of(&d) < 20) assert_found(&d);
  }
}

/* With noise of a known size, in the coordinates of both positions. */
static void add_noise(double size, real points[9]) {
  for (int i = 0; i < 9; i++) points[i] = rounded((double)points[i] + uniform(-size, size));
}

static double sum_of_squares(const real T[16], const real initial[9], const real final[9]) {
  double sum = 0;
  for (int m = 0; m < 9; m += 3)
    for (int i = 0; i < 3; i++) {
      double image = (double)T[4 * i + 3];
      for (int j = 0; j < 3; j++) image += (double)T[4 * i + j] * (double)initial[m + j];
      sum += pow(image - (double) final[m + i], 2);
    }
  return sum;
}

/* No other turn about the centroid, by a little in any direction, leaves less. */
static void test_spoor_veldpaus_leaves_the_least_sum_of_squares(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    real initial[9], final[9], T[16], turned[16], R[9], p[3], w[3], W[9], center[3];
    points_of(&d, initial, final);
    const double size = length_of(initial, 9);
    add_noise(0.01 * size, final);
    if (FN(chs_motion_spoor_veldpaus)(initial, final, 1, NULL, T) < 0) continue;
    const double least = sum_of_squares(T, initial, final);
    FN(chs_se3_to_parts)(T, R, p);
    for (int i = 0; i < 3; i++)
      center[i] = rounded(((double) final[i] + (double) final[3 + i] + (double) final[6 + i]) / 3);
    for (int i = 0; i < 6; i++) {
      set(w, 0, 0, 0);
      w[i / 2] = rounded(i % 2 ? 0.01 : -0.01);
      FN(chs_so3_exp)(w, W);
      product_of(W, R, 3, 3, turned);
      real moved[9], offset[3], shift[3];
      memcpy(moved, turned, sizeof moved);
      for (int j = 0; j < 3; j++) offset[j] = rounded((double)p[j] - (double)center[j]);
      product_of(W, offset, 3, 1, shift);
      for (int j = 0; j < 3; j++) shift[j] = rounded((double)shift[j] + (double)center[j]);
      FN(chs_se3_from_parts)(moved, shift, turned);
      TEST_ASSERT_TRUE(sum_of_squares(turned, initial, final) > least);
    }
  }
}

static void test_equal_moments_leave_angeles_the_turn_that_fits_best(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(1, 5));
    for (int m = 0; m < 3; m++)
      for (int i = 0; i < 3; i++) d.x[m][i] = 5 * (m == i);
    real initial[9], final[9], T[16], expected[16];
    points_of(&d, initial, final);
    add_noise(0.01 * length_of(initial, 3), final);
    ASSERT_STATUS(CHS_OK, FN(chs_motion_spoor_veldpaus)(initial, final, K(0.1), NULL, expected));
    ASSERT_STATUS(CHS_OK, FN(chs_motion_angeles)(initial, final, K(0.1), NULL, T));
    ASSERT_SAME_BITS(expected, T, 16);
  }
}

/* Noise of a thousandth of the triangle moves no solver's answer by more than its condition number times that, or four
 * times where Bottema & Roth have the axis at 14.5 degrees to the plane. */
static void test_noise_is_not_magnified_beyond_the_condition_number(void) {
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    real initial[9], final[9], T[16], R[9], p[3], expected[9];
    points_of(&d, initial, final);
    const double kappa = scales_of(initial, final).kappa;
    real side[3];
    double longest = 0;
    for (int m = 0; m < 3; m++) {
      side_of(initial, m, side);
      longest = fmax(longest, length_of(side, 3));
    }
    add_noise(0.001 * longest, initial);
    add_noise(0.001 * longest, final);
    turn_matrix(&d.q, expected);
    for (int m = 0; m < LENGTH(solvers); m++) {
      subject = solvers[m].name;
      TEST_ASSERT_GREATER_OR_EQUAL(0, solvers[m].solve(initial, final, K(0.02), NULL, T));
      FN(chs_se3_to_parts)(T, R, p);
      ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, 32 * 0.001 / EPS, kappa);
    }
  }
}

static void test_the_order_of_bottema_roth_is_that_of_the_side_that_turns_most(void) {
  /* A quarter turn about z; the sides from point 0, 1 and 2 turn by their part in the plane. */
  const struct {
    int order;
    real initial[9], final[9];
  } cases[] = {
      {0, {0, 0, 0, 4, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 4, 0, -1, 1, 1}},
      {1, {1, 1, 1, 0, 0, 0, 4, 0, 0}, {-1, 1, 1, 0, 0, 0, 0, 4, 0}},
      {2, {4, 0, 0, 1, 1, 1, 0, 0, 0}, {0, 4, 0, -1, 1, 1, 0, 0, 0}},
      {-1, {0, 0, 0, 0, 0, 4, 1, 0, 0}, {0, 0, 0, 0, 0, 4, 0, 1, 0}}, /* the axis lies in the plane */
      {-1, {0, 0, 0, 4, 0, 0, 4, 1, 1}, {0, 0, 1, 4, 0, 1, 4, 1, 2}}, /* no rotation */
  };
  for (int k = 0; k < LENGTH(cases); k++) {
    int order = 7;
    TEST_ASSERT_GREATER_OR_EQUAL(
        0, FN(chs_motion_bottema_roth_order)(cases[k].initial, cases[k].final, tolerance, &order));
    TEST_ASSERT_EQUAL_INT(cases[k].order, order);
  }
  int order = 7;
  ASSERT_STATUS(CHS_ERR_NOT_RIGID,
                FN(chs_motion_bottema_roth_order)(cases[0].initial, cases[3].final, tolerance, &order));
  TEST_ASSERT_EQUAL_INT(7, order);
}

/* The figures by which motion.h recommends a method: independent errors of a thousandth of the longest side in every
 * coordinate, k <= 4, angles up to 3. */
static void test_measuring_errors_disturb_the_methods_as_documented(void) {
  const double documented[LENGTH(solvers)] = {1.95, 1.16, 1.12, 1, 1.19}; /* in the order of solvers[] */
  double sum[LENGTH(solvers)] = {0};
  for (int k = 0; k < 100 * CASES; k++) {
    real initial[9], final[9], w[3], R[9], p[3], T[16], angle;
    do
      for (int m = 0; m < 9; m++) initial[m] = (real)(uniform(-1, 1) + uniform(-1, 1) + uniform(-1, 1));
    while (scales_of(initial, initial).kappa > 4);
    real side[3];
    double longest = 0;
    for (int m = 0; m < 3; m++) {
      side_of(initial, m, side);
      longest = fmax(longest, length_of(side, 3));
    }
    random_vector(uniform(0, 3), w);
    random_vector(1, p);
    FN(chs_so3_exp)(w, R);
    FN(chs_se3_from_parts)(R, p, T);
    for (int m = 0; m < 9; m += 3) FN(chs_se3_apply)(T, initial + m, final + m);
    add_noise(0.001 * longest, initial);
    add_noise(0.001 * longest, final);
    for (int m = 0; m < LENGTH(solvers); m++) {
      real found[9];
      TEST_ASSERT_GREATER_OR_EQUAL(0, solvers[m].solve(initial, final, K(0.1), NULL, T));
      FN(chs_se3_to_parts)(T, found, p);
      FN(chs_so3_angle)(R, found, &angle);
      sum[m] += (double)angle * (double)angle;
    }
  }
  for (int m = 0; m < LENGTH(solvers); m++) {
    char name[80];
    snprintf(name, sizeof name, "%s: %.3f", solvers[m].name, sqrt(sum[m] / sum[3]));
    TEST_ASSERT_TRUE_MESSAGE(fabs(sqrt(sum[m] / sum[3]) - documented[m]) < 0.05 * documented[m], name);
  }
}

static void test_methods_by_their_number(void) {
  static const struct {
    chs_motion_method method;
    int (*solve)(const real initial[9], const real final[9], real tolerance, screw *s, real T[16]);
  } methods[] = {
      {CHS_MOTION_DEFAULT, FN(chs_motion_spoor_veldpaus)},
      {CHS_MOTION_ANGELES, FN(chs_motion_angeles)},
      {CHS_MOTION_LAUB_SHIFLETT, FN(chs_motion_laub_shiflett)},
      {CHS_MOTION_BOTTEMA_ROTH, FN(chs_motion_bottema_roth)},
      {CHS_MOTION_SPOOR_VELDPAUS, FN(chs_motion_spoor_veldpaus)},
      {CHS_MOTION_BEGGS, FN(chs_motion_beggs)},
  };
  for (int k = 0; k < CASES; k++) {
    displacement d = random_displacement(integer(0, 5));
    real initial[9], final[9], T[16], expected_T[16];
    points_of(&d, initial, final);
    add_noise(0.01 * length_of(initial, 9), final);
    for (int m = 0; m < LENGTH(methods); m++) {
      screw s, expected;
      memset(&s, 0, sizeof s);
      memset(&expected, 0, sizeof expected);
      memset(T, 0, sizeof T);
      memset(expected_T, 0, sizeof expected_T);
      ASSERT_STATUS(methods[m].solve(initial, final, K(0.1), &expected, expected_T),
                    FN(chs_motion_from_three)(methods[m].method, initial, final, K(0.1), &s, T));
      ASSERT_SAME_BITS(expected_T, T, 16);
      ASSERT_SAME_BITS(expected.axis, s.axis, 8);
    }
  }
}

static void test_a_method_that_is_none_is_refused(void) {
  const real points[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const int none[] = {6, 7, 100};
  for (int k = 0; k < LENGTH(none); k++) {
    struct {
      screw s;
      real T[16];
    } out;
    ASSERT_REFUSES(CHS_ERR_ARGUMENT, out,
                   FN(chs_motion_from_three)((chs_motion_method)none[k], points, points, tolerance, &out.s, out.T));
  }
}

static void test_outputs_may_be_left_out(void) {
  displacement turning = random_displacement(2), sliding = random_displacement(1);
  sliding.q = turn_of(1, 0, 0, 0);
  const displacement *both[2] = {&turning, &sliding};
  for (int k = 0; k < 2; k++)
    for (int m = 0; m < LENGTH(solvers); m++) {
      real initial[9], final[9], T[16], only_T[16];
      screw s, only_s;
      points_of(both[k], initial, final);
      int status = solvers[m].solve(initial, final, tolerance, &s, T);
      ASSERT_STATUS(status, solvers[m].solve(initial, final, tolerance, NULL, only_T));
      ASSERT_STATUS(status, solvers[m].solve(initial, final, tolerance, &only_s, NULL));
      ASSERT_STATUS(status, solvers[m].solve(initial, final, tolerance, NULL, NULL));
      ASSERT_SAME_BITS(T, only_T, 16);
      ASSERT_SAME_BITS(s.axis, only_s.axis, 8);
    }
}

static void assert_all_refuse(int status, const real initial[9], const real final[9], real allowed) {
  for (int m = 0; m < LENGTH(solvers); m++) {
    struct {
      screw s;
      real T[16];
    } out;
    subject = solvers[m].name;
    ASSERT_REFUSES(status, out, solvers[m].solve(initial, final, allowed, &out.s, out.T));
  }
}

static void test_degenerate_triangles_are_refused_wherever_they_are(void) {
  const real good[9] = {1, 0, 0, 0, 2, 0, 0, 0, 1};
  const struct {
    int status;
    real points[9];
  } bad[] = {
      {CHS_ERR_COINCIDENT, {1, 2, 3, 1, 2, 3, 0, 0, 1}},
      {CHS_ERR_COINCIDENT, {0, 0, 1, 1, 2, 3, 1, 2, 3}},
      {CHS_ERR_COINCIDENT, {1, 2, 3, 0, 0, 1, 1, 2, 3}},
      {CHS_ERR_COINCIDENT, {1, 2, 3, 1, 2, 3, 1, 2, 3}},
      {CHS_ERR_COINCIDENT, {0}},
      {CHS_ERR_COLLINEAR, {0, 0, 0, 1, 2, 3, 2, 4, 6}},
      {CHS_ERR_COLLINEAR, {1, 2, 3, -1, 2, 3, 9, 2, 3}},
      {CHS_ERR_COLLINEAR, {3, 6, 9, 1, 2, 3, 2, 4, 6}},
  };
  const real scale_list[] = {1, PICK(0x1p300, 0x1p40F), PICK(0x1p-300, 0x1p-40F)};
  for (int k = 0; k < LENGTH(bad); k++)
    for (int n = 0; n < LENGTH(scale_list); n++) {
      real points[9], other[9];
      scaled((double)scale_list[n], bad[k].points, 9, points);
      scaled((double)scale_list[n], good, 9, other);
      assert_all_refuse(bad[k].status, points, points, tolerance);
      assert_all_refuse(bad[k].status, points, other, tolerance);
      assert_all_refuse(bad[k].status, other, points, tolerance);
    }
}

static void test_the_worst_of_several_faults_is_named(void) {
  const real coincident[9] = {1, 2, 3, 1, 2, 3, 0, 0, 1}, collinear[9] = {0, 0, 0, 1, 2, 3, 2, 4, 6};
  assert_all_refuse(CHS_ERR_COINCIDENT, coincident, collinear, tolerance);
  assert_all_refuse(CHS_ERR_COLLINEAR, collinear, coincident, tolerance);
}

/* A quarter turn about z; two sides grow, their squares by 4.25, and the square of the longest is 32. */
static void test_sides_may_differ_by_the_tolerance_and_no_more(void) {
  const real initial[9] = {0, 0, 0, 4, 0, 0, 0, 4, 0}, final[9] = {0, 0, 0, 0, K(4.5), 0, -4, 0, 0};
  const real allowed = K(4.25) / (2 * 32);
  for (int m = 0; m < LENGTH(solvers); m++) {
    screw s;
    subject = solvers[m].name;
    ASSERT_STATUS(CHS_OK, solvers[m].solve(initial, final, allowed, &s, NULL));
  }
  assert_all_refuse(CHS_ERR_NOT_RIGID, initial, final, NEXT_AFTER(allowed, 0));
  assert_all_refuse(CHS_ERR_NOT_RIGID, initial, final, 0);
  assert_all_refuse(CHS_ERR_NOT_RIGID, initial, final, (real)NAN);
}

static void test_each_side_counts_against_the_tolerance(void) {
  const real initial[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  for (int k = 0; k < 9; k++)
    for (int sign = -1; sign <= 1; sign += 2) {
      real final[9];
      memcpy(final, initial, sizeof final);
      final[k] += K(0.25) * (real)sign;
      assert_all_refuse(CHS_ERR_NOT_RIGID, initial, final, tolerance);
      assert_all_refuse(CHS_ERR_NOT_RIGID, final, initial, tolerance);
    }
}

static void test_points_too_far_apart_are_an_overflow(void) {
  const real initial[9] = {REAL_MAX, 0, 0, -REAL_MAX, 0, 0, 0, 1, 0};
  const real there[9] = {REAL_MAX, 0, 0, REAL_MAX / 2, 0, 0, REAL_MAX, REAL_MAX / 2, 0};
  real back[9];
  scaled(-1, there, 6, back);
  for (int i = 6; i < 9; i++) back[i] = -there[i];
  assert_all_refuse(CHS_ERR_OVERFLOW, initial, initial, tolerance);
  assert_all_refuse(CHS_ERR_OVERFLOW, there, back, tolerance);

  /* A third of a turn about (1, 1, 1), and a way along it that is longer than any of its coordinates. */
  const real near = K(0.45) * REAL_MAX, off = K(0.05) * REAL_MAX;
  const real low[9] = {-near, -near, -near, off - near, -near, -near, -near, off - near, -near};
  const real high[9] = {near, near, near, near, off + near, near, near, near, off + near};
  assert_all_refuse(CHS_ERR_OVERFLOW, low, high, tolerance);
}

static void test_triangles_that_lose_half_of_the_digits_are_called_ill_conditioned(void) {
  const long lengths[] = {PICK(1L << 24, 1L << 10), PICK(1L << 28, 1L << 13)};
  for (int k = 0; k < 2; k++)
    for (int m = 0; m < LENGTH(solvers); m++) {
      const real length = (real)lengths[k];
      const real initial[9] = {0, 0, 0, length, 0, 0, length / 2, 1, 0};
      const real final[9] = {0, 0, 0, 0, length, 0, -1, length / 2, 0}; /* a quarter turn about z */
      real T[16], R[9], p[3], expected[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
      screw s;
      ASSERT_STATUS(k == 0 ? CHS_OK : CHS_ILL_CONDITIONED, solvers[m].solve(initial, final, tolerance, &s, T));
      FN(chs_se3_to_parts)(T, R, p);
      ASSERT_ENTRIES_WITHIN_EPS(expected, R, 9, solvers[m].rotation, length);
    }
}

/* Fenton & Shi 1990, equations A1 and A2, whose columns are the points, and A3: the screw that they were made with. */
static void test_worked_example_of_fenton_and_shi(void) {
  const real initial[9] = {K(3.51542), K(0.48235), K(3.43593), K(3.18322), K(0.69586),
                           K(1.23011), K(1.66537), K(2.29896), K(0.97893)};
  const real final[9] = {K(3.44738), K(2.94288), K(5.02296), K(2.99723), K(2.91118),
                         K(2.82798), K(0.78293), K(2.91222), K(2.64402)};
  const screw expected = {{K(0.04864213), K(0.02074652), K(0.99860078)},
                          {K(0.46231923), K(1.45288157), K(-0.05270418)},
                          K(1.63255501),
                          K(0.81610703)};
  const double relative = 5e-5 / EPS;
  for (int m = 0; m < LENGTH(solvers); m++) {
    screw s;
    ASSERT_STATUS(CHS_OK, solvers[m].solve(initial, final, tolerance, &s, NULL));
    ASSERT_NORM_WITHIN_EPS(expected.axis, s.axis, 3, relative, 1);
    ASSERT_NORM_WITHIN_EPS(expected.point, s.point, 3, relative, length_of(expected.point, 3));
    ASSERT_WITHIN_EPS(expected.translation, s.translation, relative, expected.translation);
    ASSERT_WITHIN_EPS(expected.angle, s.angle, relative, expected.angle);
  }
}

int main(void) {
  SUITE_BEGIN();
  RUN_CONTRACT_TESTS();
  RUN_TEST(test_solvers_find_rotations_of_every_size);
  RUN_TEST(test_solvers_find_half_turns_with_a_positive_first_component);
  RUN_TEST(test_rotations_within_their_error_of_a_half_turn_count_as_one);
  RUN_TEST(test_rotations_beyond_their_error_of_a_half_turn_are_none);
  RUN_TEST(test_solvers_find_a_rotation_about_the_line_through_two_points);
  RUN_TEST(test_solvers_find_an_axis_parallel_to_the_plane_of_the_points);
  RUN_TEST(test_solvers_do_not_mind_the_origin_in_the_plane_of_the_points);
  RUN_TEST(test_solvers_lose_no_more_than_the_condition_number_on_thin_triangles);
  RUN_TEST(test_solvers_work_far_from_the_origin);
  RUN_TEST(test_scaling_by_a_power_of_two_scales_the_lengths_and_nothing_else);
  RUN_TEST(test_a_translation_added_leaves_the_rotation_as_it_is);
  RUN_TEST(test_the_order_of_the_points_does_not_matter);
  RUN_TEST(test_backwards_is_the_inverse);
  RUN_TEST(test_in_another_frame_the_displacement_is_conjugated);
  RUN_TEST(test_solvers_find_the_pose_that_moved_the_points);
  RUN_TEST(test_the_screw_is_that_of_the_pose);
  RUN_TEST(test_pure_translations_are_exact);
  RUN_TEST(test_a_translation_that_rounding_disturbs_is_still_pure);
  RUN_TEST(test_no_motion_is_the_identity);
  RUN_TEST(test_a_body_at_rest_with_one_coordinate_off_has_not_moved_far);
  RUN_TEST(test_laub_shiflett_sees_growth_without_rotation_as_a_translation);
  RUN_TEST(test_solvers_lose_no_more_on_flat_triangles_that_turn_near_their_longest_side);
  RUN_TEST(test_solvers_find_turns_about_coordinate_axes_of_triangles_in_coordinate_planes);
  RUN_TEST(test_spoor_veldpaus_leaves_the_least_sum_of_squares);
  RUN_TEST(test_equal_moments_leave_angeles_the_turn_that_fits_best);
  RUN_TEST(test_noise_is_not_magnified_beyond_the_condition_number);
  RUN_TEST(test_the_order_of_bottema_roth_is_that_of_the_side_that_turns_most);
  RUN_TEST(test_measuring_errors_disturb_the_methods_as_documented);
  RUN_TEST(test_methods_by_their_number);
  RUN_TEST(test_a_method_that_is_none_is_refused);
  RUN_TEST(test_outputs_may_be_left_out);
  RUN_TEST(test_degenerate_triangles_are_refused_wherever_they_are);
  RUN_TEST(test_the_worst_of_several_faults_is_named);
  RUN_TEST(test_sides_may_differ_by_the_tolerance_and_no_more);
  RUN_TEST(test_each_side_counts_against_the_tolerance);
  RUN_TEST(test_points_too_far_apart_are_an_overflow);
  RUN_TEST(test_triangles_that_lose_half_of_the_digits_are_called_ill_conditioned);
  RUN_TEST(test_worked_example_of_fenton_and_shi);
  return SUITE_END();
}
