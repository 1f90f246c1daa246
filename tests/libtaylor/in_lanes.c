/* An operation on jets with lanes. */
#include "in_lanes.h"
#include "taylor/taylor.h"

#include <stdio.h>
#include <stdlib.h>

int in_lanes_length(int which, const tl_shape *shape, int place) {
  return which == LANE_TEST_compose && place == IN_LANES_B ? shape->degree + 1 : shape->ncoef;
}

/* Which earlier argument is the same jet, or the argument itself. */
static int first_of_same(const lane_arguments *mine, int i) {
  int first = 0;
  while (mine->jet[first] != mine->jet[i]) first++;
  return first;
}

unsigned in_lanes(int which, const tl_shape *shape, const lane_arguments *mine, const lane_arguments *others, long long n, int lane,
                  int line, int *function, int *at_line) {
  const size_t size = tl_ctx_size(shape, IN_LANES_JETS);
  tl_real *memory = malloc(size * sizeof *memory), *jet[IN_LANES_JETS], x = TL_FROM(others->x);
  if (memory == NULL) abort();
  tl_ctx context, *cx = &context;
  tl_ctx_init(cx, shape, memory, size);
  for (int i = 0; i < IN_LANES_JETS; i++) {
    jet[i] = tl_push(cx, 1);
    if (mine->jet[i] == NULL) continue;
    const int length = in_lanes_length(which, shape, i);
    for (int k = 0; k < length; k++) {
      jet[i][k] = TL_FROM(others->jet[i][k]);
      jet[i][k][lane] = mine->jet[i][k];
    }
    jet[i] = jet[first_of_same(mine, i)];
  }
  x[lane] = mine->x;
  cx->line = line;
  tl_real *c = jet[IN_LANES_C], *d = jet[IN_LANES_D];
  const tl_real *a = jet[IN_LANES_A], *b = jet[IN_LANES_B], *e = jet[IN_LANES_E];
  LANE_TEST_CASES(cx, which, c, d, a, b, e, x, n)
  for (int i = IN_LANES_C; i <= IN_LANES_D; i++)
    for (int k = 0; mine->jet[i] && k < shape->ncoef; k++) mine->jet[i][k] = jet[i][k][lane];
  if (cx->status.bits != TL_OK && cx->status.lane != lane) {
    fprintf(stderr, "operation %d: lane %d has failed, not %d\n", which, cx->status.lane, lane);
    abort();
  }
  free(memory);
  *function = (int)cx->status.function;
  *at_line = cx->status.line;
  return cx->status.bits;
}
