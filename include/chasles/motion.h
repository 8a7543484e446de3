/* chasles/motion.h - the displacement of a body from three of its points, by five methods, or from any number of them.
 *
 * chasles.h has the conventions that all headers share.
 */
#ifndef CHASLES_MOTION_H
#define CHASLES_MOTION_H

#include <chasles/screw.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Five methods for the same task, of one interface: on points that move rigidly they give the same answer, and on
 * measured ones the answer depends on the method. Bottema & Roth is the fastest, Laub & Shiflett next. An output left
 * out costs nothing.
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
 * than asin(1/4), 14.5 degrees, to the plane, where the sides changed by more than 1.4 times what a turn by its angle
 * can do, so that (v; w) is measuring errors magnified, and where the triangle is so thin (k^2 > 1/(600 eps) at the latest)
 * or the motion so near to none or to a half-turn that rounding has a say in it, the rotation is that of Laub & Shiflett.
 *
 * Laub & Shiflett (eq. 12 and 13): [Q] = [Pf] [Pi]^-1, R = [Q] - p v^T, with both origins moved along the normal of
 * their plane, so that [Pi] is never singular and a thin triangle of relative height h loses eps/h, not eps/h^2. With
 * sides a, c and the normal N = a x c before, a', c', N' after, that is R = (a' (c x N)^T + c' (N x a)^T + N' N^T) /
 * N.N. R is then made a rotation through its quaternion.
 *
 * Spoor & Veldpaus (eq. 14 to 16): the rotation that leaves the least sum of squared distances between the points and
 * their images. For three points M is a 2 x 2 matrix between their two planes and the product of eq. 16 its orthogonal
 * factor, written down without eigenvectors: neither equal nor vanishing d matter, and it is never a reflection.
 *
 * Angeles (eq. 6 to 8): R = Q2 Q1^T from the principal axes of the points' second moments before and after, the normal
 * of the plane and two in the plane; which end of an axis is which is told by the points. Where the two moments in the
 * plane differ by less than a quarter of their sum, as in an equilateral triangle, the axes say too little, and those
 * are taken that fit the points best: the rotation is that of Spoor & Veldpaus.
 *
 * Beggs (eq. 28 to 30): each row of R from two linear equations and its length, by a quadratic whose unknown is the
 * row's part along the normal N instead of a coordinate, so that no denominator (E) vanishes. All of the eight matrices
 * take the three points to the same images; of these that one is taken which leaves the smallest residual on a fourth
 * point off the plane, the end of N. A row whose part along N is below 1/2, and so lost in its root, gets it from the
 * other rows by eq. 5b. R is made a rotation through its quaternion.
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

/* Which order of the points chs_motion_bottema_roth took, for the same arguments. The paper's rule is the order with
 * the largest change of the side p3 - p2, so that eq. 23 stays away from 0/0.
 *
 *   order  k = 0, 1 or 2: the rule's p2 is initial point k, p3 the next one and p1 the last, in cyclic order. The
 *          answer is the same in all three, to within rounding and the changes of the sides' lengths.
 *          -1: none would do, and the rotation is that of Laub & Shiflett; or there is no rotation.
 *
 * Returns what chs_motion_bottema_roth returns. */
int chs_motion_bottema_roth_order(const double initial[9], const double final[9], double tolerance, int *order);
int chs_motion_bottema_roth_orderf(const float initial[9], const float final[9], float tolerance, int *order);

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

#define CHS_EPS_MOTION_ANGELES_AXIS 8.0
#define CHS_EPS_MOTION_ANGELES_POINT 8.0
#define CHS_EPS_MOTION_ANGELES_TRANSLATION 8.0
#define CHS_EPS_MOTION_ANGELES_ANGLE 12.0
#define CHS_EPS_MOTION_ANGELES_ROTATION 12.0
#define CHS_EPS_MOTION_ANGELES_POSITION 12.0
int chs_motion_angeles(const double initial[9], const double final[9], double tolerance, chs_screw *screw,
                       double T[16]);
int chs_motion_angelesf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw, float T[16]);

#define CHS_EPS_MOTION_SPOOR_VELDPAUS_AXIS 8.0
#define CHS_EPS_MOTION_SPOOR_VELDPAUS_POINT 8.0
#define CHS_EPS_MOTION_SPOOR_VELDPAUS_TRANSLATION 8.0
#define CHS_EPS_MOTION_SPOOR_VELDPAUS_ANGLE 8.0
#define CHS_EPS_MOTION_SPOOR_VELDPAUS_ROTATION 8.0
#define CHS_EPS_MOTION_SPOOR_VELDPAUS_POSITION 8.0
int chs_motion_spoor_veldpaus(const double initial[9], const double final[9], double tolerance, chs_screw *screw,
                              double T[16]);
int chs_motion_spoor_veldpausf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw,
                               float T[16]);

