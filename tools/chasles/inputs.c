/* inputs.c - see inputs.h. C leaves the order open in which an expression's operands are evaluated: wherever two
 * numbers are drawn from the source, their order is fixed.
 */
#include "inputs.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "random.h"

enum { X, Y, Z };

static const double pi = 3.14159265358979323846;

struct source source_for(const struct function *function, enum precision precision, uint64_t seed) {
  struct source source = {seed, precision};
  for (const char *c = function->name; *c != '\0'; ++c)
    source.state = next_bits(&source.state) ^ (uint64_t)(unsigned char)*c;
  source.state = next_bits(&source.state) ^ (uint64_t)precision;
  return source;
}

static int below(struct source *source, int count) {
  return (int)((next_bits(&source->state) >> 32) % (uint64_t)count);
}

static bool one_in(struct source *source, int count) { return below(source, count) == 0; }

/* The value rounded to the precision at hand. gcc 12 forgets a plain cast in loops that it vectorises. */
static double rounded(const struct source *source, double x) {
  volatile float single = (float)x;
  return source->precision == DOUBLE_PRECISION ? x : (double)single;
}

static int mantissa_bits(const struct source *source) { return source->precision == DOUBLE_PRECISION ? 52 : 23; }

/* Either sign, an exponent in [least, most], and mantissa bits that are all random or, one time in eight, nearly all
 * zero, so that exact results and ties happen. */
static double number(struct source *source, int least, int most) {
  const int width = mantissa_bits(source);
  const int bias = source->precision == DOUBLE_PRECISION ? 1023 : 127;
  const uint64_t sign = next_bits(&source->state) & 1u;
  const uint64_t exponent = (uint64_t)(least + below(source, most - least + 1) + bias);
  uint64_t mantissa = next_bits(&source->state) >> (64 - width);
  if (one_in(source, 8)) mantissa &= (uint64_t)7 << (width - 3);
  const uint64_t bits = (((sign << (source->precision == DOUBLE_PRECISION ? 11 : 8)) | exponent) << width) | mantissa;
  return precision_number(bits, source->precision);
}

/* Flips some of the lowest `count` bits of the mantissa. */
static double jitter(struct source *source, double x, int count) {
  const uint64_t mask = ((uint64_t)1 << count) - 1u;
  return precision_number(precision_bits(x, source->precision) ^ (next_bits(&source->state) & mask), source->precision);
}

/* Exponents of magnitudes from nearly the least to nearly the greatest number. */
struct range {
  int least;
  int most;
};

enum { TINY, SMALL, MODERATE, ORDINARY, LARGE, FAR, HUGEST, MAGNITUDES };

static struct range range_of(const struct source *source, int magnitude) {
  static const struct range ranges[PRECISIONS][MAGNITUDES] = {
      {{-1022, -500}, {-500, -20}, {-20, -3}, {-3, 1}, {1, 10}, {10, 48}, {48, 1023}},
      {{-126, -60}, {-60, -12}, {-12, -3}, {-3, 1}, {1, 7}, {7, 20}, {20, 127}}};
  return ranges[source->precision][magnitude];
}

/* Half of the numbers are of ordinary size. */
static int any_magnitude(struct source *source) { return one_in(source, 2) ? ORDINARY : below(source, MAGNITUDES); }

static double number_of(struct source *source, int magnitude) {
  const struct range range = range_of(source, magnitude);
  return number(source, range.least, range.most);
}

/* Components of one magnitude or, sometimes, each of its own; some of them zero, of either sign. */
static void make_numbers(struct source *source, double *x, int count) {
  const bool mixed = one_in(source, 8);
  const bool zeros = one_in(source, 6);
  int magnitude = any_magnitude(source);
  for (int i = 0; i < count; ++i) {
    if (mixed) magnitude = any_magnitude(source);
    x[i] = number_of(source, magnitude);
    if (zeros && one_in(source, 2)) x[i] = x[i] < 0.0 ? -0.0 : 0.0;
  }
}

static void make_vector(struct source *source, double *x) { make_numbers(source, x, 3); }

