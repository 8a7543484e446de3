/* chasles/motion.h - the displacement of a body from three of its points (Fenton & Shi 1990).
 *
 * chasles.h has the conventions that all headers share.
 */
#ifndef CHASLES_MOTION_H
#define CHASLES_MOTION_H

#include <chasles/screw.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Two methods for the same task. Bottema & Roth is the faster; Laub & Shiflett is disturbed less by measuring errors,
 * above all where the body turns by little more than they do. Neither costs anything for an output left out.
 *
 *   initial    three points before, [9], one point after the other.
 *   final      the same three points after, in the same order.
 *   tolerance  how far the two triangles may differ, for real markers do: | f^2 - i^2 | <= 2 tolerance L^2 for each
 *              side, initially i long and finally f, L the longest initial side. So it is about the largest change of a
 *              side relative to L; 1e-3 suits a good optical system, 0.05 markers on skin.
 *   screw      the screw parameters, angle in [0, pi]; may be NULL. A pure translation has e along the displacement of
 *              the centroid, A = 0 and theta = 0; no motion has e along z. At a half-turn the first component of e that
 *              is not zero to within its error is positive.
 *   T          the pose that takes initial to final; may be NULL. With points that are not quite rigid R is a rotation
 *              all the same, and p takes the centroid to the centroid.
 *
 * Bottema & Roth (eq. 23): with two vectors x, y of the body, x' and y' after, the half-angle vector
 *   (v; w) = ((x' - x) x (y' - y); (x' - x) . (y' + y))  is proportional to  (sin(theta/2) e; cos(theta/2)),
 * which unlike v/w = tan(theta/2) e has no infinity at a half-turn. For two sides of the triangle (v; w) is the same in
 * whatever order the points are taken, as long as the sides keep their lengths; x is here the side from the first point
 * to the second, y that from the third to the first. In every order it is 4 sin(theta/2) |e . N| long, N = x x y, and 0
 * where the screw axis is parallel to the plane of the points. So where (v; w) says itself that the axis stands at less
 * than asin(1/4), 14.5 degrees, to the plane, and where the triangle is so thin (k^2 > 1/(600 eps)) or the motion so near
 * to none or to a half-turn that rounding has a say in it, the rotation is that of Laub & Shiflett.
 *
 * Laub & Shiflett (eq. 12 and 13): [Q] = [Pf] [Pi]^-1, R = [Q] - p v^T, with both origins moved along the normal of
 * their plane, so that [Pi] is never singular and a thin triangle of relative height h loses eps/h, not eps/h^2. With
 * sides a, c and the normal N = a x c before, a', c', N' after, that is R = (a' (c x N)^T + c' (N x a)^T + N' N^T) / N.N.
 * R is then made a rotation through its quaternion.
 *
 * Then u = e . D and A by eq. 10 and 24 at the centroid, which moves from C to C + D.
 *
 * The reference of the errors is the method in exact arithmetic on the given points. With the condition number
 * k = L/h, longest side over smallest height, s = sin(theta/2) and r the distance of the farthest point from the origin
 * they are relative to: rotation k; position p k r; axis k/s; angle k (absolute); translation r + k |D|/s;
 * point k (r/s + |D|/s^2). An offset of the points costs nothing but its own rounding, for sides are formed first.
 *
 * Returns CHS_OK, or
 *   CHS_HALF_TURN         pi - theta <= 16 k eps
 *   CHS_PURE_TRANSLATION  no side turned by more than the rounding of the coordinates, 4 eps of the largest of them
 *   CHS_NO_MOTION         nor did the centroid move
 *   CHS_ILL_CONDITIONED   k > eps^-1/2; a half-turn is then not told
 *   CHS_ERR_NAN, CHS_ERR_INFINITE
 *   CHS_ERR_OVERFLOW      a side, the difference of two sides or the result is beyond the format
 *   CHS_ERR_COINCIDENT    a side, before or after, is not above 4 eps of the largest coordinate
 *   CHS_ERR_COLLINEAR     a height is not above 8 eps of it
 *   CHS_ERR_NOT_RIGID     beyond the tolerance, or a tolerance that is negative or NaN
 * Of several errors the first in this list counts, the shape of the initial triangle before that of the final one. */
#define CHS_EPS_MOTION_BOTTEMA_ROTH_AXIS 8.0
#define CHS_EPS_MOTION_BOTTEMA_ROTH_POINT 8.0
#define CHS_EPS_MOTION_BOTTEMA_ROTH_TRANSLATION 8.0
#define CHS_EPS_MOTION_BOTTEMA_ROTH_ANGLE 12.0
#define CHS_EPS_MOTION_BOTTEMA_ROTH_ROTATION 12.0
#define CHS_EPS_MOTION_BOTTEMA_ROTH_POSITION 12.0
int chs_motion_bottema_roth(const double initial[9], const double final[9], double tolerance, chs_screw *screw,
                            double T[16]);
int chs_motion_bottema_rothf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw,
                             float T[16]);

#define CHS_EPS_MOTION_LAUB_SHIFLETT_AXIS 8.0
#define CHS_EPS_MOTION_LAUB_SHIFLETT_POINT 8.0
#define CHS_EPS_MOTION_LAUB_SHIFLETT_TRANSLATION 8.0
#define CHS_EPS_MOTION_LAUB_SHIFLETT_ANGLE 8.0
#define CHS_EPS_MOTION_LAUB_SHIFLETT_ROTATION 8.0
#define CHS_EPS_MOTION_LAUB_SHIFLETT_POSITION 8.0
int chs_motion_laub_shiflett(const double initial[9], const double final[9], double tolerance, chs_screw *screw,
                             double T[16]);
int chs_motion_laub_shiflettf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw,
                              float T[16]);

#ifdef __cplusplus
}
#endif

#endif
