/* chasles/status.h - what a function can answer besides its outputs.
 *
 * 0         the outputs are valid.
 * positive  the outputs are valid, and the caller may care why the case is special.
 * negative  an error; the outputs were not written, so that a control loop still holds its last good value.
 */
#ifndef CHASLES_STATUS_H
#define CHASLES_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum chs_status {
  CHS_OK = 0,

  CHS_HALF_TURN = 1,         /* the angle is pi to within rounding: the sign of the axis is a convention */
  CHS_PURE_TRANSLATION = 2,  /* no rotation: the axis is the direction of travel, its position is a convention */
  CHS_NO_MOTION = 3,         /* neither rotation nor translation: the axis is a convention */
  CHS_ILL_CONDITIONED = 4,   /* more than half of the digits are lost to the data's geometry */
  CHS_AZIMUTH_UNDEFINED = 5, /* tilt 0: the azimuth is a convention */
  CHS_TORSION_UNDEFINED = 6, /* tilt pi: only 2 azimuth - torsion is defined, the torsion is a convention */
  CHS_POINTS_MISSING = 7,    /* some points were missing: the result is that of the others */
  CHS_PARALLEL = 8,          /* the lines are parallel: the place of their common perpendicular is a convention */
  CHS_COINCIDENT = 9,        /* the lines coincide: direction and place of their common perpendicular are conventions */
  CHS_INTERSECTING = 10,     /* the lines meet: the sense of their common perpendicular is a convention */
  CHS_ITERATION_LIMIT = 11,  /* not converged in the steps allowed: the best so far */
  CHS_AT_JOINT_LIMIT = 12,   /* a joint is held at its limit */
  CHS_NEAR_SINGULAR = 13,    /* near a singular configuration: the answer is damped, not exact */
  CHS_SELF_MOTION = 14,      /* a joint turns freely without moving the rest: its angle is a convention */

  CHS_ERR_NAN = -1,             /* an input is not a number */
  CHS_ERR_INFINITE = -2,        /* an input is infinite */
  CHS_ERR_OVERFLOW = -3,        /* finite inputs, but the result is beyond the format's range */
  CHS_ERR_ANGLE_RANGE = -4,     /* an angle so large that its remainder modulo 2 pi cannot be resolved */
  CHS_ERR_NOT_ROTATION = -5,    /* a matrix farther from orthonormal than CHS_SO3_FAR, or than the tolerance given */
  CHS_ERR_REFLECTION = -6,      /* a matrix with negative determinant */
  CHS_ERR_SINGULAR = -7,        /* the result does not exist or is not unique */
  CHS_ERR_COINCIDENT = -8,      /* two of the points coincide to within the rounding of the coordinates */
  CHS_ERR_COLLINEAR = -9,       /* the points lie on a line to within the rounding of the coordinates */
  CHS_ERR_NOT_RIGID = -10,      /* the points have changed their shape by more than the tolerance given */
  CHS_ERR_ARGUMENT = -11,       /* a count, an index, a weight or an option is outside its range */
  CHS_ERR_TOO_FEW_POINTS = -12, /* fewer than three points are left */
  CHS_ERR_LOCKUP = -13          /* the mechanism is locked up: no joint rate moves it as wanted */
} chs_status;

/* A short English sentence without a full stop for any value of chs_status, and for any other int. Never NULL. */
const char *chs_status_text(int status);

#ifdef __cplusplus
}
#endif

#endif
