/* Arithmetic of jets: identities that hold exactly for integers, aliasing, and the failures of arithmetic. */
#include "close_real.h"
#include "functions.h"
#include "random.h"
#include "reference_jet.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tl_spec SPECS[] = {
    {0, 1, 0}, {0, 1, 4}, {5, 0, 0}, {0, 5, 1}, {0, 4, 2}, {0, 3, 3}, {0, 2, 6}, {1, 4, 1}, {1, 4, 2}, {2, 3, 1}, {2, 2, 4}, {3, 2, 3},
};
enum { NSPEC = sizeof SPECS / sizeof *SPECS, NJET = 8 };

/* So small that sums of their products in the shapes above are exact. */
enum { LARGEST = TL_MANT_DIG < 53 ? 1 : 9 };

static void draw_integers(rng *r, tl_real *a, int n) {
  for (int i = 0; i < n; i++) a[i] = (tl_real)(rng_below(r, 2 * LARGEST + 1) - LARGEST);
}

static void for_each_shape(void (*check)(tl_ctx *cx, tl_real *jet[NJET], rng *r)) {
  for (int i = 0; i < NSPEC; i++) {
    jet_space space;
    jet_space_init(&space, SPECS[i], NJET);
    rng r = {(uint64_t)i};
    tl_real *jet[NJET];
    for (int j = 0; j < NJET; j++) jet[j] = tl_push(&space.cx, 1);
    for (int j = 0; j < NJET; j++) draw_integers(&r, jet[j], space.shape.ncoef);
    check(&space.cx, jet, &r);
    assert_int_equal(space.cx.status.bits, TL_OK);
    jet_space_free(&space);
  }
}

static void check_product(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  (void)r;
  const tl_shape *s = cx->shape;
  static ref_shape plain;
  ref_shape_init(&plain, s->curve, s->nvar, s->order);
  tl_real *expected = jet[3];
  for (int i = 0; i < s->ncoef; i++) expected[i] = 0.0;
  for (int i = 0; i < s->ncoef; i++)
    for (int j = 0; j < s->ncoef; j++) {
      int sum[REF_MAX_VAR + 1] = {0};
      for (int v = 0; v <= s->nvar; v++) sum[v] = plain.exponent[i][v] + plain.exponent[j][v];
      const int at = ref_find(&plain, sum);
      if (at >= 0) expected[at] += jet[0][i] * jet[1][j];
    }
  tl_mul(cx, jet[2], jet[0], jet[1]);
  assert_jet_same(jet[2], expected, s->ncoef);
  for (int i = 0; i < s->ncoef; i++) expected[i] += jet[4][i];
  tl_muladd(cx, jet[4], jet[0], jet[1]);
  assert_jet_same(jet[4], expected, s->ncoef);
}
static void products_agree_with_added_exponents(void **state) {
  (void)state;
  for_each_shape(check_product);
}

static void check_ring(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  (void)r;
  const int n = cx->shape->ncoef;
  tl_real *a = jet[0], *b = jet[1], *c = jet[2], *left = jet[3], *right = jet[4], *t = jet[5];
  tl_mul(cx, left, a, b); /* a b = b a */
  tl_mul(cx, right, b, a);
  assert_jet_same(left, right, n);
  tl_mul(cx, left, left, c); /* (a b) c = a (b c) */
  tl_mul(cx, right, b, c);
  tl_mul(cx, right, a, right);
  assert_jet_same(left, right, n);
  tl_add(cx, left, a, b); /* (a+b) c = a c + b c */
  tl_mul(cx, left, left, c);
  tl_mul(cx, right, a, c);
  tl_muladd(cx, right, b, c);
  assert_jet_same(left, right, n);
  tl_sub(cx, left, a, b); /* (a-b) + b = a */
  tl_add(cx, left, left, b);
  assert_jet_same(left, a, n);
  tl_neg(cx, left, a); /* -(-a) = 0 - (-a) */
  tl_rsub(cx, left, 0.0, left);
  assert_jet_same(left, a, n);
  tl_scale(cx, left, a, 3.0); /* 3a - 2a = a */
  tl_axpy(cx, left, -2.0, a);
  assert_jet_same(left, a, n);
  tl_shift(cx, left, a, 5.0); /* a + 5 */
  tl_const(cx, t, 5.0);
  tl_add(cx, right, a, t);
  assert_jet_same(left, right, n);
  tl_divc(cx, left, left, 4.0);
  tl_scale(cx, right, right, 0.25);
  assert_jet_same(left, right, n);
  tl_copy(cx, left, a);
  assert_jet_same(left, a, n);
}
static void integer_jets_are_a_ring(void **state) {
  (void)state;
  for_each_shape(check_ring);
}

