/* markers.c - see markers.h. */
#include "markers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "angles.h"

enum { LONGEST_ROW = 1 << 20 };

static bool no_memory(void) {
  complain("not enough memory for the columns of the file");
  return false;
}

/* Removes spaces and tabs from both ends. */
static char *trimmed(char *cell) {
  cell += strspn(cell, " \t");
  size_t length = strlen(cell);
  while (length > 0 && (cell[length - 1] == ' ' || cell[length - 1] == '\t')) --length;
  cell[length] = '\0';
  return cell;
}

/* Takes the quotes off a quoted cell in place, "" standing for one quote. *end is set behind it; NULL when the
 * closing quote is missing. */
static char *unquoted(char *cell, char **end) {
  char *from = cell + 1;
  char *to = cell;
  for (;;) {
    if (*from == '\0') return NULL;
    if (*from == '"' && from[1] != '"') break;
    if (*from == '"') ++from;
    *to++ = *from++;
  }
  *end = from + 1;
  *to = '\0';
  return cell;
}

/* Cuts the next cell off a row; *row becomes NULL with the last one. NULL with a message when quotes are unbalanced. */
static char *next_cell(const struct markers *markers, char **row) {
  const char *blanks = markers->separator == '\t' ? " " : " \t";
  char *cell = *row + strspn(*row, blanks);
  char *end = cell;
  char *content = cell;
  if (*cell == '"') {
    content = unquoted(cell, &end);
    if (content != NULL) end += strspn(end, blanks);
    if (content == NULL || (*end != '\0' && *end != markers->separator)) {
      text_expected(&markers->text, content == NULL ? "" : end, "a closing quote at the end of a cell");
      return NULL;
    }
  } else {
    while (*end != '\0' && *end != markers->separator) ++end;
  }
  *row = *end == '\0' ? NULL : end + 1;
  *end = '\0'; /* behind the content: unquoted ended that earlier */
  return trimmed(content);
}

/* Cuts the row in the buffer into cells and counts them; `columns` of them are kept. -1 after a message. */
static int split_row(struct markers *markers) {
  char *row = markers->text.buffer;
  int count = 0;
  while (row != NULL) {
    char *cell = next_cell(markers, &row);
    if (cell == NULL) return -1;
    if (count < markers->columns) markers->cells[count] = cell;
    ++count;
  }
  return count;
}

static bool is_blank(const char *row) { return row[strspn(row, " \t")] == '\0'; }

/* The next row that is not blank. */
static enum text_result next_row(struct markers *markers) {
  enum text_result result;
  do {
    result = text_next(&markers->text);
  } while (result == TEXT_LINE && is_blank(markers->text.buffer));
  return result;
}

static char find_separator(const char *row) {
  if (strchr(row, ',') != NULL) return ',';
  if (strchr(row, ';') != NULL) return ';';
  return strchr(row, '\t') != NULL ? '\t' : ',';
}

/* Parts Head1_x_m into name "Head1", axis 0 and unit "m": the last _x, _y or _z that ends the title or is followed
 * by _unit. The title is cut. */
static bool parse_title(char *title, int *axis, char **unit) {
  static const char axes[] = "xyz";
  char *tail = NULL;
  for (char *c = title; *c != '\0'; ++c) {
    if (*c != '_' || c == title || c[1] == '\0' || (c[2] != '\0' && c[2] != '_')) continue;
    const char *found = strchr(axes, c[1] == 'X' ? 'x' : c[1] == 'Y' ? 'y' : c[1] == 'Z' ? 'z' : c[1]);
    if (found == NULL) continue;
    tail = c;
    *axis = (int)(found - axes);
  }
  if (tail == NULL) return false;
  *unit = tail[2] == '_' ? tail + 3 : tail + 2;
  *tail = '\0';
  return true;
}

static bool is_time(const char *title) {
  const size_t length = strcspn(title, "_ ([");
  return (length == 4 && strncasecmp(title, "time", 4) == 0) || (length == 1 && (*title == 't' || *title == 'T'));
}

int markers_find(const struct markers *markers, const char *name, size_t length) {
  for (int i = 0; i < markers->count; ++i) {
    if (strlen(markers->list[i].name) == length && strncmp(markers->list[i].name, name, length) == 0) return i;
  }
  return -1;
}

static struct marker *new_marker(struct markers *markers, const char *name, const char *unit) {
  struct marker *marker = &markers->list[markers->count];
  marker->name = strdup(name);
  marker->unit = strdup(unit);
  for (int i = 0; i < 3; ++i) marker->column[i] = -1;
  ++markers->count;
  if (marker->name != NULL && marker->unit != NULL) return marker;
  no_memory();
  return NULL;
}

