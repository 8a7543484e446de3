#include <chasles/screw.h>

#include <chasles/se3.h>

#include "axis.h"
#include "pose.h"
#include "screw_private.h"

int FN(chs_screw_from_pose)(const real T[16], screw *out) {
  static const real origin[3] = {0, 0, 0};
  real R[9], p[3];
  int status = read_pose(T, R, p);
  if (status != CHS_OK) return status;
  quaternion q = quaternion_of(R);
  real n = norm(q.v, 3);
  if (q.w <= EPS * n) settle_half_turn(&q, 0, n);
  screw s;
  if (n == 0 || !screw_of_rotation(&q, n, origin, p, &s)) {
    /* No rotation to the format, or one whose axis lies beyond the format's range. */
    if (n > EPS * q.w) return CHS_ERR_OVERFLOW;
    status = screw_of_translation(p, &s);
    if (!is_finite(s.translation)) return CHS_ERR_OVERFLOW;
  } else if (q.w <= EPS * n)
    status = CHS_HALF_TURN;
  *out = s;
  return status;
}

int FN(chs_screw_to_pose)(const screw *in, real T[16]) {
  const real numbers[8] = {in->axis[0],  in->axis[1],  in->axis[2],     in->point[0],
                           in->point[1], in->point[2], in->translation, in->angle};
  int status = finiteness_at_a_glance(numbers, 8);
  if (status != CHS_OK) return status;
  if (ABS(in->angle) > ANGLE_MAX) return CHS_ERR_ANGLE_RANGE;

  if (largest(in->axis, 3) == 0 && (in->angle != 0 || in->translation != 0)) return CHS_ERR_SINGULAR;

  /* R = I + sin(theta) [e] + (1 - cos(theta)) [e]^2, and (I - R) A from the same terms, so that a small rotation about
   * a far axis does not cancel. */
  real e[3], R[9], p[3], exA[3], exexA[3];
  unit(in->axis, e);
  sine_cosine half = sin_cos_of(K(0.5) * in->angle);
  real ss = half.sine * half.sine, cc = half.cosine * half.cosine, ee = dot(e, e);
  if (ee == 0) ee = 1; /* no axis and nothing to do about it */
  real a = K(2.0) * half.sine * half.cosine / SQRT(ee), b = (cc < ss ? K(1.0) - cc : ss) / ee;
  rotation_from(e, a, b, cc, R);
  cross(e, in->point, exA);
  cross(e, exA, exexA);
  for (int i = 0; i < 3; i++) p[i] = in->translation * e[i] - (a * exA[i] + K(2.0) * b * exexA[i]);
  if (!all_finite(p, 3)) return CHS_ERR_OVERFLOW;
  join(R, p, T);
  return CHS_OK;
}

int FN(chs_screw_pitch)(const screw *in, real *pitch) {
  const real numbers[2] = {in->translation, in->angle};
  int status = finiteness_at_a_glance(numbers, 2);
  if (status != CHS_OK) return status;
  if (in->angle == 0) {
    *pitch = in->translation == 0 ? 0 : in->translation / K(0.0);
    return in->translation == 0 ? CHS_NO_MOTION : CHS_PURE_TRANSLATION;
  }
  real h = in->translation / in->angle;
  if (!is_finite(h)) return CHS_ERR_OVERFLOW;
  *pitch = h;
  return CHS_OK;
}

/* S = (omega; v) where v is within the format. */
static int put_axis(const real omega[3], const real v[3], int status, real S[6]) {
  if (!all_finite(v, 3)) return CHS_ERR_OVERFLOW;
  copy(omega, 3, S);
  copy(v, 3, S + 3);
  return status;
}

static const real none[3] = {0, 0, 0};

int FN(chs_screw_helical)(const real q[3], const real s[3], real h, real S[6]) {
  int endless = ABS(h) > REAL_MAX, status = first_error(finiteness_at_a_glance(q, 3), finiteness_at_a_glance(s, 3));
  if (h != h) return CHS_ERR_NAN;
  if (status != CHS_OK) return status;
  if (largest(s, 3) == 0) return CHS_ERR_SINGULAR;
  real e[3], v[3];
  unit(s, e);
  cross(q, e, v);
  for (int i = 0; i < 3; i++) v[i] = endless ? (h < 0 ? -e[i] : e[i]) : v[i] + h * e[i];
  return put_axis(endless ? none : e, v, endless ? CHS_PURE_TRANSLATION : CHS_OK, S);
}