#define CHS_EPS_MOTION_BEGGS_AXIS 8.0
#define CHS_EPS_MOTION_BEGGS_POINT 8.0
#define CHS_EPS_MOTION_BEGGS_TRANSLATION 8.0
#define CHS_EPS_MOTION_BEGGS_ANGLE 8.0
#define CHS_EPS_MOTION_BEGGS_ROTATION 8.0
#define CHS_EPS_MOTION_BEGGS_POSITION 8.0
int chs_motion_beggs(const double initial[9], const double final[9], double tolerance, chs_screw *screw, double T[16]);
int chs_motion_beggsf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw, float T[16]);

/* One entry for all five, for a program that leaves the choice to its user. In firmware call the method itself: only
 * this function makes a linker keep them all.
 *
 * The default is Spoor & Veldpaus, which measuring errors disturb least: with independent errors of the coordinates, as
 * markers have, and triangles of k <= 4 the rotation of Angeles is off by 1.12 times as much, Laub & Shiflett 1.16,
 * Beggs 1.19, Bottema & Roth 1.95 (root mean square). On the motions of the paper's section 4 with 0.1 % of such errors
 * the final points are off by 1.16, 1.24, 1.40 and 2.00 times as much: tools/study/methods.md. In time they cost, in
 * the same order, about 1.1, 0.55, 0.9 and 0.45.
 *
 * Returns what the method returns, or CHS_ERR_ARGUMENT for a method that is none. */
typedef enum chs_motion_method {
  CHS_MOTION_DEFAULT = 0,
  CHS_MOTION_ANGELES = 1, /* the paper's numbers */
  CHS_MOTION_LAUB_SHIFLETT = 2,
  CHS_MOTION_SPOOR_VELDPAUS = 3,
  CHS_MOTION_BOTTEMA_ROTH = 4,
  CHS_MOTION_BEGGS = 5
} chs_motion_method;

#define CHS_EPS_MOTION_FROM_THREE_AXIS 8.0
#define CHS_EPS_MOTION_FROM_THREE_POINT 8.0
#define CHS_EPS_MOTION_FROM_THREE_TRANSLATION 8.0
#define CHS_EPS_MOTION_FROM_THREE_ANGLE 12.0
#define CHS_EPS_MOTION_FROM_THREE_ROTATION 12.0
#define CHS_EPS_MOTION_FROM_THREE_POSITION 12.0
int chs_motion_from_three(chs_motion_method method, const double initial[9], const double final[9], double tolerance,
                          chs_screw *screw, double T[16]);
int chs_motion_from_threef(chs_motion_method method, const float initial[9], const float final[9], float tolerance,
                           chs_screwf *screw, float T[16]);

/* How well a displacement fits the points, lengths in the unit of the points. */
typedef struct chs_motion_quality {
  double rms;        /* root of the weighted mean square of the residuals | y - (R x + p) | */
  double largest;    /* the largest residual, unweighted; -1 where it is not known (streaming) */
  size_t largest_at; /* the point that has it, from 0; the number of points used where it is not known */
  double size;       /* root of the weighted mean square distance of the initial points from their centroid */
  double rigidity;   /* rms / size: 0 for a rigid body, whatever the motion; what the tolerance is compared with */
  double growth;     /* final size / initial size - 1: a wrong unit or scale, where it is much of the rigidity */
  double condition;  /* k of the errors below */
  size_t points;     /* used: there, and with a weight above 0 */
  size_t missing;
} chs_motion_quality;

typedef struct chs_motion_qualityf {
  float rms;
  float largest;
  size_t largest_at;
  float size;
  float rigidity;
  float growth;
  float condition;
  size_t points;
  size_t missing;
} chs_motion_qualityf;