static bool add_coordinate(struct markers *markers, const char *name, int axis, const char *unit, int column) {
  const int known = markers_find(markers, name, strlen(name));
  struct marker *marker = known >= 0 ? &markers->list[known] : new_marker(markers, name, unit);
  if (marker == NULL) return false;
  if (marker->column[axis] >= 0) {
    text_expected(&markers->text, name, "one column %c for each marker", "xyz"[axis]);
    return false;
  }
  if (strcmp(marker->unit, unit) != 0) {
    text_expected(&markers->text, unit, "the unit '%s' in all columns of marker %s", marker->unit, name);
    return false;
  }
  marker->column[axis] = column;
  return true;
}

static bool read_titles(struct markers *markers) {
  for (int i = 0; i < markers->columns; ++i) {
    int axis = 0;
    char *unit = NULL;
    char *title = markers->cells[i];
    if (i == 0 && is_time(title)) {
      markers->has_time = true;
      markers->time_title = strdup(title);
      if (markers->time_title == NULL) return no_memory();
    } else if (parse_title(title, &axis, &unit) && !add_coordinate(markers, title, axis, unit, i)) {
      return false;
    }
  }
  for (int i = 0; i < markers->count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      if (markers->list[i].column[axis] >= 0) continue;
      text_expected(&markers->text, "", "a column %c of marker %s", "xyz"[axis], markers -> list[i].name);
      return false;
    }
  }
  return true;
}

/* Spreadsheets put a byte-order mark before the first cell: it becomes spaces. */
static void blank_mark(char *row) {
  if (strncmp(row, "\xef\xbb\xbf", 3) == 0) memset(row, ' ', 3);
}

static bool read_first_row(struct markers *markers) {
  const enum text_result result = next_row(markers);
  if (result == TEXT_END) text_expected(&markers->text, NULL, "a row of column names");
  if (result != TEXT_LINE) return false;
  blank_mark(markers->text.buffer);
  markers->separator = find_separator(markers->text.buffer);
  markers->columns = 1;
  for (const char *c = markers->text.buffer; *c != '\0'; ++c) markers->columns += *c == markers->separator;
  markers->cells = calloc((size_t)markers->columns, sizeof *markers->cells);
  markers->list = calloc((size_t)markers->columns, sizeof *markers->list);
  if (markers->cells == NULL || markers->list == NULL) return no_memory();
  markers->columns = split_row(markers); /* fewer when quoted cells hold separators */
  return markers->columns > 0 && read_titles(markers);
}

bool markers_open(struct markers *markers, const char *name) {
  memset(markers, 0, sizeof *markers);
  if (!text_open(&markers->text, name, LONGEST_ROW)) return false;
  if (read_first_row(markers)) return true;
  markers_close(markers);
  return false;
}

void markers_close(struct markers *markers) {
  for (int i = 0; i < markers->count; ++i) {
    free(markers->list[i].name);
    free(markers->list[i].unit);
  }
  free(markers->list);
  free(markers->cells);
  free(markers->time_title);
  text_close(&markers->text);
}

static bool is_missing(const char *cell) {
  return *cell == '\0' || strcasecmp(cell, "nan") == 0 || strcasecmp(cell, "-nan") == 0 || strcasecmp(cell, "na") == 0;
}

/* A decimal number; a missing one is NaN. */
static bool read_cell(const struct markers *markers, int column, const char *meaning, double *value) {
  const char *cell = markers->cells[column];
  *value = (double)NAN;
  if (is_missing(cell) || read_number(cell, value)) return true;
  text_expected(&markers->text, cell, "%s in column %d: a number with a decimal point", meaning, column + 1);
  return false;
}

enum text_result markers_next(struct markers *markers, const int *chosen, int count, struct frame *frame) {
  const enum text_result result = next_row(markers);
  if (result != TEXT_LINE) return result;
  const int cells = split_row(markers);
  if (cells < 0) return TEXT_ERROR;
  if (cells != markers->columns) {
    const char *separator = markers->separator == ',' ? "commas" : markers->separator == ';' ? "semicolons" : "tabs";
    fprintf(stderr, "%s:%ld: expected %d cells parted by %s, found %d\n", markers->text.name, markers->text.line,
            markers->columns, separator, cells);
    return TEXT_ERROR;
  }
  frame->number = ++markers->frame;
  frame->line = markers->text.line;
  frame->time = (double)NAN;
  if (markers->has_time && !read_cell(markers, 0, "the time", &frame->time)) return TEXT_ERROR;
  for (int k = 0; k < count; ++k) {
    const struct marker *marker = &markers->list[chosen[k]];
    frame->present[k] = true;
    for (int axis = 0; axis < 3; ++axis) {
      double *x = &frame->points[3 * k + axis];
      if (!read_cell(markers, marker->column[axis], "a position", x)) return TEXT_ERROR;
      if (isnan(*x)) frame->present[k] = false;
    }
  }
  return TEXT_LINE;
}
