/* Coefficients of one series after the other, order by order: what products and elementary functions of series add up from the orders
 * before (Jorba and Zou 2005, section 2).
 *
 * The coefficient of order k of a b is sum_(j=0..k) a_j b_(k-j). Orders come in blocks of four, block = 4, 8, .. and place = k - block
 * = 0..3. As a block begins, the terms whose factors are both older than it are added up for its four orders side by side, a vector for
 * each a_j; of the others an order has place pairs, and the two terms with the coefficients of order 0 and k, which are left to the
 * caller. Orders 1 to 3 are a block of their own, with place = k and without anything older.
 *
 * A series has a row of TL_SERIES_ROW numbers, coefficient j in row[j]; that of a second factor b is followed by four zeros where its
 * last block ends.
 */
#ifndef TAYLOR_CONVOLVE_H
#define TAYLOR_CONVOLVE_H

#include "taylor/kernel.h"

enum { TL_SERIES_ROW = 32, TL_SERIES_MOST = 27 /* order */ };

/* Where the rows of the factors of a product begin. */
typedef struct tl_series_pair {
  int a, b;
} tl_series_pair;

/* Stores coefficient k, of a second factor. */
TL_INLINE void tl_series_put(tl_real *row, int k, int place, tl_real value) {
  row[k] = value;
  if (place == 3)
    for (int i = 1; i <= 4; i++) row[k + i] = TL_C(0.0);
}

/* sum[place] = sum_(j=1..block-1) a_j b_(block+place-j), where b_i is 0 from block on. block: constant. */
TL_INLINE void tl_series_add_up(tl_real *sum, const tl_real *a, const tl_real *b, int block) {
  b += block;
#if TL_VECTORS
  tl_v4 even = a[2] * TL_V4_CONST(b - 2), odd = a[1] * TL_V4_CONST(b - 1);
  odd += a[3] * TL_V4_CONST(b - 3);
  TL_UNROLL for (int j = 4; j < block; j += 2) {
    even += a[j] * TL_V4_CONST(b - j);
    odd += a[j + 1] * TL_V4_CONST(b - j - 1);
  }
  TL_V4(sum) = even + odd;
#else
  for (int place = 0; place < 4; place++) {
    sum[place] = TL_C(0.0);
    for (int j = 1; j < block; j++) sum[place] += a[j] * b[place - j];
  }
#endif
}

TL_INLINE void tl_series_add_all(tl_real *x, tl_real *older, int count, const tl_series_pair *pairs, int block) {
  for (int i = 0; i < count; i++) tl_series_add_up(older + 4 * i, x + pairs[i].a, x + pairs[i].b, block);
}

/* The beginning of a block: older, 4 count numbers, from the rows in x of as many pairs. */
static inline void tl_series_begin_block(tl_real *x, tl_real *older, int count, const tl_series_pair *pairs, int block) {
  switch (block) {
  case 4:
    tl_series_add_all(x, older, count, pairs, 4);
    break;
  case 8:
    tl_series_add_all(x, older, count, pairs, 8);
    break;
  case 12:
    tl_series_add_all(x, older, count, pairs, 12);
    break;
  case 16:
    tl_series_add_all(x, older, count, pairs, 16);
    break;
  case 20:
    tl_series_add_all(x, older, count, pairs, 20);
    break;
  default:
    tl_series_add_all(x, older, count, pairs, 24);
  }
}

/* sum_(j=1..k-1) a_j b_(k-j). older: the pair's four numbers of the block. first: it is that of the orders 1 to 3. place, first:
 * constant. */
TL_INLINE tl_real tl_series_between(const tl_real *a, const tl_real *b, const tl_real *older, int k, int place, int first) {
  if (first) return place == 1 ? TL_C(0.0) : place == 2 ? a[1] * b[1] : a[1] * b[2] + a[2] * b[1];
  tl_real sum = older[place];
  TL_UNROLL for (int j = place; j > 0; j--) {
    if (a == b)
      sum += (a[j] + a[j]) * a[k - j];
    else
      sum += a[j] * b[k - j] + a[k - j] * b[j];
  }
  return sum;
}

#endif
