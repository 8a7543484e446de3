/* Two triangles, and the ordinary way from them to a rotation, a screw and a pose: what a solver does at once and its
 * array form in blocks. */
#ifndef CHASLES_TRIANGLES_H
#define CHASLES_TRIANGLES_H

#include "motion_private.h"

/* Two triangles: the side a from the first point to the second and c from the third to the first, before and after. */
typedef struct triangles {
  real a[3], c[3], af[3], cf[3];
  /* Of their squares half the sum over all sides before, and over those before and after; of what each square changed
   * the sum. */
  real before, span, strain;
  real area, area_after; /* squares of twice the areas, good to 16 eps span^2 */
  real changed;          /* |af - a|^2 + |cf - c|^2 */
  real reach;            /* two thirds of it are at least the square of the largest coordinate */
  int ordinary;          /* nothing but ordinary is known of them, which saves looking closer */
} triangles;

/* Where they are. */
typedef struct place {
  real center[3]; /* centroid of the initial points */
  real travel[3]; /* displacement of the centroid */
} place;

/* Products of four lengths between which those of fewer and those that small turns make of them neither overflow nor
 * underflow, and the least square of a quaternion's vector that is good to all digits. */
#ifdef CHS_SINGLE
#define AREA_LEAST 0x1p-96F
#define AREA_MOST 0x1p+96F
#define SQUARE_LEAST 0x1p-100F
#else
#define AREA_LEAST 0x1p-900
#define AREA_MOST 0x1p+900
#define SQUARE_LEAST 0x1p-960
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

static INLINE void read_place(const real initial[9], const real final[9], const triangles *t, place *p) {
  real moved[3], da[3], dc[3];
  subtract(final, initial, moved);
  subtract(t->af, t->a, da);
  subtract(t->cf, t->c, dc);
  mean(initial, t->a, t->c, p->center);
  mean(moved, da, dc, p->travel);
}

static INLINE void measure(triangles *t) {
  real aa = dot(t->a, t->a), cc = dot(t->c, t->c), ac = dot(t->a, t->c);
  real ff = dot(t->af, t->af), gg = dot(t->cf, t->cf), fg = dot(t->af, t->cf);
  real aa_more = ff - aa, cc_more = gg - cc, bb_more = (aa_more + cc_more) + K(2.0) * (fg - ac), da[3], dc[3];
  t->before = aa + cc + ac;
  t->span = t->before + (ff + gg + fg);
  t->strain = ABS(aa_more) + ABS(bb_more) + ABS(cc_more);
  t->area = aa * cc - ac * ac;
  t->area_after = ff * gg - fg * fg;
  subtract(t->af, t->a, da);
  subtract(t->cf, t->c, dc);
  t->changed = dot(da, da) + dot(dc, dc);
}

static INLINE real squares_of(const place *p) { return dot(p->center, p->center) + dot(p->travel, p->travel); }

static INLINE void measure_reach(real squares, triangles *t) { t->reach = t->span + K(0.5) * squares; }

static INLINE void read_rest(const real initial[9], const real final[9], triangles *t, place *p) {
  measure(t);
  read_place(initial, final, t, p);
  measure_reach(squares_of(p), t);
}

/* Far enough from lines, and near enough to the origin, for rounding to be out of the question. NaN fails. */
static INLINE int well_shaped(const triangles *t) {
  real least = K(256.0) * EPS * (t->span * (t->span + K(0.25) * EPS * t->reach));
  return t->area >= least && t->area_after >= least;
}

/* Enough to be certain, at a glance, that examine() would find nothing wrong. NaN fails. */
static INLINE int ordinary(const triangles *t, real tolerance) {
  return well_shaped(t) && t->area >= AREA_LEAST && t->area <= AREA_MOST &&
         t->strain <= K(4.0) / K(3.0) * tolerance * t->before;
}

/* Whether it is certain, without a look at all of the coordinates, that some of the sides turned or changed. */
static INLINE int moves(const triangles *t) { return t->changed > K(80.0) * EPS * EPS * t->reach; }

/* Enough to be certain, of ordinary triangles that move, that the rotation is neither none nor a half-turn nor so near
 * to one that somebody would ask. */
static INLINE int plain(const triangles *t, const quaternion *q) {
  real vv = dot(q->v, q->v), ww = q->w * q->w;
  return vv >= SQUARE_LEAST && ww * t->area > K(144.0) * EPS * EPS * (t->before * t->before) * vv;
}

/* The screw of q = (v; w), n = |v|, turned so that w is not negative where sign has its sign. */
static INLINE void write_screw(const place *p, const quaternion *q, real n, real sign, screw *out) {
  real w = sign * q->w;
  screw_through(p->center, p->travel, q->v, sign / n, w / n, out);
  out->angle = angle_of_half(n, w);
}

/* The rotation of q, |q|^2 = nn, and the translation that takes the centroid to the centroid. */
static INLINE void pose_of(const place *p, const quaternion *q, real nn, real R[9], real shift[3]) {
  rotation_from_quaternion(q, nn, R);
  rotate(R, p->center, shift);
  subtract(p->center, shift, shift);
  add_to(shift, p->travel);
}

