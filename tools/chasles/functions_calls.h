/* functions_calls.h - the calls of functions.def in one precision; functions.c includes it twice.
 *
 * The includer defines REAL, SCREW, SUMS, QUALITY, CHAIN and IK (the types), REAL_EPSILON, LIB(name) (the library's
 * function of that name) and LOCAL(name) (a name of our own for this precision); all are undefined at the end. No
 * include guard, on purpose.
 */

/* A screw in a flat array is axis, point, translation, angle. */
static SCREW LOCAL(get_screw)(const REAL *flat) {
  SCREW screw;
  for (int i = 0; i < 3; ++i) {
    screw.axis[i] = flat[i];
    screw.point[i] = flat[3 + i];
  }
  screw.translation = flat[6];
  screw.angle = flat[7];
  return screw;
}

static void LOCAL(put_screw)(const SCREW *screw, REAL *flat) {
  for (int i = 0; i < 3; ++i) {
    flat[i] = screw->axis[i];
    flat[3 + i] = screw->point[i];
  }
  flat[6] = screw->translation;
  flat[7] = screw->angle;
}

/* Functions that take or give a screw. A screw to be written starts as what the output array holds, so that one left
 * untouched leaves the array untouched. */
static int LOCAL(pose_to_screw)(const REAL *in, REAL *out) {
  SCREW screw = LOCAL(get_screw)(out);
  const int status = LIB(screw_from_pose)(in, &screw);
  LOCAL(put_screw)(&screw, out);
  return status;
}

static int LOCAL(screw_to_pose)(const REAL *in, REAL *out) {
  const SCREW screw = LOCAL(get_screw)(in);
  return LIB(screw_to_pose)(&screw, out);
}

static int LOCAL(pitch)(const REAL *in, REAL *out) {
  const SCREW screw = LOCAL(get_screw)(in);
  return LIB(screw_pitch)(&screw, out);
}

static int LOCAL(points_to_screw)(int (*method)(const REAL *, const REAL *, REAL, SCREW *, REAL *), const REAL *in,
                                  REAL *out) {
  SCREW screw = LOCAL(get_screw)(out);
  const int status = method(in, in + 9, in[18], &screw, out + 8);
  LOCAL(put_screw)(&screw, out);
  return status;
}

/* Six points in a flat array: before, after and their weights; the tolerance follows. Counts are numbers here. */
static int LOCAL(fit)(const REAL *in, REAL *out) {
  SCREW screw = LOCAL(get_screw)(out);
  QUALITY quality;
  const int status = LIB(motion_fit)(6, in, in + 18, in + 36, NULL, in[42], &screw, out + 8, &quality);
  if (status < 0) return status;
  const REAL numbers[] = {quality.rms,    quality.largest,   quality.size,         quality.rigidity,
                          quality.growth, quality.condition, (REAL)quality.points, (REAL)quality.missing};
  LOCAL(put_screw)(&screw, out);
  for (int i = 0; i < 8; ++i) out[24 + i] = numbers[i];
  return status;
}

static int LOCAL(stream)(const REAL *in, REAL *out) {
  SCREW screw = LOCAL(get_screw)(out);
  QUALITY quality;
  SUMS sums;
  LIB(motion_begin)(&sums);
  for (int i = 0; i < 6; ++i) {
    const int status = LIB(motion_add)(&sums, in + 3 * i, in + 18 + 3 * i, in[36 + i]);
    if (status < 0) return status;
  }
  const int status = LIB(motion_finish)(&sums, in[42], &screw, out + 8, &quality);
  if (status < 0) return status;
  LOCAL(put_screw)(&screw, out);
  out[24] = quality.rms;
  return status;
}

static int LOCAL(spread)(const REAL *in, REAL *out) {
  return LIB(motion_covariance)(6, in, in + 18, in + 36, NULL, in[42], out, out + 36);
}

/* A chain of six joints in a flat array is its screws, home pose and form, 1 being the body form; the joint values
 * follow. */
static CHAIN LOCAL(get_chain)(const REAL *flat) {
  CHAIN chain = {6, flat[52] == 1 ? CHS_BODY_FORM : CHS_SPACE_FORM, flat, {0}, NULL};
  for (int i = 0; i < 16; ++i) chain.home[i] = flat[36 + i];
  return chain;
}

static int LOCAL(chain_pose)(int (*method)(const CHAIN *, const REAL *, REAL *), const REAL *in, REAL *out) {
  const CHAIN chain = LOCAL(get_chain)(in);
  return method(&chain, in + 53, out);
}

