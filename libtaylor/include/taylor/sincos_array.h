/* Sines and cosines of several numbers at once, in vectors of four.
 *
 * With k the integer nearest to 2x/pi and r = x - k pi/2, |r| <= pi/4, sin x and cos x are +-sin r and +-cos r, or the other way round
 * where k is odd. sin r and cos r are fdlibm's polynomials of degree 13 and 14. pi/2 is the sum of some numbers whose products with k
 * are exact but for the last: by their few digits, or because the processor rounds x - k p once. So are the first differences, and what
 * the rounding of r leaves over is known and goes into both results. Larger arguments than that allows go to the C library, and so does
 * what is no number. */
#ifndef TAYLOR_SINCOS_ARRAY_H
#define TAYLOR_SINCOS_ARRAY_H

#include "taylor/kernel.h"

#if TL_VECTORS && !defined(TL_REAL_FLOAT)

/* The largest |x| for vectors: |k| <= 2^20. It holds for each number by itself, so that no other changes a result. */
#define TL_SINCOS_LIMIT 0x1.9p20

typedef unsigned long long tl_u4 __attribute__((vector_size(4 * sizeof(unsigned long long))));

#if defined(__FMA__) && defined(__AVX__)
typedef double tl_sincos_fours __attribute__((vector_size(32)));
#define TL_SINCOS_LESS(rest, k, p)                                                                                                     \
  (tl_v4) __builtin_ia32_vfmaddpd256(-(tl_sincos_fours)(k), (tl_sincos_fours){p, p, p, p}, (tl_sincos_fours)(rest))
#endif

/* 1 where some number of a mask is true. */
TL_INLINE int tl_sincos_any_four(const tl_u4 *mask) {
#ifdef __AVX__
  typedef double four __attribute__((vector_size(32)));
  return __builtin_ia32_movmskpd256((four)*mask) != 0;
#else
  return (((*mask)[0] | (*mask)[1]) | ((*mask)[2] | (*mask)[3])) != 0;
#endif
}

#define TL_V tl_v4
#define TL_V_BITS tl_u4
#define TL_V_NAME(name) name##_four
#include "taylor/sincos_vector.h"

/* Numbers i..i+count-1, 1 <= count <= 4. */
TL_INLINE void tl_sincos_some(int count, const tl_real *x, tl_real *s, tl_real *c) {
  tl_v4 v = {x[0], count > 1 ? x[1] : 0.0, count > 2 ? x[2] : 0.0, 0.0}, sine, cosine;
  if (count == 4) v = TL_V4_CONST(x);
  if (tl_sincos_vector_four(&sine, &cosine, &v)) tl_sincos_large_four(count, &sine, &cosine, &v);
  if (count == 4) {
    TL_V4(s) = sine;
    TL_V4(c) = cosine;
  } else {
    s[0] = sine[0], c[0] = cosine[0];
    if (count > 1) s[1] = sine[1], c[1] = cosine[1];
    if (count > 2) s[2] = sine[2], c[2] = cosine[2];
  }
}

#endif

/* Numbers one by one, unless the header of the mathematics has functions of its own. */
#if TL_SINGLE_NUMBERS && !defined(TL_OTHER_MATHEMATICS)
#define TL_SINCOS_OWN 1
#include "taylor/sincos_number.h"
#else
#define TL_SINCOS_OWN 0
#endif

#if TL_SINCOS_OWN
TL_INLINE void tl_sincos_one(const tl_real *x, tl_real *s, tl_real *c) {
  const tl_sincos_pair pair = tl_sincos_number(*x);
  *s = pair.sine;
  *c = pair.cosine;
}
#endif

/* s[i] = sin x[i], c[i] = cos x[i] for i < n, each within 1.1 ulp; where x[i] is infinite or no number, neither is the result. s and c
 * may be x, not each other. A number's result does not depend on its place in the array, nor on the others. */
TL_INLINE void tl_sincos_array(int n, const tl_real *x, tl_real *s, tl_real *c) {
#if TL_VECTORS && !defined(TL_REAL_FLOAT)
  int i = 0;
  for (; i + 4 <= n; i += 4) tl_sincos_some(4, x + i, s + i, c + i);
  if (n % 4 == 1) tl_sincos_some(1, x + i, s + i, c + i);
  if (n % 4 == 2) tl_sincos_some(2, x + i, s + i, c + i);
  if (n % 4 == 3) tl_sincos_some(3, x + i, s + i, c + i);
#elif TL_SINCOS_OWN
  enum { UNROLLED = 8 };
  if (n <= UNROLLED) {
    TL_UNROLL for (int i = 0; i < UNROLLED; i++) if (i < n) tl_sincos_one(x + i, s + i, c + i);
  } else {
    for (int i = 0; i < n; i++) tl_sincos_one(x + i, s + i, c + i);
  }
#else
  for (int i = 0; i < n; i++) {
    const tl_real xi = x[i];
    s[i] = TL_LIBM(sin)(xi);
    c[i] = TL_LIBM(cos)(xi);
  }
#endif
}

#endif
