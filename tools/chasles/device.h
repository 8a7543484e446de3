/* device.h - the library as it runs on a device, over a line on which bytes may be lost or damaged. frame.h has the
 * protocol; a request without a whole answer is repeated, and counted.
 */
#ifndef DEVICE_H
#define DEVICE_H

#include <stdbool.h>
#include <stdint.h>

#include "evaluate.h"

struct device;

/* Opens the line that line.h describes and makes sure that a device with this version of the library is there. NULL
 * after a message on standard error. */
struct device *device_open(const char *name);

/* How the device names itself, and the cases worth giving to it at a time. */
const char *device_description(const struct device *device);
int device_batch(const struct device *device);

/* One call, and its answer. */
struct device_call {
  const double *in;
  struct answer answer;
  uint32_t count; /* instructions or cycles, 0 when the device does not count */
  bool answered;
};

/* Makes all the calls. False, after a message, when the device has died or does not know the function. */
bool device_evaluate(struct device *device, const struct function *function, enum precision precision,
                     struct device_call *calls, int count);

/* Requests sent again, and why: no answer came, or request or answer were damaged. */
struct device_losses {
  long repeated, silences, damaged;
};
struct device_losses device_losses(const struct device *device);

void device_close(struct device *device);

#endif
