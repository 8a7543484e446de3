/* angles.c - see angles.h. */
#include "angles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "text.h"

static const double pi = 3.14159265358979323846;

double in_degrees(double radians) { return radians * (180.0 / pi); }

double in_radians(double degrees) { return degrees * (pi / 180.0); }

/* The decimal number that the text starts with; *end is what follows it. strtod takes blanks, hexadecimal digits,
 * infinities and NaN too: none of them is meant here. */
static bool read_leading_number(const char *text, const char **end, double *value) {
  char *after;
  *value = strtod(text, &after);
  *end = after;
  return after != text && (size_t)(after - text) <= strspn(text, "+-.0123456789eE") && isfinite(*value);
}

bool read_number(const char *text, double *value) {
  const char *end;
  return read_leading_number(text, &end, value) && *end == '\0';
}

bool read_angle(const char *text, double *radians) {
  const char *unit;
  double value;
  if (!read_leading_number(text, &unit, &value)) return false;
  const bool degrees = strcmp(unit, "deg") == 0;
  *radians = degrees ? in_radians(value) : value;
  return degrees || strcmp(unit, "rad") == 0;
}

/* The numbers after the last one, up to `end`, by the step between the last two; the new count, or 0. */
static int fill_in(double *values, int count, int most, double end) {
  if (count < 2) return 0;
  const double start = values[count - 1];
  const double step = start - values[count - 2];
  const double steps = floor((end - start) / step + 1e-9);
  if (!(steps >= 1.0 && steps <= most - count)) return 0;
  for (int i = 1; i <= (int)steps; ++i) values[count++] = start + i * step;
  return count;
}

int read_number_list(const char *text, double *values, int most) {
  int count = 0;
  for (;;) {
    const bool fills = strncmp(text, "...,", 4) == 0;
    double value;
    if (!read_leading_number(fills ? text + 4 : text, &text, &value)) return 0;
    if (fills) {
      count = fill_in(values, count, most, value);
      if (count == 0) return 0;
    } else {
      if (count == most) return 0;
      values[count++] = value;
    }
    if (*text == '\0') return count;
    if (*text++ != ',') return 0;
  }
}

bool option_degrees(const char *name, const char *word, double least, double most, double *degrees) {
  if (read_number(word, degrees) && *degrees >= least && *degrees <= most) return true;
  complain("--%s expects degrees from %g to %g, not '%s'", name, least, most, word);
  return false;
}

bool option_count(const char *name, const char *word, long least, long most, long *count) {
  if (parse_integer(word, least, most, count)) return true;
  complain("--%s expects a number from %ld to %ld, not '%s'", name, least, most, word);
  return false;
}

bool option_epsilon(const char *word, double *radians) {
  if (read_angle(word, radians) && *radians > 0.0 && *radians <= 0.5) return true;
  complain("--epsilon expects an angle above 0 and up to 0.5rad, as 0.01deg or 1e-4rad, not '%s'", word);
  return false;
}

void print_degrees(FILE *file, double radians) {
  fputc(',', file);
  if (!isnan(radians)) fprintf(file, "%.9g", in_degrees(radians));
}

bool is_inside(int joints, const double *nominal, const double *errors, const double *worst) {
  for (int i = 0; i < joints; ++i) {
    if (fabs(worst[i] - nominal[i]) < errors[i] * (1.0 - 1e-9)) return true;
  }
  return false;
}
