/* Coefficients of one series after the other, order by order: what products and elementary functions of series add up from the orders
 * before (Jorba and Zou 2005, section 2).
 *
 * The coefficient of order k of a b is sum_(j=0..k) a_j b_(k-j). Of these terms the four that hold a coefficient of order k or k - 1
 * come from scalars; the others were stored long enough ago to be read as vectors without waiting, and do not wait for anything of this
 * order.
 *
 * A series has a row of TL_SERIES_ROW numbers, forward: coefficient j is row[j], followed by four zeros. A series that is the second
 * factor has another row, backward: coefficient j >= 2 is row[TL_SERIES_END - j], and from TL_SERIES_END - 1 on there are four zeros.
 */
#ifndef TAYLOR_CONVOLVE_H
#define TAYLOR_CONVOLVE_H

#include "taylor/kernel.h"

enum { TL_SERIES_ROW = 32, TL_SERIES_END = 28, TL_SERIES_MOST = 27 /* order */ };

/* How many vectors of four numbers hold the terms of order k that are read as vectors, k >= 3. */
#define TL_SERIES_VECTORS(k) ((k) < 8 ? 1 : (k) / 4)

/* Stores coefficient k. */
TL_INLINE void tl_series_put(tl_real *row, int k, tl_real value) {
  row[k] = value;
  row[k + 4] = TL_C(0.0);
}

/* Starts a forward row with its coefficient 0, a backward row. */
TL_INLINE void tl_series_begin(tl_real *row, tl_real value) {
  row[0] = value;
  row[2] = row[3] = row[4] = TL_C(0.0);
}
TL_INLINE void tl_series_begin_backward(tl_real *row) {
  for (int i = -1; i < 3; i++) row[TL_SERIES_END + i] = TL_C(0.0);
}

/* sum_(j=2..k-2) a_j b_(k-j) from so many vectors. */
TL_INLINE tl_real tl_series_older(const tl_real *a, const tl_real *b_backward, int k, int vectors) {
  const tl_real *b = b_backward + (TL_SERIES_END + 2 - k);
  a += 2;
#if TL_VECTORS
  tl_v4 sum = TL_V4_CONST(a) * TL_V4_CONST(b);
  TL_UNROLL for (int i = 1; i < vectors; i++) sum += TL_V4_CONST(a + 4 * i) * TL_V4_CONST(b + 4 * i);
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
#else
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < 4 * vectors; i++) sum += a[i] * b[i];
  return sum;
#endif
}

/* sum_(j=1..k-1) a_j b_(k-j). k = 1, 2, and from 3 on with TL_SERIES_VECTORS(k) vectors, all constants where this is called. */
TL_INLINE tl_real tl_series_between(const tl_real *a, const tl_real *b, const tl_real *b_backward, int k, int vectors) {
  if (vectors > 0) return (a[1] * b[k - 1] + a[k - 1] * b[1]) + tl_series_older(a, b_backward, k, vectors);
  return k == 1 ? TL_C(0.0) : a[1] * b[1];
}

#endif
