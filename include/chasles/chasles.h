/* chasles/chasles.h - the whole library, and the conventions that every header keeps.
 *
 * Matrices    Flat and row-major: R[9] is 3x3, R[3*i + j] row i, column j; T[16] is a 4x4 pose [R p; 0 1]. A two-
 *             dimensional array passes as &T[0][0].
 * Vectors     [3]; n points are [3*n], one point after the other. Twists are (omega; v), wrenches (moment; force).
 * Frames      Right-handed. R_ab has the axes of frame b as its columns, in coordinates of frame a; T_ab likewise, with
 *             the origin of b as its last column. Both take coordinates in b to coordinates in a.
 * Angles      Radians, positive by the right-hand rule.
 * Lengths     Any unit, the same in and out.
 * Precisions  Each function exists twice: chs_so3_exp in double, chs_so3_expf in float. eps is 2^-52 or 2^-23.
 *
 * Arguments   Sizes and inputs first, outputs last. No pointer may be NULL unless its comment says so. Outputs may
 *             overlap inputs in any way: every input is read before the first output is written. Outputs must not
 *             overlap each other.
 * Answers     A function that can fail returns a chs_status (status.h): 0 or positive, the outputs are valid; negative,
 *             nothing was written. Plain algebra returns void and lets NaN and infinity through.
 * Errors      CHS_EPS_NAME beside a function's prototype is its promise: the largest error, in eps, relative to the
 *             scale that the comment names. The tests and the host program read the same macro. Exact means 0. Below
 *             the format's normal range, where the format itself has fewer digits, errors are absolute.
 * Bits        The same input gives the same bits on every IEEE 754 machine, with every compiler and optimisation.
 *             Only + - * / sqrt fabs and comparisons are used, no fused multiply-add, and nothing else of libm.
 * Memory      No allocation, no static data that is written, no recursion, no stdio, no errno. Every function may be
 *             called from any thread or interrupt.
 */
#ifndef CHASLES_CHASLES_H
#define CHASLES_CHASLES_H

#define CHS_VERSION_MAJOR 0
#define CHS_VERSION_MINOR 1
#define CHS_VERSION_PATCH 0
#define CHS_VERSION "0.1.0"

#include <chasles/agile_eye.h>
#include <chasles/array.h>
#include <chasles/chain.h>
#include <chasles/line.h>
#include <chasles/motion.h>
#include <chasles/screw.h>
#include <chasles/se3.h>
#include <chasles/so3.h>
#include <chasles/status.h>
#include <chasles/tilt.h>

#endif
