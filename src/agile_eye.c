#include <chasles/agile_eye.h>

#include "rotation.h"

/* Legs are counted from 0 here. Leg i has u_i along axis i, v_i against column j = i + 1 of R, and in that column row i
 * holds -u_i . v_i, rows j and k = i + 2 the cosine and the sine of the joint angle times a common factor. */
static const int next[3] = {1, 2, 0};

/* The least sine of the angle between v_i and u_i that is more than rounding. */
#define ALONG (K(4.0) * EPS)

/* Of the columns a change of mode turns round an even number: all but one, or none. */
static inline real sign_in_assembly(int mode, int column) { return mode == 0 || column == mode - 1 ? K(1.0) : K(-1.0); }

static inline int is_flipped(int working, int leg) { return (working >> leg) & 1; }

/* ---- From the orientation to the joints ---- */

/* The sine of the angle between v_i and u_i. */
static inline real sine_of_leg(const real R[9], int i) {
  int j = next[i], k = next[j];
  real v[2] = {R[3 * j + j], R[3 * k + j]};
  return norm(v, 2);
}

/* How many legs turn freely. */
static int free_legs(const real R[9]) {
  int count = 0;
  for (int i = 0; i < 3; i++) count += sine_of_leg(R, i) <= ALONG;
  return count;
}

static real leg_angle(const real R[9], int i, int flipped) {
  if (sine_of_leg(R, i) <= ALONG) return 0;
  int j = next[i], k = next[j];
  real c = R[3 * j + j], s = R[3 * k + j];
  return flipped ? signed_angle_of(K(0.0) - s, K(0.0) - c) : signed_angle_of(s, c);
}

static int inverse_status(const real R[9]) {
  int status = check_rotation_apart(R);
  if (status != CHS_OK) return status;
  int count = free_legs(R);
  return count == 3 ? CHS_ERR_LOCKUP : count > 0 ? CHS_SELF_MOTION : CHS_OK;
}

int FN(chs_agile_eye_inverse)(const real R[9], int working, real joints[3]) {
  if (working < 0 || working > 7) return CHS_ERR_ARGUMENT;
  int status = inverse_status(R);
  if (status < 0) return status;
  real q[3];
  for (int i = 0; i < 3; i++) q[i] = leg_angle(R, i, is_flipped(working, i));
  copy(q, 3, joints);
  return status;
}

int FN(chs_agile_eye_inverse_all)(const real R[9], real joints[24]) {
  int status = inverse_status(R);
  if (status < 0) return status;
  real q[3][2];
  for (int i = 0; i < 3; i++)
    for (int flipped = 0; flipped < 2; flipped++) q[i][flipped] = leg_angle(R, i, flipped);
  for (int working = 0; working < 8; working++)
    for (int i = 0; i < 3; i++) joints[3 * working + i] = q[i][is_flipped(working, i)];
  return status;
}

int FN(chs_agile_eye_distance)(const real R[9], real *distance) {
  int status = check_rotation_apart(R);
  if (status != CHS_OK) return status;
  real least = CHS_PI_A;
  for (int i = 0; i < 3; i++) {
    real angle = FN(chs_p_angle_of)(sine_of_leg(R, i), ABS(R[3 * i + next[i]]));
    if (angle < least) least = angle;
  }
  *distance = least;
  return CHS_OK;
}

int FN(chs_agile_eye_jacobian_inverse)(const real R[9], real rates[9]) {
  int status = inverse_status(R);
  if (status != CHS_OK) return status == CHS_SELF_MOTION ? CHS_ERR_SINGULAR : status;
  real result[9];
  for (int i = 0; i < 3; i++) {
    int j = next[i], k = next[j];
    real c = R[3 * j + j], s = R[3 * k + j], ratio = R[3 * i + j] / (c * c + s * s);
    result[3 * i + i] = 1;
    result[3 * i + j] = K(0.0) - ratio * c;
    result[3 * i + k] = K(0.0) - ratio * s;
  }
  copy(result, 9, rates);
  return CHS_OK;
}

/* ---- From the joints to the orientation ---- */

/* The three numbers of each leg in the header, the angles' sines and cosines, and D. */
typedef struct legs {
  real s[3], c[3], d[3], N[3], D;
  real size; /* max(1, |q1|, |q2|, |q3|) */
} legs;

static int legs_status(const legs *l) {
  real least = l->d[0] < l->d[1] ? l->d[0] : l->d[1], rounding = K(8.0) * EPS * l->size;
  if (l->d[2] < least) least = l->d[2];
  if (least <= rounding) return CHS_ERR_SINGULAR;
  if (ABS(l->D) <= rounding) return CHS_SELF_MOTION;
  return least * least <= EPS * (l->size * l->size) ? CHS_ILL_CONDITIONED : CHS_OK;
}

/* D and N_i are differences of products of which none exceeds d_j d_k, the length of (D, N_i): their errors are small
 * against it however small it is. */
static int legs_of(const real joints[3], legs *l) {
  int status = angles_status(joints, 3);
  if (status != CHS_OK) return status;
  real *s = l->s, *c = l->c;
  for (int i = 0; i < 3; i++) {
    sine_cosine of_joint = FN(chs_p_sin_cos_to_all_digits)(joints[i]);
    s[i] = of_joint.sine;
    c[i] = of_joint.cosine;
  }
  for (int i = 0; i < 3; i++) {
    int j = next[i], k = next[j];
    real cc = c[j] * c[k];
    l->N[i] = c[j] * s[k] - (s[j] * s[i]) * (c[k] * c[i]);
    l->d[i] = SQRT(s[j] * s[j] + cc * cc);
  }
  l->D = s[0] * s[1] * s[2] + c[0] * c[1] * c[2];
  real size = largest(joints, 3);
  l->size = size > 1 ? size : K(1.0);
  return legs_status(l);
}

