/* chasles/se3.h - poses, twists and wrenches.
 *
 * A pose T is double[16] or float[16], row-major, [R p; 0 1]. Functions that take a pose never read its last row, and
 * functions that give one always write it. T_ab is the pose of frame b in frame a: it takes coordinates in b to
 * coordinates in a. A twist V is (omega; v), a wrench F is (moment; force), each of 6 entries, so that power is V . F.
 * chasles.h has the conventions that all headers share. Norms of matrices are Frobenius norms.
 */
#ifndef CHASLES_SE3_H
#define CHASLES_SE3_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* T = [R p; 0 1] from its parts, and back. Exact. */
#define CHS_EPS_SE3_FROM_PARTS 0.0
#define CHS_EPS_SE3_TO_PARTS 0.0
void chs_se3_from_parts(const double R[9], const double p[3], double T[16]);
void chs_se3_from_partsf(const float R[9], const float p[3], float T[16]);
void chs_se3_to_parts(const double T[16], double R[9], double p[3]);
void chs_se3_to_partsf(const float T[16], float R[9], float p[3]);

/* C = A B, so that T_ac = T_ab T_bc. The error of the rotation is relative to |R_A| |R_B|, that of the translation to
 * |R_A| |p_B| + |p_A|. */
#define CHS_EPS_SE3_COMPOSE_ROTATION 2.0
#define CHS_EPS_SE3_COMPOSE_TRANSLATION 2.0
void chs_se3_compose(const double A[16], const double B[16], double C[16]);
void chs_se3_composef(const float A[16], const float B[16], float C[16]);

/* B = [R^T, -R^T p; 0 1], the inverse of a pose. The rotation is exact; the error of the translation is relative to
 * |R| |p|. */
#define CHS_EPS_SE3_INVERSE_ROTATION 0.0
#define CHS_EPS_SE3_INVERSE_TRANSLATION 2.0
void chs_se3_inverse(const double A[16], double B[16]);
void chs_se3_inversef(const float A[16], float B[16]);

/* y = R x + p, for one point. The error is relative to |R| |x| + |p|. */
#define CHS_EPS_SE3_APPLY 2.0
void chs_se3_apply(const double T[16], const double x[3], double y[3]);
void chs_se3_applyf(const float T[16], const float x[3], float y[3]);

/* T = exp [V]: R = exp [omega], p = J_l(omega) v with the left Jacobian of so3.h. The finite motion along a screw: with
 * V = S theta it is the exponential of Lynch & Park and of Murray, Li & Sastry, G(theta) v of the product of
 * exponentials.
 *
 *   V  (omega; v): omega as for chs_so3_exp, v any vector for which |omega| |v| is within the format.
 *   T  the pose; V = 0 gives the identity exactly.
 *
 * The error of the rotation counts as for chs_so3_exp; that of the translation is relative to |p| up to theta = pi and
 * to |v| beyond, where p itself may vanish.
 * Returns as chs_so3_exp, and CHS_ERR_OVERFLOW. */
#define CHS_EPS_SE3_EXP_ROTATION 2.0
#define CHS_EPS_SE3_EXP_ROTATION_BEYOND 4.0
#define CHS_EPS_SE3_EXP_TRANSLATION 4.0
#define CHS_EPS_SE3_EXP_TRANSLATION_BEYOND 5.0
int chs_se3_exp(const double V[6], double T[16]);
int chs_se3_expf(const float V[6], float T[16]);

/* V = log T, (omega; v) with omega = log R as chs_so3_log gives it, half-turns included, and v = J_l(omega)^-1 p.
 *
 *   T  a pose whose rotation is one to within CHS_SO3_FAR.
 *
 * The errors are relative to |omega| and to |v|.
 * Returns as chs_so3_log, and CHS_ERR_OVERFLOW. */
#define CHS_EPS_SE3_LOG_ROTATION_VECTOR 2.0
#define CHS_EPS_SE3_LOG_TRANSLATION 5.0
int chs_se3_log(const double T[16], double V[6]);
int chs_se3_logf(const float T[16], float V[6]);

/* Ad(T) = [R 0; [p]R R] and Ad(T)^-1 = Ad(T^-1) = [R^T 0; -R^T[p] R^T], 6x6, row-major. The error is relative to
 * |R| (1 + |p|). */
