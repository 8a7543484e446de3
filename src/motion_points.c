#include <chasles/motion.h>

#include "exact.h"
#include "motion_private.h"
#include "motion_sums.h"

#ifdef CHS_SINGLE
typedef chs_motion_sumsf motion_sums;
typedef chs_motion_qualityf motion_quality;
#else
typedef chs_motion_sums motion_sums;
typedef chs_motion_quality motion_quality;
#endif

/* Up to so many points are summed before they join the total, which keeps what rounding takes from it. */
enum { BLOCK = 128 };

/* The sums stay about the same two points until the weight is so many times what their mean was taken of. So they are
 * never farther from the centroids than sqrt(REACH - 1) times the size of the cloud, in whatever order points come. */
#define REACH K(2.0)

/* Sums between it and its inverse can be raised to the fourth power and leave room for what is small beside them. */
#ifdef CHS_SINGLE
#define MODEST 0x1p+15F
#else
#define MODEST 0x1p+120
#endif

static real weight_of(const run *r, size_t i) { return r->weights ? r->weights[i] : K(1.0); }

static real total(const motion_sums *s, int k) { return s->sum[k] + s->lost[k]; }

static INLINE void add_exactly(motion_sums *s, int k, exact_sum x) {
  exact_sum t = {s->sum[k], s->lost[k]};
  add(&t, x);
  s->sum[k] = t.hi;
  s->lost[k] = t.lo;
}

static INLINE void add_plainly(motion_sums *s, int k, real x) {
  exact_sum t = {x, 0};
  add_exactly(s, k, t);
}

/* The sums about two other points. */
static void move_sums(motion_sums *s, const real about[6]) {
  real shift[6], first[6], w = total(s, WEIGHT);
  for (int k = 0; k < 6; k++) {
    shift[k] = s->scale * (about[k] - s->about[k]);
    first[k] = total(s, FIRST + k);
    add_exactly(s, FIRST + k, product(-w, shift[k]));
  }
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      add_plainly(s, PRODUCTS + 3 * i + j, (w * shift[3 + i] - first[3 + i]) * shift[j] - shift[3 + i] * first[j]);
  for (int k = 0; k < 6; k++) add_plainly(s, SQUARES + k / 3, (w * shift[k] - K(2.0) * first[k]) * shift[k]);
}

/* Moves the sums to where a point of weight w is welcome: to the point if it outweighs all the others, or else to their
 * centroids. */
static void make_room(motion_sums *s, const run *r, real w) {
  real about[6], weight = total(s, WEIGHT);
  if (w > weight) {
    copy(r->initial, 3, about);
    copy(r->final, 3, about + 3);
  } else
    for (int k = 0; k < 6; k++) about[k] = s->about[k] + total(s, FIRST + k) / weight / s->scale;
  if (weight > 0) move_sums(s, about);
  copy(about, 6, s->about);
  s->about_weight = w > weight ? w : weight;
}

/* Places the empty sums at the mean of a sample of a run, if that is all there. */
static void settle(motion_sums *s, const run *r) {
  real mean[7];
  if (!sample_mean(r, mean)) return;
  copy(mean, 6, s->about);
  s->about_weight = mean[6];
}

/* The weight that may be added before the sums must be moved. */
static real room_in(const motion_sums *s) { return REACH * s->about_weight - total(s, WEIGHT); }

/* How many of the first points have no more weight than that; fewer too where a weight is not one. */
static size_t count_within(real room, const run *r) {
  size_t most = r->count < BLOCK ? r->count : BLOCK, i = 0;
  if (!r->weights) return room >= (real)most ? most : room > 0 ? (size_t)room : 0;
  for (real w = 0; i < most; i++) {
    w += r->weights[i];
    if (!(r->weights[i] >= 0 && w <= room)) break;
  }
  return i;
}

/* Whether what a sum is about is farther from its centroid than 0.6 times the size. NaN is not. */
static int is_far(const real sum[3], real square, real weight) {
  real mean[3] = {sum[0] / weight, sum[1] / weight, sum[2] / weight};
  return dot(sum, mean) > K(0.25) * square;
}

static int off_center(const real sum[SUMS]) {
  return is_far(sum + FIRST, sum[SQUARES], sum[WEIGHT]) || is_far(sum + FIRST + 3, sum[SQUARES + 1], sum[WEIGHT]);
}

