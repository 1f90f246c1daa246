/* Rows of numbers with a prefix that is in use: row[j] for j < n. Rows are padded to TL_ROW(n) numbers (kernel.h), and all of these may
 * be read and written: what a row holds between n and TL_ROW(n) needs no value before, and has kept it after. */
#ifndef TAYLOR_ROW_H
#define TAYLOR_ROW_H

#include "taylor/kernel.h"

/* d[j] += m*x[j] for j < n. d and x are the same row or do not overlap. */
TL_INLINE void tl_row_add_prefix(tl_real *d, const tl_real *x, tl_real m, int n) {
  for (int j = 0; j < n; j++) d[j] += m * x[j];
}

#endif
