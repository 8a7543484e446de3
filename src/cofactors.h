/* The cofactor matrix of a 3x3 matrix, with its digits also where the matrix is nearly singular. */
#ifndef CHASLES_COFACTORS_H
#define CHASLES_COFACTORS_H

#include "exact.h"
#include "vec3.h"

#define cofactors(...) FN(chs_p_cofactors)(__VA_ARGS__)

/* C = cof(X), and its norm given that of X. */
SHARED real cofactors(const real X[9], real size, real C[9]) {
  cross(X + 3, X + 6, C);
  cross(X + 6, X, C + 3);
  cross(X, X + 3, C + 6);
  if (norm(C, 9) < K(0.125) * size * size) {
    exact_cross(X + 3, X + 6, C);
    exact_cross(X + 6, X, C + 3);
    exact_cross(X, X + 3, C + 6);
  }
  return norm(C, 9);
}

#endif
