/* What the header-only kernels (ldl.h, sincos_array.h, row.h, power.h) share: inlining, unrolling, vectors of numbers, padded rows.
 *
 * Kernels are functions of sizes that are constants where they are called; an optimising compiler leaves no loop over a small size, and
 * no array of the caller's that has no other use. Other compilers than gcc and clang, and all with -DTL_NO_VECTORS, get the same
 * formulas without vectors. */
#ifndef TAYLOR_KERNEL_H
#define TAYLOR_KERNEL_H

#include "taylor/real.h"

/* Forced where that is worth the compiler's time: not without optimisation, nor with a sanitizer's checks at each access. */
#if defined(__SANITIZE_ADDRESS__)
#define TL_CHECKED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(undefined_behavior_sanitizer)
#define TL_CHECKED 1
#endif
#endif
#if defined(__OPTIMIZE__) && !defined(TL_CHECKED) /* gcc's and clang's name */
#define TL_INLINED 1
#define TL_INLINE static inline __attribute__((always_inline))
#else
#define TL_INLINED 0
#define TL_INLINE static inline
#endif

/* TL_VECTORS is 1 where there are vectors, of float or double only. All are of four numbers, whatever the processor has: an operation
 * is then one instruction or two. Eight at a time would slow down the scalar code between them. */
#if !defined(TL_NO_VECTORS) && !defined(TL_REAL_LANES) && (TL_REAL == TL_FLOAT || TL_REAL == TL_DOUBLE) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define TL_VECTORS 1
#endif
#endif
#ifndef TL_VECTORS
#define TL_VECTORS 0
#endif

/* 1 where kernels work on one number of C's float or double at a time, and may know its bits. */
#if !TL_VECTORS && !defined(TL_REAL_LANES) && (TL_REAL == TL_FLOAT || TL_REAL == TL_DOUBLE)
#define TL_SINGLE_NUMBERS 1
#else
#define TL_SINGLE_NUMBERS 0
#endif

/* 1 where arithmetic on numbers is functions of the compiler's: the processor has no instructions for it, and libtaylor takes integers
 * where they are faster. With 0 its results are to the bit those of a processor that has them. */
#ifndef TL_SOFT_NUMBERS
#if defined(__arm__) && !defined(__ARM_FP)
#define TL_SOFT_NUMBERS 1
#elif defined(__arm__) && !(__ARM_FP & 4 && TL_REAL == TL_FLOAT) && !(__ARM_FP & 8)
#define TL_SOFT_NUMBERS 1
#else
#define TL_SOFT_NUMBERS 0
#endif
#endif

/* Before a loop whose length is a small constant once its function is inlined: numbers that a processor's registers hold. */
#if TL_INLINED && !defined(TL_REAL_LANES) && (TL_REAL == TL_FLOAT || TL_REAL == TL_DOUBLE)
#define TL_UNROLL _Pragma("GCC unroll 64")
#else
#define TL_UNROLL
#endif

/* Before a loop whose iterations do not touch each other's memory: becomes vectors, and is not taken apart into scalars before. */
#if defined(__clang__)
#define TL_INDEPENDENT _Pragma("clang loop vectorize(assume_safety) unroll(disable)")
#elif defined(__GNUC__)
#define TL_INDEPENDENT _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define TL_INDEPENDENT
#endif

/* Before the type of a local array of numbers: starts at a multiple of TL_ALIGNMENT bytes. */
#if defined(__GNUC__) || defined(__clang__)
#define TL_ALIGNED __attribute__((aligned(TL_ALIGNMENT)))
#else
#define TL_ALIGNED
#endif

/* Rows that kernels read and write in whole vectors have a length that is a multiple of TL_ROW_PAD; TL_ROW(n) is the smallest such
 * length that holds n numbers. Kernels are fastest where rows start at a multiple of TL_ROW_PAD numbers in memory; none needs it. */
#define TL_ROW_PAD 8
#define TL_ROW(n) (((n) + TL_ROW_PAD - 1) / TL_ROW_PAD * TL_ROW_PAD)

#if TL_VECTORS
/* Four numbers beside each other in memory, at any place. */
typedef tl_real tl_v4 __attribute__((vector_size(4 * sizeof(tl_real)), aligned(sizeof(tl_real)), may_alias));
#define TL_V4(address) (*(tl_v4 *)(address))
#define TL_V4_CONST(address) (*(const tl_v4 *)(address))
#endif

#endif