/* Whole numbers whose squares add up to that of a whole number: a unit vector when divided by it. */
static int whole_axis(struct source *source, int axis[3]) {
  static const int quadruples[][4] = {{0, 0, 1, 1}, {0, 3, 4, 5}, {0, 5, 12, 13}, {1, 2, 2, 3},  {2, 3, 6, 7},
                                      {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11},  {6, 6, 7, 11}, {8, 9, 12, 17}};
  const int *chosen = quadruples[below(source, (int)(sizeof quadruples / sizeof quadruples[0]))];
  const int first = below(source, 3);
  for (int i = 0; i < 3; ++i) axis[(first + i) % 3] = one_in(source, 2) ? chosen[i] : -chosen[i];
  return chosen[3];
}

/* Rotation vectors around multiples of pi, mostly pi itself, some exactly as near to it as numbers come, others with
 * an error in any bit. */
static void make_turns(struct source *source, double *w) {
  int axis[3];
  const int length = whole_axis(source, axis);
  const int turns = one_in(source, 4) ? below(source, 300) : 1;
  const int bits = below(source, mantissa_bits(source));
  for (int i = 0; i < 3; ++i) w[i] = jitter(source, rounded(source, axis[i] * turns * pi / length), bits);
}

static void make_rotation_vector(struct source *source, double *w) {
  if (one_in(source, 3)) {
    make_turns(source, w);
  } else {
    make_vector(source, w);
  }
}

static void make_angle(struct source *source, double *angle) {
  if (one_in(source, 3)) {
    const int quarters = below(source, 9) - 4;
    *angle = jitter(source, rounded(source, quarters * (pi / 2.0)), below(source, mantissa_bits(source)));
  } else {
    *angle = one_in(source, 8) ? 0.0 : number_of(source, any_magnitude(source));
  }
}

static void make_identity(double *R) {
  for (int i = 0; i < 9; ++i) R[i] = i % 4 == 0 ? 1.0 : 0.0;
}

/* 2 e e^T - I with an axis of whole numbers. */
static void make_half_turn(struct source *source, double *R) {
  int axis[3];
  const int length = whole_axis(source, axis);
  for (int i = 0; i < 9; ++i) {
    const int row = i / 3;
    const int column = i % 3;
    const int numerator = 2 * axis[row] * axis[column] - (row == column ? length * length : 0);
    R[i] = rounded(source, (double)numerator / (double)(length * length));
  }
}

/* Axes exchanged and turned round: half of these matrices are reflections. */
static void make_permutation(struct source *source, double *R) {
  const int first = below(source, 3);
  const int step = 1 + below(source, 2);
  for (int i = 0; i < 9; ++i) R[i] = 0.0;
  for (int row = 0; row < 3; ++row) R[3 * row + (first + step * row) % 3] = one_in(source, 2) ? 1.0 : -1.0;
}

/* Calls a function of the library by its name in the registry; the outputs stay as they are on an error. */
static void call_library(const struct source *source, const char *name, const double *in, double *out) {
  const struct function *function = find_function(name);
  struct answer answer;
  evaluate(function, source->precision, in, &answer);
  if (answer.status >= 0) memcpy(out, answer.out, (size_t)function->outputs * sizeof *out);
}

/* The library's own exponential of any rotation vector. */
static void make_exponential(struct source *source, double *R) {
  double w[3];
  make_rotation_vector(source, w);
  make_identity(R);
  call_library(source, "so3_exp", w, R);
}

static void make_proper_rotation(struct source *source, double *R) {
  switch (below(source, 12)) {
  case 0: make_identity(R); break;
  case 1: make_half_turn(source, R); break;
  case 2: make_permutation(source, R); break;
  default: make_exponential(source, R); break;
  }
}

/* One rotation in four comes drifted, broken or reflected. */
static void make_rotation(struct source *source, double *R) {
  make_proper_rotation(source, R);
  const int bits = below(source, mantissa_bits(source));
  const int row = below(source, 3);
  const int entry = below(source, 9);
  switch (below(source, 16)) {
  case 0:
  case 1:
    for (int i = 0; i < 9; ++i) R[i] = jitter(source, R[i], bits);
    break;
  case 2: R[entry] = number_of(source, any_magnitude(source)); break;
  case 3:
    for (int i = 0; i < 3; ++i) R[3 * row + i] = -R[3 * row + i];
    break;
  default: break;
  }
}

