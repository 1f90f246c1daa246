/* Trigonometric and hyperbolic functions. */
#include "block.h"
#include "taylor/elementary.h"

/* E s = c E a,  E c = sign s E a, from s_0 and c_0. a may be neither s nor c. */
static void circle_blocks(const tl_shape *s, tl_real *sine, tl_real *cosine, tl_real sign, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_real *sB = sine + b.at, *cB = cosine + b.at;
    tl_row_zero(b.n, sB);
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, sB, (tl_factor){.u = TL_C(1.0)}, a, cosine);
    tl_add_interior(s, b, cB, (tl_factor){.u = sign}, a, sine);
    tl_row_divide_weight(b.n, sB, b.weight);
    tl_row_divide_weight(b.n, cB, b.weight);
    tl_row_add(b.n, sB, cosine[0], a + b.at);
    tl_row_add(b.n, cB, sign * sine[0], a + b.at);
  }
}

static void trigonometric(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  sine[0] = TL_LIBM(sin)(a[0]);
  cosine[0] = TL_LIBM(cos)(a[0]);
  circle_blocks(cx->shape, sine, cosine, -TL_C(1.0), a);
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

/* E c = q E a with q = 1 + sign c^2, from c_0 = start and q_0 = slope: c_B by the sum over lower blocks of q, then q_B by that over c.
 * Then the value takes start's place. */
static void tangent(tl_ctx *cx, tl_real *c, tl_real sign, tl_real start, tl_real slope, tl_real value, const tl_real *a,
                    tl_fn function) {
  const tl_shape *s = cx->shape;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  tl_real *q = tl_scratch(cx, 1);
  c[0] = start;
  q[0] = slope;
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_real *cB = c + b.at, *qB = q + b.at;
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, cB, (tl_factor){.u = TL_C(1.0)}, x, q);
    tl_row_divide_weight(b.n, cB, b.weight);
    tl_row_add(b.n, cB, q[0], x + b.at);
    tl_row_zero(b.n, qB);
    tl_add_interior(s, b, qB, (tl_factor){.z = sign}, c, c);
    tl_row_add(b.n, qB, TL_C(2.0) * sign * c[0], cB);
  }
  c[0] = value;
  tl_check(cx, c, function);
}

void tl_tan(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_tan)) return;
  const tl_real t = TL_LIBM(tan)(a[0]);
  tangent(cx, c, TL_C(1.0), t, TL_C(1.0) + t * t, t, a, TL_FN_tan);
}

/* tanh and its slope 1 - tanh^2 from e = exp(-2|x|): (1-e)/(1+e) and 4e/(1+e)^2, which keep their digits where tanh is near 1; near 0
 * from e - 1. Both are nearer to the truth than the C library's tanh and cosh. */
void tl_tanh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_tanh)) return;
  const tl_real y = -TL_C(2.0) * TL_LIBM(fabs)(a[0]), m = TL_LIBM(expm1)(y), start = -m / (TL_C(2.0) + m);
  const tl_real e = TL_LIBM(exp)(y), sum = TL_C(1.0) + e, rest = e - (sum - TL_C(1.0)); /* sum + rest = 1 + e exactly */
  const tl_real square = sum * sum + (TL_LIBM(fma)(sum, sum, -(sum * sum)) + TL_C(2.0) * sum * rest);
  const tl_real slope = start < TL_C(0.5) ? TL_LIBM(fma)(-start, start, TL_C(1.0)) : TL_C(4.0) * e / square;
  tangent(cx, c, -TL_C(1.0), TL_LIBM(copysign)(start, a[0]), slope, TL_LIBM(tanh)(a[0]), a, TL_FN_tanh);
}

static void hyperbolic(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a) {
  sine[0] = TL_LIBM(sinh)(a[0]);
  cosine[0] = TL_LIBM(cosh)(a[0]);
  circle_blocks(cx->shape, sine, cosine, TL_C(1.0), a);
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
