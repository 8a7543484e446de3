/* functions.h - the registry: every function of the library behind one kind of call.
 *
 * Each function takes its inputs as one flat array and gives its outputs as another, in the order of its prototype, in
 * double and in float. functions.c and what it includes are freestanding C: they need the library's headers and nothing
 * else, so that firmware can link them as they are. A new library function costs one entry in functions.def.
 */
#ifndef FUNCTIONS_H
#define FUNCTIONS_H

enum {
  MAX_INPUTS = 80, /* a larger function does not compile: see functions.c */
  MAX_OUTPUTS = 104,
  MAX_PROMISES = 16
};

/* The largest error promised for a group of outputs, in eps of the format, as the public header states it. */
struct promise {
  const char *group;
  double within_pi; /* every band of inputs but these two: */
  double beyond_pi; /* bands beyond_pi and far */
};

struct function {
  const char *name;  /* without chs_ and without the f of float */
  const char *kinds; /* what the inputs are, a letter a block: see inputs.c; only `chasles hash` reads it */
  int inputs;
  int outputs;
  int (*call)(const double *in, double *out); /* both answer the library's status; 0 where the library returns void */
  int (*callf)(const float *in, float *out);
  struct promise promises[MAX_PROMISES + 1]; /* the first whose group is NULL ends the list */
};

extern const struct function functions[];
extern const int function_count;

/* The function of that name, or NULL. */
const struct function *find_function(const char *name);

/* The function that does the same for many elements, or NULL: it answers as this one does. */
const struct function *find_array_form(const struct function *single);

int same_text(const char *a, const char *b);

/* The promise for that group of the function's outputs, or NULL. */
const struct promise *find_promise(const struct function *function, const char *group);

#endif