/* The displacement that fits n >= 3 points best: of all rotations R and translations p the pair with the least weighted
 * sum of squares of the residuals y - (R x + p) (Spoor & Veldpaus 1980, for any number of points and any weights).
 *
 *   n          number of points.
 *   initial    the points before, [3 n], one point after the other.
 *   final      the same points after, [3 n], in the same order.
 *   weights    [n], each finite and >= 0; 0 leaves a point out. NULL: all 1. Weights of missing points are not read.
 *   missing    [n], not 0 for a point that is missing; may be NULL. A point with a coordinate that is NaN or infinite,
 *              before or after, is missing too, so that gaps in measured data need no mask.
 *   tolerance  the largest rigidity (rms / size) that is accepted: 1e-3 suits a good optical system, 0.05 markers on
 *              skin. INFINITY: none.
 *   screw      as for three points; may be NULL.
 *   T          the pose that takes initial to final; may be NULL. p takes the centroid to the centroid.
 *   quality    may be NULL, which saves a second look at the points.
 *
 * R makes trace(R^T H) largest, H = sum w (y - C') (x - C)^T with the centroids C and C'. It is a rotation also where
 * the best orthogonal matrix is a reflection (points in a plane, large errors, a mirror image). The largest value, s1 +
 * s2 + s3 in signed singular values of H, is a root of a polynomial (Davenport 1968) and gives R without an
 * eigenvector (Markley 1993); one Newton step on the rotations then brings it to the last digits.
 *
 * The points are looked at once, or twice where the first tell too little of the rest, and memory is constant, however
 * many they are. Differences from a point amid them are summed, so that an offset costs nothing but its own rounding;
 * blocks of 128 join totals that keep their rounding errors, so that the errors do not grow with n; and what the
 * differences are taken from is moved when the weight has doubled, so that it never lies far outside the cloud.
 *
 * The reference of the errors is the least-squares displacement of the given points in exact arithmetic. With
 *   k = N | (trace(S) I - S)^-1 |, S = R^T H, N^2 = sum w |x - C|^2 sum w |y - C'|^2, Frobenius norms,
 * s = sin(theta/2), r the distance of the farthest point from the origin, f that from their centroid, and D the
 * displacement of the centroid, they are relative to: rotation k; position p k r; axis k/s; angle k (absolute);
 * translation r + k |D|/s; point k (r/s + |D|/s^2); residuals k f; size itself; rigidity k f/size; growth
 * 1 + |growth|; condition k^2. k is 2.6 for a round cloud, 3 for a flat one; for a thin one of relative height h it
 * grows like 1/h^2, since H holds squares: three of its points, well chosen, lose only eps/h with the methods above.
 * A rotation of less than its own error, 2 k eps, counts as none; the angle of a half-turn ends at pi, on whichever
 * side of it the convention for its axis leaves it.
 *
 * Returns CHS_OK, or
 *   CHS_POINTS_MISSING       some are missing, and nothing of the following
 *   CHS_HALF_TURN            pi - theta <= 16 k eps
 *   CHS_PURE_TRANSLATION     no rotation
 *   CHS_NO_MOTION            nor did the centroid move
 *   CHS_ILL_CONDITIONED      k > eps^-1/2; a half-turn is then not told
 *   CHS_ERR_ARGUMENT         a weight that is negative, NaN or infinite
 *   CHS_ERR_OVERFLOW         a distance between points, a sum of weighted squares or the result is beyond the format
 *   CHS_ERR_TOO_FEW_POINTS   fewer than three are left
 *   CHS_ERR_COINCIDENT       the size, before or after, is not above 4 eps of the coordinates
 *   CHS_ERR_COLLINEAR        nearer to a line than the rounding errors of the squares, a relative height of about
 *                            3 eps^1/2, or of the coordinates
 *   CHS_ERR_SINGULAR         more than one rotation is best, to within rounding: a mirror image of a cloud that is
 *                            round about some axis, or points that have nothing to do with each other
 *   CHS_ERR_NOT_RIGID        beyond the tolerance, or a tolerance that is negative or NaN
 * Of several errors the first in this list counts, but of the first two the one that is met first. */
#define CHS_EPS_MOTION_FIT_AXIS 8.0
#define CHS_EPS_MOTION_FIT_POINT 8.0
#define CHS_EPS_MOTION_FIT_TRANSLATION 8.0
#define CHS_EPS_MOTION_FIT_ANGLE 8.0
#define CHS_EPS_MOTION_FIT_ROTATION 8.0
#define CHS_EPS_MOTION_FIT_POSITION 8.0
#define CHS_EPS_MOTION_FIT_RESIDUALS 8.0
#define CHS_EPS_MOTION_FIT_SIZE 8.0
#define CHS_EPS_MOTION_FIT_RIGIDITY 8.0
#define CHS_EPS_MOTION_FIT_GROWTH 12.0
#define CHS_EPS_MOTION_FIT_CONDITION 8.0
int chs_motion_fit(size_t n, const double *initial, const double *final, const double *weights,
                   const unsigned char *missing, double tolerance, chs_screw *screw, double T[16],
                   chs_motion_quality *quality);
int chs_motion_fitf(size_t n, const float *initial, const float *final, const float *weights,
                    const unsigned char *missing, float tolerance, chs_screwf *screw, float T[16],
                    chs_motion_qualityf *quality);

/* The same for points that come one at a time. The sums are the caller's, of constant size, and may be copied; what
 * they hold is the library's business. chs_motion_begin empties them. */
typedef struct chs_motion_sums {
  double about[6];          /* the points that distances are summed from, initial and final, */
  double about_weight;      /* and the weight of those they stand for */
  double scale;             /* a power of two that distances are multiplied by */
  double sum[18], lost[18]; /* totals, and what rounding took from them */
  size_t points, missing;
} chs_motion_sums;

