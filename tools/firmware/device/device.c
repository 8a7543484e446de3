/* device.c - the program on the board: calls the library's functions as the host asks. frame.h has the protocol.
 *
 * The registry is the host program's own, so that every function of the library is served.
 */
#include <chasles/chasles.h>
#include <stddef.h>

#include "evaluate.h"
#include "frame.h"
#include "functions.h"
#include "port.h"

#if defined(__clang__)
#define COMPILER "clang"
#elif defined(__GNUC__)
#define COMPILER "gcc"
#else
#define COMPILER "compiler"
#endif

#ifndef DEVICE_NAME
#define DEVICE_NAME "device"
#endif

#define OPTIONAL __attribute__((weak))
OPTIONAL unsigned port_window(void) { return 0; }
OPTIONAL void port_count_start(void) {}
OPTIONAL uint32_t port_count_stop(void) { return 0; }

/* The count of a call that does nothing, to be taken off; 0 where nothing is counted. */
static uint32_t empty_count;

static int empty_call(const double *in, double *out) {
  (void)in;
  (void)out;
  return 0;
}

static uint32_t count_call(const struct function *function, enum precision precision, const double *in) {
  static double out[MAX_OUTPUTS];
  static float outf[MAX_OUTPUTS];
  static float inf[MAX_INPUTS];
  if (precision == DOUBLE_PRECISION) {
    port_count_start();
    function->call(in, out);
    return port_count_stop();
  }
  for (int i = 0; i < function->inputs; ++i) inf[i] = (float)in[i];
  port_count_start();
  function->callf(inf, outf);
  return port_count_stop();
}

/* A call of its own, so that nothing but the function is counted. */
static uint32_t net_count(const struct function *function, enum precision precision, const double *in) {
  const uint32_t count = empty_count == 0 ? 0 : count_call(function, precision, in);
  return count > empty_count ? count - empty_count : 0;
}

static void calibrate(void) {
  static const struct function empty = {"", "", 0, 0, empty_call, NULL, {{NULL, 0, 0}}};
  static const double nothing[1];
  empty_count = count_call(&empty, DOUBLE_PRECISION, nothing);
}

static void send(struct frame *answer) {
  if (!frame_end(answer)) return;
  for (int i = 0; i < answer->length; ++i) port_write(answer->text[i]);
}

static void say(uint32_t id, const char *word) {
  static struct frame answer;
  frame_begin(&answer, id);
  frame_add_word(&answer, word);
  send(&answer);
}

static void say_hello(uint32_t id) {
  static struct frame answer;
  frame_begin(&answer, id);
  frame_add_word(&answer, "hello");
  frame_add_hex(&answer, FRAME_PROTOCOL, 2);
  frame_add_word(&answer, CHS_VERSION);
  frame_add_hex(&answer, port_window(), 8);
  frame_add_word(&answer, DEVICE_NAME);
  frame_add_word(&answer, COMPILER);
#ifdef __VERSION__
  frame_add_word(&answer, __VERSION__);
#endif
  send(&answer);
}

static const char *memory_word(const struct answer *answer) {
  if (answer->wrote_past) return "beyond";
  return answer->untouched ? "untouched" : "written";
}

static void call(uint32_t id, const struct function *function, enum precision precision, const double *in) {
  static struct frame frame;
  static struct answer answer;
  evaluate(function, precision, in, &answer);
  frame_begin(&frame, id);
  frame_add_word(&frame, "=");
  frame_add_hex(&frame, (uint32_t)answer.status, 8);
  frame_add_word(&frame, memory_word(&answer));
  frame_add_hex(&frame, net_count(function, precision, in), 8);
  for (int i = 0; i < function->outputs && answer.status >= 0; ++i) {
    frame_add_hex(&frame, precision_bits(answer.out[i], precision), precision_digits(precision));
  }
  send(&frame);
}

/* Reads a request's function, precision and inputs; false when this device does not know them. */
static bool read_request(struct frame *request, const char *name, const struct function **function,
                         enum precision *precision, double *in) {
  *function = find_function(name);
  const char *word = frame_word(request);
  if (*function == NULL || word == NULL) return false;
  *precision = same_text(word, precision_name(DOUBLE_PRECISION)) ? DOUBLE_PRECISION : FLOAT_PRECISION;
  if (!same_text(word, precision_name(*precision))) return false;
  for (int i = 0; i < (*function)->inputs; ++i) {
    uint64_t bits = 0;
    if (!frame_hex(request, precision_digits(*precision), &bits)) return false;
    in[i] = precision_number(bits, *precision);
  }
  return frame_word(request) == NULL;
}

static void serve(struct frame *request) {
  static double in[MAX_INPUTS];
  const struct function *function = NULL;
  enum precision precision = DOUBLE_PRECISION;
  uint64_t id = 0;
  const char *name = frame_hex(request, 8, &id) ? frame_word(request) : NULL;
  if (name == NULL) {
    say((uint32_t)id, "unknown");
  } else if (same_text(name, "hello")) {
    say_hello((uint32_t)id);
  } else if (read_request(request, name, &function, &precision, in)) {
    call((uint32_t)id, function, precision, in);
  } else {
    say((uint32_t)id, "unknown");
  }
}

int main(void) {
  static struct frame request;
  calibrate();
  frame_clear(&request);
  for (;;) {
    switch (frame_receive(&request, port_read())) {
    case FRAME_WHOLE:
      serve(&request);
      frame_clear(&request);
      break;
    case FRAME_DAMAGED: say(0, "damaged"); break;
    case FRAME_MORE: break;
    }
  }
}
