/* port_semihosting.c - the line to the host through files of the host: a million cases a minute under an emulator. */
#include <stdbool.h>

#include "port.h"
#include "semihosting.h"

enum { BUFFER = 2048, WINDOW = 65536 }; /* the window is what a pipe of the host holds */

static struct {
  bool opened;
  int file;
  int count, next;
  unsigned char bytes[BUFFER];
} input, output;

unsigned port_window(void) { return WINDOW; }

static void flush(void) {
  if (!output.opened) output.file = semihosting_open("/dev/stdout", SEMIHOSTING_APPEND);
  output.opened = true;
  if (output.count > 0) semihosting_write(output.file, output.bytes, output.count);
  output.count = 0;
}

/* Answers go out before the program waits for more. The end of the requests ends the program. */
int port_read(void) {
  if (input.next == input.count) {
    flush();
    if (!input.opened) input.file = semihosting_open("/dev/stdin", SEMIHOSTING_READ);
    input.opened = true;
    input.next = 0;
    input.count = semihosting_read(input.file, input.bytes, BUFFER);
    if (input.count <= 0) semihosting_exit(0);
  }
  return input.bytes[input.next++];
}

void port_write(int byte) {
  if (output.count == BUFFER) flush();
  output.bytes[output.count++] = (unsigned char)byte;
}