#define CHS_EPS_SE3_ADJOINT 2.0
#define CHS_EPS_SE3_ADJOINT_INVERSE 2.0
void chs_se3_adjoint(const double T[16], double Ad[36]);
void chs_se3_adjointf(const float T[16], float Ad[36]);
void chs_se3_adjoint_inverse(const double T[16], double Ad[36]);
void chs_se3_adjoint_inversef(const float T[16], float Ad[36]);

/* A twist changes its frame: U = Ad(T) V takes V_b to V_a with T = T_ab, the inverse takes V_a to V_b. The error is
 * relative to |R| (1 + |p|) |V|. */
#define CHS_EPS_SE3_ADJOINT_TWIST 2.0
#define CHS_EPS_SE3_ADJOINT_INVERSE_TWIST 2.0
void chs_se3_adjoint_twist(const double T[16], const double V[6], double U[6]);
void chs_se3_adjoint_twistf(const float T[16], const float V[6], float U[6]);
void chs_se3_adjoint_inverse_twist(const double T[16], const double V[6], double U[6]);
void chs_se3_adjoint_inverse_twistf(const float T[16], const float V[6], float U[6]);

/* A wrench changes its frame by the transpose of the inverse adjoint, so that the power V . F is the same in both:
 * G = Ad(T)^-T F takes F_b to F_a with T = T_ab, the inverse, G = Ad(T)^T F, takes F_a to F_b. (Lecture notes that
 * print the adjoint itself have the force first and the twist's halves in the other order.) The error is relative to
 * |R| (1 + |p|) |F|. */
#define CHS_EPS_SE3_ADJOINT_WRENCH 2.0
#define CHS_EPS_SE3_ADJOINT_INVERSE_WRENCH 2.0
void chs_se3_adjoint_wrench(const double T[16], const double F[6], double G[6]);
void chs_se3_adjoint_wrenchf(const float T[16], const float F[6], float G[6]);
void chs_se3_adjoint_inverse_wrench(const double T[16], const double F[6], double G[6]);
void chs_se3_adjoint_inverse_wrenchf(const float T[16], const float F[6], float G[6]);

/* M = [V] = [[omega] v; 0 0], the 4x4 matrix of a twist or a screw axis, and back. hat is exact; vee takes the skew-
 * symmetric part of the upper block as chs_so3_vee does, not the last row, and is exact where hat was before. */
#define CHS_EPS_SE3_HAT 0.0
#define CHS_EPS_SE3_VEE 0.0
void chs_se3_hat(const double V[6], double M[16]);
void chs_se3_hatf(const float V[6], float M[16]);
void chs_se3_vee(const double M[16], double V[6]);
void chs_se3_veef(const float M[16], float V[6]);

/* ad(V) = [[omega] 0; [v] [omega]], 6x6, row-major: d/dt Ad(exp(V t)) at t = 0. Exact.
 * ad(V) U, the Lie bracket of two twists, and ad(V)^T F, the rate of change of a momentum (so that (ad(V) U) . F =
 * U . (ad(V)^T F)). Their errors are relative to |V| |U| and |V| |F|. */
#define CHS_EPS_SE3_AD 0.0
#define CHS_EPS_SE3_AD_TWIST 2.0
#define CHS_EPS_SE3_AD_WRENCH 2.0
void chs_se3_ad(const double V[6], double ad[36]);
void chs_se3_adf(const float V[6], float ad[36]);
void chs_se3_ad_twist(const double V[6], const double U[6], double W[6]);
void chs_se3_ad_twistf(const float V[6], const float U[6], float W[6]);
void chs_se3_ad_wrench(const double V[6], const double F[6], double G[6]);
void chs_se3_ad_wrenchf(const float V[6], const float F[6], float G[6]);

