/* port.h - what a board provides: the only file its owner writes defines the first two. */
#ifndef PORT_H
#define PORT_H

#include <stdint.h>

/* The next byte from the host; waits for it. */
int port_read(void);

/* Sends a byte to the host; waits until the line takes it. */
void port_write(int byte);

/* Bytes that the board buffers while it computes; 0 unless defined: the host then sends one request at a time. */
unsigned port_window(void);

/* Instructions or cycles from one to the other; nothing is counted unless both are defined. */
void port_count_start(void);
uint32_t port_count_stop(void);

#endif
