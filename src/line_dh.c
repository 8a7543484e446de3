/* Chains of joint axes and the parameters of Denavit and Hartenberg. Both ways are walked twice: once to find what is
 * wrong, and once more to write. */
#include <chasles/line.h>

#include <chasles/se3.h>

#include "line_private.h"
#include "pose.h"

/* A frame on a line, its z axis. */
typedef struct frame {
  real x[3], z[3], o[3];
} frame;

static void pose_of(const frame *f, real T[16]) {
  real y[3], R[9];
  cross(f->z, f->x, y);
  for (int i = 0; i < 3; i++) {
    R[3 * i] = f->x[i];
    R[3 * i + 1] = y[i];
    R[3 * i + 2] = f->z[i];
  }
  join(R, f->o, T);
}

static int arguments_are_right(int n, chs_dh convention) {
  return n >= 1 && (convention == CHS_DH_STANDARD || convention == CHS_DH_MODIFIED);
}

/* ---- Axes from parameters ---- */

static const real identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/* T <- T times a turn about, and a travel along, its axis `along`, 0 for x and 2 for z. */
static void advance(real T[16], int along, real angle, real travel) {
  int u = (along + 1) % 3, v = (along + 2) % 3;
  sine_cosine turn = sin_cos_of(angle);
  real s = turn.sine, c = turn.cosine;
  for (int i = 0; i < 12; i += 4) {
    real a = T[i + u], b = T[i + v];
    T[i + 3] += travel * T[i + along];
    T[i + u] = c * a + s * b;
    T[i + v] = c * b - s * a;
  }
}

/* The line of the pose's z axis. */
static void z_line(const real T[16], real L[6]) {
  const real z[3] = {T[2], T[6], T[10]}, p[3] = {T[3], T[7], T[11]};
  copy(z, 3, L);
  cross(p, z, L + 3);
}

/* False where something overflows; axes may be NULL. */
static int walk_rows(int n, chs_dh convention, const real base[16], const real *dh, const real tool[16], real *axes,
                     real home[16]) {
  real T[16], L[6];
  copy(base, 12, T);
  int good = 1;
  for (int i = 0; i < n; i++) {
    const real *row = dh + 4 * i;
    if (convention == CHS_DH_MODIFIED) advance(T, 0, row[1], row[0]);
    z_line(T, L);
    good = good && all_finite(L, 6);
    if (axes) copy(L, 6, axes + 6 * i);
    advance(T, 2, row[3], row[2]);
    if (convention == CHS_DH_STANDARD) advance(T, 0, row[1], row[0]);
  }
  FN(chs_se3_compose)(T, tool, home);
  return good && all_finite(home, 12);
}

int FN(chs_line_from_dh)(int n, chs_dh convention, const real base[16], const real *dh, const real tool[16], real *axes,
                         real home[16]) {
  if (!arguments_are_right(n, convention)) return CHS_ERR_ARGUMENT;
  real end[16], B[16], E[16];
  copy(base ? base : identity, 12, B);
  copy(tool ? tool : identity, 12, E);
  int status = first_error(FN(chs_p_check_pose)(B), FN(chs_p_check_pose)(E));
  status = first_error(status, finiteness(dh, 4 * n));
  if (status != CHS_OK) return status;
  for (int i = 0; i < n; i++)
    if (ABS(dh[4 * i + 1]) > ANGLE_MAX || ABS(dh[4 * i + 3]) > ANGLE_MAX) return CHS_ERR_ANGLE_RANGE;
  if (!walk_rows(n, convention, B, dh, E, NULL, end)) return CHS_ERR_OVERFLOW;
  walk_rows(n, convention, B, dh, E, axes, end);
  if (home) copy(end, 16, home);
  return CHS_OK;
}

/* ---- Parameters from axes ---- */

typedef struct chain {
  int n;
  chs_dh convention;
  const real *axes;
  real home[16], tool[6]; /* the tool's pose, and its z axis as a line */
  real zero, near;        /* the tolerance, and that share of the length it is also relative to */
} chain;

/* A link: the perpendicular of two lines, with its sense. */
typedef struct link {
  real a, alpha;
  frame end; /* its x axis, the second line as z axis, and its foot there */
  real foot[3];
  int status;
} link;