static const real sign_of[2] = {1, -1}; /* looked up, for a branch would be a coin's toss */

static INLINE int write_plain(const place *p, const quaternion *q, screw *out, real T[16]) {
  real vv = dot(q->v, q->v), ww = q->w * q->w;
  if (out) write_screw(p, q, SQRT(vv), sign_of[q->w < 0], out);
  if (T) {
    real R[9], shift[3];
    pose_of(p, q, vv + ww, R, shift);
    join(R, shift, T);
  }
  return CHS_OK;
}

/* Eq. 23 for the sides a and c. */
static INLINE void rodrigues(const triangles *t, quaternion *q) {
  real da[3], dc[3], sum[3];
  subtract(t->af, t->a, da);
  subtract(t->cf, t->c, dc);
  copy3(t->c, sum);
  add_to(sum, t->cf);
  cross(da, dc, q->v);
  q->w = dot(da, sum);
}

/* Whether it may be believed. Not where the axis that it tells stands at less than asin(1/4) to the plane of the sides,
 * for its length is |q| = 4 sin(theta/2) |e . (a x c)|; where the squares of their changes are more than twice what
 * turning can do, 4 sin(theta/2)^2 of theirs; and where the rotation is so near to none or to a half-turn that the
 * errors of a thin triangle have a say in it. So ordinary triangles move where this is true, and q is plain. With
 * 1 - cos(theta) and 1 + cos(theta) no product is longer than four lengths. */
static INLINE int clear(const triangles *t, const quaternion *q) {
  real vv = dot(q->v, q->v), ww = q->w * q->w, nn = vv + ww, scale = K(2.0) / nn;
  real less = scale * vv, more = scale * ww, area = less * t->area;
  return K(2.0) * nn >= area && t->changed <= K(4.0) * less * (dot(t->a, t->a) + dot(t->c, t->c)) &&
         area * more > K(512.0) * EPS * EPS * (t->span * t->reach) && vv >= SQUARE_LEAST;
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
  R[0] = x[0] * a[0] + y[0] * c[0] + z[0] * n[0];
  R[1] = x[0] * a[1] + y[0] * c[1] + z[0] * n[1];
  R[2] = x[0] * a[2] + y[0] * c[2] + z[0] * n[2];
  R[3] = x[1] * a[0] + y[1] * c[0] + z[1] * n[0];
  R[4] = x[1] * a[1] + y[1] * c[1] + z[1] * n[1];
  R[5] = x[1] * a[2] + y[1] * c[2] + z[1] * n[2];
  R[6] = x[2] * a[0] + y[2] * c[0] + z[2] * n[0];
  R[7] = x[2] * a[1] + y[2] * c[1] + z[2] * n[1];
  R[8] = x[2] * a[2] + y[2] * c[2] + z[2] * n[2];
}

/* Eq. 12 and 13 with both origins moved along the normal of the points' plane: Q takes the sides to what they became,
 * and its cofactors take the normal a x c to af x cf. */
static INLINE void laub_shiflett_rotation(const triangles *t, real R[9]) {
  real a[3], c[3], n[3], Nf[3];
  dual_basis(t, a, c, n);
  cross(t->af, t->cf, Nf);
  sum_of_products(t->af, a, t->cf, c, Nf, n, R);
}

/* A triangle in its own plane: the frame f1 along a, f2, f3 normal to the plane, and in it a = (l, 0), c = (u, h). */
typedef struct flat {
  real f1[3], f2[3], f3[3], l, u, h;
} flat;

static inline void flatten(const real a[3], const real c[3], flat *f) {
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
static inline void between_planes(const flat *f, const flat *g, real x, real y, real R[9]) {
  real g1[3], g2[3], length = SQRT(x * x + y * y);
  x /= length;
  y /= length;
  for (int i = 0; i < 3; i++) {
    g1[i] = x * g->f1[i] + y * g->f2[i];
    g2[i] = x * g->f2[i] - y * g->f1[i];
  }
  sum_of_products(g1, f->f1, g2, f->f2, g->f3, f->f3, R);
}

/* The turn in the plane that leaves the least sum of squares: sums over the sides of dot and of cross products. */
static inline void least_squares_turn(const flat *f, const flat *g, real *x, real *y) {
  *x = K(2.0) * (f->l * g->l + f->u * g->u + f->h * g->h) + (f->l * g->u + f->u * g->l);
  *y = K(2.0) * (f->u * g->h - f->h * g->u) + (f->l * g->h - f->h * g->l);
}

/* Eq. 14 to 16. M takes the plane of the initial points to that of the final ones, and [m1/d11 m2/d22 ...] V^T is its
 * orthogonal factor: in frames of the two planes that is a turn, without eigenvectors, equal d or division by a small
 * one. With both normals on the side from which the points go round alike det M > 0, so that it is never a reflection.
 * */
static inline void spoor_veldpaus_rotation(const triangles *t, real R[9]) {
  flat f, g;
  real x, y;
  flatten(t->a, t->c, &f);
  flatten(t->af, t->cf, &g);
  least_squares_turn(&f, &g, &x, &y);
  between_planes(&f, &g, x, y, R);
}

#endif
