/* chasles/so3.h - rotations: 3x3 matrices, rotation vectors, and the maps between them.
 *
 * R is double[9] or float[9], row-major. A rotation vector w is double[3] or float[3]: the unit axis e times the angle
 * theta in radians, w = theta e. [w] is the skew-symmetric matrix with [w] x = w x x. chasles.h has the conventions
 * that all headers share.
 */
#ifndef CHASLES_SO3_H
#define CHASLES_SO3_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How far a matrix may be from a rotation and still be read as one. With rows r1, r2, r3 its deviation is the largest
 * of | r1.r1 - 1 |, | r2.r2 - 1 |, | r1.r2 | and the entries of | r3 - r1 x r2 |. A function that takes a rotation and
 * returns a status accepts a deviation up to CHS_SO3_FAR: rounding, drift, data printed with three digits. Beyond it
 * the answer is CHS_ERR_NOT_ROTATION, or CHS_ERR_REFLECTION where the determinant is negative; NaN and infinite entries
 * are CHS_ERR_NAN and CHS_ERR_INFINITE. */
#define CHS_SO3_FAR 0.01

/* The largest angles, in radians, that are reduced modulo 2 pi to their stated error. Beyond them neighbouring numbers
 * are so far apart that an angle modulo 2 pi means nothing: CHS_ERR_ANGLE_RANGE. */
#define CHS_ANGLE_MAX 281474976710656.0 /* 2^48, double */
#define CHS_ANGLE_MAXF 1048576.0F       /* 2^20, float */

/* W = [w]. Exact. */
#define CHS_EPS_SO3_HAT 0.0
void chs_so3_hat(const double w[3], double W[9]);
void chs_so3_hatf(const float w[3], float W[9]);

/* w from the skew-symmetric part of W: the inverse of hat. Exact where W is skew-symmetric; otherwise half the
 * difference of opposite entries, rounded. */
#define CHS_EPS_SO3_VEE 0.0
void chs_so3_vee(const double W[9], double w[3]);
void chs_so3_veef(const float W[9], float w[3]);

/* R = exp [w] = I + sin(theta)/theta [w] + (1 - cos(theta))/theta^2 [w]^2 (Rodrigues).
 *
 *   w  rotation vector, any finite one with theta up to CHS_ANGLE_MAX(F), far beyond 2 pi.
 *   R  the rotation; w = 0 gives the identity exactly.
 *
 * The error counts entries absolutely, and those off the diagonal relative to theta below 1 rad, so that a rotation by
 * 1e-300 keeps all its digits. Above pi (BEYOND) it is that of the exact exponential of the given w: the angle is
 * computed and reduced with far more digits than the format has.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE. */
#define CHS_EPS_SO3_EXP 2.0
#define CHS_EPS_SO3_EXP_BEYOND 4.0
int chs_so3_exp(const double w[3], double R[9]);
int chs_so3_expf(const float w[3], float R[9]);

/* w = log R, the rotation vector with angle in [0, pi].
 *
 *   R  a rotation to within CHS_SO3_FAR. Up to 104 degrees, a trace of 1/2, the axis is that of its skew part and the
 *      angle that of the trace; beyond, it is read through a column of its quaternion matrix, the largest of three
 *      (Shepperd 1978). For a rotation rounded to the format that is the nearest rotation, to a fraction of an eps;
 *      for one that has drifted it is one within the drift, and chs_so3_nearest is there to go before.
 *   w  the rotation vector; the identity gives 0 exactly. At a half-turn, where the skew part of R is exactly 0, its
 *      first non-zero component is positive; next to it the skew part decides, however small.
 *
 * The error is relative to theta. There is no loss near 0 nor near pi, and no slow path.
 * Returns CHS_OK; CHS_HALF_TURN where pi - theta <= 2 eps, so that rounding decides the sign of the axis; and what
 * CHS_SO3_FAR says. */
#define CHS_EPS_SO3_LOG 2.0
int chs_so3_log(const double R[9], double w[3]);
int chs_so3_logf(const float R[9], float w[3]);

