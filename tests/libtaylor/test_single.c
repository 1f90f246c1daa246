/* The same sources in single precision: values and derivatives of closed forms, and a failure. */
#include "close.h"
#include "taylor/taylor.h"

#include <math.h>
#include <stdlib.h>

_Static_assert(sizeof(tl_real) == sizeof(float), "this test is for the build in single precision");

static const double ROOT_PI = 1.77245385090551602730, PSI_HALF = -1.96351002602142347944, HALF_TRIGAMMA_HALF = 2.46740110027233965471;

/* A few roundings each: 8 units of 2^-24. */
static const double TOLERANCE = 8 * 0x1p-24;

typedef struct closed_form {
  void (*f)(tl_ctx *cx, tl_real *c, const tl_real *a);
  double value, first, second; /* f, f', f''/2 at 0.5, acosh at 1.5 */
} closed_form;

static void derivatives_are_right_to_single_precision(void **state) {
  (void)state;
  const double s = sin(0.5), c = cos(0.5), e = exp(0.5), t = tan(0.5), h = tanh(0.5), q = sqrt(0.75), sh = sinh(0.5), ch = cosh(0.5);
  const double gauss = 2.0 / sqrt(3.14159265358979323846) * exp(-0.25), d = sqrt(1.25), r = cbrt(0.5);
  const closed_form forms[] = {
      {tl_sqrt, sqrt(0.5), 0.5 / sqrt(0.5), -0.125 / (0.5 * sqrt(0.5))},
      {tl_cbrt, r, r / 1.5, -r / 2.25},
      {tl_exp, e, e, e / 2},
      {tl_expm1, expm1(0.5), e, e / 2},
      {tl_exp2, sqrt(2.0), sqrt(2.0) * log(2.0), sqrt(2.0) * log(2.0) * log(2.0) / 2},
      {tl_log, log(0.5), 2, -2},
      {tl_log1p, log(1.5), 1 / 1.5, -0.5 / 2.25},
      {tl_log2, -1, 2 / log(2.0), -2 / log(2.0)},
      {tl_log10, log10(0.5), 2 / log(10.0), -2 / log(10.0)},
      {tl_sin, s, c, -s / 2},
      {tl_cos, c, -s, -c / 2},
      {tl_tan, t, 1 + t * t, t * (1 + t * t)},
      {tl_asin, asin(0.5), 1 / q, 0.25 / (0.75 * q)},
      {tl_acos, acos(0.5), -1 / q, -0.25 / (0.75 * q)},
      {tl_atan, atan(0.5), 0.8, -0.5 * 0.64},
      {tl_sinh, sh, ch, sh / 2},
      {tl_cosh, ch, sh, ch / 2},
      {tl_tanh, h, 1 - h * h, -h * (1 - h * h)},
      {tl_asinh, asinh(0.5), 1 / d, -0.25 / (1.25 * d)},
      {tl_acosh, acosh(1.5), 1 / d, -0.75 / (1.25 * d)},
      {tl_atanh, atanh(0.5), 1 / 0.75, 0.5 / 0.5625},
      {tl_erf, erf(0.5), gauss, -0.5 * gauss},
      {tl_erfc, erfc(0.5), -gauss, 0.5 * gauss},
      {tl_lgamma, lgamma(0.5), PSI_HALF, HALF_TRIGAMMA_HALF},
      {tl_tgamma, ROOT_PI, ROOT_PI * PSI_HALF, ROOT_PI * (HALF_TRIGAMMA_HALF + 0.5 * PSI_HALF * PSI_HALF)},
      {tl_fabs, 0.5, 1, 0},
      {tl_floor, 0, 0, 0},
      {tl_ceil, 1, 0, 0},
      {tl_trunc, 0, 0, 0},
      {tl_float, 0.5, 1, 0},
  };
  tl_shape shape;
  assert_int_equal(tl_shape_init(&shape, tl_hessian(1), NULL, 0), 0);
  tl_real memory[3 * (TL_NSCRATCH + 2)];
  tl_ctx cx;
  tl_ctx_init(&cx, &shape, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 1), *b = tl_push(&cx, 1);
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++) {
    tl_seed(&cx, a, forms[i].f == tl_acosh ? 1.5f : 0.5f, 0);
    forms[i].f(&cx, b, a);
    const double expected[] = {forms[i].value, forms[i].first, forms[i].second};
    for (int k = 0; k < 3; k++) assert_close_at((double)b[k], expected[k], TOLERANCE, 0.0, 3 * (int)i + k, __FILE__, __LINE__);
  }
  assert_int_equal(cx.status.bits, TL_OK);
}