/* The centroids of what is summed about the points of s. */
static SELDOM void find_centroids(const motion_sums *s, const real sum[SUMS], real centroids[6]) {
  for (int k = 0; k < 6; k++) centroids[k] = s->about[k] + sum[FIRST + k] / sum[WEIGHT] / s->scale;
}

/* False where a point is missing, the squares leave the format's range, or the weights are more than there is room for.
 * The squares tell of all that is not finite, for nothing that is summed is larger but the weight. */
static int is_ordinary(const real sum[SUMS], size_t points, real room) {
  real least = sum[SQUARES] < sum[SQUARES + 1] ? sum[SQUARES] : sum[SQUARES + 1];
  int finite = sum[SQUARES] <= REAL_MAX && sum[SQUARES + 1] <= REAL_MAX;
  return finite && points > 0 && sum[WEIGHT] <= room && least > UNDERFLOWS * UNDERFLOWS;
}

/* Adds the first points of a run at once. 0, and nothing added, where they must be looked at one by one. */
static APART size_t add_block(motion_sums *s, const run *r, size_t count, real room) {
  const run block = {count, r->initial, r->final, r->weights};
  real sum[SUMS];
  size_t points = gather(&block, s->about, s->scale, sum);
  if (count > 1 && !is_ordinary(sum, points, room)) return 0;
  if (s->points > 0)
    for (int k = 0; k < SUMS; k++) add_plainly(s, k, sum[k]);
  else {
    if (count > 1 && off_center(sum)) { /* what the sample tells is not true of the rest */
      find_centroids(s, sum, s->about);
      gather(&block, s->about, s->scale, sum);
    }
    if (count > 1) s->about_weight = sum[WEIGHT];
    copy(sum, SUMS, s->sum);
  }
  s->points += points;
  return count;
}

/* Lengths are multiplied by a power of two that makes them safe to square: by that of the largest so far. */
static void fit_scale(motion_sums *s, real most) {
  real scale = safe_to_square(most), change = scale / s->scale;
  int empty = s->sum[SQUARES] == 0 && s->sum[SQUARES + 1] == 0;
  if (most == 0 || scale == s->scale || (change > 1 && !empty)) return;
  for (int k = FIRST; k < SUMS; k++) {
    real by = k < PRODUCTS ? K(1.0) : change;
    s->sum[k] = s->sum[k] * change * by;
    s->lost[k] = s->lost[k] * change * by;
  }
  s->scale = scale;
}

/* Makes the sums ready for a point, if it is there. */
static APART int make_ready(motion_sums *s, const run *point) {
  real w = weight_of(point, 0), apart[6];
  if (!all_finite(point->initial, 3) || !all_finite(point->final, 3)) {
    s->missing++;
    return CHS_POINTS_MISSING;
  }
  if (!(w > 0 && w <= REAL_MAX)) return CHS_ERR_ARGUMENT;
  if (s->about_weight > 0) {
    subtract(point->initial, s->about, apart);
    subtract(point->final, s->about + 3, apart + 3);
    real most = largest(apart, 6);
    if (!is_finite(most)) return CHS_ERR_OVERFLOW;
    fit_scale(s, most);
  }
  if (!(w <= room_in(s))) make_room(s, point, w);
  return CHS_OK;
}

static INLINE int add_point(motion_sums *s, const run *point) {
  if (weight_of(point, 0) == 0) return CHS_OK;
  int status = make_ready(s, point);
  if (status == CHS_OK) add_block(s, point, 1, 0);
  return status;
}

static run rest_of(const run *r, size_t done) {
  run rest = {r->count - done, r->initial + 3 * done, r->final + 3 * done, r->weights ? r->weights + done : NULL};
  return rest;
}

/* Blocks of points as long as they are ordinary, single ones where they are not. Weights are only looked at where a whole
 * block's are too many. */
static int add_run(motion_sums *s, const run *all) {
  run r = rest_of(all, 0);
  if (r.count > 0 && s->points == 0) settle(s, &r);
  while (r.count > 0) {
    size_t block = r.count < BLOCK ? r.count : BLOCK;
    real room = s->points > 0 || !(s->about_weight > 0) ? room_in(s) : REAL_MAX; /* about what, is then seen to */
    size_t singly = r.weights ? block : count_within(room, &r), done = singly > 1 ? add_block(s, &r, singly, room) : 0;
    if (done == 0 && r.weights) {
      singly = count_within(room, &r);
      done = singly > 1 && singly < block ? add_block(s, &r, singly, room) : 0;
    }
    r = rest_of(&r, done);
    if (done == 0 && singly == 0) singly = 1;
    for (size_t i = done; i < singly; i++) {
      int status = add_point(s, &r);
      if (status < 0) return status;
      r = rest_of(&r, 1);
    }
  }
  return CHS_OK;
}

