#include "rotation.h"

real FN(chs_p_deviation)(const real R[9]) {
  real off[6], poison = 0;
  offsets(R, off);
  for (int i = 0; i < 6; i++) poison += K(0.0) * off[i];
  return largest(off, 6) + poison;
}

static real determinant_sign(const real M[9]) {
  real scaled[9], third[3], scale = K(1.0) / largest(M, 9);
  for (int i = 0; i < 9; i++) scaled[i] = scale * M[i];
  cross(scaled, scaled + 3, third);
  return dot(scaled + 6, third);
}

int FN(chs_p_rotation_status)(const real R[9], real tolerance) {
  int status = finiteness(R, 9);
  if (status != CHS_OK) return status;
  if (determinant_sign(R) < 0) return CHS_ERR_REFLECTION;
  return FN(chs_p_deviation)(R) <= tolerance ? CHS_OK : CHS_ERR_NOT_ROTATION;
}
