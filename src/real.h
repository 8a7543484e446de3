/* The two precisions from one source: X.c compiles for double, Xf.c is `#define CHS_SINGLE` and #include "X.c".
 *
 * Included first by every source file, because it also nails down the arithmetic. The same input must give the same
 * bits with every compiler, also in a build that knows nothing of this library's flags.
 */
#ifndef CHASLES_REAL_H
#define CHASLES_REAL_H

#include "vectors.h"
#include <float.h>
#include <math.h>
#include <stddef.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "chasles needs IEEE arithmetic: compile it without -ffast-math or -ffinite-math-only"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "chasles needs operations rounded to their own type: on 32-bit x86 use -msse2 -mfpmath=sse"
#endif

/* a*b + c is two roundings, never one. gcc does not know the standard pragma and contracts unless told so here; and its
 * vectoriser of straight-line code (seen in gcc 12) makes fused a*b -+ c of neighbouring results all the same, so that
 * only a source without differences of products may have it: one that defines SUMS_ALONE. */
#if defined(__GNUC__) && !defined(__clang__) && defined(SUMS_ALONE)
#pragma GCC optimize("fp-contract=off")
#elif defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off", "no-tree-slp-vectorize")
#else
#pragma STDC FP_CONTRACT OFF
#endif

/* INLINE is for the few functions that are worth their copies where they are called, but not where size counts (-Os, as
 * gcc and clang tell); APART for those that should not be copied, nor take stack where they are not called; SELDOM for
 * those, too, that should not lie in the way of the ordinary case. */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define INLINE inline __attribute__((always_inline))
#else
#define INLINE inline
#endif
#if defined(__GNUC__)
#define APART __attribute__((noinline))
#define SELDOM __attribute__((noinline, cold))
#else
#define APART
#define SELDOM
#endif

/* Before a loop whose bounds are known once it is inlined: written out where code may be large and processors have much
 * to do at a time, which gcc does not do by itself at -O2. */
#if defined(__GNUC__) && !defined(__clang__) && VECTORS
#define UNROLL _Pragma("GCC unroll 8")
#else
#define UNROLL
#endif

/* What a private header defines, under a name with the library's prefix: #define norm(...) FN(chs_p_norm)(__VA_ARGS__).
 * Where speed counts, each source has its own to inline. Where size does, C99's inline lets a call go to the only one in
 * the library, which kernels.c defines; so these functions may use nothing that is static. */
#if defined(DEFINE_SHARED)
#define SHARED extern inline
#elif defined(__OPTIMIZE_SIZE__) && !defined(__GNUC_GNU_INLINE__)
#define SHARED inline
#else
#define SHARED static inline
#endif

/* LARGE is SHARED for what is worth copies only where code may be large, whatever else it is compiled for: elsewhere a
 * source sees no more than the prototype. The bodies stand at the end of their header, #if LARGE_BODIES. */
#if defined(DEFINE_SHARED)
#define LARGE APART
#define LARGE_BODIES 1
#elif VECTORS
#define LARGE static inline
#define LARGE_BODIES 1
#else
#define LARGE
#define LARGE_BODIES 0
#endif

/* SHARED of what is worth its copies, as with INLINE. */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define SHARED_INLINE SHARED __attribute__((always_inline))
#else
#define SHARED_INLINE SHARED
#endif

/* In front of a loop over the four entries of a pose's row. Where there are vectors gcc shall not unroll it before its
 * vectoriser comes, but may unroll what that leaves; where there are none it shall write out all four. */
#if !defined(__GNUC__) || defined(__clang__) || __GNUC__ < 8 || defined(__OPTIMIZE_SIZE__)
#define OVER_ROW
#elif VECTORS
#define OVER_ROW _Pragma("GCC unroll 2")
#else
#define OVER_ROW _Pragma("GCC unroll 4")
#endif

/* In front of a loop over two numbers that shall be a vector where there are vectors, and else two statements. */
#if !defined(__GNUC__) || defined(__clang__) || __GNUC__ < 8
#define OVER_PAIR
#elif VECTORS
#define OVER_PAIR _Pragma("GCC unroll 1")
#else
#define OVER_PAIR _Pragma("GCC unroll 2")
#endif

#ifdef CHS_SINGLE
typedef float real;
#define FN(name) name##f
#define K(literal) literal##F
#define EPS FLT_EPSILON
#define REAL_MAX FLT_MAX
#define SQRT sqrtf
#define ABS fabsf
/* Numbers below UNDERFLOWS or above OVERFLOWS may not be squared; times ENLARGE or REDUCE they may. All powers of 2. */
#define UNDERFLOWS 0x1p-50F
#define OVERFLOWS 0x1p+50F
#define ENLARGE 0x1p+90F
#define REDUCE 0x1p-80F
/* Lost beside 1. Added to a number that may be small, it keeps the powers of that out of the subnormal numbers, where
 * some processors are slow. */
#define NEGLIGIBLE 0x1p-31F
/* Adding and subtracting it rounds a number to a multiple of 2^-3; see split_square in angle.h. */
#define GRID 0x1.8p+20F
/* Numbers up to it, rounded so, have exact squares, and a sum of three of them is exact. */
#define NEAR 0x1.8p+8F
/* Nearer to a multiple of 2 pi what is left of such a one has too few digits for those who count relative errors. */
#define CLOSE_BY 0.25F
/* Adding and subtracting it rounds a number to an integer. */
#define TO_INTEGER 0x1.8p+23F
/* Times it, a number splits into two halves whose products are exact (Veltkamp). */
#define SPLITTER 0x1.002p+12F
#else
typedef double real;
#define FN(name) name
#define K(literal) literal
#define EPS DBL_EPSILON
#define REAL_MAX DBL_MAX
#define SQRT sqrt
#define ABS fabs
#define UNDERFLOWS 0x1p-500
#define OVERFLOWS 0x1p+500
#define ENLARGE 0x1p+600
#define REDUCE 0x1p-600
#define NEGLIGIBLE 0x1p-62
#define GRID 0x1.8p+42 /* multiples of 2^-10 */
#define NEAR 0x1.8p+15
#define CLOSE_BY 0x1p-6
#define TO_INTEGER 0x1.8p+52
#define SPLITTER 0x1.0000002p+27
#endif

#endif
