/* chasles/screw.h - a displacement as a screw: about which axis, by what angle, how far along it (Chasles's theorem).
 *
 * chasles.h has the conventions that all headers share.
 */
#ifndef CHASLES_SCREW_H
#define CHASLES_SCREW_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The screw parameters [e, A, u, theta] of Fenton & Shi 1990, section 2. (-e, A, -u, -theta) is the same
 * displacement. */
typedef struct chs_screw {
  double axis[3];     /* e, a unit vector */
  double point[3];    /* A, a point of the axis; from the library the one nearest to the origin, e . A = 0 */
  double translation; /* u, along e, in the unit of length of A */
  double angle;       /* theta, about e, in radians */
} chs_screw;

typedef struct chs_screwf {
  float axis[3];
  float point[3];
  float translation;
  float angle;
} chs_screwf;

/* The screw of a pose, with angle in [0, pi]: e and theta from R, and (eq. 21 and 22 of the paper, without their 0/0)
 *
 *   u = e . p,  A = 1/2 (p - u e + cot(theta/2) e x p)
 *
 *   T      a pose whose rotation is one to within CHS_SO3_FAR, read as by chs_so3_log.
 *   screw  at a half-turn the first non-zero component of e is positive. A pure translation has e along p, u = |p|,
 *          A = 0, theta = 0; the identity has e along z. A rotation below eps whose axis lies beyond the format's
 *          range counts as none.
 *
 * The errors: the axis absolutely; the angle relative to itself; the translation relative to |p|; the point relative to
 * |p|/(2 sin(theta/2)), the distance at which the axis lies.
 * Returns CHS_OK; CHS_HALF_TURN as chs_so3_log; CHS_PURE_TRANSLATION; CHS_NO_MOTION; CHS_ERR_OVERFLOW where |p| or A is
 * beyond the format; and what CHS_SO3_FAR says, for p as well. */
#define CHS_EPS_SCREW_FROM_POSE_AXIS 2.0
#define CHS_EPS_SCREW_FROM_POSE_POINT 6.0
#define CHS_EPS_SCREW_FROM_POSE_TRANSLATION 3.0
#define CHS_EPS_SCREW_FROM_POSE_ANGLE 3.0
int chs_screw_from_pose(const double T[16], chs_screw *screw);
int chs_screw_from_posef(const float T[16], chs_screwf *screw);

/* The pose of a screw: R = exp(theta [e]), p = (I - R) A + u e.
 *
 *   screw  any axis but 0, which is divided by its length first; any point of the axis, near the origin or not; any
 *          angle up to CHS_ANGLE_MAX(F) in size.
 *
 * The error of the rotation is absolute, at any angle; that of the translation relative to |u| + min(|theta|, 2) |A|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE, CHS_ERR_OVERFLOW, and CHS_ERR_SINGULAR where the
 * axis is 0 but the motion is not. */
#define CHS_EPS_SCREW_TO_POSE_ROTATION 4.0
#define CHS_EPS_SCREW_TO_POSE_TRANSLATION 6.0
int chs_screw_to_pose(const chs_screw *screw, double T[16]);
int chs_screw_to_posef(const chs_screwf *screw, float T[16]);

/* The pitch u/theta, in units of length a radian, rounded once.
 * Returns CHS_OK; CHS_PURE_TRANSLATION with a pitch of plus or minus infinity, by the sign of u; CHS_NO_MOTION with 0;
 * CHS_ERR_NAN and CHS_ERR_INFINITE, of u and theta; CHS_ERR_OVERFLOW. */
#define CHS_EPS_SCREW_PITCH 1.0
int chs_screw_pitch(const chs_screw *screw, double *pitch);
int chs_screw_pitchf(const chs_screwf *screw, float *pitch);

#ifdef __cplusplus
}
#endif

#endif
