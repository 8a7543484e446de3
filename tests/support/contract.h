/* What all functions of the library promise alike: outputs may overlap inputs, NaN and infinities are refused with the
 * outputs left alone (or let through by plain algebra), matrices that are no rotations are refused, and the last row of
 * a pose is never read.
 *
 * A test file lists its functions once,
 *
 *   #define FUNCTIONS(PLAIN, CHECKED) \
 *     PLAIN(so3_hat, "w", "M", (in[0], out[0])) \
 *     CHECKED(so3_exp, "w", "M", (in[0], out[0]))
 *
 * name, kinds of the inputs, kinds of the outputs, arguments; PLAIN functions return nothing, CHECKED ones a status.
 */
#ifndef CHASLES_TESTS_CONTRACT_H
#define CHASLES_TESTS_CONTRACT_H

#include <stdlib.h>

#include "algebra.h"
#include "assertions.h"
#include "exact.h"
#include "precision.h"
#include "random.h"

typedef struct function {
  const char *name;
  int checked;
  const char *inputs, *outputs;
  int (*call)(const real *const in[], real *const out[]);
} function;

#define DEFINE_PLAIN(name, inputs, outputs, arguments)                \
  static int call_##name(const real *const in[], real *const out[]) { \
    FN(chs_##name) arguments;                                         \
    return CHS_OK;                                                    \
  }
#define DEFINE_CHECKED(name, inputs, outputs, arguments)              \
  static int call_##name(const real *const in[], real *const out[]) { \
    (void)out;                                                        \
    return FN(chs_##name) arguments;                                  \
  }
#define LIST_PLAIN(name, inputs, outputs, arguments) {#name, 0, inputs, outputs, call_##name},
#define LIST_CHECKED(name, inputs, outputs, arguments) {#name, 1, inputs, outputs, call_##name},

/* Defines the table `functions`. */
#define DEFINE_FUNCTIONS(FUNCTIONS)       \
  FUNCTIONS(DEFINE_PLAIN, DEFINE_CHECKED) \
  static const function functions[] = {FUNCTIONS(LIST_PLAIN, LIST_CHECKED)};

/* A screw is its eight numbers, and may be placed wherever they are. */
#define SCREW_AT(array) ((screw *)(void *)(array))
#define CONST_SCREW_AT(array) ((const screw *)(const void *)(array))

enum { MOST_ARRAYS = 5, MOST_NUMBERS = 36 };

static inline int size_of_kind(char kind) {
  switch (kind) {
  case 'a':            /* angle */
  case 'p':            /* positive number */
  case 't': return 1;  /* tolerance */
  case 'w':            /* rotation vector */
  case 'x': return 3;  /* vector */
  case 'L':            /* line of unit direction */
  case 'V': return 6;  /* twist or wrench */
  case 'S':            /* screw */
  case 'H': return 8;  /* screw of which only translation and angle are read */
  case 'U':            /* matrix of a twist */
  case 'D':            /* rate of a pose */
  case 'T': return 16; /* pose */
  case 'E': return 24; /* eight sets of three joint angles */
  case 'A': return 36; /* adjoint */
  default: return 9; /* M any matrix, W matrix without its diagonal, R rotation, P three points, F those points moved */
  }
}

/* Whether a bad number in this place makes a bad result. */
static inline int is_read(char kind, int i) {
  switch (kind) {
  case 't': return 0;
  case 'H': return i >= 6;
  case 'U': return i < 12 && i % 5 != 0;
  case 'D':
  case 'T': return i < 12;
  case 'W': return i % 4 != 0;
  default: return 1;
  }
}

/* `previous` is the input before this one: three points and the same three points moved. */
static inline void make_input(char kind, const real *previous, real *x) {
  real pose[16];
  switch (kind) {
  case 't': x[0] = K(0.01); break;
  case 'p': x[0] = (real)uniform(0, 1); break;
  case 'R':
  case 'M':
  case 'W': random_rotation(x); break;
  case 'T': random_pose(2, x); break;
  case 'L':
    random_vector(1, x);
    random_vector(1, pose);
    cross_of(pose, x, x + 3);
    break;
  case 'F':
    random_pose(2, pose);
    for (int i = 0; i < 9; i += 3) FN(chs_se3_apply)(pose, previous + i, x + i);
    break;
  default:
    for (int i = 0; i < size_of_kind(kind); i++) x[i] = (real)uniform(-1, 1);
  }
}

