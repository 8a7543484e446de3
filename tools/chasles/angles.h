/* angles.h - angles and numbers as options and tables hold them, for the studies of errors. */
#ifndef ANGLES_H
#define ANGLES_H

#include <stdbool.h>
#include <stdio.h>

double in_degrees(double radians);
double in_radians(double degrees);

/* A finite number that is the whole of the text. */
bool read_number(const char *text, double *value);

/* The same with deg or rad behind it, in radians. */
bool read_angle(const char *text, double *radians);

/* Numbers parted by commas; a,b,...,z stands for all from a to z by steps of b - a. How many, or 0 where the text is no
 * such list or one of more than `most`. */
int read_number_list(const char *text, double *values, int most);

/* The value of an option, false after a message that names it: degrees or a number in the closed range; an error of a
 * joint, an angle with its unit, in radians. */
bool option_degrees(const char *name, const char *word, double least, double most, double *degrees);
bool option_count(const char *name, const char *word, long least, long most, long *count);
bool option_epsilon(const char *word, double *radians);

/* A cell of CSV with a comma before it: the angle in degrees, or nothing for a NaN. */
void print_degrees(FILE *file, double radians);

/* Whether a joint of the worst is strictly inside its interval, the nominal value and its error either way. */
bool is_inside(int joints, const double *nominal, const double *errors, const double *worst);

#endif
