#include <chasles/line.h>

#include <chasles/screw.h>
#include <chasles/se3.h>

#include "angle.h"
#include "axis.h"
#include "exact.h"
#include "rotation.h"

/* The point nearer to the origin. */
static const real *nearer(const real a[3], const real b[3]) { return norm(b, 3) < norm(a, 3) ? b : a; }

void FN(chs_line_raw_from_points)(const real a[3], const real b[3], real L[6]) {
  real d[3], m[3];
  subtract(b, a, d);
  cross(nearer(a, b), d, m);
  copy(d, 3, L);
  copy(m, 3, L + 3);
}

int FN(chs_line_from_points)(const real a[3], const real b[3], real L[6]) {
  real d[3];
  int status = first_error(finiteness(a, 3), finiteness(b, 3));
  if (status != CHS_OK) return status;
  subtract(b, a, d);
  if (!all_finite(d, 3)) return CHS_ERR_OVERFLOW;
  return largest(d, 3) == 0 ? CHS_ERR_COINCIDENT : FN(chs_screw_revolute)(nearer(a, b), d, L);
}

int FN(chs_line_from_direction)(const real p[3], const real d[3], real L[6]) { return FN(chs_screw_revolute)(p, d, L); }

int FN(chs_line_normalize)(const real raw[6], real L[6]) { return FN(chs_screw_axis_line)(raw, L); }

void FN(chs_line_move)(const real T[16], const real L[6], real moved[6]) { FN(chs_se3_adjoint_twist)(T, L, moved); }

/* A line as it is read: d of unit length, m at a right angle to it. */
typedef struct line {
  real d[3], m[3];
} line;

static int check_line(const real L[6]) {
  int status = finiteness(L, 6);
  if (status != CHS_OK) return status;
  return ABS(dot(L, L) - K(1.0)) <= (real)CHS_SO3_FAR ? CHS_OK : CHS_ERR_ARGUMENT;
}

/* One that has passed the check. */
static line line_of(const real L[6]) {
  line l;
  real h;
  axis_of(L, l.d, l.m, &h);
  return l;
}

/* The point nearest to the origin. */
static void point_of(const line *l, real p[3]) { cross(l->d, l->m, p); }

int FN(chs_line_project)(const real L[6], const real x[3], real foot[3], real *distance) {
  int status = first_error(check_line(L), finiteness(x, 3));
  if (status != CHS_OK) return status;
  line l = line_of(L);
  real p[3], off[3], along = dot(l.d, x);
  point_of(&l, p);
  for (int i = 0; i < 3; i++) p[i] += along * l.d[i];
  cross(x, l.d, off);
  subtract(off, l.m, off);
  real d = norm(off, 3);
  if (!all_finite(p, 3) || !is_finite(d)) return CHS_ERR_OVERFLOW;
  copy(p, 3, foot);
  if (distance) *distance = d;
  return CHS_OK;
}

/* The normal a x b of two directions and its length, to full precision also where they are nearly parallel. */
static real normal_of(const real a[3], const real b[3], real n[3]) {
  cross(a, b, n);
  if (dot(n, n) < K(0.25)) exact_cross(a, b, n);
  return norm(n, 3);
}

static int signed_angle_about(const real A[6], const real B[6], const real about[3], real *angle) {
  int status = first_error(first_error(check_line(A), check_line(B)), finiteness(about, 3));
  if (status != CHS_OK) return status;
  real n[3], sine = normal_of(A, B, n), direction[3];
  unit(about, direction);
  real size = FN(chs_p_angle_of)(sine, dot(A, B));
  *angle = dot(direction, n) < 0 ? -size : size;
  return CHS_OK;
}

int FN(chs_line_angle)(const real A[6], const real B[6], real *angle) {
  static const real none[3] = {0, 0, 0};
  return signed_angle_about(A, B, none, angle);
}

int FN(chs_line_signed_angle)(const real A[6], const real B[6], const real about[3], real *angle) {
  return signed_angle_about(A, B, about, angle);
}

/* What lies between two lines: the common perpendicular's direction x, and along it the distance. */
typedef struct between {
  line a, b;
  real x[3], distance;
  real sine, angle; /* of the two lines; the angle signed about x */
  int status;
} between;

/* x across the line, as near as may be to the coordinate axis of the direction's smallest component. */
static void across(const real d[3], real x[3]) {
  int k = 0;
  for (int i = 1; i < 3; i++) k = ABS(d[i]) < ABS(d[k]) ? i : k;
  for (int i = 0; i < 3; i++) x[i] = (i == k ? K(1.0) : K(0.0)) - d[k] * d[i];
  unit(x, x);
}

/* A and B have been checked. */
static between between_lines(const real A[6], const real B[6]) {
  between r;
  real n[3], length = normal_of(A, B, n);
  r.a = line_of(A);
  r.b = line_of(B);
  r.angle = FN(chs_p_angle_of)(length, dot(A, B));
  r.sine = length / (norm(A, 3) * norm(B, 3));
  real rounding = K(8.0) * EPS * norm(r.a.m, 3) + K(8.0) * EPS * norm(r.b.m, 3);
  if (r.sine > K(8.0) * EPS) {
    real turned = dot(r.a.d, r.b.m) + dot(r.b.d, r.a.m); /* s times the distance, against a x b */
    int meet = ABS(turned) <= rounding, back = !meet && turned > 0;
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
  r.distance = norm(to, 3);
  r.status = r.distance <= rounding ? CHS_COINCIDENT : CHS_PARALLEL;
  if (r.status == CHS_PARALLEL)
    unit(to, r.x);
  else
    across(A, r.x);
  return r;
}

/* Where the perpendicular meets the lines: t along each from its point nearest to the origin (eq. 8). */
static void feet_of(const between *r, real foot_a[3], real foot_b[3]) {
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

int FN(chs_line_distance)(const real A[6], const real B[6], real *distance) {
  int status = first_error(check_line(A), check_line(B));
  if (status != CHS_OK) return status;
  between r = between_lines(A, B);
  if (!is_finite(r.distance)) return CHS_ERR_OVERFLOW;
  *distance = r.distance;
  return r.status;
}

int FN(chs_line_perpendicular)(const real A[6], const real B[6], real X[6], real foot_a[3], real foot_b[3], real *angle,
                               real *distance) {
  int status = first_error(check_line(A), check_line(B));
  if (status != CHS_OK) return status;
  between r = between_lines(A, B);
  real from[3], to[3], m[3];
  feet_of(&r, from, to);
  cross(from, r.x, m);
  if (!is_finite(r.distance) || !all_finite(m, 3) || !all_finite(from, 3) || !all_finite(to, 3))
    return CHS_ERR_OVERFLOW;
  copy(r.x, 3, X);
  copy(m, 3, X + 3);
  if (foot_a) copy(from, 3, foot_a);
  if (foot_b) copy(to, 3, foot_b);
  if (angle) *angle = r.angle;
  if (distance) *distance = r.distance;
  return r.status;
}
