/* Exponentials, logarithms, powers with a variable exponent, and the integral of exp(-a^2). */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

static const tl_real LN2 = TL_C(0.693147180559945309417232121458176568);
static const tl_real INV_LN2 = TL_C(1.44269504088896340735992468100189213743);
static const tl_real INV_LN10 = TL_C(0.434294481903251827651128918916605082);
static const tl_real TWO_OVER_SQRT_PI = TL_C(1.12837916709551257389615890312154517169);

/* E c = rate c E a, from c_0 = power; then the value takes power's place (expm1 differs from exp by its value alone). */
static void exponential(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real power, tl_real rate, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  c[0] = power;
  tl_exp_blocks(cx->shape, c, rate, x);
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

void tl_exp2(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real e = TL_LIBM(exp2)(a[0]);
  exponential(cx, c, a, e, e, LN2, TL_FN_exp2);
}

/* x^b = exp(b log x). 0^b is 0 around every b > 0; at b = 0 and for x < 0 it exists for single numbers only. */
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b) {
  const tl_real value = TL_LIBM(pow)(x, b[0]);
  if (!tl_accept(cx, c, x, TL_FN_pow) || !tl_accept(cx, c, b[0], TL_FN_pow)) return;
  if (x > TL_C(0.0))
    exponential(cx, c, b, value, value, TL_LIBM(log)(x), TL_FN_pow);
  else if (!TL_ISFINITE(value))
    tl_reject(cx, c, TL_DOMAIN, TL_FN_pow);
  else if (cx->shape->degree == 0 || (x == TL_C(0.0) && b[0] > TL_C(0.0)))
    tl_const(cx, c, value);
  else
    tl_reject(cx, c, TL_SINGULAR, TL_FN_pow);
}

/* a E c = rate E a:  |B| a_0 c_B = rate |B| a_B - sum_{B1,B2>0} |B1| c_B1 a_B2. Only ratios of a's coefficients enter, which is why a
 * may carry any constant factor. c may not be a. */
static void log_blocks(const tl_shape *s, tl_real *c, tl_real rate, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    const tl_real w = (tl_real)b.weight;
    tl_row_zero(b.n, c + b.at);
    tl_add_interior(s, b, c + b.at, (tl_factor){.u = -TL_C(1.0)}, c, a);
    tl_row_add(b.n, c + b.at, rate * w, a + b.at);
    tl_row_divide(b.n, c + b.at, w * a[0]);
  }
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
  c[0] = value;
  log_blocks(cx->shape, c, rate, x);
  tl_check(cx, c, function);
}

void tl_log(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log)(a[0]), TL_C(1.0), TL_FN_log); }

void tl_log1p(tl_ctx *cx, tl_real *c, const tl_real *a) {
  logarithm(cx, c, a, TL_C(1.0) + a[0], TL_LIBM(log1p)(a[0]), TL_C(1.0), TL_FN_log1p);
}

void tl_log2(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log2)(a[0]), INV_LN2, TL_FN_log2); }

void tl_log10(tl_ctx *cx, tl_real *c, const tl_real *a) { logarithm(cx, c, a, a[0], TL_LIBM(log10)(a[0]), INV_LN10, TL_FN_log10); }

static int is_constant(const tl_shape *s, const tl_real *a) {
  for (int i = 1; i < s->ncoef; i++)
    if (a[i] != TL_C(0.0)) return 0;
  return 1;
}

enum { NPLACE = (TL_WIDE_DEGREE + 1) * (TL_WIDE_DEGREE + 2) / 2 };

/* The coefficients of h^i g^j of a_0^(y+g) (1 + h/x)^(y+g) at their places i + j = n, n(n+1)/2 + j: value e_j b_i with
 *     e = exp(g log a_0),   b_i = binomial(y+g, i) x^-i = b_(i-1) (y - i + 1 + g)/(i x),   polynomials in g. */
static void power_series(tl_real *f, int degree, tl_real x, tl_real y, tl_wide logarithm_of_base, tl_real value) {
  tl_wide e[TL_WIDE_DEGREE + 1] = {tl_widen(value)}, b[TL_WIDE_DEGREE + 1] = {tl_widen(TL_C(1.0))};
  for (int j = 1; j <= degree; j++) e[j] = tl_wide_div(tl_wide_mul(e[j - 1], logarithm_of_base), tl_widen((tl_real)j));
  for (int i = 0; i <= degree; i++) {
    for (int j = 0, n = i; n <= degree; j++, n++) {
      tl_wide sum = tl_wide_mul(b[0], e[j]);
      for (int k = 1; k <= i && k <= j; k++) sum = tl_wide_add(sum, tl_wide_mul(b[k], e[j - k]));
      f[n * (n + 1) / 2 + j] = tl_narrow(sum);
    }
    if (i == degree) return;
    const tl_wide rest = tl_wide_sum(y, -(tl_real)i), over = tl_wide_div(tl_widen(TL_C(1.0)), tl_wide_product((tl_real)(i + 1), x));
    b[i + 1] = tl_widen(TL_C(0.0));
    for (int k = i + 1; k > 0; k--) b[k] = tl_wide_mul(tl_wide_add(tl_wide_mul(b[k], rest), b[k - 1]), over);
    b[0] = tl_wide_mul(tl_wide_mul(b[0], rest), over);
  }
}

