/* sweep.h - the same work for many rows, on all cores, with a progress bar. */
#ifndef SWEEP_H
#define SWEEP_H

#include <stdbool.h>

enum { MOST_THREADS = 256 };

/* Cores at hand, 1 to MOST_THREADS. */
int core_count(void);

/* Calls work(context, row) once for each row from 0, on that many threads; the rows must not depend on each other. A
 * progress bar on standard error, if that is a terminal. False with a message when no thread can be started. */
bool sweep(long rows, int threads, void (*work)(void *context, long row), void *context);

#endif