/* The twist of a moving pose T = T_sb, from T and its rate dT (of which, as of T, the last row is not read):
 *
 *   body   V_b: [V_b] = T^-1 dT, that is, [omega_b] = R^T dR, v_b = R^T dp
 *   space  V_s: [V_s] = dT T^-1, that is, [omega_s] = dR R^T, v_s = dp - omega_s x p
 *
 * V_s = Ad(T) V_b: chs_se3_adjoint_inverse_twist takes the one to the other. Of R^T dR the skew-symmetric part
 * counts.
 *
 * The error of omega is relative to |dR|, that of v_b to |dp|, and that of v_s to |dp| + |dR| |p|.
 * Returns CHS_OK, CHS_ERR_OVERFLOW, and what CHS_SO3_FAR says, for the other entries as well. */
#define CHS_EPS_SE3_BODY_TWIST_ROTATION 2.0
#define CHS_EPS_SE3_BODY_TWIST_TRANSLATION 3.0
#define CHS_EPS_SE3_SPACE_TWIST_ROTATION 2.0
#define CHS_EPS_SE3_SPACE_TWIST_TRANSLATION 3.0
int chs_se3_body_twist(const double T[16], const double dT[16], double V[6]);
int chs_se3_body_twistf(const float T[16], const float dT[16], float V[6]);
int chs_se3_space_twist(const double T[16], const double dT[16], double V[6]);
int chs_se3_space_twistf(const float T[16], const float dT[16], float V[6]);

/* The constant twist that takes a body from pose A to pose B within a time of dt, by less than a turn:
 *
 *   body   log(A^-1 B)/dt,  space  log(B A^-1)/dt = Ad(A) log(A^-1 B)/dt
 *
 *   A, B  poses whose rotations are such to within CHS_SO3_FAR; the product is read as chs_so3_log reads a matrix.
 *   dt    any time but 0; a negative one turns the twist round.
 *
 * Rotations that are near each other are subtracted before they are multiplied, so that also where the body hardly
 * turned the error of omega dt is relative to |R_B - R_A|, which is 2 sqrt(2) sin(theta/2) for rotations by theta. That
 * of v_b is relative to |v_b|, that of v_s dt to |v_b dt| + |R_B - R_A| |p_A|.
 * Returns CHS_OK; CHS_HALF_TURN as chs_so3_log; CHS_ERR_OVERFLOW; CHS_ERR_ARGUMENT where dt = 0; and what CHS_SO3_FAR
 * says, for the other numbers as well. */
#define CHS_EPS_SE3_BODY_TWIST_BETWEEN_ROTATION 4.0
#define CHS_EPS_SE3_BODY_TWIST_BETWEEN_TRANSLATION 6.0
#define CHS_EPS_SE3_SPACE_TWIST_BETWEEN_ROTATION 5.0
#define CHS_EPS_SE3_SPACE_TWIST_BETWEEN_TRANSLATION 6.0
int chs_se3_body_twist_between(const double A[16], const double B[16], double dt, double V[6]);
int chs_se3_body_twist_betweenf(const float A[16], const float B[16], float dt, float V[6]);
int chs_se3_space_twist_between(const double A[16], const double B[16], double dt, double V[6]);
int chs_se3_space_twist_betweenf(const float A[16], const float B[16], float dt, float V[6]);

/* The pose at the share s of the way from A to B along the screw that joins them, at constant twist:
 *
 *   T = A exp(s log(A^-1 B)), which is B exp((s - 1) log(A^-1 B)), used beyond s = 1/2
 *
 *   s  any number: 0 gives A and 1 gives B, exactly, save the sign of a zero; others go on along the same screw.
 *
 * With log(A^-1 B) = (omega; v) and r the smaller of |s| and |s - 1| (|s - 1| for s > 1/2), the error of the rotation
 * is relative to max(1, r |omega|), that of the translation to max(1, r |omega|) (|p| + r |v|), p that of the nearer
 * end.
 * Returns CHS_OK; CHS_HALF_TURN where A and B are a half-turn apart, so that the screw's sense is a convention;
 * CHS_ERR_ANGLE_RANGE where s takes it beyond CHS_ANGLE_MAX(F); CHS_ERR_OVERFLOW; what CHS_SO3_FAR says, for the other
 * numbers as well. */
#define CHS_EPS_SE3_INTERPOLATE_ROTATION 5.0
#define CHS_EPS_SE3_INTERPOLATE_TRANSLATION 8.0
int chs_se3_interpolate(const double A[16], const double B[16], double s, double T[16]);
int chs_se3_interpolatef(const float A[16], const float B[16], float s, float T[16]);

