/* chasles/chain.h - serial chains as products of exponentials: forward kinematics, Jacobians.
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
 * overlap the joint values q, but neither the chain and its arrays nor scratch memory. chasles.h has the conventions
 * that all headers share.
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
 * Returns CHS_OK; CHS_ERR_ARGUMENT where n < 1; CHS_ERR_NAN, CHS_ERR_INFINITE, CHS_ERR_ANGLE_RANGE and
 * CHS_ERR_OVERFLOW. */
#define CHS_EPS_CHAIN_FK_ROTATION 4.0
#define CHS_EPS_CHAIN_FK_TRANSLATION 4.0
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
#define CHS_EPS_CHAIN_LINKS_TRANSLATION 4.0
int chs_chain_links(const chs_chain *chain, const double *q, double *D);
int chs_chain_linksf(const chs_chainf *chain, const float *q, float *D);

/* The Jacobian V = J qdot: the twist of the tool in the fixed frame (space) or in its own (body), for the rates of the
 * joints. Column i is Ad(T_i) S_i, with T_i what the joints before i do, and Ad(T)^-1 of that.
 *
 *   J  [6*n], row-major, of 6 rows.
 *   T  the pose as from chs_chain_fk; may be NULL.
 *
 * Errors as for chs_chain_fk: those of the first three rows are absolute, those of the last three relative to the
 * reach, both times the largest |omega| where that is a gear ratio above 1.
 * Returns as chs_chain_fk. */
#define CHS_EPS_CHAIN_SPACE_JACOBIAN_ANGULAR 4.0
#define CHS_EPS_CHAIN_SPACE_JACOBIAN_LINEAR 4.0
#define CHS_EPS_CHAIN_BODY_JACOBIAN_ANGULAR 4.0
#define CHS_EPS_CHAIN_BODY_JACOBIAN_LINEAR 4.0
int chs_chain_space_jacobian(const chs_chain *chain, const double *q, double *J, double T[16]);
int chs_chain_space_jacobianf(const chs_chainf *chain, const float *q, float *J, float T[16]);
int chs_chain_body_jacobian(const chs_chain *chain, const double *q, double *J, double T[16]);
int chs_chain_body_jacobianf(const chs_chainf *chain, const float *q, float *J, float T[16]);

#ifdef __cplusplus
}
#endif

#endif
