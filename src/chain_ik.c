#include "chain_private.h"

#include <stdint.h>

#ifdef CHS_SINGLE
typedef chs_ikf ik_options;
#else
typedef chs_ik ik_options;
#endif

/* Where a search is: joint values, their Jacobian and what is left to do. Both are of the tool's own point, in the
 * directions of the fixed frame, with lengths in the search's unit. */
typedef struct stand {
  real *q, *J;
  real error[6];
  real angle, length; /* of it, the length in the caller's unit */
  real square;        /* of the error */
} stand;

typedef struct search {
  const chain *c;
  const ik_options *options;
  place goal;
  real per_length; /* the angle that counts as much as a unit of length */
  int last;        /* no step will follow */
  stand now, next;
  real *dq, *weights, *start, *X;
} search;

enum { MOST_TRIES = 8 };

static int is_revolute(const real S[6]) {
  real ww = dot(S, S), pitch = dot(S, S + 3);
  return ABS(ww - K(1.0)) <= K(8.0) * EPS && ABS(pitch) <= K(8.0) * EPS * largest(S + 3, 3);
}

/* Whether joint i may go on beyond a limit because the other one leaves room for a whole turn. */
static int may_wind_back(const chain *c, int i) {
  return is_revolute(c->screws + 6 * i) && c->limits[2 * i + 1] - c->limits[2 * i] >= K(2.0) * CHS_PI_A;
}

/* Brings q within the limits: by a whole turn where that does it, otherwise to the limit. */
static void hold(const chain *c, real *q) {
  const real turn = K(2.0) * CHS_PI_A;
  for (int i = 0; c->limits && i < c->joints; i++) {
    real least = c->limits[2 * i], most = c->limits[2 * i + 1];
    if (q[i] < least && may_wind_back(c, i)) q[i] += turn;
    if (q[i] > most && may_wind_back(c, i)) q[i] -= turn;
    q[i] = q[i] < least ? least : q[i] > most ? most : q[i];
  }
}

/* Moves what the Jacobian tells of to the tool's own point. */
static void to_tool(const place *t, int n, real per_length, real *J) {
  for (int i = 0; i < n; i++) {
    real column[6], moment[3];
    get_column(J, n, i, column);
    cross(t->p, column, moment);
    for (int row = 0; row < 3; row++) column[3 + row] = (column[3 + row] - moment[row]) * per_length;
    put_column(column, n, i, J);
  }
}

/* What is left to do at at->q, and the Jacobian if more steps follow. CHS_OK; an error of the rotation; or
 * CHS_ERR_OVERFLOW where there is no place to look at. */
static int look(const search *s, stand *at) {
  place t;
  real back[9], left[9];
  if (!FN(chs_p_walk)(s->c, at->q, s->last ? NULL : at->J, &t)) return CHS_ERR_OVERFLOW;
  transpose(t.R, back);
  FN(chs_so3_multiply)(s->goal.R, back, left);
  int status = FN(chs_so3_log)(left, at->error);
  if (status < 0) return status;
  subtract(s->goal.p, t.p, at->error + 3);
  at->angle = norm(at->error, 3);
  at->length = norm(at->error + 3, 3);
  multiply_by(s->per_length, at->error + 3);
  real length = s->per_length * at->length;
  at->square = at->angle * at->angle + length * length;
  if (!s->last) to_tool(&t, s->c->joints, s->per_length, at->J);
  return CHS_OK;
}

static int is_there(const search *s, const stand *at) {
  return at->angle <= s->options->angle && at->length <= s->options->length;
}

/* The gradient of |error|^2 / 2 by joint i, its sign turned: which way the joint would have to move. */
static real pull(const stand *at, int n, int i) {
  real column[6];
  get_column(at->J, n, i, column);
  return dot(column, at->error) + dot(column + 3, at->error + 3);
}

/* Whether joint i is at a limit that it would have to move beyond. */
static int is_held(const search *s, const stand *at, int i) {
  if (!s->c->limits) return 0;
  real least = s->c->limits[2 * i], most = s->c->limits[2 * i + 1], q = at->q[i];
  if ((q > least && q < most) || may_wind_back(s->c, i)) return 0;
  real p = pull(at, s->c->joints, i);
  return p == 0 || (p < 0 && q <= least) || (p > 0 && q >= most);
}

/* A joint that turns by more than a quarter turn in a step is asked too much of: J tells of small motions only. */
static int is_small(const search *s) {
  for (int i = 0; i < s->c->joints; i++) {
    const real *w = s->c->screws + 6 * i;
    real turn = s->dq[i] * s->dq[i] * dot(w, w);
    if (!(turn <= CHS_HALF_PI_A * CHS_HALF_PI_A && is_finite(s->dq[i]))) return 0;
  }
  return 1;
}

