/* chasles/array.h - many at once: functions of so3.h, se3.h, screw.h, motion.h and tilt.h over arrays.
 *
 * Each does to every element what the single function does, with the same bits and the same status. Where the processor
 * has vector instructions ordinary elements go through in blocks of 16, which compilers make them of. chasles.h has the
 * conventions that all headers share.
 *
 *   n         how many elements; 0 is allowed.
 *   strides   from the start of an element to that of the next, in numbers, not bytes: 9 for rotations that follow one
 *             another. At least the size of an element, but for an input that is the same for all: there 0.
 *   screws    one after the other.
 *   statuses  n answers of the single function, or NULL.
 *
 * An element that fails keeps its output. An output array may be the same as an input array where their elements start
 * at the same places with the same stride and are of the same size; any other overlap is not allowed.
 * Functions that return a status return the first error of all elements, else the first positive status, else CHS_OK.
 */
#ifndef CHASLES_ARRAY_H
#define CHASLES_ARRAY_H

#include <chasles/screw.h>
#include <chasles/status.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* R_i = exp [w_i], as chs_so3_exp; the error is its own. */
int chs_so3_exp_array(size_t n, const double *w, size_t w_stride, double *R, size_t R_stride, int *statuses);
int chs_so3_exp_arrayf(size_t n, const float *w, size_t w_stride, float *R, size_t R_stride, int *statuses);

/* w_i = log R_i, as chs_so3_log. */
int chs_so3_log_array(size_t n, const double *R, size_t R_stride, double *w, size_t w_stride, int *statuses);
int chs_so3_log_arrayf(size_t n, const float *R, size_t R_stride, float *w, size_t w_stride, int *statuses);

/* T_i = exp [V_i], as chs_se3_exp. */
int chs_se3_exp_array(size_t n, const double *V, size_t V_stride, double *T, size_t T_stride, int *statuses);
int chs_se3_exp_arrayf(size_t n, const float *V, size_t V_stride, float *T, size_t T_stride, int *statuses);

/* V_i = log T_i, as chs_se3_log. */
int chs_se3_log_array(size_t n, const double *T, size_t T_stride, double *V, size_t V_stride, int *statuses);
int chs_se3_log_arrayf(size_t n, const float *T, size_t T_stride, float *V, size_t V_stride, int *statuses);

/* C_i = A_i B_i, as chs_se3_compose. */
void chs_se3_compose_array(size_t n, const double *A, size_t A_stride, const double *B, size_t B_stride, double *C,
                           size_t C_stride);
void chs_se3_compose_arrayf(size_t n, const float *A, size_t A_stride, const float *B, size_t B_stride, float *C,
                            size_t C_stride);

/* y_i = R_i x_i + p_i, as chs_se3_apply: T_stride 0 moves many points by one pose. */
void chs_se3_apply_array(size_t n, const double *T, size_t T_stride, const double *x, size_t x_stride, double *y,
                         size_t y_stride);
void chs_se3_apply_arrayf(size_t n, const float *T, size_t T_stride, const float *x, size_t x_stride, float *y,
                          size_t y_stride);

/* alpha_i and beta_i, one number after the other, as chs_tilt_error: nominal_stride 0 compares many orientations with
 * one. */
int chs_tilt_error_array(size_t n, const double *nominal, size_t nominal_stride, const double *actual,
                         size_t actual_stride, double *alpha, double *beta, int *statuses);
int chs_tilt_error_arrayf(size_t n, const float *nominal, size_t nominal_stride, const float *actual,
                          size_t actual_stride, float *alpha, float *beta, int *statuses);

/* screws_i of T_i, as chs_screw_from_pose. */
int chs_screw_from_pose_array(size_t n, const double *T, size_t T_stride, chs_screw *screws, int *statuses);
int chs_screw_from_pose_arrayf(size_t n, const float *T, size_t T_stride, chs_screwf *screws, int *statuses);

/* The displacement that takes the three points initial_i to final_i, by a method of motion.h: initial_stride 0 gives
 * where a body is that was once at initial. screws or T may be NULL. */
int chs_motion_bottema_roth_array(size_t n, const double *initial, size_t initial_stride, const double *final,
                                  size_t final_stride, double tolerance, chs_screw *screws, double *T, size_t T_stride,
                                  int *statuses);
int chs_motion_bottema_roth_arrayf(size_t n, const float *initial, size_t initial_stride, const float *final,
                                   size_t final_stride, float tolerance, chs_screwf *screws, float *T, size_t T_stride,
                                   int *statuses);
int chs_motion_laub_shiflett_array(size_t n, const double *initial, size_t initial_stride, const double *final,
                                   size_t final_stride, double tolerance, chs_screw *screws, double *T, size_t T_stride,
                                   int *statuses);
int chs_motion_laub_shiflett_arrayf(size_t n, const float *initial, size_t initial_stride, const float *final,
                                    size_t final_stride, float tolerance, chs_screwf *screws, float *T, size_t T_stride,
                                    int *statuses);
int chs_motion_spoor_veldpaus_array(size_t n, const double *initial, size_t initial_stride, const double *final,
                                    size_t final_stride, double tolerance, chs_screw *screws, double *T,
                                    size_t T_stride, int *statuses);
int chs_motion_spoor_veldpaus_arrayf(size_t n, const float *initial, size_t initial_stride, const float *final,
                                     size_t final_stride, float tolerance, chs_screwf *screws, float *T,
                                     size_t T_stride, int *statuses);

#ifdef __cplusplus
}
#endif

#endif