/* The inputs of one call and the outputs it gave. */
typedef struct example {
  real in[MOST_ARRAYS][MOST_NUMBERS], out[MOST_ARRAYS][MOST_NUMBERS];
  int status;
} example;

static inline int inputs_of(const function *f) { return (int)strlen(f->inputs); }
static inline int outputs_of(const function *f) { return (int)strlen(f->outputs); }

static inline void make_inputs(const function *f, example *e) {
  subject = f->name;
  for (int i = 0; i < inputs_of(f); i++) make_input(f->inputs[i], i > 0 ? e->in[i - 1] : NULL, e->in[i]);
}

static inline void run(const function *f, example *e) {
  const real *in[MOST_ARRAYS] = {e->in[0], e->in[1], e->in[2]};
  real *out[MOST_ARRAYS] = {e->out[0], e->out[1], e->out[2], e->out[3], e->out[4]};
  e->status = f->call(in, out);
}

static inline void assert_outputs(const function *f, const example *expected, real *const out[]) {
  for (int k = 0; k < outputs_of(f); k++) ASSERT_SAME_BITS(expected->out[k], out[k], size_of_kind(f->outputs[k]));
}

/* Runs f with the input i at arena[40] and the outputs from `first` to `last` one after the other from there, moved by
 * shift. The other arrays stay apart. */
static inline void assert_placement_is_harmless(const function *f, const example *e, int i, int first, int last,
                                                int shift) {
  real *arena = (real *)calloc(160, sizeof(real)), apart[MOST_ARRAYS][MOST_NUMBERS];
  const real *in[MOST_ARRAYS];
  real *out[MOST_ARRAYS], *next = arena + 40 + shift;
  for (int k = 0; k < MOST_ARRAYS; k++) {
    in[k] = e->in[k];
    out[k] = apart[k];
  }
  memcpy(arena + 40, e->in[i], (size_t)size_of_kind(f->inputs[i]) * sizeof(real));
  in[i] = arena + 40;
  for (int k = first; k <= last; k++) {
    out[k] = next;
    next += size_of_kind(f->outputs[k]);
  }
  ASSERT_STATUS(e->status, f->call(in, out));
  assert_outputs(f, e, out);
  free(arena);
}

/* Two inputs and the first output are all the same array. */
static inline void assert_one_array_is_harmless(const function *f, int i, int j) {
  example e;
  make_inputs(f, &e);
  memcpy(e.in[j], e.in[i], sizeof e.in[i]);
  run(f, &e);
  real apart[MOST_ARRAYS][MOST_NUMBERS], same[MOST_NUMBERS];
  const real *in[MOST_ARRAYS] = {e.in[0], e.in[1], e.in[2]};
  real *out[MOST_ARRAYS] = {same, apart[1], apart[2], apart[3], apart[4]};
  memcpy(same, e.in[i], sizeof same);
  in[i] = in[j] = same;
  ASSERT_STATUS(e.status, f->call(in, out));
  if (e.status >= 0) assert_outputs(f, &e, out);
}

/* Each output over each input in every position in which they share an element, and all of them at once. */
static inline void assert_overlap_is_harmless(const function *f) {
  example e;
  make_inputs(f, &e);
  run(f, &e);
  for (int i = 0; i < inputs_of(f); i++) {
    int size = size_of_kind(f->inputs[i]);
    for (int o = 0; o < outputs_of(f); o++)
      for (int shift = 1 - size_of_kind(f->outputs[o]); shift < size; shift++)
        assert_placement_is_harmless(f, &e, i, o, o, shift);
    if (outputs_of(f) > 0) assert_placement_is_harmless(f, &e, i, 0, outputs_of(f) - 1, 0);
    for (int j = i + 1; j < inputs_of(f); j++)
      if (f->inputs[i] == f->inputs[j] && outputs_of(f) > 0) assert_one_array_is_harmless(f, i, j);
  }
}

static inline void assert_refused(const function *f, example *e, int status) {
  fill_with_pattern(e->out, sizeof e->out);
  run(f, e);
  ASSERT_STATUS(status, e->status);
  assert_untouched(f->name, e->out, sizeof e->out, __LINE__);
}

