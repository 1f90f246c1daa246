/* Solution of M x = b in lanes: each lane its own M and b, with the formulas of ldl.h for small n, whatever n is. Arrays as there. */
#ifndef TAYLOR_LDL_LANES_H
#define TAYLOR_LDL_LANES_H

#include "taylor/lanes_math.h"

#define TL_T tl_lanes
#define TL_T_NAME(name) name##_lanes
#define TL_T_OF(x) tl_lanes_of(x)
#define TL_T_WHERE(condition, a, b) tl_lanes_select(condition, a, b)
#define TL_T_UNROLL TL_UNROLL
#include "taylor/ldl_straight.h"

/* x = M^-1 b. Returns in each lane the largest M_ii/d_i, an infinity where M is not positive definite; x has no meaning there. */
TL_INLINE tl_lanes tl_ldl_factor_solve_lanes(int n, tl_lanes *x, tl_lanes *w, int ld, tl_lanes *d, const tl_lanes *b) {
  const tl_lanes ratio = tl_ldl_factor_scalar_lanes(n, w, ld, d);
  TL_UNROLL for (int i = 0; i < n; i++) x[i] = b[i];
  tl_ldl_solve_scalar_lanes(n, x, w, ld, d);
  return ratio;
}

/* x = M^-1 b from the factors. x may be b. */
TL_INLINE void tl_ldl_solve_lanes(int n, tl_lanes *x, const tl_lanes *w, int ld, tl_lanes *d, const tl_lanes *b) {
  TL_UNROLL for (int i = 0; i < n; i++) x[i] = b[i];
  tl_ldl_solve_scalar_lanes(n, x, w, ld, d);
}

/* B = M^-1 B, from the factors, for k right-hand sides: row i of b, of length ldb >= k, holds the i-th numbers of all of them. */
TL_INLINE void tl_ldl_solve_many_lanes(int n, int k, tl_lanes *b, int ldb, const tl_lanes *w, int ld, tl_lanes *d) {
  for (int j = 0; j < k; j++) {
    tl_lanes *const x = b + j;
    TL_UNROLL for (int l = 0; l < n; l++) TL_UNROLL for (int i = l + 1; i < n; i++) x[i * ldb] -= w[i * ld + l] * x[l * ldb];
    TL_UNROLL for (int i = 0; i < n; i++) x[i * ldb] *= d[i];
    TL_UNROLL for (int l = n - 1; l > 0; l--) TL_UNROLL for (int i = 0; i < l; i++) x[i * ldb] -= w[l * ld + i] * x[l * ldb];
  }
}

#endif
