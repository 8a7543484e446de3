/* vectors.c - see vectors.h. */
#include "vectors.h"

#include <chasles/chasles.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_LINE = 16384 };

/* A line that carries something: not blank, not a comment. A file cut short can end in the middle of a number, so every
 * line must have its line feed. */
static enum text_result next_line(struct text *text, char **line) {
  for (;;) {
    const enum text_result result = text_next(text);
    if (result != TEXT_LINE) return result;
    if (!text->ended) return text_expected(text, NULL, "a line feed after the last line");
    *line = text->buffer + strspn(text->buffer, " \t");
    if (**line != '\0' && **line != '#') return TEXT_LINE;
  }
}

/* The next line, which must start with that keyword; *rest is what follows it. */
static enum text_result keyword_line(struct text *text, const char *keyword, char **rest) {
  char *line = NULL;
  const enum text_result result = next_line(text, &line);
  if (result == TEXT_ERROR) return TEXT_ERROR;
  const char *word = result == TEXT_END ? NULL : next_word(&line);
  if (word == NULL || strcmp(word, keyword) != 0) return text_expected(text, word, "'%s'", keyword);
  *rest = line;
  return TEXT_LINE;
}

static bool line_ends(const struct text *text, char **rest) {
  const char *word = next_word(rest);
  if (word != NULL) text_expected(text, word, "the end of the line");
  return word == NULL;
}

/* "keyword word" */
static bool header_word(struct text *text, const char *keyword, const char *meaning, const char **word) {
  char *rest = NULL;
  if (keyword_line(text, keyword, &rest) != TEXT_LINE) return false;
  *word = next_word(&rest);
  if (*word == NULL) {
    text_expected(text, "", "%s", meaning);
    return false;
  }
  return line_ends(text, &rest);
}

/* "keyword value", value being an integer known beforehand */
static bool header_count(struct text *text, const char *keyword, int value) {
  const char *word = NULL;
  char meaning[32];
  long found = 0;
  snprintf(meaning, sizeof meaning, "%d", value);
  if (!header_word(text, keyword, meaning, &word)) return false;
  if (parse_integer(word, value, value, &found)) return true;
  text_expected(text, word, "%s %s", keyword, meaning);
  return false;
}

static bool read_precision(struct vectors *vectors) {
  const char *word = NULL;
  if (!header_word(&vectors->text, "precision", "'double' or 'float'", &word)) return false;
  for (int i = 0; i < PRECISIONS; ++i) {
    vectors->precision = (enum precision)i;
    if (strcmp(word, precision_name(vectors->precision)) == 0) return true;
  }
  text_expected(&vectors->text, word, "'double' or 'float'");
  return false;
}

/* Names go into tables, JSON and CSV as they are: letters, digits and a few signs only. */
static bool is_name(const char *word) {
  static const char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+.";
  const size_t length = strlen(word);
  return length > 0 && length <= MAX_NAME && strspn(word, letters) == length;
}

/* "group NAME max|norm INDEX..." */
static bool read_group(struct vectors *vectors, char *rest, bool *taken) {
  const struct text *text = &vectors->text;
  if (vectors->group_count == MAX_PROMISES) {
    text_expected(text, "group", "at most %d groups", (int)MAX_PROMISES);
    return false;
  }
  struct group *group = &vectors->groups[vectors->group_count++];
  const char *word = next_word(&rest);
  group->promise = word == NULL ? NULL : find_promise(vectors->function, word);
  if (group->promise == NULL) {
    text_expected(text, word == NULL ? "" : word, "a group that %s has a promise for", vectors->function->name);
    return false;
  }
  word = next_word(&rest);
  if (word == NULL || (strcmp(word, "max") != 0 && strcmp(word, "norm") != 0)) {
    text_expected(text, word == NULL ? "" : word, "'max' or 'norm'");
    return false;
  }
  group->norm = strcmp(word, "norm") == 0;
  group->count = 0;
  while ((word = next_word(&rest)) != NULL) {
    long index = 0;
    if (!parse_integer(word, 0, vectors->function->outputs - 1, &index) || taken[index]) {
      text_expected(text, word, "an output from 0 to %d that no group has yet", vectors->function->outputs - 1);
      return false;
    }
    taken[index] = true;
    group->index[group->count++] = (int)index;
  }
  if (group->count == 0) text_expected(text, "", "the numbers of the group's outputs");
  return group->count > 0;
}

/* The group lines. They are over when every output belongs to one. */
static bool read_groups(struct vectors *vectors) {
  bool taken[MAX_OUTPUTS] = {false};
  vectors->group_count = 0;
  for (int covered = 0; covered < vectors->function->outputs;) {
    char *rest = NULL;
    if (keyword_line(&vectors->text, "group", &rest) != TEXT_LINE) return false;
    if (!read_group(vectors, rest, taken)) return false;
    covered += vectors->groups[vectors->group_count - 1].count;
  }
  return true;
}

static bool read_header(struct vectors *vectors) {
  struct text *text = &vectors->text;
  const char *word = NULL;
  if (!header_count(text, "chasles-vectors", 1)) return false;
  if (!header_word(text, "function", "the name of a function", &word)) return false;
  vectors->function = find_function(word);
  if (vectors->function == NULL) {
    text_expected(text, word, "a function of chasles " CHS_VERSION);
    return false;
  }
  return read_precision(vectors) && header_count(text, "inputs", vectors->function->inputs) &&
         header_count(text, "outputs", vectors->function->outputs) && read_groups(vectors);
}

bool vectors_open(struct vectors *vectors, const char *name) {
  if (!text_open(&vectors->text, name, LONGEST_LINE)) return false;
  if (read_header(vectors)) return true;
  text_close(&vectors->text);
  return false;
}

