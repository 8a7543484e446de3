/* loop.h - what a controller does a thousand times a second: three markers on a tool in, the tool's screw out, and
 * whether the tool is where it should be. Portable; needs the library and nothing else.
 */
#ifndef LOOP_H
#define LOOP_H

#include <chasles/chasles.h>

struct loop {
  /* Set once. */
  float reference[9];  /* the markers when the tool stood at its base orientation, in metres */
  float tolerance;     /* of the triangle's shape: chasles/motion.h */
  float largest_alpha; /* how far the tool may be off, in radians: its axis, */
  float largest_beta;  /* and about its axis */

  /* The last good values: a tick that fails leaves them as they are. */
  chs_screwf screw; /* from the reference to now */
  float pose[16];
  float alpha, beta;

  int age;   /* ticks since they were good */
  int fault; /* the tool was off by more than allowed, or unseen for too long: stays until cleared */
};

enum { LOOP_PATIENCE = 20 }; /* ticks that the tool may be unseen */

/* One tick. `wanted` is the orientation wanted now. Returns the library's status. */
int loop_tick(struct loop *loop, const float markers[9], const float wanted[9]);

#endif
