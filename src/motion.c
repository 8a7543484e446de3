#include <chasles/motion.h>

#include "triangles.h"

/* What follows is the careful way, for all that is not plain, in steps that are called one after the other rather than
 * one by the other, so that little stack is taken. */

/* The sum of the sizes of the sides' components, each times a factor: NaN or infinite where one of them is. */
static SELDOM real extent_of(const real points[9], real factor) {
  real sum = 0;
  for (int i = 0; i < 3; i++) {
    real x = points[i], y = points[3 + i], z = points[6 + i];
    sum += factor * ABS(y - x) + factor * ABS(x - z) + factor * ABS(z - y);
  }
  return sum;
}

static SELDOM real largest_coordinate(const real initial[9], const real final[9]) {
  real before = largest(initial, 9), after = largest(final, 9);
  return before > after ? before : after;
}

/* Why the sum of all sides is beyond the format; CHS_OK if but their number is to blame. */
static SELDOM int range_status(const real initial[9], const real final[9]) {
  const real less = K(0.03125);
  int status = first_error(finiteness(initial, 9), finiteness(final, 9));
  if (status != CHS_OK) return status;
  return is_finite(extent_of(initial, less) + extent_of(final, less)) ? CHS_OK : CHS_ERR_OVERFLOW;
}

/* Two factors, since one alone may be beyond the format. */
typedef struct scaling {
  real first, second;
} scaling;

static INLINE void scale_by(scaling by, real x[3]) {
  multiply_by(by.first, x);
  multiply_by(by.second, x);
}

static INLINE real scaled_square(scaling by, const real v[3]) {
  real x[3] = {v[0], v[1], v[2]};
  scale_by(by, x);
  return dot(x, x);
}

static SELDOM void bring_to_scale(scaling by, const place *p, triangles *t) {
  scale_by(by, t->a);
  scale_by(by, t->c);
  scale_by(by, t->af);
  scale_by(by, t->cf);
  measure(t);
  measure_reach(scaled_square(by, p->center) + scaled_square(by, p->travel), t);
}

/* Points too near to each other or to a line for their rounding errors to be told from their positions; a and c are
 * sides to scale. Also the squares of all three. */
static SELDOM int shape_status(const real points[9], scaling by, const real a[3], const real c[3], real noise,
                               real squares[3]) {
  real b[3], normal[3], least = noise * noise;
  subtract(points + 6, points + 3, b);
  scale_by(by, b);
  cross(a, c, normal);
  squares[0] = dot(a, a);
  squares[1] = dot(b, b);
  squares[2] = dot(c, c);
  for (int k = 0; k < 3; k++)
    if (squares[k] <= least) return CHS_ERR_COINCIDENT;
  return dot(normal, normal) <= K(4.0) * least * largest(squares, 3) ? CHS_ERR_COLLINEAR : CHS_OK;
}

/* What is wrong with two triangles. Their sides are divided by a power of two near the longest, so that products of any
 * degree fit, and what is known of them changes with them. */
static SELDOM int examine(const real initial[9], const real final[9], real tolerance, triangles *t, const place *p) {
  real extent = extent_of(initial, 1) + extent_of(final, 1);
  if (!is_finite(extent)) {
    int status = range_status(initial, final);
    if (status != CHS_OK) return status;
    extent = REAL_MAX;
  }
  if (extent == 0) return CHS_ERR_COINCIDENT;
  scaling by = {safe_to_square(extent), 0};
  by.second = K(8.0) / power_of_two_below(by.first * extent);
  bring_to_scale(by, p, t);
  real before[3], after[3], noise = K(4.0) * EPS * (by.second * (by.first * largest_coordinate(initial, final)));
  int status = shape_status(initial, by, t->a, t->c, noise, before);
  if (status == CHS_OK) status = shape_status(final, by, t->af, t->cf, noise, after);
  if (status != CHS_OK) return status;
  real most = K(2.0) * tolerance * largest(before, 3);
  for (int k = 0; k < 3; k++)
    if (!(ABS(after[k] - before[k]) <= most)) return CHS_ERR_NOT_RIGID;
  return CHS_OK;
}

static APART int read_triangles(const real initial[9], const real final[9], real tolerance, triangles *t, place *p) {
  read_sides(initial, final, t);
  measure(t);
  read_place(initial, final, t, p);
  measure_reach(squares_of(p), t);
  t->ordinary = ordinary(t, tolerance);
  return t->ordinary ? CHS_OK : examine(initial, final, tolerance, t, p);
}

/* No component of a side changed by more than the rounding of the coordinates. */
static SELDOM int is_still(const real initial[9], const real final[9]) {
  real turned = 0;
  for (int i = 0; i < 9; i++) {
    int next = i < 6 ? i + 3 : i - 6;
    real change = ABS((final[next] - final[i]) - (initial[next] - initial[i]));
    turned = change > turned ? change : turned;
  }
  return turned * (K(0.25) / EPS) <= largest_coordinate(initial, final);
}