/* R0 of the header. */
static void first_assembly(const legs *l, real R[9]) {
  for (int i = 0; i < 3; i++) {
    int j = next[i], k = next[j];
    real length = l->d[j] * l->d[k], part = l->D / length;
    R[3 * i + j] = K(0.0) - l->N[i] / length;
    R[3 * j + j] = l->c[i] * part;
    R[3 * k + j] = l->s[i] * part;
  }
}

/* Every v_i along its u_i, or against it. */
static void locked_assembly(real R[9]) {
  for (int i = 0; i < 9; i++) R[i] = 0;
  for (int i = 0; i < 3; i++) R[3 * i + next[i]] = 1;
}

static void sign_columns(const real from[9], const real sign[3], real R[9]) {
  for (int i = 0; i < 9; i++) R[i] = sign[i % 3] < 0 ? K(0.0) - from[i] : from[i];
}

static void change_assembly(const real from[9], int mode, real R[9]) {
  const real sign[3] = {sign_in_assembly(mode, 0), sign_in_assembly(mode, 1), sign_in_assembly(mode, 2)};
  sign_columns(from, sign, R);
}

int FN(chs_agile_eye_direct)(const real joints[3], int assembly, real R[9]) {
  if (assembly < 0 || assembly > 7) return CHS_ERR_ARGUMENT;
  real first[9];
  int status;
  if (assembly < 4) {
    legs l;
    status = legs_of(joints, &l);
    if (status < 0) return status;
    first_assembly(&l, first);
  } else {
    status = angles_status(joints, 3);
    if (status < 0) return status;
    locked_assembly(first);
  }
  change_assembly(first, assembly % 4, R);
  return status;
}

/* In the first assembly mode (u_i x w_i) . v_i = D / (d_j d_k). Where D is no more than rounding either will do. */
int FN(chs_agile_eye_direct_working)(const real joints[3], int working, real R[9]) {
  if (working < 0 || working > 7) return CHS_ERR_ARGUMENT;
  legs l;
  int status = legs_of(joints, &l);
  if (status < 0) return status;
  int odd = is_flipped(working, 0) ^ is_flipped(working, 1) ^ is_flipped(working, 2);
  if (status != CHS_SELF_MOTION && odd != (l.D < 0)) return CHS_ERR_SINGULAR;
  real first[9], sign[3];
  first_assembly(&l, first);
  for (int i = 0; i < 3; i++) sign[next[i]] = is_flipped(working, i) != odd ? K(-1.0) : K(1.0);
  sign_columns(first, sign, R);
  return status;
}

int FN(chs_agile_eye_direct_near)(const real joints[3], const real last[9], real R[9]) {
  int status = first_error(angles_status(joints, 3), check_rotation_apart(last));
  if (status != CHS_OK) return status;
  legs l;
  status = legs_of(joints, &l);
  if (status < 0) return status;
  real first[9], along[3], most = 0;
  first_assembly(&l, first);
  for (int j = 0; j < 3; j++) along[j] = first[j] * last[j] + first[3 + j] * last[3 + j] + first[6 + j] * last[6 + j];
  int nearest = 0;
  for (int mode = 0; mode < 4; mode++) {
    real trace = 0;
    for (int j = 0; j < 3; j++) trace += sign_in_assembly(mode, j) * along[j];
    if (mode > 0 && !(trace > most)) continue;
    most = trace;
    nearest = mode;
  }
  change_assembly(first, nearest, R);
  return status;
}

int FN(chs_agile_eye_jacobian)(const real joints[3], real J[9]) {
  legs l;
  int status = legs_of(joints, &l);
  if (status < 0) return status;
  const real *s = l.s, *c = l.c;
  for (int i = 0; i < 3; i++) {
    int j = next[i], k = next[j];
    real length = l.d[j] * l.d[k], ss = s[i] * s[k], cc = c[i] * c[j];
    J[3 * i + i] = ((ss * ss + cc * cc) + (ss * cc) * (s[j] * c[k])) / length / length;
    J[3 * j + i] = K(0.0) - ss * l.N[j] / length / length;
    J[3 * k + i] = K(0.0) - cc * l.N[k] / length / length;
  }
  return status;
}

/* ---- The tool ---- */

/* C0 and C1 of the header without their factors, and the products of those. */
static const real base_axes[9] = {2, 0, 1, -1, 1, 1, -1, -1, 1};
static const real platform_axes[9] = {1, -1, 1, 1, 1, 1, -2, 0, 1};
static const real factors[9] = {
    K(0.16666666666666666667), K(0.28867513459481288225),
    K(0.23570226039551584147), /* 1/6, 1/sqrt 12, 1/sqrt 18 */
    K(0.28867513459481288225), K(0.5),
    K(0.40824829046386301637), /* 1/sqrt 12, 1/2, 1/sqrt 6 */
    K(0.23570226039551584147), K(0.40824829046386301637),
    K(0.33333333333333333333), /* 1/sqrt 18, 1/sqrt 6, 1/3 */
};

void FN(chs_agile_eye_tool)(const real R[9], real tool[9]) {
  real across[9], result[9];
  transpose(base_axes, across);
  multiply(across, R, result);
  multiply(result, platform_axes, result);
  for (int i = 0; i < 9; i++) tool[i] = factors[i] * result[i];
}

void FN(chs_agile_eye_platform)(const real tool[9], real R[9]) {
  real across[9], result[9];
  for (int i = 0; i < 9; i++) result[i] = factors[i] * tool[i];
  transpose(platform_axes, across);
  multiply(base_axes, result, result);
  multiply(result, across, R);
}
