/* chasles/chain.h - serial chains as products of exponentials: kinematics forward and inverse, Jacobians, statics.
 *
 * The methods are those of Brockett 1984 and of Lynch & Park, Modern Robotics (2017), chapters 4 to 6. A joint is its
 * screw axis S = (omega; v), three numbers each, at q = 0:
 *
 *   revolute   omega a unit vector along the axis, v = a x omega with a any point of the axis; q an angle
 *   helical    the same and h omega added to v, with h the pitch, a length a radian; q an angle
 *   prismatic  omega = 0, v a unit vector in the direction of travel; q a length
 *
 * An omega whose square is 1 to within 8 eps is read as the unit vector it was rounded from, S/|omega|. Any other
 * length of omega, and any of v where omega = 0, is a gear ratio: the joint moves by exp([S] q) as it stands.
 *
 * Matrices of a chain of n joints are row-major: a Jacobian J is double[6*n], J[n*i + j] row i, column j. Outputs may
 * overlap joint values, twists and wrenches, but neither the chain and its arrays, nor J, nor scratch memory.
 * chasles.h has the conventions that all headers share.
 *
 * The reach of a chain at q, to which errors of lengths are relative, is |p| of the home pose plus, for each joint,
 * the distance of its axis from the origin of the frame in which it is given plus |h| max(1, |q|), or |v| max(1, |q|)
 * for a prismatic one.
 */
#ifndef CHASLES_CHAIN_H
#define CHASLES_CHAIN_H

#include <chasles/status.h>

