#include "linear.h"

static inline void take_away(real factor, const real *x, real *y) {
  y[0] -= factor * x[0];
  y[1] -= factor * x[1];
  y[2] -= factor * x[2];
  y[3] -= factor * x[3];
  y[4] -= factor * x[4];
  y[5] -= factor * x[5];
  y[6] -= factor * x[6];
}

/* Selections in place of branches here and below: which row it is cannot be foreseen. */
static inline int pivot_row(real *const rows[6], int column) {
  int best = column;
  real most = ABS(rows[column][column]);
  for (int i = column + 1; i < 6; i++) {
    real size = ABS(rows[i][column]);
    int larger = size > most;
    best = larger ? i : best;
    most = larger ? size : most;
  }
  return best;
}

static real largest_of_column(const real *A, int j) {
  const real column[6] = {A[j], A[7 + j], A[14 + j], A[21 + j], A[28 + j], A[35 + j]};
  return largest(column, 6);
}

real FN(chs_p_eliminate)(real A[42], real x[6], real *determinant) {
  real least = 1, det = 1, sizes[6], inverses[6];
  int exchanged = 0;
  real *rows[6] = {A, A + 7, A + 14, A + 21, A + 28, A + 35};
  for (int j = 0; j < 6; j++) sizes[j] = largest_of_column(A, j);
  for (int j = 0; j < 6; j++) {
    int best = pivot_row(rows, j);
    real *top = rows[best];
    rows[best] = rows[j];
    rows[j] = top;
    real pivot = top[j], share = ABS(pivot) / sizes[j];
    det *= pivot;
    exchanged ^= best != j;
    least = share < least ? share : least; /* NaN where the column is 0 */
    if (pivot == 0) {
      least = 0;
      break;
    }
    inverses[j] = K(1.0) / pivot;
    /* What is left below the diagonal is never read. */
    for (int i = j + 1; i < 6; i++) take_away(rows[i][j] * inverses[j], top, rows[i]);
  }
  *determinant = exchanged ? -det : det;
  for (int i = 5; i >= 0 && least > 0; i--) {
    real rest = rows[i][6];
    for (int k = i + 1; k < 6; k++) rest -= rows[i][k] * x[k];
    x[i] = rest * inverses[i];
  }
  return least;
}

static real dot_n(const real *a, const real *b, int n) {
  real sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

static void rotate_pair(real *x, real *y, int n, real s, real c) {
  for (int i = 0; i < n; i++) {
    real a = x[i], b = y[i];
    x[i] = c * a - s * b;
    y[i] = s * a + c * b;
  }
}

/* One rotation of Jacobi's that brings x and y to a right angle, done to g and h as well. False where they are at one
 * to within rounding, or one of them is no more than rounding. */
static int straighten(real *x, real *y, int m, real *g, real *h, int k) {
  real a = dot_n(x, x, m), b = dot_n(y, y, m), ab = dot_n(x, y, m), noise = EPS * EPS;
  if (a <= noise || b <= noise || ab * ab <= (K(4.0) * noise) * (a * b)) return 0;
  real zeta = (b - a) / (K(2.0) * ab), root = SQRT(K(1.0) + zeta * zeta);
  real t = zeta > 0 ? K(1.0) / (zeta + root) : K(-1.0) / (root - zeta);
  real c = K(1.0) / SQRT(K(1.0) + t * t), s = c * t;
  rotate_pair(x, y, m, s, c);
  rotate_pair(g, h, k, s, c);
  return 1;
}

static void sort(spectrum *s) {
  for (int i = 0; i < s->k; i++) {
    int j = i;
    real square = s->squares[i];
    for (; j > 0 && s->squares[j - 1] < square; j--) {
      s->squares[j] = s->squares[j - 1];
      s->order[j] = s->order[j - 1];
    }
    s->squares[j] = square;
    s->order[j] = i;
  }
}

int FN(chs_p_spectrum_of)(int n, const real *J, real length, real *X, spectrum *s) {
  s->n = n;
  s->k = n <= 6 ? n : 6;
  s->m = n <= 6 ? 6 : n;
  for (int row = 0; row < 6; row++)
    for (int j = 0; j < n; j++) {
      real entry = row < 3 ? J[n * row + j] : J[n * row + j] / length;
      X[n <= 6 ? 6 * j + row : n * row + j] = entry;
    }
  s->size = largest(X, 6 * n);
  if (!is_finite(s->size)) return 0;
  for (int i = 0; i < 6 * n; i++) X[i] = s->size > 0 ? X[i] / s->size : K(0.0);
  for (int i = 0; i < s->k * s->k; i++) s->G[i] = i % (s->k + 1) == 0;

  /* Each sweep about squares what is left; six vectors need some six of them, and none needs the bound. */
  int turned = 1;
  for (int sweep = 0; turned && sweep < 32; sweep++) {
    turned = 0;
    for (int i = 0; i < s->k; i++)
      for (int j = i + 1; j < s->k; j++)
        turned |= straighten(X + s->m * i, X + s->m * j, s->m, s->G + s->k * i, s->G + s->k * j, s->k);
  }
  for (int i = 0; i < s->k; i++) s->squares[i] = dot_n(X + s->m * i, X + s->m * i, s->m);
  sort(s);
  return 1;
}

int FN(chs_p_rank_of)(const spectrum *s) {
  real noise = K(8.0) * (real)s->m * EPS;
  int rank = 0;
  while (rank < s->k && s->squares[rank] > noise * noise * s->squares[0]) rank++;
  return rank;
}

void FN(chs_p_damped_solution)(const spectrum *s, const real *X, int count, const real V[6], real lambda, real *x) {
  real damping = lambda / s->size, coefficients[6];
  int k = s->k, m = s->m, wide = s->n > 6;
  if (s->size == 0) count = 0;
  for (int i = 0; i < count; i++) {
    const real *vector = wide ? s->G + k * s->order[i] : X + m * s->order[i];
    coefficients[i] = dot_n(vector, V, 6) / (s->squares[i] + damping * damping) / s->size;
  }
  for (int j = 0; j < s->n; j++) {
    real sum = 0;
    for (int i = 0; i < count; i++)
      sum += coefficients[i] * (wide ? X[m * s->order[i] + j] : s->G[k * s->order[i] + j]);
    x[j] = sum;
  }
}