/* The cloud: where its centroids are and what was summed about them, divided by a power of two. */
typedef struct cloud {
  real center[3]; /* centroid of the initial points */
  real travel[3]; /* its displacement */
  real offset[6]; /* of the centroids from the points that the sums were about */
  real H[9];      /* sum of w y x^T */
  real squares[2];
  real size[2]; /* root mean square distances from the centroids */
  real N;       /* root of the product of both squares */
  real reduce;  /* the power of two */
} cloud;

/* Sum of w |x|^2 about the centroid, from that about a point and the sum of w x, whose mean tells the centroid. */
static real central_square(real square, const real sum[3], const real mean[3]) {
  real rest = square - dot(sum, mean);
  return rest < 0 ? K(0.0) : rest;
}

/* A row of H = sum of w y x^T about the centroids, times the power of two, likewise. */
static void central_products(const real about[3], real sum, const real mean[3], real reduce, real row[3]) {
  row[0] = reduce * (about[0] - sum * mean[0]);
  row[1] = reduce * (about[1] - sum * mean[1]);
  row[2] = reduce * (about[2] - sum * mean[2]);
}

/* NaN where not even one component is a number. */
static int read_cloud(const motion_sums *s, cloud *c) {
  real t[SUMS], w, share, unscale = K(1.0) / s->scale, *sum = t + FIRST, mean[6], size[2];
  for (int k = 0; k < SUMS; k++) t[k] = total(s, k);
  w = t[WEIGHT];
  share = K(1.0) / w;
  for (int k = 0; k < 6; k++) mean[k] = share * sum[k];
  for (int k = 0; k < 6; k++) c->offset[k] = mean[k] * unscale;
  for (int k = 0; k < 2; k++) {
    c->squares[k] = central_square(t[SQUARES + k], sum + 3 * k, mean + 3 * k);
    size[k] = SQRT(share * c->squares[k]);
    c->size[k] = size[k] * unscale;
  }
  c->N = (w * size[0]) * size[1];
  copy3(s->about, c->center);
  add_to(c->center, c->offset);
  subtract(s->about + 3, s->about, c->travel);
  for (int i = 0; i < 3; i++) c->travel[i] += c->offset[3 + i] - c->offset[i];
  if (!(c->N <= REAL_MAX)) return CHS_ERR_OVERFLOW;
  for (int k = 0; k < 2; k++)
    if (c->size[k] <= K(4.0) * EPS * largest(s->about + 3 * k, 3)) return CHS_ERR_COINCIDENT;
  real reduce = c->N > MODEST || c->N * MODEST < 1 ? EPS / power_of_two_below(EPS * c->N) : K(1.0);
  c->reduce = reduce;
  for (int i = 0; i < 3; i++) central_products(t + PRODUCTS + 3 * i, sum[3 + i], mean, reduce, c->H + 3 * i);
  c->squares[0] *= reduce;
  c->squares[1] *= reduce;
  c->N *= reduce;
  return all_finite(c->travel, 3) ? CHS_OK : CHS_ERR_OVERFLOW; /* and H is, since |H| <= N */
}

static real square_of(const real X[9]) { return dot(X, X) + dot(X + 3, X + 3) + dot(X + 6, X + 6); }

/* The rotation R that makes trace(R^T H) largest, and what that rests on. */
typedef struct best_rotation {
  quaternion q;
  real trace;     /* lambda, of S = R^T H */
  real a;         /* lambda^2 - |H|^2 */
  real curvature; /* 1 / det A, A = trace(S) I - S the second derivative; A^-1 = (S^2 + a/2 I) / det A, S^2 = H^T H */
  real condition; /* N |A^-1| */
} best_rotation;

/* det A = (s1 + s2)(s1 + s3)(s2 + s3), and |A^-1|^2 from the other two invariants of A. False where the determinant is
 * nothing but rounding. */
