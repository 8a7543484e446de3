/* report.c - see report.h. */
#include "report.h"

#include <chasles/chasles.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#if defined(__clang__)
#define COMPILER __VERSION__
#elif defined(__GNUC__)
#define COMPILER "gcc " __VERSION__
#else
#define COMPILER "an unknown compiler"
#endif

#if defined(__x86_64__)
#define ARCHITECTURE "x86_64"
#elif defined(__i386__)
#define ARCHITECTURE "i386"
#elif defined(__aarch64__)
#define ARCHITECTURE "aarch64"
#elif defined(__arm__)
#define ARCHITECTURE "arm"
#elif defined(__riscv) && __riscv_xlen == 64
#define ARCHITECTURE "riscv64"
#elif defined(__riscv)
#define ARCHITECTURE "riscv32"
#else
#define ARCHITECTURE "unknown"
#endif

#if defined(__linux__)
#define SYSTEM "linux"
#elif defined(__APPLE__)
#define SYSTEM "macos"
#elif defined(__FreeBSD__)
#define SYSTEM "freebsd"
#else
#define SYSTEM "posix"
#endif

enum { LABEL = 80, NUMBER = 24 };

/* "so3_exp.diagonal", or the function alone when it has one group or none. */
static void put_label(const struct function *function, const struct promise *group, char label[LABEL]) {
  if (group == NULL || function->promises[1].group == NULL) {
    snprintf(label, LABEL, "%s", function->name);
  } else {
    snprintf(label, LABEL, "%s.%s", function->name, group->group);
  }
}

/* Errors of a few eps with three digits behind the point, large ones with an exponent. */
static void put_error(double error, char number[NUMBER]) {
  snprintf(number, NUMBER, error < 1e5 ? "%.3f" : "%.2e", error);
}

static bool colour_wanted(void) { return isatty(STDOUT_FILENO) && getenv("NO_COLOR") == NULL; }

/* PASS or FAIL; the latter red on a terminal. */
static const char *verdict(bool pass, bool colour) {
  if (pass) return "PASS";
  return colour ? "\033[1;31mFAIL\033[0m" : "FAIL";
}

static int label_width(const struct tally *tally, bool quiet) {
  size_t width = strlen("function");
  for (int i = 0; i < tally->row_count; ++i) {
    char label[LABEL];
    if (quiet && tally->rows[i].failures == 0) continue;
    put_label(tally->rows[i].function, tally->rows[i].group, label);
    if (strlen(label) > width) width = strlen(label);
  }
  return (int)width;
}

/* The columns of a device, whose titles are given in place of a row's contents. */
static void print_device_columns(const struct tally *tally, const char *bits, const char *least, const char *most) {
  if (!tally->device) return;
  printf("  %-12s", bits);
  if (tally->counted) printf(" %8s %8s", least, most);
}

static void print_row_device(const struct tally *tally, const struct row *row) {
  char bits[LABEL] = "same bits";
  char least[NUMBER] = "-";
  char most[NUMBER];
  if (row->different > 0) snprintf(bits, sizeof bits, "%ld differ", row->different);
  if (row->least > 0) snprintf(least, sizeof least, "%lu", row->least);
  snprintf(most, sizeof most, "%lu", row->most);
  print_device_columns(tally, bits, least, most);
}

static void print_row(const struct tally *tally, const struct row *row, int width, bool colour) {
  char label[LABEL];
  char largest[NUMBER] = "-";
  char mean[NUMBER] = "-";
  char promise[NUMBER] = "-";
  put_label(row->function, row->group, label);
  if (row->measured > 0) {
    put_error(row->largest, largest);
    put_error(row_mean(row), mean);
    snprintf(promise, sizeof promise, "%g", row->promise);
  }
  printf("%-*s %-6s %-10s %6ld %9s %9s %7s  %s", width, label, precision_name(row->precision), row->band, row->cases,
         largest, mean, promise, verdict(row->failures == 0, colour));
  print_row_device(tally, row);
  printf("  %s\n", row->measured > 0 ? row->worst_case : "-");
}

