/* The files of tools/firmware/board/semihosting.h on this machine: the device's program as a program here. */
#include "semihosting.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

int semihosting_open(const char *name, enum semihosting_mode mode) {
  return open(name, mode == SEMIHOSTING_READ ? O_RDONLY : O_WRONLY | O_APPEND);
}

int semihosting_read(int file, void *bytes, int count) { return (int)read(file, bytes, (size_t)count); }

void semihosting_write(int file, const void *bytes, int count) {
  const char *next = bytes;
  while (count > 0) {
    const ssize_t written = write(file, next, (size_t)count);
    if (written <= 0) exit(1);
    next += written;
    count -= (int)written;
  }
}

void semihosting_exit(int status) { exit(status); }