static int set_trace(const cloud *c, real lambda, real a, real det, real HH, best_rotation *best) {
  real det_A = K(0.5) * a * lambda - det, second = lambda * lambda + K(0.5) * a;
  best->trace = lambda;
  best->a = a;
  best->curvature = K(1.0) / det_A;
  best->condition = c->N * SQRT(second * second - K(4.0) * lambda * det_A) * best->curvature;
  return det_A > K(8.0) * EPS * HH * SQRT(HH);
}

/* lambda = s1 + s2 + s3, the largest trace(R^T H), s3 negative where H is a reflection, is the largest root of
 * p = a^2 - 8 det(H) lambda - 4 |cof H|^2 with a = lambda^2 - |H|^2 = 2 (s1 s2 + s1 s3 + s2 s3); all terms are small where
 * s2 and s3 are, so that a is carried along. Newton's iteration descends from above; what it starts from is nearly the
 * root where the points are nearly rigid. The slope is 8 det A. */
static int largest_trace(const cloud *c, real det, real HH, real CC, best_rotation *best) {
  real lambda = K(0.5) * (c->squares[0] + c->squares[1]), a = lambda * lambda - HH;
  if (a > 0 && !(a * a < K(12.0) * CC)) {
    a = SQRT(K(12.0) * CC);
    lambda = SQRT(HH + a);
  }
  for (int i = 0; i < 24; i++) {
    real slope = K(0.5) * a * lambda - det, p = (a * a - K(4.0) * CC) - K(8.0) * det * lambda;
    if (!(slope > 0)) return 0;
    real step = K(0.125) * p / slope;
    a -= step * (K(2.0) * lambda - step);
    lambda -= step;
    if (!(ABS(step) * (lambda * lambda) > SQRT(EPS) * slope && ABS(p) > K(4.0) * EPS * (a * a + K(4.0) * CC))) break;
  }
  return set_trace(c, lambda, a, det, HH, best);
}

static INLINE real dot_of_columns(const real *a, const real *b) { return a[0] * b[0] + a[3] * b[3] + a[6] * b[6]; }

/* G = H^T H + diagonal I */
static void gram(const real H[9], real diagonal, real G[9]) {
  G[0] = dot_of_columns(H, H) + diagonal;
  G[4] = dot_of_columns(H + 1, H + 1) + diagonal;
  G[8] = dot_of_columns(H + 2, H + 2) + diagonal;
  G[1] = G[3] = dot_of_columns(H, H + 1);
  G[2] = G[6] = dot_of_columns(H, H + 2);
  G[5] = G[7] = dot_of_columns(H + 1, H + 2);
}

/* R = ((a/2 + |H|^2) H + lambda cof(H) - H H^T H) / det A (Markley 1993), which has rounding errors of its own; C is
 * cof(H) before and R after. */
static void first_guess(const cloud *c, real HH, real C[9], best_rotation *best) {
  real G[9], row[3];
  gram(c->H, -(K(0.5) * best->a + HH), G);
  for (int i = 0; i < 9; i += 3) {
    rotate_back(G, c->H + i, row);
    multiply_by(best->trace, C + i);
    subtract(C + i, row, C + i);
    multiply_by(best->curvature, C + i);
  }
  best->q = quaternion_of(C);
}

/* u = A^-1 g times det A, from (H^T H + a/2 I) g. */
static void times_inverse(const real H[9], const best_rotation *best, const real g[3], real u[3]) {
  real Hg[3], rest = K(0.5) * best->a;
  rotate(H, g, Hg);
  rotate_back(H, Hg, u);
  u[0] = best->curvature * (u[0] + rest * g[0]);
  u[1] = best->curvature * (u[1] + rest * g[1]);
  u[2] = best->curvature * (u[2] + rest * g[2]);
}

/* Newton's step on the rotations. trace(R^T H) is q.(K q) / q.q with Davenport's K; its gradient is the vector part of
 * q^* (K q) times 1 / q.q, the skew-symmetric part of S. Returns whether the step was more than its own error and needs
 * another one, and the trace behind it. */
