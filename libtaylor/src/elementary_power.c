/* Roots, powers with a constant exponent, the length of a vector, and fma. */
#include "block.h"
#include "taylor/elementary.h"

/* c = value (a/a_0)^(p/q): the power recurrence on a brought to the size of 1, since only ratios of its coefficients enter. a_0 not 0.
 */
static void power_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real value, tl_real p, tl_real q, tl_fn function) {
  tl_real *x = tl_scratch(cx, 0);
  const tl_real scale = tl_normaliser(a[0]);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = scale * a[i];
  c[0] = value;
  tl_power_blocks(cx->shape, c, p, q, x);
  tl_check(cx, c, function);
}

/* r^2 = a:  2 r_0 r_B = a_B - sum_{B1,B2>0} r_B1 r_B2. At both ends of the range of numbers the sum overflows or
 * loses digits before the division brings it back; there the power recurrence on a scaled jet serves. */
static void sqrt_blocks(const tl_shape *s, tl_real *c, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    for (int i = 0; i < b.n; i++) c[b.at + i] = a[b.at + i];
    tl_add_interior(s, b, c + b.at, (tl_factor){.z = -TL_C(1.0)}, c, c);
    tl_row_divide(b.n, c + b.at, TL_C(2.0) * c[0]);
  }
}

void tl_sqrt(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real value = TL_LIBM(sqrt)(a[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_sqrt)) return;
  if (a[0] < TL_C(0.0) || (a[0] == TL_C(0.0) && cx->shape->degree > 0)) {
    tl_reject(cx, c, a[0] < TL_C(0.0) ? TL_DOMAIN : TL_SINGULAR, TL_FN_sqrt);
  } else if (a[0] != TL_C(0.0) && (a[0] > TL_MAX * TL_EPSILON || a[0] < TL_MIN / TL_EPSILON)) {
    power_by_recurrence(cx, c, a, value, TL_C(1.0), TL_C(2.0), TL_FN_sqrt);
  } else {
    const tl_real *x = tl_unaliased(cx, a, c, 0);
    c[0] = value;
    sqrt_blocks(cx->shape, c, x);
    tl_check(cx, c, TL_FN_sqrt);
  }
}

void tl_cbrt(tl_ctx *cx, tl_real *c, const tl_real *a) {
  const tl_real value = TL_LIBM(cbrt)(a[0]);
  if (!tl_accept(cx, c, a[0], TL_FN_cbrt)) return;
  if (a[0] != TL_C(0.0))
    power_by_recurrence(cx, c, a, value, TL_C(1.0), TL_C(3.0), TL_FN_cbrt);
  else if (cx->shape->degree > 0)
    tl_reject(cx, c, TL_SINGULAR, TL_FN_cbrt);
  else
    c[0] = value;
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

/* The length r and the angle of (a,b) with its unit vector (u,v) = (a,b)/r carried along:
 *     E r = u E a + v E b,    r E angle = u E b - v E a,    E u = -v E angle,    E v = u E angle.
 * Unlike r = sqrt(a^2 + b^2) this loses no digits where one side is much longer than the other. a, b scaled to about 1. */
void tl_hypot(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_shape *s = cx->shape;
  if (!tl_accept(cx, c, a[0], TL_FN_hypot) || !tl_accept(cx, c, b[0], TL_FN_hypot)) return;
  const tl_real value = TL_LIBM(hypot)(a[0], b[0]), scale = tl_normaliser(TL_LIBM(fmax)(TL_LIBM(fabs)(a[0]), TL_LIBM(fabs)(b[0])));
  if (value == TL_C(0.0) && s->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, TL_FN_hypot);
    return;
  }
  tl_real *x = tl_scratch(cx, 0), *y = tl_scratch(cx, 1), *u = tl_scratch(cx, 2), *v = tl_scratch(cx, 3), *angle = tl_scratch(cx, 4);
  for (int i = 0; i < s->ncoef; i++) {
    x[i] = scale * a[i];
    y[i] = scale * b[i];
  }
  const tl_real r0 = TL_LIBM(hypot)(x[0], y[0]);
  c[0] = r0;
  u[0] = x[0] / r0;
  v[0] = y[0] / r0;
  angle[0] = TL_C(0.0); /* only its derivatives are used */
  const tl_factor first = {.u = TL_C(1.0)}, minus_first = {.u = -TL_C(1.0)};
  for (tl_block B = tl_first_block(s); B.n; B = tl_next_block(s, B)) {
    const int n = B.n, at = B.at;
    const tl_real w = (tl_real)B.weight;
    tl_row_zero(n, c + at);
    tl_add_interior(s, B, c + at, first, x, u);
    tl_add_interior(s, B, c + at, first, y, v);
    tl_row_divide(n, c + at, w);
    tl_row_add(n, c + at, u[0], x + at);
    tl_row_add(n, c + at, v[0], y + at);

    tl_row_combine(n, angle + at, w * u[0], y + at, -w * v[0], x + at);
    tl_add_interior(s, B, angle + at, first, y, u);
    tl_add_interior(s, B, angle + at, minus_first, x, v);
    tl_add_interior(s, B, angle + at, minus_first, angle, c);
    tl_row_divide(n, angle + at, w * r0);

    tl_row_zero(n, u + at);
    tl_add_interior(s, B, u + at, minus_first, angle, v);
    tl_row_divide(n, u + at, w);
    tl_row_add(n, u + at, -v[0], angle + at);

    tl_row_zero(n, v + at);
    tl_add_interior(s, B, v + at, first, angle, u);
    tl_row_divide(n, v + at, w);
    tl_row_add(n, v + at, u[0], angle + at);
  }
  for (int i = 1; i < s->ncoef; i++) c[i] /= scale;
  c[0] = value;
  tl_check(cx, c, TL_FN_hypot);
}

void tl_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *d) {
  const tl_real value = TL_LIBM(fma)(a[0], b[0], d[0]);
  const tl_real *addend = tl_unaliased(cx, d, c, 0);
  tl_product_blocks(cx->shape, c, a, b);
  for (int i = 1; i < cx->shape->ncoef; i++) c[i] += addend[i];
  c[0] = value;
  tl_check(cx, c, TL_FN_fma);
}