void report_table(const struct tally *tally, bool quiet) {
  const int width = label_width(tally, quiet);
  const bool colour = colour_wanted();
  bool titled = false;
  for (int i = 0; i < tally->row_count; ++i) {
    if (quiet && tally->rows[i].failures == 0) continue;
    if (!titled) {
      printf("Errors in eps of the format, relative to each group's scale.\n\n");
      printf("%-*s %-6s %-10s %6s %9s %9s %7s  %-4s", width, "function", "format", "band", "cases", "largest", "mean",
             "promise", "");
      print_device_columns(tally, "device", "least", "most");
      printf("  %s\n", "worst case");
    }
    titled = true;
    print_row(tally, &tally->rows[i], width, colour);
  }
  if (titled) putchar('\n');
}

/* "0 (text)" or "0|1" */
static void print_expected_statuses(const struct vector_case *record) {
  for (int i = 0; i < record->status_count; ++i) printf("%s%d", i == 0 ? "" : "|", record->statuses[i]);
  if (record->status_count == 1) printf(" (%s)", chs_status_text(record->statuses[0]));
}

/* The first difference from this machine's answer. */
static void print_different_bits(const struct specimen *specimen) {
  const struct answer *there = &specimen->answer;
  const struct answer *here = &specimen->here;
  if (there->status != here->status) {
    printf("status %d on the device, %d here\n", there->status, here->status);
    return;
  }
  for (int i = 0; i < specimen->function->outputs; ++i) {
    const uint64_t a = precision_bits(there->out[i], specimen->precision);
    const uint64_t b = precision_bits(here->out[i], specimen->precision);
    if (a == b) continue;
    printf("out[%d] is %a on the device, %a here\n", i, there->out[i], here->out[i]);
    return;
  }
  printf("the outputs are %s on the device, and not here\n", there->untouched ? "untouched" : "written");
}

static void print_fault(const struct specimen *specimen) {
  const struct answer *answer = &specimen->answer;
  printf("%s:%ld: %s %s %s: ", specimen->file, specimen->record.line, specimen->function->name,
         precision_name(specimen->precision), specimen->record.name);
  switch (specimen->fault) {
  case WRONG_STATUS:
    fputs("wrong status, expected ", stdout);
    print_expected_statuses(&specimen->record);
    printf(", got %d (%s)\n", answer->status, chs_status_text(answer->status));
    break;
  case TOUCHED_OUTPUTS:
    printf("outputs were written in spite of status %d (%s)\n", answer->status, chs_status_text(answer->status));
    break;
  case WROTE_PAST: printf("something was written behind the %d outputs\n", specimen->function->outputs); break;
  case DIFFERENT_BITS: print_different_bits(specimen); break;
  case NO_FAULT: break;
  }
}

static long faults_kept(const struct tally *tally) {
  return tally->fault_count < MOST_FAULTS_KEPT ? tally->fault_count : MOST_FAULTS_KEPT;
}

void report_faults(const struct tally *tally) {
  const long kept = faults_kept(tally);
  for (long i = 0; i < kept; ++i) print_fault(&tally->faults[i]);
  if (tally->fault_count > kept) printf("... and %ld more cases of that kind\n", tally->fault_count - kept);
  if (kept > 0) putchar('\n');
}

/* A number in hexadecimal, exact, and with as many decimal digits as tell it from its neighbours. */
static void print_number(double x, enum precision precision) {
  printf(" %a (%.*g)", x, precision == DOUBLE_PRECISION ? 17 : 9, x);
}

