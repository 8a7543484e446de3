#include "chain_private.h"
#include "exact.h"

#include <string.h>

/* omega x v and omega . v, rounded once or twice. In a revolute joint omega . v is nothing but rounding, and q times
 * that would count; and omega x v counts up to twice. */
static void exact_products(const real S[6], real wxv[3], real *pitch) {
  real scale = safe_to_square(largest(S + 3, 3)), v[3] = {scale * S[3], scale * S[4], scale * S[5]};
  exact_sum sum = product(S[0], v[0]);
  add(&sum, product(S[1], v[1]));
  add(&sum, product(S[2], v[2]));
  *pitch = (sum.hi + sum.lo) / scale;
  exact_cross(S, v, wxv);
  multiply_by(K(1.0) / scale, wxv);
}

/* omega . omega - 1 where that is small, but for the rounding of the squares. */
static real excess_of(const real w[3]) {
  split_square square = squared_length(w);
  return (square.head - K(1.0)) + square.rest;
}

/* A turn by q about any unit axis, which rounding has made longer or shorter by a few eps. The formula G(q) v = q v +
 * (1 - cos q) w x v + (q - sin q) w x (w x v) needs no second cross product, as w . w = 1. */
APART static void turn_about(place *t, real excess, real q, sine_cosine of_joint, const real S[6]) {
  real sine = of_joint.sine, cosine = of_joint.cosine;
  real E[9], u[3], wxv[3], versine = K(1.0) - cosine;
  const real *w = S, *v = S + 3;
  real pitch = dot(w, v);
  cross(w, v, wxv);
  if (ABS(q) > 1) exact_products(S, wxv, &pitch);
  real along = (q - sine) * (pitch - K(1.5) * excess * pitch);
  /* Beyond a quarter turn the versine is 2 less something small, and 2 wxv is not rounded. */
  real whole = cosine < 0 ? K(2.0) : K(0.0), rest = ((K(1.0) - whole) - cosine) - excess * versine;
  sine -= K(0.5) * excess * sine;
  versine -= excess * versine;
  rotation_from(w, sine, K(0.5) * versine, K(0.5) + K(0.5) * cosine, E);
  for (int i = 0; i < 3; i++) u[i] = whole * wxv[i] + (sine * v[i] + (rest * wxv[i] + along * w[i]));
  move(t, E, u);
}

/* t <- t exp([S] q), where omega is of no use as it is; a NaN where that is out of range. */
SELDOM static void advance_by_exp(place *t, const real S[6], real q) {
  real V[6], T[16];
  for (int i = 0; i < 6; i++) V[i] = q * S[i];
  if (FN(chs_se3_exp)(V, T) < 0) {
    t->p[0] = (real)NAN;
    return;
  }
  part(T, T, V);
  move(t, T, V);
}

static void slide(place *t, const real S[6], real q) {
  real v[3] = {q * S[3], q * S[4], q * S[5]};
  rotate(t->R, v, v);
  add_to(t->p, v);
}

static void advance_about(place *t, const real S[6], real q) {
  real excess = excess_of(S);
  if (ABS(excess) <= K(8.0) * EPS)
    turn_about(t, excess, q, sin_cos_of(q), S);
  else
    advance_by_exp(t, S, q);
}

/* t <- t exp([S] q), k being the frame's axis of S. Something in t is no number where something in S or q is none, or
 * where q is out of range. */
static void advance(place *t, int k, const real S[6], real q) {
  if (k == 3)
    slide(t, S, q);
  else if (k >= 0)
    turn(t, k, S, q, sin_cos_of(q));
  else
    advance_about(t, S, q);
}

/* Where the walk starts: at the fixed frame, or at the home pose. */
static void start(const chain *c, place *t) {
  static const place origin = {{1, 0, 0, 0, 1, 0, 0, 0, 1}, {0, 0, 0}};
  if (c->form == CHS_BODY_FORM)
    part(c->home, t->R, t->p);
  else
    *t = origin;
}

/* From the end of the walk to the tool. */
static void finish(const chain *c, place *t) {
  real M[9], p[3];
  if (c->form == CHS_BODY_FORM) return;
  part(c->home, M, p);
  move(t, M, p);
}

/* In the body form, t <- t M^-1: from a place to how far the link has gone. */
static void leave_home(const chain *c, place *t) {
  real M[9], p[3];
  if (c->form != CHS_BODY_FORM) return;
  part(c->home, M, p);
  transpose(M, M);
  multiply(t->R, M, t->R);
  rotate(t->R, p, p);
  subtract(t->p, p, t->p);
}

static int is_finite_place(const place *t) { return all_finite(t->R, 9) && all_finite(t->p, 3); }

int FN(chs_p_why_no_walk)(const chain *c, const real *q) {
  if (!is_chain(c)) return CHS_ERR_ARGUMENT;
  int status = first_error(finiteness(c->screws, 6 * c->joints), finiteness(q, c->joints));
  status = first_error(status, finiteness(c->home, 12)); /* the last row is never read */
  for (int i = 0; i < c->joints && status == CHS_OK; i++)
    if (norm(c->screws + 6 * i, 3) * ABS(q[i]) >= (K(1.0) - K(8.0) * EPS) * ANGLE_MAX) status = CHS_ERR_ANGLE_RANGE;
  return status == CHS_OK ? CHS_ERR_OVERFLOW : status;
}

