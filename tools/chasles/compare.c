/* compare.c - chasles compare: the library against reference vectors. */
#include <getopt.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "commands.h"
#include "device.h"
#include "line.h"
#include "paths.h"
#include "report.h"
#include "selection.h"
#include "tally.h"
#include "vectors.h"

const char compare_help[] =
    "usage: chasles compare [options] DIR_OR_FILE...\n"
    "\n"
    "Calls every function of the library on the inputs of reference vectors and compares the results with the\n"
    "exact ones. For each function, group of outputs, precision and band of inputs it prints the number of cases,\n"
    "the largest and the mean error in eps of the format (2^-52 for double, 2^-23 for float), the error that the\n"
    "public header promises, PASS or FAIL, and the name of the worst case. Statuses must be exactly those expected,\n"
    "and on an error status no byte of the outputs may change. The array form of a function is called for 17 copies\n"
    "of each input; it must answer for all alike, and is compared as the function is.\n"
    "\n"
    "With --device the functions are called on a controller, or an emulated one, that runs the program of\n"
    "tools/firmware, and its results are compared; a column says whether their bits and statuses equal those of this\n"
    "machine (any NaN equals any other). Where the device counts, the least and the most instructions of a call are\n"
    "shown, the least among calls without an error; --counts has every call. A line that loses or damages bytes\n"
    "costs time, not results: requests are repeated, and counted.\n"
    "\n"
    "Of a directory, the files that end in .f64.txt or .f32.txt are read; '-' is standard input.\n"
    "\n"
    "options:\n"
    "  --only FUNCTION    compare this function only; may be repeated, or hold several parted by commas\n"
    "                     (default: all)\n"
    "  --device LINE      call the functions on a device: /dev/NAME[:BAUD] (115200 unless given), tcp:HOST:PORT, or\n"
    "                     exec:COMMAND for a program that is one on its standard input and output\n"
    "  --worst N          print the N worst cases in full, in hexadecimal and decimal (default: 0)\n"
    "  --quiet            print only the rows that fail, and the summary\n"
    "  --csv FILE         write the table to FILE as CSV\n"
    "  --json FILE        write the table and the faults to FILE as JSON\n"
    "  --counts FILE      write to FILE as CSV what the device counted in each call\n"
    "  --help             print this help\n"
    "\n"
    "exit status:\n"
    "  0  every result is within its promise\n"
    "  1  some result is not, or a status or an untouched output is wrong\n"
    "  2  unusable input: nothing to read, a malformed file, an unknown function, a device that does not\n"
    "     answer, an output that cannot be written\n"
    "\n"
    "examples:\n"
    "  chasles compare tests/vectors\n"
    "  chasles compare --only so3_exp,so3_log --worst 3 --json report.json tests/vectors\n"
    "  chasles compare --device /dev/ttyACM0 --only so3_exp tests/vectors\n";

enum { MOST_WORST = 10000, CASES_BETWEEN_PROGRESS = 4096 };

struct options {
  struct selection only;
  struct paths paths;
  long worst;
  bool quiet;
  const char *csv;
  const char *json;
  const char *counts;
  const char *device;
};

/* How far the run is, once a second, on a terminal only. */
struct progress {
  bool terminal;
  bool shown;
  time_t last; /* second of the start, then of the last line shown */
};

static void progress_show(struct progress *progress, int file, int files, const struct tally *tally) {
  if (!progress->terminal || seconds_now() == progress->last) return;
  fprintf(stderr, "\r\033[Kfile %d of %d, %ld cases", file, files, tally->cases);
  progress->shown = true;
  progress->last = seconds_now();
}

static void progress_end(const struct progress *progress) {
  if (progress->shown) fputs("\r\033[K", stderr);
}

enum { FORMS = 2 };

/* Cases that are read ahead, because a device takes many at a time. */
struct batch {
  const struct function *forms[FORMS]; /* what is called: the function, its array form; NULL where not wanted */
  struct device *device;               /* NULL: the library in this program */
  FILE *counts;                        /* what each call took; NULL: nobody asked */
  int space;
  int count;
  struct vector_case *records;
  struct device_call *calls;
};

