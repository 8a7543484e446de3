/* What is summed of many points; shared by the loop over the points and by what is made of the sums. */
#ifndef CHASLES_MOTION_SUMS_H
#define CHASLES_MOTION_SUMS_H

#include "real.h"

#define sample_mean(...) FN(chs_p_sample_mean)(__VA_ARGS__)
#define gather(...) FN(chs_p_gather)(__VA_ARGS__)

/* Of points about - their distances x and y from the points that the sums are about, times the weight: the weight
 * itself, x, y, the nine products of components, a row for each of y, and both squares. */
enum { WEIGHT, FIRST, PRODUCTS = FIRST + 6, SQUARES = PRODUCTS + 9, SUMS = SQUARES + 2 };

/* Points one after the other and their weights, or NULL where all are 1. */
typedef struct run {
  size_t count;
  const real *initial, *final, *weights;
} run;

/* The mean of some points of a run, more and more apart, initial and final, and their weight. False where it has none. */
int FN(chs_p_sample_mean)(const run *r, real mean[7]);

/* The sums over a run, lengths times scale. Returns how many weights are above 0, but 0 where one is below. */
size_t FN(chs_p_gather)(const run *r, const real about[6], real scale, real sum[SUMS]);

#endif