static int LOCAL(chain_jacobian)(int (*method)(const CHAIN *, const REAL *, REAL *, REAL *), const REAL *in,
                                 REAL *out) {
  const CHAIN chain = LOCAL(get_chain)(in);
  return method(&chain, in + 53, out, out + 36);
}

/* The pose that inverse kinematics reaches from the joint values in the array, to 1024 eps. Without a solution it is
 * that of the best joint values found. */
static int LOCAL(chain_reach)(int (*method)(const CHAIN *, const REAL *, const REAL *, const IK *, REAL *, REAL *,
                                            REAL *),
                              const REAL *in, REAL *out) {
  const CHAIN chain = LOCAL(get_chain)(in);
  const IK options = {CHS_IK_NEWTON, 1024 * REAL_EPSILON, 1024 * REAL_EPSILON, 1, 8, 1};
  REAL scratch[CHS_CHAIN_IK_SCRATCH(6)];
  REAL q[6];
  const int status = method(&chain, in + 59, in + 53, &options, scratch, q, NULL);
  if (status >= 0) (void)LIB(chain_fk)(&chain, q, out);
  return status;
}

static int LOCAL(jacobian_value)(int (*method)(int, const REAL *, REAL, REAL *, REAL *), const REAL *in, REAL *out) {
  REAL scratch[CHS_CHAIN_SCRATCH(6)];
  return method(6, in, in[36], scratch, out);
}

static int LOCAL(jacobian_rank)(const REAL *in, REAL *out) {
  REAL scratch[CHS_CHAIN_SCRATCH(6)];
  int rank = 0;
  const int status = LIB(chain_rank)(6, in, in[36], scratch, &rank);
  if (status >= 0) out[0] = (REAL)rank;
  return status;
}

static int LOCAL(pseudoinverse)(const REAL *in, REAL *out) {
  REAL scratch[CHS_CHAIN_SCRATCH(7)];
  return LIB(chain_rates_pseudoinverse)(7, in, in + 42, in[48], scratch, out);
}

static int LOCAL(damped)(const REAL *in, REAL *out) {
  REAL scratch[CHS_CHAIN_SCRATCH(7)];
  return LIB(chain_rates_damped)(7, in, in + 42, in[48], in[49], in[50], scratch, out);
}

/* An integer argument from a flat array: one that no function takes where the number is none. */
static int LOCAL(whole)(REAL x) { return x > -1000 && x < 1000 ? (int)x : -1000; }

/* For so3_solve, the equations that R M^T be symmetric: near M the rotation nearest to it solves them. */
static int LOCAL(asymmetry)(const REAL *R, void *M, REAL *f) {
  REAL product[9];
  LIB(so3_transpose)(M, product);
  LIB(so3_multiply)(R, product, product);
  LIB(so3_vee)(product, f);
  return CHS_OK;
}

static int LOCAL(solve)(const REAL *in, REAL *out) {
  const REAL tolerance = sizeof(REAL) == sizeof(double) ? (REAL)0x1p-49 : (REAL)0x1p-20; /* 8 eps */
  REAL M[9];
  for (int i = 0; i < 9; ++i) M[i] = in[i];
  return LIB(so3_solve)(LOCAL(asymmetry), M, in + 9, tolerance, 8, out, NULL);
}

/* For tilt_worst, the tool of the Agile Eye. */
static int LOCAL(eye)(const REAL *joints, void *context, REAL *T) {
  const REAL origin[3] = {0, 0, 0};
  REAL R[9];
  const int status = LIB(agile_eye_direct)(joints, 0, R);
  (void)context;
  if (status < 0) return status;
  LIB(agile_eye_tool)(R, R);
  LIB(se3_from_parts)(R, origin, T);
  return status;
}

static int LOCAL(worst)(const REAL *in, REAL *out) {
  REAL scratch[CHS_TILT_WORST_SCRATCH(3)];
  return LIB(tilt_worst)(LOCAL(eye), NULL, 3, in, in + 3, 2, 1, scratch, out, NULL);
}

static int LOCAL(by_method)(const REAL *in, REAL *out) {
  SCREW screw = LOCAL(get_screw)(out);
  const chs_motion_method method = (chs_motion_method)LOCAL(whole)(in[19]);
  const int status = LIB(motion_from_three)(method, in, in + 9, in[18], &screw, out + 8);
  LOCAL(put_screw)(&screw, out);
  return status;
}

static int LOCAL(order_of_points)(const REAL *in, REAL *out) {
  int order;
  const int status = LIB(motion_bottema_roth_order)(in, in + 9, in[18], &order);
  if (status >= 0) *out = (REAL)order;
  return status;
}

/* What an array form gives for copies of one element. Each starts as what the output array holds. */
struct LOCAL(copies) {
  REAL y[COPIES * MOST_COPIED];
  int statuses[COPIES];
};

