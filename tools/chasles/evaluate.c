/* evaluate.c - see evaluate.h. */
#include "evaluate.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Outputs are filled with this byte before a call. As a number of either format it is a NaN, so that an output that a
 * function forgets cannot pass for a result. */
enum { FILL = 0xff, SPARE = 4 };

const char *precision_name(enum precision precision) { return precision == DOUBLE_PRECISION ? "double" : "float"; }

int precision_digits(enum precision precision) { return precision == DOUBLE_PRECISION ? 16 : 8; }

double precision_eps(enum precision precision) {
  return precision == DOUBLE_PRECISION ? DBL_EPSILON : (double)FLT_EPSILON;
}

bool fits_precision(double x, enum precision precision) {
  if (precision == DOUBLE_PRECISION || isnan(x) || isinf(x)) return true;
  return fabs(x) <= (double)FLT_MAX && (double)(float)x == x;
}

uint64_t precision_bits(double x, enum precision precision) {
  uint64_t bits = 0;
  if (precision == DOUBLE_PRECISION) {
    memcpy(&bits, &x, sizeof bits);
    return bits;
  }
  const float single = (float)x;
  uint32_t single_bits = 0;
  memcpy(&single_bits, &single, sizeof single_bits);
  return single_bits;
}

double precision_number(uint64_t bits, enum precision precision) {
  if (precision == DOUBLE_PRECISION) {
    double x = 0.0;
    memcpy(&x, &bits, sizeof x);
    return x;
  }
  const uint32_t single_bits = (uint32_t)bits;
  float single = 0.0F;
  memcpy(&single, &single_bits, sizeof single);
  return (double)single;
}

static bool all_fill(const void *memory, size_t size) {
  const unsigned char *bytes = memory;
  for (size_t i = 0; i < size; ++i) {
    if (bytes[i] != FILL) return false;
  }
  return true;
}

void evaluate(const struct function *function, enum precision precision, const double *in, struct answer *answer) {
  const size_t count = (size_t)function->outputs;
  double out[MAX_OUTPUTS + SPARE];
  float outf[MAX_OUTPUTS + SPARE];
  float inf[MAX_INPUTS];
  memset(out, FILL, sizeof out);
  memset(outf, FILL, sizeof outf);

  if (precision == DOUBLE_PRECISION) {
    answer->status = function->call(in, out);
    answer->untouched = all_fill(out, count * sizeof out[0]);
    answer->wrote_past = !all_fill(out + count, sizeof out - count * sizeof out[0]);
    memcpy(answer->out, out, count * sizeof out[0]);
  } else {
    for (int i = 0; i < function->inputs; ++i) inf[i] = (float)in[i];
    answer->status = function->callf(inf, outf);
    answer->untouched = all_fill(outf, count * sizeof outf[0]);
    answer->wrote_past = !all_fill(outf + count, sizeof outf - count * sizeof outf[0]);
    for (size_t i = 0; i < count; ++i) answer->out[i] = (double)outf[i];
  }
}
