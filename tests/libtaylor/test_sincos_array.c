/* Sines and cosines of arrays against MPFR: uniform in the exponent, near multiples of pi/2, special values, every place and length. An
 * argument on the command line is the number of random points of each kind. */
#include "close.h"
#include "random.h"
#include "taylor/sincos_array.h"

#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 21, REFERENCE_BITS = 160, DIGITS = sizeof(tl_real) == sizeof(float) ? FLT_MANT_DIG : DBL_MANT_DIG };

static const double BOUND = 1.1; /* ulp, as the header says */

static int points = 20000;

/* |actual - exact| in units of the last place of exact, those of subnormal numbers for results below. Destroys exact. */
static double error(tl_real actual, mpfr_t exact) {
  mpfr_exp_t e = mpfr_zero_p(exact) ? TL_MIN_EXP : mpfr_get_exp(exact);
  if (e < TL_MIN_EXP) e = TL_MIN_EXP;
  mpfr_sub_d(exact, exact, (double)actual, MPFR_RNDN);
  mpfr_mul_2si(exact, exact, DIGITS - (long)e, MPFR_RNDN);
  return fabs(mpfr_get_d(exact, MPFR_RNDN));
}

/* The worst error so far of a kind of points, and where. */
typedef struct worst {
  double error, at;
} worst;

static void check(const tl_real *x, int n, worst *w) {
  tl_real s[LONGEST], c[LONGEST];
  mpfr_t argument, sine, cosine;
  mpfr_init2(argument, DIGITS);
  mpfr_inits2(REFERENCE_BITS, sine, cosine, (mpfr_ptr)NULL);
  tl_sincos_array(n, x, s, c);
  for (int i = 0; i < n; i++) {
    mpfr_set_d(argument, (double)x[i], MPFR_RNDN);
    mpfr_sin_cos(sine, cosine, argument, MPFR_RNDN);
    const double e = fmax(error(s[i], sine), error(c[i], cosine));
    if (!(e <= w->error)) *w = (worst){e, (double)x[i]};
  }
  mpfr_clears(argument, sine, cosine, (mpfr_ptr)NULL);
}

static void assert_bounded(const worst *w, const char *kind) {
  assert_close_case(w->error, 0.0, BOUND, __FILE__, __LINE__, "worst error in ulp, %s, at %.17g", kind, w->at);
  print_message("%s: at most %.3f ulp, at %.17g\n", kind, w->error, w->at);
}

static void arguments_of_every_size(void **state) {
  (void)state;
  rng r = {1};
  worst w = {0};
  for (int k = 0; k < points; k += LONGEST) {
    tl_real x[LONGEST];
    for (int i = 0; i < LONGEST; i++) x[i] = (tl_real)(rng_sign(&r) * rng_exponent(&r, TL_MIN_EXP - DIGITS, 60.0));
    check(x, LONGEST, &w);
  }
  assert_bounded(&w, "uniform in the exponent");
}

/* Up to the largest number: those that are many turns. The first is the one that comes nearest to a multiple of pi/2, where glibc's cos
 * is wrong by 8 ulp. */
static void arguments_of_any_exponent(void **state) {
  (void)state;
  rng r = {6};
  worst w = {0};
  for (int k = 0; k < points; k += LONGEST) {
    tl_real x[LONGEST];
    for (int i = 0; i < LONGEST; i++) x[i] = (tl_real)(rng_sign(&r) * rng_exponent(&r, 60.0, TL_MAX_EXP - 1));
    if (TL_SINCOS_OWN) x[0] = sizeof(tl_real) == sizeof(float) ? TL_C(0x1.f37c8ap+95) : (tl_real)0x1.6ac5b262ca1ffp849;
    check(x, LONGEST, &w);
  }
  assert_bounded(&w, "of many turns");
}

static void arguments_of_mechanisms(void **state) {
  (void)state;
  rng r = {2};
  worst w = {0};
  for (int k = 0; k < points; k += LONGEST) {
    tl_real x[LONGEST];
    for (int i = 0; i < LONGEST; i++) x[i] = (tl_real)rng_uniform(&r, -50.0, 50.0);
    check(x, LONGEST, &w);
  }
  assert_bounded(&w, "uniform to 50");
}

/* The nearest numbers to k pi/2 and their neighbours, k of every size: what is left after the reduction is smallest there. */
static void arguments_near_multiples_of_a_quarter_turn(void **state) {
  (void)state;
  rng r = {3};
  worst w = {0};
  for (int k = 0; k < points; k += LONGEST) {
    tl_real x[LONGEST];
    for (int i = 0; i < LONGEST; i++) {
      x[i] = (tl_real)(rng_sign(&r) * floor(rng_exponent(&r, 0.0, 40.0)) * 1.57079632679489661923);
      for (int step = rng_below(&r, 5) - 2; step != 0; step += step > 0 ? -1 : 1)
        x[i] = TL_LIBM(nextafter)(x[i], step > 0 ? TL_MAX : -TL_MAX);
    }
    check(x, LONGEST, &w);
  }
  assert_bounded(&w, "near multiples of pi/2");
}

