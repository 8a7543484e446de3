/* Sums and products with their rounding errors (Dekker, Veltkamp, Knuth), without a fused multiply-add. */
#ifndef CHASLES_EXACT_H
#define CHASLES_EXACT_H

#include "real.h"

#define two_sum(...) FN(chs_p_two_sum)(__VA_ARGS__)
#define upper(...) FN(chs_p_upper)(__VA_ARGS__)
#define product(...) FN(chs_p_product)(__VA_ARGS__)
#define add(...) FN(chs_p_add)(__VA_ARGS__)
#define difference_of_products(...) FN(chs_p_difference_of_products)(__VA_ARGS__)
#define exact_cross(...) FN(chs_p_exact_cross)(__VA_ARGS__)

/* An unevaluated sum hi + lo, lo much the smaller. */
typedef struct exact_sum {
  real hi, lo;
} exact_sum;

SHARED exact_sum two_sum(real a, real b) {
  real s = a + b, v = s - a;
  exact_sum x = {s, (a - (s - v)) + (b - v)};
  return x;
}

/* The upper half of a number's digits. */
SHARED real upper(real a) {
  real c = SPLITTER * a;
  return c - (c - a);
}

SHARED exact_sum product(real a, real b) {
  real a1 = upper(a), a0 = a - a1, b1 = upper(b), b0 = b - b1, p = a * b;
  exact_sum x = {p, ((a1 * b1 - p) + a1 * b0 + a0 * b1) + a0 * b0};
  return x;
}

/* x += y, the errors gathered in x.lo. */
SHARED void add(exact_sum *x, exact_sum y) {
  exact_sum s = two_sum(x->hi, y.hi);
  x->hi = s.hi;
  x->lo += s.lo + y.lo;
}

SHARED real difference_of_products(real a, real b, real c, real d) {
  exact_sum ab = product(a, b), cd = product(c, d);
  return (ab.hi - cd.hi) + (ab.lo - cd.lo);
}

/* a x b where cancellation would eat the digits: rounded once or twice, whatever the angle between a and b. */
LARGE void exact_cross(const real a[3], const real b[3], real c[3]);

#if LARGE_BODIES

LARGE void exact_cross(const real a[3], const real b[3], real c[3]) {
  c[0] = difference_of_products(a[1], b[2], a[2], b[1]);
  c[1] = difference_of_products(a[2], b[0], a[0], b[2]);
  c[2] = difference_of_products(a[0], b[1], a[1], b[0]);
}

#endif

#endif