/* The left and right Jacobians of the exponential, and their inverses:
 *
 *   J_l = a I + b [w] + c w w^T,  a = sin(theta)/theta, b = (1 - cos(theta))/theta^2, c = (theta - sin(theta))/theta^3
 *   J_l^-1 = k I - [w]/2 + d w w^T,  k = (theta/2) cot(theta/2), d = (1 - k)/theta^2
 *   J_r(w) = J_l(-w),  J_r^-1(w) = J_l^-1(-w)
 *
 * To first order in dw, exp(w + dw) = exp(J_l dw) exp(w) = exp(w) exp(J_r dw).
 *
 *   w  as for chs_so3_exp.
 *   J  3x3; the identity at w = 0.
 *
 * The errors count as for chs_so3_exp; those of the inverses also relative to max(1, (theta/2)/|sin(theta/2)|), their
 * norm, which grows without bound near a multiple of 2 pi.
 * Returns as chs_so3_exp; the inverses also CHS_ERR_SINGULAR where theta is within 8 eps theta of a multiple of 2 pi
 * other than 0, so that the rounding of w alone decides the result. */
#define CHS_EPS_SO3_LEFT_JACOBIAN 1.5
#define CHS_EPS_SO3_LEFT_JACOBIAN_BEYOND 2.0
#define CHS_EPS_SO3_RIGHT_JACOBIAN 1.5
#define CHS_EPS_SO3_RIGHT_JACOBIAN_BEYOND 2.0
#define CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE 1.5
#define CHS_EPS_SO3_LEFT_JACOBIAN_INVERSE_BEYOND 4.0
#define CHS_EPS_SO3_RIGHT_JACOBIAN_INVERSE 1.5
#define CHS_EPS_SO3_RIGHT_JACOBIAN_INVERSE_BEYOND 4.0
int chs_so3_left_jacobian(const double w[3], double J[9]);
int chs_so3_left_jacobianf(const float w[3], float J[9]);
int chs_so3_right_jacobian(const double w[3], double J[9]);
int chs_so3_right_jacobianf(const float w[3], float J[9]);
int chs_so3_left_jacobian_inverse(const double w[3], double J[9]);
int chs_so3_left_jacobian_inversef(const float w[3], float J[9]);
int chs_so3_right_jacobian_inverse(const double w[3], double J[9]);
int chs_so3_right_jacobian_inversef(const float w[3], float J[9]);

/* C = A B, for any 3x3 matrices. The error is relative to |A| |B|, Frobenius norms. */
#define CHS_EPS_SO3_MULTIPLY 2.0
void chs_so3_multiply(const double A[9], const double B[9], double C[9]);
void chs_so3_multiplyf(const float A[9], const float B[9], float C[9]);

/* B = A^T, the inverse of a rotation. Exact. */
#define CHS_EPS_SO3_TRANSPOSE 0.0
void chs_so3_transpose(const double A[9], double B[9]);
void chs_so3_transposef(const float A[9], float B[9]);

/* y = R x. The error is relative to |R| |x|. */
#define CHS_EPS_SO3_APPLY 2.0
void chs_so3_apply(const double R[9], const double x[3], double y[3]);
void chs_so3_applyf(const float R[9], const float x[3], float y[3]);

/* The angle in [0, pi] of the rotation A^T B, the bi-invariant distance of two orientations:
 *
 *   angle = atan2(|s|, trace(A^T B) - 1),  s = sum over the columns a_k x b_k
 *
 * The error is relative to |B - A|, Frobenius, which is 2 sqrt(2) sin(angle/2) for rotations, down to the smallest: s
 * is formed from the differences b_k - a_k, which are exact for near orientations. (An arccos of the trace has no digit
 * left below 1e-8 rad in double.) Where drift sets the matrices apart by more than the angle does, it is the drift.
 * Returns CHS_OK and what CHS_SO3_FAR says, of either matrix. */
#define CHS_EPS_SO3_ANGLE 5.0
int chs_so3_angle(const double A[9], const double B[9], double *angle);
int chs_so3_anglef(const float A[9], const float B[9], float *angle);

