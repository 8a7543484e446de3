/* sweep.c - see sweep.h. */
#include "sweep.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "text.h"

enum { BAR = 50 };

struct rows {
  pthread_mutex_t lock;
  long next;
  long done;
  long count;
  bool shown;
  void (*work)(void *context, long row);
  void *context;
};

int core_count(void) {
  const long cores = sysconf(_SC_NPROCESSORS_ONLN);
  return cores < 1 ? 1 : cores > MOST_THREADS ? MOST_THREADS : (int)cores;
}

/* Redrawn a hundred times in all. */
static void show_progress(const struct rows *rows) {
  const int percent = (int)(100 * rows->done / rows->count);
  if (!rows->shown || (rows->done > 1 && percent == (int)(100 * (rows->done - 1) / rows->count))) return;
  char bar[BAR + 1];
  memset(bar, ' ', BAR);
  memset(bar, '#', (size_t)(percent * BAR / 100));
  bar[BAR] = '\0';
  fprintf(stderr, "\r[%s] %3d %%", bar, percent);
}

static void *run_rows(void *argument) {
  struct rows *rows = argument;
  pthread_mutex_lock(&rows->lock);
  while (rows->next < rows->count) {
    const long row = rows->next++;
    pthread_mutex_unlock(&rows->lock);
    rows->work(rows->context, row);
    pthread_mutex_lock(&rows->lock);
    ++rows->done;
    show_progress(rows);
  }
  pthread_mutex_unlock(&rows->lock);
  return NULL;
}

bool sweep(long row_count, int threads, void (*work)(void *context, long row), void *context) {
  struct rows rows = {PTHREAD_MUTEX_INITIALIZER, 0, 0, row_count, isatty(STDERR_FILENO) != 0, work, context};
  pthread_t started[MOST_THREADS];
  int running = 0;
  while (running < threads && running < MOST_THREADS && pthread_create(&started[running], NULL, run_rows, &rows) == 0) {
    ++running;
  }
  for (int i = 0; i < running; ++i) pthread_join(started[i], NULL);
  if (rows.shown) fprintf(stderr, "\r%*s\r", BAR + 8, "");
  if (running == 0) complain("no thread could be started");
  return running > 0;
}
