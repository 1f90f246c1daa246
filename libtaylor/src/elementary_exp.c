/* Exponentials, logarithms, and the integral of exp(-a^2). */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

static const tl_real INV_LN2 = TL_C(1.44269504088896340735992468100189213743);
static const tl_real INV_LN10 = TL_C(0.434294481903251827651128918916605082);
static const tl_real TWO_OVER_SQRT_PI = TL_C(1.12837916709551257389615890312154517169);

/* E c = rate c E a, from c_0 = power; then the value takes power's place (expm1 differs from exp by its value alone). A power near the
 * largest number is brought down meanwhile: the recurrence takes multiples of it. */
static void exponential(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real power, tl_real rate, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  const int large = power > TL_MAX / TL_HEADROOM && TL_ISFINITE(power);
  c[0] = large ? power / TL_HEADROOM : power;
  tl_exp_blocks(cx->shape, c, rate, x);
  if (large) tl_row_scale(cx->shape->ncoef, c, TL_HEADROOM);
  c[0] = value;
  tl_check(cx, c, function);
}

void tl_exp(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real e = TL_LIBM(exp)(a[0]);
  exponential(cx, c, a, e, e, TL_C(1.0), TL_FN_exp);
}

void tl_expm1(tl_ctx *cx, tl_real *c, const tl_real *a) {
  exponential(cx, c, a, TL_LIBM(expm1)(a[0]), TL_LIBM(exp)(a[0]), TL_C(1.0), TL_FN_expm1);
}

/* f_k = value (log 2)^k/k!, rounded once. */
static void exp2_by_series(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value) {
  tl_real f[TL_WIDE_DEGREE + 1] = {value};
  tl_wide power = tl_widen(value);
  for (int k = 1; k <= cx->shape->degree; k++) {
    power = tl_wide_div(tl_wide_mul(power, tl_wide_ln2), tl_widen((tl_real)k));
    f[k] = tl_narrow(power);
  }
  tl_compose_blocks(cx, c, a, f, cx->shape->degree, 0);
  tl_check(cx, c, TL_FN_exp2);
}

void tl_exp2(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real e = TL_LIBM(exp2)(a[0]);
  if (cx->shape->degree <= TL_WIDE_DEGREE && TL_ISFINITE(a[0]))
    exp2_by_series(cx, c, a, e);
  else
    exponential(cx, c, a, e, e, tl_narrow(tl_wide_ln2), TL_FN_exp2);
}

/* argument: the number whose logarithm it is, a_0 or 1 + a_0. */
static void logarithm(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real argument, tl_real value, tl_real rate, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function)) return;
  if (argument <= TL_C(0.0)) {
    tl_reject(cx, c, TL_DOMAIN, function);
    return;
  }
  tl_real *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(argument);
  for (int i = 1; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  x[0] = scale * argument;
  const int large = scale > TL_C(1.0) / TL_EPSILON; /* the recurrence takes multiples of the derivatives */
  tl_log_blocks(cx->shape, c, large ? rate / TL_HEADROOM : rate, x);
  if (large) tl_row_scale(cx->shape->ncoef, c, TL_HEADROOM);
  c[0] = value;
  tl_check(cx, c, function);
}

void tl_log(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log)(a[0]), TL_C(1.0), TL_FN_log); }

/* log(1 + a) from the exact sum 1 + a_0, brought to the size of 1: f_k = (-1)^(k-1)/(k (1 + a_0)^k). */
static void logarithm_past_one(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_wide sum = tl_wide_sum(TL_C(1.0), a[0]);
  const tl_real scale = tl_normaliser(sum.hi);
  const tl_wide x = {.hi = scale * sum.hi, .lo = scale * sum.lo};
  tl_real f[TL_WIDE_DEGREE + 1] = {TL_LIBM(log1p)(a[0])}, *u = tl_scratch(cx, 0);
  tl_wide power = tl_widen(-TL_C(1.0));
  for (int i = 0; i < cx->shape->ncoef; i++) u[i] = scale * a[i];
  for (int k = 1; k <= cx->shape->degree; k++) {
    power = tl_wide_neg(tl_wide_div(power, x));
    f[k] = tl_narrow(tl_wide_div(power, tl_widen((tl_real)k)));
  }
  tl_compose_blocks(cx, c, u, f, cx->shape->degree, 1);
  tl_check(cx, c, TL_FN_log1p);
}

