/* chasles/line.h - lines in space: Pluecker coordinates, angles, distances, common perpendiculars.
 *
 * A line L is double[6] or float[6], (direction; moment): d and m = r x d for any point r of the line, so that the line
 * has a sense, and so that L is the twist of a turn about it at one radian a unit of time. Unit coordinates have
 * |d| = 1; raw ones, of any length of d, are the same line, and chs_line_normalize makes them unit. The functions below
 * that answer a status take lines whose direction is of unit length, | d.d - 1 | <= CHS_SO3_FAR, divide by that length,
 * and leave out what the moment has along the direction: what they answer is exact for the line so read. In their
 * comments d, m are what was read, s = |d1 x d2| is the sine of the angle of two lines, and M = |m1| + |m2|, their
 * distances from the origin; but errors are relative to moments as they were given, what is left out included. The
 * numbers of equations are those of the lecture notes "Homogeneous coordinates, lines, screws and twists".
 * chasles.h has the conventions that all headers share.
 */
#ifndef CHASLES_LINE_H
#define CHASLES_LINE_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The line from a through b, raw: (b - a; a x b). The moment is that of whichever point is nearer to the origin. The
 * error of the direction is relative to |b - a|, that of the moment to |b - a| times the smaller of |a| and |b|. */
#define CHS_EPS_LINE_RAW_FROM_POINTS_DIRECTION 1.0
#define CHS_EPS_LINE_RAW_FROM_POINTS_MOMENT 2.0
void chs_line_raw_from_points(const double a[3], const double b[3], double L[6]);
void chs_line_raw_from_pointsf(const float a[3], const float b[3], float L[6]);

/* The line from a through b, of unit direction. The error of the direction is absolute, that of the moment relative to
 * the smaller of |a| and |b|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_COINCIDENT where a = b. */
#define CHS_EPS_LINE_FROM_POINTS_DIRECTION 2.0
#define CHS_EPS_LINE_FROM_POINTS_MOMENT 3.0
int chs_line_from_points(const double a[3], const double b[3], double L[6]);
int chs_line_from_pointsf(const float a[3], const float b[3], float L[6]);

/* The line through p along d, a vector of any length but 0; the line's direction is d/|d|. Errors as above, with |p|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_SINGULAR where d = 0. */
#define CHS_EPS_LINE_FROM_DIRECTION_DIRECTION 2.0
#define CHS_EPS_LINE_FROM_DIRECTION_MOMENT 3.0
int chs_line_from_direction(const double p[3], const double d[3], double L[6]);
int chs_line_from_directionf(const float p[3], const float d[3], float L[6]);

/* Raw coordinates (q; q0) of a line made unit: direction q/|q| and moment q0/|q|, less what it has along the direction.
 * The error of the direction is absolute, that of the moment relative to |q0|/|q|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_SINGULAR where q = 0. */
#define CHS_EPS_LINE_NORMALIZE_DIRECTION 2.0
#define CHS_EPS_LINE_NORMALIZE_MOMENT 4.0
int chs_line_normalize(const double raw[6], double L[6]);
int chs_line_normalizef(const float raw[6], float L[6]);

/* The line in another frame, or moved with a body: (R d; R m + p x R d), raw or unit as it was, which is what
 * chs_se3_adjoint_twist does to a twist. With a rotation R the error of the direction is relative to |R| |d|, that of
 * the moment to |R| (|m| + |p| |d|). */
#define CHS_EPS_LINE_MOVE_DIRECTION 2.0
#define CHS_EPS_LINE_MOVE_MOMENT 2.0
void chs_line_move(const double T[16], const double L[6], double moved[6]);
void chs_line_movef(const float T[16], const float L[6], float moved[6]);

/* The point of the line nearest to x, its foot d x m + (d.x) d, and its distance |x x d - m|; the distance may be NULL.
 * With x = 0 this is the point of the line nearest to the origin. Errors are relative to |x| + |m|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_ARGUMENT where the direction is not of
 * unit length. */
#define CHS_EPS_LINE_PROJECT_FOOT 5.0
#define CHS_EPS_LINE_PROJECT_DISTANCE 4.0
int chs_line_project(const double L[6], const double x[3], double foot[3], double *distance);
int chs_line_projectf(const float L[6], const float x[3], float foot[3], float *distance);

