/* Roots, powers with a constant exponent, products with a power of two, and fma. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

/* c = value (a/a_0)^(p/q) by the power recurrence on a brought to the size of 1, since only ratios of its coefficients enter. a_0 not
 * 0. */
static void power_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real p, tl_real q, tl_fn function) {
  tl_real *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  c[0] = value;
  tl_power_blocks(cx->shape, c, p, q, x);
  tl_check(cx, c, function);
}

void tl_sqrt(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real value = TL_LIBM(sqrt)(a[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_sqrt)) return;
  if (a[0] > TL_C(0.0))
    power_by_recurrence(cx, c, a, value, TL_C(1.0), TL_C(2.0), TL_FN_sqrt);
  else if (a[0] < TL_C(0.0))
    tl_reject(cx, c, TL_DOMAIN, TL_FN_sqrt);
  else if (cx->shape->degree > 0)
    tl_reject(cx, c, TL_SINGULAR, TL_FN_sqrt);
  else
    c[0] = value;
}

/* One step of Newton's method towards the cube root of x from a root r that is right to a few ulp: r - (r^3 - x)/(3 r^2), with r^2 = h
 * + l exactly. The C library's cbrt may be wrong by several ulp, which would go into every coefficient. */
static tl_wide refine_cube_root(tl_real r, tl_real x) {
  const tl_real h = r * r, l = TL_LIBM(fma)(r, r, -h);
  return tl_wide_quick_sum(r, -(TL_LIBM(fma)(h, r, -x) + l * r) / (TL_C(3.0) * h));
}

/* c = value + the series of root ((a/a_0)^(1/3) - 1), f_k = root binomial(1/3, k) a_0^-k: 3 k a_0 f_k = (4 - 3 k) f_(k-1), on a brought
 * to the size of 1. degree <= TL_WIDE_DEGREE. */
static void cube_root_by_series(tl_ctx *cx, tl_real *c, const tl_real *a, tl_wide root, tl_real value) {
  tl_real f[TL_WIDE_DEGREE + 1] = {value}, *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  for (int k = 1; k <= cx->shape->degree; k++) {
    root = tl_wide_div(tl_wide_mul(root, tl_widen((tl_real)(4 - 3 * k))), tl_wide_product((tl_real)(3 * k), x[0]));
    f[k] = tl_narrow(root);
  }
  tl_compose_blocks(cx, c, x, f, cx->shape->degree, 1);
  tl_check(cx, c, TL_FN_cbrt);
}

void tl_cbrt(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real value = TL_LIBM(cbrt)(a[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_cbrt)) return;
  if (a[0] != TL_C(0.0)) {
    const tl_wide root = refine_cube_root(value, a[0]);
    if (cx->shape->degree <= TL_WIDE_DEGREE) {
      cube_root_by_series(cx, c, a, root, value);
    } else {
      power_by_recurrence(cx, c, a, tl_narrow(root), TL_C(1.0), TL_C(3.0), TL_FN_cbrt);
      c[0] = value;
    }
  } else if (cx->shape->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, TL_FN_cbrt);
  } else {
    c[0] = value;
  }
}

/* a^x = sum_k binomial(x,k) a_0^(x-k) (a - a_0)^k: no division by a_0. For an integer x >= 0 the sum ends at k = x. */
static void power_by_series(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  tl_real f[TL_MAX_CURVE + TL_MAX_ORDER + 1], binomial = TL_C(1.0);
  int top = 0;
  for (int k = 0; k <= cx->shape->degree && binomial != TL_C(0.0); k++) {
    f[k] = binomial * TL_LIBM(pow)(a[0], x - (tl_real)k);
    top = k;
    binomial = binomial * (x - (tl_real)k) / (tl_real)(k + 1);
  }
  tl_compose_blocks(cx, c, a, f, top, 0);
  tl_check(cx, c, TL_FN_pow);
}

/* A power whose exponent is constant. Positive integer exponents go through the series, which holds at and near a_0 = 0 too, and so
 * does a value too small for the recurrence to start from. */
void tl_powc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  const int integer = TL_LIBM(trunc)(x) == x;
  const tl_real a0 = a[0], value = TL_LIBM(pow)(a0, x);
  if (!tl_accept(cx, c, a0, TL_FN_pow) || !tl_accept(cx, c, x, TL_FN_pow)) return;
  if ((a0 < TL_C(0.0) && !integer) || (a0 == TL_C(0.0) && x < TL_C(0.0)))
    tl_reject(cx, c, TL_DOMAIN, TL_FN_pow);
  else if (x == TL_C(0.0) || (a0 == TL_C(0.0) && x > (tl_real)cx->shape->degree))
    tl_const(cx, c, value);
  else if (a0 == TL_C(0.0) && !integer)
    tl_reject(cx, c, TL_SINGULAR, TL_FN_pow);
  else if ((integer && x > TL_C(0.0)) || TL_LIBM(fabs)(value) < TL_MIN)
    power_by_series(cx, c, a, x);
  else
    power_by_recurrence(cx, c, a, value, x, TL_C(1.0), TL_FN_pow);
}

void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {
  const tl_real x = (tl_real)n;
  assert((long long)x == n); /* single precision does not hold every int */
  tl_powc(cx, c, a, x);
}

void tl_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *d) {
  const tl_real value = TL_LIBM(fma)(a[0], b[0], d[0]);
  const tl_real *addend = tl_unaliased(cx, d, c, 0);
  tl_product_blocks(cx->shape, c, a, b);
  for (int i = 1; i < cx->shape->ncoef; i++) c[i] += addend[i];
  c[0] = value;
  tl_check(cx, c, TL_FN_fma);
}

void tl_scalbn(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = TL_LIBM(scalbn)(a[i], n);
  tl_check(cx, c, TL_FN_scalbn);
}