int FN(chs_screw_revolute)(const real q[3], const real s[3], real S[6]) {
  return FN(chs_screw_helical)(q, s, K(0.0), S);
}

int FN(chs_screw_prismatic)(const real s[3], real S[6]) {
  int status = FN(chs_screw_helical)(none, s, (real)INFINITY, S);
  return status == CHS_PURE_TRANSLATION ? CHS_OK : status;
}

int FN(chs_screw_axis_parts)(const real S[6], real q[3], real s[3], real *h) {
  int status = finiteness_at_a_glance(S, 6);
  if (status != CHS_OK) return status;
  real e[3], m[3], point[3], pitch;
  if (largest(S, 3) == 0) {
    if (largest(S + 3, 3) == 0) return CHS_ERR_SINGULAR;
    unit(S + 3, s);
    copy(none, 3, q);
    *h = (real)INFINITY;
    return CHS_PURE_TRANSLATION;
  }
  axis_of(S, e, m, &pitch);
  cross(e, m, point);
  if (!all_finite(point, 3) || !is_finite(pitch)) return CHS_ERR_OVERFLOW;
  copy(point, 3, q);
  copy(e, 3, s);
  *h = pitch;
  return CHS_OK;
}

int FN(chs_screw_axis_pitch)(const real S[6], real *h) {
  int status = finiteness_at_a_glance(S, 6);
  if (status != CHS_OK) return status;
  real e[3], m[3], pitch;
  if (largest(S, 3) == 0) {
    if (largest(S + 3, 3) == 0) return CHS_ERR_SINGULAR;
    *h = (real)INFINITY;
    return CHS_PURE_TRANSLATION;
  }
  axis_of(S, e, m, &pitch);
  if (!is_finite(pitch)) return CHS_ERR_OVERFLOW;
  *h = pitch;
  return CHS_OK;
}

int FN(chs_screw_axis_line)(const real S[6], real L[6]) {
  int status = finiteness_at_a_glance(S, 6);
  if (status != CHS_OK) return status;
  if (largest(S, 3) == 0) return CHS_ERR_SINGULAR;
  real e[3], m[3], h;
  axis_of(S, e, m, &h);
  return put_axis(e, m, CHS_OK, L);
}

int FN(chs_screw_normalize)(const real V[6], real S[6], real *rate) {
  int status = finiteness_at_a_glance(V, 6);
  if (status != CHS_OK) return status;
  real e[3], w[3], size;
  if (largest(V, 3) > 0) {
    per_radian(V, e, w, &size);
    if (!is_finite(size)) return CHS_ERR_OVERFLOW;
    if (all_finite(w, 3)) {
      *rate = size;
      return put_axis(e, w, CHS_OK, S);
    }
  }
  size = unit(V + 3, w);
  if (!is_finite(size)) return CHS_ERR_OVERFLOW;
  if (size == 0) w[2] = 1;
  *rate = size;
  return put_axis(none, w, size > 0 ? CHS_PURE_TRANSLATION : CHS_NO_MOTION, S);
}

void FN(chs_screw_twist)(const real S[6], real rate, real V[6]) {
  real v[6];
  for (int i = 0; i < 6; i++) v[i] = rate * S[i];
  copy(v, 6, V);
}

void FN(chs_screw_reciprocal)(const real A[6], const real B[6], real *product) {
  *product = dot(A, B + 3) + dot(A + 3, B);
}

/* T exp([S] theta), or exp([S] theta) T. */
static int move(const real T[16], const real S[6], real theta, int in_body, real moved[16]) {
  real V[6], step[16], end[16];
  int status = first_error(FN(chs_p_check_pose)(T), first_error(finiteness(S, 6), finiteness(&theta, 1)));
  if (status != CHS_OK) return status;
  FN(chs_screw_twist)(S, theta, V);
  if (!all_finite(V, 3)) return CHS_ERR_ANGLE_RANGE;
  if (!all_finite(V, 6)) return CHS_ERR_OVERFLOW;
  status = FN(chs_se3_exp)(V, step);
  if (status != CHS_OK) return status;
  FN(chs_se3_compose)(in_body ? T : step, in_body ? step : T, end);
  if (!all_finite(end, 12)) return CHS_ERR_OVERFLOW;
  copy(end, 16, moved);
  return CHS_OK;
}

int FN(chs_screw_move_body)(const real T[16], const real S[6], real theta, real moved[16]) {
  return move(T, S, theta, 1, moved);
}

int FN(chs_screw_move_space)(const real T[16], const real S[6], real theta, real moved[16]) {
  return move(T, S, theta, 0, moved);
}
