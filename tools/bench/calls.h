/* calls.h - every function of tools/chasles/functions.def, called for many cases in a row. */
#ifndef CALLS_H
#define CALLS_H

#ifdef __cplusplus
extern "C" {
#endif

struct calls {
  const char *name;
  int inputs;
  int outputs;
  int (*loop)(const double *in, double *out, long cases); /* answers the last status */
  int (*loopf)(const float *in, float *out, long cases);
};

extern const struct calls calls[];
extern const int calls_count;

/* Some of them, inlined; see inlined.c. */
extern const struct calls inlined[];
extern const int inlined_count;

#ifdef __cplusplus
}
#endif

#endif