typedef struct chs_motion_sumsf {
  float about[6];
  float about_weight;
  float scale;
  float sum[18], lost[18];
  size_t points, missing;
} chs_motion_sumsf;

void chs_motion_begin(chs_motion_sums *sums);
void chs_motion_beginf(chs_motion_sumsf *sums);

/* Adds a point: where it was, where it is, and its weight, finite and >= 0.
 * Returns CHS_OK; CHS_POINTS_MISSING for a point that is missing, counted and left out; and with the sums as they were
 * CHS_ERR_ARGUMENT for a weight that is negative, NaN or infinite, and CHS_ERR_OVERFLOW for a point whose distance from
 * the others is beyond the format. */
int chs_motion_add(chs_motion_sums *sums, const double initial[3], const double final[3], double weight);
int chs_motion_addf(chs_motion_sumsf *sums, const float initial[3], const float final[3], float weight);

/* The displacement that fits the points added so far; more may follow. Arguments, statuses and errors are those of
 * chs_motion_fit, but for the residuals: the sums do not tell the largest, and they give the rms by a difference of
 * squares of the size. So its error is relative to size^2/rms, and at most size (64 eps)^1/2: 1.2e-7 of the size
 * in double, 2.8e-3 in float, size being the larger of before and after. A tolerance of that order is not told from
 * 0. */
#define CHS_EPS_MOTION_FINISH_RMS 64.0
int chs_motion_finish(const chs_motion_sums *sums, double tolerance, chs_screw *screw, double T[16],
                      chs_motion_quality *quality);
int chs_motion_finishf(const chs_motion_sumsf *sums, float tolerance, chs_screwf *screw, float T[16],
                       chs_motion_qualityf *quality);

/* What measuring errors do to the least-squares displacement, to first order (Spoor & Veldpaus 1980; Woltring et al.
 * 1985 for the axis).
 *
 *   n ... missing  as for chs_motion_fit. Where the points differ in quality the weights must be what they should be:
 *                  the error of point i is sigma / sqrt(weight of i), in each coordinate.
 *   sigma          the standard deviation of each coordinate of y - (R x + p), in the unit of the points: errors are
 *                  independent and alike in all directions. With errors of s_i before and s_f after that is
 *                  (s_i^2 + s_f^2)^1/2. From the fit itself an estimate is rms (n / (3 n - 6))^1/2.
 *   pose           [36], row-major, the covariance of (w; d): the true pose is [exp([w]) R, p + d; 0 1], w a small
 *                  rotation vector in the final frame, d in coordinates of it. Units: radians and the points' unit,
 *                  multiplied; may be NULL.
 *   screw          [64], row-major, the covariance of the eight numbers of chs_screw in their order: axis, point,
 *                  translation, angle; may be NULL. The axis has two degrees of freedom and so has the point: the rank
 *                  is 6.
 *
 * With A = R (trace(S) I - S) R^T (chs_motion_fit), W the sum of the weights and e the axis,
 *   cov(w) = sigma^2 A^-1,  cov(C' + error) = sigma^2 / W I, independent,  d = shift of the centroid - w x R C,
 *   d axis = 1/2 (cot(theta/2) (w - (e.w) e) - e x w),  d angle = e.w,
 * and point and translation by the differentials of eq. 24 and 10. So the axis' variance grows like 1/theta^2 for small
 * angles, and that of the point like |D|^2/theta^4.
 *
 * With a^2 = |A^-1| and b^2 = 1/W the standard deviations are bounded by sigma times: w a; d a r + b; axis a/s; point
 * a (r/s + |D|/s^2) + b/s; translation a |D|/s + b; angle a. The error of an entry is relative to the two bounds that
 * it belongs to times k, for the screw times k/s.
 * Returns as chs_motion_fit but for CHS_ERR_NOT_RIGID, and
 *   CHS_ILL_CONDITIONED  the rotation or the axis is uncertain by more than 0.1 radians, where first order tells
 *                        little: the angle is too small for the errors, or the cloud too thin
 *   CHS_ERR_SINGULAR     also where the covariance of the screw is asked for and there is no rotation
 *   CHS_ERR_ARGUMENT     also a sigma that is negative, NaN or infinite */
#define CHS_EPS_MOTION_COVARIANCE 16.0
int chs_motion_covariance(size_t n, const double *initial, const double *final, const double *weights,
                          const unsigned char *missing, double sigma, double pose[36], double screw[64]);
int chs_motion_covariancef(size_t n, const float *initial, const float *final, const float *weights,
                           const unsigned char *missing, float sigma, float pose[36], float screw[64]);

/* The same for points that came one at a time. */
int chs_motion_finish_covariance(const chs_motion_sums *sums, double sigma, double pose[36], double screw[64]);
int chs_motion_finish_covariancef(const chs_motion_sumsf *sums, float sigma, float pose[36], float screw[64]);

#ifdef __cplusplus
}
#endif

#endif
