/* Functions made of pieces: each is one of its operands, up to sign, away from a kink. */
#include "block.h"
#include "taylor/elementary.h"

static int is_negative(tl_real x) { return TL_LIBM(copysign)(TL_C(1.0), x) < TL_C(0.0); } /* -0 too */

static void signed_copy(tl_ctx *cx, tl_real *c, const tl_real *a, int negative, tl_fn function) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = negative ? -a[i] : a[i];
  tl_check(cx, c, function);
}

void tl_fabs(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (a[0] == TL_C(0.0) && cx->shape->degree > 0)
    tl_reject(cx, c, TL_SINGULAR, TL_FN_fabs);
  else
    signed_copy(cx, c, a, is_negative(a[0]), TL_FN_fabs);
}

static int same_jet(const tl_shape *s, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < s->ncoef; i++)
    if (a[i] != b[i]) return 0;
  return 1;
}

/* sign +1: the smaller value, -1: the larger. */
static void extremum(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real sign, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function) || !tl_accept(cx, c, b[0], function)) return;
  if (a[0] == b[0] && !same_jet(cx->shape, a, b))
    tl_reject(cx, c, TL_SINGULAR, function);
  else
    signed_copy(cx, c, sign * a[0] <= sign * b[0] ? a : b, 0, function);
}

void tl_fmin(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { extremum(cx, c, a, b, TL_C(1.0), TL_FN_fmin); }
void tl_fmax(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { extremum(cx, c, a, b, -TL_C(1.0), TL_FN_fmax); }

void tl_fdim(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_shape *s = cx->shape;
  const tl_real value = TL_LIBM(fdim)(a[0], b[0]), slope = a[0] > b[0] ? TL_C(1.0) : TL_C(0.0);
  if (!tl_accept(cx, c, a[0], TL_FN_fdim) || !tl_accept(cx, c, b[0], TL_FN_fdim)) return;
  if (a[0] == b[0] && !same_jet(s, a, b)) {
    tl_reject(cx, c, TL_SINGULAR, TL_FN_fdim);
    return;
  }
  for (int i = 1; i < s->ncoef; i++) c[i] = slope * (a[i] - b[i]);
  c[0] = value;
  tl_check(cx, c, TL_FN_fdim);
}

void tl_copysign(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  if (!tl_accept(cx, c, a[0], TL_FN_copysign) || !tl_accept(cx, c, b[0], TL_FN_copysign)) return;
  if ((a[0] == TL_C(0.0) || b[0] == TL_C(0.0)) && cx->shape->degree > 0)
    tl_reject(cx, c, TL_SINGULAR, TL_FN_copysign);
  else
    signed_copy(cx, c, a, is_negative(a[0]) != is_negative(b[0]), TL_FN_copysign);
}
