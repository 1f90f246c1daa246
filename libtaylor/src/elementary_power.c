/* Roots, powers, products with a power of two, and fma. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

enum { MAX_DEGREE = TL_MAX_CURVE + TL_MAX_ORDER };

/* c = value (a/a_0)^(p/q) by the power recurrence on a brought to the size of 1, since only ratios of its coefficients enter. a_0 not
 * 0. Where the derivatives are large, c is brought down meanwhile: the recurrence takes multiples of them. */
static void power_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real p, tl_real q, tl_fn function) {
  tl_real *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  const int large = scale > TL_C(1.0) / TL_EPSILON;
  c[0] = large ? value / TL_HEADROOM : value;
  tl_power_blocks(cx->shape, c, p, q, x);
  if (large) tl_row_scale(cx->shape->ncoef, c, TL_HEADROOM);
  c[0] = value;
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

/* factor x^(y-i) times. Digits are lost neither to the rounding of y - i, which a large logarithm of x magnifies, nor where the power
 * alone is beyond the normal numbers. */
static tl_real times_power(tl_wide factor, tl_real x, tl_real y, int i, tl_real times) {
  const tl_wide exponent = tl_wide_sum(y, -(tl_real)i);
  const tl_real whole = TL_LIBM(pow)(x, exponent.hi), size = TL_LIBM(fabs)(x);
  if (exponent.lo != TL_C(0.0)) factor = tl_wide_mul(factor, tl_wide_sum(TL_C(1.0), exponent.lo * TL_LIBM(log)(size)));
  if (TL_LIBM(fabs)(whole) >= TL_MIN && TL_ISFINITE(whole)) return tl_narrow(tl_wide_mul(factor, tl_widen(whole))) * times;
  const tl_real half = TL_LIBM(pow)(size, exponent.hi / TL_C(2.0));
  if (half == TL_C(0.0)) return half;
  if (TL_ISFINITE(half)) return tl_narrow(factor) * half * times * TL_LIBM(copysign)(half, whole);
  const tl_real quarter = TL_LIBM(pow)(size, exponent.hi / TL_C(4.0));
  return tl_narrow(factor) * quarter * times * quarter * quarter * TL_LIBM(copysign)(quarter, whole);
}

/* Far enough from the ends of the range of numbers for a product with a number around 1 to keep its digits. */
static int is_moderate(tl_real x) {
  const tl_real size = TL_LIBM(fabs)(x);
  return size >= TL_MIN / TL_EPSILON && size <= TL_MAX * TL_EPSILON;
}

/* a^y = sum_k f_k (a - a_0)^k, f_k = binomial(y,k) a_0^(y-k): no division by a_0. For an integer y >= 0 the sum ends at k = y. The
 * factor y of the binomial comes last, since it may be tiny. */
static void power_by_series(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real y) {
  tl_real f[MAX_DEGREE + 1] = {TL_LIBM(pow)(a[0], y)};
  tl_wide over_y = tl_widen(TL_C(1.0)); /* binomial(y,k)/y */
  int top = 0;
  for (int k = 1; k <= cx->shape->degree && over_y.hi != TL_C(0.0); k++) {
    f[k] = times_power(over_y, a[0], y, k, y);
    top = k;
    over_y = tl_wide_div(tl_wide_mul(over_y, tl_wide_sum(y, -(tl_real)k)), tl_widen((tl_real)(k + 1)));
  }
  tl_compose_blocks(cx, c, a, f, top, 0);
  tl_check(cx, c, TL_FN_pow);
}

/* The same for y < 0, not tiny, on a brought to the size of 1, f_k = binomial(y,k) a_0^y/(scale a_0)^k: the single powers above could
 * vanish, or overflow, where their products with the derivatives of a do not. */
static void negative_power_by_series(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real y) {
  tl_real f[MAX_DEGREE + 1] = {TL_LIBM(pow)(a[0], y)}, *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]), a0 = a[0];
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  tl_wide over_y = tl_wide_div(tl_widen(TL_C(1.0)), tl_widen(x[0]));
  for (int k = 1; k <= cx->shape->degree; k++) {
    f[k] = times_power(over_y, a0, y, 0, y);
    over_y = tl_wide_div(tl_wide_mul(over_y, tl_wide_sum(y, -(tl_real)k)), tl_wide_product((tl_real)(k + 1), x[0]));
  }
  tl_compose_blocks(cx, c, x, f, cx->shape->degree, 1);
  tl_check(cx, c, TL_FN_pow);
}

