/* tally.c - see tally.h. */
#include "tally.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_ROWS = 10000 };

bool tally_init(struct tally *tally, int worst) {
  memset(tally, 0, sizeof *tally);
  tally->worst_space = worst;
  tally->worst = calloc((size_t)worst + 1, sizeof *tally->worst); /* one more: a request for 0 bytes may give NULL */
  tally->faults = calloc(MOST_FAULTS_KEPT, sizeof *tally->faults);
  tally->seen = calloc((size_t)function_count, sizeof *tally->seen);
  if (tally->worst != NULL && tally->faults != NULL && tally->seen != NULL) return true;
  complain("not enough memory to keep %d cases", worst);
  tally_free(tally);
  return false;
}

void tally_free(struct tally *tally) {
  free(tally->rows);
  free(tally->worst);
  free(tally->faults);
  free(tally->seen);
}

/* |got - (high + low)|, infinite where a finite, or another infinite, number or a NaN was expected.
 *
 * high is the exact result rounded to the format and low, the rest, is smaller than half a unit in high's last
 * place; their sum does not fit one number. got - high loses nothing: it is exact when the two are within a factor
 * of 2 (Sterbenz), and when they are not, the error is so large that its own last digits do not matter. So low is
 * subtracted from the difference, where it counts, and double is enough for either format. */
static double difference(double got, double high, double low) {
  if (isnan(high)) return isnan(got) ? 0.0 : (double)INFINITY;
  if (isinf(high)) return got == high ? 0.0 : (double)INFINITY;
  return isfinite(got) ? fabs((got - high) - low) : (double)INFINITY;
}

/* Each difference is divided by the scale before it is squared, so that nothing underflows or overflows on the way. */
double group_error(const struct group *group, enum precision precision, const struct vector_case *record, double scale,
                   const double *got) {
  double largest = 0.0;
  double squares = 0.0;
  for (int i = 0; i < group->count; ++i) {
    const int k = group->index[i];
    const double off = difference(got[k], record->high[k], record->low[k]);
    const double error = off == 0.0 ? 0.0 : off / scale / precision_eps(precision);
    largest = fmax(largest, error);
    squares += error * error;
  }
  return group->norm ? sqrt(squares) : largest;
}

static double promised(const struct promise *promise, const char *band) {
  const bool beyond = strcmp(band, "beyond_pi") == 0 || strcmp(band, "far") == 0;
  return beyond ? promise->beyond_pi : promise->within_pi;
}

static double excess_of(double error, double promise) {
  if (promise > 0.0) return error / promise;
  return error > 0.0 ? (double)INFINITY : 0.0;
}

static bool status_expected(const struct vector_case *record, int status) {
  for (int i = 0; i < record->status_count; ++i) {
    if (record->statuses[i] == status) return true;
  }
  return false;
}

/* NaNs differ in sign and payload from one machine to the next, and count as equal. */
static bool same_number(double a, double b, enum precision precision) {
  return (isnan(a) && isnan(b)) || precision_bits(a, precision) == precision_bits(b, precision);
}

static bool same_state(const struct answer *a, const struct answer *b) {
  return a->status == b->status && a->untouched == b->untouched && a->wrote_past == b->wrote_past;
}

/* The outputs of the group, or that all is the same but for outputs. */
static bool same_group(const struct group *group, const struct specimen *specimen) {
  const struct answer *a = &specimen->answer;
  const struct answer *b = &specimen->here;
  if (!same_state(a, b)) return false;
  for (int i = 0; i < group->count && a->status >= 0; ++i) {
    if (!same_number(a->out[group->index[i]], b->out[group->index[i]], specimen->precision)) return false;
  }
  return true;
}

static bool same_answers(const struct vectors *vectors, const struct specimen *specimen) {
  for (int i = 0; i < vectors->group_count; ++i) {
    if (!same_group(&vectors->groups[i], specimen)) return false;
  }
  return same_state(&specimen->answer, &specimen->here);
}

static enum fault find_fault(const struct vectors *vectors, const struct specimen *specimen) {
  const struct vector_case *record = &specimen->record;
  const struct answer *answer = &specimen->answer;
  if (answer->wrote_past) return WROTE_PAST;
  if (!status_expected(record, answer->status)) return WRONG_STATUS;
  if (answer->status < 0 && !answer->untouched) return TOUCHED_OUTPUTS;
  if (!same_answers(vectors, specimen)) return DIFFERENT_BITS;
  return NO_FAULT;
}

static struct row *new_row(struct tally *tally) {
  if (tally->row_count == tally->row_space) {
    const int space = tally->row_space == 0 ? 64 : 2 * tally->row_space;
    struct row *rows = space > MOST_ROWS ? NULL : realloc(tally->rows, (size_t)space * sizeof *rows);
    if (rows == NULL) {
      complain("too many bands for one table: %d rows", tally->row_count);
      return NULL;
    }
    tally->rows = rows;
    tally->row_space = space;
  }
  struct row *row = &tally->rows[tally->row_count];
  memset(row, 0, sizeof *row);
  row->order = tally->row_count++;
  return row;
}

static struct row *find_row(struct tally *tally, const struct vectors *vectors, const struct promise *group,
                            const char *band) {
  for (int i = tally->row_count - 1; i >= 0; --i) {
    struct row *row = &tally->rows[i];
    if (row->function == vectors->function && row->group == group && row->precision == vectors->precision &&
        strcmp(row->band, band) == 0) {
      return row;
    }
  }
  struct row *row = new_row(tally);
  if (row == NULL) return NULL;
  row->function = vectors->function;
  row->group = group;
  row->precision = vectors->precision;
  row->promise = group == NULL ? 0.0 : promised(group, band);
  strcpy(row->band, band);
  return row;
}

