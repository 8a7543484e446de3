/* vectors.h - files of reference vectors, read one case at a time.
 *
 *   chasles-vectors 1
 *   function so3_exp
 *   precision double
 *   inputs 3
 *   outputs 9
 *   group diagonal max 0 4 8
 *   group off_diagonal max 1 2 3 5 6 7
 *   case tiny_0001 tiny 0
 *   in 0x1.8p-700 0x0p+0 -0x1p-701
 *   out 0x1p+0 0 0x1.8p-700 -0x1p-760 ...
 *   scale 0x1p+0 0x1.8p-700
 *
 * Lines that start with # and blank lines are skipped. Numbers are C99 hexadecimal floats, 0, -0, nan, inf or -inf. A
 * case has a name, a band and the status expected, or several parted by |. `out` holds a pair for each output: the
 * exact result rounded to the format, and a short number for the rest. `scale` holds what each group's error is
 * divided by. A case all of whose statuses are negative has neither, nor has a function without outputs.
 */
#ifndef VECTORS_H
#define VECTORS_H

#include <stdbool.h>

#include "evaluate.h"
#include "text.h"

enum { MAX_NAME = 63, MAX_STATUSES = 4 };

/* Outputs whose error is measured together. */
struct group {
  const struct promise *promise;
  bool norm; /* the Euclidean norm of the differences, not the largest */
  int count;
  int index[MAX_OUTPUTS];
};

struct vectors {
  struct text text;
  const struct function *function;
  enum precision precision;
  int group_count;
  struct group groups[MAX_PROMISES];
};

struct vector_case {
  long line;
  char name[MAX_NAME + 1];
  char band[MAX_NAME + 1];
  int status_count;
  int statuses[MAX_STATUSES];
  bool has_values; /* out and scale are there */
  double in[MAX_INPUTS];
  double high[MAX_OUTPUTS];
  double low[MAX_OUTPUTS];
  double scale[MAX_PROMISES];
};

/* Opens a file and reads its header. False after a message on standard error; nothing is left to close then. */
bool vectors_open(struct vectors *vectors, const char *name);

/* The next case: TEXT_LINE; TEXT_END behind the last; TEXT_ERROR after a message on standard error. */
enum text_result vectors_next(struct vectors *vectors, struct vector_case *record);

void vectors_close(struct vectors *vectors);

#endif