/* A unit divisor leaves every quotient of integers an integer. */
static void check_quotient(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  (void)r;
  const int n = cx->shape->ncoef;
  tl_real *a = jet[0], *b = jet[1], *q = jet[2], *back = jet[3];
  b[0] = -1.0;
  tl_div(cx, q, a, b);
  tl_mul(cx, back, q, b);
  assert_jet_same(back, a, n);
  tl_rdiv(cx, q, 3.0, b);
  tl_mul(cx, back, q, b);
  tl_const(cx, a, 3.0);
  assert_jet_same(back, a, n);
}
static void quotients_times_divisors_are_exact_for_unit_values(void **state) {
  (void)state;
  for_each_shape(check_quotient);
}

/* At the ends of the range of numbers a quotient of ordinary size is found by scaling: the same bits as for scaled operands. */
static void quotients_do_not_depend_on_a_power_of_two(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, (tl_spec){1, 2, 2}, 4);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *expected = tl_push(cx, 1), *q = tl_push(cx, 1);
  rng r = {5};
  for (int i = 0; i < space.shape.ncoef; i++) a[i] = (tl_real)(rng_uniform(&r, 1.0, 1.9) * (i % 2 ? -1.0 : 1.0));
  for (int i = 0; i < space.shape.ncoef; i++) b[i] = (tl_real)rng_uniform(&r, 1.0, 1.9);
  tl_div(cx, expected, a, b);
  tl_scale(cx, a, a, real_power_of_two(TL_MAX_EXP - 1));
  tl_scale(cx, b, b, real_power_of_two(TL_MAX_EXP - 1));
  tl_div(cx, q, a, b);
  assert_jet_same(q, expected, space.shape.ncoef);
  assert_int_equal(cx->status.bits, TL_OK);
  jet_space_free(&space);
}

/* Integers that the type holds are constants, others are reported. */
static void integers_are_exact_or_reported(void **state) {
  (void)state;
  const long long limit = (long long)1 << (TL_MANT_DIG < 62 ? TL_MANT_DIG : 62);
  jet_space space;
  jet_space_init(&space, tl_jacobian(1), 1);
  tl_real *c = tl_push(&space.cx, 1);
  const long long ends[] = {-limit, limit};
  for (int i = 0; i < 2; i++) {
    tl_integer(&space.cx, c, ends[i]);
    assert_int_equal(space.cx.status.bits, TL_OK);
    assert_real_same(c[0], (tl_real)ends[i]);
    assert_real_same(c[1], 0);
    if (TL_MANT_DIG > 62) continue;
    tl_integer(&space.cx, c, ends[i] + (i == 0 ? -1 : 1));
    assert_int_equal(space.cx.status.bits, TL_NONFINITE);
    tl_ctx_clear(&space.cx);
  }
  jet_space_free(&space);
}

/* Moved jets keep what is no number, and nothing is reported. */
static void jets_are_moved_as_they_are(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_jacobian(2), 4);
  tl_real *from = tl_push(&space.cx, 2), *to = tl_push(&space.cx, 2);
  tl_const(&space.cx, from + 3, 5);
  tl_move(&space.cx, to, from, 2);
  assert_true(isnan((double)to[0]) && isnan((double)to[2]));
  assert_real_same(to[3], 5);
  assert_real_same(to[5], 0);
  assert_int_equal(space.cx.status.bits, TL_OK);
  jet_space_free(&space);
}

