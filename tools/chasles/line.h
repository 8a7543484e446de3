/* line.h - bytes to and from a device: a serial port, a TCP port or a program. */
#ifndef LINE_H
#define LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>
#include <time.h>

struct line {
  const char *name; /* as the user wrote it */
  int in, out;
  pid_t child; /* of exec:, otherwise 0 */
};

/* Opens tcp:HOST:PORT, exec:COMMAND (run by sh, on its standard input and output) or /dev/NAME[:BAUD]. False after a
 * message on standard error. */
bool line_open(struct line *line, const char *name);

/* Sends what is pending, as far as the line takes it, until bytes have come in: their number. 0 after so many
 * milliseconds without a byte either way, -1 when the other side has closed the line. */
struct pending {
  const char *bytes;
  size_t count;
};
int line_exchange(struct line *line, struct pending *pending, char *bytes, size_t space, int milliseconds);

/* Closes the line. For a program, waits a moment for its end and then ends it; how it ended goes into `ending`. */
enum { LINE_ENDING = 64 };
void line_close(struct line *line, char ending[LINE_ENDING]);

/* Seconds of a clock that nobody sets. */
time_t seconds_now(void);

#endif