static void print_specimen(const struct specimen *specimen, int rank) {
  const struct vector_case *record = &specimen->record;
  const struct answer *answer = &specimen->answer;
  printf("%d. %s %s, band %s, case %s (%s:%ld)\n", rank, specimen->function->name, precision_name(specimen->precision),
         record->band, record->name, specimen->file, record->line);
  if (specimen->group != NULL) {
    char error[NUMBER];
    put_error(specimen->error, error);
    printf("   largest error: %s eps in %s, promise %g\n", error, specimen->group->group, specimen->promise);
  }
  fputs("   status expected ", stdout);
  print_expected_statuses(record);
  printf(", got %d (%s)\n", answer->status, chs_status_text(answer->status));
  for (int i = 0; i < specimen->function->inputs; ++i) {
    printf("   in[%d] ", i);
    print_number(record->in[i], specimen->precision);
    putchar('\n');
  }
  if (answer->status < 0) {
    printf("   outputs %s\n", answer->untouched ? "untouched" : "were written");
  }
  for (int i = 0; i < specimen->function->outputs; ++i) {
    if (answer->status < 0 && !record->has_values) break;
    printf("   out[%d]", i);
    if (answer->status >= 0) {
      fputs("  got", stdout);
      print_number(answer->out[i], specimen->precision);
    }
    if (record->has_values) {
      fputs("  expected", stdout);
      print_number(record->high[i], specimen->precision);
      printf(" %s %a", signbit(record->low[i]) ? "-" : "+", fabs(record->low[i]));
    }
    putchar('\n');
  }
  putchar('\n');
}

void report_worst(const struct tally *tally) {
  if (tally->worst_count > 0) printf("The worst cases, by error over promise:\n\n");
  for (int i = 0; i < tally->worst_count; ++i) print_specimen(&tally->worst[i], i + 1);
}

void report_device(const struct tally *tally, const struct device *device) {
  const struct device_losses losses = device_losses(device);
  printf("device: %s; cases %ld, same bits %ld, other bits %ld; requests repeated %ld (%ld damaged lines, %ld "
         "silences)\n",
         device_description(device), tally->cases, tally->cases - tally->different, tally->different, losses.repeated,
         losses.damaged, losses.silences);
}

static int functions_seen(const struct tally *tally) {
  int count = 0;
  for (int i = 0; i < function_count; ++i) count += tally->seen[i];
  return count;
}

void report_summary(const struct tally *tally) {
  printf("%s: functions %d, files %d, cases %ld, failed %ld; %s, %s-%s, chasles " CHS_VERSION "\n",
         verdict(tally->failures == 0, colour_wanted()), functions_seen(tally), tally->files, tally->cases,
         tally->failures, COMPILER, ARCHITECTURE, SYSTEM);
}

static void write_csv(const struct tally *tally, FILE *file) {
  fputs("function,group,precision,band,cases,failures,largest_eps,mean_eps,promise_eps,worst_case,result", file);
  fputs(tally->device ? ",other_bits,least_instructions,most_instructions\n" : "\n", file);
  for (int i = 0; i < tally->row_count; ++i) {
    const struct row *row = &tally->rows[i];
    fprintf(file, "%s,%s,%s,%s,%ld,%ld,", row->function->name, row->group == NULL ? "" : row->group->group,
            precision_name(row->precision), row->band, row->cases, row->failures);
    if (row->measured > 0) {
      fprintf(file, "%.9g,%.9g,%g,%s,", row->largest, row_mean(row), row->promise, row->worst_case);
    } else {
      fputs(",,,,", file);
    }
    fputs(row->failures == 0 ? "PASS" : "FAIL", file);
    if (tally->device) fprintf(file, ",%ld,%lu,%lu", row->different, row->least, row->most);
    fputc('\n', file);
  }
}

bool report_csv(const struct tally *tally, const char *name) {
  FILE *file = output_open(name);
  if (file == NULL) return false;
  write_csv(tally, file);
  return output_close(file, name);
}

static void json_text(FILE *file, const char *text) {
  fputc('"', file);
  for (; *text != '\0'; ++text) {
    const unsigned char c = (unsigned char)*text;
    if (c == '"' || c == '\\') fputc('\\', file);
    if (c < 0x20) {
      fprintf(file, "\\u%04x", c);
    } else {
      fputc(c, file);
    }
  }
  fputc('"', file);
}

