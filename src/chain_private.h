/* The walk along a chain, from the fixed end to the tool. */
#ifndef CHASLES_CHAIN_PRIVATE_H
#define CHASLES_CHAIN_PRIVATE_H

#include "linear.h"
#include "pose.h"
#include "rotation.h"
#include <chasles/chain.h>
#include <chasles/se3.h>

#define move(...) FN(chs_p_move)(__VA_ARGS__)
#define frame_axis(...) FN(chs_p_frame_axis)(__VA_ARGS__)
#define turn(...) FN(chs_p_turn)(__VA_ARGS__)
#define excess_of(...) FN(chs_p_excess_of)(__VA_ARGS__)
#define turn_about(...) FN(chs_p_turn_about)(__VA_ARGS__)
#define advance(...) FN(chs_p_advance)(__VA_ARGS__)
#define get_column(...) FN(chs_p_get_column)(__VA_ARGS__)
#define put_column(...) FN(chs_p_put_column)(__VA_ARGS__)

#ifdef CHS_SINGLE
typedef chs_chainf chain;
#else
typedef chs_chain chain;
#endif

/* A pose on the way. */
typedef struct place {
  real R[9], p[3];
} place;

/* t <- t moved by (E, u) in its own frame. */
SHARED void move(place *t, const real E[9], const real u[3]) {
  real step[3];
  rotate(t->R, u, step);
  for (int i = 0; i < 3; i++) t->p[i] += step[i];
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

/* A turn by q about the axis k = i x j of t's frame, of a joint with the given v: two columns of R change. */
SHARED int turn(place *t, int i, int j, int k, real q, const real v[3]) {
  real sine, cosine;
  if (!sin_cos_of(q, &sine, &cosine)) return 0;
  real versine = K(1.0) - cosine;
  real ui = sine * v[i] - versine * v[j], uj = sine * v[j] + versine * v[i], uk = q * v[k];
  for (int row = 0; row < 9; row += 3) {
    real x = t->R[row + i], y = t->R[row + j], z = t->R[row + k];
    t->R[row + i] = cosine * x + sine * y;
    t->R[row + j] = cosine * y - sine * x;
    t->p[row / 3] += x * ui + y * uj + z * uk;
  }
  return 1;
}

/* omega . v of a joint rounded once: in a revolute joint it is nothing but rounding, and q times that would count. */
real FN(chs_p_exact_pitch)(const real S[6]);

/* omega . omega - 1, to full precision where that is small. */
SHARED real excess_of(const real w[3]) {
  split_square square = squared_length(w);
  return (square.head - K(1.0)) + square.rest;
}

/* A turn by q about any unit axis, which rounding has made longer or shorter by a few eps. The formula G(q) v = q v +
 * (1 - cos q) w x v + (q - sin q) w x (w x v) needs no second cross product, as w . w = 1. */
SHARED int turn_about(place *t, real excess, real q, const real S[6]) {
  real sine, cosine, E[9], u[3], wxv[3];
  const real *w = S, *v = S + 3;
  if (!sin_cos_of(q, &sine, &cosine)) return 0;
  real versine = K(1.0) - cosine, pitch = ABS(q) <= 1 ? dot(w, v) : FN(chs_p_exact_pitch)(S);
  real along = (q - sine) * (pitch - K(1.5) * excess * pitch);
  sine -= K(0.5) * excess * sine;
  versine -= excess * versine;
  rotation_from(w, sine, K(0.5) * versine, K(0.5) + K(0.5) * cosine, E);
  cross(w, v, wxv);
  for (int i = 0; i < 3; i++) u[i] = sine * v[i] + (versine * wxv[i] + along * w[i]);
  move(t, E, u);
  return 1;
}

/* t <- t exp([S] q), where omega is of no use as it is. */
int FN(chs_p_advance_by_exp)(place *t, const real S[6], real q);

/* t <- t exp([S] q). False where q is out of range or something is no number; t is then of no use. */
SHARED int advance(place *t, const real S[6], real q) {
  int k = frame_axis(S);
  real v[3];
  if (k == 3) {
    for (int i = 0; i < 3; i++) v[i] = q * S[3 + i];
    rotate(t->R, v, v);
    for (int i = 0; i < 3; i++) t->p[i] += v[i];
    return 1;
  }
  if (k < 0) {
    real excess = excess_of(S);
    return ABS(excess) <= K(8.0) * EPS ? turn_about(t, excess, q, S) : FN(chs_p_advance_by_exp)(t, S, q);
  }
  /* The same joint with its axis turned round where it points backwards. */
  real sign = S[k];
  for (int i = 0; i < 3; i++) v[i] = sign * S[3 + i];
  q = sign * q;
  return k == 0 ? turn(t, 1, 2, 0, q, v) : k == 1 ? turn(t, 2, 0, 1, q, v) : turn(t, 0, 1, 2, q, v);
}

/* Why a chain and joint values gave no result. */
int FN(chs_p_why_no_walk)(const chain *c, const real *q);

/* The walk to the tool, and the columns of the Jacobian in the fixed frame; J may be NULL. False where something is out
 * of range or no number, which only t may tell: then J and t are of no use. */
int FN(chs_p_walk)(const chain *c, const real *q, real *J, place *t);

/* Column i of J, which is 6 x n. */
SHARED void get_column(const real *J, int n, int i, real column[6]) {
  for (int row = 0; row < 6; row++) column[row] = J[n * row + i];
}

SHARED void put_column(const real column[6], int n, int i, real *J) {
  for (int row = 0; row < 6; row++) J[n * row + i] = column[row];
}

#endif