/* Euler: a product of sums of four squares is a sum of four squares, an identity of degree 4 in 8 variables. */
static void euler_four_squares_are_exact_in_eight_variables(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_complete(8, 4), 12);
  tl_ctx *cx = &space.cx;
  tl_real *x[8];
  for (int i = 0; i < 8; i++) {
    x[i] = tl_push(cx, 1);
    tl_seed(cx, x[i], (tl_real)(i * i - 11), i);
  }
  tl_real *left = tl_push(cx, 1), *right = tl_push(cx, 1), *sum = tl_push(cx, 1), *t = tl_push(cx, 1);
  tl_const(cx, left, 0.0);
  tl_const(cx, sum, 0.0);
  for (int i = 0; i < 4; i++) {
    tl_muladd(cx, left, x[i], x[i]);
    tl_muladd(cx, sum, x[4 + i], x[4 + i]);
  }
  tl_mul(cx, left, left, sum);
  const int sign[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}};
  const int partner[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 3, 0, 1}, {3, 2, 1, 0}};
  tl_const(cx, right, 0.0);
  for (int row = 0; row < 4; row++) {
    tl_const(cx, sum, 0.0);
    for (int i = 0; i < 4; i++) {
      tl_mul(cx, t, x[i], x[4 + partner[row][i]]);
      tl_axpy(cx, sum, (tl_real)sign[row][i], t);
    }
    tl_muladd(cx, right, sum, sum);
  }
  assert_jet_same(left, right, space.shape.ncoef);
  assert_real_same(tl_coef(&space.shape, left, 0, (int[]){2, 0, 0, 0, 0, 0, 0, 2}), 1.0);
  jet_space_free(&space);
}

/* Fateman: (1 + x + y + z + t)^n, coefficient n!/(i! j! k! l! (n-i-j-k-l)!). */
static void fateman_power_is_exact(void **state) {
  (void)state;
  enum { SQUARINGS = TL_MANT_DIG < 53 ? 3 : 4, POWER = 1 << SQUARINGS };
  jet_space space;
  jet_space_init(&space, tl_complete(4, POWER), 1);
  tl_ctx *cx = &space.cx;
  tl_real *p = tl_push(cx, 1);
  tl_const(cx, p, 1.0);
  for (int i = 0; i < 4; i++) p[1 + i] = 1.0;
  for (int i = 0; i < SQUARINGS; i++) tl_mul(cx, p, p, p);
  int64_t factorial[POWER + 1] = {1};
  for (int i = 1; i <= POWER; i++) factorial[i] = i * factorial[i - 1];
  for (int at = 0; at < space.shape.ncoef; at++) {
    int k, alpha[4];
    tl_monomial(&space.shape, at, &k, alpha);
    const int rest = POWER - alpha[0] - alpha[1] - alpha[2] - alpha[3];
    const int64_t c =
        factorial[POWER] / factorial[alpha[0]] / factorial[alpha[1]] / factorial[alpha[2]] / factorial[alpha[3]] / factorial[rest];
    assert_real_same(p[at], (tl_real)c);
  }
  jet_space_free(&space);
}

/* Composition with a polynomial with integer coefficients is the polynomial. */
static void check_composition(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  const int n = cx->shape->ncoef, degree = cx->shape->degree;
  tl_real *a = jet[0], *sum = jet[1], *power = jet[2], *c = jet[3], *h = jet[4], f[TL_MAX_CURVE + TL_MAX_ORDER + 1];
  draw_integers(r, f, degree + 1);
  tl_shift(cx, h, a, -a[0]);
  tl_const(cx, sum, 0.0);
  tl_const(cx, power, 1.0);
  for (int k = 0; k <= degree; k++) {
    tl_axpy(cx, sum, f[k], power);
    tl_mul(cx, power, power, h);
  }
  tl_compose(cx, c, a, f);
  assert_jet_same(c, sum, n);
  tl_compose(cx, a, a, f);
  assert_jet_same(a, sum, n);
}
static void composition_with_a_polynomial_is_exact(void **state) {
  (void)state;
  for_each_shape(check_composition);
}