/* A bad number in each place that is read; with an infinity in another place NaN still counts. */
static inline void assert_bad_numbers_are_refused(const function *f) {
  for (int i = 0; i < inputs_of(f); i++)
    for (int k = 0; k < size_of_kind(f->inputs[i]); k++) {
      if (!is_read(f->inputs[i], k)) continue;
      example e;
      make_inputs(f, &e);
      e.in[i][k] = (real)INFINITY;
      assert_refused(f, &e, CHS_ERR_INFINITE);
      e.in[i][k] = -(real)INFINITY;
      assert_refused(f, &e, CHS_ERR_INFINITE);
      e.in[i][k] = (real)NAN;
      assert_refused(f, &e, CHS_ERR_NAN);
      for (int j = 0; j < inputs_of(f); j++)
        for (int m = 0; m < size_of_kind(f->inputs[j]); m++) {
          if (!is_read(f->inputs[j], m) || (i == j && m == k)) continue;
          real good = e.in[j][m];
          e.in[j][m] = (real)INFINITY;
          assert_refused(f, &e, CHS_ERR_NAN);
          e.in[j][m] = good;
        }
    }
}

static inline void assert_nan_goes_through(const function *f) {
  for (int i = 0; i < inputs_of(f); i++)
    for (int k = 0; k < size_of_kind(f->inputs[i]); k++) {
      if (!is_read(f->inputs[i], k)) continue;
      example e;
      make_inputs(f, &e);
      e.in[i][k] = (real)NAN;
      run(f, &e);
      int nans = 0;
      for (int o = 0; o < outputs_of(f); o++)
        for (int m = 0; m < size_of_kind(f->outputs[o]); m++) nans += e.out[o][m] != e.out[o][m];
      if (nans == 0) fail(__LINE__, "NaN in place %d of input %d was lost by", k, i);
    }
}

static inline void assert_unread_numbers_do_not_matter(const function *f) {
  example e;
  make_inputs(f, &e);
  run(f, &e);
  example spoilt = e;
  real *out[MOST_ARRAYS] = {spoilt.out[0], spoilt.out[1], spoilt.out[2], spoilt.out[3], spoilt.out[4]};
  for (int i = 0; i < inputs_of(f); i++)
    for (int k = 0; k < size_of_kind(f->inputs[i]); k++)
      if (f->inputs[i] != 't' && !is_read(f->inputs[i], k)) spoilt.in[i][k] = (real)NAN;
  run(f, &spoilt);
  ASSERT_STATUS(e.status, spoilt.status);
  assert_outputs(f, &e, out);
}

typedef struct bad_rotation {
  const char *name;
  int status;
  real R[9];
} bad_rotation;

static const bad_rotation bad_rotations[] = {
    {"z reflected", CHS_ERR_REFLECTION, {1, 0, 0, 0, 1, 0, 0, 0, -1}},
    {"all axes reflected", CHS_ERR_REFLECTION, {-1, 0, 0, 0, -1, 0, 0, 0, -1}},
    {"x and y exchanged", CHS_ERR_REFLECTION, {0, 1, 0, 1, 0, 0, 0, 0, 1}},
    {"a large reflection", CHS_ERR_REFLECTION, {K(1e30), 0, 0, 0, K(-1e30), 0, 0, 0, K(1e30)}},
    {"a small reflection", CHS_ERR_REFLECTION, {K(1e-30), 0, 0, 0, K(-1e-30), 0, 0, 0, K(1e-30)}},
    {"too large", CHS_ERR_NOT_ROTATION, {K(1.02), 0, 0, 0, K(1.02), 0, 0, 0, K(1.02)}},
    {"too small", CHS_ERR_NOT_ROTATION, {K(0.98), 0, 0, 0, K(0.98), 0, 0, 0, K(0.98)}},
    {"first row long", CHS_ERR_NOT_ROTATION, {K(1.02), 0, 0, 0, 1, 0, 0, 0, 1}},
    {"second row long", CHS_ERR_NOT_ROTATION, {1, 0, 0, 0, K(1.02), 0, 0, 0, 1}},
    {"third row long", CHS_ERR_NOT_ROTATION, {1, 0, 0, 0, 1, 0, 0, 0, K(1.02)}},
    {"first rows not at a right angle", CHS_ERR_NOT_ROTATION, {1, K(0.02), 0, 0, 1, 0, 0, 0, 1}},
    {"third row aslant in x", CHS_ERR_NOT_ROTATION, {1, 0, 0, 0, 1, 0, K(0.02), 0, 1}},
    {"third row aslant in y", CHS_ERR_NOT_ROTATION, {1, 0, 0, 0, 1, 0, 0, K(0.02), 1}},
    {"zero", CHS_ERR_NOT_ROTATION, {0}},
    {"too large to be squared", CHS_ERR_NOT_ROTATION, {REAL_MAX, 0, 0, 0, REAL_MAX, 0, 0, 0, REAL_MAX}},
};

