#include <chasles/status.h>

const char *chs_status_text(int status) {
  switch (status) {
  case CHS_OK: return "ok";
  case CHS_HALF_TURN: return "half-turn: the sign of the axis is a convention";
  case CHS_PURE_TRANSLATION: return "pure translation: no rotation axis";
  case CHS_NO_MOTION: return "no motion";
  case CHS_ILL_CONDITIONED: return "ill-conditioned: more than half of the digits are lost";
  case CHS_AZIMUTH_UNDEFINED: return "no tilt: the azimuth is undefined";
  case CHS_TORSION_UNDEFINED: return "tilt of pi: the torsion is undefined";
  case CHS_POINTS_MISSING: return "some points are missing: the result is that of the others";
  case CHS_PARALLEL: return "the lines are parallel: the place of their common perpendicular is a convention";
  case CHS_COINCIDENT: return "the lines coincide: their common perpendicular is a convention";
  case CHS_INTERSECTING: return "the lines meet: the sense of their common perpendicular is a convention";
  case CHS_ITERATION_LIMIT: return "not converged in the steps allowed";
  case CHS_AT_JOINT_LIMIT: return "a joint is held at its limit";
  case CHS_NEAR_SINGULAR: return "near a singular configuration: the answer is damped";
  case CHS_SELF_MOTION: return "a joint turns freely: its angle is a convention";
  case CHS_ERR_NAN: return "an input is not a number";
  case CHS_ERR_INFINITE: return "an input is infinite";
  case CHS_ERR_OVERFLOW: return "the result is beyond the range of the format";
  case CHS_ERR_ANGLE_RANGE: return "an angle is too large to be reduced modulo 2 pi";
  case CHS_ERR_NOT_ROTATION: return "a matrix is too far from a rotation";
  case CHS_ERR_REFLECTION: return "a matrix is a reflection";
  case CHS_ERR_SINGULAR: return "the result does not exist or is not unique";
  case CHS_ERR_COINCIDENT: return "two points coincide to within the rounding of the coordinates";
  case CHS_ERR_COLLINEAR: return "the points lie on a line to within the rounding of the coordinates";
  case CHS_ERR_NOT_RIGID: return "the points have changed their shape";
  case CHS_ERR_ARGUMENT: return "a count, an index, a weight or an option is outside its range";
  case CHS_ERR_TOO_FEW_POINTS: return "fewer than three points are left";
  case CHS_ERR_LOCKUP: return "the mechanism is locked up";
  default: return "unknown status";
  }
}