/* The angle of two lines, atan2(|d1 x d2|, d1.d2) in [0, pi], in place of eq. 6 (an arccos has no digit left below 1e-8
 * rad). The signed one, in [-pi, pi], has the sign of about . (d1 x d2): it is measured from the first line to the
 * second about the vector given, by the right-hand rule. A vector of 0, or one at a right angle to both lines' normal,
 * counts as positive, to within rounding: an angle is negative where about . (d1 x d2) < -8 eps |about| s. The errors
 * are relative to the angle, down to the smallest.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ARGUMENT. */
#define CHS_EPS_LINE_ANGLE 4.0
#define CHS_EPS_LINE_SIGNED_ANGLE 4.0
int chs_line_angle(const double A[6], const double B[6], double *angle);
int chs_line_anglef(const float A[6], const float B[6], float *angle);
int chs_line_signed_angle(const double A[6], const double B[6], const double about[3], double *angle);
int chs_line_signed_anglef(const float A[6], const float B[6], const float about[3], float *angle);

/* The shortest distance of two lines: |d1.m2 + d2.m1| / s (eq. 7, whose sign depends on the sense of the normal), and
 * |d x (p2 - p1)| for parallel ones, p their points nearest to the origin. The error is relative to M/s, for parallel
 * lines to M.
 * Returns CHS_OK; CHS_INTERSECTING where it is no more than rounding, | d1.m2 + d2.m1 | <= 8 eps M; CHS_PARALLEL where
 * s <= 8 eps; CHS_COINCIDENT where also the distance is at most 8 eps M; CHS_ERR_NAN, CHS_ERR_INFINITE,
 * CHS_ERR_ARGUMENT; CHS_ERR_OVERFLOW, which an M beyond half of the format's range can be whatever the distance is. */
#define CHS_EPS_LINE_DISTANCE 6.0
int chs_line_distance(const double A[6], const double B[6], double *distance);
int chs_line_distancef(const float A[6], const float B[6], float *distance);

/* The common perpendicular of two lines, all that lies between them:
 *
 *   X               a unit line, from A to B (eq. 5; eq. 9, which lacks its 1/s^2).
 *   foot_a, foot_b  where it meets them (eq. 8); either may be NULL, and so may the next two.
 *   angle           from A to B about X, in [-pi, pi].
 *   distance        from A to B along X, as chs_line_distance gives it.
 *
 * Lines that meet have no A-to-B: X is along d1 x d2 and the angle is positive (CHS_INTERSECTING). For parallel lines X
 * goes through the point of A nearest to the origin, and the angle is not negative (CHS_PARALLEL). Where they coincide
 * X is as near as may be to the coordinate axis of the smallest component of A's direction, the first of equals
 * (CHS_COINCIDENT).
 *
 * The errors: the direction of X absolute, for parallel lines at a distance a relative to M/a; its moment, and the feet
 * as one vector of six, relative to M/s, for parallel lines the moment to M max(1, M/a) and the feet to M; the angle
 * relative to itself; the distance as above. Returns as chs_line_distance. */
#define CHS_EPS_LINE_PERPENDICULAR_DIRECTION 3.0
#define CHS_EPS_LINE_PERPENDICULAR_MOMENT 10.0
#define CHS_EPS_LINE_PERPENDICULAR_FOOT 12.0
#define CHS_EPS_LINE_PERPENDICULAR_ANGLE 4.0
#define CHS_EPS_LINE_PERPENDICULAR_DISTANCE 6.0
int chs_line_perpendicular(const double A[6], const double B[6], double X[6], double foot_a[3], double foot_b[3],
                           double *angle, double *distance);
int chs_line_perpendicularf(const float A[6], const float B[6], float X[6], float foot_a[3], float foot_b[3],
                            float *angle, float *distance);

/* The parameters of Denavit and Hartenberg tell a chain of n joint axes by four numbers each, (a, alpha, d, theta):
 * double[4*n], one row after the other. Frame i is frame i-1 moved by
 *
 *   standard (distal)             A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i),  axis i is z of frame i-1
 *   modified (proximal, Craig)    A_i = Rx(alpha_i) Tx(a_i) Rz(theta_i) Tz(d_i),  axis i is z of frame i
 *
 * where a and alpha of the modified row i are those that Craig writes with the index i-1. So home = base A_1 ... A_n
 * tool with two poses that a table of 4 n numbers leaves out. A revolute joint's value adds to theta, a prismatic one's
 * to d. As screws of chain.h the axes are (d; m) of a revolute joint and (0; d) of a prismatic one. */
typedef enum chs_dh { CHS_DH_STANDARD = 1, CHS_DH_MODIFIED = 2 } chs_dh;