#ifdef __cplusplus
extern "C" {
#endif

/* In which frame the screw axes are given, with M the home pose, that of the tool at q = 0:
 *
 *   CHS_SPACE_FORM  T(q) = exp([S_1] q_1) ... exp([S_n] q_n) M   in the fixed frame
 *   CHS_BODY_FORM   T(q) = M exp([B_1] q_1) ... exp([B_n] q_n)   in the tool's frame at q = 0, B = Ad(M)^-1 S: see
 *                                                                chs_se3_adjoint_inverse_twist */
typedef enum chs_chain_form { CHS_SPACE_FORM = 0, CHS_BODY_FORM = 1 } chs_chain_form;

typedef struct chs_chain {
  int joints;           /* n, at least 1 */
  chs_chain_form form;  /* of the screws */
  const double *screws; /* [6*n], one screw axis after the other, from the fixed end to the tool */
  double home[16];      /* the tool's pose at q = 0; read as it stands, its last row not at all */
  const double *limits; /* [2*n], the least and the greatest value of each joint; NULL: no limits */
} chs_chain;

typedef struct chs_chainf {
  int joints;
  chs_chain_form form;
  const float *screws;
  float home[16];
  const float *limits;
} chs_chainf;

/* T = T(q), the pose of the tool.
 *
 *   q  [n], angles up to CHS_ANGLE_MAX(F) in size, and lengths.
 *
 * The errors are those of each joint: the promise counts n times. That of the rotation is absolute, that of the
 * translation relative to the reach, for a home pose that is a rotation and a translation; a joint whose omega is
 * neither a unit vector nor 0 counts |omega q| times where that is more than 1.
 * Returns CHS_OK; CHS_ERR_ARGUMENT where n < 1 or the form is none; CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE
 * and CHS_ERR_OVERFLOW. */
#define CHS_EPS_CHAIN_FK_ROTATION 4.0
#define CHS_EPS_CHAIN_FK_TRANSLATION 8.0
int chs_chain_fk(const chs_chain *chain, const double *q, double T[16]);
int chs_chain_fkf(const chs_chainf *chain, const float *q, float T[16]);

/* The displacement of every link from where it is at q = 0, in the fixed frame: D_i = exp([S_1] q_1) ... exp([S_i] q_i)
 * for link i, the one that joint i moves. Whatever is fixed to the link and has the pose M_i at q = 0 has the pose
 * D_i M_i, and the tool has D_n M.
 *
 *   D  [16*n], one pose after the other.
 *
 * Errors as for chs_chain_fk; in the body form, where D_i = T_i M^-1, that of the translation is relative to the reach
 * plus |p| of M.
 * Returns as chs_chain_fk. */
#define CHS_EPS_CHAIN_LINKS_ROTATION 4.0
#define CHS_EPS_CHAIN_LINKS_TRANSLATION 8.0
int chs_chain_links(const chs_chain *chain, const double *q, double *D);
int chs_chain_linksf(const chs_chainf *chain, const float *q, float *D);

/* The Jacobian V = J qdot: the twist of the tool in the fixed frame (space) or in its own (body), for the rates of the
 * joints. Column i is Ad(T_i) S_i, with T_i what the joints before i do, and Ad(T)^-1 of that; S_i as it stands, so that
 * a column is as long or short as rounding made its axis.
 *
 *   J  [6*n], row-major, of 6 rows.
 *   T  the pose as from chs_chain_fk; may be NULL.
 *
 * Errors as for chs_chain_fk: those of the first three rows are absolute, those of the last three relative to the
 * reach, both times the largest |omega| where that is a gear ratio above 1.
 * Returns as chs_chain_fk. */
#define CHS_EPS_CHAIN_SPACE_JACOBIAN_ANGULAR 4.0
#define CHS_EPS_CHAIN_SPACE_JACOBIAN_LINEAR 8.0
#define CHS_EPS_CHAIN_BODY_JACOBIAN_ANGULAR 4.0
#define CHS_EPS_CHAIN_BODY_JACOBIAN_LINEAR 12.0
int chs_chain_space_jacobian(const chs_chain *chain, const double *q, double *J, double T[16]);
int chs_chain_space_jacobianf(const chs_chainf *chain, const float *q, float *J, float T[16]);
int chs_chain_body_jacobian(const chs_chain *chain, const double *q, double *J, double T[16]);
int chs_chain_body_jacobianf(const chs_chainf *chain, const float *q, float *J, float T[16]);

/* tau = J^T F, the torques (forces, of prismatic joints) that hold the wrench F = (moment; force) which the tool
 * exerts, and V = J qdot. J, F and V are of one frame, fixed or the tool's.
 *
 * The error of each torque is relative to |J| |F|, that of the twist to n |J| |qdot|. */
#define CHS_EPS_CHAIN_TORQUES 4.0
#define CHS_EPS_CHAIN_TWIST 1.0
void chs_chain_torques(int joints, const double *J, const double F[6], double *torques);
void chs_chain_torquesf(int joints, const float *J, const float F[6], float *torques);
void chs_chain_twist(int joints, const double *J, const double *rates, double V[6]);
void chs_chain_twistf(int joints, const float *J, const float *rates, float V[6]);

/* How many numbers of scratch memory the functions below need for n joints. What it holds does not matter. */
#define CHS_CHAIN_SCRATCH(n) (7 * ((n) > 6 ? (n) : 6))

/* The singular values of J, by one-sided Jacobi rotations of its rows, or of its columns where n <= 6.
 *
 *   length   a characteristic length, above 0, by which the last three rows are divided first: they are lengths a
 *            radian where the first three are numbers, so that singular values, rank, manipulability and condition
 *            number depend on the unit of length. 1 leaves J as it is.
 *   scratch  [CHS_CHAIN_SCRATCH(n)]
 *   sigma    in descending order; the last 6 - n are 0 where n < 6.
 *
 * The errors are relative to sigma[0].
 * Returns CHS_OK; CHS_ERR_ARGUMENT where n < 1 or not length > 0; CHS_ERR_NAN, CHS_ERR_INFINITE; CHS_ERR_OVERFLOW. */
#define CHS_EPS_CHAIN_SINGULAR_VALUES 16.0
int chs_chain_singular_values(int joints, const double *J, double length, double *scratch, double sigma[6]);
int chs_chain_singular_valuesf(int joints, const float *J, float length, float *scratch, float sigma[6]);

/* The rank of J: how many singular values are above 8 max(n, 6) eps sigma[0], which is what the rounding errors of a
 * Jacobian may amount to. Arguments and answers as above. */
int chs_chain_rank(int joints, const double *J, double length, double *scratch, int *rank);
int chs_chain_rankf(int joints, const float *J, float length, float *scratch, int *rank);

/* Yoshikawa's manipulability, sqrt(det(J J^T)), the product of the six singular values; where n < 6, sqrt(det(J^T J)),
 * that of the n. The error is relative to that product with its smallest factor replaced by the largest, and none of
 * the others counted for less than 16 eps sigma[0]. Arguments and answers as above. */
#define CHS_EPS_CHAIN_MANIPULABILITY 48.0
int chs_chain_manipulability(int joints, const double *J, double length, double *scratch, double *manipulability);
int chs_chain_manipulabilityf(int joints, const float *J, float length, float *scratch, float *manipulability);

/* The condition number of J, the largest over the smallest of its min(n, 6) singular values: 1 where the tool moves in
 * all directions alike. The error is relative to the square of it. Arguments and answers as above, and CHS_ERR_SINGULAR
 * where the rank is less than min(n, 6). */
#define CHS_EPS_CHAIN_CONDITION 16.0
int chs_chain_condition(int joints, const double *J, double length, double *scratch, double *condition);
int chs_chain_conditionf(int joints, const float *J, float length, float *scratch, float *condition);

/* det J of six joints, by elimination. The error is relative to the product of the lengths of the columns, which bounds
 * the determinant, as long as the product of any of them is within the format's normal range: the pivots are multiplied
 * as they come.
 * Returns CHS_OK, CHS_ERR_NAN, CHS_ERR_INFINITE, and CHS_ERR_OVERFLOW where a product of pivots, or the reciprocal of
 * one, is beyond the format. */
#define CHS_EPS_CHAIN_DETERMINANT 8.0
int chs_chain_determinant(const double J[36], double *determinant);
int chs_chain_determinantf(const float J[36], float *determinant);

/* The joint rates of a twist for six joints, J^-1 V, by elimination with row interchanges.
 *
 * The error is relative to |rates| times the condition number of J, where eps times that is well below 1.
 * Returns CHS_OK; CHS_ERR_SINGULAR where a column is a combination of those before it to within rounding, 64 eps of its
 * largest entry; CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_OVERFLOW. */
#define CHS_EPS_CHAIN_RATES_INVERSE 8.0
int chs_chain_rates_inverse(const double J[36], const double V[6], double *rates);
int chs_chain_rates_inversef(const float J[36], const float V[6], float *rates);

/* The joint rates J^+ V, by the pseudoinverse: of all that come nearest to the twist V the smallest. Singular values
 * that do not count for chs_chain_rank count as 0 here.
 *
 *   length, scratch  as above. Where J has rank 6 the length makes no difference; otherwise nearest means the smallest
 *                    |omega|^2 + |v / length|^2 of what is missing.
 *
 * With s the smallest singular value that counts the error is relative to sigma[0] |V| / s^2, V with v / length for v.
 * Returns CHS_OK; CHS_NEAR_SINGULAR where the rank is less than min(n, 6); and as above. */
#define CHS_EPS_CHAIN_RATES_PSEUDOINVERSE 12.0
int chs_chain_rates_pseudoinverse(int joints, const double *J, const double V[6], double length, double *scratch,
                                  double *rates);
int chs_chain_rates_pseudoinversef(int joints, const float *J, const float V[6], float length, float *scratch,
                                   float *rates);

/* The joint rates of damped least squares, J^T (J J^T + lambda^2 I)^-1 V: they stay below |V| / (2 lambda) also where J
 * is singular.
 *
 *   damping  lambda, above 0, in the unit of the singular values.
 *   near     0: lambda = damping at all times. Above 0: lambda follows the smallest of the min(n, 6) singular values,
 *            lambda^2 = damping^2 (1 - (sigma_min / near)^2) where that is below `near`, and no damping elsewhere
 *            (Nakamura & Hanafusa 1986, Chiaverini 1997).
 *
 * With s^2 = sigma_min^2 + lambda^2 the error is relative to sigma[0] |V| / s^2, times 1 + (damping / near)^2 where
 * lambda follows.
 * Returns CHS_OK; CHS_NEAR_SINGULAR where lambda follows and is not 0; CHS_ERR_ARGUMENT also for a damping that is not
 * above 0 or a `near` below 0; and as above. */
#define CHS_EPS_CHAIN_RATES_DAMPED 24.0
int chs_chain_rates_damped(int joints, const double *J, const double V[6], double length, double damping, double near,
                           double *scratch, double *rates);
int chs_chain_rates_dampedf(int joints, const float *J, const float V[6], float length, float damping, float near,
                            float *scratch, float *rates);

/* Inverse kinematics: joint values at which the tool has the pose T.
 *
 * The error of a pose is the rotation left, log(R_T R^T) by the exact logarithm, and the way left, p_T - p. Each step
 * solves J dq = error, J for the tool's own point: by elimination or the pseudoinverse (Newton-Raphson), or by damped
 * least squares with lambda = damping |error| (Chan & Lawrence 1988), the columns of J scaled to one length. A step
 * that does not bring the tool nearer, or would turn a joint by more than pi/2, is damped and tried again; where
 * nothing helps and a direction of J is lost, a motion of second order is tried along it. So no step does harm. In
 * |error| the two tolerances weigh the same: lengths are divided by length / angle, or by eps^(1/4) times the reach
 * where that is more, lest only lengths count. */
typedef enum chs_ik_method { CHS_IK_NEWTON = 0, CHS_IK_DAMPED = 1 } chs_ik_method;

typedef struct chs_ik {
  chs_ik_method method;
  double angle;   /* the rotation that may be left, in radians, above 0 */
  double length;  /* the distance that may be left, above 0 */
  double damping; /* above 0; 0.1 is a good choice, the smaller the bolder. CHS_IK_NEWTON does not read it */
  int steps;      /* the most steps of a search, at least 0 */
  int restarts;   /* how often a search that failed may start again elsewhere, at least 0 */
} chs_ik;

typedef struct chs_ikf {
  chs_ik_method method;
  float angle;
  float length;
  float damping;
  int steps;
  int restarts;
} chs_ikf;

/* How many numbers of scratch memory both functions need for n joints. What it holds does not matter. */
#define CHS_CHAIN_IK_SCRATCH(n) (24 * ((n) > 6 ? (n) : 6))

/* A search of up to `steps` steps from `start`, and up to `restarts` more from joint values around it, at first near
 * and then ever farther away, the same ones at every call (chs_chain_ik); or one step (chs_chain_ik_step), so that a
 * controller can spread a search over its cycles. A step costs at most 14 walks along the chain and one singular value
 * decomposition, and in the ordinary case two walks and one elimination.
 *
 *   T         the pose wanted, its rotation one to within CHS_SO3_FAR.
 *   start     [n] joint values to start from, brought within the limits first. They decide which of the solutions is
 *             found; one found after a restart may be any.
 *   scratch   [CHS_CHAIN_IK_SCRATCH(n)]
 *   q         [n] the joint values found, or else the best so far: within the limits, where a revolute joint whose
 *             range has room for it has turned by 2 pi more or less.
 *   residual  {angle, length}, what is left at q; may be NULL.
 *
 * CHS_OK means that the residual, from q as chs_chain_fk and chs_so3_log have it, is within both tolerances: a solution
 * is as true as these two. Tolerances finer than their errors cannot be met.
 * Returns CHS_OK; CHS_ITERATION_LIMIT where more steps are needed or a tolerance cannot be met; CHS_AT_JOINT_LIMIT
 * where joints that are held at their limits keep the tool from getting nearer; CHS_NEAR_SINGULAR where no joint moves
 * it nearer, as beyond the reach of an outstretched arm; CHS_ERR_ARGUMENT where n < 1, the form or the method is
 * none, an option is outside its range or a lower limit above its upper one; CHS_ERR_NAN and CHS_ERR_INFINITE; as
 * chs_chain_fk; what CHS_SO3_FAR says. */
int chs_chain_ik(const chs_chain *chain, const double T[16], const double *start, const chs_ik *options,
                 double *scratch, double *q, double residual[2]);
int chs_chain_ikf(const chs_chainf *chain, const float T[16], const float *start, const chs_ikf *options,
                  float *scratch, float *q, float residual[2]);
int chs_chain_ik_step(const chs_chain *chain, const double T[16], const double *start, const chs_ik *options,
                      double *scratch, double *q, double residual[2]);
int chs_chain_ik_stepf(const chs_chainf *chain, const float T[16], const float *start, const chs_ikf *options,
                       float *scratch, float *q, float residual[2]);

#ifdef __cplusplus
}
#endif

#endif
