#include "linear.h"

/* Elimination with row interchanges, under way. */
typedef struct elimination {
  real *rows[6], inverses[6], least, det;
  int exchanged;
} elimination;

/* One column of it; false where all that is left of the column is 0. What is left below the diagonal is never read. */
static INLINE int eliminate_column(elimination *e, int j, real size) {
  real **rows = e->rows, most = ABS(rows[j][j]);
  int best = j;
  UNROLL for (int i = j + 1; i < 6; i++) {
    real other = ABS(rows[i][j]);
    best = other > most ? i : best;
    most = other > most ? other : most;
  }
  real *top = rows[best], pivot = top[j], share = most / size;
  rows[best] = rows[j];
  rows[j] = top;
  e->exchanged ^= best != j;
  e->det *= pivot;
  e->least = share < e->least ? share : e->least;
  if (pivot == 0) return 0;
  real inverse = e->inverses[j] = K(1.0) / pivot;
  UNROLL for (int i = j + 1; i < 6; i++) {
    real *row = rows[i], factor = row[j] * inverse;
    UNROLL for (int k = j + 1; k < 7; k++) row[k] -= factor * top[k];
  }
  return 1;
}

real FN(chs_p_eliminate)(real A[42], real x[6], real *determinant) {
  elimination e = {{A, A + 7, A + 14, A + 21, A + 28, A + 35}, {0}, 1, 1, 0};
  real sizes[6];
  int regular = 1;
  for (int j = 0; j < 6; j++) {
    sizes[j] = 0;
    UNROLL for (int i = 0; i < 6; i++) {
      real size = ABS(A[7 * i + j]);
      sizes[j] = size > sizes[j] ? size : sizes[j];
    }
  }
  UNROLL for (int j = 0; j < 6; j++) {
    regular = eliminate_column(&e, j, sizes[j]);
    if (!regular) break;
  }
  *determinant = e.exchanged ? -e.det : e.det;
  if (!regular || !(e.least > 0)) return 0;
  UNROLL for (int i = 5; i >= 0; i--) {
    real rest = e.rows[i][6];
    UNROLL for (int k = i + 1; k < 6; k++) rest -= e.rows[i][k] * x[k];
    x[i] = rest * e.inverses[i];
  }
  return e.least;
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
