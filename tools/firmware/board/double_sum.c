/* double_sum.c - a - b in double as IEEE 754 has it, where libgcc has not.
 *
 * libgcc's sums in double for Arm cores with Thumb-2 and no double-precision unit (Cortex-M3, M4, M33; seen in gcc 12)
 * round wrongly in one case: the exponents differ by 33, and the smaller number, taken off, leads below the power of 2
 * that the larger one is just at, as in 1 - 1.2 * 2^-33. Of the digits behind the last one only a single bit is kept
 * then, although the result, one binade lower, needs two. Cores with Thumb alone (Cortex-M0+) have other code, which is
 * right.
 *
 * Link this file with -Wl,--wrap=__aeabi_dadd -Wl,--wrap=__aeabi_dsub and the bits are those of every other machine.
 */
#include <stdint.h>

/* Numbers travel as pairs of registers, so that bits are all that is seen of them, whatever the floating-point ABI. */
uint64_t __real___aeabi_dadd(uint64_t a, uint64_t b);
uint64_t __wrap___aeabi_dadd(uint64_t a, uint64_t b);
uint64_t __wrap___aeabi_dsub(uint64_t a, uint64_t b);

enum { GAP = 33, EXPONENTS = 0x7ff };
static const uint64_t sign = (uint64_t)1 << 63;
static const uint32_t half = 0x80000000u;

/* Of the upper half of a number: its exponent, and its significand with the leading bit. Subnormal numbers have the
 * exponent of the least normal ones, and no leading bit. */
static int exponent(uint32_t high) {
  const int field = (int)(high >> 20) & EXPONENTS;
  return field > 0 ? field : 1;
}

static uint32_t leading_bits(uint32_t high) {
  return (high & 0xfffffu) | (((high >> 20) & EXPONENTS) ? 0x100000u : 0u);
}

/* In units of the last place below 2^e, halves of those above, the larger number is 2^53 + 2 F and the smaller one S
 * and a fraction: its significand over 2^32. */
static int spoilt(uint64_t larger, uint64_t smaller) {
  const uint32_t high = (uint32_t)(larger >> 32);
  const uint32_t F = (uint32_t)larger;
  const uint32_t S = leading_bits((uint32_t)(smaller >> 32));
  const int gap = exponent(high) - exponent((uint32_t)(smaller >> 32));
  return gap == GAP && exponent(high) < EXPONENTS && (high & 0xfffffu) == 0 && F <= S / 2;
}

/* 2^53 + 2 F - S, ties to even: the numbers below 2^e are consecutive as bits, too. */
static uint64_t difference(uint64_t larger, uint64_t smaller) {
  const uint32_t F = (uint32_t)larger;
  const uint32_t fraction = (uint32_t)smaller;
  uint32_t S = leading_bits((uint32_t)(smaller >> 32));
  if (fraction > half || (fraction == half && (S & 1u))) ++S;
  return larger + F - S;
}

__attribute__((noinline)) static uint64_t sum(uint64_t a, uint64_t b) {
  if ((a ^ b) & sign) {
    if (spoilt(a, b)) return difference(a, b);
    if (spoilt(b, a)) return difference(b, a);
  }
  return __real___aeabi_dadd(a, b);
}

/* Exponents that differ by anything but 33, or 34 for the sake of subnormal numbers, cost a few instructions only. */
uint64_t __wrap___aeabi_dadd(uint64_t a, uint64_t b) {
  const int gap = (int)((uint32_t)(a >> 32) << 1 >> 21) - (int)((uint32_t)(b >> 32) << 1 >> 21);
  const unsigned size = (unsigned)(gap < 0 ? -gap : gap);
  return size - GAP <= 1u ? sum(a, b) : __real___aeabi_dadd(a, b);
}

uint64_t __wrap___aeabi_dsub(uint64_t a, uint64_t b) { return __wrap___aeabi_dadd(a, b ^ sign); }
