/* textbook.c - the float functions as a textbook writes them, with libm's sinf, cosf and atan2f: no care near zero,
 * near pi or for bad inputs. Only there to be counted beside the library's own.
 */
#include <chasles/chasles.h>
#include <math.h>

static float dot(const float a[3], const float b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const float a[3], const float b[3], float c[3]) {
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

/* a I + b [w] + c w w^T, times v or as a matrix of the given row length. */
static void fill(float a, float b, float c, const float w[3], int row, float *M) {
  M[0] = a + c * w[0] * w[0];
  M[1] = c * w[0] * w[1] - b * w[2];
  M[2] = c * w[0] * w[2] + b * w[1];
  M[row] = c * w[0] * w[1] + b * w[2];
  M[row + 1] = a + c * w[1] * w[1];
  M[row + 2] = c * w[1] * w[2] - b * w[0];
  M[2 * row] = c * w[0] * w[2] - b * w[1];
  M[2 * row + 1] = c * w[1] * w[2] + b * w[0];
  M[2 * row + 2] = a + c * w[2] * w[2];
}

int chs_so3_expf(const float w[3], float R[9]) {
  const float theta = sqrtf(dot(w, w));
  const float s = theta > 0.0F ? sinf(theta) / theta : 1.0F;
  const float c = cosf(theta);
  fill(c, s, theta > 0.0F ? (1.0F - c) / (theta * theta) : 0.5F, w, 3, R);
  return CHS_OK;
}

static float log_of(const float *R, int row, float w[3]) {
  w[0] = 0.5F * (R[2 * row + 1] - R[row + 2]);
  w[1] = 0.5F * (R[2] - R[2 * row]);
  w[2] = 0.5F * (R[row] - R[1]);
  const float sine = sqrtf(dot(w, w));
  const float theta = atan2f(sine, 0.5F * (R[0] + R[row + 1] + R[2 * row + 2] - 1.0F));
  const float scale = sine > 0.0F ? theta / sine : 1.0F;
  for (int i = 0; i < 3; ++i) w[i] *= scale;
  return theta;
}

int chs_so3_logf(const float R[9], float w[3]) {
  log_of(R, 3, w);
  return CHS_OK;
}

int chs_se3_expf(const float V[6], float T[16]) {
  const float theta = sqrtf(dot(V, V));
  const float s = theta > 0.0F ? sinf(theta) / theta : 1.0F;
  const float c = cosf(theta);
  const float b = theta > 0.0F ? (1.0F - c) / (theta * theta) : 0.5F;
  float G[9];
  fill(c, s, b, V, 4, T);
  fill(s, b, theta > 0.0F ? (1.0F - s) / (theta * theta) : 1.0F / 6.0F, V, 3, G);
  for (int i = 0; i < 3; ++i) T[4 * i + 3] = dot(G + 3 * i, V + 3);
  T[12] = T[13] = T[14] = 0.0F;
  T[15] = 1.0F;
  return CHS_OK;
}

int chs_se3_logf(const float T[16], float V[6]) {
  float G[9];
  const float p[3] = {T[3], T[7], T[11]};
  const float theta = log_of(T, 4, V);
  const float half = 0.5F * theta;
  const float a = theta > 0.0F ? half * cosf(half) / sinf(half) : 1.0F;
  fill(a, -0.5F, theta > 0.0F ? (1.0F - a) / (theta * theta) : 1.0F / 12.0F, V, 3, G);
  for (int i = 0; i < 3; ++i) V[3 + i] = dot(G + 3 * i, p);
  return CHS_OK;
}

int chs_tilt_errorf(const float nominal[9], const float actual[9], float *alpha, float *beta) {
  const float *N = nominal;
  const float *A = actual;
  const float x0[3] = {N[0], N[3], N[6]}, y0[3] = {N[1], N[4], N[7]}, d0[3] = {N[2], N[5], N[8]};
  const float x1[3] = {A[0], A[3], A[6]}, y1[3] = {A[1], A[4], A[7]}, d1[3] = {A[2], A[5], A[8]};
  float tilted[3];
  cross(d0, d1, tilted);
  *alpha = atan2f(sqrtf(dot(tilted, tilted)), dot(d0, d1));
  *beta = fabsf(atan2f(dot(y0, x1) - dot(x0, y1), dot(x0, x1) + dot(y0, y1)));
  return CHS_OK;
}

/* Eq. 23, 24 and 10 of Fenton & Shi, the points in the order given. */
int chs_motion_bottema_rothf(const float initial[9], const float final[9], float tolerance, chs_screwf *screw,
                             float T[16]) {
  float d3[3], d1[3], s1[3], n[3], sum[3], travel[3], turned[3];
  (void)tolerance;
  for (int i = 0; i < 3; ++i) {
    d3[i] = (final[6 + i] - final[3 + i]) - (initial[6 + i] - initial[3 + i]);
    d1[i] = (final[i] - final[3 + i]) - (initial[i] - initial[3 + i]);
    s1[i] = (final[i] - final[3 + i]) + (initial[i] - initial[3 + i]);
    sum[i] = initial[i] + final[i];
    travel[i] = final[i] - initial[i];
  }
  cross(d3, d1, n);
  const float length = sqrtf(dot(n, n));
  screw->angle = 2.0F * atan2f(length, dot(d3, s1));
  for (int i = 0; i < 3; ++i) screw->axis[i] = n[i] / length;
  screw->translation = dot(screw->axis, travel);
  cross(screw->axis, travel, turned);
  const float along = dot(screw->axis, sum);
  const float cotangent = dot(d3, s1) / length;
  for (int i = 0; i < 3; ++i) screw->point[i] = 0.5F * (sum[i] + cotangent * turned[i] - along * screw->axis[i]);
  const float sine = sinf(screw->angle);
  const float cosine = cosf(screw->angle);
  fill(cosine, sine, 1.0F - cosine, screw->axis, 4, T);
  for (int i = 0; i < 3; ++i) {
    T[4 * i + 3] = screw->point[i] - dot(T + 4 * i, screw->point) + screw->translation * screw->axis[i];
  }
  T[12] = T[13] = T[14] = 0.0F;
  T[15] = 1.0F;
  return CHS_OK;
}
