#include <chasles/motion.h>

#include "motion_private.h"

/* Two triangles: the side a from the first point to the second and c from the third to the first, before and after. */
typedef struct triangles {
  real a[3], c[3], af[3], cf[3];
  real center[3]; /* centroid of the initial points */
  real travel[3]; /* displacement of the centroid */
  /* Sums over the sides: of their squares before, the same and after, and of how much each square changed. */
  real before, span, strain;
  real area, area_after; /* squares of twice the areas, good to 4 eps span^2 */
  real reach;            /* a third of it is at least the square of the largest coordinate */
} triangles;

/* What a closer look tells. The sides are divided by a power of two near the longest, so that products of any degree
 * fit, and these with them. */
typedef struct examination {
  int examined;
  real longest; /* length of the longest initial side */
  real doubled; /* twice the initial triangle's area */
  real turned;  /* the largest change of a side's component */
  real noise;   /* the rounding of the coordinates: how far a side is uncertain */
} examination;

/* Sums of squares between which products of eight lengths neither overflow nor underflow. */
#ifdef CHS_SINGLE
#define SPAN_LEAST 0x1p-20F
#define REACH_MOST 0x1p+28F
#else
#define SPAN_LEAST 0x1p-200
#define REACH_MOST 0x1p+200
#endif

static INLINE void read_sides(const real initial[9], const real final[9], triangles *t) {
  subtract(initial + 3, initial, t->a);
  subtract(initial, initial + 6, t->c);
  subtract(final + 3, final, t->af);
  subtract(final, final + 6, t->cf);
}

/* The mean of o, o + a and o - c, given the difference of a and c. */
static INLINE void mean(const real o[3], const real a[3], const real c[3], real m[3]) {
  const real third = K(1.0) / K(3.0);
  m[0] = o[0] + third * (a[0] - c[0]);
  m[1] = o[1] + third * (a[1] - c[1]);
  m[2] = o[2] + third * (a[2] - c[2]);
}

static INLINE void read_centers(const real initial[9], const real final[9], triangles *t) {
  real moved[3], da[3], dc[3];
  subtract(final, initial, moved);
  subtract(t->af, t->a, da);
  subtract(t->cf, t->c, dc);
  mean(initial, t->a, t->c, t->center);
  mean(moved, da, dc, t->travel);
  t->reach = t->span + (dot(t->center, t->center) + dot(t->travel, t->travel));
}

static INLINE void measure(triangles *t) {
  real aa = dot(t->a, t->a), cc = dot(t->c, t->c), ac = dot(t->a, t->c);
  real ff = dot(t->af, t->af), gg = dot(t->cf, t->cf), fg = dot(t->af, t->cf);
  real da = ff - aa, dc = gg - cc, db = (da + dc) + K(2.0) * (fg - ac);
  t->before = K(2.0) * (aa + cc + ac);
  t->span = t->before + K(2.0) * (ff + gg + fg);
  t->strain = ABS(da) + ABS(db) + ABS(dc);
  t->area = aa * cc - ac * ac;
  t->area_after = ff * gg - fg * fg;
}

static void look_at(const real initial[9], const real final[9], triangles *t) {
  read_sides(initial, final, t);
  measure(t);
  read_centers(initial, final, t);
}

/* Far enough from lines, and near enough to the origin, for rounding to be out of the question. */
static INLINE int well_shaped(const triangles *t) {
  real least = K(64.0) * EPS * (t->span * t->span);
  return (t->area >= least) & (t->area_after >= least) & (t->span >= K(4.0) * EPS * t->reach);
}

/* Enough to be certain, at a glance, that examine() would find nothing wrong. NaN fails. */
static INLINE int ordinary(const triangles *t, real tolerance) {
  return well_shaped(t) & (t->reach <= REACH_MOST) & (t->span >= SPAN_LEAST) &
         (t->strain <= K(2.0) / K(3.0) * tolerance * t->before);
}

/* Enough to be certain that the rotation is neither none nor a half-turn, nor near enough to either to ask. */
static INLINE int plain(const triangles *t, const quaternion *q) {
  real vv = dot(q->v, q->v), ww = q->w * q->w;
  real zone = K(64.0) * EPS * EPS * (t->span * t->span);
  return (vv * (t->span * t->area) > zone * t->reach * (vv + ww)) & (ww * t->area > zone * vv);
}

