#include <chasles/so3.h>

#include "rotation.h"

#ifdef CHS_SINGLE
#define DIFFERENCE 0x1p-8F /* about the cube root of eps */
#else
#define DIFFERENCE 0x1p-17
#endif
#define LONGEST_STEP K(0.5)
enum { HALVINGS = 8 };

typedef FN(chs_so3_residual) equations;

/* The equations, where they are taken, and how far they are from holding. */
typedef struct place {
  equations *residual;
  void *context;
  real R[9], f[3], rest;
} place;

static int take(place *p) {
  int status = p->residual(p->R, p->context, p->f);
  if (status < 0) return status;
  p->rest = norm(p->f, 3);
  return finiteness(p->f, 3);
}

/* The same where R is a rotation, for only that can be an answer: starts and turns drift. */
static int settle(place *p) {
  if (FN(chs_p_deviation)(p->R) > K(4.0) * EPS) FN(chs_so3_nearest)(p->R, p->R, NULL);
  return take(p);
}

/* The place after a turn, exp [w] R, where nothing is taken yet. */
static int turn(const place *from, const real w[3], place *to) {
  real E[9];
  int status = FN(chs_so3_exp)(w, E);
  if (status < 0) return status;
  *to = *from;
  FN(chs_so3_multiply)(E, from->R, to->R);
  return CHS_OK;
}

static int take_after(const place *from, const real w[3], place *to) {
  int status = turn(from, w, to);
  return status < 0 ? status : take(to);
}

/* The columns of df/dw. */
static int derivatives(const place *p, real columns[9]) {
  for (int i = 0; i < 3; i++) {
    real w[3] = {0, 0, 0}, *column = columns + 3 * i;
    place turned;
    w[i] = DIFFERENCE;
    int status = take_after(p, w, &turned);
    if (status < 0) return status;
    copy3(turned.f, column);
    w[i] = -DIFFERENCE;
    status = take_after(p, w, &turned);
    if (status < 0) return status;
    for (int j = 0; j < 3; j++) column[j] = (column[j] - turned.f[j]) / (K(2.0) * DIFFERENCE);
  }
  return CHS_OK;
}

/* w = -(df/dw)^-1 f by Cramer's rule, not longer than the longest step. */
static int newton_step(const place *p, real w[3]) {
  real A[9];
  int status = derivatives(p, A);
  if (status < 0) return status;
  real normals[9];
  cross(A + 3, A + 6, normals);
  cross(A + 6, A, normals + 3);
  cross(A, A + 3, normals + 6);
  real determinant = dot(A, normals), size = norm(A, 3) * norm(A + 3, 3) * norm(A + 6, 3);
  if (!(ABS(determinant) > DIFFERENCE * DIFFERENCE * size)) return CHS_ERR_SINGULAR; /* the differences' own error */
  for (int i = 0; i < 3; i++) w[i] = -dot(normals + 3 * i, p->f) / determinant;
  real length = norm(w, 3);
  for (int i = 0; i < 3 && length > LONGEST_STEP; i++) w[i] *= LONGEST_STEP / length;
  return CHS_OK;
}

/* Goes along w, less far each time, until it is nearer; *nearer says whether it came to be. */
static int advance(place *p, real w[3], int *nearer) {
  *nearer = 0;
  for (int k = 0; k < HALVINGS; k++) {
    place next;
    int status = turn(p, w, &next);
    if (status >= 0) status = settle(&next);
    if (status >= 0 && next.rest < p->rest) {
      *p = next;
      *nearer = 1;
      return CHS_OK;
    }
    for (int i = 0; i < 3; i++) w[i] *= K(0.5);
  }
  return CHS_OK;
}

int FN(chs_so3_solve)(equations *residual, void *context, const real start[9], real tolerance, int limit, real R[9],
                      real *rest) {
  if (!(tolerance >= 0) || limit < 0) return CHS_ERR_ARGUMENT;
  int status = check_rotation_apart(start);
  if (status != CHS_OK) return status;
  place p = {residual, context, {0}, {0}, 0};
  copy(start, 9, p.R);
  status = settle(&p);
  if (status < 0) return status;
  int nearer = 1;
  for (int k = 0; k < limit && nearer && p.rest > tolerance; k++) {
    real w[3];
    status = newton_step(&p, w);
    if (status >= 0) status = advance(&p, w, &nearer);
    if (status < 0) return status;
  }
  copy(p.R, 9, R);
  if (rest) *rest = p.rest;
  return p.rest <= tolerance ? CHS_OK : CHS_ITERATION_LIMIT;
}
