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

#ifdef __cplusplus
}
#endif

#endif
