/* loop.c - see loop.h. */
#include "loop.h"

static int measure(struct loop *loop, const float markers[9], const float wanted[9]) {
  float R[9], p[3];
  int status = chs_motion_bottema_rothf(loop->reference, markers, loop->tolerance, &loop->screw, loop->pose);
  if (status < 0) return status; /* a marker is hidden (NaN), or they do not form the triangle */
  chs_se3_to_partsf(loop->pose, R, p);
  return chs_tilt_errorf(wanted, R, &loop->alpha, &loop->beta);
}

int loop_tick(struct loop *loop, const float markers[9], const float wanted[9]) {
  const int status = measure(loop, markers, wanted);
  loop->age = status < 0 ? loop->age + 1 : 0;
  if (loop->age > LOOP_PATIENCE || loop->alpha > loop->largest_alpha || loop->beta > loop->largest_beta) {
    loop->fault = 1;
  }
  return status;
}
