/* Assertions Unity does not have: errors in eps, bits, statuses, outputs left alone. */
#ifndef CHASLES_TESTS_ASSERTIONS_H
#define CHASLES_TESTS_ASSERTIONS_H

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include <unity.h>

#include "precision.h"
#include "random.h"

/* |actual - expected| <= eps_count eps scale. NaN and infinities fail, expected or not. */
#define ASSERT_WITHIN_EPS(expected, actual, eps_count, scale) \
  assert_within_eps(#actual, (double)(expected), (double)(actual), eps_count, (double)(scale), __LINE__)

/* The same for each of n entries, and for the Euclidean norm of their differences. */
#define ASSERT_ENTRIES_WITHIN_EPS(expected, actual, n, eps_count, scale) \
  assert_entries_within_eps(#actual, expected, actual, n, eps_count, (double)(scale), __LINE__)
#define ASSERT_NORM_WITHIN_EPS(expected, actual, n, eps_count, scale) \
  assert_norm_within_eps(#actual, expected, actual, n, eps_count, (double)(scale), __LINE__)

/* Equal to the last bit, signs of zeros included. */
#define ASSERT_SAME_BITS(expected, actual, n) assert_same_bits(#actual, expected, actual, n, __LINE__)

#define ASSERT_STATUS(expected, actual) assert_status(#actual, expected, actual, __LINE__)

/* The call answers the status and leaves the object `outputs` as it was. */
#define ASSERT_REFUSES(status, outputs, call)                       \
  do {                                                              \
    fill_with_pattern(&(outputs), sizeof(outputs));                 \
    ASSERT_STATUS(status, call);                                    \
    assert_untouched(#call, &(outputs), sizeof(outputs), __LINE__); \
  } while (0)

/* What the test is at, for the message of a failure; an empty text to begin with. */
static const char *subject = "";

static inline void fail(UNITY_LINE_TYPE line, const char *format, ...) {
  char message[512];
  va_list arguments;
  va_start(arguments, format);
  int length = vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  if (length >= 0 && (size_t)length < sizeof message)
    snprintf(message + length, sizeof message - (size_t)length, " %s (CHASLES_TEST_SEED=%llu)", subject,
             (unsigned long long)random_seed());
  UNITY_TEST_FAIL(line, message);
}

static inline void assert_within_eps(const char *name, double expected, double actual, double eps_count, double scale,
                                     UNITY_LINE_TYPE line) {
  double error = fabs(actual - expected);
  if (!(error <= eps_count * (EPS * scale)))
    fail(line, "%s: expected %.17g, got %.17g, off by %.4g eps of %.4g where %.4g are allowed.", name, expected, actual,
         error / EPS / scale, scale, eps_count);
}

static inline void assert_entries_within_eps(const char *name, const real *expected, const real *actual, int n,
                                             double eps_count, double scale, UNITY_LINE_TYPE line) {
  char entry[128];
  for (int i = 0; i < n; i++) {
    snprintf(entry, sizeof entry, "%s[%d]", name, i);
    assert_within_eps(entry, (double)expected[i], (double)actual[i], eps_count, scale, line);
  }
}

static inline void assert_norm_within_eps(const char *name, const real *expected, const real *actual, int n,
                                          double eps_count, double scale, UNITY_LINE_TYPE line) {
  char norm[128];
  double most = 0, sum = 0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs((double)actual[i] - (double)expected[i]));
  for (int i = 0; i < n; i++) sum += pow(((double)actual[i] - (double)expected[i]) / (most > 0 ? most : 1), 2);
  snprintf(norm, sizeof norm, "|%s - expected|", name);
  assert_within_eps(norm, 0, most * sqrt(sum), eps_count, scale, line);
}

static inline void assert_same_bits(const char *name, const real *expected, const real *actual, int n,
                                    UNITY_LINE_TYPE line) {
  for (int i = 0; i < n; i++)
    if (memcmp(expected + i, actual + i, sizeof(real)) != 0)
      fail(line, "%s[%d]: expected %a, got %a.", name, i, (double)expected[i], (double)actual[i]);
}

static inline void assert_status(const char *name, int expected, int actual, UNITY_LINE_TYPE line) {
  if (actual != expected)
    fail(line, "%s: expected %d (%s), got %d (%s).", name, expected, chs_status_text(expected), actual,
         chs_status_text(actual));
}

static inline void fill_with_pattern(void *object, size_t size) { memset(object, 0xA5, size); }

static inline void assert_untouched(const char *name, const void *object, size_t size, UNITY_LINE_TYPE line) {
  const unsigned char *bytes = (const unsigned char *)object;
  for (size_t i = 0; i < size; i++)
    if (bytes[i] != 0xA5) fail(line, "%s has written to byte %lu of its outputs.", name, (unsigned long)i);
}

#endif