static bool batch_init(struct batch *batch, struct device *device, FILE *counts) {
  batch->device = device;
  batch->counts = counts;
  batch->space = device == NULL ? 1 : device_batch(device);
  batch->count = 0;
  batch->records = calloc((size_t)batch->space, sizeof *batch->records);
  batch->calls = calloc((size_t)batch->space, sizeof *batch->calls);
  if (batch->records != NULL && batch->calls != NULL) return true;
  complain("not enough memory for %d cases", batch->space);
  return false;
}

static void batch_free(struct batch *batch) {
  free(batch->records);
  free(batch->calls);
}

static void print_count(FILE *file, const struct vectors *vectors, const struct vector_case *record,
                        const struct device_call *call) {
  fprintf(file, "%s,%s,%s,%s,%d,%lu\n", vectors->function->name, precision_name(vectors->precision), record->band,
          record->name, call->answer.status, (unsigned long)call->count);
}

/* Chooses the forms of a function; false when there are none. */
static bool batch_wants(struct batch *batch, const struct selection *only, const struct function *function) {
  const struct function *array = find_array_form(function);
  batch->forms[0] = selection_has(only, function) ? function : NULL;
  batch->forms[1] = array != NULL && selection_has(only, array) ? array : NULL;
  return batch->forms[0] != NULL || batch->forms[1] != NULL;
}

static bool batch_call(struct batch *batch, struct tally *tally, const char *name, const struct vectors *vectors) {
  const struct function *function = vectors->function;
  if (batch->device != NULL &&
      !device_evaluate(batch->device, function, vectors->precision, batch->calls, batch->count)) {
    return false;
  }
  for (int i = 0; i < batch->count; ++i) {
    const struct vector_case *record = &batch->records[i];
    struct answer here;
    evaluate(function, vectors->precision, record->in, &here);
    if (!tally_add(tally, name, vectors, record, &here, batch->device == NULL ? NULL : &batch->calls[i])) return false;
    if (batch->counts != NULL) print_count(batch->counts, vectors, record, &batch->calls[i]);
  }
  return true;
}

/* Evaluates the cases read so far, and forgets them. */
static bool batch_compare(struct batch *batch, struct tally *tally, const char *name, struct vectors *vectors) {
  const struct function *single = vectors->function;
  bool good = true;
  for (int i = 0; i < batch->count; ++i) batch->calls[i].in = batch->records[i].in;
  for (int i = 0; good && i < FORMS; ++i) {
    if (batch->forms[i] == NULL) continue;
    vectors->function = batch->forms[i];
    good = batch_call(batch, tally, name, vectors);
  }
  vectors->function = single;
  batch->count = 0;
  return good;
}

static bool compare_cases(struct tally *tally, const char *name, struct vectors *vectors, struct batch *batch,
                          struct progress *progress, int file, int files) {
  long count = 0;
  enum text_result result;
  while ((result = vectors_next(vectors, &batch->records[batch->count])) == TEXT_LINE) {
    if (++batch->count == batch->space && !batch_compare(batch, tally, name, vectors)) return false;
    if (++count % CASES_BETWEEN_PROGRESS == 0) progress_show(progress, file, files, tally);
  }
  if (result == TEXT_END && count == 0) result = text_expected(&vectors->text, NULL, "'case'");
  return result == TEXT_END && batch_compare(batch, tally, name, vectors);
}

static bool compare_files(struct tally *tally, const struct options *options, struct batch *batch) {
  struct progress progress = {isatty(STDERR_FILENO) != 0, false, seconds_now()};
  bool good = true;
  for (int i = 0; good && i < options->paths.count; ++i) {
    const char *name = options->paths.names[i];
    struct vectors vectors;
    progress_show(&progress, i + 1, options->paths.count, tally);
    good = vectors_open(&vectors, name);
    if (!good) break;
    if (batch_wants(batch, &options->only, vectors.function)) {
      ++tally->files;
      good = compare_cases(tally, name, &vectors, batch, &progress, i + 1, options->paths.count);
    }
    vectors_close(&vectors);
  }
  progress_end(&progress);
  return good;
}

/* Nothing may look compared that was not. A function asked for by name needs vectors. */
static bool check_coverage(const struct tally *tally, const struct options *options) {
  bool good = true;
  for (int i = 0; i < function_count && options->only.chosen != NULL; ++i) {
    if (tally->seen[i] || !selection_has(&options->only, &functions[i])) continue;
    complain("no vectors of %s in what was given", functions[i].name);
    good = false;
  }
  return good;
}

