/* frame.h - the lines that the host program and a device exchange: text, so that a terminal shows what goes on, numbers
 * as bit patterns in hexadecimal, so that neither side formats or parses a float.
 *
 *   :ID WORD...*CRC
 *
 * ID is the number of the request, which its answer repeats; CRC is the CRC-32 of what stands between : and *; both
 * have eight digits. A colon always starts anew, so that a lost line feed spoils two lines at most, and what comes
 * before a colon is ignored. The host asks, the device answers, each in one line:
 *
 *   hello                                  hello PROTOCOL VERSION WINDOW WORD...
 *   FUNCTION double|float INPUT...         = STATUS MEMORY COUNT OUTPUT...   the call was made
 *                                          unknown                           no such function, or other inputs
 *   (a damaged line)                       damaged
 *
 * VERSION is the library's, WINDOW the bytes that the host may send ahead of the answers (0: one request at a time),
 * and the last words say what the device is. STATUS is the function's answer, 32 bits; MEMORY is `written`, `untouched`
 * (not one byte of the outputs was written) or `beyond` (something was written behind them); COUNT the instructions or
 * cycles of the call, 0 when the device does not count. On a negative status there are no outputs.
 *
 * Freestanding C, for both sides.
 */
#ifndef FRAME_H
#define FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "functions.h"

enum {
  FRAME_PROTOCOL = 1,
  FRAME_WORDS = 128, /* room for all but inputs and outputs */
  FRAME_SPACE = FRAME_WORDS + 17 * ((int)MAX_INPUTS > (int)MAX_OUTPUTS ? (int)MAX_INPUTS : (int)MAX_OUTPUTS)
};

struct frame {
  int length; /* -1 before the first colon */
  int next;   /* first character that no word was taken of yet */
  char text[FRAME_SPACE];
};

/* Writing: what does not fit is cut, and frame_end says so. Afterwards text holds length characters, the last of them
 * the line feed. */
void frame_begin(struct frame *frame, uint32_t id);
void frame_add_word(struct frame *frame, const char *word);
void frame_add_hex(struct frame *frame, uint64_t value, int digits);
bool frame_end(struct frame *frame);

/* Reading: one received byte after the other, until the line is whole or damaged. Starts with frame_clear. */
enum frame_state { FRAME_MORE, FRAME_WHOLE, FRAME_DAMAGED };
void frame_clear(struct frame *frame);
enum frame_state frame_receive(struct frame *frame, int byte);

/* Then its words: the next one, NULL behind the last; and the next one if it is a number of just so many digits. */
const char *frame_word(struct frame *frame);
bool frame_hex(struct frame *frame, int digits, uint64_t *value);

#endif
