/* functions.c - see functions.h. functions.def is read four times: for the size check, for the calls in each precision
 * and for the table.
 */
#include "functions.h"

#include <chasles/chasles.h>
#include <float.h>
#include <stddef.h>

/* A function with more inputs or outputs than the arrays of its callers hold gives an array of negative size here. */
#define FUNCTION(name, kinds, inputs, outputs, call, ...) \
  typedef char fits_##name[(inputs) <= MAX_INPUTS && (outputs) <= MAX_OUTPUTS ? 1 : -1];
#include "functions.def"
#undef FUNCTION

/* Of an element, for an array form: more than one of its blocks; and the most outputs of one. */
enum { COPIES = 17, MOST_COPIED = 24 };

#define REAL double
#define SCREW chs_screw
#define SUMS chs_motion_sums
#define QUALITY chs_motion_quality
#define CHAIN chs_chain
#define IK chs_ik
#define REAL_EPSILON DBL_EPSILON
#define LIB(name) chs_##name
#define LOCAL(name) name##_double
#include "functions_calls.h"

#define REAL float
#define SCREW chs_screwf
#define SUMS chs_motion_sumsf
#define QUALITY chs_motion_qualityf
#define CHAIN chs_chainf
#define IK chs_ikf
#define REAL_EPSILON FLT_EPSILON
#define LIB(name) chs_##name##f
#define LOCAL(name) name##_float
#include "functions_calls.h"

#define PROMISE(group, macro) \
  { #group, CHS_EPS_##macro, CHS_EPS_##macro }
#define PROMISE_BEYOND(group, macro) \
  { #group, CHS_EPS_##macro, CHS_EPS_##macro##_BEYOND }
#define EXACT(group) \
  { #group, 0.0, 0.0 }
#define WITHIN(group, eps) \
  { #group, eps, eps }
#define NO_OUTPUTS \
  { NULL, 0.0, 0.0 }
#define FUNCTION(name, kinds, inputs, outputs, call, ...) \
  {#name, kinds, inputs, outputs, call_##name##_double, call_##name##_float, {__VA_ARGS__}},
const struct function functions[] = {
#include "functions.def"
};
#undef FUNCTION

const int function_count = (int)(sizeof functions / sizeof functions[0]);

int same_text(const char *a, const char *b) {
  while (*a != '\0' && *a == *b) {
    ++a;
    ++b;
  }
  return *a == *b;
}

const struct function *find_function(const char *name) {
  for (int i = 0; i < function_count; ++i) {
    if (same_text(functions[i].name, name)) return &functions[i];
  }
  return NULL;
}

const struct function *find_array_form(const struct function *single) {
  for (int i = 0; i < function_count; ++i) {
    const char *a = single->name;
    const char *b = functions[i].name;
    while (*a != '\0' && *a == *b) {
      ++a;
      ++b;
    }
    if (*a == '\0' && same_text(b, "_array")) return &functions[i];
  }
  return NULL;
}

const struct promise *find_promise(const struct function *function, const char *group) {
  for (const struct promise *promise = function->promises; promise->group != NULL; ++promise) {
    if (same_text(promise->group, group)) return promise;
  }
  return NULL;
}
