/* What the header-only kernels (ldl.h, sincos_array.h, row.h) share: inlining, unrolling, vectors of numbers, padded rows.
 *
 * Kernels are functions of sizes that are constants where they are called, and nothing of a loop over such a size is left after
 * compilation with optimisation. Compilers other than gcc and clang, and all with -DTL_NO_VECTORS, get the same formulas in plain C. */
#ifndef TAYLOR_KERNEL_H
#define TAYLOR_KERNEL_H

#include "taylor/real.h"

#if defined(__GNUC__) || defined(__clang__)
#define TL_INLINE static inline __attribute__((always_inline))
#define TL_UNROLL _Pragma("GCC unroll 64")
#else
#define TL_INLINE static inline
#define TL_UNROLL
#endif

/* Rows that kernels read and write in whole vectors have a length that is a multiple of TL_ROW_PAD; TL_ROW(n) is the smallest such
 * length that holds n numbers. Kernels are fastest where rows start at a multiple of TL_ROW_PAD numbers in memory; none needs it. */
#define TL_ROW_PAD 8
#define TL_ROW(n) (((n) + TL_ROW_PAD - 1) / TL_ROW_PAD * TL_ROW_PAD)

#endif
