/* random.h - random numbers, the same on every machine. */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

/* Sebastiano Vigna's splitmix64: the state is any number, and each call moves it on. */
uint64_t next_bits(uint64_t *state);

/* Uniform in [least, most). */
double uniform(uint64_t *state, double least, double most);

/* Normal with mean 0 and standard deviation 1 (Box & Muller by Marsaglia's polar form; its last bit is that of the
 * host's log). */
double normal(uint64_t *state);

#endif