/* The same from the value: f_k = f_(k-1) (y - k + 1)/(k a_0). */
static void power_from_value(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real y, tl_real value) {
  tl_real f[MAX_DEGREE + 1] = {value}, *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]);
  tl_wide term = tl_widen(value);
  int top = 0;
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  for (int k = 1; k <= cx->shape->degree && y != (tl_real)(k - 1); k++) {
    term = tl_wide_div(tl_wide_mul(term, tl_wide_sum(y, (tl_real)(1 - k))), tl_wide_product((tl_real)k, x[0]));
    f[k] = tl_narrow(term);
    top = k;
  }
  tl_compose_blocks(cx, c, x, f, top, 1);
  tl_check(cx, c, TL_FN_pow);
}

/* Near an integer n > 0 coefficients of the power that are not a's own are small like y - n, which the recurrence has from terms that
 * cancel. */
static int is_near_integer(tl_real y) {
  const tl_real near = TL_C(0.375);
  return y > TL_C(0.5) && TL_LIBM(fabs)(y - TL_LIBM(round)(y)) < near;
}

/* A power whose exponent is constant. A value that is too small or too large to start from does not say how large its derivatives are,
 * and the series by single powers serves a_0 = 0 too. */
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
  else if (!is_moderate(value) || !is_moderate(x))
    (x < TL_C(0.0) && is_moderate(x) ? negative_power_by_series : power_by_series)(cx, c, a, x);
  else if (cx->shape->degree <= TL_WIDE_DEGREE || is_near_integer(x))
    power_from_value(cx, c, a, x, value);
  else
    power_by_recurrence(cx, c, a, value, x, TL_C(1.0), TL_FN_pow);
}

/* x^b = x^b_0 exp((b - b_0) log x): f_k = (log x)^k/k! x^b_0. x > 0. */
static void exponential_of_base(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b, tl_real value) {
  tl_real f[MAX_DEGREE + 1] = {value};
  const tl_wide rate = tl_wide_log(tl_widen(x));
  tl_wide power = tl_widen(TL_C(1.0));
  for (int k = 1; k <= cx->shape->degree; k++) {
    power = tl_wide_div(tl_wide_mul(power, rate), tl_widen((tl_real)k));
    f[k] = times_power(power, x, b[0], 0, TL_C(1.0));
  }
  tl_compose_blocks(cx, c, b, f, cx->shape->degree, 0);
  tl_check(cx, c, TL_FN_pow);
}

/* 0^b is 0 around every b > 0; at b = 0 and for x < 0 it exists for single numbers only. */
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b) {
  const tl_real value = TL_LIBM(pow)(x, b[0]);
  if (!tl_accept(cx, c, x, TL_FN_pow) || !tl_accept(cx, c, b[0], TL_FN_pow)) return;
  if (x > TL_C(0.0))
    exponential_of_base(cx, c, x, b, value);
  else if (!TL_ISFINITE(value))
    tl_reject(cx, c, TL_DOMAIN, TL_FN_pow);
  else if (cx->shape->degree == 0 || (x == TL_C(0.0) && b[0] > TL_C(0.0)))
    tl_const(cx, c, value);
  else
    tl_reject(cx, c, TL_SINGULAR, TL_FN_pow);
}

void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n) {
  const tl_real x = (tl_real)n;
  assert((long long)x == n); /* single precision does not hold every int */
  tl_powc(cx, c, a, x);
}

static int is_constant(const tl_shape *s, const tl_real *a) {
  for (int i = 1; i < s->ncoef; i++)
    if (a[i] != TL_C(0.0)) return 0;
  return 1;
}

enum { NPLACE = (TL_WIDE_DEGREE + 1) * (TL_WIDE_DEGREE + 2) / 2 };

