/* frame.c - see frame.h. */
#include "frame.h"

#include <stddef.h>

enum { CRC_DIGITS = 8, CRC_LENGTH = CRC_DIGITS + 1 }; /* with the asterisk */

/* CRC-32 as in Ethernet and zip, four bits at a time. */
static uint32_t checksum(const char *text, int length) {
  static const uint32_t table[16] = {0x00000000, 0x1db71064, 0x3b6e20c8, 0x26d930ac, 0x76dc4190, 0x6b6b51f4,
                                     0x4db26158, 0x5005713c, 0xedb88320, 0xf00f9344, 0xd6d6a3e8, 0xcb61b38c,
                                     0x9b64c2b0, 0x86d3d2d4, 0xa00ae278, 0xbdbdf21c};
  uint32_t crc = 0xffffffffu;
  for (int i = 0; i < length; ++i) {
    crc ^= (unsigned char)text[i];
    crc = (crc >> 4) ^ table[crc & 15u];
    crc = (crc >> 4) ^ table[crc & 15u];
  }
  return crc ^ 0xffffffffu;
}

static void add_character(struct frame *frame, char c) {
  if (frame->length < FRAME_SPACE) frame->text[frame->length] = c;
  ++frame->length;
}

static void add_digits(struct frame *frame, uint64_t value, int digits) {
  while (digits-- > 0) add_character(frame, "0123456789abcdef"[(value >> (4 * digits)) & 15u]);
}

void frame_begin(struct frame *frame, uint32_t id) {
  frame->length = 0;
  add_character(frame, ':');
  add_digits(frame, id, 8);
}

void frame_add_word(struct frame *frame, const char *word) {
  add_character(frame, ' ');
  while (*word != '\0') add_character(frame, *word++);
}

void frame_add_hex(struct frame *frame, uint64_t value, int digits) {
  add_character(frame, ' ');
  add_digits(frame, value, digits);
}

bool frame_end(struct frame *frame) {
  if (frame->length + CRC_LENGTH + 1 > FRAME_SPACE) return false;
  const uint32_t crc = checksum(frame->text + 1, frame->length - 1);
  add_character(frame, '*');
  add_digits(frame, crc, CRC_DIGITS);
  add_character(frame, '\n');
  return true;
}

void frame_clear(struct frame *frame) { frame->length = -1; }

static bool digit_value(char c, uint64_t *value) {
  if (c >= '0' && c <= '9') {
    *value = (uint64_t)(c - '0');
  } else if (c >= 'a' && c <= 'f') {
    *value = (uint64_t)(c - 'a') + 10u;
  } else {
    return false;
  }
  return true;
}

/* A number of just so many digits, with the end of the text or a blank behind it. */
static bool read_hex(const char *text, int digits, uint64_t *value) {
  *value = 0;
  for (int i = 0; i < digits; ++i) {
    uint64_t digit = 0;
    if (!digit_value(text[i], &digit)) return false;
    *value = (*value << 4) | digit;
  }
  return text[digits] == '\0' || text[digits] == ' ';
}

/* The received line, without its colon and line feed, ends in its own checksum, which is cut off. */
static bool is_whole(struct frame *frame) {
  const int length = frame->length - CRC_LENGTH;
  uint64_t crc = 0;
  if (length < 0 || frame->length >= FRAME_SPACE || frame->text[length] != '*') return false;
  frame->text[frame->length] = '\0';
  if (!read_hex(frame->text + length + 1, CRC_DIGITS, &crc) || crc != checksum(frame->text, length)) return false;
  frame->text[length] = '\0';
  frame->length = length;
  frame->next = 0;
  return true;
}

enum frame_state frame_receive(struct frame *frame, int byte) {
  if (byte == ':') {
    frame->length = 0;
  } else if (frame->length < 0) {
    return FRAME_MORE;
  } else if (byte == '\n') {
    const bool whole = is_whole(frame);
    if (!whole) frame_clear(frame);
    return whole ? FRAME_WHOLE : FRAME_DAMAGED;
  } else if (frame->length < FRAME_SPACE) { /* a longer line stays too long */
    frame->text[frame->length++] = (char)byte;
  }
  return FRAME_MORE;
}

const char *frame_word(struct frame *frame) {
  if (frame->next >= frame->length) return NULL;
  const char *word = frame->text + frame->next;
  while (frame->next < frame->length && frame->text[frame->next] != ' ') ++frame->next;
  frame->text[frame->next++] = '\0';
  return word;
}

bool frame_hex(struct frame *frame, int digits, uint64_t *value) {
  if (frame->length - frame->next < digits || !read_hex(frame->text + frame->next, digits, value)) return false;
  frame->next += digits + 1;
  return true;
}
