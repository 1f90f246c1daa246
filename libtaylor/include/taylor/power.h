/* Powers whose exponent is known at run time only: their derivatives, and where they have them. */
#ifndef TAYLOR_POWER_H
#define TAYLOR_POWER_H

#include "taylor/kernel.h"

/* The k-th derivative of x^e in x, e (e-1) .. (e-k+1) x^(e-k), where it exists. */
TL_INLINE tl_real tl_power(tl_real x, tl_real e, int k) {
  tl_real factor = TL_C(1.0);
  for (int i = 0; i < k; i++) factor *= e - (tl_real)i;
  return factor == TL_C(0.0) ? TL_C(0.0) : factor * TL_LIBM(pow)(x, e - (tl_real)k); /* 0 at x = 0 too */
}

/* 1 where it exists, 0 elsewhere. A whole e takes every x, but no 0 where it is negative; any other no x < 0, and 0 where x^(e-k) is
 * finite. */
TL_INLINE int tl_power_exists(tl_real x, tl_real e, int k) {
  if (x > TL_C(0.0)) return 1;
  if (e == TL_LIBM(floor)(e)) return e >= TL_C(0.0) || x < TL_C(0.0);
  return x == TL_C(0.0) && e > (tl_real)k;
}

#endif
