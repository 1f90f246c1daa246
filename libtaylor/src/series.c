/* Arithmetic of jets. */
#include "block.h"

#include <string.h>

static void set_constant(tl_ctx *cx, tl_real *c, tl_real x) {
  tl_row_zero(cx->shape->ncoef, c);
  c[0] = x;
}

void tl_const(tl_ctx *cx, tl_real *c, tl_real x) {
  set_constant(cx, c, x);
  tl_check(cx, c, TL_FN_seed);
}

void tl_integer(tl_ctx *cx, tl_real *c, long long n) {
  const int exact_bits = TL_MANT_DIG < 62 ? TL_MANT_DIG : 62;
  const long long limit = (long long)1 << exact_bits;
  tl_const(cx, c, TL_FROM(n));
  if (TL_MANT_DIG < 63 && (n > limit || n < -limit)) tl_reject(cx, c, TL_NONFINITE, TL_FN_seed);
}

void tl_seed(tl_ctx *cx, tl_real *c, tl_real x, int i) {
  assert(i >= 0 && i < cx->shape->nvar);
  set_constant(cx, c, x);
  if (cx->shape->order > 0) c[cx->shape->start[1] + i] = TL_C(1.0);
  tl_check(cx, c, TL_FN_seed);
}

void tl_move(tl_ctx *cx, tl_real *c, const tl_real *a, ptrdiff_t n) {
  for (ptrdiff_t i = 0; i < n * cx->shape->ncoef; i++) c[i] = a[i];
}

void tl_copy(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (c != a) memcpy(c, a, (size_t)cx->shape->ncoef * sizeof *c);
  tl_check(cx, c, TL_FN_copy);
}

void tl_add(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = a[i] + b[i];
  tl_check(cx, c, TL_FN_add);
}

void tl_sub(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = a[i] - b[i];
  tl_check(cx, c, TL_FN_sub);
}

void tl_neg(tl_ctx *cx, tl_real *c, const tl_real *a) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = -a[i];
  tl_check(cx, c, TL_FN_sub);
}

void tl_scale(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = x * a[i];
  tl_check(cx, c, TL_FN_scale);
}

void tl_shift(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  if (c != a) memcpy(c, a, (size_t)cx->shape->ncoef * sizeof *c);
  c[0] += x;
  tl_check(cx, c, TL_FN_add);
}

void tl_rsub(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a) {
  const tl_real value = x - a[0];
  for (int i = 1; i < cx->shape->ncoef; i++) c[i] = -a[i];
  c[0] = value;
  tl_check(cx, c, TL_FN_sub);
}

void tl_axpy(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a) {
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] += x * a[i];
  tl_check(cx, c, TL_FN_scale);
}

void tl_mul(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_real value = a[0] * b[0];
  tl_product_blocks(cx->shape, c, a, b);
  c[0] = value;
  tl_check(cx, c, TL_FN_mul);
}

void tl_muladd(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_shape *s = cx->shape;
  assert(c != a && c != b);
  c[0] += a[0] * b[0];
  for (tl_block B = tl_first_block(s); B.n; B = tl_next_block(s, B)) {
    tl_row_add(B.n, c + B.at, a[0], b + B.at);
    tl_row_add(B.n, c + B.at, b[0], a + B.at);
    tl_add_interior(s, B, c + B.at, (tl_factor){.z = TL_C(1.0)}, a, b);
  }
  tl_check(cx, c, TL_FN_mul);
}

#ifndef TL_REAL_LANES /* lanes/elementary.c has it for them */
/* So far from 1 that products of a few such numbers may leave the range of numbers, or lose digits, although the quotient does not. */
static int is_extreme(tl_real x) {
  const tl_real far = TL_C(1.0) / (TL_EPSILON * TL_EPSILON), size = TL_LIBM(fabs)(x);
  return size > far || (size < TL_C(1.0) / far && size > TL_C(0.0));
}

static tl_real largest_derivative(const tl_shape *s, const tl_real *a) {
  tl_real largest = TL_C(0.0);
  for (int i = 1; i < s->ncoef; i++) largest = TL_LIBM(fmax)(largest, TL_LIBM(fabs)(a[i]));
  return largest;
}