/* A case of which a row has no error: no values were expected, or none are to be believed. */
static void row_add_status(struct row *row, enum fault fault) {
  ++row->cases;
  if (fault != NO_FAULT) ++row->failures;
}

static void row_add_error(struct row *row, enum fault fault, double error, const char *name) {
  ++row->cases;
  if (fault != NO_FAULT || !(error <= row->promise)) ++row->failures;
  if (row->measured++ == 0 || error > row->largest) {
    row->largest = error;
    strcpy(row->worst_case, name);
  }
  row->sum += error;
}

static void row_add_device(struct row *row, bool same, int status, unsigned long count) {
  if (!same) ++row->different;
  if (count > row->most) row->most = count;
  if (status >= 0 && (row->least == 0 || count < row->least)) row->least = count;
}

/* Keeps the worst specimens in order; of two alike the first stays first. */
static void keep_worst(struct tally *tally, const struct specimen *specimen) {
  int place = tally->worst_count;
  while (place > 0 && tally->worst[place - 1].excess < specimen->excess) --place;
  if (place == tally->worst_space) return;
  if (tally->worst_count < tally->worst_space) ++tally->worst_count;
  const size_t moved = (size_t)(tally->worst_count - 1 - place);
  memmove(&tally->worst[place + 1], &tally->worst[place], moved * sizeof *tally->worst);
  tally->worst[place] = *specimen;
}

static void keep_fault(struct tally *tally, const struct specimen *specimen) {
  if (tally->fault_count < MOST_FAULTS_KEPT) tally->faults[tally->fault_count] = *specimen;
  ++tally->fault_count;
}

/* Adds the case to the row of each group and notes the worst of them in the specimen. */
static bool add_groups(struct tally *tally, const struct vectors *vectors, struct specimen *specimen,
                       unsigned long count) {
  const struct vector_case *record = &specimen->record;
  const bool measured = record->has_values && specimen->answer.status >= 0;
  for (int i = 0; i < vectors->group_count; ++i) {
    const struct group *group = &vectors->groups[i];
    struct row *row = find_row(tally, vectors, group->promise, record->band);
    if (row == NULL) return false;
    row_add_device(row, same_group(group, specimen), specimen->answer.status, count);
    if (!measured) {
      row_add_status(row, specimen->fault);
      continue;
    }
    const double error = group_error(group, vectors->precision, record, record->scale[i], specimen->answer.out);
    row_add_error(row, specimen->fault, error, record->name);
    const double excess = excess_of(error, row->promise);
    if (specimen->group == NULL || excess > specimen->excess) {
      specimen->group = group->promise;
      specimen->error = error;
      specimen->promise = row->promise;
      specimen->excess = excess;
    }
  }
  return true;
}

bool tally_add(struct tally *tally, const char *file, const struct vectors *vectors, const struct vector_case *record,
               const struct answer *here, const struct device_call *there) {
  const unsigned long count = there == NULL ? 0 : there->count;
  struct specimen specimen;
  specimen.file = file;
  specimen.function = vectors->function;
  specimen.precision = vectors->precision;
  specimen.record = *record;
  specimen.group = NULL;
  specimen.error = 0.0;
  specimen.promise = 0.0;
  specimen.excess = 0.0;
  specimen.here = *here;
  specimen.answer = there == NULL ? *here : there->answer;
  specimen.fault = find_fault(vectors, &specimen);

  if (!add_groups(tally, vectors, &specimen, count)) return false;
  if (vectors->group_count == 0) {
    struct row *row = find_row(tally, vectors, NULL, record->band);
    if (row == NULL) return false;
    row_add_device(row, same_state(&specimen.answer, here), specimen.answer.status, count);
    row_add_status(row, specimen.fault);
  }
  if (!same_answers(vectors, &specimen)) ++tally->different;
  if (count > 0) tally->counted = true;
  if (specimen.fault != NO_FAULT) specimen.excess = (double)INFINITY;

  ++tally->cases;
  if (!(specimen.excess <= 1.0)) ++tally->failures;
  tally->seen[vectors->function - functions] = true;
  if (specimen.fault != NO_FAULT) keep_fault(tally, &specimen);
  keep_worst(tally, &specimen);
  return true;
}

/* The known bands from small to large angles, then the others. */
static int band_rank(const char *band) {
  static const char *const bands[] = {"tiny",    "small", "moderate",  "ordinary", "mixed",   "large",
                                      "near_pi", "at_pi", "beyond_pi", "far",      "example", "degenerate"};
  const int count = (int)(sizeof bands / sizeof bands[0]);
  int rank = 0;
  while (rank < count && strcmp(bands[rank], band) != 0) ++rank;
  return rank;
}

static int sign_of(long difference_of_ranks) { return (difference_of_ranks > 0) - (difference_of_ranks < 0); }

static int compare_rows(const void *left, const void *right) {
  const struct row *a = left;
  const struct row *b = right;
  if (a->function != b->function) return sign_of(a->function - b->function);
  if (a->precision != b->precision) return a->precision < b->precision ? -1 : 1;
  if (a->group != b->group) return sign_of(a->group - b->group);
  const int ranks = band_rank(a->band) - band_rank(b->band);
  return ranks != 0 ? ranks : a->order - b->order;
}

void tally_sort(struct tally *tally) {
  if (tally->row_count > 0) qsort(tally->rows, (size_t)tally->row_count, sizeof *tally->rows, compare_rows);
}

double row_mean(const struct row *row) { return row->measured == 0 ? 0.0 : row->sum / (double)row->measured; }
