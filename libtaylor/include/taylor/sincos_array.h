/* Sines and cosines of several numbers at once, in vectors of four.
 *
 * With k the integer nearest to 2x/pi and r = x - k pi/2, |r| <= pi/4, sin x and cos x are +-sin r and +-cos r, or the other way round
 * where k is odd. sin r and cos r are fdlibm's polynomials of degree 13 and 14. pi/2 is the sum of some numbers whose products with k
 * are exact but for the last: by their few digits, or because the processor rounds x - k p once. So are the first differences, and r is
 * right to a unit in its last place. Larger arguments than that allows go to the C library, and so does what is no number. */
#ifndef TAYLOR_SINCOS_ARRAY_H
#define TAYLOR_SINCOS_ARRAY_H

#include "taylor/kernel.h"

#if TL_VECTORS && !defined(TL_REAL_FLOAT)

/* The largest |x| for vectors: |k| <= 2^20. It holds for each number by itself, so that no other changes a result. */
#define TL_SINCOS_LIMIT 0x1.9p20

typedef unsigned long long tl_u4 __attribute__((vector_size(4 * sizeof(unsigned long long))));

/* x - k pi/2, k an integer and |k| <= 2^20. */
TL_INLINE void tl_sincos_reduce(tl_v4 *r, const tl_v4 *x, const tl_v4 *k) {
#if defined(__FMA__) && defined(__AVX__)
  typedef double four __attribute__((vector_size(32)));
#define TL_SINCOS_LESS(rest, p) __builtin_ia32_vfmaddpd256(-(four) * k, (four){p, p, p, p}, rest)
  const four first = TL_SINCOS_LESS((four)*x, 0x1.921fb54442d18p0), second = TL_SINCOS_LESS(first, 0x1.1a62633145c06p-54);
  *r = (tl_v4)TL_SINCOS_LESS(second, 0x1.c1cd129024e08p-107);
#undef TL_SINCOS_LESS
#else
  *r = *x - *k * 0x1.921fb544p0 - *k * 0x1.0b46p-34 - *k * 0x1.1a626331p-54 - *k * 0x1.1701b839a252p-88;
#endif
}

/* Four at once. 1 where one of them is too large, or no number, and has no result. */
TL_INLINE int tl_sincos_four(tl_v4 *sine, tl_v4 *cosine, const tl_v4 *argument) {
  const tl_v4 x = *argument;
  const tl_real shift = 0x1.8p52; /* plus a number it has the nearest integer in its last bits */
  const unsigned long long sign = 1ULL << 63;
  /* Each sum has one product at most, so that a compiler that contracts them has no choice, and a number's result no company. */
  const tl_v4 shifted = x * 0x1.45f306dc9c883p-1 + shift, k = shifted - shift;
  tl_v4 r;
  tl_sincos_reduce(&r, &x, &k);

  const tl_v4 z = r * r, z2 = z * z, z4 = z2 * z2;
  const tl_v4 p0 = -1.66666666666666307295e-01 + z * 8.33333333332211858878e-03;
  const tl_v4 p1 = -1.98412698295895385996e-04 + z * 2.75573136213857245213e-06;
  const tl_v4 p2 = -2.50507477628578072866e-08 + z * 1.58962301576546568060e-10;
  const tl_v4 q0 = 4.16666666666665929218e-02 + z * -1.38888888888730564116e-03;
  const tl_v4 q1 = 2.48015872888517045348e-05 + z * -2.75573141792967388112e-07;
  const tl_v4 q2 = 2.08757008419747316778e-09 + z * -1.13585363213876817300e-11;
  const tl_v4 p01 = p0 + z2 * p1, q01 = q0 + z2 * q1, half = 0.5 - z * (q01 + z4 * q2);
  const tl_v4 s = r + r * z * (p01 + z4 * p2), c = 1.0 - z * half;

  const tl_u4 quarter = (tl_u4)shifted, odd = -(quarter & 1);
  const tl_u4 s_bits = (tl_u4)s | ((tl_u4)r & sign), c_bits = (tl_u4)c; /* the sum above loses the sign of zero */
  *sine = (tl_v4)(((c_bits & odd) | (s_bits & ~odd)) ^ ((quarter & 2) << 62));
  *cosine = (tl_v4)(((s_bits & odd) | (c_bits & ~odd)) ^ (((quarter + 1) & 2) << 62));

  const tl_u4 large = ~(tl_u4)((tl_v4)((tl_u4)x & ~sign) <= TL_SINCOS_LIMIT);
#ifdef __AVX__
  typedef double four __attribute__((vector_size(32)));
  return __builtin_ia32_movmskpd256((four)large) != 0;
#else
  return ((large[0] | large[1]) | (large[2] | large[3])) != 0;
#endif
}

/* The C library for those of `count` numbers that are too large for vectors. x may be s or c. */
static inline void tl_sincos_large(int count, tl_v4 *sine, tl_v4 *cosine, const tl_v4 *x) {
  for (int i = 0; i < count; i++) {
    const tl_real xi = (*x)[i];
    if (TL_LIBM(fabs)(xi) <= TL_SINCOS_LIMIT) continue;
    (*sine)[i] = TL_LIBM(sin)(xi);
    (*cosine)[i] = TL_LIBM(cos)(xi);
  }
}

/* Numbers i..i+count-1, 1 <= count <= 4. */
TL_INLINE void tl_sincos_some(int count, const tl_real *x, tl_real *s, tl_real *c) {
  tl_v4 v = {x[0], count > 1 ? x[1] : 0.0, count > 2 ? x[2] : 0.0, 0.0}, sine, cosine;
  if (count == 4) v = TL_V4_CONST(x);
  if (tl_sincos_four(&sine, &cosine, &v)) tl_sincos_large(count, &sine, &cosine, &v);
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

/* s[i] = sin x[i], c[i] = cos x[i] for i < n, each within 1.5 ulp; where x[i] is infinite or no number, neither is the result. s and c
 * may be x, not each other. A number's result does not depend on its place in the array, nor on the others. */
TL_INLINE void tl_sincos_array(int n, const tl_real *x, tl_real *s, tl_real *c) {
#if TL_VECTORS && !defined(TL_REAL_FLOAT)
  int i = 0;
  for (; i + 4 <= n; i += 4) tl_sincos_some(4, x + i, s + i, c + i);
  if (n % 4 == 1) tl_sincos_some(1, x + i, s + i, c + i);
  if (n % 4 == 2) tl_sincos_some(2, x + i, s + i, c + i);
  if (n % 4 == 3) tl_sincos_some(3, x + i, s + i, c + i);
#else
  for (int i = 0; i < n; i++) {
    const tl_real xi = x[i];
    s[i] = TL_LIBM(sin)(xi);
    c[i] = TL_LIBM(cos)(xi);
  }
#endif
}

#endif
