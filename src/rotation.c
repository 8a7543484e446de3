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

/* The first component other than 0 of the rotation vector of an exact half-turn, w = 0, is made positive. */
int FN(chs_p_half_turn)(real w, real vector[3]) {
  real first = vector[0] != 0 ? vector[0] : vector[1] != 0 ? vector[1] : vector[2];
  if (w == 0 && first < 0)
    for (int i = 0; i < 3; i++) vector[i] = K(0.0) - vector[i];
  return CHS_HALF_TURN;
}