/* k of the errors: the longest side over the smallest height. */
static APART real condition_of(const triangles *t) {
  real normal[3], aa = dot(t->a, t->a), cc = dot(t->c, t->c), bb = aa + cc + K(2.0) * dot(t->a, t->c);
  real longest = aa > cc ? aa : cc;
  cross(t->a, t->c, normal);
  return (bb > longest ? bb : longest) / SQRT(dot(normal, normal));
}

/* False where the result is beyond the format; then no pose was written. */
static APART int screw_fits(const place *p, const quaternion *q, real n, real sign, screw *out) {
  write_screw(p, q, n, sign, out);
  return is_finite_screw(out);
}

static APART int pose_fits(const place *p, const quaternion *q, real nn, real T[16]) {
  real R[9], shift[3];
  pose_of(p, q, nn, R, shift);
  if (!all_finite(shift, 3)) return 0;
  if (T) join(R, shift, T);
  return 1;
}

/* write_plain() with the parts of the careful way. */
static APART int write_apart(const place *p, const quaternion *q, screw *out, real T[16]) {
  real vv = dot(q->v, q->v), ww = q->w * q->w;
  if (out) screw_fits(p, q, SQRT(vv), sign_of[q->w < 0], out);
  if (T) pose_fits(p, q, vv + ww, T);
  return CHS_OK;
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
static APART int finish(const place *p, real condition, quaternion *q, screw *out, real T[16]) {
  real vv = dot(q->v, q->v), nn = vv + q->w * q->w, n = SQRT(vv), zone = K(8.0) * EPS * condition;
  if (q->w < 0) negate(q);
  int half_turn = q->w <= zone * n;
  settle_half_turn(q, zone, n);
  screw s;
  if (!screw_fits(p, q, n, 1, &s) || !pose_fits(p, q, nn, T)) return CHS_ERR_OVERFLOW;
  if (out) *out = s;
  if (condition * SQRT(EPS) > K(1.0)) return CHS_ILL_CONDITIONED;
  return half_turn ? CHS_HALF_TURN : CHS_OK;
}

/* The same from what is known to be ordinary triangles that move, once their rotation is known. */
static SELDOM int finish_ordinary(const real initial[9], const real final[9], const quaternion *rotation, screw *out,
                                  real T[16]) {
  triangles t;
  place p;
  quaternion q = *rotation;
  read_sides(initial, final, &t);
  read_place(initial, final, &t, &p);
  return finish(&p, condition_of(&t), &q, out, T);
}

/* What finds the rotation q of triangles. */
typedef void method(const triangles *t, quaternion *q);

/* The whole of a solver, one method or the other. */
static INLINE int solve_with_care(method *find, const real initial[9], const real final[9], real tolerance, screw *out,
                                  real T[16]) {
  triangles t;
  place p;
  quaternion q;
  int status = read_triangles(initial, final, tolerance, &t, &p);
  if (status != CHS_OK) return status;
  if (!moves(&t) && is_still(initial, final)) return FN(chs_p_finish_translation)(p.travel, out, T);
  find(&t, &q);
  if (dot(q.v, q.v) == 0) return FN(chs_p_finish_translation)(p.travel, out, T);
  if (t.ordinary && moves(&t) && plain(&t, &q)) return write_apart(&p, &q, out, T);
  return finish(&p, condition_of(&t), &q, out, T);
}

static INLINE void laub_shiflett(const triangles *t, quaternion *q) {
  real R[9];
  laub_shiflett_rotation(t, R);
  *q = quaternion_of(R);
}

/* Apart, where speed is not all. */
static APART void laub_shiflett_apart(const triangles *t, quaternion *q) { laub_shiflett(t, q); }

static SELDOM int laub_shiflett_with_care(const real initial[9], const real final[9], real tolerance, screw *out,
                                          real T[16]) {
  return solve_with_care(laub_shiflett_apart, initial, final, tolerance, out, T);
}

/* All that is plain is written at once; for the rest it starts over, but where code may be large not for half-turns and
 * what is near to them. */
int FN(chs_motion_laub_shiflett)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  triangles t;
  place p;
  quaternion q;
  read_sides(initial, final, &t);
  laub_shiflett(&t, &q);
  read_rest(initial, final, &t, &p);
  if (ordinary(&t, tolerance) && moves(&t)) {
    if (plain(&t, &q)) return write_plain(&p, &q, out, T);
    if (VECTORS && dot(q.v, q.v) > 0) {
      quaternion told = q; /* so that the ordinary case stays in registers */
      return finish_ordinary(initial, final, &told, out, T);
    }
  }
  return laub_shiflett_with_care(initial, final, tolerance, out, T);
}

