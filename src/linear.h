/* Linear algebra of 6 x n matrices: elimination, and singular values. */
#ifndef CHASLES_LINEAR_H
#define CHASLES_LINEAR_H

#include "real.h"

/* gcc's vectoriser of loops fuses a*b -+ c of neighbouring results just as that of straight-line code does: see real.h.
 * Before the other headers, so that their functions are compiled alike and can be inlined. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-tree-loop-vectorize")
#endif

#include "vec3.h"

#define augment(...) FN(chs_p_augment)(__VA_ARGS__)

/* x = A^-1 b and det A by elimination with row interchanges; (A b) is 6 x 7 and is overwritten. Returns the least pivot
 * relative to the largest entry of its column: 0, and no x, where a column is 0 or a combination of those before it. */
real FN(chs_p_eliminate)(real Ab[42], real x[6], real *determinant);

/* (A b), the last three rows of J and V times a factor. */
SHARED void augment(const real J[36], const real V[6], real factor, real Ab[42]) {
  for (int row = 0; row < 6; row++) {
    real f = row < 3 ? K(1.0) : factor;
    UNROLL for (int j = 0; j < 6; j++) Ab[7 * row + j] = f * J[6 * row + j];
    Ab[7 * row + 6] = f * V[row];
  }
}

/* The singular values of J / size, of which no entry is larger than 1, J being 6 x n with its last three rows divided
 * by some length. X holds k = min(6, n) vectors of length m = max(6, n), at right angles and as long as the singular
 * values: X = G J, or X = G J^T where n <= 6, and G the rotations that made them so: its rows are then the directions
 * in which the joints move together. */
typedef struct spectrum {
  int n, k, m;
  real size;
  real squares[6]; /* of the singular values, in descending order */
  int order[6];    /* which vector has which */
  real G[36];      /* k x k */
} spectrum;

/* X is scratch memory of 6 m numbers. False where J / length is beyond the format. */
int FN(chs_p_spectrum_of)(int n, const real *J, real length, real *X, spectrum *s);

/* How many singular values are more than the rounding errors of a Jacobian. */
int FN(chs_p_rank_of)(const spectrum *s);

/* x = J^T (J J^T + lambda^2 I)^-1 V from the `count` largest singular values, V with v / length for v. */
void FN(chs_p_damped_solution)(const spectrum *s, const real *X, int count, const real V[6], real lambda, real *x);

#endif
