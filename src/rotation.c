#include "pose.h"

real FN(chs_p_deviation)(const real R[9]) {
  real off[6], poison = 0;
  offsets(R, off);
  for (int i = 0; i < 6; i++) poison += K(0.0) * off[i];
  return largest(off, 6) + poison;
}

static real determinant(const real M[9]) {
  real third[3];
  cross(M, M + 3, third);
  return dot(M + 6, third);
}

/* Of entries that are too small or too large for the products. */
SELDOM static real scaled_determinant(const real M[9]) {
  real most = largest(M, 9), scale = safe_to_square(most), scaled[9];
  for (int i = 0; i < 9; i++) scaled[i] = (scale * M[i]) / (scale * most);
  return determinant(scaled);
}

int FN(chs_p_rotation_status)(const real R[9], real tolerance) {
  if (!all_finite(R, 9)) return finiteness(R, 9);
  real d = determinant(R), size = ABS(d);
  if (!(size > UNDERFLOWS && size <= REAL_MAX)) d = scaled_determinant(R);
  if (d < 0) return CHS_ERR_REFLECTION;
  return FN(chs_p_deviation)(R) <= tolerance ? CHS_OK : CHS_ERR_NOT_ROTATION;
}

int FN(chs_p_check_pose)(const real T[16]) {
  real R[9], p[3];
  return read_pose(T, R, p);
}

void FN(chs_p_settle_half_turn)(quaternion *q, real zone, real length) {
  if (q->w > zone * length) return;
  for (int i = 0; i < 3; i++) {
    if (ABS(q->v[i]) <= zone * length) continue;
    if (q->v[i] < 0) negate(q);
    return;
  }
}