static void LOCAL(begin_copies)(struct LOCAL(copies) * copies, int outputs, const REAL *out) {
  for (int i = 0; i < COPIES; ++i) {
    for (int k = 0; k < outputs; ++k) copies->y[i * outputs + k] = out[k];
    copies->statuses[i] = CHS_OK;
  }
}

/* The answer that all agree on, or one that no function gives. */
static int LOCAL(end_copies)(const struct LOCAL(copies) * copies, int outputs, int status, REAL *out) {
  const int size = outputs * (int)sizeof(REAL);
  const unsigned char *bytes = (const unsigned char *)copies->y;
  for (int i = 0; i < COPIES; ++i) {
    if (copies->statuses[i] != status) return -99;
    for (int k = 0; k < size; ++k) {
      if (bytes[i * size + k] != bytes[k]) return -99;
    }
  }
  for (int k = 0; k < outputs; ++k) out[k] = copies->y[k];
  return status;
}

static int LOCAL(one_by_one)(int (*array)(size_t, const REAL *, size_t, REAL *, size_t, int *), int outputs,
                             const REAL *in, REAL *out) {
  struct LOCAL(copies) copies;
  LOCAL(begin_copies)(&copies, outputs, out);
  const int status = array(COPIES, in, 0, copies.y, (size_t)outputs, copies.statuses);
  return LOCAL(end_copies)(&copies, outputs, status, out);
}

/* A pose and something else. */
static int LOCAL(two_by_two)(void (*array)(size_t, const REAL *, size_t, const REAL *, size_t, REAL *, size_t),
                             int outputs, const REAL *in, REAL *out) {
  struct LOCAL(copies) copies;
  LOCAL(begin_copies)(&copies, outputs, out);
  array(COPIES, in, 0, in + 16, 0, copies.y, (size_t)outputs);
  return LOCAL(end_copies)(&copies, outputs, CHS_OK, out);
}

static int LOCAL(tilts)(const REAL *in, REAL *out) {
  struct LOCAL(copies) copies;
  REAL alpha[COPIES];
  REAL beta[COPIES];
  LOCAL(begin_copies)(&copies, 2, out);
  for (int i = 0; i < COPIES; ++i) {
    alpha[i] = out[0];
    beta[i] = out[1];
  }
  const int status = LIB(tilt_error_array)(COPIES, in, 0, in + 9, 0, alpha, beta, copies.statuses);
  for (int i = 0; i < COPIES; ++i) {
    copies.y[2 * i] = alpha[i];
    copies.y[2 * i + 1] = beta[i];
  }
  return LOCAL(end_copies)(&copies, 2, status, out);
}

static int LOCAL(screws)(const REAL *in, REAL *out) {
  struct LOCAL(copies) copies;
  SCREW screws[COPIES];
  LOCAL(begin_copies)(&copies, 8, out);
  for (int i = 0; i < COPIES; ++i) screws[i] = LOCAL(get_screw)(out);
  const int status = LIB(screw_from_pose_array)(COPIES, in, 0, screws, copies.statuses);
  for (int i = 0; i < COPIES; ++i) LOCAL(put_screw)(&screws[i], copies.y + 8 * i);
  return LOCAL(end_copies)(&copies, 8, status, out);
}

static int LOCAL(displacements)(int (*array)(size_t, const REAL *, size_t, const REAL *, size_t, REAL, SCREW *, REAL *,
                                             size_t, int *),
                                const REAL *in, REAL *out) {
  struct LOCAL(copies) copies;
  SCREW screws[COPIES];
  LOCAL(begin_copies)(&copies, 24, out);
  for (int i = 0; i < COPIES; ++i) screws[i] = LOCAL(get_screw)(out);
  const int status = array(COPIES, in, 0, in + 9, 0, in[18], screws, copies.y + 8, 24, copies.statuses);
  for (int i = 0; i < COPIES; ++i) LOCAL(put_screw)(&screws[i], copies.y + 24 * i);
  return LOCAL(end_copies)(&copies, 24, status, out);
}

/* Plain algebra returns void: its status is always 0. */
#define ALWAYS_OK(call) ((call), CHS_OK)

#define FUNCTION(name, kinds, inputs, outputs, call, ...)    \
  static int LOCAL(call_##name)(const REAL *in, REAL *out) { \
    (void)out; /* a check has no outputs */                  \
    return call;                                             \
  }
#include "functions.def"
#undef FUNCTION
#undef ALWAYS_OK
#undef REAL
#undef SCREW
#undef SUMS
#undef QUALITY
#undef CHAIN
#undef IK
#undef REAL_EPSILON
#undef LIB
#undef LOCAL
