/* markers.h - CSV files of marker positions: one row a frame, columns x, y, z for each marker.
 *
 * The first row names the columns: NAME_x, NAME_y, NAME_z, each with the same unit or none behind it, as in Head1_x_m.
 * A first column called time, t, time_s or the like is the time; columns of other names are left alone. An empty cell,
 * NaN or NA is a missing coordinate. Cells may be quoted; the separator is a comma, a semicolon or a tab, whichever
 * the first row has, and numbers have a decimal point.
 */
#ifndef MARKERS_H
#define MARKERS_H

#include <stdbool.h>

#include "text.h"

struct marker {
  char *name;
  int column[3]; /* of x, y, z, from 0; -1 while it is not seen */
  char *unit;    /* "" when the header names none */
};

struct markers {
  struct text text;
  char separator;
  int columns;
  char **cells; /* the cells of the row last read, `columns` of them */
  struct marker *list;
  int count;
  bool has_time;
  char *time_title; /* as in the header */
  long frame;       /* number of the frame last read, from 1 */
};

enum { MOST_CHOSEN = 64 };

/* One frame of the chosen markers. */
struct frame {
  long number;
  long line;
  double time;                    /* NaN when there is none */
  double points[3 * MOST_CHOSEN]; /* NaN where a coordinate is missing */
  bool present[MOST_CHOSEN];
};

/* Opens the file and reads its first row. False after a message; nothing is left to close then. */
bool markers_open(struct markers *markers, const char *name);

/* The marker of that name, or -1. */
int markers_find(const struct markers *markers, const char *name, size_t length);

/* The next frame of the markers chosen: TEXT_LINE; TEXT_END behind the last; TEXT_ERROR after a message. */
enum text_result markers_next(struct markers *markers, const int *chosen, int count, struct frame *frame);

void markers_close(struct markers *markers);

#endif
