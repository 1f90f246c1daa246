/* Derivatives of powers against differences of MPFR's values, by symmetry at negative bases, and exactly at zero. */
#include "close.h"
#include "reference_function.h"
#include "taylor/power.h"

#include <math.h>

enum { DEGREE = 4, POINTS = 10 }; /* of each exponent */

/* pow is within an ulp, the factors and products cost half an ulp each. */
static const double ROUNDING = (DEGREE + 2) * TL_EPSILON;

static const double exponents[] = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 17.0, -1.0, -2.0,   -6.0,
                                   0.5, 1.5, 2.5, 3.5, 4.5, 6.5, -0.5, -1.5, 0.3125, -2.75};
enum { EXPONENTS = sizeof exponents / sizeof exponents[0] };

static double factorial(int k) { return k > 1 ? k * factorial(k - 1) : 1.0; }

static int is_whole(double x) { return x == floor(x); }

static void positive_bases(void **state) {
  (void)state;
  const ref_function *f = ref_lookup("pow");
  mpfr_t c[(DEGREE + 1) * (DEGREE + 1)];
  for (int i = 0; i < (DEGREE + 1) * (DEGREE + 1); i++) mpfr_init2(c[i], REF_PRECISION);
  rng r = {3};
  for (int i = 0; i < test_tries(POINTS) * EXPONENTS; i++) {
    const tl_real x = (tl_real)rng_uniform(&r, 0.125, 3.0), e = (tl_real)exponents[i % EXPONENTS];
    ref_taylor(f, x, e, DEGREE, c);
    for (int k = 0; k <= DEGREE; k++) {
      assert_int_equal(tl_power_exists(x, e, k), 1);
      const double expected = factorial(k) * mpfr_get_d(c[k * (DEGREE + 1)], MPFR_RNDN);
      if (is_whole(e) && e >= 0.0 && (tl_real)k > e)
        assert_same(tl_power(x, e, k), 0.0);
      else
        assert_close(tl_power(x, e, k), expected, ROUNDING, 0.0);
    }
  }
  for (int i = 0; i < (DEGREE + 1) * (DEGREE + 1); i++) mpfr_clear(c[i]);
}

/* x^e is even or odd for whole e, and each derivative turns one into the other. */
static void negative_bases(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++)
    for (int k = 0; k <= DEGREE; k++) {
      const tl_real x = TL_C(1.25), e = (tl_real)exponents[i];
      assert_int_equal(tl_power_exists(-x, e, k), is_whole(e));
      if (is_whole(e)) assert_same(tl_power(-x, e, k), fmod(e - (tl_real)k, 2.0) == 0.0 ? tl_power(x, e, k) : -tl_power(x, e, k));
    }
}

static void zero(void **state) {
  (void)state;
  for (int i = 0; i < EXPONENTS; i++)
    for (int k = 0; k <= DEGREE; k++) {
      const tl_real e = (tl_real)exponents[i];
      const int ends = is_whole(e) && e >= 0.0;
      assert_int_equal(tl_power_exists(TL_C(0.0), e, k), ends || e > (tl_real)k);
      if (ends || e > (tl_real)k) assert_same(tl_power(TL_C(0.0), e, k), e == (tl_real)k ? factorial(k) : 0.0);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(positive_bases),
      cmocka_unit_test(negative_bases),
      cmocka_unit_test(zero),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
