/* methods.h - the solvers by name. */
#ifndef METHODS_H
#define METHODS_H

#include <chasles/chasles.h>

struct method {
  const char *name;  /* as --method takes it */
  const char *title; /* as a table shows it */
  int (*solve)(const double *initial, const double *final, double tolerance, chs_screw *screw, double *T);
  int (*solvef)(const float *initial, const float *final, float tolerance, chs_screwf *screw, float *T);
};

enum { METHODS_FOR_THREE = 5, METHODS = METHODS_FOR_THREE + 1 };

/* Those for three points, in the order of the tables of Fenton & Shi 1990, and last least squares for any number of
 * points, chs_motion_fit, whose solve and solvef are NULL. */
extern const struct method methods[METHODS];

/* The method of that name, or NULL. */
const struct method *find_method(const char *name);

#endif