/* Two orientations: equal, apart by any rotation of the second's own frame, or unrelated. */
static void make_orientations(struct source *source, double *AB) {
  double factors[18];
  double *B = AB + 9;
  const int kind = below(source, 4);
  make_rotation(source, AB);
  for (int i = 0; i < 9; ++i) B[i] = factors[i] = AB[i];
  if (kind == 1) make_rotation(source, B);
  if (kind > 1) {
    make_proper_rotation(source, factors + 9);
    call_library(source, "so3_multiply", factors, B);
  }
}

/* Rotations, any nine numbers, and matrices of rank two and one. */
static void make_matrix(struct source *source, double *M) {
  const int kind = below(source, 8);
  const double factor = number(source, -8, 8);
  if (kind < 4) {
    make_rotation(source, M);
    return;
  }
  make_numbers(source, M, 9);
  for (int i = 0; i < 3 && kind >= 6; ++i) {
    M[3 + i] = M[i];
    if (kind == 7) M[6 + i] = rounded(source, fabs(M[i]) < 1.0 ? M[i] * factor : M[i]);
  }
}

static void make_last_row(struct source *source, double *T) {
  for (int i = 12; i < 16; ++i) T[i] = i == 15 ? 1.0 : 0.0;
  const int entry = 12 + below(source, 4);
  if (one_in(source, 8)) T[entry] = one_in(source, 2) ? (double)NAN : 7.0;
}

static void join_pose(const double *R, const double *p, double *T) {
  for (int i = 0; i < 3; ++i) {
    memcpy(T + 4 * i, R + 3 * i, 3 * sizeof *T);
    T[4 * i + 3] = p[i];
  }
}

/* The last row of a pose is never read, so now and then it holds nonsense. */
static void make_pose(struct source *source, double *T) {
  double R[9];
  double p[3];
  make_rotation(source, R);
  make_vector(source, p);
  join_pose(R, p, T);
  make_last_row(source, T);
}

/* Two poses of which the second is the first, the first turned and moved, or unrelated. */
static void make_poses(struct source *source, double *AB) {
  double R[18];
  double p[6];
  make_orientations(source, R);
  make_vector(source, p);
  make_vector(source, p + 3);
  for (int i = 0; i < 3 && one_in(source, 4); ++i) p[3 + i] = p[i];
  for (int k = 0; k < 2; ++k) {
    join_pose(R + 9 * k, p + 3 * k, AB + 16 * k);
    make_last_row(source, AB + 16 * k);
  }
}

static void make_twist(struct source *source, double *V) {
  make_rotation_vector(source, V);
  make_vector(source, V + 3);
}

/* Axes of unit length, of any length and, rarely, of none. */
static void make_screw(struct source *source, double *screw) {
  int axis[3];
  const int length = whole_axis(source, axis);
  make_vector(source, screw);
  for (int i = 0; i < 3 && !one_in(source, 8); ++i) screw[i] = rounded(source, (double)axis[i] / (double)length);
  if (one_in(source, 32)) screw[X] = screw[Y] = screw[Z] = 0.0;
  make_vector(source, screw + 3);
  screw[6] = one_in(source, 6) ? 0.0 : number_of(source, any_magnitude(source));
  make_angle(source, screw + 7);
}

/* A pitch, a rate or a share of the way. */
static void make_share(struct source *source, double *share) {
  static const double usual[] = {0.0, 0.5, 1.0, -1.0};
  *share = one_in(source, 4) ? usual[below(source, 4)] : number_of(source, any_magnitude(source));
  if (one_in(source, 16)) *share = one_in(source, 2) ? (double)INFINITY : -(double)INFINITY;
}