static inline real larger(real a, real b) { return a > b ? a : b; }

/* Points too near to each other or to a line for their rounding errors to be told from their positions. */
static int shape_status(const real squared[3], real doubled, real noise) {
  real longest_squared = largest(squared, 3);
  for (int k = 0; k < 3; k++)
    if (squared[k] <= noise * noise) return CHS_ERR_COINCIDENT;
  real height_noise = K(2.0) * noise;
  return doubled * doubled <= longest_squared * (height_noise * height_noise) ? CHS_ERR_COLLINEAR : CHS_OK;
}

static real doubled_area(const real a[3], const real c[3]) {
  real normal[3];
  cross(a, c, normal);
  return norm(normal, 3);
}

/* The slow and careful look at two triangles: what is wrong with them, and their sides to scale. */
static SELDOM int examine(const real initial[9], const real final[9], real tolerance, triangles *t, examination *x) {
  int status = first_error(finiteness(initial, 9), finiteness(final, 9));
  if (status != CHS_OK) return status;
  /* Sides 0 to 2 before, 3 to 5 after. */
  real sides[18], squared[6];
  subtract(initial + 3, initial, sides);
  subtract(initial, initial + 6, sides + 3);
  subtract(initial + 6, initial + 3, sides + 6);
  subtract(final + 3, final, sides + 9);
  subtract(final, final + 6, sides + 12);
  subtract(final + 6, final + 3, sides + 15);
  real reach = larger(largest(initial, 9), largest(final, 9)), most = largest(sides, 18);
  if (!is_finite(most)) return CHS_ERR_OVERFLOW;
  if (most == 0) return CHS_ERR_COINCIDENT;
  /* Two factors, since one alone may be beyond the format. */
  real enlarge = safe_to_square(most), scale = K(1.0) / power_of_two_below(enlarge * most);
  x->examined = 1;
  x->noise = K(4.0) * EPS * (scale * (enlarge * reach));
  x->turned = 0;
  for (int k = 0; k < 18; k++) sides[k] = scale * (enlarge * sides[k]);
  for (int k = 0; k < 9; k++) x->turned = larger(x->turned, ABS(sides[9 + k] - sides[k]));
  for (int k = 0; k < 6; k++) squared[k] = dot(sides + 3 * k, sides + 3 * k);
  copy(sides, 3, t->a);
  copy(sides + 3, 3, t->c);
  copy(sides + 9, 3, t->af);
  copy(sides + 12, 3, t->cf);
  real center[3], travel[3];
  for (int i = 0; i < 3; i++) {
    center[i] = scale * (enlarge * t->center[i]);
    travel[i] = scale * (enlarge * t->travel[i]);
  }
  measure(t);
  t->reach = t->span + (dot(center, center) + dot(travel, travel));
  real longest_squared = largest(squared, 3);
  x->longest = SQRT(longest_squared);
  x->doubled = doubled_area(t->a, t->c);
  status = shape_status(squared, x->doubled, x->noise);
  if (status == CHS_OK) status = shape_status(squared + 3, doubled_area(t->af, t->cf), x->noise);
  if (status != CHS_OK) return status;
  for (int k = 0; k < 3; k++)
    if (!(ABS(squared[3 + k] - squared[k]) <= K(2.0) * tolerance * longest_squared)) return CHS_ERR_NOT_RIGID;
  return CHS_OK;
}

static int read_triangles(const real initial[9], const real final[9], real tolerance, triangles *t, examination *x) {
  x->examined = 0;
  look_at(initial, final, t);
  return ordinary(t, tolerance) ? CHS_OK : examine(initial, final, tolerance, t, x);
}

/* The screw of q = (v; w), n = |v|, turned so that w is not negative where sign has its sign. */
static INLINE void write_screw(const triangles *t, const quaternion *q, real n, real sign, screw *out) {
  real w = sign * q->w;
  screw_through(t->center, t->travel, q->v, sign / n, w / n, out);
  out->angle = K(2.0) * FN(chs_p_angle_of)(n, w > 0 ? w : K(0.0)); /* a half-turn may be a hair beyond pi */
}

static INLINE void write_pose(const triangles *t, const quaternion *q, real nn, real T[16]) {
  real R[9], p[3];
  rotation_from_quaternion(q, nn, R);
  rotate(R, t->center, p);
  subtract(t->center, p, p);
  add_to(p, t->travel);
  join(R, p, T);
}