/* x^4 y^2 at (2,3) along s, by hand: coefficient and derivative. */
static void coefficients_and_derivatives_are_found_by_multi_index(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, (tl_spec){.curve = 2, .nvar = 2, .order = 3}, 3);
  tl_ctx *cx = &space.cx;
  tl_real *x = tl_push(cx, 1), *y = tl_push(cx, 1), *c = tl_push(cx, 1);
  tl_seed(cx, x, 2.0, 0);
  tl_seed(cx, y, 3.0, 1);
  x[1] = 1.0; /* x = 2 + s + t_1 */
  tl_mul(cx, c, x, x);
  tl_mul(cx, c, c, c);
  tl_mul(cx, c, c, y);
  tl_mul(cx, c, c, y);
  /* d^2/ds^2 d^2/dt1^2 d/dt2 = 24 * 2y = 144; its coefficient 144/(2! 2!) */
  assert_real_same(tl_deriv(&space.shape, c, 2, (int[]){2, 1}), 144.0);
  assert_real_same(tl_coef(&space.shape, c, 2, (int[]){2, 1}), 36.0);
  assert_real_same(tl_deriv(&space.shape, c, 0, NULL), 144.0); /* the value */
  assert_real_same(tl_coef(&space.shape, c, 3, (int[]){0, 0}), 0.0);
  assert_real_same(tl_deriv(&space.shape, c, 0, (int[]){4, 0}), 0.0);
  jet_space_free(&space);
}

typedef void binary(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);

/* c = a, c = b, a = b and all three alike give the bits of separate arrays. */
static void assert_aliasing(tl_ctx *cx, binary *f, const tl_real *a, const tl_real *b, tl_real *expected, tl_real *c) {
  const int n = cx->shape->ncoef;
  f(cx, expected, a, b);
  tl_copy(cx, c, a);
  f(cx, c, c, b);
  assert_jet_same(c, expected, n);
  tl_copy(cx, c, b);
  f(cx, c, a, c);
  assert_jet_same(c, expected, n);
  tl_copy(cx, c, a);
  f(cx, expected, a, c);
  f(cx, c, c, c);
  assert_jet_same(c, expected, n);
  f(cx, c, a, a);
  assert_jet_same(c, expected, n);
}

