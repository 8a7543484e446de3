/* evaluate.h - one call of a registered function, in either precision, with what it did to its outputs.
 *
 * Numbers travel as double: a float is exact in it. The registry converts nothing; the conversion happens here.
 */
#ifndef EVALUATE_H
#define EVALUATE_H

#include <stdbool.h>
#include <stdint.h>

#include "functions.h"

enum precision { DOUBLE_PRECISION, FLOAT_PRECISION };
enum { PRECISIONS = 2 };

const char *precision_name(enum precision precision);    /* "double", "float" */
int precision_digits(enum precision precision);          /* hexadecimal, of a bit pattern: 16, 8 */
double precision_eps(enum precision precision);          /* 2^-52, 2^-23 */
bool fits_precision(double x, enum precision precision); /* NaN and infinities fit */

/* A number's bit pattern in the precision, 64 or 32 bits of it, and back. */
uint64_t precision_bits(double x, enum precision precision);
double precision_number(uint64_t bits, enum precision precision);

struct answer {
  int status;
  double out[MAX_OUTPUTS];
  bool untouched;  /* not one byte of the outputs was written */
  bool wrote_past; /* something was written behind the last output */
};

void evaluate(const struct function *function, enum precision precision, const double *in, struct answer *answer);

#endif
