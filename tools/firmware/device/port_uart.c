/* port_uart.c - the line to the host through the serial port of the emulated boards: the file that the owner of another
 * board writes anew.
 */
#include "port.h"

#if defined(__arm__)

/* Arm's CMSDK UART. */
struct uart {
  volatile uint32_t data, state, control, interrupt, divider;
};
enum { TRANSMITTER_FULL = 1, RECEIVER_FULL = 2, BOTH_ENABLED = 3, LEAST_DIVIDER = 16 };

static struct uart *const uart = (struct uart *)UART_ADDRESS;

static void enable(void) {
  if (uart->control == BOTH_ENABLED) return;
  uart->divider = LEAST_DIVIDER;
  uart->control = BOTH_ENABLED;
}

int port_read(void) {
  enable();
  while (!(uart->state & RECEIVER_FULL)) {
  }
  return (int)(uart->data & 0xffu);
}

void port_write(int byte) {
  enable();
  while (uart->state & TRANSMITTER_FULL) {
  }
  uart->data = (uint32_t)byte;
}

#else

/* A 16550, its registers a byte each. */
enum { DATA = 0, LINE_STATUS = 5, RECEIVED = 1, TRANSMITTER_EMPTY = 0x20 };

static volatile uint8_t *const uart = (volatile uint8_t *)UART_ADDRESS;

int port_read(void) {
  while (!(uart[LINE_STATUS] & RECEIVED)) {
  }
  return uart[DATA];
}

void port_write(int byte) {
  while (!(uart[LINE_STATUS] & TRANSMITTER_EMPTY)) {
  }
  uart[DATA] = (uint8_t)byte;
}

#endif
