/* Whether numbers are finite, many at once. */
#ifndef TAYLOR_FINITE_H
#define TAYLOR_FINITE_H

#include "taylor/kernel.h"

#if TL_SINGLE_NUMBERS
#include <stdint.h>
#include <string.h>

/* Carries into the sign bit where all bits of the exponent are set; other numbers have no sign bit here. */
TL_INLINE uint32_t tl_finite_carry(const tl_real *x) {
#if TL_REAL == TL_FLOAT
  uint32_t bits;
  memcpy(&bits, x, sizeof bits);
  return (bits & 0x7f800000u) + 0x00800000u;
#else
  uint64_t bits;
  memcpy(&bits, x, sizeof bits);
  return ((uint32_t)(bits >> 32) & 0x7ff00000u) + 0x00100000u;
#endif
}

#endif

/* 1 where x[i] is finite for all i < n, 0 elsewhere. */
TL_INLINE int tl_finite_array(int n, const tl_real *x) {
#if TL_SINGLE_NUMBERS
#if !TL_SOFT_NUMBERS
  enum { ROUND = 8, FEW = 4 };
  if (n > FEW) { /* unrolled */
    tl_real total = TL_C(0.0);
    int i = 0;
    for (; i + ROUND <= n; i += ROUND) TL_UNROLL for (int j = 0; j < ROUND; j++) total += x[i + j];
    TL_UNROLL for (int j = 0; j < ROUND - 1; j++) if (i + j < n) total += x[i + j];
    if (total - total == TL_C(0.0)) return 1; /* elsewhere it may have been too large */
  }
  tl_real sum = TL_C(0.0); /* of x - x: zero, or NaN */
  for (int i = 0; i < n; i++) sum += x[i] - x[i];
  return sum == TL_C(0.0);
#else
  uint32_t carry = 0;
  for (int i = 0; i < n; i++) carry |= tl_finite_carry(x + i);
  return carry >> 31 == 0;
#endif
#else
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
#endif
}

#endif