static int improve(const cloud *c, best_rotation *best, real *trace) {
  quaternion *q = &best->q;
  const real *H = c->H, *v = q->v;
  real sum = H[0] + H[4] + H[8], zx = H[7] - H[5], zy = H[2] - H[6], zz = H[3] - H[1], w = q->w;
  real xy = H[1] + H[3], xz = H[2] + H[6], yz = H[5] + H[7];
  real ux = (((H[0] - H[4]) - H[8]) * v[0] + (xy * v[1] + xz * v[2])) + w * zx;
  real uy = (((H[4] - H[0]) - H[8]) * v[1] + (xy * v[0] + yz * v[2])) + w * zy;
  real uz = (((H[8] - H[0]) - H[4]) * v[2] + (xz * v[0] + yz * v[1])) + w * zz;
  real uw = (zx * v[0] + (zy * v[1] + zz * v[2])) + sum * w, nn = dot(v, v) + w * w, share = K(1.0) / nn;
  const real u[3] = {ux, uy, uz};
  real g[3], turn[3], vxw[3];
  cross(u, v, g);
  g[0] = share * (g[0] + (w * ux - uw * v[0]));
  g[1] = share * (g[1] + (w * uy - uw * v[1]));
  g[2] = share * (g[2] + (w * uz - uw * v[2]));
  times_inverse(H, best, g, turn);
  *trace = share * (dot(u, v) + w * uw) + K(0.5) * dot(g, turn);
  cross(v, turn, vxw);
  real along = dot(v, turn), error = K(4.0) * EPS * best->condition, turned = dot(turn, turn);
  q->v[0] += K(0.5) * (w * turn[0] + vxw[0]);
  q->v[1] += K(0.5) * (w * turn[1] + vxw[1]);
  q->v[2] += K(0.5) * (w * turn[2] + vxw[2]);
  q->w -= K(0.5) * along;
  if (q->w < 0) negate(q);
  return turned > EPS / K(16.0) && turned > error * error;
}

/* C = cof(H), with its digits also where H is nearly singular, and its square, |H|^2 being HH. */
static real cofactors_of(const real H[9], real HH, real C[9]) {
  cross(H + 3, H + 6, C);
  cross(H + 6, H, C + 3);
  cross(H, H + 3, C + 6);
  real CC = square_of(C);
  if (CC >= K(0.015625) * (HH * HH)) return CC;
  exact_cross(H + 3, H + 6, C);
  exact_cross(H + 6, H, C + 3);
  exact_cross(H, H + 3, C + 6);
  return square_of(C);
}

static int rotate_best(const motion_sums *s, const cloud *c, best_rotation *best) {
  real C[9], HH, CC, coarse[2];
  for (int k = 0; k < 2; k++) coarse[k] = K(8.0) * EPS * largest(s->about + 3 * k, 3) / c->size[k];
  real least = K(8.0) * EPS + coarse[0] * coarse[1];
  HH = square_of(c->H);
  CC = cofactors_of(c->H, HH, C);
  least *= c->N;
  if (HH <= least * least) return CHS_ERR_SINGULAR;
  if (CC <= HH * (least * least)) return CHS_ERR_COLLINEAR;
  real det = dot(c->H, C), trace;
  if (!largest_trace(c, det, HH, CC, best)) return CHS_ERR_SINGULAR;
  first_guess(c, HH, C, best);
  int moved = 1;
  for (int i = 0; i < 8 && moved; i++) {
    moved = improve(c, best, &trace);
    if (moved || ABS(best->trace - trace) <= K(8.0) * EPS * c->N) continue;
    if (!set_trace(c, trace, trace * trace - HH, det, HH, best)) return CHS_ERR_SINGULAR; /* it was no such root */
    moved = 1;
  }
  return !moved && best->condition * (K(8.0) * EPS) < 1 ? CHS_OK : CHS_ERR_SINGULAR;
}

/* The squared residuals, relative to the squared size of the initial cloud, from what was summed. */
static real relative_square(const cloud *c, const best_rotation *best) {
  real rest = c->squares[0] + c->squares[1] - K(2.0) * best->trace;
  return rest > 0 ? rest / c->squares[0] : K(0.0);
}

/* Where neither the centroid nor its displacement over twice the tangent of the half-angle nears the end of the format,
 * the axis is within it, whatever the screw is asked for. */
static int axis_within(const cloud *c, real n) {
  const real most = REAL_MAX * K(0.015625);
  return largest(c->center, 3) <= most && largest(c->travel, 3) <= most * (n < 1 ? n : K(1.0));
}