/* Ad(t) S, the column of the Jacobian of a joint at t, k being the frame's axis of S. */
static inline void column_of(const place *t, int k, const real S[6], real column[6]) {
  real moment[3];
  if (k >= 0 && k < 3) {
    column[0] = S[k] * t->R[k];
    column[1] = S[k] * t->R[3 + k];
    column[2] = S[k] * t->R[6 + k];
  } else {
    rotate(t->R, S, column);
  }
  rotate(t->R, S + 3, column + 3);
  cross(t->p, column, moment);
  add_to(column + 3, moment);
}

/* Ad(t)^-1, in place. */
static inline void into_frame_of(const place *t, real column[6]) {
  real moment[3];
  cross(t->p, column, moment);
  subtract(column + 3, moment, column + 3);
  rotate_back(t->R, column, column);
  rotate_back(t->R, column + 3, column + 3);
}

int FN(chs_p_walk)(const chain *c, const real *q, real *J, place *t) {
  start(c, t);
  for (int i = 0; i < c->joints; i++) {
    const real *S = c->screws + 6 * i;
    real column[6], joint = q[i];
    int k = frame_axis(S);
    if (J) {
      column_of(t, k, S, column);
      put_column(column, c->joints, i, J);
    }
    advance(t, k, S, joint);
  }
  finish(c, t);
  return is_chain(c) && is_finite_place(t);
}

int FN(chs_chain_fk)(const chain *c, const real *q, real T[16]) {
  place t;
  if (!FN(chs_p_walk)(c, q, NULL, &t)) return FN(chs_p_why_no_walk)(c, q);
  join(t.R, t.p, T);
  return CHS_OK;
}

/* Numbers so ordinary that nothing can come out of range: what most calls need to be told. The sums are poisoned by
 * whatever is not finite. */
static int is_ordinary(const chain *c, const real *q) {
  const real *M = c->home;
  real turns = 0, lengths = ABS(M[3]) + ABS(M[7]) + ABS(M[11]);
  real entries =
      ABS(M[0]) + ABS(M[1]) + ABS(M[2]) + ABS(M[4]) + ABS(M[5]) + ABS(M[6]) + ABS(M[8]) + ABS(M[9]) + ABS(M[10]);
  for (int i = 0; i < c->joints; i++) {
    const real *S = c->screws + 6 * i;
    real times = K(1.0) + ABS(q[i]);
    turns += (ABS(S[0]) + ABS(S[1]) + ABS(S[2])) * times;
    lengths += (ABS(S[3]) + ABS(S[4]) + ABS(S[5])) * times;
  }
  return is_chain(c) && entries <= 8 && turns <= K(1.0) / (K(64.0) * EPS) && lengths <= K(0x1p-48) * REAL_MAX;
}

/* A walk that writes nothing: is every number of the places and columns finite, columns seen from `frame`,
 * displacements from the fixed frame? Gives the tool's place. */
static int rehearse(const chain *c, const real *q, const place *frame, place *t) {
  int good = is_chain(c);
  start(c, t);
  for (int i = 0; i < c->joints && good; i++) {
    const real *S = c->screws + 6 * i;
    real column[6];
    int k = frame_axis(S);
    column_of(t, k, S, column);
    if (frame) into_frame_of(frame, column);
    good = all_finite(column, 6);
    advance(t, k, S, q[i]);
    place displacement = *t;
    leave_home(c, &displacement);
    good = good && is_finite_place(&displacement);
  }
  finish(c, t);
  return good && is_finite_place(t);
}

/* may_walk for numbers of any size. */
SELDOM static int may_walk_so_far(const chain *c, const real *q) {
  place t, end;
  return rehearse(c, q, NULL, &end) && rehearse(c, q, &end, &t) ? CHS_OK : FN(chs_p_why_no_walk)(c, q);
}

/* CHS_OK where the walk may write its results as it goes, or why there are none. */
static int may_walk(const chain *c, const real *q) { return is_ordinary(c, q) ? CHS_OK : may_walk_so_far(c, q); }

/* The joint values moved to the end of an output that they may overlap. Each is read before what takes its place is
 * written. */
static const real *keep(const real *q, int n, real *end) {
  memmove(end, q, (size_t)n * sizeof *q);
  return end;
}

/* Apart from what finds out whether they may be, so that only the stack of one is taken at a time. */
APART static void write_links(const chain *c, const real *q, real *D) {
  place t;
  int n = c->joints;
  q = keep(q, n, D + 15 * n);
  start(c, &t);
  for (int i = 0; i < n; i++) {
    advance(&t, frame_axis(c->screws + 6 * i), c->screws + 6 * i, q[i]);
    place displacement = t;
    leave_home(c, &displacement);
    join(displacement.R, displacement.p, D + 16 * i);
  }
}

/* T may be NULL. */
APART static void write_jacobian(const chain *c, const real *q, int body, real *J, real T[16]) {
  place t;
  int n = c->joints;
  FN(chs_p_walk)(c, keep(q, n, J + 5 * n), J, &t);
  for (int i = 0; i < n && body; i++) {
    real column[6];
    get_column(J, n, i, column);
    into_frame_of(&t, column);
    put_column(column, n, i, J);
  }
  if (T) join(t.R, t.p, T);
}

int FN(chs_chain_links)(const chain *c, const real *q, real *D) {
  int status = may_walk(c, q);
  if (status == CHS_OK) write_links(c, q, D);
  return status;
}

int FN(chs_chain_space_jacobian)(const chain *c, const real *q, real *J, real T[16]) {
  int status = may_walk(c, q);
  if (status == CHS_OK) write_jacobian(c, q, 0, J, T);
  return status;
}

int FN(chs_chain_body_jacobian)(const chain *c, const real *q, real *J, real T[16]) {
  int status = may_walk(c, q);
  if (status == CHS_OK) write_jacobian(c, q, 1, J, T);
  return status;
}
