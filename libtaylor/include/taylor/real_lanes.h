/* Numbers side by side as the number type: what real.h includes with -DTL_REAL_LANES=2, 4 or 8, for float and double, gcc and clang.
 *
 * tl_real is then a vector of as many tl_number; C's operators work lane by lane, and comparisons give a mask. Jets of it are as many
 * jets that go through the same operations. What fails in one lane fails in all, and tl_status is that of the first lane
 * that fails (tl_compose, tl_apply and tl_apply_n look for a value that is not finite first). Functions have
 * names of their own (lanes_names.h), beside those for one number in the same program.
 *
 * To have them, compile block.c, context.c, rule.c, series.c and lanes/elementary.c of libtaylor/src with -DTL_REAL_LANES, and link
 * libtaylor itself too, for the same TL_REAL. */
#ifndef TAYLOR_REAL_LANES_H
#define TAYLOR_REAL_LANES_H

#include "taylor/lanes_names.h"

typedef tl_number tl_real __attribute__((vector_size(TL_REAL_LANES * sizeof(tl_number)), aligned(sizeof(tl_number))));
#if TL_REAL == TL_FLOAT
typedef int tl_real_mask __attribute__((vector_size(TL_REAL_LANES * sizeof(int)), aligned(sizeof(int))));
#elif TL_REAL == TL_DOUBLE
typedef long long tl_real_mask __attribute__((vector_size(TL_REAL_LANES * sizeof(long long)), aligned(sizeof(long long))));
#else
#error "TL_REAL_LANES needs TL_REAL to be TL_FLOAT or TL_DOUBLE"
#endif

/* An integer, or one number, in every lane; a constant. */
#define TL_FROM(n) ((tl_number)(n) - (tl_real){0})
#define TL_C(x) TL_FROM(TL_NUMBER(x))

/* The first lane where the mask is true; TL_REAL_LANES where there is none. */
static inline int tl_first_lane(tl_real_mask mask) {
  int lane = 0;
  while (lane < TL_REAL_LANES && !mask[lane]) lane++;
  return lane;
}
#define TL_SOME(mask) (tl_first_lane(mask) < TL_REAL_LANES)
#define TL_EVERY(mask) (tl_first_lane((mask) == 0) == TL_REAL_LANES)
#define TL_FIRST(mask) tl_first_lane(mask)

#endif
