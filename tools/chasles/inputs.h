/* inputs.h - random inputs for any function of the registry, the same on every machine.
 *
 * They are made from the bits of a generator of our own, from sums, products and quotients that IEEE 754 rounds in one
 * way only, and by the library itself, never by libm.
 */
#ifndef INPUTS_H
#define INPUTS_H

#include <stdint.h>

#include "evaluate.h"

struct source {
  uint64_t state;
  enum precision precision;
};

/* A source for that function: other functions, and the other precision, get other inputs. */
struct source source_for(const struct function *function, enum precision precision, uint64_t seed);

/* Whether the kinds in the function's entry are known and make as many inputs as it takes. */
bool kinds_are_right(const struct function *function);

void make_inputs(struct source *source, const struct function *function, double *in);

#endif
