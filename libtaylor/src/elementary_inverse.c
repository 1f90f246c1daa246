/* Inverse trigonometric and hyperbolic functions. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

/* g_n = coefficient n of (d_0 + d_1 h + d_2 h^2)^p, n = 1..top, from g_0:
 *     n d_0 g_n = (p - n + 1) d_1 g_(n-1) + (2 p - n + 2) d_2 g_(n-2). */
static void quadratic_power(tl_wide *g, int top, tl_wide d0, tl_real d1, tl_real d2, tl_real p) {
  for (int n = 1; n <= top; n++) {
    const tl_real i = (tl_real)n;
    tl_wide sum = tl_wide_mul(g[n - 1], tl_wide_product(p - i + TL_C(1.0), d1));
    if (n > 1) sum = tl_wide_add(sum, tl_wide_mul(g[n - 2], tl_widen((TL_C(2.0) * p - i + TL_C(2.0)) * d2)));
    g[n] = tl_wide_div(sum, tl_wide_mul(d0, tl_widen(i)));
  }
}

/* E c = rate d^p E a, where d = sign a^2 + constant is given by its value d_0, and p is -1 or -1/2. Powers of a power are free of
 * cancellation near the ends of a domain as long as d_0 is. a is scaled by the caller; x is that scaled jet in scratch jet 0. Near the
 * ends the coefficients of the series grow like powers of the distance, which x takes over. */
static void integrate_power(tl_ctx *cx, tl_real *c, tl_real value, tl_real rate, tl_real sign, tl_wide d0, tl_real p, tl_fn function) {
  const int degree = cx->shape->degree;
  const tl_real *x = tl_scratch(cx, 0);
  const tl_wide g0 = tl_wide_div(tl_widen(TL_C(1.0)), p == -TL_C(1.0) ? d0 : tl_wide_sqrt(d0));
  if (degree <= TL_WIDE_DEGREE) {
    tl_wide series[TL_WIDE_DEGREE] = {g0};
    tl_real f[TL_WIDE_DEGREE + 1] = {value};
    const tl_real shrink = TL_C(1.0) / TL_LIBM(fmax)(tl_normaliser(d0.hi), TL_C(1.0));
    quadratic_power(series, degree - 1, d0, TL_C(2.0) * sign * x[0] * shrink, sign * shrink * shrink, p);
    for (int k = 1; k <= degree; k++) f[k] = rate * shrink * tl_narrow(tl_wide_div(series[k - 1], tl_widen((tl_real)k)));
    tl_row_scale(cx->shape->ncoef, tl_scratch(cx, 0), TL_C(1.0) / shrink);
    tl_compose_blocks(cx, c, x, f, degree, 1);
  } else {
    tl_real *d = tl_scratch(cx, 1), *g = tl_scratch(cx, 2);
    d[0] = tl_narrow(d0);
    tl_square_blocks(cx->shape, d, sign, x);
    g[0] = tl_narrow(g0);
    tl_power_blocks(cx->shape, g, p, TL_C(1.0), d);
    c[0] = value;
    tl_integral_blocks(cx->shape, c, rate, g, x);
  }
  tl_check(cx, c, function);
}

/* x^2 + y^2 and (x-y)(x+y). */
static tl_wide sum_of_squares(tl_real x, tl_real y) { return tl_wide_add(tl_wide_product(x, x), tl_wide_product(y, y)); }
static tl_wide difference_of_squares(tl_real x, tl_real y) { return tl_wide_mul(tl_wide_sum(x, -y), tl_wide_sum(x, y)); }

/* Scratch jet 0 = scale * a. */
static void load(tl_ctx *cx, const tl_real *a, tl_real scale) {
  tl_real *x = tl_scratch(cx, 0);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
}

/* The factor that brings |x| > 1 to about 1, so that its square cannot overflow; smaller x stay as they are. */
static tl_real shrink(tl_real x) { return TL_LIBM(fabs)(x) > TL_C(1.0) ? tl_normaliser(x) : TL_C(1.0); }

/* E asin(a) = E a / sqrt(1 - a^2), 1 - a^2 = (1-a)(1+a); acos with the other sign. */
static void arc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real rate, tl_fn function) {
  const tl_real size = TL_LIBM(fabs)(a[0]);
  if (!tl_accept(cx, c, a[0], function)) return;
  if (size > TL_C(1.0) || (size == TL_C(1.0) && cx->shape->degree > 0)) {
    tl_reject(cx, c, size > TL_C(1.0) ? TL_DOMAIN : TL_SINGULAR, function);
    return;
  }
  load(cx, a, TL_C(1.0));
  integrate_power(cx, c, value, rate, -TL_C(1.0), difference_of_squares(TL_C(1.0), a[0]), -TL_C(0.5), function);
}

void tl_asin(tl_ctx *cx, tl_real *c, const tl_real *a) { arc(cx, c, a, TL_LIBM(asin)(a[0]), TL_C(1.0), TL_FN_asin); }
void tl_acos(tl_ctx *cx, tl_real *c, const tl_real *a) { arc(cx, c, a, TL_LIBM(acos)(a[0]), -TL_C(1.0), TL_FN_acos); }

/* E atan(a) = E a / (1 + a^2) = scale E x / (scale^2 + x^2) with x = scale a. */
void tl_atan(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_atan)) return;
  const tl_real value = TL_LIBM(atan)(a[0]), scale = shrink(a[0]);
  load(cx, a, scale);
  integrate_power(cx, c, value, scale, TL_C(1.0), sum_of_squares(scale, scale * a[0]), -TL_C(1.0), TL_FN_atan);
}

/* E asinh(a) = E a / sqrt(1 + a^2) = E x / sqrt(scale^2 + x^2) with x = scale a. */
void tl_asinh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_asinh)) return;
  const tl_real value = TL_LIBM(asinh)(a[0]), scale = shrink(a[0]);
  load(cx, a, scale);
  integrate_power(cx, c, value, TL_C(1.0), TL_C(1.0), sum_of_squares(scale, scale * a[0]), -TL_C(0.5), TL_FN_asinh);
}

/* E acosh(a) = E a / sqrt(a^2 - 1) = E x / sqrt(x^2 - scale^2), x^2 - scale^2 = (x - scale)(x + scale) with x = scale a. */
void tl_acosh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!tl_accept(cx, c, a[0], TL_FN_acosh)) return;
  if (a[0] < TL_C(1.0) || (a[0] == TL_C(1.0) && cx->shape->degree > 0)) {
    tl_reject(cx, c, a[0] < TL_C(1.0) ? TL_DOMAIN : TL_SINGULAR, TL_FN_acosh);
    return;
  }
  const tl_real value = TL_LIBM(acosh)(a[0]), scale = shrink(a[0]);
  load(cx, a, scale);
  integrate_power(cx, c, value, TL_C(1.0), TL_C(1.0), difference_of_squares(scale * a[0], scale), -TL_C(0.5), TL_FN_acosh);
}

/* E atanh(a) = E a / (1 - a^2). */
void tl_atanh(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real value = TL_LIBM(atanh)(a[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_atanh)) return;
  if (TL_LIBM(fabs)(a[0]) >= TL_C(1.0)) {
    tl_reject(cx, c, TL_DOMAIN, TL_FN_atanh);
    return;
  }
  load(cx, a, TL_C(1.0));
  integrate_power(cx, c, value, TL_C(1.0), -TL_C(1.0), difference_of_squares(TL_C(1.0), a[0]), -TL_C(1.0), TL_FN_atanh);
}