/* (xy)^2 / hypot(x,y) at (3,4): value 28.8, and its gradient by hand. */
static void two_variables_work_in_single_precision(void **state) {
  (void)state;
  tl_shape shape;
  assert_int_equal(tl_shape_init(&shape, tl_jacobian(2), NULL, 0), 0);
  tl_real memory[3 * (TL_NSCRATCH + 3)];
  tl_ctx cx;
  tl_ctx_init(&cx, &shape, memory, sizeof memory / sizeof *memory);
  tl_real *x = tl_push(&cx, 1), *y = tl_push(&cx, 1), *c = tl_push(&cx, 1);
  tl_seed(&cx, x, 3.0f, 0);
  tl_seed(&cx, y, 4.0f, 1);
  tl_mul(&cx, c, x, y);
  tl_powi(&cx, c, c, 2);
  tl_hypot(&cx, x, x, y);
  tl_div(&cx, c, c, x);
  const double expected[] = {28.8, 2 * 28.8 / 3 - 28.8 * 3 / 25, 2 * 28.8 / 4 - 28.8 * 4 / 25};
  for (int k = 0; k < 3; k++) assert_close_at((double)c[k], expected[k], TOLERANCE, 0.0, k, __FILE__, __LINE__);
  assert_int_equal(cx.status.bits, TL_OK);
}

/* Below zero the gamma function takes twice the precision of a float: Gamma(-5/2 + h) = Gamma(1/2 + h)/((h - 1/2) (h - 3/2) (h - 5/2)).
 * psi(-5/2) = psi(1/2) + 2 + 2/3 + 2/5, half of psi'(-5/2) = half of psi'(1/2) + (4 + 4/9 + 4/25)/2. */
static void gamma_works_below_zero_in_single_precision(void **state) {
  (void)state;
  tl_shape shape;
  assert_int_equal(tl_shape_init(&shape, tl_hessian(1), NULL, 0), 0);
  tl_real memory[3 * (TL_NSCRATCH + 2)];
  tl_ctx cx;
  tl_ctx_init(&cx, &shape, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 1), *c = tl_push(&cx, 1);
  const double first = PSI_HALF + 2.0 + 2.0 / 3.0 + 0.4, second = HALF_TRIGAMMA_HALF + 2.0 + 2.0 / 9.0 + 0.08;
  const double gamma = -ROOT_PI * 8.0 / 15.0;
  const double expected[] = {log(-gamma), first, second, gamma, gamma * first, gamma * (second + 0.5 * first * first)};
  tl_seed(&cx, a, -2.5f, 0);
  tl_lgamma(&cx, c, a);
  for (int k = 0; k < 3; k++) assert_close_at((double)c[k], expected[k], TOLERANCE, 0.0, k, __FILE__, __LINE__);
  tl_tgamma(&cx, c, a);
  for (int k = 0; k < 3; k++) assert_close_at((double)c[k], expected[3 + k], TOLERANCE, 0.0, 3 + k, __FILE__, __LINE__);
  assert_int_equal(cx.status.bits, TL_OK);
}

/* At x = 3/2: 7 mod x = 7 - 4 x, and 7/x by a rule of two arguments. */
static unsigned ratio_rule(tl_real *f, const tl_real *x, int degree, const void *user) {
  (void)user;
  if (degree != 1) return TL_DOMAIN;
  f[0] = x[0] / x[1];
  f[1] = 1.0f / x[1];
  f[2] = -x[0] / (x[1] * x[1]);
  return TL_OK;
}
static void rests_and_rules_work_in_single_precision(void **state) {
  (void)state;
  tl_shape shape;
  assert_int_equal(tl_shape_init(&shape, tl_jacobian(1), NULL, 0), 0);
  tl_real memory[2 * (TL_NSCRATCH + 3)];
  tl_ctx cx;
  tl_ctx_init(&cx, &shape, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 1), *x = tl_push(&cx, 1), *c = tl_push(&cx, 1);
  tl_const(&cx, a, 7.0f);
  tl_seed(&cx, x, 1.5f, 0);
  tl_fmod(&cx, c, a, x);
  assert_close_at((double)c[0], 1.0, 0.0, 0.0, 0, __FILE__, __LINE__);
  assert_close_at((double)c[1], -4.0, 0.0, 0.0, 1, __FILE__, __LINE__);
  tl_apply_n(&cx, c, 2, (const tl_real *const[]){a, x}, ratio_rule, NULL);
  assert_close_at((double)c[0], 7.0 / 1.5, TOLERANCE, 0.0, 0, __FILE__, __LINE__);
  assert_close_at((double)c[1], -7.0 / 2.25, TOLERANCE, 0.0, 1, __FILE__, __LINE__);
  assert_int_equal(cx.status.bits, TL_OK);
}

static void overflow_is_that_of_single_precision(void **state) {
  (void)state;
  tl_shape shape;
  assert_int_equal(tl_shape_init(&shape, tl_jacobian(1), NULL, 0), 0);
  tl_real memory[2 * (TL_NSCRATCH + 1)];
  tl_ctx cx;
  tl_ctx_init(&cx, &shape, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 1);
  tl_seed(&cx, a, 1e30f, 0);
  tl_mul(&cx, a, a, a);
  assert_int_equal(cx.status.bits, TL_NONFINITE);
  assert_int_equal(cx.status.function, TL_FN_mul);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(derivatives_are_right_to_single_precision),  cmocka_unit_test(two_variables_work_in_single_precision),
      cmocka_unit_test(gamma_works_below_zero_in_single_precision), cmocka_unit_test(rests_and_rules_work_in_single_precision),
      cmocka_unit_test(overflow_is_that_of_single_precision),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