void vectors_close(struct vectors *vectors) { text_close(&vectors->text); }

/* One number of the format. strtod reads more than that (decimal, "infinity"), so the shape is looked at first. A
 * subnormal result is in range although strtod reports it. */
static bool parse_number(const char *word, double *value) {
  const char *digits = *word == '-' ? word + 1 : word;
  const bool special = strcmp(digits, "0") == 0 || strcmp(digits, "nan") == 0 || strcmp(digits, "inf") == 0;
  if (!special && strncmp(digits, "0x", 2) != 0) return false;
  char *end = NULL;
  errno = 0;
  *value = strtod(word, &end);
  return *end == '\0' && !(errno == ERANGE && isinf(*value));
}

static bool read_number(const struct text *text, char **rest, const char *meaning, double *value) {
  const char *word = next_word(rest);
  if (word != NULL && parse_number(word, value)) return true;
  text_expected(text, word == NULL ? "" : word, "%s: a hexadecimal float, 0, -0, nan, inf or -inf", meaning);
  return false;
}

/* A finite number of at least that size. */
static bool read_finite(const struct text *text, char **rest, const char *meaning, double least, double *value) {
  if (!read_number(text, rest, meaning, value)) return false;
  if (isfinite(*value) && *value >= least) return true;
  fprintf(stderr, "%s:%ld: expected %s: a finite number%s, found %a\n", text->name, text->line, meaning,
          least == 0.0 ? " of at least 0" : "", *value);
  return false;
}

/* A number that the precision of the file can hold. */
static bool read_exact(const struct vectors *vectors, char **rest, const char *what, int index, double *value) {
  char meaning[32];
  snprintf(meaning, sizeof meaning, "%s %d", what, index);
  if (!read_number(&vectors->text, rest, meaning, value)) return false;
  if (fits_precision(*value, vectors->precision)) return true;
  fprintf(stderr, "%s:%ld: expected %s: a number that a %s holds, found %a\n", vectors->text.name, vectors->text.line,
          meaning, precision_name(vectors->precision), *value);
  return false;
}

/* "0", "-7", "0|1" */
static bool read_statuses(const struct text *text, char *word, struct vector_case *record) {
  record->status_count = 0;
  record->has_values = false;
  char *next = word;
  while (next != NULL) {
    char *status_text = next;
    next = strchr(status_text, '|');
    if (next != NULL) *next++ = '\0';
    long status = 0;
    if (record->status_count == MAX_STATUSES || !parse_integer(status_text, -99, 99, &status)) {
      text_expected(text, status_text, "a status, or up to %d parted by |", (int)MAX_STATUSES);
      return false;
    }
    record->statuses[record->status_count++] = (int)status;
    if (status >= 0) record->has_values = true;
  }
  return true;
}

/* "case NAME BAND STATUS" */
static bool read_case_line(const struct text *text, char *rest, struct vector_case *record) {
  const char *name = next_word(&rest);
  if (name == NULL || !is_name(name)) {
    text_expected(text, name == NULL ? "" : name, "a case's name of at most %d letters and digits", (int)MAX_NAME);
    return false;
  }
  const char *band = next_word(&rest);
  if (band == NULL || !is_name(band)) {
    text_expected(text, band == NULL ? "" : band, "a band's name of at most %d letters and digits", (int)MAX_NAME);
    return false;
  }
  char *statuses = next_word(&rest);
  if (statuses == NULL) {
    text_expected(text, "", "the status of case %s", name);
    return false;
  }
  strcpy(record->name, name);
  strcpy(record->band, band);
  record->line = text->line;
  return line_ends(text, &rest) && read_statuses(text, statuses, record);
}

static bool read_in(struct vectors *vectors, struct vector_case *record) {
  char *rest = NULL;
  if (keyword_line(&vectors->text, "in", &rest) != TEXT_LINE) return false;
  for (int i = 0; i < vectors->function->inputs; ++i) {
    if (!read_exact(vectors, &rest, "input", i, &record->in[i])) return false;
  }
  return line_ends(&vectors->text, &rest);
}

static bool read_out(struct vectors *vectors, struct vector_case *record) {
  char *rest = NULL;
  if (keyword_line(&vectors->text, "out", &rest) != TEXT_LINE) return false;
  for (int i = 0; i < vectors->function->outputs; ++i) {
    if (!read_exact(vectors, &rest, "output", i, &record->high[i])) return false;
    if (!read_finite(&vectors->text, &rest, "the rest of an output", -HUGE_VAL, &record->low[i])) return false;
  }
  return line_ends(&vectors->text, &rest);
}

static bool read_scale(struct vectors *vectors, struct vector_case *record) {
  const struct text *text = &vectors->text;
  char *rest = NULL;
  if (keyword_line(&vectors->text, "scale", &rest) != TEXT_LINE) return false;
  for (int i = 0; i < vectors->group_count; ++i) {
    if (!read_finite(text, &rest, "a group's scale", 0.0, &record->scale[i])) return false;
  }
  return line_ends(text, &rest);
}

enum text_result vectors_next(struct vectors *vectors, struct vector_case *record) {
  char *line = NULL;
  const enum text_result result = next_line(&vectors->text, &line);
  if (result != TEXT_LINE) return result;
  const char *word = next_word(&line);
  if (strcmp(word, "case") != 0) return text_expected(&vectors->text, word, "'case'");
  if (!read_case_line(&vectors->text, line, record) || !read_in(vectors, record)) return TEXT_ERROR;
  if (vectors->function->outputs == 0) record->has_values = false;
  if (record->has_values && (!read_out(vectors, record) || !read_scale(vectors, record))) return TEXT_ERROR;
  return TEXT_LINE;
}
