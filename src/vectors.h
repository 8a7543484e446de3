#ifndef CHASLES_VECTORS_H
#define CHASLES_VECTORS_H

/* The processor has vector instructions and memory enough that code may be large. */
#if !defined(__OPTIMIZE_SIZE__) && (defined(__SSE2__) || defined(_M_X64) || defined(__ARM_NEON) || \
                                    defined(_M_ARM64) || defined(__VSX__) || defined(__riscv_vector))
#define VECTORS 1
#else
#define VECTORS 0
#endif

#endif
