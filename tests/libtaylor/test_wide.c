/* Arithmetic in twice the precision against MPFR, for every significand. */
#include "close_real.h"
#include "random.h"
#include "wide.h"

enum { TRIES = 2000, PRECISION = 1000 };

/* In units of TL_EPSILON^2, and of TL_EPSILON: the terms of the logarithm that are computed in one precision, and so right to half an
 * ulp, are below 2e-4 of the sum. */
static const tl_real OPERATION_UNITS = 8, LOG_UNITS = TL_C(1e-4);

static mpfr_t x, y, exact, error;

static void wide_to_mpfr(mpfr_t result, tl_wide a) {
  real_to_mpfr(result, a.hi);
  real_to_mpfr(error, a.lo);
  mpfr_add(result, result, error, MPFR_RNDN);
}

/* |actual - exact| / |size|. */
static tl_real relative_error(tl_wide actual, const mpfr_t size) {
  mpfr_t difference;
  mpfr_init2(difference, PRECISION);
  wide_to_mpfr(difference, actual);
  mpfr_sub(difference, difference, exact, MPFR_RNDN);
  mpfr_div(difference, difference, size, MPFR_RNDN);
  const tl_real result = TL_LIBM(fabs)(real_from_mpfr(difference));
  mpfr_clear(difference);
  return result;
}

static tl_real draw_real(rng *r) {
  const tl_real low = (tl_real)rng_uniform(r, -1.0, 1.0) * (TL_C(1.0) / 0x1p20f); /* a double has not the bits of all types */
  return (tl_real)(rng_sign(r) * rng_exponent(r, -8.0, 8.0)) * (TL_C(1.0) + low * low * low);
}

static tl_wide draw_wide(rng *r) {
  const tl_real hi = draw_real(r);
  return tl_wide_quick_sum(hi, hi * (TL_EPSILON / 4) * (tl_real)rng_uniform(r, -1.0, 1.0));
}

static void sums_and_products_of_two_numbers_are_exact(void **state) {
  (void)state;
  rng r = {1};
  for (int i = 0; i < test_tries(TRIES); i++) {
    const tl_real a = draw_real(&r), b = draw_real(&r);
    real_to_mpfr(x, a);
    real_to_mpfr(y, b);
    mpfr_mul(exact, x, y, MPFR_RNDN);
    assert_real_same(relative_error(tl_wide_product(a, b), exact), 0);
    mpfr_add(exact, x, y, MPFR_RNDN);
    assert_real_same(relative_error(tl_wide_sum(a, b), x), 0);
  }
}

static void operations_are_right_to_twice_the_precision(void **state) {
  (void)state;
  rng r = {2};
  const tl_real allowed = OPERATION_UNITS * TL_EPSILON * TL_EPSILON;
  for (int i = 0; i < test_tries(TRIES); i++) {
    const tl_wide a = draw_wide(&r), b = draw_wide(&r);
    wide_to_mpfr(x, a);
    wide_to_mpfr(y, b);
    mpfr_add(exact, x, y, MPFR_RNDN);
    assert_real_close(relative_error(tl_wide_add(a, b), TL_LIBM(fabs)(a.hi) > TL_LIBM(fabs)(b.hi) ? x : y), 0, 0, allowed);
    mpfr_mul(exact, x, y, MPFR_RNDN);
    assert_real_close(relative_error(tl_wide_mul(a, b), exact), 0, 0, allowed);
    mpfr_div(exact, x, y, MPFR_RNDN);
    assert_real_close(relative_error(tl_wide_div(a, b), exact), 0, 0, allowed);
    mpfr_abs(x, x, MPFR_RNDN);
    mpfr_sqrt(exact, x, MPFR_RNDN);
    assert_real_close(relative_error(tl_wide_sqrt(a.hi > 0 ? a : tl_wide_neg(a)), exact), 0, 0, allowed);
  }
}

/* Over the whole range, and beside 1. */
static void logarithms_are_right_to_a_small_part_of_an_ulp(void **state) {
  (void)state;
  rng r = {3};
  for (int i = 0; i < test_tries(TRIES); i++) {
    const tl_real near = 1 + draw_real(&r) * real_power_of_two(-rng_below(&r, TL_MANT_DIG) - 9);
    const tl_real any = TL_LIBM(fabs)(draw_real(&r)) * real_power_of_two(rng_below(&r, 2 * TL_MAX_EXP - 40) + 20 - TL_MAX_EXP);
    const tl_wide a = tl_widen(i % 2 ? near : any);
    if (a.hi == 1) continue;
    wide_to_mpfr(x, a);
    mpfr_log(exact, x, MPFR_RNDN);
    assert_real_close(relative_error(tl_wide_log(a), exact), 0, 0, LOG_UNITS * TL_EPSILON);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(sums_and_products_of_two_numbers_are_exact),
      cmocka_unit_test(operations_are_right_to_twice_the_precision),
      cmocka_unit_test(logarithms_are_right_to_a_small_part_of_an_ulp),
  };
  mpfr_inits2(PRECISION, x, y, exact, error, (mpfr_ptr)0);
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  mpfr_clears(x, y, exact, error, (mpfr_ptr)0);
  mpfr_free_cache();
  return failed;
}