/* How far two poses are apart: the angle of A^-1 B, chs_so3_angle, and the distance of their origins. There is no
 * distance of poses without a length that tells how much a radian counts; the weighted one is
 * sqrt((scale angle)^2 + length^2), with scale for instance the size of the tool.
 *
 *   scale  at least 0.
 *
 * The error of the angle is relative to |R_B - R_A|, which is 2 sqrt(2) sin(angle/2) for rotations, that of the length
 * to itself, that of the weighted distance to sqrt((scale |R_B - R_A|)^2 + length^2).
 * Returns CHS_OK; CHS_ERR_OVERFLOW; CHS_ERR_ARGUMENT where the scale is negative; what CHS_SO3_FAR says, for the other
 * numbers as well. */
#define CHS_EPS_SE3_DISTANCE_ANGLE 5.0
#define CHS_EPS_SE3_DISTANCE_LENGTH 3.0
#define CHS_EPS_SE3_WEIGHTED_DISTANCE 6.0
int chs_se3_distance(const double A[16], const double B[16], double *angle, double *length);
int chs_se3_distancef(const float A[16], const float B[16], float *angle, float *length);
int chs_se3_weighted_distance(const double A[16], const double B[16], double scale, double *distance);
int chs_se3_weighted_distancef(const float A[16], const float B[16], float scale, float *distance);

/* The left and right Jacobians of the exponential of poses, and their inverses, 6x6, row-major. With J, a, b, c, k, d
 * of so3.h, t = theta^2 and each derivative taken by t,
 *
 *   J_l(V)    = [J 0; Q J],         Q = b [v] + c (v w^T + w v^T) + 2 (w.v) (a' I + b' [w] + c' w w^T)
 *   J_l^-1(V) = [J^-1 0; P J^-1],   P = -[v]/2 + d (v w^T + w v^T) + 2 (w.v) (k' I + d' w w^T)
 *   J_r(V) = J_l(-V),  J_r^-1(V) = J_l^-1(-V)
 *
 * where w = omega: Q is the derivative of J along v. To first order in dV, exp(V + dV) = exp(J_l dV) exp(V) =
 * exp(V) exp(J_r dV).
 *
 *   V  as for chs_se3_exp.
 *   J  the identity at V = 0.
 *
 * The errors of both J are those of so3.h; that of the coupling Q is relative to |v| or, for P, to |v| g^2 with g =
 * max(1, (theta/2)/|sin(theta/2)|).
 * Returns as the Jacobians of so3.h, and CHS_ERR_OVERFLOW. */
#define CHS_EPS_SE3_LEFT_JACOBIAN_COUPLING 3.0
#define CHS_EPS_SE3_LEFT_JACOBIAN_COUPLING_BEYOND 3.0
#define CHS_EPS_SE3_RIGHT_JACOBIAN_COUPLING 3.0
#define CHS_EPS_SE3_RIGHT_JACOBIAN_COUPLING_BEYOND 3.0
#define CHS_EPS_SE3_LEFT_JACOBIAN_INVERSE_COUPLING 2.0
#define CHS_EPS_SE3_LEFT_JACOBIAN_INVERSE_COUPLING_BEYOND 2.0
#define CHS_EPS_SE3_RIGHT_JACOBIAN_INVERSE_COUPLING 2.0
#define CHS_EPS_SE3_RIGHT_JACOBIAN_INVERSE_COUPLING_BEYOND 2.0
int chs_se3_left_jacobian(const double V[6], double J[36]);
int chs_se3_left_jacobianf(const float V[6], float J[36]);
int chs_se3_right_jacobian(const double V[6], double J[36]);
int chs_se3_right_jacobianf(const float V[6], float J[36]);
int chs_se3_left_jacobian_inverse(const double V[6], double J[36]);
int chs_se3_left_jacobian_inversef(const float V[6], float J[36]);
int chs_se3_right_jacobian_inverse(const double V[6], double J[36]);
int chs_se3_right_jacobian_inversef(const float V[6], float J[36]);

#ifdef __cplusplus
}
#endif

#endif