/* x[2].. from x[0] and x[1]: larger and smaller neighbours of both. */
static void add_neighbours(tl_real *x) {
  for (int i = 2; i < LONGEST; i++) x[i] = TL_LIBM(nextafter)(x[i < 6 ? i % 2 : i - 4], i % 4 < 2 ? TL_MAX : -TL_MAX);
}

/* Powers of two and their neighbours, and those of the numbers at which another formula begins. */
static void arguments_near_round_numbers(void **state) {
  (void)state;
  worst w = {0};
  for (int e = -30; e < 60; e++) {
    tl_real x[LONGEST];
    x[0] = (tl_real)ldexp(1.0, e), x[1] = -x[0];
    add_neighbours(x);
    check(x, LONGEST, &w);
  }
#ifdef TL_SINCOS_LIMIT
  const tl_real limits[] = {TL_SINCOS_LIMIT};
#elif TL_SINCOS_OWN
  const tl_real limits[] = {TL_SINCOS_SMALL, TL_SINCOS_QUARTER, TL_SINCOS_TINY, TL_MAX / TL_C(2.0)};
#else
  const tl_real limits[] = {TL_C(1.0)};
#endif
  for (size_t k = 0; k < sizeof limits / sizeof *limits; k++) {
    tl_real x[LONGEST] = {-limits[k], limits[k]};
    add_neighbours(x);
    check(x, LONGEST, &w);
  }
  assert_bounded(&w, "near round numbers");
}

/* The bits of a number alone are those in any place of an array of any length, among numbers of any size. */
static void place_and_company_do_not_matter(void **state) {
  (void)state;
  rng r = {4};
  for (int n = 1; n <= LONGEST; n++)
    for (int k = 0; k < 200; k++) {
      tl_real x[LONGEST], s[LONGEST], c[LONGEST];
      for (int i = 0; i < n; i++) x[i] = (tl_real)(rng_sign(&r) * rng_exponent(&r, -30.0, k % 2 ? 100.0 : 3.0));
      if (k % 5 == 0) x[rng_below(&r, n)] = (tl_real)INFINITY;
      tl_sincos_array(n, x, s, c);
      for (int i = 0; i < n; i++) {
        tl_real alone[2];
        tl_sincos_array(1, x + i, alone, alone + 1);
        assert_int_equal(memcmp(alone, s + i, sizeof *s), 0);
        assert_int_equal(memcmp(alone + 1, c + i, sizeof *c), 0);
      }
    }
}

static void special_values_are_those_of_the_library(void **state) {
  (void)state;
  const tl_real x[] = {TL_C(0.0), -TL_C(0.0), (tl_real)INFINITY,  -(tl_real)INFINITY, (tl_real)NAN, TL_MAX,
                       -TL_MAX,   TL_MIN,     TL_MIN * TL_EPSILON};
  enum { N = sizeof x / sizeof *x };
  tl_real s[N], c[N];
  tl_sincos_array(N, x, s, c);
  for (int i = 0; i < N; i++) {
    const tl_real sine = TL_LIBM(sin)(x[i]), cosine = TL_LIBM(cos)(x[i]);
    if (isnan(sine)) {
      assert_true(isnan(s[i]) && isnan(c[i]));
    } else {
      assert_close(s[i], sine, TL_EPSILON, 0.0);
      assert_close(c[i], cosine, TL_EPSILON, 0.0);
      assert_int_equal(signbit(s[i]) != 0, signbit(sine) != 0);
    }
  }
}

static void results_may_replace_arguments(void **state) {
  (void)state;
  rng r = {5};
  for (int n = 1; n <= LONGEST; n++) {
    tl_real x[LONGEST], y[LONGEST], s[LONGEST], c[LONGEST], other[LONGEST];
    for (int i = 0; i < n; i++) x[i] = y[i] = (tl_real)rng_uniform(&r, -9.0, 9.0);
    tl_sincos_array(n, x, s, c);
    tl_sincos_array(n, x, x, other);
    tl_sincos_array(n, y, other, y);
    for (int i = 0; i < n; i++) {
      assert_same(x[i], s[i]);
      assert_same(y[i], c[i]);
    }
  }
}

int main(int argc, char **argv) {
  points = test_tries(argc > 1 ? atoi(argv[1]) : points);
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(arguments_of_every_size),
      cmocka_unit_test(arguments_of_any_exponent),
      cmocka_unit_test(arguments_of_mechanisms),
      cmocka_unit_test(arguments_near_multiples_of_a_quarter_turn),
      cmocka_unit_test(arguments_near_round_numbers),
      cmocka_unit_test(place_and_company_do_not_matter),
      cmocka_unit_test(special_values_are_those_of_the_library),
      cmocka_unit_test(results_may_replace_arguments),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