/* The axes, and the pose of the tool, where all joint values are zero.
 *
 *   n           the number of joints, at least 1.
 *   base, tool  the poses of frame 0 in the frame of the result, and of the tool in frame n; NULL is the identity.
 *   dh          [4*n], angles up to CHS_ANGLE_MAX(F) in size.
 *   axes        [6*n], unit lines; must not overlap dh.
 *   home        the pose of the tool; may be NULL.
 *
 * With the reach r = |p_base| + sum of |a| + |d| + |p_tool|, and for base and tool that are rotations to within
 * rounding, errors are n times what is promised here: of directions and of the rotation absolutely, of moments and of
 * the position relative to r.
 * Returns CHS_OK; CHS_ERR_ARGUMENT where n < 1 or the convention is none; CHS_ERR_ANGLE_RANGE; CHS_ERR_OVERFLOW; what
 * CHS_SO3_FAR says, for all numbers. */
#define CHS_EPS_LINE_FROM_DH_DIRECTION 3.0
#define CHS_EPS_LINE_FROM_DH_MOMENT 4.0
#define CHS_EPS_LINE_FROM_DH_ROTATION 4.0
#define CHS_EPS_LINE_FROM_DH_POSITION 4.0
int chs_line_from_dh(int n, chs_dh convention, const double base[16], const double *dh, const double tool[16],
                     double *axes, double home[16]);
int chs_line_from_dhf(int n, chs_dh convention, const float base[16], const float *dh, const float tool[16],
                      float *axes, float home[16]);

/* The parameters of a chain, the inverse of the above. Each x axis lies along the common perpendicular of two axes, and
 * of its two senses has the one that turns less from the x axis before, so that |theta| <= pi/2 and the links that lie
 * in line at home have theta = 0; a may then be negative. Where it turns by a right angle either way, x goes from the
 * one axis to the next, or along their cross product where they meet.
 *
 *   standard   Frame 0 is at the point of axis 1 nearest to the origin, its x axis as near as may be to that of the
 *              base or, where axis 1 is within 30 degrees of that, to its y axis. The last row leads to the line of the
 *              tool's z axis: the tool is a turn about z and a travel along it.
 *   modified   The first row leads from the line of the base's z axis: the base is a turn about z and a travel along
 *              it. Frame n is at the point of axis n nearest to the tool, its x axis as near as may be to that of the
 *              tool, or to its y axis likewise.
 *   parallel   axes have d = 0 for the row between them: their perpendicular goes through the frame's origin; next to
 *              the tool's z axis it goes through the tool.
 *   coincident axes have a frame that stays as it was; one that coincides with the tool's z axis has the tool's.
 *
 *   axes       [6*n], lines of unit direction, any point of a prismatic joint's axis.
 *   tolerance  lines count as parallel where their sine is at most this, and as meeting where their distance times
 *              their sine, or the distance of parallel ones, is at most this times their distances from the origin, the
 *              largest of them and |p_home|; alpha is then 0 or pi and a is 0. At least 8 eps, whatever is given.
 *   dh         [4*n]; must not overlap axes.
 *   base, tool may be NULL.
 *
 * What comes out gives the axes and the tool back by chs_line_from_dh. Let r be the largest of |m| and |p_home|, s the
 * smallest sine of neighbours that are not parallel, and k the largest of 1, 1/s and r over the smallest distance of
 * parallel neighbours: errors, n + 1 times what is promised here, are relative to k for angles and rotations and to k r
 * for lengths and positions.
 * Returns CHS_OK; CHS_PARALLEL or CHS_COINCIDENT, the latter if both, where some neighbours of the axes given are so;
 * CHS_ERR_ARGUMENT as above, for a negative tolerance and directions that are not of unit length; CHS_ERR_OVERFLOW; what
 * CHS_SO3_FAR says of home, for all numbers. */
#define CHS_EPS_LINE_TO_DH_ANGLES 3.0
#define CHS_EPS_LINE_TO_DH_LENGTHS 6.0
#define CHS_EPS_LINE_TO_DH_ROTATION 3.0
#define CHS_EPS_LINE_TO_DH_POSITION 6.0
int chs_line_to_dh(int n, chs_dh convention, const double *axes, const double home[16], double tolerance, double *dh,
                   double base[16], double tool[16]);
int chs_line_to_dhf(int n, chs_dh convention, const float *axes, const float home[16], float tolerance, float *dh,
                    float base[16], float tool[16]);

#ifdef __cplusplus
}
#endif

#endif
