/* Functions with jumps: steps, and the rests of divisions. And C's rounding to single precision, whose jumps are not seen. */
#include "block.h"
#include "taylor/elementary.h"

/* The constant value; at a jump no derivative exists. The derivatives of a leave no trace, but may not be lost where they are no
 * numbers. */
static void step(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, int at_jump, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function)) return;
  if (at_jump && cx->shape->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, function);
    return;
  }
  tl_check(cx, a, function);
  tl_row_zero(cx->shape->ncoef, c);
  c[0] = value;
}

static int is_integer(tl_real x) { return x == TL_LIBM(trunc)(x); }
static int is_half(tl_real x) { return TL_LIBM(fabs)(x - TL_LIBM(trunc)(x)) == TL_C(0.5); } /* the difference is exact */

void tl_floor(tl_ctx *cx, tl_real *c, const tl_real *a) { step(cx, c, a, TL_LIBM(floor)(a[0]), is_integer(a[0]), TL_FN_floor); }
void tl_ceil(tl_ctx *cx, tl_real *c, const tl_real *a) { step(cx, c, a, TL_LIBM(ceil)(a[0]), is_integer(a[0]), TL_FN_ceil); }
void tl_trunc(tl_ctx *cx, tl_real *c, const tl_real *a) {
  step(cx, c, a, TL_LIBM(trunc)(a[0]), is_integer(a[0]) && a[0] != TL_C(0.0), TL_FN_trunc);
}
void tl_round(tl_ctx *cx, tl_real *c, const tl_real *a) { step(cx, c, a, TL_LIBM(round)(a[0]), is_half(a[0]), TL_FN_round); }
void tl_rint(tl_ctx *cx, tl_real *c, const tl_real *a) { step(cx, c, a, TL_LIBM(rint)(a[0]), is_half(a[0]), TL_FN_rint); }

/* c = a - n b with the integer n that belongs to the given exact rest a_0 - n b_0. n is exact below 1/TL_EPSILON; above it is right to
 * about an ulp, and it may overflow, which does not matter where b is constant. */
static void rest(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value) {
  const tl_real n = TL_LIBM(round)(a[0] / b[0] - value / b[0]);
  for (int i = 1; i < cx->shape->ncoef; i++) c[i] = b[i] == TL_C(0.0) ? a[i] : TL_LIBM(fma)(-n, b[i], a[i]);
  c[0] = value;
}

static void divide_with_rest(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value, int at_jump, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function) || !tl_accept(cx, c, b[0], function)) return;
  if (b[0] == TL_C(0.0)) {
    tl_reject(cx, c, TL_DOMAIN, function);
    return;
  }
  if (at_jump && cx->shape->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, function);
    return;
  }
  rest(cx, c, a, b, value);
  tl_check(cx, c, function);
}

void tl_fmod(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_real value = TL_LIBM(fmod)(a[0], b[0]);
  divide_with_rest(cx, c, a, b, value, value == TL_C(0.0) && a[0] != TL_C(0.0), TL_FN_fmod);
}

void tl_remainder(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_real value = TL_LIBM(remainder)(a[0], b[0]);
  divide_with_rest(cx, c, a, b, value, TL_C(2.0) * TL_LIBM(fabs)(value) == TL_LIBM(fabs)(b[0]), TL_FN_remainder);
}

void tl_float(tl_ctx *cx, tl_real *c, const tl_real *a) {
  for (int i = 1; i < cx->shape->ncoef; i++) c[i] = a[i];
  c[0] = TL_TO_SINGLE(a[0]);
  tl_check(cx, c, TL_FN_float);
}