static const real sign_of[2] = {1, -1}; /* looked up, for a branch would be a coin's toss */

static INLINE void write_plain(const triangles *t, const quaternion *q, screw *out, real T[16]) {
  real vv = dot(q->v, q->v), ww = q->w * q->w;
  if (out) write_screw(t, q, SQRT(vv), sign_of[q->w < 0], out);
  if (T) write_pose(t, q, vv + ww, T);
}

int FN(chs_p_finish_translation)(const real travel[3], screw *out, real T[16]) {
  static const real identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  screw s;
  int status = screw_of_translation(travel, &s);
  if (!is_finite(s.translation)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (T) join(identity, travel, T);
  return status;
}

/* What all methods do once the rotation is known: the screw, the pose, and what is special about them. */
static int finish(const real initial[9], const real final[9], real tolerance, triangles *t, examination *x,
                  quaternion *q, screw *out, real T[16]) {
  real vv = dot(q->v, q->v), ww = q->w * q->w, n = SQRT(vv);
  if (!x->examined) {
    if (plain(t, q)) {
      write_plain(t, q, out, T);
      return CHS_OK;
    }
    int status = examine(initial, final, tolerance, t, x);
    if (status != CHS_OK) return status;
  }
  if (x->turned <= x->noise || n == 0) return FN(chs_p_finish_translation)(t->travel, out, T);
  if (q->w < 0) negate(q);
  real condition = x->longest * x->longest / x->doubled, zone = K(8.0) * EPS * condition;
  int half_turn = q->w <= zone * n;
  settle_half_turn(q, zone, n);
  screw s;
  real pose[16];
  write_screw(t, q, n, 1, &s);
  write_pose(t, q, vv + ww, pose);
  if (!all_finite(s.point, 3) || !all_finite(pose, 12)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (T) copy(pose, 16, T);
  if (condition * SQRT(EPS) > K(1.0)) return CHS_ILL_CONDITIONED;
  return half_turn ? CHS_HALF_TURN : CHS_OK;
}

/* The dual basis of the sides a and c before, and the unit normal's share: with N = a x c, that is c x N, N x a and N,
 * all over N.N. */
static INLINE void dual_basis(const triangles *t, real a[3], real c[3], real n[3]) {
  cross(t->a, t->c, n);
  cross(t->c, n, a);
  cross(n, t->a, c);
  real scale = K(1.0) / dot(n, n);
  multiply_by(scale, a);
  multiply_by(scale, c);
  multiply_by(scale, n);
}

/* R = x a^T + y c^T + z n^T. */
static INLINE void sum_of_products(const real x[3], const real a[3], const real y[3], const real c[3], const real z[3],
                                   const real n[3], real R[9]) {
  for (int i = 0; i < 3; i++) {
    R[3 * i] = x[i] * a[0] + y[i] * c[0] + z[i] * n[0];
    R[3 * i + 1] = x[i] * a[1] + y[i] * c[1] + z[i] * n[1];
    R[3 * i + 2] = x[i] * a[2] + y[i] * c[2] + z[i] * n[2];
  }
}

/* Eq. 12 and 13 with both origins moved along the normal of the points' plane: Q takes the sides to what they became,
 * and its cofactors take the normal a x c to af x cf. */
static INLINE void laub_shiflett(const triangles *t, quaternion *q) {
  real a[3], c[3], n[3], Nf[3], R[9];
  dual_basis(t, a, c, n);
  cross(t->af, t->cf, Nf);
  sum_of_products(t->af, a, t->cf, c, Nf, n, R);
  *q = quaternion_of(R);
}

/* Eq. 23 for the sides a and c. False where the axis that it tells stands at less than asin(1/4) to their plane, for
 * its length is |q| = 4 sin(theta/2) |e . (a x c)|. Wants the area measured. */
static INLINE int rodrigues(const triangles *t, quaternion *q) {
  real da[3], dc[3], sum[3];
  subtract(t->af, t->a, da);
  subtract(t->cf, t->c, dc);
  copy(t->c, 3, sum);
  add_to(sum, t->cf);
  cross(da, dc, q->v);
  q->w = dot(da, sum);
  real vv = dot(q->v, q->v), qq = vv + q->w * q->w;
  return qq * qq >= vv * t->area;
}

/* Eq. 23 on triangles that were examined. */
static int clear_rodrigues(const triangles *t, quaternion *q) {
  return rodrigues(t, q) && well_shaped(t) && plain(t, q);
}

/* The careful way of both methods. */
static SELDOM int with_care(const real initial[9], const real final[9], real tolerance, int by_rodrigues, screw *out,
                            real T[16]) {
  triangles t;
  examination x;
  quaternion q;
  look_at(initial, final, &t);
  int status = examine(initial, final, tolerance, &t, &x);
  if (status != CHS_OK) return status;
  if (!(by_rodrigues && clear_rodrigues(&t, &q))) laub_shiflett(&t, &q);
  return finish(initial, final, tolerance, &t, &x, &q, out, T);
}

static INLINE int solve(const real initial[9], const real final[9], real tolerance, int by_rodrigues, screw *out,
                        real T[16]) {
  triangles t;
  quaternion q;
  read_sides(initial, final, &t);
  measure(&t);
  if (!(by_rodrigues && rodrigues(&t, &q))) laub_shiflett(&t, &q);
  read_centers(initial, final, &t);
  if (!(ordinary(&t, tolerance) & plain(&t, &q))) return with_care(initial, final, tolerance, by_rodrigues, out, T);
  write_plain(&t, &q, out, T);
  return CHS_OK;
}

/* The order of the points makes no difference to (v; w), and an axis parallel to their plane makes it 0/0 in any order.
 * So near to it the sides say less about the rotation than the normal does; and where they changed their lengths rather
 * than turned, by measuring errors, (v; w) would be those errors magnified. */
int FN(chs_motion_bottema_roth)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  return solve(initial, final, tolerance, 1, out, T);
}

int FN(chs_motion_laub_shiflett)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  return solve(initial, final, tolerance, 0, out, T);
}

