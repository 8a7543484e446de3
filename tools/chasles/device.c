/* device.c - see device.h. */
#include "device.h"

#include <chasles/chasles.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "frame.h"
#include "line.h"
#include "text.h"

enum {
  SILENCE_MS = 1000,   /* without a byte: the request or its answer is lost */
  MOST_SILENCES = 5,   /* in a row: the device is dead */
  PATIENCE_S = 6,      /* without a whole answer, whatever comes in: no such device is there */
  MOST_TRIES = 50,     /* in a row without a whole answer: the line cannot be used */
  LARGEST_BATCH = 256, /* calls */
  LONGEST_WINDOW = 1 << 20,
  LONGEST_DESCRIPTION = 128
};

struct device {
  struct line line;
  struct frame frame; /* being received */
  uint32_t next_id;   /* numbers go on from a start that differs from run to run */
  uint32_t first_id;  /* of the calls under way */
  int window;         /* bytes sent ahead of the answers */
  char *requests;     /* room for that many, and one more request */
  time_t heard;       /* when the last whole line came */
  bool closed;        /* the other side did */
  struct device_losses losses;
  char description[LONGEST_DESCRIPTION];
};

/* The calls under way: `count` of them from `calls`, numbered from first_id. A hello has no function. */
struct exchange {
  const struct function *function;
  enum precision precision;
  struct device_call *calls;
  int count;
  int unanswered;
  int outstanding; /* requests sent less lines received */
};

static bool give_up(struct device *device, const struct exchange *exchange, const char *reason) {
  complain("the device %s %s (%s)", device->line.name, reason,
           exchange->function == NULL ? "asked for its version" : exchange->function->name);
  return false;
}

static bool wrong_answer(struct device *device, const struct exchange *exchange) {
  return give_up(device, exchange, "gives answers that are not of this protocol");
}

/* "hello PROTOCOL VERSION WINDOW WORD..." */
static bool read_hello(struct device *device, const struct exchange *exchange) {
  uint64_t protocol = 0;
  uint64_t window = 0;
  if (!frame_hex(&device->frame, 2, &protocol)) return wrong_answer(device, exchange);
  const char *version = frame_word(&device->frame);
  if (protocol != FRAME_PROTOCOL || version == NULL || strcmp(version, CHS_VERSION) != 0) {
    complain("the device %s has chasles %s, protocol %d; this program is %s, protocol %d", device->line.name,
             version == NULL ? "?" : version, (int)protocol, CHS_VERSION, (int)FRAME_PROTOCOL);
    return false;
  }
  if (!frame_hex(&device->frame, 8, &window)) return wrong_answer(device, exchange);
  device->window = window < LONGEST_WINDOW ? (int)window : LONGEST_WINDOW;
  const char *word;
  size_t length = 0;
  while ((word = frame_word(&device->frame)) != NULL && length + strlen(word) + 2 < LONGEST_DESCRIPTION) {
    length += (size_t)sprintf(device->description + length, length == 0 ? "%s" : " %s", word);
  }
  return true;
}

/* "= STATUS MEMORY COUNT OUTPUT..." */
static bool read_answer(struct frame *frame, const struct exchange *exchange, struct device_call *call) {
  const int digits = precision_digits(exchange->precision);
  struct answer *answer = &call->answer;
  uint64_t bits = 0;
  if (!frame_hex(frame, 8, &bits)) return false;
  answer->status = (int)(int32_t)(uint32_t)bits;
  const char *memory = frame_word(frame);
  if (memory == NULL) return false;
  answer->untouched = strcmp(memory, "untouched") == 0;
  answer->wrote_past = strcmp(memory, "beyond") == 0;
  if (!answer->untouched && !answer->wrote_past && strcmp(memory, "written") != 0) return false;
  if (!frame_hex(frame, 8, &bits)) return false;
  call->count = (uint32_t)bits;
  for (int i = 0; i < exchange->function->outputs && answer->status >= 0; ++i) {
    if (!frame_hex(frame, digits, &bits)) return false;
    answer->out[i] = precision_number(bits, exchange->precision);
  }
  return frame_word(frame) == NULL;
}

/* A whole line from the device. An answer to an earlier, repeated request is passed over. */
static bool accept(struct device *device, struct exchange *exchange) {
  struct frame *frame = &device->frame;
  uint64_t id = 0;
  device->heard = seconds_now();
  if (!frame_hex(frame, 8, &id)) return wrong_answer(device, exchange);
  const char *word = frame_word(frame);
  if (word == NULL) return wrong_answer(device, exchange);
  if (strcmp(word, "damaged") == 0) {
    ++device->losses.damaged;
    --exchange->outstanding;
    return true;
  }
  const uint32_t place = (uint32_t)id - device->first_id;
  if (place >= (uint32_t)exchange->count || exchange->calls[place].answered) return true;
  struct device_call *call = &exchange->calls[place];
  if (strcmp(word, "unknown") == 0) {
    return give_up(device, exchange, "does not know this function, or takes other inputs: another library is on it");
  }
  const bool good = exchange->function == NULL ? strcmp(word, "hello") == 0 && read_hello(device, exchange)
                                               : strcmp(word, "=") == 0 && read_answer(frame, exchange, call);
  if (!good && exchange->function == NULL) return false;
  if (!good) return wrong_answer(device, exchange);
  call->answered = true;
  --exchange->unanswered;
  --exchange->outstanding;
  return true;
}

