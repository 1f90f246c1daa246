/* Functions of tl_lanes: what C's operators, math.h and taylor/power.h are for one number.
 *
 * For the source files that compute with lanes; headers need taylor/lanes.h alone. */
#ifndef TAYLOR_LANES_MATH_H
#define TAYLOR_LANES_MATH_H

#include "taylor/lanes.h"
#include "taylor/power.h"

/* The same number in every lane. */
TL_INLINE tl_lanes tl_lanes_of(tl_real x) { return TL_LANES_ZERO + x; }

/* 1 where the mask is true in some lane, 0 elsewhere. */
TL_INLINE int tl_lanes_any(tl_mask mask) {
#if TL_LANES == 1
  return mask != 0;
#elif TL_LANES == 8 && defined(__AVX512DQ__) && !defined(TL_REAL_FLOAT)
  return __builtin_ia32_cvtq2mask512(mask) != 0;
#else
  tl_lane_bits any = 0;
  TL_UNROLL for (int l = 0; l < TL_LANES; l++) any |= mask[l];
  return any != 0;
#endif
}

/* The mask of truth values of C, and its negation. */
TL_INLINE tl_mask tl_lanes_truth(int truth) { return tl_lanes_of((tl_real)truth) > TL_C(0.5); }
TL_INLINE tl_mask tl_lanes_not(tl_mask mask) { return mask == 0; }

/* 1 where the mask is true in every lane. */
TL_INLINE int tl_lanes_all(tl_mask mask) { return !tl_lanes_any(tl_lanes_not(mask)); }

/* In each lane a where the mask is true, b elsewhere. */
TL_INLINE tl_lanes tl_lanes_select(tl_mask mask, tl_lanes a, tl_lanes b) {
#if TL_LANES == 1
  return mask ? a : b;
#else
  return (tl_lanes)(((tl_mask)a & mask) | ((tl_mask)b & ~mask));
#endif
}

/* math.h: tl_lanes_sin(x) is sin of each lane. */
#define TL_LANES_ONE(name)                                                                                                             \
  TL_INLINE tl_lanes tl_lanes_##name(tl_lanes x) {                                                                                     \
    tl_lanes y = x;                                                                                                                    \
    TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(y, l) = TL_LIBM(name)(TL_LANE(x, l));                                         \
    return y;                                                                                                                          \
  }
#define TL_LANES_TWO(name)                                                                                                             \
  TL_INLINE tl_lanes tl_lanes_##name(tl_lanes x, tl_lanes y) {                                                                         \
    tl_lanes z = x;                                                                                                                    \
    TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(z, l) = TL_LIBM(name)(TL_LANE(x, l), TL_LANE(y, l));                          \
    return z;                                                                                                                          \
  }
TL_LANES_ONE(sqrt)
TL_LANES_ONE(cbrt)
TL_LANES_ONE(exp)
TL_LANES_ONE(exp2)
TL_LANES_ONE(expm1)
TL_LANES_ONE(log)
TL_LANES_ONE(log2)
TL_LANES_ONE(log10)
TL_LANES_ONE(log1p)
TL_LANES_ONE(sin)
TL_LANES_ONE(cos)
TL_LANES_ONE(tan)
TL_LANES_ONE(asin)
TL_LANES_ONE(acos)
TL_LANES_ONE(atan)
TL_LANES_ONE(sinh)
TL_LANES_ONE(cosh)
TL_LANES_ONE(tanh)
TL_LANES_ONE(asinh)
TL_LANES_ONE(acosh)
TL_LANES_ONE(atanh)
TL_LANES_ONE(erf)
TL_LANES_ONE(erfc)
TL_LANES_ONE(tgamma)
TL_LANES_ONE(lgamma)
TL_LANES_ONE(fabs)
TL_LANES_ONE(floor)
TL_LANES_ONE(ceil)
TL_LANES_ONE(trunc)
TL_LANES_ONE(round)
TL_LANES_ONE(rint)
TL_LANES_ONE(nearbyint)
TL_LANES_TWO(hypot)
TL_LANES_TWO(pow)
TL_LANES_TWO(atan2)
TL_LANES_TWO(fmin)
TL_LANES_TWO(fmax)
TL_LANES_TWO(fdim)
TL_LANES_TWO(fmod)
TL_LANES_TWO(remainder)
TL_LANES_TWO(copysign)
#undef TL_LANES_ONE
#undef TL_LANES_TWO

TL_INLINE tl_lanes tl_lanes_fma(tl_lanes x, tl_lanes y, tl_lanes z) {
  TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(z, l) = TL_LIBM(fma)(TL_LANE(x, l), TL_LANE(y, l), TL_LANE(z, l));
  return z;
}
TL_INLINE tl_lanes tl_lanes_scalbn(tl_lanes x, int exponent) {
  TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(x, l) = TL_LIBM(scalbn)(TL_LANE(x, l), exponent);
  return x;
}

/* taylor/power.h in each lane. */
TL_INLINE tl_lanes tl_lanes_power(tl_lanes x, tl_lanes e, int k) {
  TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(x, l) = tl_power(TL_LANE(x, l), TL_LANE(e, l), k);
  return x;
}
TL_INLINE tl_mask tl_lanes_power_exists(tl_lanes x, tl_lanes e, int k) {
  TL_UNROLL for (int l = 0; l < TL_LANES; l++) TL_LANE(x, l) = (tl_real)tl_power_exists(TL_LANE(x, l), TL_LANE(e, l), k);
  return x > TL_C(0.5);
}

/* 1 where x[i] is finite for all i < n in all lanes, 0 elsewhere. */
TL_INLINE int tl_lanes_finite(int n, const tl_lanes *x) {
  tl_lanes even = TL_LANES_ZERO, odd = TL_LANES_ZERO; /* of 0 x: zero, or NaN for ever after one x that is not finite */
  int i = 0;
  for (; i + 2 <= n; i += 2) {
    even += TL_C(0.0) * x[i];
    odd += TL_C(0.0) * x[i + 1];
  }
  if (i < n) even += TL_C(0.0) * x[i];
  return tl_lanes_all(even + odd == TL_C(0.0));
}

#endif
