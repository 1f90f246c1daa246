/* The fast exact coefficients of reference_series.h against differences of MPFR's values, which know no formula. */
#include "close.h"
#include "functions.h"
#include "reference_series.h"

#include <math.h>
#include <stdlib.h>

enum { DEGREE = REF_MAX_DEGREE, N = DEGREE + 1, ENOUGH_BITS = 170 };

/* Both are wrong by far less than a double's last bit: |difference| <= 2^-ENOUGH_BITS (|f_ij| + |x f_(i+1)j| + |y f_i(j+1)|). */
static int agree(mpfr_t *series, mpfr_t *differences, int i, int j, double x, double y) {
  mpfr_t difference, scale, term;
  mpfr_inits2(REF_PRECISION, difference, scale, term, (mpfr_ptr)0);
  mpfr_abs(scale, series[i * N + j], MPFR_RNDN);
  if (i + j < DEGREE) {
    mpfr_mul_d(term, series[(i + 1) * N + j], fabs(x), MPFR_RNDN);
    mpfr_abs(term, term, MPFR_RNDN);
    mpfr_add(scale, scale, term, MPFR_RNDN);
    mpfr_mul_d(term, series[i * N + j + 1], fabs(y), MPFR_RNDN);
    mpfr_abs(term, term, MPFR_RNDN);
    mpfr_add(scale, scale, term, MPFR_RNDN);
  }
  mpfr_sub(difference, series[i * N + j], differences[i * N + j], MPFR_RNDN);
  mpfr_mul_2si(scale, scale, -ENOUGH_BITS, MPFR_RNDN);
  const int close = mpfr_cmpabs(difference, scale) <= 0;
  mpfr_clears(difference, scale, term, (mpfr_ptr)0);
  return close;
}

/* Constant exponents and bases are no variables there; a negative base has no differences in its exponent. */
static int is_variable(const jet_function *f, int j) { return j == 0 || f->two; }

static void check(const jet_function *f, const ref_function *ref, double x, double y, mpfr_t *series, mpfr_t *differences) {
  if (f->constant && x < 0.0) return;
  ref_series(ref, x, y, DEGREE, series);
  ref_taylor(ref, x, y, DEGREE, differences);
  for (int i = 0; i <= DEGREE; i++)
    for (int j = 0; i + j <= DEGREE; j++)
      if (is_variable(f, j) && !agree(series, differences, i, j, x, y))
        fail_msg("%s(%.17g, %.17g), coefficient (%d,%d): %.17g by the series, %.17g by differences", f->name, x, y, i, j,
                 mpfr_get_d(series[i * N + j], MPFR_RNDN), mpfr_get_d(differences[i * N + j], MPFR_RNDN));
}

static int samples = 4; /* of each function; the program's argument sets another number */

static void series_agree_with_differences(void **state) {
  (void)state;
  mpfr_t series[N * N], differences[N * N];
  for (int i = 0; i < N * N; i++) mpfr_inits2(REF_PRECISION, series[i], differences[i], (mpfr_ptr)0);
  rng r = {6};
  for (int i = 0; i < njet_functions; i++)
    for (int k = 0; k < test_tries(samples); k++) {
      const ref_function *ref = ref_lookup(jet_functions[i].name);
      double x, y;
      ref_draw(ref, &r, &x, &y);
      check(&jet_functions[i], ref, x, y, series, differences);
    }
  for (int i = 0; i < N * N; i++) mpfr_clears(series[i], differences[i], (mpfr_ptr)0);
  mpfr_free_cache();
}

int main(int argc, char **argv) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(series_agree_with_differences)};
  if (argc > 1) samples = atoi(argv[1]);
  return cmocka_run_group_tests(tests, NULL, NULL);
}
