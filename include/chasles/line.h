/* chasles/line.h - lines in space: Pluecker coordinates, angles, distances, common perpendiculars.
 *
 * A line L is double[6] or float[6], (direction; moment): d and m = r x d for any point r of the line, so that the line
 * has a sense, and so that L is the twist of a turn about it at one radian a unit of time. Unit coordinates have |d| = 1;
 * raw ones, of any length of d, are the same line, and chs_line_normalize makes them unit. The functions below that
 * answer a status take lines whose direction is of unit length, | d.d - 1 | <= CHS_SO3_FAR, divide by that length, and
 * leave out what the moment has along the direction: what they answer is exact for the line so read. In their comments
 * d, m are what was read, s = |d1 x d2| is the sine of the angle of two lines, and M = |m1| + |m2|, their distances from
 * the origin. The numbers
 * of equations are those of the lecture notes "Homogeneous coordinates, lines, screws and twists".
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
#define CHS_EPS_LINE_RAW_FROM_POINTS_MOMENT 3.0
void chs_line_raw_from_points(const double a[3], const double b[3], double L[6]);
void chs_line_raw_from_pointsf(const float a[3], const float b[3], float L[6]);

/* The line from a through b, of unit direction. The error of the direction is absolute, that of the moment relative to
 * the smaller of |a| and |b|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_COINCIDENT where a = b. */
#define CHS_EPS_LINE_FROM_POINTS_DIRECTION 2.0
#define CHS_EPS_LINE_FROM_POINTS_MOMENT 4.0
int chs_line_from_points(const double a[3], const double b[3], double L[6]);
int chs_line_from_pointsf(const float a[3], const float b[3], float L[6]);

/* The line through p along d, a vector of any length but 0; the line's direction is d/|d|. Errors as above, with |p|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_SINGULAR where d = 0. */
#define CHS_EPS_LINE_FROM_DIRECTION_DIRECTION 2.0
#define CHS_EPS_LINE_FROM_DIRECTION_MOMENT 4.0
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
 * chs_se3_adjoint_twist does to a twist. The error of the direction is relative to |R| |d|, that of the moment to
 * |R| (|m| + |p| |d|). */
#define CHS_EPS_LINE_MOVE_DIRECTION 2.0
#define CHS_EPS_LINE_MOVE_MOMENT 2.0
void chs_line_move(const double T[16], const double L[6], double moved[6]);
void chs_line_movef(const float T[16], const float L[6], float moved[6]);

/* The point of the line nearest to x, its foot d x m + (d.x) d, and its distance |x x d - m|; the distance may be NULL.
 * With x = 0 this is the point of the line nearest to the origin. Errors are relative to |x| + |m|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_ARGUMENT where the direction is not of
 * unit length. */
#define CHS_EPS_LINE_PROJECT_FOOT 6.0
#define CHS_EPS_LINE_PROJECT_DISTANCE 6.0
int chs_line_project(const double L[6], const double x[3], double foot[3], double *distance);
int chs_line_projectf(const float L[6], const float x[3], float foot[3], float *distance);

/* The angle of two lines, atan2(|d1 x d2|, d1.d2) in [0, pi], in place of eq. 6 (an arccos has no digit left below 1e-8
 * rad). The signed one, in [-pi, pi], has the sign of about . (d1 x d2): it is measured from the first line to the second
 * about the vector given, by the right-hand rule. A vector of 0, or one at a right angle to both lines' normal, counts
 * as positive. The errors are relative to the angle, down to the smallest.
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
 * CHS_ERR_ARGUMENT, CHS_ERR_OVERFLOW. */
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
 * goes through the point of A nearest to the origin, and the angle is not negative (CHS_PARALLEL). Where they coincide X
 * is as near as may be to the coordinate axis of the smallest component of A's direction, the first of equals
 * (CHS_COINCIDENT).
 *
 * The errors: the direction of X absolute, for parallel lines at a distance a relative to M/a; its moment and the feet
 * relative to M/s, for parallel lines the moment to M max(1, M/a) and the feet to M; the angle relative to itself; the
 * distance as above. Returns as chs_line_distance. */
#define CHS_EPS_LINE_PERPENDICULAR_DIRECTION 6.0
#define CHS_EPS_LINE_PERPENDICULAR_MOMENT 10.0
#define CHS_EPS_LINE_PERPENDICULAR_FOOT 10.0
#define CHS_EPS_LINE_PERPENDICULAR_ANGLE 4.0
#define CHS_EPS_LINE_PERPENDICULAR_DISTANCE 6.0
int chs_line_perpendicular(const double A[6], const double B[6], double X[6], double foot_a[3], double foot_b[3],
                           double *angle, double *distance);
int chs_line_perpendicularf(const float A[6], const float B[6], float X[6], float foot_a[3], float foot_b[3],
                            float *angle, float *distance);

#ifdef __cplusplus
}
#endif

#endif
