/* report.h - a tally as a table, as CSV and as JSON. */
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>

#include "tally.h"

/* The table; with quiet only rows that fail. */
void report_table(const struct tally *tally, bool quiet);

/* Faults other than errors: wrong statuses, outputs written that should not be. */
void report_faults(const struct tally *tally);

/* The worst cases in full. */
void report_worst(const struct tally *tally);

/* What the device is, whether its bits are those of this machine, and what the line lost. */
void report_device(const struct tally *tally, const struct device *device);

/* One line: verdict, cases, compiler, target, version. */
void report_summary(const struct tally *tally);

/* The same rows in a file. False with a message when it cannot be written in full. */
bool report_csv(const struct tally *tally, const char *name);
bool report_json(const struct tally *tally, const char *name);

#endif