/* The coefficients of h^i g^j of (x+h)^(y+g) at their places i + j = n, n(n+1)/2 + j: x^(y-i) times sum_k b_ik e_(j-k),
 *     e_j = (log x)^j/j!,   b_ik of g^k in binomial(y+g, i) = b_(i-1) (y - i + 1 + g)/i.
 * On x brought to the size of 1 and from the value, or by single powers where scale is 0. */
static void power_series(tl_real *f, int degree, tl_real x, tl_real y, tl_real value, tl_real scale) {
  const tl_wide logarithm = tl_wide_log(tl_widen(x)), one = tl_widen(TL_C(1.0));
  tl_wide e[TL_WIDE_DEGREE + 1] = {one}, b[TL_WIDE_DEGREE + 1] = {one}, power = tl_widen(value);
  tl_wide over_y = one; /* binomial(y,i)/y, for a tiny y */
  for (int j = 1; j <= degree; j++) e[j] = tl_wide_div(tl_wide_mul(e[j - 1], logarithm), tl_widen((tl_real)j));
  for (int i = 0; i <= degree; i++) {
    for (int j = 0, n = i; n <= degree; j++, n++) {
      tl_wide sum = tl_wide_mul(b[0], e[j]);
      for (int k = 1; k <= i && k <= j; k++) sum = tl_wide_add(sum, tl_wide_mul(b[k], e[j - k]));
      f[n * (n + 1) / 2 + j] = scale == TL_C(0.0) ? times_power(sum, x, y, i, TL_C(1.0)) : tl_narrow(tl_wide_mul(sum, power));
    }
    if (scale == TL_C(0.0) && i > 0) f[i * (i + 1) / 2] = times_power(over_y, x, y, i, y);
    if (i == degree) return;
    if (i > 0) over_y = tl_wide_div(tl_wide_mul(over_y, tl_wide_sum(y, -(tl_real)i)), tl_widen((tl_real)(i + 1)));
    const tl_wide rest = tl_wide_sum(y, -(tl_real)i), over = tl_wide_div(one, tl_widen((tl_real)(i + 1)));
    b[i + 1] = tl_widen(TL_C(0.0));
    for (int k = i + 1; k > 0; k--) b[k] = tl_wide_mul(tl_wide_add(tl_wide_mul(b[k], rest), b[k - 1]), over);
    b[0] = tl_wide_mul(tl_wide_mul(b[0], rest), over);
    if (scale != TL_C(0.0)) power = tl_wide_div(power, tl_widen(scale * x));
  }
}

/* a^b = a^(b_0) exp((b - b_0) log a): the first factor by the recurrence of a constant exponent, the second from a jet without value,
 * so that powers of b_0 and of log a_0 do not cancel. a_0 > 0. */
static void general_power_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value) {
  const tl_shape *s = cx->shape;
  const tl_real scale = tl_normaliser(a[0]), exponent = b[0];
  tl_real *l = tl_scratch(cx, 1), *h = tl_scratch(cx, 2), *x = tl_scratch(cx, 3), *factor = tl_scratch(cx, 4),
          *base = tl_scratch(cx, 5);
  for (int i = 0; i < s->ncoef; i++) {
    x[i] = scale * a[i];
    h[i] = b[i];
  }
  l[0] = TL_LIBM(log)(a[0]);
  tl_log_blocks(s, l, TL_C(1.0), x);
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

static void general_power(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value) {
  if (cx->shape->degree > TL_WIDE_DEGREE) {
    general_power_by_recurrence(cx, c, a, b, value);
    return;
  }
  tl_real f[NPLACE], *x = tl_scratch(cx, 2);
  const int moderate = is_moderate(value) && (b[0] == TL_C(0.0) || is_moderate(b[0]));
  const tl_real scale = moderate ? tl_normaliser(a[0]) : TL_C(1.0);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  power_series(f, cx->shape->degree, a[0], b[0], value, moderate ? scale : TL_C(0.0));
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
    general_power(cx, c, a, b, value);
  else if (a[0] == TL_C(0.0) && b[0] > (tl_real)cx->shape->degree)
    tl_row_zero(cx->shape->ncoef, c);
  else
    tl_reject(cx, c, TL_ISFINITE(value) ? TL_SINGULAR : TL_DOMAIN, TL_FN_pow);
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
