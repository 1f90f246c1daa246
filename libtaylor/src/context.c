/* The context: workspace, frames and status. */
#include "taylor/context.h"

#include <assert.h>
#include <stdint.h>

size_t tl_ctx_size(const tl_shape *shape, size_t njet) {
  const size_t ncoef = (size_t)shape->ncoef;
  return njet > SIZE_MAX / ncoef - TL_NSCRATCH ? SIZE_MAX : (njet + TL_NSCRATCH) * ncoef;
}

void tl_ctx_init(tl_ctx *cx, const tl_shape *shape, tl_real *memory, size_t nreal) {
  *cx = (tl_ctx){.shape = shape, .scratch = memory, .top = memory, .end = memory};
  const size_t scratch = tl_ctx_size(shape, 0);
  if (nreal < scratch) {
    cx->scratch = NULL;
    tl_fail(cx, TL_NO_SPACE, TL_FN_frame);
    return;
  }
  cx->top = memory + scratch;
  cx->end = memory + nreal;
}

void tl_ctx_clear(tl_ctx *cx) { cx->status = (tl_status){.bits = TL_OK}; }

void tl_fail(tl_ctx *cx, unsigned bits, tl_fn function) { tl_fail_in_lane(cx, bits, function, 0); }

void tl_fail_in_lane(tl_ctx *cx, unsigned bits, tl_fn function, int lane) {
  if (cx->status.bits == TL_OK) {
    cx->status.function = function;
    cx->status.lane = lane;
    cx->status.line = cx->line;
    cx->status.file = cx->file;
  }
  cx->status.bits |= bits;
}

tl_real *tl_push(tl_ctx *cx, size_t njet) {
  const size_t room = (size_t)(cx->end - cx->top), ncoef = (size_t)cx->shape->ncoef;
  if (njet > room / ncoef) {
    tl_fail(cx, TL_NO_SPACE, TL_FN_frame);
    return NULL;
  }
  tl_real *frame = cx->top;
  cx->top += njet * ncoef;
  for (tl_real *x = frame; x < cx->top; x++) *x = TL_FROM(NAN);
  return frame;
}

void tl_pop(tl_ctx *cx, size_t njet) {
  const size_t n = njet * (size_t)cx->shape->ncoef;
  assert((size_t)(cx->top - cx->scratch) >= n + tl_ctx_size(cx->shape, 0));
  cx->top -= n;
}

const char *tl_fn_name(tl_fn function) {
  switch (function) {
  case TL_FN_none:
    return "none";
#define TL_X(name)                                                                                                                     \
  case TL_FN_##name:                                                                                                                   \
    return #name;
    TL_FUNCTIONS(TL_X)
#undef TL_X
  }
  return "unknown";
}

const char *tl_status_text(unsigned bits) {
  if (bits & TL_NO_SPACE) return "workspace too small";
  if (bits & TL_DOMAIN) return "outside the domain";
  if (bits & TL_SINGULAR) return "derivative does not exist";
  if (bits & TL_NONFINITE) return "number not finite";
  return "ok";
}
