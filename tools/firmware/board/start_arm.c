/* start_arm.c - from reset to main on a Cortex-M, and what happens when something goes wrong. */
#include <stdint.h>
#include <string.h>

#include "semihosting.h"

/* From sections.ld. */
extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];

int main(void);
void reset(void);

static void fault(void) { semihosting_exit(99); }

/* The timer's interrupt, for programs that have one. */
void systick(void);
__attribute__((weak)) void systick(void) {}

void reset(void) {
#if defined(__ARM_FP)
  /* Full access to the floating-point unit, before the first instruction that needs it. */
  *(volatile uint32_t *)0xe000ed88 |= 0xfu << 20;
  __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
  memcpy(data_start, data_load, (size_t)((char *)data_end - (char *)data_start));
  memset(bss_start, 0, (size_t)((char *)bss_end - (char *)bss_start));
  semihosting_exit(main());
}

union vector {
  void *stack;
  void (*handler)(void);
};

/* Non-maskable interrupt, hard fault and what the larger cores have besides. */
__attribute__((section(".vectors"), used)) static const union vector vectors[16] = {
    [0] = {stack_top},        [1] = {.handler = reset}, [2] = {.handler = fault}, [3] = {.handler = fault},
    [4] = {.handler = fault}, [5] = {.handler = fault}, [6] = {.handler = fault}, [15] = {.handler = systick}};