/* a^b = a^(b_0) exp((b - b_0) log a): the first factor by the recurrence of a constant exponent, the second from a jet without value,
 * so that powers of b_0 and of log a_0 do not cancel. a_0 > 0. */
static void power_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value) {
  const tl_shape *s = cx->shape;
  const tl_real scale = tl_normaliser(a[0]), exponent = b[0];
  tl_real *l = tl_scratch(cx, 1), *h = tl_scratch(cx, 2), *x = tl_scratch(cx, 3), *factor = tl_scratch(cx, 4),
          *base = tl_scratch(cx, 5);
  logarithm(cx, l, a, a[0], TL_LIBM(log)(a[0]), TL_C(1.0), TL_FN_pow);
  for (int i = 0; i < s->ncoef; i++) {
    x[i] = scale * a[i];
    h[i] = b[i];
  }
  h[0] = TL_C(0.0);
  tl_product_blocks(s, h, h, l);
  factor[0] = TL_C(1.0);
  tl_exp_blocks(s, factor, TL_C(1.0), h);
  base[0] = value;
  tl_power_blocks(s, base, exponent, TL_C(1.0), x);
  tl_product_blocks(s, c, base, factor);
  c[0] = value;
  tl_check(cx, c, TL_FN_pow);
}

static void power(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value) {
  if (cx->shape->degree > TL_WIDE_DEGREE) {
    power_by_recurrence(cx, c, a, b, value);
    return;
  }
  tl_real f[NPLACE], *x = tl_scratch(cx, 2);
  const tl_real scale = tl_normaliser(a[0]);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  power_series(f, cx->shape->degree, x[0], b[0], tl_wide_log(tl_widen(a[0])), value);
  tl_compose_n_blocks(cx, c, 2, (const tl_real *const[]){x, b}, f);
  tl_check(cx, c, TL_FN_pow);
}

/* At a_0 <= 0 only a constant exponent, or one that is larger than the degree at 0. */
void tl_pow(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_real value = TL_LIBM(pow)(a[0], b[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_pow) || !tl_accept(cx, c, b[0], TL_FN_pow)) return;
  if (is_constant(cx->shape, b))
    tl_powc(cx, c, a, b[0]);
  else if (a[0] > TL_C(0.0))
    power(cx, c, a, b, value);
  else if (a[0] == TL_C(0.0) && b[0] > (tl_real)cx->shape->degree)
    tl_row_zero(cx->shape->ncoef, c);
  else
    tl_reject(cx, c, TL_ISFINITE(value) ? TL_SINGULAR : TL_DOMAIN, TL_FN_pow);
}

/* exp(-x^2) = exp(-h^2) exp(-(x-h)(x+h)) with h = x rounded to a multiple of 1/16: h^2 is exact and the second exponent small, so that
 * the tail keeps its digits although exp magnifies the rounding of x^2. */
static tl_real gauss(tl_real x) {
  const tl_real h = TL_LIBM(trunc)(x * TL_C(16.0)) / TL_C(16.0);
  return TL_LIBM(exp)(-h * h) * TL_LIBM(exp)(-(x - h) * (x + h));
}

/* From here on exp(-x^2), below the square of the smallest number, times any number of the range is zero. */
static const tl_real FLAT = TL_MAX_EXP > 1024 ? TL_C(160.0) : TL_C(40.0);

/* E c = rate g E a with g = exp(-a^2), E g = g E(-a^2), rate 2/sqrt(pi) for erf and its opposite for erfc. */
static void integrate_gauss(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real rate, tl_fn function) {
  if (!tl_accept(cx, c, a[0], function)) return;
  const tl_real *x = tl_unaliased(cx, a, c, 0);
  if (TL_LIBM(fabs)(x[0]) > FLAT) {
    tl_check(cx, x, function);
    tl_const(cx, c, value);
    return;
  }
  tl_real *q = tl_scratch(cx, 1), *g = tl_scratch(cx, 2);
  q[0] = TL_C(0.0); /* only its derivatives are used */
  tl_square_blocks(cx->shape, q, -TL_C(1.0), x);
  g[0] = gauss(x[0]);
  tl_exp_blocks(cx->shape, g, TL_C(1.0), q);
  c[0] = value;
  tl_integral_blocks(cx->shape, c, rate, g, x);
  tl_check(cx, c, function);
}

void tl_erf(tl_ctx *cx, tl_real *c, const tl_real *a) { integrate_gauss(cx, c, a, TL_LIBM(erf)(a[0]), TWO_OVER_SQRT_PI, TL_FN_erf); }
void tl_erfc(tl_ctx *cx, tl_real *c, const tl_real *a) {
  integrate_gauss(cx, c, a, TL_LIBM(erfc)(a[0]), -TWO_OVER_SQRT_PI, TL_FN_erfc);
}
