/* The walk along a chain, from the fixed end to the tool. */
#ifndef CHASLES_CHAIN_PRIVATE_H
#define CHASLES_CHAIN_PRIVATE_H

#include "linear.h"
#include "pose.h"
#include "rotation.h"
#include <chasles/chain.h>
#include <chasles/se3.h>

#define is_chain(...) FN(chs_p_is_chain)(__VA_ARGS__)
#define move(...) FN(chs_p_move)(__VA_ARGS__)
#define frame_axis(...) FN(chs_p_frame_axis)(__VA_ARGS__)
#define turn_row(...) FN(chs_p_turn_row)(__VA_ARGS__)
#define turn(...) FN(chs_p_turn)(__VA_ARGS__)
#define get_column(...) FN(chs_p_get_column)(__VA_ARGS__)
#define put_column(...) FN(chs_p_put_column)(__VA_ARGS__)

#ifdef CHS_SINGLE
typedef chs_chainf chain;
#else
typedef chs_chain chain;
#endif

/* Joints, and one of the forms. */
SHARED int is_chain(const chain *c) {
  return c->joints >= 1 && (c->form == CHS_SPACE_FORM || c->form == CHS_BODY_FORM);
}

/* A pose on the way. */
typedef struct place {
  real R[9], p[3];
} place;

/* t <- t moved by (E, u) in its own frame. */
SHARED void move(place *t, const real E[9], const real u[3]) {
  real step[3];
  rotate(t->R, u, step);
  add_to(t->p, step);
  multiply(t->R, E, t->R);
}

/* Which of its frame's axes omega is, of either sign: 0, 1, 2; 3 where it is zero; -1 otherwise. */
SHARED int frame_axis(const real w[3]) {
  if (w[0] == 0) {
    if (w[1] == 0) return w[2] == 0 ? 3 : ABS(w[2]) == 1 ? 2 : -1;
    return w[2] == 0 && ABS(w[1]) == 1 ? 1 : -1;
  }
  return w[1] == 0 && w[2] == 0 && ABS(w[0]) == 1 ? 0 : -1;
}

/* A row of R, and what its place moves by, for a turn about the axis k = i x j of the frame. */
SHARED void turn_row(real row[3], int i, int j, int k, real sine, real cosine, const real u[3], real *p) {
  real x = row[i], y = row[j], z = row[k];
  row[i] = cosine * x + sine * y;
  row[j] = cosine * y - sine * x;
  *p += x * u[0] + y * u[1] + z * u[2];
}

/* A turn by q about axis k of t's frame or, where S[k] = -1, the other way round: two columns of R change. */
SHARED void turn(place *t, int k, const real S[6], real q, sine_cosine of_joint) {
  real sine = of_joint.sine, cosine = of_joint.cosine;
  int i = k == 2 ? 0 : k + 1, j = k == 0 ? 2 : k - 1;
  real versine = S[k] * (K(1.0) - cosine), vi = S[3 + i], vj = S[3 + j];
  const real u[3] = {sine * vi - versine * vj, sine * vj + versine * vi, q * S[3 + k]};
  sine *= S[k];
  turn_row(t->R, i, j, k, sine, cosine, u, t->p);
  turn_row(t->R + 3, i, j, k, sine, cosine, u, t->p + 1);
  turn_row(t->R + 6, i, j, k, sine, cosine, u, t->p + 2);
}

/* Why a chain and joint values gave no result. */
int FN(chs_p_why_no_walk)(const chain *c, const real *q);

/* The walk to the tool, and the columns of the Jacobian in the fixed frame; J may be NULL. False where something is out
 * of range or no number, which only t may tell: then J and t are of no use. */
int FN(chs_p_walk)(const chain *c, const real *q, real *J, place *t);

/* Column i of J, which is 6 x n. Written out, because compilers leave a loop a loop. */
SHARED void get_column(const real *J, int n, int i, real column[6]) {
  J += i;
  column[0] = J[0];
  column[1] = J[n];
  column[2] = J[2 * n];
  column[3] = J[3 * n];
  column[4] = J[4 * n];
  column[5] = J[5 * n];
}

SHARED void put_column(const real column[6], int n, int i, real *J) {
  J += i;
  J[0] = column[0];
  J[n] = column[1];
  J[2 * n] = column[2];
  J[3 * n] = column[3];
  J[4 * n] = column[4];
  J[5 * n] = column[5];
}

#endif
