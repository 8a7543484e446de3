/* text.h - text files: lines read one at a time with a bound on their length, complaints that name file and line, and
 * output whose every byte is known to be written.
 */
#ifndef TEXT_H
#define TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* What the program exits with. */
enum { ALL_WELL = 0, SOMETHING_OVER = 1, UNUSABLE = 2 };

struct text {
  FILE *file;
  const char *name; /* as the user wrote it; the caller keeps it */
  long line;        /* number of the line last read, from 1 */
  char *buffer;     /* that line, without its end: a line feed, a carriage return, or both */
  size_t limit;     /* longest line accepted */
  bool ended;       /* whether that line had an end */
};

enum text_result { TEXT_LINE, TEXT_END, TEXT_ERROR };

/* Opens the file, "-" being standard input. False with a message on standard error when it cannot be read. */
bool text_open(struct text *text, const char *name, size_t longest_line);
enum text_result text_next(struct text *text);
void text_close(struct text *text);

/* "FILE:LINE: expected ..., found ..." on standard error; found NULL is the end of the file. Returns TEXT_ERROR. */
#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
enum text_result
text_expected(const struct text *text, const char *found, const char *expected, ...);

/* A message of the program itself, "chasles: ...", on standard error. */
#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
void complain(const char *message, ...);

/* The next word of a line, cut off with a zero, or NULL; words are parted by spaces and tabs. */
char *next_word(char **line);

/* An integer in [least, most] that is the whole of the text, decimal digits after an optional minus. */
bool parse_integer(const char *text, long least, long most, long *value);

/* The decimal number with the fewest digits that reads back as x. */
void print_shortest(FILE *file, double x);

/* A file for writing; NULL with a message when it cannot be opened. */
FILE *output_open(const char *name);
/* False with a message when not every byte could be written. */
bool output_close(FILE *file, const char *name);

#endif
