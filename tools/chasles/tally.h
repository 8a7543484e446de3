/* tally.h - what `chasles compare` found: errors by function, group of outputs, precision and band. */
#ifndef TALLY_H
#define TALLY_H

#include <stdbool.h>

#include "device.h"
#include "vectors.h"

/* One row of the table. */
struct row {
  const struct function *function;
  const struct promise *group; /* NULL: the function has no outputs, only its status is compared */
  enum precision precision;
  char band[MAX_NAME + 1];
  int order;     /* of appearance */
  long cases;    /* all, also those of which only the status is compared */
  long measured; /* those with an error */
  long failures;
  double promise;
  double largest; /* in eps of the format, like sum */
  double sum;
  long different;            /* cases whose outputs of this group have other bits on the device */
  unsigned long least, most; /* instructions of a call on the device; the least of those without an error */
  char worst_case[MAX_NAME + 1];
};

/* A case that failed by something else than its error. */
enum fault { NO_FAULT, WRONG_STATUS, TOUCHED_OUTPUTS, WROTE_PAST, DIFFERENT_BITS };

/* A case in full, as --worst prints it. */
struct specimen {
  const char *file;
  const struct function *function;
  enum precision precision;
  struct vector_case record;
  struct answer answer; /* the device's, if there is one */
  struct answer here;   /* that of this machine */
  enum fault fault;
  const struct promise *group; /* the worst one; NULL when nothing was measured */
  double error;
  double promise;
  double excess; /* error / promise, infinite when there is a fault: what the worst cases are ranked by */
};

enum { MOST_FAULTS_KEPT = 50 };

struct tally {
  struct row *rows;
  int row_count;
  int row_space;
  struct specimen *worst; /* descending excess; the first worst_count of worst_space are in use */
  int worst_count;
  int worst_space;
  struct specimen *faults; /* the first MOST_FAULTS_KEPT in order of reading */
  long fault_count;        /* all */
  int files;               /* compared; the caller counts them */
  long cases;
  long failures;
  bool device;    /* the answers are a device's */
  bool counted;   /* it counts instructions */
  long different; /* cases with other bits there */
  bool *seen;     /* one flag a function of the registry */
};

/* False with a message when memory is short, as in tally_add. `worst` specimens are kept. */
bool tally_init(struct tally *tally, int worst);
void tally_free(struct tally *tally);

/* Adds one case, as answered here and, unless NULL, by the device. file must live as long as the tally. */
bool tally_add(struct tally *tally, const char *file, const struct vectors *vectors, const struct vector_case *record,
               const struct answer *here, const struct device_call *there);

/* Rows in the order of the registry, then precision, group and band. */
void tally_sort(struct tally *tally);

double row_mean(const struct row *row);

/* The error of a group of outputs in eps of the format. A scale of 0 demands equality. */
double group_error(const struct group *group, enum precision precision, const struct vector_case *record, double scale,
                   const double *got);

#endif
