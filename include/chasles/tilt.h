/* chasles/tilt.h - the tilt-and-torsion angles, and the rotational error of axisymmetric tools (Briot & Bonev 2008).
 *
 * The tool's axis of symmetry is the third column of an orientation, its z axis. The angle that disregards the tool's
 * shape, that of nominal^T actual, is chs_so3_angle. chasles.h has the conventions that all headers share.
 */
#ifndef CHASLES_TILT_H
#define CHASLES_TILT_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How far an orientation is from the one wanted, as an axisymmetric tool sees it: by which angle alpha its axis is off,
 * and by which angle beta it is turned about that axis once the axes are brought together. With columns x, y, d of the
 * nominal (0) and the actual (1) orientation
 *
 *   alpha = atan2(|d0 x d1|, d0 . d1),  beta = | atan2(y0 . x1 - x0 . y1, x0 . x1 + y0 . y1) |
 *
 * in place of the paper's arccos (eq. 1), which has no digit left below 1e-8 rad, and two-case sum (eq. 2).
 *
 *   nominal, actual  rotations to within CHS_SO3_FAR, in the same base frame.
 *   alpha, beta      in [0, pi]. At alpha = pi beta has no meaning and is 0.
 *
 * Let r be the length of the two arguments that beta's atan2 has, which for rotations is 1 + cos(alpha). The errors:
 * alpha relative to |d1 - d0|, which is 2 sin(alpha/2) for rotations; beta relative to |actual - nominal|, Frobenius,
 * times 1/r where r < 1, above pi/2, where it is ever worse defined. Both at 1e-12 rad are as exact as any.
 * Returns CHS_OK; CHS_TORSION_UNDEFINED where r is no more than rounding, about 8 eps, so that beta is set to 0; and what
 * CHS_SO3_FAR says, of either matrix. */
#define CHS_EPS_TILT_ERROR_ALPHA 4.0
#define CHS_EPS_TILT_ERROR_BETA 4.0
int chs_tilt_error(const double nominal[9], const double actual[9], double *alpha, double *beta);
int chs_tilt_errorf(const float nominal[9], const float actual[9], float *alpha, float *beta);

/* R = Rz(azimuth) Ry(tilt) Rz(torsion - azimuth): the axis tilts towards the azimuth, then the torsion about it.
 *
 *   azimuth, tilt, torsion  any angles up to CHS_ANGLE_MAX(F) in size.
 *
 * The error is absolute, at any angles.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE. */
#define CHS_EPS_TILT_TO_ROTATION 3.5
int chs_tilt_to_rotation(double azimuth, double tilt, double torsion, double R[9]);
int chs_tilt_to_rotationf(float azimuth, float tilt, float torsion, float R[9]);

/* The tilt-and-torsion angles of an orientation:
 *
 *   azimuth = atan2(r23, r13),  tilt = atan2(sqrt(r13^2 + r23^2), r33),  torsion = atan2(r21 - r12, r11 + r22)
 *
 *   R                 a rotation to within CHS_SO3_FAR.
 *   azimuth, torsion  in [-pi, pi], with atan2's signs of zeros; tilt in [0, pi].
 *
 * Near a tilt of pi, where |r21 - r12| + |r11 + r22| <= 1/64 and rounding drowns them, the torsion is 2 azimuth -
 * atan2(-(r12 + r21), r22 - r11), brought into [-pi, pi].
 *
 * The errors are relative to each angle, near a tilt of pi that of the torsion to 2 pi. At tilt 0 the azimuth is
 * undefined and is 0 (CHS_AZIMUTH_UNDEFINED). At tilt pi only 2 azimuth - torsion is defined; the torsion is 0
 * (CHS_TORSION_UNDEFINED). Returns CHS_OK, these two, and what CHS_SO3_FAR says. */
#define CHS_EPS_TILT_FROM_ROTATION_AZIMUTH 2.0
#define CHS_EPS_TILT_FROM_ROTATION_TILT 2.0
#define CHS_EPS_TILT_FROM_ROTATION_TORSION 2.0
int chs_tilt_from_rotation(const double R[9], double *azimuth, double *tilt, double *torsion);
int chs_tilt_from_rotationf(const float R[9], float *azimuth, float *tilt, float *torsion);

/* How wrong a robot is whose joints are: the largest errors of its tool while each joint is off by at most its error.
 * Over a grid of the error box, and from the best points of it uphill to points between, by turns along each joint.
 *
 *   robot    the robot's direct kinematics: writes the pose of the tool and returns a chs_status. In float the pose and
 *            the joints are float.
 *   context  is handed to it.
 *   n        joints, at least 1.
 *   joints   their nominal values [n].
 *   errors   how far each may be off, either way [n], >= 0.
 *   steps    points of the grid along each joint, at least 2, the ends of its interval among them; the robot is called
 *            for all steps^n, which may be 2^30 at most.
 *   refine   how often the search after the grid halves its step, from the grid's; 0 for the grid alone.
 *   scratch  CHS_TILT_WORST_SCRATCH(n) numbers.
 *   worst    the largest alpha and the largest beta of chs_tilt_error against the nominal pose, and the largest
 *            distance of the two origins.
 *   where    the joint values that gave them [3 n], n each; may be NULL.
 *
 * The errors of the two angles are absolute, those of two poses; the promise is for a robot whose R is within 6 eps.
 * Gains up to 16 eps, times the size of the nominal position for the distance, are taken for rounding: a joint that
 * does not matter stays at the lower end of its interval.
 * Returns CHS_OK, or the first positive status of the robot or of chs_tilt_error on the way; CHS_ERR_ARGUMENT,
 * CHS_ERR_NAN, CHS_ERR_INFINITE of joints, errors and the robot's positions; and the first error of the robot or of
 * chs_tilt_error, so that a box that reaches a singularity is told. */
#define CHS_EPS_TILT_WORST 32.0
#define CHS_TILT_WORST_SCRATCH(n) (4 * (n))
typedef int chs_tilt_robot(const double *joints, void *context, double T[16]);
typedef int chs_tilt_robotf(const float *joints, void *context, float T[16]);
int chs_tilt_worst(chs_tilt_robot *robot, void *context, int n, const double *joints, const double *errors, int steps,
                   int refine, double *scratch, double worst[3], double *where);
int chs_tilt_worstf(chs_tilt_robotf *robot, void *context, int n, const float *joints, const float *errors, int steps,
                    int refine, float *scratch, float worst[3], float *where);

#ifdef __cplusplus
}
#endif

#endif