/* Moves by dq if that brings the tool nearer. */
static int move_if_nearer(search *s) {
  if (!is_small(s)) return 0;
  for (int i = 0; i < s->c->joints; i++) s->next.q[i] = s->now.q[i] + s->dq[i];
  hold(s->c, s->next.q);
  if (look(s, &s->next) != CHS_OK || !(s->next.square < s->now.square)) return 0;
  stand left = s->now;
  s->now = s->next;
  s->next = left;
  return 1;
}

/* dq = J^-1 error, where J has one. */
APART static int solve_exactly(search *s) {
  real A[42], det;
  augment(s->now.J, s->now.error, 1, A);
  return FN(chs_p_eliminate)(A, s->dq, &det) > SQRT(EPS);
}

enum outcome { MOVED, STUCK, STUCK_AT_LIMIT, STUCK_SINGULAR };

/* Divides the columns of J by their lengths, so that radians and millimetres of joints count alike, and takes out those
 * of the joints that are held. What it means to be stuck here: held joints; or an error at right angles to all that the
 * joints can do. */
static enum outcome level_columns(search *s) {
  int n = s->c->joints, held = 0, blocked = 1;
  real length = SQRT(s->now.square);
  for (int i = 0; i < n; i++) {
    real column[6], p = pull(&s->now, n, i);
    get_column(s->now.J, n, i, column);
    real size = norm(column, 6);
    int keep = size > 0 && !is_held(s, &s->now, i);
    if (size > 0 && !keep) held = 1;
    if (keep && ABS(p) > K(1e-3) * size * length) blocked = 0;
    s->weights[i] = keep ? K(1.0) / size : K(0.0);
  }
  for (int i = 0; i < 6 * n; i++) s->now.J[i] *= s->weights[i % n];
  return held ? STUCK_AT_LIMIT : blocked ? STUCK_SINGULAR : STUCK;
}

/* Damped least squares; lambda = 0: the pseudoinverse. */
static int try_damped(search *s, const spectrum *sp, int count, real lambda) {
  FN(chs_p_damped_solution)(sp, s->X, count, s->now.error, lambda, s->dq);
  for (int i = 0; i < s->c->joints; i++) s->dq[i] *= s->weights[i];
  return move_if_nearer(s);
}

/* A singular Jacobian says nothing of one direction, in which the tool may yet get nearer by a motion of second order:
 * by as much as the root of the error, either way. */
static int try_blindly(search *s, const spectrum *sp) {
  const real *direction = sp->G + sp->k * sp->order[sp->k - 1];
  real far = SQRT(SQRT(s->now.square));
  for (int i = 0; i < 4 && sp->n <= 6; i++) {
    for (int j = 0; j < sp->n; j++) s->dq[j] = far * s->weights[j] * direction[j];
    if (move_if_nearer(s)) return 1;
    far *= i % 2 ? K(-0.5) : K(-1.0);
  }
  return 0;
}

static enum outcome step(search *s) {
  int n = s->c->joints, newton = s->options->method == CHS_IK_NEWTON, held = 0;
  for (int i = 0; i < n; i++) held |= is_held(s, &s->now, i);
  int direct = newton && n == 6 && !held;
  if (direct && solve_exactly(s) && move_if_nearer(s)) return MOVED;

  spectrum sp;
  enum outcome stuck = level_columns(s);
  if (!FN(chs_p_spectrum_of)(n, s->now.J, 1, s->X, &sp)) return stuck;
  if (newton && !direct && try_damped(s, &sp, FN(chs_p_rank_of)(&sp), 0)) return MOVED;
  real lambda = (newton ? K(0.1) : s->options->damping) * SQRT(s->now.square);
  for (int i = 0; i < MOST_TRIES; i++) {
    if (try_damped(s, &sp, sp.k, lambda)) return MOVED;
    lambda *= K(4.0);
  }
  return try_blindly(s, &sp) ? MOVED : stuck;
}

static int check_options(const chain *c, const ik_options *o) {
  const real numbers[3] = {o->angle, o->length, o->method == CHS_IK_DAMPED ? o->damping : K(1.0)};
  if (!is_chain(c) || o->steps < 0 || o->restarts < 0) return CHS_ERR_ARGUMENT;
  if (o->method != CHS_IK_NEWTON && o->method != CHS_IK_DAMPED) return CHS_ERR_ARGUMENT;
  int status = finiteness(numbers, 3);
  for (int i = 0; c->limits && i < c->joints; i++) {
    real least = c->limits[2 * i], most = c->limits[2 * i + 1];
    if (least != least || most != most) status = CHS_ERR_NAN;
    if (status == CHS_OK && least > most) status = CHS_ERR_ARGUMENT;
  }
  for (int i = 0; i < 3; i++)
    if (status == CHS_OK && numbers[i] <= 0) status = CHS_ERR_ARGUMENT;
  return status;
}

/* The angle that counts as much as a unit of length: in the ratio of the tolerances, but not so large that the tool's
 * turning would be lost beside the length of the way to it. */
