#include <chasles/motion.h>

#include "motion_private.h"

/* The two triangles, their sides divided by a power of two near the longest side so that products of any degree fit. */
typedef struct triangles {
  centroid at;
  real from[3][3]; /* from[k] and to[k]: the side opposite point k, in cyclic order, scaled */
  real to[3][3];
  real longest;   /* length of the longest initial side, scaled */
  int longest_at; /* and the point opposite to it */
  real doubled;   /* twice the initial triangle's area, scaled */
  real turned;    /* the largest change of a side's component, scaled */
  real noise;     /* the rounding of the coordinates, scaled: how far a side is uncertain */
} triangles;

/* The largest power of two not above x, for x in the format's normal range short of its ends (Rump's ufp). */
static real power_of_two_below(real x) {
  real q = x * (K(1.0) / EPS + K(1.0));
  return ABS(q - (K(1.0) - K(0.5) * EPS) * q);
}

static void sides_of(const real points[9], real side[3][3]) {
  for (int k = 0; k < 3; k++) subtract(points + 3 * ((k + 2) % 3), points + 3 * ((k + 1) % 3), side[k]);
}

static real third_of(real a, real b, real c) { return (a + b + c) / K(3.0); }

/* Points too near to each other or to a line for their rounding errors to be told from their positions. */
static int shape_status(const real squared[3], real doubled, real noise) {
  real longest_squared = largest(squared, 3);
  for (int k = 0; k < 3; k++)
    if (squared[k] <= noise * noise) return CHS_ERR_COINCIDENT;
  real height_noise = K(2.0) * noise;
  return doubled * doubled <= longest_squared * (height_noise * height_noise) ? CHS_ERR_COLLINEAR : CHS_OK;
}

static real doubled_area(real side[3][3]) {
  real normal[3];
  cross(side[0], side[1], normal);
  return norm(normal, 3);
}

static int read_triangles(const real initial[9], const real final[9], real tolerance, triangles *t) {
  int status = first_error(finiteness(initial, 9), finiteness(final, 9));
  if (status != CHS_OK) return status;
  real sides[18], from_squared[3], to_squared[3];
  sides_of(initial, t->from);
  sides_of(final, t->to);
  for (int k = 0; k < 3; k++) {
    copy(t->from[k], 3, sides + 3 * k);
    copy(t->to[k], 3, sides + 9 + 3 * k);
  }
  real reach = largest(initial, 9) > largest(final, 9) ? largest(initial, 9) : largest(final, 9);
  real most = largest(sides, 18);
  if (!is_finite(most)) return CHS_ERR_OVERFLOW;
  if (most == 0) return CHS_ERR_COINCIDENT;
  /* Two factors, since one alone may be beyond the format. */
  real enlarge = safe_to_square(most), scale = K(1.0) / power_of_two_below(enlarge * most);
  t->noise = K(4.0) * EPS * (scale * (enlarge * reach));
  t->turned = 0;
  t->longest_at = 0;
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      t->from[k][i] = scale * (enlarge * t->from[k][i]);
      t->to[k][i] = scale * (enlarge * t->to[k][i]);
      real change = ABS(t->to[k][i] - t->from[k][i]);
      t->turned = change > t->turned ? change : t->turned;
    }
    from_squared[k] = dot(t->from[k], t->from[k]);
    to_squared[k] = dot(t->to[k], t->to[k]);
    if (from_squared[k] > from_squared[t->longest_at]) t->longest_at = k;
  }
  real longest_squared = from_squared[t->longest_at];
  t->doubled = doubled_area(t->from);
  status = shape_status(from_squared, t->doubled, t->noise);
  if (status == CHS_OK) status = shape_status(to_squared, doubled_area(t->to), t->noise);
  if (status != CHS_OK) return status;
  for (int k = 0; k < 3; k++)
    if (!(ABS(to_squared[k] - from_squared[k]) <= K(2.0) * tolerance * longest_squared)) return CHS_ERR_NOT_RIGID;
  t->longest = SQRT(longest_squared);
  for (int i = 0; i < 3; i++) {
    t->at.center[i] = third_of(initial[i], initial[3 + i], initial[6 + i]);
    t->at.travel[i] = third_of(final[i] - initial[i], final[3 + i] - initial[3 + i], final[6 + i] - initial[6 + i]);
  }
  return CHS_OK;
}

