/* Seeded random numbers. Every test starts from the same seed, so that it gives the same numbers when run alone. */
#ifndef CHASLES_TESTS_RANDOM_H
#define CHASLES_TESTS_RANDOM_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "precision.h"

static uint64_t random_state;

/* The environment variable CHASLES_TEST_SEED, or 1830: the year of Chasles's theorem. */
static inline uint64_t random_seed(void) {
  const char *text = getenv("CHASLES_TEST_SEED");
  return text ? (uint64_t)strtoull(text, NULL, 0) : 1830;
}

static inline void restart_random(void) { random_state = random_seed(); }

static inline void print_seed(void) { printf("CHASLES_TEST_SEED=%llu\n", (unsigned long long)random_seed()); }

/* splitmix64 (Steele, Lea & Flood 2014). */
static inline uint64_t random_word(void) {
  uint64_t z = random_state += UINT64_C(0x9E3779B97F4A7C15);
  z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
  return z ^ (z >> 31);
}

static inline double uniform(double from, double to) {
  return from + (to - from) * ((double)(random_word() >> 11) * 0x1p-53);
}

/* A magnitude whose logarithm is uniform. */
static inline double log_uniform(double from, double to) { return exp(uniform(log(from), log(to))); }

/* An integer of the closed range. */
static inline int integer(int from, int to) { return from + (int)((random_word() >> 33) % (uint64_t)(to - from + 1)); }

static inline void random_integers(int from, int to, int n, real *x) {
  for (int i = 0; i < n; i++) x[i] = (real)integer(from, to);
}

/* A vector of the given length, to within rounding, in a random direction. */
static inline void random_vector(double length, real v[3]) {
  double x[3], square;
  do {
    for (int i = 0; i < 3; i++) x[i] = uniform(-1, 1);
    square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  } while (square > 1 || square < 0.01);
  for (int i = 0; i < 3; i++) v[i] = rounded(length / sqrt(square) * x[i]);
}

static inline void random_rotation(real R[9]) {
  real w[3];
  random_vector(uniform(0, PI), w);
  FN(chs_so3_exp)(w, R);
}

static inline void random_pose(double length, real T[16]) {
  real R[9], p[3];
  random_rotation(R);
  random_vector(length, p);
  FN(chs_se3_from_parts)(R, p, T);
}

/* Bands of angles, short of pi. */
typedef struct band {
  const char *name;
  double from, to;
} band;

static const band angle_bands[] = {
    {"tiny", PICK(1e-300, 1e-37), PICK(1e-150, 1e-19)},
    {"small", PICK(1e-150, 1e-19), 1e-6},
    {"moderate", 1e-6, 0.1},
    {"ordinary", 0.1, 3.0},
};

/* pi less what is given is still resolved well by the format. */
static const band gaps_below_pi = {"near pi", PICK(1e-15, 2e-6), 0.14};

/* In turn an angle of each band, the last being the one near pi. */
static inline double random_angle(int turn) {
  int k = turn % (LENGTH(angle_bands) + 1);
  if (k == LENGTH(angle_bands)) return PI - log_uniform(gaps_below_pi.from, gaps_below_pi.to);
  return log_uniform(angle_bands[k].from, angle_bands[k].to);
}

#endif
