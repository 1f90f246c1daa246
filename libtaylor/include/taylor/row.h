/* Rows of numbers with a prefix that is in use: row[j] for j < n. Rows are padded to TL_ROW(n) numbers (kernel.h), and all of these may
 * be read and written: what a row holds between n and TL_ROW(n) needs no value before, and has kept it after. So there is no loop over
 * the last few numbers one by one; the last vector keeps by a mask what is not in use. n may vary from call to call. */
#ifndef TAYLOR_ROW_H
#define TAYLOR_ROW_H

#include "taylor/kernel.h"

#if TL_VECTORS

/* Integers of the size of a number, to make masks. */
#if TL_REAL == TL_FLOAT
typedef int tl_row_integer;
#else
typedef long long tl_row_integer;
#endif
typedef tl_row_integer tl_row_mask __attribute__((vector_size(4 * sizeof(tl_real))));

/* a where j < n for the four numbers from place j on, else b. */
TL_INLINE void tl_row_choose(tl_v4 *result, int n, int j, const tl_v4 *a, const tl_v4 *b) {
  const tl_row_mask place = {0, 1, 2, 3}, in_use = (tl_row_mask)(place < (tl_row_integer)(n - j));
  *result = (tl_v4)(((tl_row_mask)*a & in_use) | ((tl_row_mask)*b & ~in_use));
}

#endif

/* d[j] += m*x[j] for j < n. d and x are the same row or do not overlap. */
TL_INLINE void tl_row_add_prefix(tl_real *d, const tl_real *x, tl_real m, int n) {
#if TL_VECTORS
  int j = 0;
  for (; j + 4 <= n; j += 4) TL_V4(d + j) += m * TL_V4_CONST(x + j);
  if (j >= n) return;
  const tl_v4 before = TL_V4_CONST(d + j), sum = before + m * TL_V4_CONST(x + j);
  tl_v4 after;
  tl_row_choose(&after, n, j, &sum, &before);
  TL_V4(d + j) = after;
#else
  for (int j = 0; j < n; j++) d[j] += m * x[j];
#endif
}

/* d[j] = m*x[j] for j < n. */
TL_INLINE void tl_row_set_prefix(tl_real *d, const tl_real *x, tl_real m, int n) {
#if TL_VECTORS
  int j = 0;
  for (; j + 4 <= n; j += 4) TL_V4(d + j) = m * TL_V4_CONST(x + j);
  if (j >= n) return;
  const tl_v4 before = TL_V4_CONST(d + j), product = m * TL_V4_CONST(x + j);
  tl_v4 after;
  tl_row_choose(&after, n, j, &product, &before);
  TL_V4(d + j) = after;
#else
  for (int j = 0; j < n; j++) d[j] = m * x[j];
#endif
}

/* d[j] += a*x[j] + b*y[j] for j < n: what a product does to a row. d is not x nor y unless it is the same row. */
TL_INLINE void tl_row_add_two(tl_real *d, const tl_real *x, tl_real a, const tl_real *y, tl_real b, int n) {
#if TL_VECTORS
  int j = 0;
  for (; j + 4 <= n; j += 4) TL_V4(d + j) += a * TL_V4_CONST(x + j) + b * TL_V4_CONST(y + j);
  if (j >= n) return;
  const tl_v4 before = TL_V4_CONST(d + j), sum = before + (a * TL_V4_CONST(x + j) + b * TL_V4_CONST(y + j));
  tl_v4 after;
  tl_row_choose(&after, n, j, &sum, &before);
  TL_V4(d + j) = after;
#else
  for (int j = 0; j < n; j++) d[j] += a * x[j] + b * y[j];
#endif
}

/* Takes apart the pairs of so many rows of x, ldx numbers apart: even[i*ld + j] = m*x[i*ldx + 2*j] and odd[i*ld + j] =
 * m*x[i*ldx + 2*j + 1] for j < n, and nothing beyond these. m is 1 or -1. The arrays do not overlap. 1 where all these numbers are
 * finite, 0 elsewhere. */
TL_INLINE int tl_rows_unpair(int rows, tl_real *even, tl_real *odd, int ld, const tl_real *x, int ldx, tl_real m, int n) {
  tl_real sum = TL_C(0.0); /* of 0 x, as in finite.h */
#if TL_VECTORS
  tl_v4 low_sum = {TL_C(0.0)}, high_sum = {TL_C(0.0)};
#endif
  for (int i = 0; i < rows; i++, even += ld, odd += ld, x += ldx) {
    int j = 0;
#if TL_VECTORS
    for (; j + 4 <= n; j += 4) {
      const tl_v4 low = TL_V4_CONST(x + 2 * j), high = TL_V4_CONST(x + 2 * j + 4);
      low_sum += TL_C(0.0) * low;
      high_sum += TL_C(0.0) * high;
      TL_V4(even + j) = m * __builtin_shufflevector(low, high, 0, 2, 4, 6);
      TL_V4(odd + j) = m * __builtin_shufflevector(low, high, 1, 3, 5, 7);
    }
#endif
    for (; j < n; j++) {
      sum += TL_C(0.0) * x[2 * j] + TL_C(0.0) * x[2 * j + 1];
      even[j] = m * x[2 * j];
      odd[j] = m * x[2 * j + 1];
    }
  }
#if TL_VECTORS
  low_sum += high_sum;
  sum += (low_sum[0] + low_sum[1]) + (low_sum[2] + low_sum[3]);
#endif
  return sum == TL_C(0.0);
}

#endif
