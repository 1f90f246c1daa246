/* Sines and cosines of tl_lanes: the formulas of sincos_array.h, in registers of eight numbers where there are such. */
#ifndef TAYLOR_SINCOS_LANES_H
#define TAYLOR_SINCOS_LANES_H

#include "taylor/lanes_math.h"
#include "taylor/sincos_array.h"

#if TL_LANES == 8 && defined(__AVX512DQ__) && !defined(TL_REAL_FLOAT)
#define TL_SINCOS_EIGHT 1

typedef unsigned long long tl_u8 __attribute__((vector_size(8 * sizeof(unsigned long long))));

#define TL_SINCOS_LESS(rest, k, p) __builtin_ia32_vfmaddpd512_mask(-(k), (tl_lanes){p, p, p, p, p, p, p, p}, rest, (unsigned char)-1, 4)

TL_INLINE int tl_sincos_any_eight(const tl_u8 *mask) { return tl_lanes_any((tl_mask)*mask); }

#define TL_V tl_lanes
#define TL_V_BITS tl_u8
#define TL_V_NAME(name) name##_eight
#include "taylor/sincos_vector.h"
#endif

/* s[i] = sin x[i], c[i] = cos x[i] for i < n in each lane, as tl_sincos_array has them. s and c may be x, not each other. */
TL_INLINE void tl_sincos_lanes(int n, const tl_lanes *x, tl_lanes *s, tl_lanes *c) {
#ifdef TL_SINCOS_EIGHT
  TL_UNROLL for (int i = 0; i < n; i++) {
    const tl_lanes angle = x[i];
    tl_lanes sine, cosine;
    if (tl_sincos_vector_eight(&sine, &cosine, &angle)) tl_sincos_large_eight(TL_LANES, &sine, &cosine, &angle);
    s[i] = sine;
    c[i] = cosine;
  }
#else
  tl_sincos_array(n * TL_LANES, (const tl_real *)x, (tl_real *)s, (tl_real *)c);
#endif
}

#endif