/* Eq. 23 for the vectors x and y of the body, which became xf and yf: q = (v; w) proportional to (sin(theta/2) e;
 * cos(theta/2)). Returns how much it tells: its squared length over the squares of what the rounding errors of x and y
 * are multiplied by, those of y counted double because y may be a product itself. */
static real half_angle_vector(const real x[3], const real xf[3], const real y[3], const real yf[3], quaternion *q) {
  real dx[3], dy[3], sum[3];
  for (int i = 0; i < 3; i++) {
    dx[i] = xf[i] - x[i];
    dy[i] = yf[i] - y[i];
    sum[i] = yf[i] + y[i];
  }
  cross(dx, dy, q->v);
  q->w = dot(dx, sum);
  q->short_of_4 = 0;
  return (dot(q->v, q->v) + q->w * q->w) / (K(4.0) * dot(dx, dx) + dot(dy, dy) + dot(sum, sum));
}

/* The rotation of Laub & Shiflett: eq. 12 and 13 with both origins moved into the plane's own frame (f1, f2, f3), f1
 * along the longest side and f3 normal to the plane. Q maps f1 and f2 to g1 and g2, and cof(Q) maps f3 to g1 x g2. */
static quaternion frame_quaternion(const triangles *t) {
  const real *a = t->from[t->longest_at], *af = t->to[t->longest_at];
  const real *c = t->from[(t->longest_at + 1) % 3], *cf = t->to[(t->longest_at + 1) % 3];
  real f1[3], f2[3], f3[3], g1[3], g2[3], g3[3], R[9];
  for (int i = 0; i < 3; i++) {
    f1[i] = a[i] / t->longest;
    g1[i] = af[i] / t->longest;
  }
  cross(a, c, f3);
  unit(f3, f3);
  cross(f3, f1, f2);
  real along = dot(c, f1), height = t->doubled / t->longest;
  for (int i = 0; i < 3; i++) g2[i] = (cf[i] - along * g1[i]) / height;
  cross(g1, g2, g3);
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++) R[3 * i + j] = g1[i] * f1[j] + g2[i] * f2[j] + g3[i] * f3[j];
  return quaternion_of(R);
}

int FN(chs_motion_bottema_roth)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  triangles t;
  int status = read_triangles(initial, final, tolerance, &t);
  if (status != CHS_OK) return status;
  if (t.turned <= t.noise) return finish_translation(&t.at, out, T);

  /* The order of the points makes no difference to (v; w), but an axis parallel to their plane makes it 0/0 in any
   * order, and one along a thin triangle nearly so. Two sides and the normal of the plane are never all of one kind:
   * the pair that tells most is taken, the normal as the second vector, whose sum is then the shorter. */
  const real *a = t.from[(t.longest_at + 2) % 3], *af = t.to[(t.longest_at + 2) % 3];
  const real *c = t.from[(t.longest_at + 1) % 3], *cf = t.to[(t.longest_at + 1) % 3];
  real normal[3], normal_f[3];
  cross(a, c, normal);
  cross(af, cf, normal_f);
  quaternion q, other;
  real most = half_angle_vector(a, af, c, cf, &q);
  real tells = half_angle_vector(a, af, normal, normal_f, &other);
  if (tells > most) {
    q = other;
    most = tells;
  }
  tells = half_angle_vector(c, cf, normal, normal_f, &other);
  if (tells > most) {
    q = other;
    most = tells;
  }
  if (q.w < 0) negate(&q);
  /* Each (v; w) is as long as the sides have turned, times the height of the triangle. Much shorter ones come from
   * sides that changed their lengths rather than turned, by measuring errors, and would be those errors magnified. */
  real height = t.doubled / (t.longest * t.longest);
  if (most < K(0.1) * (t.turned * height) * (t.turned * height)) q = frame_quaternion(&t);
  return finish_rotation(&t.at, t.longest * t.longest / t.doubled, &q, out, T);
}

int FN(chs_motion_laub_shiflett)(const real initial[9], const real final[9], real tolerance, screw *out, real T[16]) {
  triangles t;
  int status = read_triangles(initial, final, tolerance, &t);
  if (status != CHS_OK) return status;
  if (t.turned <= t.noise) return finish_translation(&t.at, out, T);

  quaternion q = frame_quaternion(&t);
  return finish_rotation(&t.at, t.longest * t.longest / t.doubled, &q, out, T);
}