static real weight_of_length(const chain *c, const place *goal, const ik_options *o) {
  const real home[3] = {c->home[3], c->home[7], c->home[11]};
  real wanted = o->angle / o->length, reach = largest(goal->p, 3), size = largest(home, 3);
  reach = size > reach ? size : reach;
  for (int i = 0; i < c->joints; i++) {
    size = largest(c->screws + 6 * i + 3, 3);
    reach = size > reach ? size : reach;
  }
  real most = K(1.0) / (SQRT(SQRT(EPS)) * (reach > 0 ? reach : K(1.0)));
  return wanted < most ? wanted : most;
}

/* Random numbers in [-1, 1), the same everywhere: a linear congruential generator of 32 bits (Knuth). */
static real random_share(uint32_t *state) {
  *state = *state * UINT32_C(1664525) + UINT32_C(1013904223);
  return (real)(*state >> 8) * K(0x1p-23) - K(1.0);
}

/* Other joint values to start from: the later, the farther from the first ones. */
static void start_elsewhere(const search *s, int turn, uint32_t *random, real *q) {
  const real *limits = s->c->limits;
  real far = turn < 5 ? K(0.1) * (real)(1 << turn) : CHS_PI_A;
  for (int i = 0; i < s->c->joints; i++) {
    const real *w = s->c->screws + 6 * i;
    real range = largest(w, 3) > 0 ? far : far / s->per_length, share = random_share(random);
    if (limits && limits[2 * i + 1] - limits[2 * i] < K(2.0) * CHS_PI_A * range / far)
      range = (limits[2 * i + 1] - limits[2 * i]) * far / (K(2.0) * CHS_PI_A);
    q[i] = s->start[i] + share * range;
  }
}

static enum outcome descend(search *s, int steps) {
  enum outcome outcome = MOVED;
  for (int i = 0; i < steps && outcome == MOVED && !is_there(s, &s->now); i++) {
    s->last = i == steps - 1;
    outcome = step(s);
  }
  s->last = 0;
  return outcome;
}

static int status_of(const search *s, enum outcome outcome) {
  if (is_there(s, &s->now)) return CHS_OK;
  return outcome == STUCK_AT_LIMIT   ? CHS_AT_JOINT_LIMIT
         : outcome == STUCK_SINGULAR ? CHS_NEAR_SINGULAR
                                     : CHS_ITERATION_LIMIT;
}

static int find(const chain *c, const real T[16], const real *start, const ik_options *o, int steps, int restarts,
                real *scratch, real *q, real residual[2]) {
  int n = c->joints, m = n > 6 ? n : 6, status = check_options(c, o);
  if (status != CHS_OK) return status;
  search s;
  s.c = c;
  s.options = o;
  s.last = 0;
  s.now.q = scratch;
  s.next.q = scratch + m;
  s.dq = scratch + 2 * m;
  s.weights = scratch + 3 * m;
  s.start = scratch + 4 * m;
  real *best = scratch + 5 * m;
  s.now.J = scratch + 6 * m;
  s.next.J = scratch + 12 * m;
  s.X = scratch + 18 * m;
  part(T, s.goal.R, s.goal.p);
  status = first_error(check_rotation_apart(s.goal.R), finiteness(s.goal.p, 3));
  status = first_error(status, finiteness(start, n));
  if (status != CHS_OK) {
    status = first_error(status, finiteness(c->screws, 6 * n));
    return first_error(status, finiteness(c->home, 12));
  }
  s.per_length = weight_of_length(c, &s.goal, o);
  copy(start, n, s.start);
  copy(start, n, s.now.q);
  hold(c, s.now.q);
  status = look(&s, &s.now);
  if (status == CHS_ERR_OVERFLOW) status = FN(chs_p_why_no_walk)(c, s.now.q);
  if (status < 0) return status;

  real left[2] = {0, 0}, least = 0;
  uint32_t random = 1;
  for (int turn = 0; turn <= restarts; turn++) {
    if (turn > 0) {
      start_elsewhere(&s, turn - 1, &random, s.now.q);
      hold(c, s.now.q);
      if (look(&s, &s.now) != CHS_OK) continue;
    }
    int answer = status_of(&s, descend(&s, steps));
    if (turn > 0 && answer != CHS_OK && s.now.square >= least) continue;
    status = answer;
    least = s.now.square;
    left[0] = s.now.angle;
    left[1] = s.now.length;
    copy(s.now.q, n, best);
    if (status == CHS_OK) break;
  }
  copy(best, n, q);
  if (residual) copy(left, 2, residual);
  return status;
}

int FN(chs_chain_ik)(const chain *c, const real T[16], const real *start, const ik_options *o, real *scratch, real *q,
                     real residual[2]) {
  return find(c, T, start, o, o->steps, o->restarts, scratch, q, residual);
}

int FN(chs_chain_ik_step)(const chain *c, const real T[16], const real *start, const ik_options *o, real *scratch,
                          real *q, real residual[2]) {
  return find(c, T, start, o, 1, 0, scratch, q, residual);
}