static const real base_axes[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

/* What is as near as may be to the first of the axes across z or, where that is within 30 degrees of z, to the
 * second. */
static void nearest_across(const real z[3], const real first[3], const real second[3], real x[3]) {
  real along = dot(first, z);
  const real *axis = first;
  if (ABS(along) > K(0.866025403784438647)) { /* cos 30 deg */
    axis = second;
    along = dot(second, z);
  }
  for (int i = 0; i < 3; i++) x[i] = axis[i] - along * z[i];
  unit(x, x);
}

/* A column of the tool's pose: its axes, and its position. */
static void tool_column(const chain *c, int k, real column[3]) {
  for (int i = 0; i < 3; i++) column[i] = c->home[4 * i + k];
}

/* The k-th of the n + 1 lines: the axes, before them the base's z axis or behind them the tool's. */
static const real *line_at(const chain *c, int k) {
  static const real base_line[6] = {0, 0, 1, 0, 0, 0};
  int i = c->convention == CHS_DH_MODIFIED ? k - 1 : k;
  return i < 0 ? base_line : i == c->n ? c->tool : c->axes + 6 * i;
}

static void start_at(const chain *c, frame *f) {
  line l = line_of(line_at(c, 0));
  point_of(&l, f->o);
  copy3(l.d, f->z);
  nearest_across(f->z, base_axes, base_axes + 3, f->x);
}

/* The link from line k - 1, on which the frame f lies, to line k. */
static void link_of(const chain *c, const frame *f, int k, link *l) {
  const real *A = line_at(c, k - 1), *B = line_at(c, k);
  between r = between_lines(A, B, c->zero, c->near);
  int to_tool = c->convention == CHS_DH_STANDARD && k == c->n, coincident = r.status == CHS_COINCIDENT;
  l->a = r.distance;
  l->alpha = r.angle;
  l->status = r.status;
  copy3(r.x, l->end.x);
  copy3(r.b.d, l->end.z);
  if (coincident || r.status == CHS_PARALLEL) {
    copy3(f->o, l->foot);
    if (to_tool) tool_column(c, 3, l->foot);
    foot_on(&r.a, l->foot, l->foot);
    foot_on(&r.b, l->foot, l->end.o);
    l->alpha = dot(A, B) < 0 ? CHS_PI_A : K(0.0);
  } else
    feet_of(&r, l->foot, l->end.o);
  if (coincident) {
    copy3(f->x, l->end.x);
    if (to_tool) tool_column(c, 0, l->end.x);
  } else if (dot(l->end.x, f->x) < -c->zero) {
    for (int i = 0; i < 3; i++) l->end.x[i] = -l->end.x[i];
    l->a = -l->a;
    l->alpha = r.status == CHS_PARALLEL ? l->alpha : -l->alpha;
  }
  if (coincident || r.status == CHS_INTERSECTING) l->a = 0;
}

/* d and theta from the frame to another x axis and origin on its line. */
static void joint_of(const frame *f, const real x[3], const real o[3], real d_theta[2]) {
  real side[3], travel[3];
  cross(f->x, x, side);
  subtract(o, f->o, travel);
  d_theta[0] = dot(f->z, travel);
  d_theta[1] = signed_angle_of(dot(f->z, side), dot(f->x, x));
}

/* The frame of the last row, on the same line as the frame f before its joint turns. */
static void last_of(const chain *c, const frame *f, frame *last) {
  real first[3], second[3], p[3];
  line l = line_of(line_at(c, c->n));
  tool_column(c, 0, first);
  tool_column(c, 1, second);
  tool_column(c, 3, p);
  copy3(f->z, last->z);
  nearest_across(f->z, first, second, last->x);
  foot_on(&l, p, last->o);
}

/* CHS_OK, CHS_PARALLEL, CHS_COINCIDENT or CHS_ERR_OVERFLOW; dh, base and tool may be NULL. */
static int walk_axes(const chain *c, real *dh, real *base, real *tool) {
  int modified = c->convention == CHS_DH_MODIFIED, status = CHS_OK, good = 1;
  real row[4], T[16];
  frame f, first;
  start_at(c, &f);
  first = f;
  for (int k = 1; k <= c->n; k++) {
    link l;
    link_of(c, &f, k, &l);
    /* Its joint is that of the row, or of the row before, and of no row before the first. */
    row[0] = l.a;
    row[1] = l.alpha;
    joint_of(&f, l.end.x, l.foot, row + 2);
    good = good && all_finite(row, 4);
    if (modified && k == 1) {
      copy3(l.end.x, f.x);
      copy3(l.foot, f.o);
      first = f;
    }
    if (dh) copy(row, 2, dh + 4 * (k - 1));
    if (dh && k > modified) copy(row + 2, 2, dh + 4 * (k - 1 - modified) + 2);
    if (modified ? k > 1 : k < c->n)
      if (l.status == CHS_COINCIDENT || (l.status == CHS_PARALLEL && status == CHS_OK)) status = l.status;
    f = l.end;
  }
  if (modified) {
    frame last;
    last_of(c, &f, &last);
    joint_of(&f, last.x, last.o, row);
    good = good && all_finite(row, 2);
    if (dh) copy(row, 2, dh + 4 * (c->n - 1) + 2);
    f = last;
  }
  pose_of(&first, T);
  good = good && all_finite(T, 12);
  if (base) copy(T, 16, base);
  pose_of(&f, T);
  FN(chs_se3_inverse)(T, T);
  FN(chs_se3_compose)(T, c->home, T);
  if (tool) copy(T, 16, tool);
  return good && all_finite(T, 12) ? status : CHS_ERR_OVERFLOW;
}

int FN(chs_line_to_dh)(int n, chs_dh convention, const real *axes, const real home[16], real tolerance, real *dh,
                       real base[16], real tool[16]) {
  if (!arguments_are_right(n, convention)) return CHS_ERR_ARGUMENT;
  chain c = {n, convention, axes, {0}, {0}, tolerance > ROUNDING ? tolerance : ROUNDING, 0};
  real p[3];
  int status = first_error(FN(chs_p_check_pose)(home), finiteness(&tolerance, 1));
  for (int i = 0; i < n; i++) status = first_error(status, check_line(axes + 6 * i));
  if (status != CHS_OK) return status;
  if (tolerance < 0) return CHS_ERR_ARGUMENT;
  copy(home, 12, c.home);
  z_line(home, c.tool);
  tool_column(&c, 3, p);
  c.near = zero_of(c.zero, p);
  for (int i = 0; i < n; i++) {
    real near = zero_of(c.zero, axes + 6 * i + 3);
    c.near = near > c.near ? near : c.near;
  }
  if (walk_axes(&c, NULL, NULL, NULL) < 0) return CHS_ERR_OVERFLOW;
  return walk_axes(&c, dh, base, tool);
}