/* A whole directory is expected to cover the library: what it leaves out is said. */
static void print_uncovered(const struct tally *tally, const struct options *options) {
  bool any = false;
  if (options->only.chosen != NULL || !options->paths.has_directory) return;
  for (int i = 0; i < function_count; ++i) {
    if (tally->seen[i]) continue;
    printf("%s %s", any ? "," : "not compared, no vectors:", functions[i].name);
    any = true;
  }
  if (any) putchar('\n');
}

static int report(struct tally *tally, const struct options *options, const struct device *device) {
  tally_sort(tally);
  report_table(tally, options->quiet);
  report_faults(tally);
  report_worst(tally);
  print_uncovered(tally, options);
  if (device != NULL) report_device(tally, device);
  report_summary(tally);
  bool written = options->csv == NULL || report_csv(tally, options->csv);
  if (options->json != NULL && !report_json(tally, options->json)) written = false;
  if (!written) return UNUSABLE;
  return tally->failures == 0 ? ALL_WELL : SOMETHING_OVER;
}

static int compare_with(struct options *options, struct device *device, FILE *counts) {
  struct tally tally;
  struct batch batch;
  int status = UNUSABLE;
  paths_sort(&options->paths);
  if (!tally_init(&tally, (int)options->worst)) return UNUSABLE;
  tally.device = device != NULL;
  if (batch_init(&batch, device, counts) && compare_files(&tally, options, &batch) && check_coverage(&tally, options)) {
    status = report(&tally, options, device);
  }
  batch_free(&batch);
  tally_free(&tally);
  return status;
}

static int compare(struct options *options) {
  if (options->device == NULL) return compare_with(options, NULL, NULL);
  struct device *device = device_open(options->device);
  if (device == NULL) return UNUSABLE;
  FILE *counts = options->counts == NULL ? NULL : output_open(options->counts);
  int status = UNUSABLE;
  if (counts != NULL) fputs("function,precision,band,case,status,count\n", counts);
  if (counts != NULL || options->counts == NULL) status = compare_with(options, device, counts);
  if (counts != NULL && !output_close(counts, options->counts)) status = UNUSABLE;
  device_close(device);
  return status;
}

/* Returns the exit status when the run ends here, or -1. */
static int read_options(int argc, char **argv, struct options *options) {
  static const struct option names[] = {{"only", required_argument, NULL, 'o'},
                                        {"device", required_argument, NULL, 'd'},
                                        {"worst", required_argument, NULL, 'w'},
                                        {"quiet", no_argument, NULL, 'q'},
                                        {"csv", required_argument, NULL, 'c'},
                                        {"json", required_argument, NULL, 'j'},
                                        {"counts", required_argument, NULL, 'n'},
                                        {"help", no_argument, NULL, 'h'},
                                        {NULL, 0, NULL, 0}};
  int option;
  while ((option = getopt_long(argc, argv, ":h", names, NULL)) != -1) {
    switch (option) {
    case 'o':
      if (!selection_add(&options->only, optarg)) return UNUSABLE;
      break;
    case 'd': options->device = optarg; break;
    case 'w':
      if (parse_integer(optarg, 0, MOST_WORST, &options->worst)) break;
      complain("--worst expects a number from 0 to %d, not '%s'", (int)MOST_WORST, optarg);
      return UNUSABLE;
    case 'q': options->quiet = true; break;
    case 'c': options->csv = optarg; break;
    case 'j': options->json = optarg; break;
    case 'n': options->counts = optarg; break;
    case 'h': fputs(compare_help, stdout); return ALL_WELL;
    default: return bad_option(option, argv);
    }
  }
  if (optind == argc) {
    complain("compare expects a directory or a file of vectors; see 'chasles help compare'");
    return UNUSABLE;
  }
  if (options->counts != NULL && options->device == NULL) {
    complain("--counts needs --device: only a device counts");
    return UNUSABLE;
  }
  for (int i = optind; i < argc; ++i) {
    if (!paths_add(&options->paths, argv[i])) return UNUSABLE;
  }
  return -1;
}

int compare_command(int argc, char **argv) {
  struct options options;
  memset(&options, 0, sizeof options);
  int status = read_options(argc, argv, &options);
  if (status == -1) status = compare(&options);
  selection_free(&options.only);
  paths_free(&options.paths);
  return status;
}
