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
#define CHS_EPS_SCREW_TO_POSE_TRANSLATION 5.0
int chs_screw_to_pose(const chs_screw *screw, double T[16]);
int chs_screw_to_posef(const chs_screwf *screw, float T[16]);

/* The pitch u/theta, in units of length a radian, rounded once.
 * Returns CHS_OK; CHS_PURE_TRANSLATION with a pitch of plus or minus infinity, by the sign of u; CHS_NO_MOTION with 0;
 * CHS_ERR_NAN and CHS_ERR_INFINITE, of u and theta; CHS_ERR_OVERFLOW. */
#define CHS_EPS_SCREW_PITCH 1.0
int chs_screw_pitch(const chs_screw *screw, double *pitch);
int chs_screw_pitchf(const chs_screwf *screw, float *pitch);

/* A screw axis S is double[6] or float[6], (omega; v), the twist of a unit rate along the screw: of a turn by one
 * radian a unit of time about its axis or, where omega = 0 and the pitch is infinite, of a travel by one. In the
 * parameters {q, s, h} of Lynch & Park, a point q, the unit direction s and the pitch h, the length of travel a radian,
 *
 *   S = (s; q x s + h s),  or (0; s) where h is infinite (-s where it is minus infinity).
 *
 * S theta, with an angle or a length, is what chs_se3_exp takes, S times a rate is a twist, and the frame of S is
 * changed by chs_se3_adjoint_twist. A revolute joint is a screw of pitch 0, a helical joint one of pitch h, a
 * prismatic joint one of infinite pitch.
 *
 *   q  a point of the axis.
 *   s  its direction, of any length but 0.
 *   h  any pitch, infinite ones included.
 *
 * The error of omega is absolute, that of v relative to |q| + |h|, for prismatic ones absolute.
 * Returns CHS_OK; CHS_PURE_TRANSLATION where h is infinite; CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW;
 * CHS_ERR_SINGULAR where s = 0. */
#define CHS_EPS_SCREW_HELICAL_ROTATION 2.0
#define CHS_EPS_SCREW_HELICAL_TRANSLATION 3.0
int chs_screw_helical(const double q[3], const double s[3], double h, double S[6]);
int chs_screw_helicalf(const float q[3], const float s[3], float h, float S[6]);

#define CHS_EPS_SCREW_REVOLUTE_ROTATION 2.0
#define CHS_EPS_SCREW_REVOLUTE_TRANSLATION 3.0
int chs_screw_revolute(const double q[3], const double s[3], double S[6]);
int chs_screw_revolutef(const float q[3], const float s[3], float S[6]);

#define CHS_EPS_SCREW_PRISMATIC_ROTATION 0.0
#define CHS_EPS_SCREW_PRISMATIC_TRANSLATION 2.0
int chs_screw_prismatic(const double s[3], double S[6]);
int chs_screw_prismaticf(const float s[3], float S[6]);

/* {q, s, h} of a screw axis, or of any twist along it: the point nearest to the origin, q = omega x v/|omega|^2, the
 * direction s = omega/|omega| and the pitch h = omega.v/|omega|^2. Where omega = 0, q = 0, s = v/|v| and h is plus
 * infinity. The error of s is absolute; those of q and h are relative to |v|/|omega|.
 * Returns CHS_OK; CHS_PURE_TRANSLATION; CHS_ERR_NAN; CHS_ERR_INFINITE; CHS_ERR_OVERFLOW where |v|/|omega| is beyond the
 * format; CHS_ERR_SINGULAR where S = 0. */
#define CHS_EPS_SCREW_AXIS_PARTS_POINT 5.0
#define CHS_EPS_SCREW_AXIS_PARTS_DIRECTION 2.0
#define CHS_EPS_SCREW_AXIS_PARTS_PITCH 4.0
int chs_screw_axis_parts(const double S[6], double q[3], double s[3], double *h);
int chs_screw_axis_partsf(const float S[6], float q[3], float s[3], float *h);

/* The pitch alone. Returns as chs_screw_axis_parts. */
#define CHS_EPS_SCREW_AXIS_PITCH 4.0
int chs_screw_axis_pitch(const double S[6], double *h);
int chs_screw_axis_pitchf(const float S[6], float *h);

/* The axis as a line of line.h, (s; q x s). The error of s is absolute, that of the moment relative to |v|/|omega|.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW, and CHS_ERR_SINGULAR where omega = 0. */
#define CHS_EPS_SCREW_AXIS_LINE_DIRECTION 2.0
#define CHS_EPS_SCREW_AXIS_LINE_MOMENT 4.0
int chs_screw_axis_line(const double S[6], double L[6]);
int chs_screw_axis_linef(const float S[6], float L[6]);

/* A twist as a screw axis and the rate along it, V = S rate: rate = |omega| or, where omega = 0, |v|. A rotation so
 * slow that |v|/|omega| is beyond the format's range counts as none. Without motion S is the travel along z and the
 * rate 0. The error of omega in S is absolute, that of v relative to |v|, that of the rate to itself.
 * Returns CHS_OK, CHS_PURE_TRANSLATION, CHS_NO_MOTION, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW. */
#define CHS_EPS_SCREW_NORMALIZE_ROTATION 2.0
#define CHS_EPS_SCREW_NORMALIZE_TRANSLATION 3.0
#define CHS_EPS_SCREW_NORMALIZE_RATE 2.0
int chs_screw_normalize(const double V[6], double S[6], double *rate);
int chs_screw_normalizef(const float V[6], float S[6], float *rate);

/* V = S rate, each entry rounded once. The error is relative to |V|. */
#define CHS_EPS_SCREW_TWIST 1.0
void chs_screw_twist(const double S[6], double rate, double V[6]);
void chs_screw_twistf(const float S[6], float rate, float V[6]);

/* The reciprocal product of two screws, omega_a . v_b + v_a . omega_b: 0 where the one, as a wrench (v; omega), does no
 * work on the other. For two lines it is minus the sine of their angle times their distance, so 0 where they meet. The
 * error is relative to |omega_a| |v_b| + |v_a| |omega_b|. */
#define CHS_EPS_SCREW_RECIPROCAL 3.0
void chs_screw_reciprocal(const double A[6], const double B[6], double *product);
void chs_screw_reciprocalf(const float A[6], const float B[6], float *product);

/* Where a body at T comes to by moving along a screw by theta, an angle or, for infinite pitch, a length: T exp([S]
 * theta) with S in the body frame, exp([S] theta) T with S in the space frame.
 *
 *   T      a pose whose rotation is one to within CHS_SO3_FAR.
 *   S      a screw axis, or any twist.
 *   theta  such that |omega theta| is at most CHS_ANGLE_MAX(F).
 *
 * With a = max(1, |omega theta|), what the rounding of S theta comes to, the error of the rotation is relative to a,
 * that of the translation to a (|p| + |v theta|).
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE, CHS_ERR_OVERFLOW, and what CHS_SO3_FAR says. */
#define CHS_EPS_SCREW_MOVE_ROTATION 4.0
#define CHS_EPS_SCREW_MOVE_TRANSLATION 5.0
int chs_screw_move_body(const double T[16], const double S[6], double theta, double moved[16]);
int chs_screw_move_bodyf(const float T[16], const float S[6], float theta, float moved[16]);
int chs_screw_move_space(const double T[16], const double S[6], double theta, double moved[16]);
int chs_screw_move_spacef(const float T[16], const float S[6], float theta, float moved[16]);

#ifdef __cplusplus
}
#endif

#endif