void tl_log1p(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (cx->shape->degree <= TL_WIDE_DEGREE && a[0] > -TL_C(1.0) && TL_ISFINITE(a[0]))
    logarithm_past_one(cx, c, a);
  else
    logarithm(cx, c, a, TL_C(1.0) + a[0], TL_LIBM(log1p)(a[0]), TL_C(1.0), TL_FN_log1p);
}

void tl_log2(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log2)(a[0]), INV_LN2, TL_FN_log2); }

void tl_log10(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log10)(a[0]), INV_LN10, TL_FN_log10); }

/* A product with exp(-x^2), x^2 = square.hi + square.lo: no digits lost to the rounding of x^2, which exp magnifies, nor below the
 * normal numbers. */
static tl_real times_gauss(tl_wide factor, tl_wide square) {
  const tl_real whole = TL_LIBM(exp)(-square.hi), half = TL_LIBM(exp)(-square.hi / TL_C(2.0));
  factor = tl_wide_mul(factor, tl_wide_sum(TL_C(1.0), -square.lo));
  return whole > TL_MIN / TL_EPSILON ? tl_narrow(factor) * whole : tl_narrow(factor) * half * half;
}

/* From here on exp(-x^2), below the square of the smallest number, times any number of the range is zero. */
static const tl_real FLAT = TL_MAX_EXP > 1024 ? TL_C(160.0) : TL_C(40.0);

/* f_k = rate p_(k-1)/k exp(-x^2), where exp(-(x+h)^2) = exp(-x^2) sum p_n h^n:  n p_n = -2 (x p_(n-1) + p_(n-2)). */
static void gauss_series(tl_real *f, int degree, tl_real x, tl_real rate) {
  const tl_wide square = tl_wide_product(x, x);
  tl_wide before = tl_widen(TL_C(0.0)), p = tl_widen(TL_C(1.0));
  for (int k = 1; k <= degree; k++) {
    f[k] = times_gauss(tl_wide_div(tl_wide_mul(p, tl_widen(rate)), tl_widen((tl_real)k)), square);
    const tl_wide sum = tl_wide_add(tl_wide_mul(p, tl_widen(x)), before);
    before = p;
    p = tl_wide_div(tl_wide_mul(sum, tl_widen(-TL_C(2.0))), tl_widen((tl_real)k));
  }
}

/* E c = rate g E a with g = exp(-a^2), E g = g E(-a^2). c may not be a. */
static void gauss_blocks(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real rate) {
  tl_real *q = tl_scratch(cx, 1), *g = tl_scratch(cx, 2);
  q[0] = TL_C(0.0); /* only its derivatives are used */
  tl_square_blocks(cx->shape, q, -TL_C(1.0), a);
  g[0] = times_gauss(tl_widen(TL_C(1.0)), tl_wide_product(a[0], a[0]));
  tl_exp_blocks(cx->shape, g, TL_C(1.0), q);
  tl_integral_blocks(cx->shape, c, rate, g, a);
}

/* The integral of rate exp(-a^2), rate 2/sqrt(pi) for erf and its opposite for erfc. */
static void integrate_gauss(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real rate, tl_fn function) {
  const int degree = cx->shape->degree;
  if (!tl_accept(cx, c, a[0], function)) return;
  if (TL_LIBM(fabs)(a[0]) > FLAT) {
    tl_check(cx, a, function);
    tl_const(cx, c, value);
    return;
  }
  if (degree <= TL_WIDE_DEGREE) {
    tl_real f[TL_WIDE_DEGREE + 1] = {value};
    gauss_series(f, degree, a[0], rate);
    tl_compose_blocks(cx, c, a, f, degree, 0);
  } else {
    gauss_blocks(cx, c, tl_unaliased(cx, a, c, 0), rate);
    c[0] = value;
  }
  tl_check(cx, c, function);
}

void tl_erf(tl_ctx *cx, tl_real *c, const tl_real *a) { integrate_gauss(cx, c, a, TL_LIBM(erf)(a[0]), TWO_OVER_SQRT_PI, TL_FN_erf); }
void tl_erfc(tl_ctx *cx, tl_real *c, const tl_real *a) {
  integrate_gauss(cx, c, a, TL_LIBM(erfc)(a[0]), -TWO_OVER_SQRT_PI, TL_FN_erfc);
}