/* A line of unit direction through a point of any size; one in sixteen has a direction of any length. */
static void make_line(struct source *source, double *L) {
  int axis[3];
  double point_and_direction[6];
  const int length = whole_axis(source, axis);
  make_vector(source, point_and_direction);
  make_vector(source, point_and_direction + 3);
  for (int i = 0; i < 3; ++i) L[i] = rounded(source, (double)axis[i] / (double)length);
  for (int i = 3; i < 6; ++i) L[i] = 0.0;
  if (!one_in(source, 4)) call_library(source, "line_from_direction", point_and_direction, L);
  if (one_in(source, 16)) memcpy(L, point_and_direction + 3, 3 * sizeof *L);
}

/* Two lines: unrelated; of one direction, exactly or nearly; through one point; or the same one. */
static void make_lines(struct source *source, double *AB) {
  double through[6];
  double *B = AB + 6;
  make_line(source, AB);
  make_line(source, B);
  make_vector(source, through);
  const int kind = below(source, 8);
  const bool back = one_in(source, 2);
  const int bits = below(source, mantissa_bits(source));
  for (int i = 0; i < 3; ++i) through[3 + i] = kind == 1 ? AB[i] : jitter(source, AB[i], bits);
  if (kind == 1 || kind == 2) call_library(source, "line_from_direction", through, B);
  for (int end = 0; end < 12 && kind == 3; end += 6) {
    for (int i = 0; i < 3; ++i) through[3 + i] = AB[end + i];
    call_library(source, "line_from_direction", through, AB + end);
  }
  if (kind == 4) memcpy(B, AB, 6 * sizeof *B);
  for (int i = 0; i < 6 && back; ++i) B[i] = -B[i];
}

/* Three rows of Denavit and Hartenberg. */
static void make_rows(struct source *source, double *rows) {
  for (int i = 0; i < 12; i += 2) {
    rows[i] = one_in(source, 3) ? 0.0 : number_of(source, one_in(source, 8) ? any_magnitude(source) : ORDINARY);
    make_angle(source, rows + i + 1);
  }
}

/* Three axes, each related to the one before or to that before it, or not at all. */
static void make_axes(struct source *source, double *axes) {
  make_lines(source, axes);
  make_lines(source, axes + 6);
  if (!one_in(source, 3)) make_line(source, axes + 12);
}

/* Three points of about the size 2^exponent: any, two nearly or exactly alike, on a line through the origin, far
 * away from it for their size, or in a plane with it. */
static void make_triangle(struct source *source, int exponent, double *points) {
  const int width = mantissa_bits(source);
  for (int i = 0; i < 9; ++i) points[i] = number(source, exponent - 3, exponent);
  const int kind = below(source, 16);
  const int bits = 1 + below(source, width - 1);
  for (int i = 0; i < 3; ++i) {
    double *point_2 = points + 3;
    double *point_3 = points + 6;
    if (kind == 0) point_3[i] = point_2[i];
    if (kind == 1) point_3[i] = 2.0 * point_2[i];
    if (kind == 1) points[i] = -point_2[i];
    if (kind == 2) point_3[i] = 0.0;
    if (kind == 3 || kind == 4) point_3[i] = jitter(source, point_2[i], bits);
    if (kind == 4) points[i] = jitter(source, point_2[i], bits);
    if (kind == 5) points[3 * i + Z] = 0.0;
  }
}

static void move_points(struct source *source, int exponent, int count, const double *points, double *moved) {
  double R[9];
  double p[3];
  double pose_and_point[19] = {0.0};
  make_proper_rotation(source, R);
  if (one_in(source, 10)) make_identity(R);
  const bool travels = !one_in(source, 6);
  for (int i = 0; i < 3; ++i) p[i] = travels ? number(source, exponent - 3, exponent + 3) : 0.0;
  join_pose(R, p, pose_and_point);
  for (int k = 0; k < count; ++k) {
    memcpy(pose_and_point + 16, points + 3 * k, 3 * sizeof *points);
    call_library(source, "se3_apply", pose_and_point, moved + 3 * k);
  }
}

