/* counter.c - instructions counted, under an emulator whose clock advances by the instruction (-icount).
 *
 * Arm: SysTick, 24 bits, TICKS_PER_THOUSAND of them to a thousand instructions. RISC-V: minstret.
 */
#include "port.h"

#if defined(__arm__)

struct systick {
  volatile uint32_t control, reload, value;
};
static struct systick *const systick = (struct systick *)0xe000e010;

enum { MOST_TICKS = 0xffffff, ON_PROCESSOR_CLOCK = 5 };

void port_count_start(void) {
  systick->control = 0;
  systick->reload = MOST_TICKS;
  systick->value = 0; /* any write clears it; the next tick loads it anew */
  systick->control = ON_PROCESSOR_CLOCK;
}

uint32_t port_count_stop(void) {
  const uint32_t ticks = MOST_TICKS - systick->value;
  return (uint32_t)(((uint64_t)ticks * 1000u + TICKS_PER_THOUSAND / 2u) / TICKS_PER_THOUSAND);
}

#else

static uint32_t started;

static inline uint32_t instructions(void) {
  uint32_t count;
  __asm__ volatile(".option push\n.option arch, +zicsr\ncsrr %0, minstret\n.option pop" : "=r"(count));
  return count;
}

void port_count_start(void) { started = instructions(); }
uint32_t port_count_stop(void) { return instructions() - started; }

#endif
