/* Whether numbers are finite, many at once. */
#ifndef TAYLOR_FINITE_H
#define TAYLOR_FINITE_H

#include "taylor/kernel.h"

/* 1 where x[i] is finite for all i < n, 0 elsewhere. */
TL_INLINE int tl_finite_array(int n, const tl_real *x) {
  enum { LANES = 8 };
  tl_real sum[LANES] = {TL_C(0.0)}; /* of x - x: zero, or NaN for ever after one x that is not finite */
  int i = 0;
  for (; i + LANES <= n; i += LANES)
    for (int j = 0; j < LANES; j++) sum[j] += x[i + j] - x[i + j];
  for (; i < n; i++) sum[0] += x[i] - x[i];
  for (int j = 1; j < LANES; j++) sum[0] += sum[j];
  return sum[0] == TL_C(0.0);
}

#endif
