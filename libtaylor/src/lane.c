/* One lane of an operation on jets with lanes, by the functions for one number. */
#include "lane.h"
#include "taylor/elementary.h"

_Static_assert(TL_LANE_JETS == TL_NSCRATCH, "the memory of a lane is that of a context without frames");

unsigned tl_lane_run(const tl_lane_task *task, int *failed) {
  tl_ctx cx;
  const size_t ncoef = (size_t)task->shape->ncoef;
  tl_ctx_init(&cx, task->shape, task->memory, TL_LANE_JETS * ncoef);
  const tl_real *a = task->operands, *b = a + ncoef, *d = b + ncoef;
  tl_real *c = task->results;
  switch (task->function) {
#define TL_X(name)                                                                                                                     \
  case TL_LANE_##name:                                                                                                                 \
    tl_##name(&cx, c, a);                                                                                                              \
    break;
    TL_LANE_ONE(TL_X)
#undef TL_X
#define TL_X(name)                                                                                                                     \
  case TL_LANE_##name:                                                                                                                 \
    tl_##name(&cx, c, a, b);                                                                                                           \
    break;
    TL_LANE_TWO(TL_X)
#undef TL_X
  case TL_LANE_powi:
    tl_powi(&cx, c, a, task->n);
    break;
  case TL_LANE_scalbn:
    tl_scalbn(&cx, c, a, task->n);
    break;
  case TL_LANE_powc:
    tl_powc(&cx, c, a, task->x);
    break;
  case TL_LANE_divc:
    tl_divc(&cx, c, a, task->x);
    break;
  case TL_LANE_rdiv:
    tl_rdiv(&cx, c, task->x, a);
    break;
  case TL_LANE_rpow:
    tl_rpow(&cx, c, task->x, a);
    break;
  case TL_LANE_fma:
    tl_fma(&cx, c, a, b, d);
    break;
  case TL_LANE_sincos:
    tl_sincos(&cx, c, c + ncoef, a);
    break;
  }
  *failed = (int)cx.status.function;
  return cx.status.bits;
}
