/* Whether numbers are finite, many at once. */
#ifndef TAYLOR_FINITE_H
#define TAYLOR_FINITE_H

#include "taylor/kernel.h"

/* 1 where x[i] is finite for all i < n, 0 elsewhere. */
TL_INLINE int tl_finite_array(int n, const tl_real *x) {
  enum { LANES = 8, MANY = 4 * LANES };
  tl_real sum[MANY] = {TL_C(0.0)}; /* of 0 x: zero, or NaN for ever after one x that is not finite */
  int i = 0;
  for (; i + MANY <= n; i += MANY)
    for (int j = 0; j < MANY; j++) sum[j] += TL_C(0.0) * x[i + j];
  if (i > 0)
    for (int j = 0; j < LANES; j++) sum[j] = (sum[j] + sum[j + LANES]) + (sum[j + 2 * LANES] + sum[j + 3 * LANES]);
  for (; i + LANES <= n; i += LANES)
    for (int j = 0; j < LANES; j++) sum[j] += TL_C(0.0) * x[i + j];
  TL_UNROLL for (int j = 0; j < LANES - 1; j++) if (i + j < n) sum[j] += TL_C(0.0) * x[i + j];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]) + ((sum[4] + sum[5]) + (sum[6] + sum[7])) == TL_C(0.0);
}

#endif
