/* system_calls.c - what newlib asks of a system, for programs that print: the tests and the example. */
#include <errno.h>
#include <stddef.h>
#include <sys/stat.h>

#include "semihosting.h"

extern char heap_start[], stack_top[];

void *_sbrk(ptrdiff_t more);
int _write(int file, const char *bytes, int count);
int _read(int file, char *bytes, int count);
int _lseek(int file, int offset, int whence);
int _close(int file);
int _fstat(int file, struct stat *about);
int _isatty(int file);
int _getpid(void);
int _kill(int process, int signal);
void _exit(int status);

/* Half of what lies between the program's data and the end of memory; the other half is the stack's. */
void *_sbrk(ptrdiff_t more) {
  static ptrdiff_t used;
  if (more > (stack_top - heap_start) / 2 - used) {
    errno = ENOMEM;
    return (void *)-1;
  }
  used += more;
  return heap_start + used - more;
}

/* Whatever the stream, to the console of the emulator. */
int _write(int file, const char *bytes, int count) {
  static int console = -1;
  (void)file;
  if (console < 0) console = semihosting_open(":tt", SEMIHOSTING_APPEND);
  semihosting_write(console, bytes, count);
  return count;
}

int _read(int file, char *bytes, int count) {
  (void)file;
  (void)bytes;
  (void)count;
  return 0;
}

int _fstat(int file, struct stat *about) {
  (void)file;
  about->st_mode = S_IFCHR;
  return 0;
}

int _lseek(int file, int offset, int whence) {
  (void)file;
  (void)offset;
  (void)whence;
  return 0;
}

int _close(int file) {
  (void)file;
  return -1;
}

int _isatty(int file) {
  (void)file;
  return 1;
}

int _getpid(void) { return 1; }

int _kill(int process, int signal) {
  (void)process;
  (void)signal;
  return -1;
}

void _exit(int status) {
  for (;;) semihosting_exit(status);
}