/* Eq. 23 on triangles that were read with care. */
static APART int clear_rodrigues(const triangles *t, quaternion *q) {
  rodrigues(t, q);
  return well_shaped(t) && clear(t, q);
}

static INLINE void bottema_roth(const triangles *t, quaternion *q) {
  if (!clear_rodrigues(t, q)) laub_shiflett_apart(t, q);
}

static SELDOM int bottema_roth_with_care(const real initial[9], const real final[9], real tolerance, screw *out,
                                         real T[16]) {
  return solve_with_care(bottema_roth, initial, final, tolerance, out, T);
}

/* The order of the points makes no difference to (v; w), and an axis parallel to their plane makes it 0/0 in any order.
 * So near to it the sides say less about the rotation than the normal does; and where they changed their lengths rather
 * than turned, by measuring errors, (v; w) would be those errors magnified. */
int FN(chs_motion_bottema_roth)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  triangles t;
  place p;
  quaternion q;
  read_sides(initial, final, &t);
  rodrigues(&t, &q);
  read_rest(initial, final, &t, &p);
  if (!ordinary(&t, tolerance)) return bottema_roth_with_care(initial, final, tolerance, out, T);
  if (!clear(&t, &q)) return FN(chs_motion_laub_shiflett)(initial, final, tolerance, out, T);
  return write_plain(&p, &q, out, T);
}

int FN(chs_motion_bottema_roth_order)(const real initial[9], const real final[9], real tolerance, int *order) {
  triangles t;
  place p;
  quaternion q;
  int status = FN(chs_motion_bottema_roth)(initial, final, tolerance, NULL, NULL);
  if (status < 0) return status;
  if (read_triangles(initial, final, tolerance, &t, &p) != CHS_OK || !clear_rodrigues(&t, &q)) {
    *order = -1;
    return status;
  }
  real a[3], b[3], c[3];
  subtract(t.af, t.a, a);
  subtract(t.cf, t.c, c);
  copy(a, 3, b);
  add_to(b, c);
  real first = dot(a, a), second = dot(b, b), third = dot(c, c);
  *order = third > (first > second ? first : second) ? 2 : second > first;
  return status;
}

/* Eq. 28 to 30: each row r of R takes the sides to a component of what they became and has length 1, so that it is
 * known but for the sign of its part along the normal: eight matrices. With that part for the unknown, rather than a
 * coordinate, the quadratic has no linear term and nothing (E) can vanish. All eight take the three points to where
 * they are. Only a fourth one, off the plane, tells them apart: the end of the normal leaves the smallest residual
 * where each row has the sign of a component of af x cf. A row that is all but parallel to the plane has half of its
 * digits in the root, and so its part along the normal comes from the others, that is from eq. 5b. */
static APART void beggs(const triangles *t, quaternion *q) {
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

static APART void spoor_veldpaus(const triangles *t, quaternion *q) {
  real R[9];
  spoor_veldpaus_rotation(t, R);
  *q = quaternion_of(R);
}

/* Twice the sum of the squares of the sides as complex numbers over the sum of the moments, (x, y): its angle is twice
 * that of the principal axis, and its length the difference of the moments in parts of their sum. */
static void moments(const flat *f, real *x, real *y) {
  real ll = f->l * f->l + f->l * f->u + f->u * f->u, hh = f->h * f->h, scale = K(1.0) / (ll + hh);
  *x = scale * (ll - hh);
  *y = scale * (f->h * (f->l + K(2.0) * f->u));
}

/* Eq. 6 to 8. The normal of the plane is one principal axis; the other two turn in it by half the angle between the
 * moments before and after. Of the two turns that leaves, the smaller matches the axes to the points. Moments that are
 * equal, or nearly, leave the axes free: those are then taken that fit the points best. */
static APART void angeles(const triangles *t, quaternion *q) {
  flat f, g;
  real x, y, xf, yf, R[9];
  flatten(t->a, t->c, &f);
  flatten(t->af, t->cf, &g);
  moments(&f, &x, &y);
  moments(&g, &xf, &yf);
  real square = x * x + y * y, square_f = xf * xf + yf * yf;
  if (square < K(0.0625) || square_f < K(0.0625))
    least_squares_turn(&f, &g, &x, &y);
  else {
    real cosine = x * xf + y * yf;
    y = x * yf - y * xf;
    x = cosine + SQRT(square * square_f);
  }
  between_planes(&f, &g, x, y, R);
  *q = quaternion_of(R);
}

#define METHOD(name)                                                                                              \
  int FN(chs_motion_##name)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) { \
    return solve_with_care(name, initial, final, tolerance, out, T);                                              \
  }

METHOD(angeles)
METHOD(spoor_veldpaus)
METHOD(beggs)