static void fma_of_product(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { tl_fma(cx, c, a, b, b); }
static void fma_of_square(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { tl_fma(cx, c, b, b, a); }
static void quotient_of_value(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  (void)b;
  tl_rdiv(cx, c, TL_C(3.7), a);
}
static void difference_from_value(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  (void)b;
  tl_rsub(cx, c, TL_C(3.7), a);
}

static void check_aliasing(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  binary *const functions[] = {tl_add, tl_sub, tl_mul, tl_div, fma_of_product, fma_of_square};
  for (int k = 0; k < 4; k++) /* fractions, so that rounding would show a change of order */
    for (int i = 0; i < cx->shape->ncoef; i++) jet[k][i] = (tl_real)rng_uniform(r, 0.5, 1.5);
  for (size_t i = 0; i < sizeof functions / sizeof *functions; i++) assert_aliasing(cx, functions[i], jet[0], jet[1], jet[2], jet[3]);
  binary *const unary[] = {quotient_of_value, difference_from_value};
  for (size_t i = 0; i < 2; i++) {
    unary[i](cx, jet[2], jet[0], NULL);
    tl_copy(cx, jet[3], jet[0]);
    unary[i](cx, jet[3], jet[3], NULL);
    assert_jet_same(jet[3], jet[2], cx->shape->ncoef);
  }
}
static void aliased_operands_give_the_same_bits(void **state) {
  (void)state;
  for_each_shape(check_aliasing);
}

static void check_fma(tl_ctx *cx, tl_real *jet[NJET], rng *r) {
  (void)r;
  tl_mul(cx, jet[3], jet[0], jet[1]);
  tl_add(cx, jet[3], jet[3], jet[2]);
  tl_fma(cx, jet[4], jet[0], jet[1], jet[2]);
  assert_jet_same(jet[4], jet[3], cx->shape->ncoef);
  const tl_real small = real_power_of_two(-TL_MANT_DIG / 2 - 4);
  jet[0][0] = TL_C(1.0) + small; /* the square's last bit is lost by a product, not by fma */
  tl_const(cx, jet[2], -TL_C(1.0) - TL_C(2.0) * small);
  tl_fma(cx, jet[4], jet[0], jet[0], jet[2]);
  assert_real_same(jet[4][0], small * small);
}
static void fma_rounds_its_value_once(void **state) {
  (void)state;
  for_each_shape(check_fma);
}

static void failures_of_arithmetic_name_the_operation(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_jacobian(1), 3);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  const tl_real huge = TL_C(0.75) * TL_MAX, infinite = (tl_real)INFINITY, undefined = (tl_real)NAN;
#define EXPECT(call, bit, fn)                                                                                                          \
  a[0] = huge, a[1] = 1.0, b[0] = 0.0, b[1] = huge;                                                                                    \
  tl_ctx_clear(cx);                                                                                                                    \
  call;                                                                                                                                \
  assert_int_equal(cx->status.bits, bit);                                                                                              \
  assert_int_equal(cx->status.function, fn)
  EXPECT(tl_add(cx, c, a, a), TL_NONFINITE, TL_FN_add);
  EXPECT(tl_add(cx, c, b, b), TL_NONFINITE, TL_FN_add);
  EXPECT(tl_shift(cx, c, a, huge), TL_NONFINITE, TL_FN_add);
  EXPECT(tl_rsub(cx, c, -huge, a), TL_NONFINITE, TL_FN_sub);
  EXPECT(tl_neg(cx, c, a); tl_sub(cx, c, c, a), TL_NONFINITE, TL_FN_sub);
  EXPECT(tl_scale(cx, c, b, 2.0), TL_NONFINITE, TL_FN_scale);
  EXPECT(tl_copy(cx, c, a); tl_axpy(cx, c, 1.0, a), TL_NONFINITE, TL_FN_scale);
  EXPECT(tl_mul(cx, c, a, b), TL_NONFINITE, TL_FN_mul);
  EXPECT(tl_copy(cx, c, a); tl_muladd(cx, c, a, a), TL_NONFINITE, TL_FN_mul);
  EXPECT(tl_fma(cx, c, a, b, a), TL_NONFINITE, TL_FN_fma);
  EXPECT(tl_div(cx, c, a, b), TL_DOMAIN, TL_FN_div);
  EXPECT(tl_rdiv(cx, c, 1.0, b), TL_DOMAIN, TL_FN_div);
  EXPECT(tl_divc(cx, c, a, 0.0), TL_DOMAIN, TL_FN_div);
  EXPECT(tl_divc(cx, c, a, 0.5), TL_NONFINITE, TL_FN_div);
  EXPECT(tl_divc(cx, c, a, infinite), TL_NONFINITE, TL_FN_div);
  EXPECT(tl_const(cx, c, infinite), TL_NONFINITE, TL_FN_seed);
  EXPECT(tl_seed(cx, c, undefined, 0), TL_NONFINITE, TL_FN_seed);
  EXPECT(a[1] = undefined; tl_copy(cx, c, a), TL_NONFINITE, TL_FN_copy);
  EXPECT(tl_compose(cx, c, a, (tl_real[]){1.0, infinite}), TL_NONFINITE, TL_FN_compose);
#undef EXPECT
  jet_space_free(&space);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(products_agree_with_added_exponents),
      cmocka_unit_test(integer_jets_are_a_ring),
      cmocka_unit_test(quotients_times_divisors_are_exact_for_unit_values),
      cmocka_unit_test(quotients_do_not_depend_on_a_power_of_two),
      cmocka_unit_test(integers_are_exact_or_reported),
      cmocka_unit_test(jets_are_moved_as_they_are),
      cmocka_unit_test(euler_four_squares_are_exact_in_eight_variables),
      cmocka_unit_test(fateman_power_is_exact),
      cmocka_unit_test(composition_with_a_polynomial_is_exact),
      cmocka_unit_test(coefficients_and_derivatives_are_found_by_multi_index),
      cmocka_unit_test(aliased_operands_give_the_same_bits),
      cmocka_unit_test(fma_rounds_its_value_once),
      cmocka_unit_test(failures_of_arithmetic_name_the_operation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
