#include <chasles/line.h>

#include <chasles/screw.h>
#include <chasles/se3.h>

#include "line_private.h"

/* The point nearer to the origin. Where one square underflows the other point's does not, or both are 0. */
static const real *nearer(const real a[3], const real b[3]) {
  real x = largest(a, 3), y = largest(b, 3), scale = safe_to_square(x > y ? x : y);
  const real p[3] = {scale * a[0], scale * a[1], scale * a[2]}, q[3] = {scale * b[0], scale * b[1], scale * b[2]};
  return dot(q, q) < dot(p, p) ? b : a;
}

void FN(chs_line_raw_from_points)(const real a[3], const real b[3], real L[6]) {
  real d[3], m[3];
  subtract(b, a, d);
  cross(nearer(a, b), d, m);
  copy(d, 3, L);
  copy(m, 3, L + 3);
}

int FN(chs_line_from_points)(const real a[3], const real b[3], real L[6]) {
  real d[3];
  int status = first_error(finiteness_at_a_glance(a, 3), finiteness_at_a_glance(b, 3));
  if (status != CHS_OK) return status;
  subtract(b, a, d);
  if (!all_finite(d, 3)) return CHS_ERR_OVERFLOW;
  return largest(d, 3) == 0 ? CHS_ERR_COINCIDENT : FN(chs_screw_revolute)(nearer(a, b), d, L);
}

int FN(chs_line_from_direction)(const real p[3], const real d[3], real L[6]) { return FN(chs_screw_revolute)(p, d, L); }

int FN(chs_line_normalize)(const real raw[6], real L[6]) { return FN(chs_screw_axis_line)(raw, L); }

void FN(chs_line_move)(const real T[16], const real L[6], real moved[6]) { FN(chs_se3_adjoint_twist)(T, L, moved); }

int FN(chs_line_project)(const real L[6], const real x[3], real foot[3], real *distance) {
  int status = first_error(check_line(L), finiteness_at_a_glance(x, 3));
  if (status != CHS_OK) return status;
  line l = line_of(L);
  real p[3], off[3];
  cross(x, l.d, off);
  subtract(off, l.m, off);
  cross(l.d, off, p);
  subtract(x, p, p);
  real d = norm(off, 3);
  if (!all_finite(p, 3) || !is_finite(d)) return CHS_ERR_OVERFLOW;
  copy(p, 3, foot);
  if (distance) *distance = d;
  return CHS_OK;
}

static int signed_angle_about(const real A[6], const real B[6], const real about[3], real *angle) {
  int status = first_error(first_error(check_line(A), check_line(B)), finiteness_at_a_glance(about, 3));
  if (status != CHS_OK) return status;
  real n[3], sine = normal_of(A, B, n), direction[3];
  unit(about, direction);
  real size = FN(chs_p_angle_of)(sine, dot(A, B));
  *angle = dot(direction, n) < -ROUNDING * sine ? -size : size;
  return CHS_OK;
}

int FN(chs_line_angle)(const real A[6], const real B[6], real *angle) {
  static const real none[3] = {0, 0, 0};
  return signed_angle_about(A, B, none, angle);
}

int FN(chs_line_signed_angle)(const real A[6], const real B[6], const real about[3], real *angle) {
  return signed_angle_about(A, B, about, angle);
}

int FN(chs_line_distance)(const real A[6], const real B[6], real *distance) {
  int status = first_error(check_line(A), check_line(B));
  if (status != CHS_OK) return status;
  between r = between_lines(A, B, ROUNDING, 0);
  if (!is_finite(r.distance)) return CHS_ERR_OVERFLOW;
  *distance = r.distance;
  return r.status;
}

int FN(chs_line_perpendicular)(const real A[6], const real B[6], real X[6], real foot_a[3], real foot_b[3], real *angle,
                               real *distance) {
  int status = first_error(check_line(A), check_line(B));
  if (status != CHS_OK) return status;
  between r = between_lines(A, B, ROUNDING, 0);
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
