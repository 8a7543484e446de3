/* angles.h - angles and numbers as options hold them. */
#ifndef ANGLES_H
#define ANGLES_H

#include <stdbool.h>

double in_degrees(double radians);
double in_radians(double degrees);

/* A finite number that is the whole of the text. */
bool read_number(const char *text, double *value);

/* The same with deg or rad behind it, in radians. */
bool read_angle(const char *text, double *radians);

/* Numbers parted by commas; a,b,...,z stands for all from a to z by steps of b - a. How many, or 0 where the text is no
 * such list or one of more than `most`. */
int read_number_list(const char *text, double *values, int most);

#endif