/* JSON has no infinity: an infinite error is the text "inf", one that was not measured is null. */
static void json_error(FILE *file, const char *key, bool measured, double error) {
  fprintf(file, "\"%s\": ", key);
  if (!measured) {
    fputs("null, ", file);
  } else if (isfinite(error)) {
    fprintf(file, "%.9g, ", error);
  } else {
    fputs("\"inf\", ", file);
  }
}

static void json_row(FILE *file, const struct tally *tally, const struct row *row) {
  const bool measured = row->measured > 0;
  fprintf(file, "    {\"function\": \"%s\", ", row->function->name);
  if (row->group == NULL) {
    fputs("\"group\": null, ", file);
  } else {
    fprintf(file, "\"group\": \"%s\", ", row->group->group);
  }
  fprintf(file, "\"precision\": \"%s\", \"band\": \"%s\", \"cases\": %ld, \"failures\": %ld, ",
          precision_name(row->precision), row->band, row->cases, row->failures);
  json_error(file, "largest_eps", measured, row->largest);
  json_error(file, "mean_eps", measured, row_mean(row));
  json_error(file, "promise_eps", measured, row->promise);
  if (measured) {
    fprintf(file, "\"worst_case\": \"%s\", ", row->worst_case);
  } else {
    fputs("\"worst_case\": null, ", file);
  }
  if (tally->device) {
    fprintf(file, "\"other_bits\": %ld, \"least_instructions\": %lu, \"most_instructions\": %lu, ", row->different,
            row->least, row->most);
  }
  fprintf(file, "\"pass\": %s}", row->failures == 0 ? "true" : "false");
}

static void json_fault(FILE *file, const struct specimen *specimen) {
  static const char *const kinds[] = {"", "wrong status", "outputs written", "written behind the outputs",
                                      "other bits on the device"};
  fputs("    {\"file\": ", file);
  json_text(file, specimen->file);
  fprintf(file, ", \"line\": %ld, \"function\": \"%s\", \"precision\": \"%s\", \"case\": \"%s\", \"fault\": \"%s\", ",
          specimen->record.line, specimen->function->name, precision_name(specimen->precision), specimen->record.name,
          kinds[specimen->fault]);
  fputs("\"expected\": [", file);
  for (int i = 0; i < specimen->record.status_count; ++i) {
    fprintf(file, "%s%d", i == 0 ? "" : ", ", specimen->record.statuses[i]);
  }
  fprintf(file, "], \"got\": %d}", specimen->answer.status);
}

static void write_json(const struct tally *tally, FILE *file) {
  fputs("{\n  \"version\": \"" CHS_VERSION "\",\n  \"compiler\": ", file);
  json_text(file, COMPILER);
  fprintf(file, ",\n  \"target\": \"%s-%s\",\n", ARCHITECTURE, SYSTEM);
  fprintf(file, "  \"files\": %d,\n  \"functions\": %d,\n  \"cases\": %ld,\n  \"failures\": %ld,\n", tally->files,
          functions_seen(tally), tally->cases, tally->failures);
  fputs("  \"rows\": [", file);
  for (int i = 0; i < tally->row_count; ++i) {
    fputs(i == 0 ? "\n" : ",\n", file);
    json_row(file, tally, &tally->rows[i]);
  }
  fprintf(file, "\n  ],\n  \"fault_count\": %ld,\n  \"faults\": [", tally->fault_count);
  for (long i = 0; i < faults_kept(tally); ++i) {
    fputs(i == 0 ? "\n" : ",\n", file);
    json_fault(file, &tally->faults[i]);
  }
  fputs("\n  ]\n}\n", file);
}

bool report_json(const struct tally *tally, const char *name) {
  FILE *file = output_open(name);
  if (file == NULL) return false;
  write_json(tally, file);
  return output_close(file, name);
}
