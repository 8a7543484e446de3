/* chasles/agile_eye.h - the kinematics of the Agile Eye, a spherical parallel robot of three legs.
 *
 * A platform turns about a fixed centre O, through which every joint axis passes. Leg i has a motor on the base, its
 * axis along u_i; a link of a right angle from u_i to w_i, the axis of the middle joint; and one more, from w_i to v_i,
 * the axis of the joint on the platform (Bonev, Chablat & Wenger 2006; Briot & Bonev 2008). The base frame x y z and
 * the platform's frame X Y Z, the columns of R, have their origin at O:
 *
 *        u3 w1                    motor axis    at joint angle q_i           platform's axis
 *           z                     u1 =  x       w1 = (0, -sin q1, cos q1)    v1 = -Y
 *           |                     u2 =  y       w2 = (cos q2, 0, -sin q2)    v2 = -Z
 *           |                     u3 =  z       w3 = (-sin q3, cos q3, 0)    v3 = -X
 *   v1 -----O----- y  u2 w3
 *          /|                     Each leg says w_i . v_i = 0. The drawing shows the reference, q = 0 and R = I:
 *         / |                     leg 1 goes from x over z to -y, leg 2 from y over x to -z, leg 3 from z over y
 *        x  |                     to -x, which is hidden.
 *    u1 w2  v2
 *
 * An orientation has two joint angles a leg, opposite to each other: 8 working modes, numbers 0 to 7. Bit i - 1 of the
 * number is set where leg i is the other way round, (u_i x w_i) . v_i < 0; mode 0 holds the reference.
 *
 * Joint angles have eight orientations, the assembly modes. Four, 4 to 7, do not depend on the joints: every v_i lies
 * along its u_i, the platform is locked, and the legs turn freely. The other four, 0 to 3, are R0, R0 diag(1,-1,-1),
 * R0 diag(-1,1,-1) and R0 diag(-1,-1,1), with
 *
 *   D  = s1 s2 s3 + c1 c2 c3,  s_i = sin q_i, c_i = cos q_i
 *   N1 = c2 s3 - s2 s1 c3 c1,  d1^2 = s2^2 + c2^2 c3^2,  and cyclically 1 -> 2 -> 3 -> 1
 *   D^2 + N1^2 = d2^2 d3^2
 *   R0 = [ (c3 D, s3 D, -N3) / (d1 d2),  (-N1, c1 D, s1 D) / (d2 d3),  (s2 D, -N2, c2 D) / (d3 d1) ], as columns
 *
 * Working mode m goes with one of these four if its number of legs the other way round is even and D > 0, or odd and
 * D < 0, and with none otherwise. Where D = 0 they coincide with the four of the locked platform.
 *
 * Singular are the six curves on which v_i lies along u_i or against it, Y = +-x, Z = +-y, X = +-z: on the first pair
 * leg 1 turns freely, and because d1 = 0, q2 in {0, pi} and q3 = +-pi/2, so does the platform about x. Nothing else is
 * singular: wherever no d_i is 0 the orientation follows the joints smoothly, through D = 0 as well. chasles.h has the
 * conventions that all headers share.
 */
#ifndef CHASLES_AGILE_EYE_H
#define CHASLES_AGILE_EYE_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The joint angles of an orientation: q1 = atan2(r32, r22), q2 = atan2(r13, r33), q3 = atan2(r21, r11), or pi away.
 *
 *   R        the platform in the base frame, a rotation to within CHS_SO3_FAR.
 *   working  the working mode, 0 to 7; _all gives all eight, three joint angles each.
 *   joints   in [-pi, pi].
 *
 * The error is relative to each angle.
 * Returns CHS_OK; CHS_SELF_MOTION where v_i is along u_i to within 4 eps: that leg turns freely and its angle is 0;
 * CHS_ERR_LOCKUP where all three are: any joint angles hold this orientation; CHS_ERR_ARGUMENT where there is no such
 * mode; and what CHS_SO3_FAR says. */
#define CHS_EPS_AGILE_EYE_INVERSE 2.0
#define CHS_EPS_AGILE_EYE_INVERSE_ALL 2.0
int chs_agile_eye_inverse(const double R[9], int working, double joints[3]);
int chs_agile_eye_inversef(const float R[9], int working, float joints[3]);
int chs_agile_eye_inverse_all(const double R[9], double joints[24]);
int chs_agile_eye_inverse_allf(const float R[9], float joints[24]);

/* The orientation of given joint angles: in an assembly mode, 0 to 7; in the assembly mode that a working mode, 0 to 7,
 * goes with; and in that of the modes 0 to 3 which is nearest to a given one, as a control loop's last.
 *
 *   joints  any angles up to CHS_ANGLE_MAX(F) in size.
 *   last    a rotation to within CHS_SO3_FAR. Of modes equally far the first is taken.
 *
 * The error is absolute, and does not grow on the way to a singular curve: of the joint angles as they are given every
 * orientation is known to its last digits. What a change of theirs does there is another matter: it is larger in R by
 * up to 1/d, d the least of the d_i. With size = max(1, |q1|, |q2|, |q3|):
 * Returns CHS_OK; CHS_SELF_MOTION where |D| <= 8 eps size, at which the platform is locked, the legs turn freely, and
 * every working mode is answered; CHS_ILL_CONDITIONED where d <= sqrt(eps) size; CHS_ERR_SINGULAR where d <= 8 eps
 * size, so that the rounding of the joint angles alone decides how the platform has turned, and where the working mode
 * goes with no orientation; CHS_ERR_ARGUMENT where there is no such mode; CHS_ERR_NAN, CHS_ERR_INFINITE,
 * CHS_ERR_ANGLE_RANGE; and of `last` what CHS_SO3_FAR says. Assembly modes 4 to 7 are always CHS_OK. */
