/* random.c - see random.h. */
#include "random.h"

#include <math.h>

uint64_t next_bits(uint64_t *state) {
  uint64_t z = *state += 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

double uniform(uint64_t *state, double least, double most) {
  return least + (most - least) * ((double)(next_bits(state) >> 11) * 0x1p-53);
}

double normal(uint64_t *state) {
  double x, square;
  do {
    x = uniform(state, -1.0, 1.0);
    const double y = uniform(state, -1.0, 1.0);
    square = x * x + y * y;
  } while (square >= 1.0 || square == 0.0);
  return x * sqrt(-2.0 * log(square) / square);
}
