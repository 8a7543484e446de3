/* text.c - see text.h. */
#include "text.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { SHOWN_OF_FOUND = 40 }; /* characters of a bad text that a message repeats */

void complain(const char *message, ...) {
  va_list arguments;
  va_start(arguments, message);
  fputs("chasles: ", stderr);
  vfprintf(stderr, message, arguments);
  fputc('\n', stderr);
  va_end(arguments);
}

bool text_open(struct text *text, const char *name, size_t longest_line) {
  const bool is_stdin = strcmp(name, "-") == 0;
  text->name = is_stdin ? "standard input" : name;
  text->line = 0;
  text->limit = longest_line;
  text->ended = true;
  text->file = is_stdin ? stdin : fopen(name, "r");
  if (text->file == NULL) {
    complain("cannot read %s: %s", name, strerror(errno));
    return false;
  }
  text->buffer = malloc(longest_line + 1);
  if (text->buffer == NULL) {
    complain("not enough memory for a line of %zu characters", longest_line);
    if (!is_stdin) fclose(text->file);
    return false;
  }
  return true;
}

void text_close(struct text *text) {
  free(text->buffer);
  if (text->file != stdin) fclose(text->file);
}

/* The text found, in quotes, cut when long, and with nothing in it that could disturb a terminal. */
static void print_found(const char *found) {
  if (found == NULL) {
    fputs("the end of the file", stderr);
    return;
  }
  if (*found == '\0') {
    fputs("nothing", stderr);
    return;
  }
  fputc('\'', stderr);
  int shown = 0;
  for (; *found != '\0' && shown < SHOWN_OF_FOUND; ++found, ++shown) {
    const unsigned char c = (unsigned char)*found;
    if (c >= 0x20 && c < 0x7f) {
      fputc(c, stderr);
    } else {
      fprintf(stderr, "\\x%02x", c);
    }
  }
  fputs(*found == '\0' ? "'" : "...'", stderr);
}

enum text_result text_expected(const struct text *text, const char *found, const char *expected, ...) {
  va_list arguments;
  va_start(arguments, expected);
  fprintf(stderr, "%s:%ld: expected ", text->name, text->line);
  vfprintf(stderr, expected, arguments);
  fputs(", found ", stderr);
  print_found(found);
  fputc('\n', stderr);
  va_end(arguments);
  return TEXT_ERROR;
}

/* A line ends with a line feed, a carriage return, or both. */
static bool is_end(int c) { return c == '\n' || c == '\r'; }

enum text_result text_next(struct text *text) {
  size_t length = 0;
  int c = getc(text->file);
  if (c != EOF || text->line == 0) ++text->line; /* an empty file ends in its first line */
  while (c != EOF && !is_end(c)) {
    if (c == '\0') {
      fprintf(stderr, "%s:%ld: expected text, found a zero byte\n", text->name, text->line);
      return TEXT_ERROR;
    }
    if (length == text->limit) {
      fprintf(stderr, "%s:%ld: expected a line of at most %zu characters, found a longer one\n", text->name, text->line,
              text->limit);
      return TEXT_ERROR;
    }
    text->buffer[length++] = (char)c;
    c = getc(text->file);
  }
  const int next = c == '\r' ? getc(text->file) : '\n';
  if (next != '\n' && next != EOF) ungetc(next, text->file);
  if (ferror(text->file)) {
    complain("cannot read %s: %s", text->name, strerror(errno));
    return TEXT_ERROR;
  }
  if (c == EOF && length == 0) return TEXT_END;
  text->ended = is_end(c);
  text->buffer[length] = '\0';
  return TEXT_LINE;
}

char *next_word(char **line) {
  char *word = *line + strspn(*line, " \t");
  if (*word == '\0') return NULL;
  char *end = word + strcspn(word, " \t");
  *line = *end == '\0' ? end : end + 1;
  *end = '\0';
  return word;
}

bool parse_integer(const char *text, long least, long most, long *value) {
  const char *digits = *text == '-' ? text + 1 : text;
  if (*digits == '\0' || digits[strspn(digits, "0123456789")] != '\0') return false;
  errno = 0;
  *value = strtol(text, NULL, 10);
  return errno == 0 && *value >= least && *value <= most;
}

void print_shortest(FILE *file, double x) {
  char number[32];
  for (int digits = 15; digits <= 17; ++digits) {
    snprintf(number, sizeof number, "%.*g", digits, x);
    if (strtod(number, NULL) == x) break;
  }
  fputs(number, file);
}

FILE *output_open(const char *name) {
  FILE *file = fopen(name, "w");
  if (file == NULL) complain("cannot write %s: %s", name, strerror(errno));
  return file;
}

bool output_close(FILE *file, const char *name) {
  errno = 0;
  bool written = !ferror(file);
  if (fflush(file) != 0) written = false;
  const int reason = errno;
  if (file != stdout && fclose(file) != 0) written = false;
  if (!written) complain("cannot write %s: %s", name, reason != 0 ? strerror(reason) : "not all of it was accepted");
  return written;
}