/* The rotation nearest to M in the Frobenius norm, that is, its orthogonal polar factor (Higham 1986).
 *
 *   M         any finite 3x3 matrix with det M >= 0 and rank at least 2, of any size: a drifted rotation as well as a
 *             correlation matrix of points in a plane.
 *   R         the rotation.
 *   distance  |M - R|, Frobenius; may be NULL.
 *
 * With singular values s1 >= s2 >= s3 of M, the error of R is relative to the condition number 2 s1/(s2 + s3), which is
 * 1 for a rotation; that of the distance to |M| + |R|.
 * Returns CHS_OK; CHS_ERR_NAN; CHS_ERR_INFINITE; CHS_ERR_REFLECTION where det M < 0; CHS_ERR_SINGULAR where the rank is
 * less than 2 to within rounding; CHS_ERR_OVERFLOW where the distance is beyond the format. */
#define CHS_EPS_SO3_NEAREST_ROTATION 3.0
#define CHS_EPS_SO3_NEAREST_DISTANCE 4.0
int chs_so3_nearest(const double M[9], double R[9], double *distance);
int chs_so3_nearestf(const float M[9], float R[9], float *distance);

/* The deviation of R from a rotation, as defined at CHS_SO3_FAR. The error is relative to max(1, |R|^2).
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW. */
#define CHS_EPS_SO3_DEVIATION 4.0
int chs_so3_deviation(const double R[9], double *deviation);
int chs_so3_deviationf(const float R[9], float *deviation);

/* Is R a rotation, to within a deviation (CHS_SO3_FAR) of at most `tolerance`?
 * Returns CHS_OK, or why not: CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_REFLECTION, CHS_ERR_NOT_ROTATION. */
int chs_so3_check(const double R[9], double tolerance);
int chs_so3_checkf(const float R[9], float tolerance);

/* The rotation at which three equations hold, by Newton's method: the direct kinematics of a spherical robot that has
 * no closed form, for one. The derivatives with respect to small turns, exp [w] R, are central differences; a step
 * turns by at most 1/2 rad, and is halved until it comes nearer.
 *
 *   residual   writes f(R), three numbers, and returns a chs_status; an error of it shortens the step
 *              that led there; at the start and in the derivatives it ends the search and is returned.
 *   context    is handed to it.
 *   start      a rotation to within CHS_SO3_FAR. Where chs_so3_deviation of it is above 4 eps the rotation nearest to
 *              it takes its place. The solution found is that of its neighbourhood, not always the nearest.
 *   tolerance  |f| that counts as solved, >= 0.
 *   limit      the most steps, >= 0. A step calls the residual 7 to 14 times.
 *   R          the rotation; its chs_so3_deviation is at most 4 eps.
 *   rest       |f| at it; may be NULL.
 *
 * The error of R is what the tolerance and the residual's own errors leave open, times the norm of the inverse of the
 * derivatives; the promise is for a norm of 1, a tolerance of 8 eps and residuals within 2 eps.
 * Returns CHS_OK; CHS_ITERATION_LIMIT where no step left, or none to be found, brings |f| down to the tolerance, with
 * the best R so far; CHS_ERR_SINGULAR where the derivatives leave a turn open; CHS_ERR_ARGUMENT; CHS_ERR_NAN and
 * CHS_ERR_INFINITE also where f at the start is such; what CHS_SO3_FAR says; and the residual's errors. */
#define CHS_EPS_SO3_SOLVE 12.0
typedef int chs_so3_residual(const double R[9], void *context, double f[3]);
typedef int chs_so3_residualf(const float R[9], void *context, float f[3]);
int chs_so3_solve(chs_so3_residual *residual, void *context, const double start[9], double tolerance, int limit,
                  double R[9], double *rest);
int chs_so3_solvef(chs_so3_residualf *residual, void *context, const float start[9], float tolerance, int limit,
                   float R[9], float *rest);

#ifdef __cplusplus
}
#endif

#endif