static inline int takes_a_rotation(char kind) { return kind == 'R' || kind == 'T'; }

static inline void put_rotation(char kind, const real R[9], real *x) {
  int columns = kind == 'T' ? 4 : 3;
  for (int i = 0; i < 9; i++) x[columns * (i / 3) + i % 3] = R[i];
}

/* Each matrix of the table, turned somehow, in each input that is a rotation or a pose. */
static inline void assert_bad_rotations_are_refused(const function *f) {
  for (int i = 0; i < inputs_of(f); i++) {
    if (!takes_a_rotation(f->inputs[i])) continue;
    for (int b = 0; b < LENGTH(bad_rotations); b++) {
      example e;
      make_inputs(f, &e);
      put_rotation(f->inputs[i], bad_rotations[b].R, e.in[i]);
      subject = bad_rotations[b].name;
      assert_refused(f, &e, bad_rotations[b].status);
    }
  }
}

/* Drift well below CHS_SO3_FAR is no error. */
static inline void assert_drift_is_accepted(const function *f) {
  const real drift = (real)(0.45 * CHS_SO3_FAR);
  for (int i = 0; i < inputs_of(f); i++) {
    if (!takes_a_rotation(f->inputs[i])) continue;
    example e;
    make_inputs(f, &e);
    for (int k = 0; k < size_of_kind(f->inputs[i]); k++) e.in[i][k] *= 1 + drift;
    run(f, &e);
    if (e.status < 0) fail(__LINE__, "a rotation with drift was refused with %d by", e.status);
  }
}

/* One test for each clause, over all functions of the file; run by RUN_CONTRACT_TESTS. */
#define DEFINE_CONTRACT_TESTS()                                                                               \
  static void for_each_function(void (*assertion)(const function *), int plain, int checked) {                \
    for (int k = 0; k < LENGTH(functions); k++)                                                               \
      if (functions[k].checked ? checked : plain) assertion(functions + k);                                   \
  }                                                                                                           \
  static void test_outputs_may_overlap_inputs(void) { for_each_function(assert_overlap_is_harmless, 1, 1); }  \
  static void test_what_is_not_read_does_not_matter(void) {                                                   \
    for_each_function(assert_unread_numbers_do_not_matter, 1, 1);                                             \
  }                                                                                                           \
  static void test_plain_algebra_lets_nan_through(void) { for_each_function(assert_nan_goes_through, 1, 0); } \
  static void test_bad_numbers_are_refused_and_nan_counts_more_than_infinity(void) {                          \
    for_each_function(assert_bad_numbers_are_refused, 0, 1);                                                  \
  }                                                                                                           \
  static void test_matrices_that_are_no_rotations_are_refused(void) {                                         \
    for_each_function(assert_bad_rotations_are_refused, 0, 1);                                                \
  }                                                                                                           \
  static void test_rotations_with_some_drift_are_accepted(void) { for_each_function(assert_drift_is_accepted, 0, 1); }

#define RUN_CONTRACT_TESTS()                                                \
  RUN_TEST(test_outputs_may_overlap_inputs);                                \
  RUN_TEST(test_what_is_not_read_does_not_matter);                          \
  RUN_TEST(test_plain_algebra_lets_nan_through);                            \
  RUN_TEST(test_bad_numbers_are_refused_and_nan_counts_more_than_infinity); \
  RUN_TEST(test_matrices_that_are_no_rotations_are_refused);                \
  RUN_TEST(test_rotations_with_some_drift_are_accepted)

#endif