#define CHS_EPS_AGILE_EYE_DIRECT 6.0
#define CHS_EPS_AGILE_EYE_DIRECT_WORKING 6.0
#define CHS_EPS_AGILE_EYE_DIRECT_NEAR 6.0
int chs_agile_eye_direct(const double joints[3], int assembly, double R[9]);
int chs_agile_eye_directf(const float joints[3], int assembly, float R[9]);
int chs_agile_eye_direct_working(const double joints[3], int working, double R[9]);
int chs_agile_eye_direct_workingf(const float joints[3], int working, float R[9]);
int chs_agile_eye_direct_near(const double joints[3], const double last[9], double R[9]);
int chs_agile_eye_direct_nearf(const float joints[3], const float last[9], float R[9]);

/* Rates: omega = J (dq1/dt, dq2/dt, dq3/dt), the angular velocity of the platform in the base frame, the same in the
 * assembly modes 0 to 3; and back, the same in all working modes. With A omega + B dq/dt = 0, the derivatives of
 * w_i . v_i, A has the rows v_i x w_i and the determinant -D (D where the platform is locked), B the diagonal
 * (u_i x w_i) . v_i, and J = -A^-1 B has the determinant D^2 / (d1 d2 d3)^2 and the columns
 *
 *   (s1^2 s3^2 + c1^2 c2^2 + s1 s2 s3 c1 c2 c3, -s1 s3 N2, -c1 c2 N3) / (d2 d3)^2,  and cyclically
 *
 * which do not divide by D; the inverse has the rows (1, -r12 r22 / b1^2, -r12 r32 / b1^2), b1^2 = r22^2 + r32^2, and
 * cyclically.
 *
 *   joints  as for chs_agile_eye_direct.
 *   R       as for chs_agile_eye_inverse.
 *
 * The errors: a column of J relative to 1/(d_j d_k), which it does not exceed, and a row of the inverse to its norm.
 * The first returns as chs_agile_eye_direct; where D = 0 the rank of J is 1. The second returns CHS_OK;
 * CHS_ERR_SINGULAR where a v_i is along u_i to within 4 eps; CHS_ERR_LOCKUP where all are, so that no joint rates move
 * the platform; and what CHS_SO3_FAR says. */
#define CHS_EPS_AGILE_EYE_JACOBIAN 8.0
#define CHS_EPS_AGILE_EYE_JACOBIAN_INVERSE 3.0
int chs_agile_eye_jacobian(const double joints[3], double J[9]);
int chs_agile_eye_jacobianf(const float joints[3], float J[9]);
int chs_agile_eye_jacobian_inverse(const double R[9], double K[9]);
int chs_agile_eye_jacobian_inversef(const float R[9], float K[9]);

/* The distance to the singular curves: the least angle by which the platform must be turned to be on one of them. It is
 * the least of the angles between v_i and the line of u_i, atan2(b_i, |u_i . v_i|): pi/2 at the reference, and 0 on the
 * curves. Its sine is the least |D| / (d_j d_k).
 *
 *   R  as for chs_agile_eye_inverse.
 *
 * The error is relative. Returns CHS_OK and what CHS_SO3_FAR says. */
#define CHS_EPS_AGILE_EYE_DISTANCE 3.0
int chs_agile_eye_distance(const double R[9], double *distance);
int chs_agile_eye_distancef(const float R[9], float *distance);

/* The tool, and the frames in which the tilt-and-torsion angles of the paper are meant. On the base z is along (1,1,1)
 * and x is the projection of u1; on the platform z is along (1,1,1) as well and x along (1,1,-2), so that the reference
 * has tilt 0 and torsion pi/3. chs_tilt_from_rotation and chs_tilt_error take the result.
 *
 *   tool = C0^T R C1,  R = C0 tool C1^T,
 *
 *        [  2 0 1 ]                                       [  1 -1 1 ]
 *   C0 = [ -1 1 1 ] diag(1/sqrt(6), 1/sqrt(2), 1/sqrt(3)), C1 = [  1  1 1 ] times the same
 *        [ -1 -1 1 ]                                      [ -2  0 1 ]
 *
 * For any 3x3 matrices; the errors are relative to the Frobenius norm of the input. */
#define CHS_EPS_AGILE_EYE_TOOL 2.0
#define CHS_EPS_AGILE_EYE_PLATFORM 2.0
void chs_agile_eye_tool(const double R[9], double tool[9]);
void chs_agile_eye_toolf(const float R[9], float tool[9]);
void chs_agile_eye_platform(const double tool[9], double R[9]);
void chs_agile_eye_platformf(const float tool[9], float R[9]);

#ifdef __cplusplus
}
#endif

#endif
