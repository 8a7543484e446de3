#include <chasles/so3.h>

#include "cofactors.h"
#include "rotation.h"

void FN(chs_so3_hat)(const real w[3], real W[9]) { hat(w, W); }

/* (a - b) / 2, exactly a where b = -a, without overflow. */
static real half_difference(real a, real b) { return a == -b ? a : K(0.5) * a - K(0.5) * b; }

void FN(chs_so3_vee)(const real W[9], real w[3]) {
  real x = half_difference(W[7], W[5]), y = half_difference(W[2], W[6]), z = half_difference(W[3], W[1]);
  w[0] = x;
  w[1] = y;
  w[2] = z;
}

SELDOM static int exp_beyond_pi(const real w[3], real R[9]) {
  half_angle half;
  int status = FN(chs_p_half_angle_beyond_pi)(w, &half);
  if (status == CHS_OK) rotation_from_half_angle(w, half, R);
  return status;
}

int FN(chs_so3_exp)(const real w[3], real R[9]) {
  split_square square = squared_length(w);
  if (!within_pi(square)) return exp_beyond_pi(w, R);
  rotation_from_half_angle(w, half_angle_within_pi(square), R);
  return CHS_OK;
}

int FN(chs_so3_log)(const real R[9], real w[3]) {
  int status = check_rotation(R);
  return status == CHS_OK ? logarithm(R, w) : status;
}

static int jacobian(const real w[3], real side, real J[9]) {
  half_angle half;
  int status = half_angle_of(w, &half);
  if (status == CHS_OK) jacobian_from(w, half, side, J);
  return status;
}

static int jacobian_inverse(const real w[3], real side, real J[9]) {
  half_angle half;
  int status = half_angle_of(w, &half);
  return status == CHS_OK ? inverse_jacobian_from(w, half, side, J) : status;
}

int FN(chs_so3_left_jacobian)(const real w[3], real J[9]) { return jacobian(w, K(1.0), J); }

int FN(chs_so3_right_jacobian)(const real w[3], real J[9]) { return jacobian(w, K(-1.0), J); }

int FN(chs_so3_left_jacobian_inverse)(const real w[3], real J[9]) { return jacobian_inverse(w, K(1.0), J); }

int FN(chs_so3_right_jacobian_inverse)(const real w[3], real J[9]) { return jacobian_inverse(w, K(-1.0), J); }

int FN(chs_so3_angle)(const real A[9], const real B[9], real *angle) {
  int status = first_error(check_rotation(A), check_rotation(B));
  if (status != CHS_OK) return status;
  /* Twice the sine's axis is sum a_k x b_k = sum a_k x (b_k - a_k), k the columns: differences keep small angles exact.
   * Its first component is row 2 of A times row 3 of B - A less row 3 times row 2, and so on. */
  real d[9], s[3];
  subtract(B, A, d);
  subtract(B + 3, A + 3, d + 3);
  subtract(B + 6, A + 6, d + 6);
  s[0] = dot(A + 3, d + 6) - dot(A + 6, d + 3);
  s[1] = dot(A + 6, d) - dot(A, d + 6);
  s[2] = dot(A, d + 3) - dot(A + 3, d);
  real trace = (dot(A, B) + dot(A + 3, B + 3)) + dot(A + 6, B + 6);
  *angle = FN(chs_p_angle_of_vector)(s, trace - K(1.0));
  return CHS_OK;
}

/* Newton's iteration for the polar factor, X <- X/|X| + cof(X)/|cof(X)|: X and its cofactor matrix have the same
 * singular vectors, and cof(X) = det(X) X^-T needs no inverse, so that rank 2 is as good as rank 3. Scaled by Frobenius
 * norms as in Higham 1986; 9 steps suffice for any condition number, and the bound below is never met by a matrix that
 * has a nearest rotation. */
int FN(chs_so3_nearest)(const real M[9], real R[9], real *distance) {
  int status = finiteness(M, 9);
  if (status != CHS_OK) return status;
  const real root = K(0.86602540378443864676); /* sqrt(3)/2: a rotation has Frobenius norm sqrt(3) */
  real most = largest(M, 9), X[9], C[9], change = 1;
  if (most == 0) return CHS_ERR_SINGULAR;
  real scale = safe_to_square(most);
  for (int i = 0; i < 9; i++) X[i] = scale * M[i];
  for (int step = 0; change > K(0.25) * SQRT(EPS); step++) {
    real size = norm(X, 9), cofactor_size = cofactors(X, size, C);
    if (dot(X, C) < K(-16.0) * EPS * size * size * size) return CHS_ERR_REFLECTION;
    if (cofactor_size <= K(8.0) * EPS * size * size || step == 16) return CHS_ERR_SINGULAR;
    real x_scale = root / size, c_scale = root / cofactor_size;
    change = 0;
    for (int i = 0; i < 9; i++) {
      real x = x_scale * X[i], c = c_scale * C[i], difference = ABS(x - c);
      change = difference > change ? difference : change;
      X[i] = x + c;
    }
  }
  real difference[9];
  for (int i = 0; i < 9; i++) difference[i] = M[i] - X[i];
  real d = norm(difference, 9);
  if (!is_finite(d)) return CHS_ERR_OVERFLOW;
  if (distance) *distance = d;
  copy(X, 9, R);
  return CHS_OK;
}

int FN(chs_so3_deviation)(const real R[9], real *deviation) {
  real d = FN(chs_p_deviation)(R);
  if (!is_finite(d)) return why_not_finite(R, 9);
  *deviation = d;
  return CHS_OK;
}

int FN(chs_so3_check)(const real R[9], real tolerance) { return FN(chs_p_rotation_status)(R, tolerance); }