/* The screw and the pose, and what is special about them. A rotation smaller than its own error counts as none. */
static int displace(const cloud *c, best_rotation *best, screw *out, real T[16]) {
  quaternion *q = &best->q;
  real R[9], p[3], vv = dot(q->v, q->v), n = SQRT(vv), zone = K(8.0) * EPS * best->condition;
  if (n <= best->condition * EPS * q->w) return FN(chs_p_finish_translation)(c->travel, out, T);
  int half_turn = q->w <= zone * n;
  settle_half_turn(q, zone, n);
  rotation_from_quaternion(q, vv + q->w * q->w, R);
  rotate(R, c->center, p);
  subtract(c->center, p, p);
  add_to(p, c->travel);
  if (!all_finite(p, 3)) return CHS_ERR_OVERFLOW;
  if (out || !axis_within(c, n)) {
    screw s;
    screw_through(c->center, c->travel, q->v, K(1.0) / n, q->w / n, &s);
    s.angle = K(2.0) * FN(chs_p_angle_of)(n, q->w > 0 ? q->w : K(0.0));
    if (!is_finite_screw(&s)) return CHS_ERR_OVERFLOW;
    if (out) *out = s;
  }
  if (T) join(R, p, T);
  if (best->condition * SQRT(EPS) > K(1.0)) return CHS_ILL_CONDITIONED;
  return half_turn ? CHS_HALF_TURN : CHS_OK;
}

/* What is special about the points counts for less. */
static int with_missing(const motion_sums *s, int status) {
  return status == CHS_OK && s->missing > 0 ? CHS_POINTS_MISSING : status;
}

static int solve(const motion_sums *s, cloud *c, best_rotation *best) {
  if (s->points < 3) return CHS_ERR_TOO_FEW_POINTS;
  int status = read_cloud(s, c);
  return status == CHS_OK ? rotate_best(s, c, best) : status;
}

static void describe(const motion_sums *s, const cloud *c, const best_rotation *best, motion_quality *quality) {
  quality->points = s->points;
  quality->missing = s->missing;
  quality->size = c->size[0];
  quality->growth = (c->size[1] - c->size[0]) / c->size[0];
  quality->condition = best->condition;
  quality->rigidity = quality->rms / c->size[0];
}

void FN(chs_motion_begin)(motion_sums *s) {
  s->scale = 1;
  s->about_weight = 0;
  for (int k = 0; k < 6; k++) s->about[k] = 0;
  for (int k = 0; k < SUMS; k++) s->sum[k] = s->lost[k] = 0;
  s->points = s->missing = 0;
}

int FN(chs_motion_add)(motion_sums *s, const real initial[3], const real final[3], real weight) {
  const run point = {1, initial, final, &weight};
  return add_point(s, &point);
}

/* The stretches of points that are there. */
static int add_all(motion_sums *s, const run *all, const unsigned char *missing) {
  if (!missing) return add_run(s, all);
  for (size_t i = 0; i < all->count;) {
    run stretch = rest_of(all, i);
    for (stretch.count = 0; i < all->count && !missing[i]; i++) stretch.count++;
    int status = add_run(s, &stretch);
    if (status < 0) return status;
    for (; i < all->count && missing[i]; i++) s->missing++;
  }
  return CHS_OK;
}

static int is_there(const run *r, const unsigned char *missing, size_t i) {
  return !(missing && missing[i]) && weight_of(r, i) != 0 && all_finite(r->initial + 3 * i, 3) &&
         all_finite(r->final + 3 * i, 3);
}

/* The second look at the points: what each is off by. */
static void look_back(const motion_sums *s, const cloud *c, const best_rotation *best, const run *r,
                      const unsigned char *missing, motion_quality *found) {
  exact_sum sum = {0, 0}; /* however many points there are */
  real R[9], most = -1, nn = dot(best->q.v, best->q.v) + best->q.w * best->q.w;
  rotation_from_quaternion(&best->q, nn, R);
  int gaps = s->missing > 0 || r->weights;
  for (size_t i = 0; i < r->count; i++) {
    if (gaps && !is_there(r, missing, i)) continue;
    real x[3], y[3], off[3];
    const real *p = r->initial + 3 * i, *q = r->final + 3 * i;
    for (int k = 0; k < 3; k++) {
      x[k] = s->scale * ((p[k] - s->about[k]) - c->offset[k]);
      y[k] = s->scale * ((q[k] - s->about[3 + k]) - c->offset[3 + k]);
    }
    rotate(R, x, off);
    subtract(y, off, off);
    real square = dot(off, off);
    exact_sum weighted = {r->weights ? r->weights[i] * square : square, 0};
    add(&sum, weighted);
    if (square > most) {
      most = square;
      found->largest_at = i;
    }
  }
  found->rms = SQRT((sum.hi + sum.lo) / total(s, WEIGHT)) / s->scale;
  found->largest = SQRT(most) / s->scale;
}

