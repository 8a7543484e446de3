/* semihosting.c - see semihosting.h. Arm's specification, which RISC-V shares. */
#include "semihosting.h"

#include <stdint.h>
#include <string.h>

enum { SYS_OPEN = 1, SYS_WRITE = 5, SYS_READ = 6, SYS_EXIT_EXTENDED = 0x20 };
enum { APPLICATION_EXIT = 0x20026 };

/* Not inlined: on RISC-V the three instructions must be uncompressed and lie in one line of memory. */
__attribute__((noinline)) static int request(int operation, const void *arguments) {
#if defined(__arm__)
  register int r0 __asm__("r0") = operation;
  register const void *r1 __asm__("r1") = arguments;
  __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
  return r0;
#elif defined(__riscv)
  register int a0 __asm__("a0") = operation;
  register const void *a1 __asm__("a1") = arguments;
  __asm__ volatile(".option push\n"
                   ".option norvc\n"
                   ".balign 16\n"
                   "slli zero, zero, 0x1f\n"
                   "ebreak\n"
                   "srai zero, zero, 7\n"
                   ".option pop"
                   : "+r"(a0)
                   : "r"(a1)
                   : "memory");
  return a0;
#else
#error "semihosting on Arm and RISC-V only"
#endif
}

int semihosting_open(const char *name, enum semihosting_mode mode) {
  const uintptr_t arguments[3] = {(uintptr_t)name, (uintptr_t)mode, strlen(name)};
  return request(SYS_OPEN, arguments);
}

int semihosting_read(int file, void *bytes, int count) {
  const uintptr_t arguments[3] = {(uintptr_t)file, (uintptr_t)bytes, (uintptr_t)count};
  return count - request(SYS_READ, arguments); /* it answers what is left over */
}

void semihosting_write(int file, const void *bytes, int count) {
  const uintptr_t arguments[3] = {(uintptr_t)file, (uintptr_t)bytes, (uintptr_t)count};
  request(SYS_WRITE, arguments);
}

void semihosting_exit(int status) {
  const uintptr_t arguments[2] = {APPLICATION_EXIT, (uintptr_t)status};
  for (;;) request(SYS_EXIT_EXTENDED, arguments);
}
