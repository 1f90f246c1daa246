/* Operations on jets of one number. */
#include "one_lane.h"
#include "taylor/taylor.h"

#include <stdlib.h>

unsigned one_lane(int which, const tl_shape *shape, tl_number *c, tl_number *d, const tl_number *a, const tl_number *b, tl_number x,
                  long long n, int *function) {
  const size_t size = tl_ctx_size(shape, 0);
  tl_real *memory = malloc(size * sizeof *memory);
  if (memory == NULL) abort();
  tl_ctx context, *cx = &context;
  tl_ctx_init(cx, shape, memory, size);
  LANE_TEST_CASES(cx, which, c, d, a, b, a, x, n)
  free(memory);
  *function = (int)cx->status.function;
  return cx->status.bits;
}