/* All that follows once the points are summed; r is NULL where they cannot be looked at again. Apart, for while points
 * are summed its memory need not be there. */
static APART int conclude(const motion_sums *s, const run *r, const unsigned char *missing, real tolerance, screw *out,
                          real T[16], motion_quality *quality) {
  cloud c;
  best_rotation best;
  motion_quality found;
  int status = solve(s, &c, &best);
  if (status != CHS_OK) return status;
  /* What was summed settles most questions of tolerance. */
  real square = relative_square(&c, &best), doubt = K(64.0) * EPS * (c.squares[0] + c.squares[1]) / c.squares[0];
  if (!r) {
    found.rms = SQRT(square) * c.size[0];
    found.largest = K(-1.0);
    found.largest_at = s->points;
  } else if (quality || !(tolerance > 0 && square + doubt < tolerance * tolerance))
    look_back(s, &c, &best, r, missing, &found);
  else
    found.rms = 0;
  describe(s, &c, &best, &found);
  if (!(found.rigidity <= tolerance)) return CHS_ERR_NOT_RIGID;
  status = with_missing(s, displace(&c, &best, out, T));
  if (status >= 0 && quality) *quality = found;
  return status;
}

int FN(chs_motion_finish)(const motion_sums *s, real tolerance, screw *out, real T[16], motion_quality *quality) {
  return conclude(s, NULL, NULL, tolerance, out, T, quality);
}

int FN(chs_motion_fit)(size_t n, const real *initial, const real *final, const real *weights,
                       const unsigned char *missing, real tolerance, screw *out, real T[16], motion_quality *quality) {
  motion_sums s;
  const run all = {n, initial, final, weights};
  FN(chs_motion_begin)(&s);
  int status = add_all(&s, &all, missing);
  return status == CHS_OK ? conclude(&s, &all, missing, tolerance, out, T, quality) : status;
}

/* C = J P J^T for J of n rows of three, P symmetric, plus block (I - e e^T) in rows and columns 3 to 5 and `seventh` in row
 * and column 6. C may be NULL: the result is the trace of the first three rows, and no number where C is not finite. */
static real spread(int n, const real *J, const real P[9], const real e[3], real block, real seventh, real *C) {
  real trace = 0;
  for (int i = 0; i < n; i++) {
    real row[3];
    rotate_back(P, J + 3 * i, row);
    for (int j = 0; j < n; j++) {
      real x = dot(row, J + 3 * j);
      if (i / 3 == 1 && j / 3 == 1) x += block * ((i == j ? K(1.0) : K(0.0)) - e[i - 3] * e[j - 3]);
      if (i == 6 && j == 6) x += seventh;
      trace += i == j && i < 3 ? x : K(0.0) * x;
      if (C) C[n * i + j] = x;
    }
  }
  return trace;
}

/* How a small turn w of the rotation in the final frame moves the screw. */
typedef struct screw_slopes {
  const real *e;
  real middle[3], travel[3];
  real cotangent, inverse_square; /* of half the angle, and of its sine */
} screw_slopes;

/* de = 1/2 (cot(theta/2) (w - (e.w) e) - e x w); the rest are the differentials of eq. 10 and 24. */
static void slopes_by_turn(const screw_slopes *s, const real w[3], real slope[8]) {
  real exw[3], exD[3], dexD[3], *de = slope, *dA = slope + 3, along = dot(s->e, w);
  cross(s->e, w, exw);
  for (int i = 0; i < 3; i++) de[i] = K(0.5) * (s->cotangent * (w[i] - along * s->e[i]) - exw[i]);
  cross(s->e, s->travel, exD);
  cross(de, s->travel, dexD);
  real dM = dot(de, s->middle), M = dot(s->e, s->middle), dcot = K(-0.5) * along * s->inverse_square;
  for (int i = 0; i < 3; i++) dA[i] = K(0.5) * (dcot * exD[i] + s->cotangent * dexD[i]) - (dM * s->e[i] + M * de[i]);
  slope[6] = dot(de, s->travel);
  slope[7] = along;
}

/* What the covariances are made of: the variance of the rotation in the initial frame, R, the axis where there is one, and
 * the variance of a centroid's component. */