int FN(chs_motion_bottema_roth_order)(const real initial[9], const real final[9], real tolerance, int *order) {
  triangles t;
  examination x;
  quaternion q;
  int status = FN(chs_motion_bottema_roth)(initial, final, tolerance, NULL, NULL);
  if (status < 0) return status;
  look_at(initial, final, &t);
  if (examine(initial, final, tolerance, &t, &x) != CHS_OK || !clear_rodrigues(&t, &q)) {
    *order = -1;
    return status;
  }
  real a[3], b[3], c[3];
  subtract(t.af, t.a, a);
  subtract(t.cf, t.c, c);
  copy(a, 3, b);
  add_to(b, c);
  real first = dot(a, a), second = dot(b, b), third = dot(c, c);
  *order = third > larger(first, second) ? 2 : second > first;
  return status;
}

/* Eq. 28 to 30: each row r of R takes the sides to a component of what they became and has length 1, so that it is
 * known but for the sign of its part along the normal: eight matrices. With that part for the unknown, rather than a
 * coordinate, the quadratic has no linear term and nothing (E) can vanish. All eight take the three points to where
 * they are. Only a fourth one, off the plane, tells them apart: the end of the normal leaves the smallest residual
 * where each row has the sign of a component of af x cf. A row that is all but parallel to the plane has half of its
 * digits in the root, and so its part along the normal comes from the others, that is from eq. 5b. */
static void beggs(const triangles *t, quaternion *q) {
  real a[3], c[3], n[3], Nf[3], R[9], squared[3], along[3];
  dual_basis(t, a, c, n);
  cross(t->af, t->cf, Nf);
  real scale = K(1.0) / SQRT(dot(n, n)); /* |a x c|, for n = a x c / |a x c|^2 */
  int best = ABS(Nf[1]) > ABS(Nf[0]);
  best = ABS(Nf[2]) > ABS(Nf[best]) ? 2 : best;
  for (int i = 0; i < 3; i++) {
    real row[3];
    for (int j = 0; j < 3; j++) row[j] = t->af[i] * a[j] + t->cf[i] * c[j];
    squared[i] = K(1.0) - dot(row, row);
  }
  real other = squared[best] > 0 ? SQRT(squared[best]) / ABS(Nf[best]) : K(0.0);
  for (int i = 0; i < 3; i++) {
    along[i] = scale * other * Nf[i];
    if (squared[i] >= K(0.25)) along[i] = Nf[i] < 0 ? -scale * SQRT(squared[i]) : scale * SQRT(squared[i]);
  }
  sum_of_products(t->af, a, t->cf, c, along, n, R);
  *q = quaternion_of(R);
}

