#include "linear.h"
#include "rotation.h"
#include <chasles/chain.h>

void FN(chs_chain_torques)(int n, const real *J, const real F[6], real *torques) {
  const real f[6] = {F[0], F[1], F[2], F[3], F[4], F[5]};
  for (int j = 0; j < n; j++) {
    real sum = 0;
    for (int row = 0; row < 6; row++) sum += J[n * row + j] * f[row];
    torques[j] = sum;
  }
}

void FN(chs_chain_twist)(int n, const real *J, const real *rates, real V[6]) {
  real v[6] = {0, 0, 0, 0, 0, 0};
  for (int row = 0; row < 6; row++)
    for (int j = 0; j < n; j++) v[row] += J[n * row + j] * rates[j];
  copy(v, 6, V);
}

/* The spectrum of J, or why there is none. */
static int decompose(int n, const real *J, real length, real *scratch, spectrum *s) {
  if (n < 1) return CHS_ERR_ARGUMENT;
  int status = first_error(finiteness(J, 6 * n), finiteness(&length, 1));
  if (status == CHS_OK && length <= 0) status = CHS_ERR_ARGUMENT;
  if (status == CHS_OK && !FN(chs_p_spectrum_of)(n, J, length, scratch, s)) status = CHS_ERR_OVERFLOW;
  return status;
}

int FN(chs_chain_singular_values)(int n, const real *J, real length, real *scratch, real sigma[6]) {
  spectrum s;
  int status = decompose(n, J, length, scratch, &s);
  if (status != CHS_OK) return status;
  real values[6] = {0, 0, 0, 0, 0, 0};
  for (int i = 0; i < s.k; i++) values[i] = s.size * SQRT(s.squares[i]);
  if (!is_finite(values[0])) return CHS_ERR_OVERFLOW;
  copy(values, 6, sigma);
  return CHS_OK;
}

int FN(chs_chain_rank)(int n, const real *J, real length, real *scratch, int *rank) {
  spectrum s;
  int status = decompose(n, J, length, scratch, &s);
  if (status == CHS_OK) *rank = FN(chs_p_rank_of)(&s);
  return status;
}

/* The product of the singular values, out of the format's range on the way only where it ends there: the smallest are
 * taken while it is above 1, the largest while it is below. */
static real product_of(const spectrum *s) {
  real product = 1;
  for (int first = 0, last = s->k; first < last;) product *= s->size * SQRT(s->squares[product < 1 ? first++ : --last]);
  return product;
}

int FN(chs_chain_manipulability)(int n, const real *J, real length, real *scratch, real *manipulability) {
  spectrum s;
  int status = decompose(n, J, length, scratch, &s);
  if (status != CHS_OK) return status;
  real product = product_of(&s);
  if (!is_finite(product)) return CHS_ERR_OVERFLOW;
  *manipulability = product;
  return CHS_OK;
}

int FN(chs_chain_condition)(int n, const real *J, real length, real *scratch, real *condition) {
  spectrum s;
  int status = decompose(n, J, length, scratch, &s);
  if (status != CHS_OK) return status;
  if (FN(chs_p_rank_of)(&s) < s.k) return CHS_ERR_SINGULAR;
  *condition = SQRT(s.squares[0]) / SQRT(s.squares[s.k - 1]);
  return CHS_OK;
}

int FN(chs_chain_determinant)(const real J[36], real *determinant) {
  static const real nothing[6] = {0, 0, 0, 0, 0, 0};
  real A[42], x[6], det;
  augment(J, nothing, 1, A);
  FN(chs_p_eliminate)(A, x, &det);
  if (!is_finite(det) || (det == 0 && !all_finite(J, 36))) return why_not_finite(J, 36);
  *determinant = det;
  return CHS_OK;
}

/* The largest entry of three rows in size: first of each column, which wait for none of the others. */
static inline real largest_of_rows(const real J[18]) {
  real most[6];
  UNROLL for (int j = 0; j < 6; j++) {
    const real column[3] = {J[j], J[6 + j], J[12 + j]};
    most[j] = largest(column, 3);
  }
  return largest(most, 6);
}

/* The factor that makes the last three rows as large as the first three. */
static real balance(const real J[36]) {
  real factor = largest_of_rows(J) / largest_of_rows(J + 18);
  return factor > 0 && is_finite(factor) ? factor : K(1.0);
}

int FN(chs_chain_rates_inverse)(const real J[36], const real V[6], real *rates) {
  real A[42], x[6] = {0, 0, 0, 0, 0, 0}, det;
  augment(J, V, balance(J), A);
  int regular = FN(chs_p_eliminate)(A, x, &det) > K(64.0) * EPS;
  if (!regular || !is_finite(det) || !all_finite(x, 6)) {
    int status = first_error(finiteness(J, 36), finiteness(V, 6));
    if (status == CHS_OK && !regular) status = CHS_ERR_SINGULAR;
    if (status == CHS_OK && !all_finite(x, 6)) status = CHS_ERR_OVERFLOW;
    if (status != CHS_OK) return status;
  }
  copy(x, 6, rates);
  return CHS_OK;
}

/* Solves from the `count` largest singular values, by way of scratch memory behind X. */
static int solve(const spectrum *s, real *X, int count, const real V[6], real length, real lambda, real *rates) {
  real *x = X + 6 * s->m, scaled[6];
  for (int i = 0; i < 6; i++) scaled[i] = i < 3 ? V[i] : V[i] / length;
  FN(chs_p_damped_solution)(s, X, count, scaled, lambda, x);
  if (!all_finite(x, s->n)) return CHS_ERR_OVERFLOW;
  copy(x, s->n, rates);
  return CHS_OK;
}

int FN(chs_chain_rates_pseudoinverse)(int n, const real *J, const real V[6], real length, real *scratch, real *rates) {
  spectrum s;
  int status = first_error(decompose(n, J, length, scratch, &s), finiteness(V, 6));
  if (status != CHS_OK) return status;
  int rank = FN(chs_p_rank_of)(&s);
  status = solve(&s, scratch, rank, V, length, 0, rates);
  return status == CHS_OK && rank < s.k ? CHS_NEAR_SINGULAR : status;
}

int FN(chs_chain_rates_damped)(int n, const real *J, const real V[6], real length, real damping, real near,
                               real *scratch, real *rates) {
  spectrum s;
  const real others[8] = {V[0], V[1], V[2], V[3], V[4], V[5], damping, near};
  int status = first_error(decompose(n, J, length, scratch, &s), finiteness(others, 8));
  if (status == CHS_OK && (damping <= 0 || near < 0)) status = CHS_ERR_ARGUMENT;
  if (status != CHS_OK) return status;
  real least = s.size * SQRT(s.squares[s.k - 1]) / near; /* NaN or infinite where `near` is 0 */
  int follows = near > 0, damped = !follows || least < 1;
  real lambda = !damped ? K(0.0) : follows ? damping * SQRT((K(1.0) - least) * (K(1.0) + least)) : damping;
  status = solve(&s, scratch, s.k, V, length, lambda, rates);
  return status == CHS_OK && follows && damped ? CHS_NEAR_SINGULAR : status;
}
