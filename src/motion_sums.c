/* No differences of products here, so that gcc may vectorise. */
#define SUMS_ALONE
#include "motion_sums.h"
#include "vec3.h"

/* Sums of so many points are summed in their turn: rounding errors of one sign, as of points that are the same or lie in a
 * grid, grow with the number of terms. */
enum { SAMPLE = 16, RUN = 16 };

/* What is summed, in two lanes: x and y of a point, or a component before and after. The order of the sums is that of
 * the lanes with vectors and without. */
typedef struct lanes {
  real p[2], q[2], z[2];                   /* x before, y after, and the third component of both */
  real xx[2], yx[2], zx[2], yz[2];         /* components of y by x */
  real zz[2];                              /* that of y by that of x and by itself */
  real squares_x[2], squares_y[2], z_by_z; /* what is left of the squares */
  real weight;
} lanes;

static INLINE void clear_lanes(lanes *l) {
  OVER_PAIR for (int k = 0; k < 2; k++) l->p[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->q[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->z[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->xx[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->yx[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->zx[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->yz[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->zz[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->squares_x[k] = 0;
  OVER_PAIR for (int k = 0; k < 2; k++) l->squares_y[k] = 0;
  l->z_by_z = 0;
  l->weight = 0;
}

static INLINE void add_lanes(lanes *sum, const lanes *l) {
  OVER_PAIR for (int k = 0; k < 2; k++) sum->p[k] += l->p[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->q[k] += l->q[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->z[k] += l->z[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->xx[k] += l->xx[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->yx[k] += l->yx[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->zx[k] += l->zx[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->yz[k] += l->yz[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->zz[k] += l->zz[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->squares_x[k] += l->squares_x[k];
  OVER_PAIR for (int k = 0; k < 2; k++) sum->squares_y[k] += l->squares_y[k];
  sum->z_by_z += l->z_by_z;
  sum->weight += l->weight;
}

/* Where there are vectors apart, or clang's vectoriser would take the lanes apart while they are summed. */
#if VECTORS
#define WRITER APART
#else
#define WRITER INLINE
#endif

static WRITER void write_lanes(const lanes *l, real sum[SUMS]) {
  real *first = sum + FIRST, *H = sum + PRODUCTS;
  sum[WEIGHT] = l->weight;
  first[0] = l->p[0], first[1] = l->p[1], first[2] = l->z[0];
  first[3] = l->q[0], first[4] = l->q[1], first[5] = l->z[1];
  H[0] = l->xx[0], H[1] = l->xx[1], H[2] = l->yz[0];
  H[3] = l->yx[0], H[4] = l->yx[1], H[5] = l->yz[1];
  H[6] = l->zx[0], H[7] = l->zx[1], H[8] = l->zz[0];
  sum[SQUARES] = (l->squares_x[0] + l->squares_x[1]) + l->z_by_z;
  sum[SQUARES + 1] = (l->squares_y[0] + l->squares_y[1]) + l->zz[1];
}

/* Adds all points of a run. */
static INLINE size_t sum_up(const run *r, const real about[6], int weighted, real scale, lanes *all) {
  const real axy[2] = {about[0], about[1]}, bxy[2] = {about[3], about[4]}, abz[2] = {about[2], about[5]};
  real least = 0;
  size_t points = 0, i = 0;
  while (i < r->count) {
    lanes some;
    clear_lanes(&some);
    size_t end = r->count - i < RUN ? r->count : i + RUN;
    for (; i < end; i++) {
      const real *before = r->initial + 3 * i, *after = r->final + 3 * i;
      real x[2], y[2], z[2] = {before[2], after[2]};
      OVER_PAIR for (int l = 0; l < 2; l++) x[l] = before[l] - axy[l];
      OVER_PAIR for (int l = 0; l < 2; l++) y[l] = after[l] - bxy[l];
      OVER_PAIR for (int l = 0; l < 2; l++) z[l] -= abz[l];
      real v = 1;
      if (weighted) {
        OVER_PAIR for (int l = 0; l < 2; l++) x[l] *= scale;
        OVER_PAIR for (int l = 0; l < 2; l++) y[l] *= scale;
        OVER_PAIR for (int l = 0; l < 2; l++) z[l] *= scale;
        v = r->weights ? r->weights[i] : K(1.0);
        some.weight += v;
        points += v > 0;
        least = v < least ? v : least;
      }
      real vx[2], vy[2], vz[2];
      OVER_PAIR for (int l = 0; l < 2; l++) vx[l] = weighted ? v * x[l] : x[l];
      OVER_PAIR for (int l = 0; l < 2; l++) vy[l] = weighted ? v * y[l] : y[l];
      OVER_PAIR for (int l = 0; l < 2; l++) vz[l] = weighted ? v * z[l] : z[l];
      real y0 = y[0], y1 = y[1], z1 = z[1], vz0 = vz[0];
      OVER_PAIR for (int l = 0; l < 2; l++) some.p[l] += vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.q[l] += vy[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.z[l] += vz[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.yz[l] += y[l] * vz0;
      some.z_by_z += z[0] * vz0;
      OVER_PAIR for (int l = 0; l < 2; l++) some.zz[l] += z1 * vz[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.zx[l] += z1 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.xx[l] += y0 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.yx[l] += y1 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.squares_x[l] += x[l] * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) some.squares_y[l] += y[l] * vy[l];
    }
    add_lanes(all, &some);
  }
  if (!weighted) all->weight = (real)r->count;
  return least < 0 ? 0 : r->weights ? points : r->count;
}

/* Where size counts, all as if weighted, which makes the same sums. */
#ifdef __OPTIMIZE_SIZE__
#define ALL_WEIGHTED 1
#else
#define ALL_WEIGHTED 0
#endif

size_t FN(chs_p_gather)(const run *r, const real about[6], real scale, real sum[SUMS]) {
  lanes all;
  size_t points;
  clear_lanes(&all);
  if (ALL_WEIGHTED || r->weights || scale != 1)
    points = sum_up(r, about, 1, scale, &all);
  else
    points = sum_up(r, about, 0, 1, &all);
  write_lanes(&all, sum);
  return points;
}

static INLINE int mean_of_sample(const run *r, int weighted, real mean[7]) {
  const real *a = r->initial, *b = r->final, ab[2] = {a[2], b[2]};
  size_t n = r->count < SAMPLE ? r->count : SAMPLE, rest = r->count - n, whole = rest / 128, part = rest % 128;
  real p[2] = {0}, q[2] = {0}, pqz[2] = {0}, weight = weighted ? K(0.0) : (real)n;
  for (size_t k = 0, sum = 0; k < n; k++, sum += k) {
    size_t i = k + sum * whole + sum * part / 128;
    const real *before = a + 3 * i, *after = b + 3 * i, z[2] = {before[2], after[2]};
    real v = weighted && r->weights ? r->weights[i] : K(1.0);
    if (!(v >= 0)) return 0;
    if (weighted) weight += v;
    OVER_PAIR for (int l = 0; l < 2; l++) p[l] += v * (before[l] - a[l]);
    OVER_PAIR for (int l = 0; l < 2; l++) q[l] += v * (after[l] - b[l]);
    OVER_PAIR for (int l = 0; l < 2; l++) pqz[l] += v * (z[l] - ab[l]);
  }
  real share = K(1.0) / weight;
  mean[0] = a[0] + share * p[0], mean[1] = a[1] + share * p[1], mean[2] = a[2] + share * pqz[0];
  mean[3] = b[0] + share * q[0], mean[4] = b[1] + share * q[1], mean[5] = b[2] + share * pqz[1];
  mean[6] = weight;
  return all_finite(mean, 7);
}

int FN(chs_p_sample_mean)(const run *r, real mean[7]) {
  return VECTORS && !r->weights ? mean_of_sample(r, 0, mean) : mean_of_sample(r, 1, mean);
}