/* A triangle in its own plane: the frame f1 along a, f2, f3 normal to the plane, and in it a = (l, 0), c = (u, h). */
typedef struct flat {
  real f1[3], f2[3], f3[3], l, u, h;
} flat;

static void flatten(const real a[3], const real c[3], flat *f) {
  cross(a, c, f->f3);
  real l = SQRT(dot(a, a)), n = SQRT(dot(f->f3, f->f3));
  copy(a, 3, f->f1);
  multiply_by(K(1.0) / l, f->f1);
  multiply_by(K(1.0) / n, f->f3);
  cross(f->f3, f->f1, f->f2);
  f->l = l;
  f->u = dot(a, c) / l;
  f->h = n / l;
}

/* The rotation that takes the first frame to the second and then turns by the angle of (x, y) in its plane. */
static void between_planes(const flat *f, const flat *g, real x, real y, quaternion *q) {
  real g1[3], g2[3], R[9], length = SQRT(x * x + y * y);
  x /= length;
  y /= length;
  for (int i = 0; i < 3; i++) {
    g1[i] = x * g->f1[i] + y * g->f2[i];
    g2[i] = x * g->f2[i] - y * g->f1[i];
  }
  sum_of_products(g1, f->f1, g2, f->f2, g->f3, f->f3, R);
  *q = quaternion_of(R);
}

/* The turn in the plane that leaves the least sum of squares: sums over the sides of dot and of cross products. */
static void least_squares_turn(const flat *f, const flat *g, real *x, real *y) {
  *x = K(2.0) * (f->l * g->l + f->u * g->u + f->h * g->h) + (f->l * g->u + f->u * g->l);
  *y = K(2.0) * (f->u * g->h - f->h * g->u) + (f->l * g->h - f->h * g->l);
}

/* Eq. 14 to 16. M takes the plane of the initial points to that of the final ones, and [m1/d11 m2/d22 ...] V^T is its
 * orthogonal factor: in frames of the two planes that is a turn, without eigenvectors, equal d or division by a small
 * one. With both normals on the side from which the points go round alike det M > 0, so that it is never a reflection.
 * */
static void spoor_veldpaus(const triangles *t, quaternion *q) {
  flat f, g;
  real x, y;
  flatten(t->a, t->c, &f);
  flatten(t->af, t->cf, &g);
  least_squares_turn(&f, &g, &x, &y);
  between_planes(&f, &g, x, y, q);
}

/* Twice the sum of the squares of the sides as complex numbers, (x, y): its angle is twice that of the principal axis,
 * and its length the difference of the moments, of which the return value is the sum. */
static real moments(const flat *f, real *x, real *y) {
  real ll = f->l * f->l + f->l * f->u + f->u * f->u, hh = f->h * f->h;
  *x = ll - hh;
  *y = f->h * (f->l + K(2.0) * f->u);
  return ll + hh;
}

/* Eq. 6 to 8. The normal of the plane is one principal axis; the other two turn in it by half the angle between the
 * moments before and after. Of the two turns that leaves, the smaller matches the axes to the points. Moments that are
 * equal, or nearly, leave the axes free: those are then taken that fit the points best. */
static void angeles(const triangles *t, quaternion *q) {
  flat f, g;
  real x, y, xf, yf;
  flatten(t->a, t->c, &f);
  flatten(t->af, t->cf, &g);
  real sum = moments(&f, &x, &y), sum_f = moments(&g, &xf, &yf), square = x * x + y * y, square_f = xf * xf + yf * yf;
  if (K(16.0) * square < sum * sum || K(16.0) * square_f < sum_f * sum_f)
    least_squares_turn(&f, &g, &x, &y);
  else {
    real cosine = x * xf + y * yf;
    y = x * yf - y * xf;
    x = cosine + SQRT(square * square_f);
  }
  between_planes(&f, &g, x, y, q);
}

#define METHOD(name)                                                                                              \
  int FN(chs_motion_##name)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) { \
    triangles t;                                                                                                  \
    examination x;                                                                                                \
    quaternion q;                                                                                                 \
    int status = read_triangles(initial, final, tolerance, &t, &x);                                               \
    if (status != CHS_OK) return status;                                                                          \
    name(&t, &q);                                                                                                 \
    return finish(initial, final, tolerance, &t, &x, &q, out, T);                                                 \
  }

METHOD(angeles)
METHOD(spoor_veldpaus)
METHOD(beggs)
