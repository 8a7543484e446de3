#include <chasles/tilt.h>

#include "pose.h"

/* What a pose of a few eps may show of errors where there are none, in radians and for a position of size 1. */
#define ROUNDING (K(16.0) * EPS)

enum { MEASURES = 3, MOST_CALLS = 1 << 30 };

typedef FN(chs_tilt_robot) kinematics;

/* The robot, its nominal pose, and the joint values tried (q) and found worst (best, n a measure), in the caller's
 * scratch memory. */
typedef struct study {
  kinematics *robot;
  void *context;
  int n, steps;
  const real *joints, *errors;
  real R[9], p[3];
  real *q, *best;
  real worst[MEASURES];
  real rounding[MEASURES]; /* a gain that is no larger is none */
  int status;              /* the first that was positive, or CHS_OK */
} study;

static int note(study *s, int status) {
  if (s->status == CHS_OK && status > 0) s->status = status;
  return status;
}

static int pose_of_robot(study *s, const real *q, real R[9], real p[3]) {
  real T[16];
  int status = note(s, s->robot(q, s->context, T));
  if (status < 0) return status;
  part(T, R, p);
  return finiteness(p, 3);
}

/* Alpha, beta and the distance at s->q. */
static int errors_at(study *s, real error[MEASURES]) {
  real R[9], p[3];
  int status = pose_of_robot(s, s->q, R, p);
  if (status < 0) return status;
  status = note(s, FN(chs_tilt_error)(s->R, R, error, error + 1));
  if (status < 0) return status;
  subtract(p, s->p, p);
  error[2] = norm(p, 3);
  return CHS_OK;
}

static int is_worse(const study *s, int m, const real error[MEASURES]) {
  return error[m] > s->worst[m] + s->rounding[m];
}

/* Of `steps` values from -1 to 1 that of the index; both ends exactly. */
static real part_of_interval(int index, int steps) { return (real)(2 * index - (steps - 1)) / (real)(steps - 1); }

static int search_grid(study *s, int calls) {
  for (int k = 0; k < calls; k++) {
    int rest = k;
    for (int i = 0; i < s->n; i++, rest /= s->steps)
      s->q[i] = s->joints[i] + s->errors[i] * part_of_interval(rest % s->steps, s->steps);
    real error[MEASURES];
    int status = errors_at(s, error);
    if (status < 0) return status;
    for (int m = 0; m < MEASURES; m++) {
      if (k > 0 && !is_worse(s, m, error)) continue;
      s->worst[m] = error[m];
      copy(s->q, s->n, s->best + m * s->n);
    }
  }
  return CHS_OK;
}

static real within(real x, real low, real high) { return x < low ? low : x > high ? high : x; }

/* Steps of a part of the errors along each joint, both ways; *higher counts those that made the measure larger. */
static int climb_once(study *s, int m, real part, int *higher) {
  real *best = s->best + m * s->n;
  for (int i = 0; i < s->n; i++)
    for (int way = -1; way <= 1; way += 2) {
      real low = s->joints[i] - s->errors[i], high = s->joints[i] + s->errors[i], error[MEASURES];
      copy(best, s->n, s->q);
      s->q[i] = within(best[i] + (real)way * part * s->errors[i], low, high);
      int status = errors_at(s, error);
      if (status < 0) return status;
      if (!is_worse(s, m, error)) continue;
      s->worst[m] = error[m];
      best[i] = s->q[i];
      ++*higher;
    }
  return CHS_OK;
}

/* Up to four rounds with each step, while they gain something. */
static int climb(study *s, int m, int refine) {
  real part = K(1.0) / (real)(s->steps - 1);
  for (int k = 0; k < refine; k++, part *= K(0.5)) {
    int higher = 1;
    for (int again = 0; again < 4 && higher; again++) {
      higher = 0;
      int status = climb_once(s, m, part, &higher);
      if (status < 0) return status;
    }
  }
  return CHS_OK;
}

/* steps^n, or 0 where it is too many. */
static int grid_size(int n, int steps) {
  int calls = 1;
  for (int i = 0; i < n; i++) {
    if (calls > MOST_CALLS / steps) return 0;
    calls *= steps;
  }
  return calls;
}

int FN(chs_tilt_worst)(kinematics *robot, void *context, int n, const real *joints, const real *errors, int steps,
                       int refine, real *scratch, real worst[3], real *where) {
  if (n < 1 || steps < 2 || refine < 0) return CHS_ERR_ARGUMENT;
  int calls = grid_size(n, steps);
  if (calls == 0) return CHS_ERR_ARGUMENT;
  int status = first_error(finiteness(joints, n), finiteness(errors, n));
  if (status != CHS_OK) return status;
  for (int i = 0; i < n; i++)
    if (errors[i] < 0) return CHS_ERR_ARGUMENT;

  study s = {robot, context, n, steps, joints, errors, {0}, {0}, scratch, scratch + n, {0}, {0}, CHS_OK};
  status = pose_of_robot(&s, joints, s.R, s.p);
  s.rounding[0] = s.rounding[1] = ROUNDING;
  s.rounding[2] = ROUNDING * norm(s.p, 3);
  if (status >= 0) status = search_grid(&s, calls);
  for (int m = 0; m < MEASURES && status >= 0; m++) status = climb(&s, m, refine);
  if (status < 0) return status;
  copy(s.worst, MEASURES, worst);
  if (where) copy(s.best, MEASURES * n, where);
  return s.status;
}