static bool take_bytes(struct device *device, struct exchange *exchange, const char *bytes, int count) {
  for (int i = 0; i < count; ++i) {
    switch (frame_receive(&device->frame, (unsigned char)bytes[i])) {
    case FRAME_WHOLE:
      if (!accept(device, exchange)) return false;
      frame_clear(&device->frame);
      break;
    case FRAME_DAMAGED:
      ++device->losses.damaged;
      --exchange->outstanding;
      break;
    case FRAME_MORE: break;
    }
  }
  return true;
}

/* The text of a request; false when it is longer than a frame, which functions.h rules out. */
static bool make_request(struct frame *frame, uint32_t id, const struct exchange *exchange, const double *in) {
  frame_begin(frame, id);
  if (exchange->function == NULL) {
    frame_add_word(frame, "hello");
    return frame_end(frame);
  }
  frame_add_word(frame, exchange->function->name);
  frame_add_word(frame, precision_name(exchange->precision));
  for (int i = 0; i < exchange->function->inputs; ++i) {
    frame_add_hex(frame, precision_bits(in[i], exchange->precision), precision_digits(exchange->precision));
  }
  return frame_end(frame);
}

/* Writes the requests of unanswered calls, as many as the window holds and at least one. */
static struct pending write_requests(struct device *device, struct exchange *exchange) {
  struct pending pending = {device->requests, 0};
  exchange->outstanding = 0;
  for (int i = 0; i < exchange->count; ++i) {
    struct frame request;
    if (exchange->calls[i].answered) continue;
    if (!make_request(&request, device->first_id + (uint32_t)i, exchange, exchange->calls[i].in)) continue;
    const size_t length = (size_t)request.length;
    if (exchange->outstanding > 0 && pending.count + length > (size_t)device->window) break;
    memcpy(device->requests + pending.count, request.text, length);
    pending.count += length;
    ++exchange->outstanding;
  }
  device->losses.repeated += exchange->outstanding;
  return pending;
}

static bool closed(struct device *device, const struct exchange *exchange) {
  char ending[LINE_ENDING];
  line_close(&device->line, ending);
  device->closed = true;
  return give_up(device, exchange, ending);
}

/* Sends what the window holds and takes what comes back, until every request sent has had its answer or nothing that
 * makes sense comes any more. */
static bool try_once(struct device *device, struct exchange *exchange, bool *silent) {
  struct pending pending = write_requests(device, exchange);
  *silent = false;
  while (exchange->outstanding > 0 && exchange->unanswered > 0 && !*silent) {
    char bytes[4096];
    const int count = line_exchange(&device->line, &pending, bytes, sizeof bytes, SILENCE_MS);
    if (count < 0) return closed(device, exchange);
    if (!take_bytes(device, exchange, bytes, count)) return false;
    *silent = count == 0;
    if (seconds_now() - device->heard > PATIENCE_S) break;
  }
  if (*silent) ++device->losses.silences;
  return true;
}

static bool run(struct device *device, struct exchange *exchange) {
  int tries = 0;
  int silences = 0;
  device->first_id = device->next_id;
  device->next_id += (uint32_t)exchange->count;
  device->heard = seconds_now();
  while (exchange->unanswered > 0) {
    const int before = exchange->unanswered;
    bool silent = false;
    if (!try_once(device, exchange, &silent)) return false;
    const bool progress = exchange->unanswered < before;
    tries = progress ? 0 : tries + 1;
    silences = progress || !silent ? 0 : silences + 1;
    if (silences == MOST_SILENCES) return give_up(device, exchange, "does not answer");
    if (seconds_now() - device->heard > PATIENCE_S) return give_up(device, exchange, "sends nothing that makes sense");
    if (tries == MOST_TRIES) return give_up(device, exchange, "cannot be understood: the line is too noisy");
  }
  device->losses.repeated -= exchange->count;
  return true;
}

struct device *device_open(const char *name) {
  struct device *device = calloc(1, sizeof *device);
  if (device != NULL) device->requests = malloc(LONGEST_WINDOW + FRAME_SPACE);
  if (device == NULL || device->requests == NULL) {
    complain("not enough memory for a device");
    free(device);
    return NULL;
  }
  frame_clear(&device->frame);
  device->next_id = (uint32_t)time(NULL) * 2654435761u;
  if (!line_open(&device->line, name)) {
    free(device->requests);
    free(device);
    return NULL;
  }
  struct device_call hello;
  memset(&hello, 0, sizeof hello);
  struct exchange exchange = {NULL, DOUBLE_PRECISION, &hello, 1, 1, 0};
  if (run(device, &exchange)) return device;
  device_close(device);
  return NULL;
}

void device_close(struct device *device) {
  char ending[LINE_ENDING];
  if (device == NULL) return;
  if (!device->closed) line_close(&device->line, ending);
  free(device->requests);
  free(device);
}

const char *device_description(const struct device *device) { return device->description; }

int device_batch(const struct device *device) { return device->window > 0 ? LARGEST_BATCH : 1; }

struct device_losses device_losses(const struct device *device) {
  return device->losses;
}

bool device_evaluate(struct device *device, const struct function *function, enum precision precision,
                     struct device_call *calls, int count) {
  struct exchange exchange = {function, precision, calls, count, count, 0};
  for (int i = 0; i < count; ++i) calls[i].answered = false;
  return run(device, &exchange);
}
