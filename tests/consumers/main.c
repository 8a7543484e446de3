/* A stranger's program: it prints one number made of the bits of many results, so that two builds of the library can
 * be compared. C99 and C++98 alike. */
#include <chasles/chasles.h>
#include <stdio.h>

static unsigned long hash = 2166136261UL; /* FNV-1a, 32 bits */

static void add(const void *results, size_t size) {
  const unsigned char *bytes = (const unsigned char *)results;
  for (size_t i = 0; i < size; ++i) hash = ((hash ^ bytes[i]) * 16777619UL) & 0xFFFFFFFFUL;
}

/* A number in [-4, 4), exact in float too. */
static float coordinate(void) {
  static unsigned long state = 1;
  state = (1664525UL * state + 1013904223UL) & 0xFFFFFFFFUL;
  return (float)((long)(state >> 8) - 8388608L) / 2097152.0F;
}

static void add_double(void) {
  double V[6], T[16], U[6], R[9], p[3], J[9], alpha = 0.0, beta = 0.0;
  double before[9], after[9], pose[16] = {0.0};
  chs_screw screw = {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0, 0.0};
  for (int i = 0; i < 6; ++i) V[i] = (double)coordinate() / 3.0;
  for (int i = 0; i < 9; ++i) before[i] = (double)coordinate() / 3.0;
  chs_se3_exp(V, T);
  chs_se3_log(T, U);
  chs_se3_to_parts(T, R, p);
  chs_so3_left_jacobian(V, J);
  chs_tilt_from_rotation(R, &alpha, &beta, &p[0]);
  for (int i = 0; i < 9; i += 3) chs_se3_apply(T, &before[i], &after[i]);
  chs_motion_bottema_roth(before, after, 1e-9, &screw, pose);
  add(T, sizeof T);
  add(U, sizeof U);
  add(p, sizeof p);
  add(J, sizeof J);
  add(&alpha, sizeof alpha);
  add(&beta, sizeof beta);
  add(&screw, sizeof screw);
  add(pose, sizeof pose);
}

static void add_float(void) {
  float V[6], T[16], U[6], R[9], p[3], J[9], alpha = 0.0F, beta = 0.0F;
  float before[9], after[9], pose[16] = {0.0F};
  chs_screwf screw = {{0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, 0.0F, 0.0F};
  for (int i = 0; i < 6; ++i) V[i] = coordinate() / 3.0F;
  for (int i = 0; i < 9; ++i) before[i] = coordinate() / 3.0F;
  chs_se3_expf(V, T);
  chs_se3_logf(T, U);
  chs_se3_to_partsf(T, R, p);
  chs_so3_left_jacobianf(V, J);
  chs_tilt_from_rotationf(R, &alpha, &beta, &p[0]);
  for (int i = 0; i < 9; i += 3) chs_se3_applyf(T, &before[i], &after[i]);
  chs_motion_bottema_rothf(before, after, 1e-3F, &screw, pose);
  add(T, sizeof T);
  add(U, sizeof U);
  add(p, sizeof p);
  add(J, sizeof J);
  add(&alpha, sizeof alpha);
  add(&beta, sizeof beta);
  add(&screw, sizeof screw);
  add(pose, sizeof pose);
}

int main(void) {
  for (int i = 0; i < 1000; ++i) {
    add_double();
    add_float();
  }
  printf("chasles %s %08lx\n", CHS_VERSION, hash);
  return 0;
}
