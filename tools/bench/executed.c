/* executed.c - calls every function of the library for every case of its reference vectors, and has callgrind write
 * down after each what was executed: once for the ordinary band, once for all bands. executed.py runs it.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <valgrind/callgrind.h>

#include "evaluate.h"
#include "vectors.h"

struct inputs {
  double *values;
  float *singles;
  long cases;
};

/* The inputs of a file's cases, of that band or, NULL, of all; none where there is no such file. */
static void read_inputs(const char *name, const char *band, struct inputs *inputs) {
  struct vectors vectors;
  struct vector_case record;
  inputs->values = NULL;
  inputs->singles = NULL;
  inputs->cases = 0;
  FILE *file = fopen(name, "r");
  if (file == NULL) return;
  fclose(file);
  if (!vectors_open(&vectors, name)) exit(2);
  const size_t size = (size_t)vectors.function->inputs;
  for (;;) {
    const enum text_result result = vectors_next(&vectors, &record);
    if (result == TEXT_END) break;
    if (result == TEXT_ERROR) exit(2);
    if (band != NULL && strcmp(record.band, band) != 0) continue;
    const size_t filled = (size_t)inputs->cases++ * size;
    inputs->values = realloc(inputs->values, (filled + size) * sizeof *inputs->values);
    inputs->singles = realloc(inputs->singles, (filled + size) * sizeof *inputs->singles);
    if (inputs->values == NULL || inputs->singles == NULL) exit(2);
    for (size_t i = 0; i < size; ++i) {
      inputs->values[filled + i] = record.in[i];
      inputs->singles[filled + i] = (float)record.in[i];
    }
  }
  vectors_close(&vectors);
}

static void call(const struct function *function, enum precision precision, const struct inputs *inputs) {
  double out[MAX_OUTPUTS] = {0.0};
  float outf[MAX_OUTPUTS] = {0.0F};
  for (long i = 0; i < inputs->cases; ++i) {
    if (precision == DOUBLE_PRECISION) {
      function->call(inputs->values + i * function->inputs, out);
    } else {
      function->callf(inputs->singles + i * function->inputs, outf);
    }
  }
}

int main(int argc, char **argv) {
  static const char *const bands[] = {"ordinary", NULL};
  for (int i = 0; argc == 2 && i < 2 * 2 * function_count; ++i) {
    const struct function *function = &functions[i / 4];
    const enum precision precision = (enum precision)(i / 2 % 2);
    const char *band = bands[i % 2];
    char name[1024];
    char title[256];
    struct inputs inputs;
    snprintf(name, sizeof name, "%s/%s.%s.txt", argv[1], function->name, precision == DOUBLE_PRECISION ? "f64" : "f32");
    read_inputs(name, band, &inputs);
    snprintf(title, sizeof title, "%s %s %s %ld", function->name, precision_name(precision),
             band == NULL ? "all" : band, inputs.cases);
    CALLGRIND_START_INSTRUMENTATION;
    call(function, precision, &inputs);
    CALLGRIND_STOP_INSTRUMENTATION;
    CALLGRIND_DUMP_STATS_AT(title);
    free(inputs.values);
    free(inputs.singles);
  }
  return argc == 2 ? 0 : 2;
}
