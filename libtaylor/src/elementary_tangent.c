/* Tangents, trigonometric and hyperbolic: in twice the precision up to some degree. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

/* The recurrence of tangent_series in blocks: c_B by the sum over lower blocks of q, then q_B by that over c. c may not be a. */
static void tangent_blocks(tl_ctx *cx, tl_real *c, tl_real sign, tl_real start, tl_real slope, const tl_real *a) {
  const tl_shape *s = cx->shape;
  tl_real *q = tl_scratch(cx, 1);
  c[0] = start;
  q[0] = slope;
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_real *cB = c + b.at, *qB = q + b.at;
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, cB, (tl_factor){.u = TL_C(1.0)}, a, q);
    tl_row_divide_weight(b.n, cB, b.weight);
    tl_row_add(b.n, cB, q[0], a + b.at);
    tl_row_zero(b.n, qB);
    tl_add_interior(s, b, qB, (tl_factor){.z = sign}, c, c);
    tl_row_add(b.n, qB, TL_C(2.0) * sign * c[0], cB);
  }
}

/* c' = q, q = 1 + sign c^2:  (k+1) c_(k+1) = q_k,  q_k = sign sum_{i=0..k} c_i c_(k-i) for k > 0; f[k] = c_k shrink^k, k = 1..degree,
 * shrink a power of two. */
static void tangent_series(tl_real *f, int degree, tl_real sign, tl_wide start, tl_wide slope, tl_real shrink) {
  tl_wide c[TL_WIDE_DEGREE + 1] = {start};
  for (int k = 1; k <= degree; k++) {
    tl_wide q = slope;
    for (int i = 0; k > 1 && i < k; i++) {
      const tl_wide term = tl_wide_mul(c[i], c[k - 1 - i]);
      q = i == 0 ? term : tl_wide_add(q, term);
    }
    c[k] = tl_wide_div(q, tl_widen((k > 1 ? sign * (tl_real)k : TL_C(1.0)) / shrink));
    f[k] = tl_narrow(c[k]);
  }
}

/* E c = q E a with q = 1 + sign c^2, from c_0 = start and q_0 = slope. Then the value takes start's place. Near a pole the coefficients
 * of the series grow like powers of its distance, which a takes over. */
static void tangent(tl_ctx *cx, tl_real *c, tl_real sign, tl_wide start, tl_wide slope, tl_real value, const tl_real *a,
                    tl_fn function) {
  const int degree = cx->shape->degree;
  if (degree <= TL_WIDE_DEGREE) {
    tl_real f[TL_WIDE_DEGREE + 1] = {value}, *x = tl_scratch(cx, 0);
    const tl_real shrink = TL_LIBM(fmin)(tl_normaliser(value), TL_C(1.0));
    for (int i = 0; i < cx->shape->ncoef; i++) x[i] = a[i] / shrink;
    tangent_series(f, degree, sign, start, slope, shrink);
    tl_compose_blocks(cx, c, x, f, degree, 1);
  } else {
    tangent_blocks(cx, c, sign, tl_narrow(start), tl_narrow(slope), tl_unaliased(cx, a, c, 0));
    c[0] = value;
  }
  tl_check(cx, c, function);
}

void tl_tan(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_tan)) return;
  const tl_real t = TL_LIBM(tan)(a[0]);
  tangent(cx, c, TL_C(1.0), tl_widen(t), tl_wide_add(tl_widen(TL_C(1.0)), tl_wide_product(t, t)), t, a, TL_FN_tan);
}

/* tanh x >= 0 and its slope from e = exp(-2x): (1-e)/(1+e) and 4e/(1+e)^2, which keep their digits where tanh is near 1; below 2^-20,
 * where 1 - e would lose some, from m = e - 1: -m/(2+m) and 1 - tanh^2. Both are nearer to the truth than the C library's tanh and
 * cosh. */
static void tanh_and_slope(tl_real x, tl_wide *value, tl_wide *slope) {
  if (x < TL_C(9.5367431640625e-7)) {
    const tl_real m = TL_LIBM(expm1)(-TL_C(2.0) * x);
    *value = tl_wide_div(tl_widen(-m), tl_wide_sum(TL_C(2.0), m));
    *slope = tl_wide_add(tl_widen(TL_C(1.0)), tl_wide_neg(tl_wide_mul(*value, *value)));
  } else {
    const tl_wide one = tl_widen(TL_C(1.0)), e = tl_wide_exp(-TL_C(2.0) * x), sum = tl_wide_add(one, e);
    *value = tl_wide_div(tl_wide_add(one, tl_wide_neg(e)), sum);
    *slope = tl_wide_div(tl_wide_mul(tl_widen(TL_C(4.0)), e), tl_wide_mul(sum, sum));
  }
}

void tl_tanh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_tanh)) return;
  tl_wide start, slope;
  tanh_and_slope(TL_LIBM(fabs)(a[0]), &start, &slope);
  tangent(cx, c, -TL_C(1.0), a[0] < TL_C(0.0) ? tl_wide_neg(start) : start, slope, TL_LIBM(tanh)(a[0]), a, TL_FN_tanh);
}
