/* A line as the library reads it, and what lies between two of them. */
#ifndef CHASLES_LINE_PRIVATE_H
#define CHASLES_LINE_PRIVATE_H

#include "axis.h"
#include "exact.h"
#include "rotation.h"

#define check_line(...) FN(chs_p_check_line)(__VA_ARGS__)
#define line_of(...) FN(chs_p_line_of)(__VA_ARGS__)
#define point_of(...) FN(chs_p_point_of)(__VA_ARGS__)
#define foot_on(...) FN(chs_p_foot_on)(__VA_ARGS__)
#define normal_of(...) FN(chs_p_normal_of)(__VA_ARGS__)
#define zero_of(...) FN(chs_p_zero_of)(__VA_ARGS__)
#define across(...) FN(chs_p_across)(__VA_ARGS__)
#define between_lines(...) FN(chs_p_between_lines)(__VA_ARGS__)
#define feet_of(...) FN(chs_p_feet_of)(__VA_ARGS__)

/* The sine of lines that are parallel but for rounding. */
#define ROUNDING (K(8.0) * EPS)

/* A line as it is read: d of unit length, m at a right angle to it; and the length that d had. */
typedef struct line {
  real d[3], m[3], length;
} line;

LARGE int check_line(const real L[6]);

/* One that has passed the check. */
LARGE line line_of(const real L[6]);

/* Its point nearest to the origin. */
SHARED void point_of(const line *l, real p[3]) { cross(l->d, l->m, p); }

/* Its point nearest to x; foot may be x. */
SHARED void foot_on(const line *l, const real x[3], real foot[3]) {
  real p[3], along = dot(l->d, x);
  point_of(l, p);
  for (int i = 0; i < 3; i++) foot[i] = p[i] + along * l->d[i];
}

/* The normal a x b of two directions and its length, to full precision also where they are nearly parallel. */
LARGE real normal_of(const real a[3], const real b[3], real n[3]);

/* What lies between two lines: the common perpendicular's direction x, and along it the distance. */
typedef struct between {
  line a, b;
  real x[3], distance;
  real sine, angle; /* of the two lines; the angle signed about x */
  int status;
} between;

/* x across the line, as near as may be to the coordinate axis of the direction's smallest component. */
LARGE void across(const real d[3], real x[3]);

/* zero |m|, also where |m| is beyond the format. */
SHARED real zero_of(real zero, const real m[3]) {
  const real x[3] = {zero * m[0], zero * m[1], zero * m[2]};
  return norm(x, 3);
}

/* A and B have been checked. A sine up to `zero` counts as zero, and so does a distance (times the sine, where there is
 * one) up to that share of |m_a| + |m_b|, and `more`. */
LARGE between between_lines(const real A[6], const real B[6], real zero, real more);

/* Where the perpendicular meets the lines: t along each from its point nearest to the origin (eq. 8). */
LARGE void feet_of(const between *r, real foot_a[3], real foot_b[3]);

#if LARGE_BODIES

LARGE int check_line(const real L[6]) {
  int status = finiteness_at_a_glance(L, 6);
  if (status != CHS_OK) return status;
  return ABS(dot(L, L) - K(1.0)) <= (real)CHS_SO3_FAR ? CHS_OK : CHS_ERR_ARGUMENT;
}

LARGE line line_of(const real L[6]) {
  line l;
  real h;
  l.length = axis_of(L, l.d, l.m, &h);
  return l;
}

LARGE real normal_of(const real a[3], const real b[3], real n[3]) {
  cross(a, b, n);
  if (dot(n, n) < K(0.25)) exact_cross(a, b, n);
  return norm(n, 3);
}

LARGE void across(const real d[3], real x[3]) {
  int k = 0;
  real dd = dot(d, d); /* d is of unit length only to within CHS_SO3_FAR */
  for (int i = 1; i < 3; i++) k = ABS(d[i]) < ABS(d[k]) ? i : k;
  for (int i = 0; i < 3; i++) x[i] = (i == k ? dd : K(0.0)) - d[k] * d[i];
  unit(x, x);
}

LARGE between between_lines(const real A[6], const real B[6], real zero, real more) {
  between r;
  real n[3], length = normal_of(A, B, n);
  r.a = line_of(A);
  r.b = line_of(B);
  r.angle = FN(chs_p_angle_of)(length, dot(A, B));
  r.sine = length / (r.a.length * r.b.length);
  real near = zero_of(zero, r.a.m) + zero_of(zero, r.b.m) + more;
  if (r.sine > zero) {
    real turned = dot(r.a.d, r.b.m) + dot(r.b.d, r.a.m); /* s times the distance, against a x b */
    int meet = ABS(turned) <= near, back = !meet && turned > 0;
    unit(n, r.x);
    for (int i = 0; i < 3 && back; i++) r.x[i] = -r.x[i];
    r.angle = back ? -r.angle : r.angle;
    r.distance = ABS(turned) / r.sine;
    r.status = meet ? CHS_INTERSECTING : CHS_OK;
    return r;
  }
  real from[3], to[3], along;
  point_of(&r.a, from);
  point_of(&r.b, to);
  subtract(to, from, to);
  along = dot(r.a.d, to);
  for (int i = 0; i < 3; i++) to[i] -= along * r.a.d[i];
  r.distance = unit(to, r.x);
  r.status = r.distance <= near ? CHS_COINCIDENT : CHS_PARALLEL;
  if (r.status == CHS_COINCIDENT) across(A, r.x);
  return r;
}

LARGE void feet_of(const between *r, real foot_a[3], real foot_b[3]) {
  point_of(&r->a, foot_a);
  if (r->status == CHS_PARALLEL || r->status == CHS_COINCIDENT) {
    for (int i = 0; i < 3; i++) foot_b[i] = foot_a[i] + (r->status == CHS_PARALLEL ? r->distance * r->x[i] : K(0.0));
    return;
  }
  point_of(&r->b, foot_b);
  real cosine = dot(r->a.d, r->b.d), sine = r->angle < 0 ? -r->sine : r->sine;
  real xa = dot(r->x, r->a.m), xb = dot(r->x, r->b.m);
  real ta = (xb - cosine * xa) / sine, tb = (cosine * xb - xa) / sine;
  for (int i = 0; i < 3; i++) {
    foot_a[i] += ta * r->a.d[i];
    foot_b[i] += tb * r->b.d[i];
  }
}

#endif

#endif
