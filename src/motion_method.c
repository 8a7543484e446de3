#include "real.h"
#include <chasles/motion.h>

#ifdef CHS_SINGLE
typedef chs_screwf screw;
#else
typedef chs_screw screw;
#endif

/* Apart from the methods, so that only a program that leaves the choice open links them all. */
int FN(chs_motion_from_three)(chs_motion_method method, const real initial[9], const real final[9], real tolerance,
                              screw *out, real T[16]) {
  switch (method) {
  case CHS_MOTION_DEFAULT:
  case CHS_MOTION_SPOOR_VELDPAUS: return FN(chs_motion_spoor_veldpaus)(initial, final, tolerance, out, T);
  case CHS_MOTION_ANGELES: return FN(chs_motion_angeles)(initial, final, tolerance, out, T);
  case CHS_MOTION_LAUB_SHIFLETT: return FN(chs_motion_laub_shiflett)(initial, final, tolerance, out, T);
  case CHS_MOTION_BOTTEMA_ROTH: return FN(chs_motion_bottema_roth)(initial, final, tolerance, out, T);
  case CHS_MOTION_BEGGS: return FN(chs_motion_beggs)(initial, final, tolerance, out, T);
  }
  return CHS_ERR_ARGUMENT;
}
