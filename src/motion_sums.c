/* No differences of products here, so that gcc may vectorise. */
#define SUMS_ALONE
#include "motion_sums.h"
#include "vec3.h"

/* Sums of so many points are summed in their turn: rounding errors of one sign, as of points that are the same or lie in a
 * grid, grow with the number of terms. */
enum { SAMPLE = 16, RUN = 16 };

/* Two lanes: x and y of a point, or a component before and after. The order of the sums is that of the lanes with
 * vectors and without. */
static INLINE size_t sum_up(const run *r, const real about[6], int weighted, real scale, real sum[SUMS]) {
  const real axy[2] = {about[0], about[1]}, bxy[2] = {about[3], about[4]}, abz[2] = {about[2], about[5]};
  real least = 0, *at = sum + FIRST, *H = sum + PRODUCTS;
  size_t points = 0, i = 0;
  for (int k = 0; k < SUMS; k++) sum[k] = 0;
  while (i < r->count) {
    real p[2] = {0}, q[2] = {0}, pqz[2] = {0}, xx[2] = {0}, yx[2] = {0}, zx[2] = {0}, yz[2] = {0}, squares[2] = {0};
    real zz = 0, w = 0;
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
        w += v;
        points += v > 0;
        least = v < least ? v : least;
      }
      real vx[2], vy[2], vz[2];
      OVER_PAIR for (int l = 0; l < 2; l++) vx[l] = weighted ? v * x[l] : x[l];
      OVER_PAIR for (int l = 0; l < 2; l++) vy[l] = weighted ? v * y[l] : y[l];
      OVER_PAIR for (int l = 0; l < 2; l++) vz[l] = weighted ? v * z[l] : z[l];
      OVER_PAIR for (int l = 0; l < 2; l++) p[l] += vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) q[l] += vy[l];
      OVER_PAIR for (int l = 0; l < 2; l++) pqz[l] += vz[l];
      real y0 = y[0], y1 = y[1], z1 = z[1], vz0 = vz[0];
      OVER_PAIR for (int l = 0; l < 2; l++) xx[l] += y0 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) yx[l] += y1 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) zx[l] += z1 * vx[l];
      OVER_PAIR for (int l = 0; l < 2; l++) yz[l] += y[l] * vz0;
      zz += z1 * vz0;
      const real first[2] = {x[0], y0}, second[2] = {x[1], y1}, vfirst[2] = {vx[0], vy[0]}, vsecond[2] = {vx[1], vy[1]};
      OVER_PAIR for (int l = 0; l < 2; l++) squares[l] +=
          (first[l] * vfirst[l] + second[l] * vsecond[l]) + z[l] * vz[l];
    }
    sum[WEIGHT] += w;
    at[0] += p[0], at[1] += p[1], at[2] += pqz[0], at[3] += q[0], at[4] += q[1], at[5] += pqz[1];
    H[0] += xx[0], H[1] += xx[1], H[2] += yz[0], H[3] += yx[0], H[4] += yx[1], H[5] += yz[1];
    H[6] += zx[0], H[7] += zx[1], H[8] += zz;
    sum[SQUARES] += squares[0];
    sum[SQUARES + 1] += squares[1];
  }
  if (!weighted) sum[WEIGHT] = (real)r->count;
  return least < 0 ? 0 : r->weights ? points : r->count;
}

size_t FN(chs_p_gather)(const run *r, const real about[6], real scale, real sum[SUMS]) {
  return r->weights || scale != 1 ? sum_up(r, about, 1, scale, sum) : sum_up(r, about, 0, 1, sum);
}

int FN(chs_p_sample_mean)(const run *r, real mean[7]) {
  const real *a = r->initial, *b = r->final, ab[2] = {a[2], b[2]};
  size_t n = r->count < SAMPLE ? r->count : SAMPLE, rest = r->count - n;
  real p[2] = {0}, q[2] = {0}, pqz[2] = {0}, weight = 0;
  for (size_t k = 0; k < n; k++) {
    size_t sum = k * (k + 1) / 2, i = k + sum * (rest / 128) + sum * (rest % 128) / 128;
    const real *before = a + 3 * i, *after = b + 3 * i, z[2] = {before[2], after[2]};
    real v = r->weights ? r->weights[i] : K(1.0);
    if (!(v >= 0)) return 0;
    weight += v;
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