/* By how much the dividend is raised where the quotient, about as large as the divisor is small, would first be computed below the
 * normal numbers: to about 1 where no coefficient grows by the division, otherwise until a subnormal value has its digits. Beside a
 * large divisor a dividend near the largest number is lowered, as the recurrence exceeds it on the way. */
static tl_real lift_of(const tl_shape *s, const tl_real *a, tl_real scale, tl_real growth) {
  const tl_real largest = TL_LIBM(fmax)(TL_LIBM(fabs)(a[0]), largest_derivative(s, a));
  if (scale <= TL_C(1.0)) return largest > TL_MAX / TL_HEADROOM ? TL_C(1.0) / TL_HEADROOM : TL_C(1.0);
  if (growth <= TL_C(2.0)) return TL_LIBM(fmax)(tl_normaliser(largest), TL_C(1.0));
  return TL_LIBM(fabs)(a[0]) < TL_MIN / TL_EPSILON ? TL_C(2.0) / TL_EPSILON : TL_C(1.0);
}

/* c = a/b with the divisor brought to about 1 by a power of two. */
static void divide_scaled(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const int n = cx->shape->ncoef;
  tl_real *x = tl_scratch(cx, 0), *y = tl_scratch(cx, 1);
  const tl_real scale = tl_normaliser(b[0]), value = a[0] / b[0];
  const tl_real lift = lift_of(cx->shape, a, scale, scale * largest_derivative(cx->shape, b));
  for (int i = 0; i < n; i++) {
    x[i] = lift * a[i];
    y[i] = scale * b[i];
  }
  c[0] = x[0] / y[0];
  tl_quotient_blocks(cx->shape, c, x, y);
  tl_row_scale(n, c, scale / lift);
  c[0] = value;
}

void tl_div(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  if (!tl_accept(cx, c, a[0], TL_FN_div) || !tl_accept(cx, c, b[0], TL_FN_div)) return;
  if (b[0] == TL_C(0.0)) {
    tl_reject(cx, c, TL_DOMAIN, TL_FN_div);
    return;
  }
  if (is_extreme(a[0]) || is_extreme(b[0])) {
    divide_scaled(cx, c, a, b);
  } else {
    const tl_real *divisor = tl_unaliased(cx, b, c, 0);
    c[0] = a[0] / divisor[0];
    tl_quotient_blocks(cx->shape, c, b == a ? divisor : a, divisor);
  }
  tl_check(cx, c, TL_FN_div);
}

void tl_rdiv(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b) {
  if (!tl_accept(cx, c, x, TL_FN_div) || !tl_accept(cx, c, b[0], TL_FN_div)) return;
  if (b[0] == TL_C(0.0)) {
    tl_reject(cx, c, TL_DOMAIN, TL_FN_div);
    return;
  }
  const tl_real *divisor = tl_unaliased(cx, b, c, 0);
  set_constant(cx, c, x);
  c[0] = x / divisor[0];
  tl_quotient_blocks(cx->shape, c, c, divisor);
  tl_check(cx, c, TL_FN_div);
}

void tl_divc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x) {
  if (!tl_accept(cx, c, x, TL_FN_div)) return;
  if (x == TL_C(0.0)) {
    tl_reject(cx, c, TL_DOMAIN, TL_FN_div);
    return;
  }
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = a[i] / x;
  tl_check(cx, c, TL_FN_div);
}

#endif

void tl_compose(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *f) {
  if (!tl_accept(cx, c, a[0], TL_FN_compose)) return;
  tl_compose_blocks(cx, c, a, f, cx->shape->degree, 0);
  tl_check(cx, c, TL_FN_compose);
}

tl_real tl_coef(const tl_shape *s, const tl_real *a, int k, const int *alpha) {
  const int at = tl_index(s, k, alpha);
  return at < 0 ? TL_C(0.0) : a[at];
}

static tl_real factorial(int n) {
  tl_real f = TL_C(1.0);
  for (int i = 2; i <= n; i++) f *= TL_FROM(i);
  return f;
}

tl_real tl_deriv(const tl_shape *s, const tl_real *a, int k, const int *alpha) {
  const int at = tl_index(s, k, alpha);
  if (at < 0) return TL_C(0.0);
  tl_real scale = factorial(k);
  for (int i = 0; alpha && i < s->nvar; i++) scale *= factorial(alpha[i]);
  return a[at] * scale;
}
