/* Sine and cosine, trigonometric and hyperbolic. */
#include "block.h"
#include "taylor/elementary.h"

static void trigonometric(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  sine[0] = TL_LIBM(sin)(a[0]);
  cosine[0] = TL_LIBM(cos)(a[0]);
  tl_circle_blocks(cx->shape, sine, cosine, -TL_C(1.0), a);
}

void tl_sin(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_sin)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  trigonometric(cx, c, tl_scratch(cx, 1), x);
  tl_check(cx, c, TL_FN_sin);
}

void tl_cos(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_cos)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  trigonometric(cx, tl_scratch(cx, 1), c, x);
  tl_check(cx, c, TL_FN_cos);
}

void tl_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  assert(sine != cosine);
  const tl_real *x = a == cosine ? tl_unaliased(cx, a, cosine, 0) : tl_unaliased(cx, a, sine, 0);
  if (!tl_accept(cx, sine, x[0], TL_FN_sin) || !tl_accept(cx, cosine, x[0], TL_FN_cos)) {
    tl_reject(cx, cosine, TL_NONFINITE, TL_FN_cos);
    return;
  }
  trigonometric(cx, sine, cosine, x);
  tl_check(cx, sine, TL_FN_sin);
  tl_check(cx, cosine, TL_FN_cos);
}

static void hyperbolic(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  const tl_real s = TL_LIBM(sinh)(a[0]), c = TL_LIBM(cosh)(a[0]);
  const int large = c > TL_MAX / TL_HEADROOM && TL_ISFINITE(c); /* the recurrence takes multiples of them */
  sine[0] = large ? s / TL_HEADROOM : s;
  cosine[0] = large ? c / TL_HEADROOM : c;
  tl_circle_blocks(cx->shape, sine, cosine, TL_C(1.0), a);
  if (!large) return;
  tl_row_scale(cx->shape->ncoef, sine, TL_HEADROOM);
  tl_row_scale(cx->shape->ncoef, cosine, TL_HEADROOM);
  sine[0] = s;
  cosine[0] = c;
}

void tl_sinh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_sinh)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  hyperbolic(cx, c, tl_scratch(cx, 1), x);
  tl_check(cx, c, TL_FN_sinh);
}

void tl_cosh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_cosh)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  hyperbolic(cx, tl_scratch(cx, 1), c, x);
  tl_check(cx, c, TL_FN_cosh);
}
