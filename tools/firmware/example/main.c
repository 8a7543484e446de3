/* main.c - the loop of loop.c in an interrupt at 1 kHz, on a Cortex-M4 that is emulated with -icount shift=7, where an
 * instruction takes 3.2 ticks of the 25 MHz clock. The tool swings for two seconds; now and then a marker is hidden.
 * Prints what became of it, and how many instructions the longest tick took. Exit status 0 when all was well.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>

#include "loop.h"

enum { TICKS = 2000, CLOCK = 25000000, RATE = 1000, TICKS_OF_TEN_INSTRUCTIONS = 32 };
enum { PERIOD = CLOCK / RATE };

struct systick {
  volatile uint32_t control, reload, value;
};
static struct systick *const timer = (struct systick *)0xe000e010;

/* Three markers on the tool, in metres; 0.1 rad off is a fault. */
static struct loop loop = {.reference = {0.10F, 0.02F, 0.30F, 0.16F, 0.02F, 0.30F, 0.12F, 0.07F, 0.33F},
                           .tolerance = 1e-3F,
                           .largest_alpha = 0.1F,
                           .largest_beta = 0.1F};

/* Read and written by the interrupt, and by main when it is over. */
static volatile int tick;
static int refused, kept, worst;
static float largest_alpha, largest_beta;

/* The orientation wanted at a tick, and that of the tool, which lags behind by some milliradians. */
static void orientation(int at, float lag, float R[9]) {
  const float time = (float)at / (float)RATE;
  chs_tilt_to_rotationf(2.0F * time, 0.5F - lag, 0.3F * time + lag, R);
}

/* What the cameras see; every 97th tick the second marker is hidden. */
static void see(int at, float markers[9]) {
  const float travel[3] = {0.05F * (float)at / (float)TICKS, 0.0F, 0.01F};
  float R[9], T[16];
  orientation(at, 0.004F, R);
  chs_se3_from_partsf(R, travel, T);
  for (int i = 0; i < 9; i += 3) chs_se3_applyf(T, loop.reference + i, markers + i);
  if (at % 97 == 96) markers[4] = NAN;
}

void systick(void);
void systick(void) {
  float markers[9], wanted[9];
  see(tick, markers);
  orientation(tick, 0.0F, wanted);
  const float angle = loop.screw.angle;

  const uint32_t start = timer->value;
  const int status = loop_tick(&loop, markers, wanted);
  const uint32_t end = timer->value;
  const uint32_t taken = start >= end ? start - end : start + PERIOD - end; /* it counts down, and starts anew */

  const int instructions = (int)(taken * 10u / TICKS_OF_TEN_INSTRUCTIONS);
  if (instructions > worst) worst = instructions;
  if (status < 0) {
    ++refused;
    kept += loop.screw.angle == angle && loop.age == 1;
  }
  if (loop.alpha > largest_alpha) largest_alpha = loop.alpha;
  if (loop.beta > largest_beta) largest_beta = loop.beta;
  ++tick;
}

static int microradians(float angle) { return (int)(1e6F * angle + 0.5F); }

int main(void) {
  timer->reload = PERIOD - 1;
  timer->value = 0;
  timer->control = 7; /* on, with its interrupt, on the processor's clock */
  while (tick < TICKS) __asm__ volatile("wfi");
  timer->control = 0;

  const int period = PERIOD * 10 / TICKS_OF_TEN_INSTRUCTIONS;
  printf("%d ticks at %d Hz: %d refused, of which %d kept the last good screw\n", tick, RATE, refused, kept);
  printf("tool off by at most %d urad of tilt, %d urad of torsion: %s\n", microradians(largest_alpha),
         microradians(largest_beta), loop.fault ? "FAULT" : "within the limits");
  printf("longest tick: %d instructions of %d in a period\n", worst, period);
  const int good = refused == TICKS / 97 && kept == refused && !loop.fault && worst < period;
  return good ? 0 : 1;
}