/* Three points before and after a motion; one time in eight the second three are unrelated or measured badly. */
static void make_triangles(struct source *source, double *points) {
  const int most = source->precision == DOUBLE_PRECISION ? 300 : 30;
  const int exponent = one_in(source, 2) ? 0 : below(source, 2 * most + 1) - most;
  const int bits = below(source, mantissa_bits(source));
  make_triangle(source, exponent, points);
  switch (below(source, 16)) {
  case 0: make_triangle(source, exponent, points + 9); break;
  case 1:
    for (int i = 0; i < 9; ++i) points[9 + i] = jitter(source, points[i], bits);
    break;
  default: move_points(source, exponent, 3, points, points + 9); break;
  }
}

/* Six points before and after, and their weights: moved, measured more or less badly, or unrelated; some in a plane or
 * nearly on a line, some missing, some of no weight. */
static void make_cloud(struct source *source, double *points) {
  enum { COUNT = 6, NUMBERS = 3 * COUNT };
  const int most = source->precision == DOUBLE_PRECISION ? 140 : 14;
  const int exponent = one_in(source, 2) ? 0 : below(source, 2 * most + 1) - most;
  double *moved = points + NUMBERS;
  double *weights = moved + NUMBERS;
  make_triangle(source, exponent, points);
  for (int i = 9; i < NUMBERS; ++i) points[i] = number(source, exponent - 3, exponent);
  const int flat = below(source, 8);
  const int bits = 1 + below(source, mantissa_bits(source) - 1);
  for (int i = 3; i < NUMBERS && flat == 0; ++i) points[i] = jitter(source, points[i - 3], bits);
  for (int i = Z; i < NUMBERS && flat == 1; i += 3) points[i] = 0.0;
  move_points(source, exponent, COUNT, points, moved);
  const int error = below(source, 8);
  for (int i = 0; i < NUMBERS && error < 3; ++i) {
    if (error == 0) moved[i] = number(source, exponent - 3, exponent);
    if (error == 1) moved[i] = jitter(source, moved[i], bits);
    if (error == 2 && i % 3 == Z) moved[i] = -moved[i];
  }
  const bool weighted = one_in(source, 2);
  for (int i = 0; i < COUNT; ++i) weights[i] = weighted ? fabs(number(source, -8, 8)) : 1.0;
  const int chosen = below(source, COUNT);
  switch (below(source, 8)) {
  case 0: moved[3 * chosen + Y] = (double)NAN; break;
  case 1: weights[chosen] = 0.0; break;
  default: break;
  }
}

static void make_tolerance(struct source *source, double *tolerance) {
  static const double usual[] = {0.0, 0x1p-20, 0x1p-10, 0.0625, 0.0625, 1.0};
  *tolerance = usual[below(source, (int)(sizeof usual / sizeof usual[0]))];
  if (one_in(source, 16)) *tolerance = number_of(source, any_magnitude(source));
}

/* A joint about an axis of its frame, about an axis of any direction, with a pitch or not, a slide, or any twist. */
static void make_joint(struct source *source, double *S) {
  int axis[3];
  double carried[22] = {1, 0, 0, 0, 0, 1, 0, 0,
                        0, 0, 1, 0, 0, 0, 0, 1}; /* a translation, and the joint at the origin */
  double *w = carried + 16;
  const int length = whole_axis(source, axis);
  const int kind = below(source, 16);
  const int along = below(source, 3);
  const double pitch = one_in(source, 4) ? number_of(source, ORDINARY) : 0.0;
  make_twist(source, S);
  if (kind < 2) return;
  if (kind == 2) S[X] = S[Y] = S[Z] = 0.0;
  if (kind == 2) return;
  for (int i = 0; i < 3; ++i) {
    w[i] = rounded(source, kind < 8 ? (i == along ? 1.0 : 0.0) : (double)axis[i] / (double)length);
    if (kind == 3) w[i] = -w[i];
    w[3 + i] = rounded(source, pitch * w[i]);
    carried[4 * i + 3] = S[3 + i];
  }
  call_library(source, "se3_adjoint_twist", carried, S);
}

/* Six joints, the pose at rest, the form, and the joint values. */
static void make_chain(struct source *source, double *chain) {
  for (int i = 0; i < 6; ++i) make_joint(source, chain + 6 * i);
  make_pose(source, chain + 36);
  chain[52] = one_in(source, 2) ? 1.0 : 0.0;
  for (int i = 0; i < 6; ++i) make_angle(source, chain + 53 + i);
}