typedef struct uncertainty {
  real P[9], R[9], e[3], shift;
} uncertainty;

/* The covariance of the pose; as spread. */
static APART real pose_covariance(const cloud *c, const uncertainty *u, real *C) {
  const real none[3] = {0};
  real J[18], arm[3], column[3];
  rotate(u->R, c->center, arm);
  for (int j = 0; j < 3; j++) {
    const real w[3] = {u->R[j], u->R[3 + j], u->R[6 + j]};
    cross(arm, w, column);
    for (int i = 0; i < 3; i++) {
      J[3 * i + j] = w[i];
      J[9 + 3 * i + j] = column[i];
    }
  }
  return spread(6, J, u->P, none, u->shift, 0, C);
}

/* That of the screw. A shift d of the centroid moves the point by 1/2 ((I - e e^T) + cot(theta/2) [e]) d and the
 * translation by e.d. */
static APART real screw_covariance(const cloud *c, const quaternion *q, const uncertainty *u, real *C) {
  real vv = dot(q->v, q->v), w = q->w > 0 ? q->w : K(0.0), J[24], slope[8];
  screw_slopes s = {u->e, {0}, {0}, w / SQRT(vv), (vv + w * w) / vv};
  copy(c->travel, 3, s.travel);
  for (int i = 0; i < 3; i++) s.middle[i] = c->center[i] + K(0.5) * c->travel[i];
  for (int j = 0; j < 3; j++) {
    const real axis[3] = {u->R[j], u->R[3 + j], u->R[6 + j]};
    slopes_by_turn(&s, axis, slope);
    for (int i = 0; i < 8; i++) J[3 * i + j] = slope[i];
  }
  return spread(8, J, u->P, u->e, K(0.25) * u->shift * s.inverse_square, u->shift, C);
}

/* A pure translation has no axis. */
static void read_uncertainty(const motion_sums *s, const cloud *c, best_rotation *best, int turns, real sigma,
                             uncertainty *u) {
  quaternion *q = &best->q;
  real scaled = s->scale * sigma, turn = scaled * scaled * c->reduce * best->curvature;
  for (int i = 0; i < 3 && !turns; i++) q->v[i] = 0;
  real vv = dot(q->v, q->v), n = SQRT(vv);
  rotation_from_quaternion(q, vv + q->w * q->w, u->R);
  for (int i = 0; i < 3; i++) u->e[i] = turns ? q->v[i] / n : K(0.0);
  gram(c->H, K(0.5) * best->a, u->P);
  for (int i = 0; i < 9; i++) u->P[i] *= turn;
  u->shift = sigma * (sigma / total(s, WEIGHT));
}

int FN(chs_motion_finish_covariance)(const motion_sums *sums, real sigma, real pose[36], real of_screw[64]) {
  cloud c;
  best_rotation best;
  uncertainty u;
  if (!(sigma >= 0 && sigma <= REAL_MAX)) return CHS_ERR_ARGUMENT;
  int status = solve(sums, &c, &best);
  if (status == CHS_OK) status = displace(&c, &best, NULL, NULL);
  if (status < 0) return status;
  int turns = status != CHS_PURE_TRANSLATION && status != CHS_NO_MOTION;
  if (of_screw && !turns) return CHS_ERR_SINGULAR;
  read_uncertainty(sums, &c, &best, turns, sigma, &u);
  real of_rotation = pose_covariance(&c, &u, NULL),
       of_axis = of_screw ? screw_covariance(&c, &best.q, &u, NULL) : K(0.0);
  if (!is_finite(of_rotation) || !is_finite(of_axis)) return CHS_ERR_OVERFLOW;
  if (pose) pose_covariance(&c, &u, pose);
  if (of_screw) screw_covariance(&c, &best.q, &u, of_screw);
  if (of_axis > K(0.01) || of_rotation > K(0.01)) return CHS_ILL_CONDITIONED;
  return with_missing(sums, status);
}

int FN(chs_motion_covariance)(size_t n, const real *initial, const real *final, const real *weights,
                              const unsigned char *missing, real sigma, real pose[36], real of_screw[64]) {
  motion_sums s;
  const run all = {n, initial, final, weights};
  FN(chs_motion_begin)(&s);
  int status = add_all(&s, &all, missing);
  return status == CHS_OK ? FN(chs_motion_finish_covariance)(&s, sigma, pose, of_screw) : status;
}