/* A chain, and a pose: mostly one that it has at joint values not far away. */
static void make_goal(struct source *source, double *chain) {
  double there[59];
  const double far = number(source, -12, -2);
  make_chain(source, chain);
  make_pose(source, chain + 59);
  if (one_in(source, 16)) return;
  memcpy(there, chain, sizeof there);
  for (int i = 53; i < 59; ++i) there[i] = rounded(source, chain[i] + (one_in(source, 2) ? far : -far));
  call_library(source, "chain_fk", there, chain + 59);
}

/* Six columns: of a chain, which may be singular, or any numbers, or the one column twice. */
static void make_jacobian(struct source *source, double *J) {
  double chain[59];
  double answer[MAX_OUTPUTS];
  const bool twice = one_in(source, 8);
  make_numbers(source, J, 36);
  make_chain(source, chain);
  memcpy(answer, J, 36 * sizeof *J);
  if (one_in(source, 2)) call_library(source, "chain_space_jacobian", chain, answer);
  memcpy(J, answer, 36 * sizeof *J);
  for (int row = 0; row < 6 && twice; ++row) J[6 * row + 5] = J[6 * row + 2];
}

static void make_wide_jacobian(struct source *source, double *J) {
  double six[36];
  make_jacobian(source, six);
  for (int row = 0; row < 6; ++row) {
    memcpy(J + 7 * row, six + 6 * row, 6 * sizeof *J);
    J[7 * row + 6] = number_of(source, ORDINARY);
  }
}

/* The number of a mode, 0 to 7, now and then of none. */
static void make_mode(struct source *source, double *mode) {
  *mode = one_in(source, 16) ? 8 - 9 * below(source, 2) : below(source, 8);
}

/* The letters of functions.def. */
struct kind {
  char letter;
  int size;
  void (*make)(struct source *source, double *block);
};

static const struct kind kinds[] = {
    {'x', 3, make_vector},    {'w', 3, make_rotation_vector}, {'a', 1, make_angle},     {'M', 9, make_matrix},
    {'R', 9, make_rotation},  {'Q', 18, make_orientations},   {'T', 16, make_pose},     {'V', 6, make_twist},
    {'S', 8, make_screw},     {'P', 18, make_triangles},      {'t', 1, make_tolerance}, {'L', 6, make_line},
    {'D', 12, make_lines},    {'C', 59, make_chain},          {'m', 1, make_mode},      {'h', 1, make_share},
    {'J', 36, make_jacobian}, {'K', 42, make_wide_jacobian},  {'B', 32, make_poses},    {'N', 42, make_cloud},
    {'H', 12, make_rows},     {'G', 18, make_axes},           {'I', 75, make_goal},
};

static const struct kind *find_kind(char letter) {
  for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; ++i) {
    if (kinds[i].letter == letter) return &kinds[i];
  }
  return NULL;
}

bool kinds_are_right(const struct function *function) {
  int size = 0;
  for (const char *letter = function->kinds; *letter != '\0'; ++letter) {
    const struct kind *kind = find_kind(*letter);
    if (kind == NULL) return false;
    size += kind->size;
  }
  return size == function->inputs;
}

/* One input out of all becomes a NaN, an infinity, or a number at an end of the range. */
static void make_extreme(struct source *source, double *x) {
  const bool wide = source->precision == DOUBLE_PRECISION;
  const double extremes[] = {(double)NAN, (double)INFINITY, wide ? DBL_MAX : (double)FLT_MAX,
                             precision_number(1 + (next_bits(&source->state) >> 44), source->precision)};
  *x = extremes[below(source, 4)];
  if (one_in(source, 2)) *x = -*x;
}

void make_inputs(struct source *source, const struct function *function, double *in) {
  int filled = 0;
  for (const char *letter = function->kinds; *letter != '\0'; ++letter) {
    const struct kind *kind = find_kind(*letter);
    kind->make(source, in + filled);
    filled += kind->size;
  }
  if (one_in(source, 64)) make_extreme(source, in + below(source, filled));
}
