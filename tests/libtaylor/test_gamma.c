/* The gamma functions in high degrees, where their coefficients at 1/2 and at integers are values of Riemann's zeta function. */
#include "close_real.h"
#include "functions.h"
#include "random.h"

#include <math.h>
#include <mpfr.h>

/* The largest degree that a shape can have. Mixed coefficients of the highest are beyond the range of a float, and products of such
 * jets of __float128 take long. */
enum { ORDER = TL_MAX_EXP < 1024 || TL_MANT_DIG > 64 ? 4 : TL_MAX_ORDER, DEGREE = TL_MAX_CURVE + ORDER, PRECISION = 1000 };

/* In ulp: rounded once from twice the precision. */
static const tl_real LOG_ULPS = TL_C(0.6);
/* Every coefficient of Gamma has the C library's Gamma for a factor: its 2 ulp are up to 4 of a product with a smaller significand. */
static const tl_real GAMMA_ULPS = TL_C(5.0);
/* Degrees above TL_MAX_CURVE are read off mixed coefficients, sums of binomials that are rounded once in each step of Horner's scheme.
 */
static const tl_real MIXED_ULPS = TL_C(0.5) * (tl_real)DEGREE;

/* Up to here Gamma is within the range, on both sides of zero; and below that size a coefficient, or a part of it, loses digits to the
 * range. */
static const double LARGEST_FACTORIAL = TL_MAX_EXP < 1024 ? 32.0 : 165.0;
static const tl_real SMALLEST = TL_MIN / (TL_EPSILON * TL_EPSILON);

/* f[k], k >= 2, of log Gamma(x+h) = (-1)^k zeta(k,x)/k: zeta(k,1/2) = (2^k - 1) zeta(k), zeta(k,x) = zeta(k) - 1 - 2^-k - ..
 * - (x-1)^-k for an integer x; f[1] = psi(x) = -euler - 2 log 2, -euler + 1 + 1/2 + .. + 1/(x-1). */
static void exact_log_series(mpfr_t *f, double x) {
  mpfr_t term;
  mpfr_init2(term, PRECISION);
  for (int k = 1; k <= DEGREE; k++) {
    if (k == 1)
      mpfr_const_euler(f[k], MPFR_RNDN);
    else
      mpfr_zeta_ui(f[k], (unsigned long)k, MPFR_RNDN);
    for (int n = 1; n < x; n++) {
      mpfr_set_si(term, n, MPFR_RNDN);
      mpfr_pow_si(term, term, -k, MPFR_RNDN);
      mpfr_sub(f[k], f[k], term, MPFR_RNDN);
    }
    if (x == 0.5 && k == 1) {
      mpfr_const_log2(term, MPFR_RNDN);
      mpfr_mul_ui(term, term, 2, MPFR_RNDN);
      mpfr_add(f[k], f[k], term, MPFR_RNDN);
    } else if (x == 0.5) {
      mpfr_set(term, f[k], MPFR_RNDN);
      mpfr_mul_2ui(f[k], f[k], (unsigned long)k, MPFR_RNDN);
      mpfr_sub(f[k], f[k], term, MPFR_RNDN);
    }
    mpfr_div_si(f[k], f[k], k % 2 ? -k : k, MPFR_RNDN);
  }
  mpfr_clear(term);
}

/* Multiplies f, the coefficients of log Gamma, out to those of Gamma: the sum of powers of the series over factorials. */
static void exponentiate(mpfr_t *f, double x) {
  mpfr_t g[DEGREE + 1], power[DEGREE + 1], sum;
  mpfr_init2(sum, PRECISION);
  for (int k = 0; k <= DEGREE; k++) {
    mpfr_init2(g[k], PRECISION);
    mpfr_init2(power[k], PRECISION);
    mpfr_set_ui(g[k], k == 0, MPFR_RNDN);
    mpfr_set_ui(power[k], k == 0, MPFR_RNDN);
  }
  for (int n = 1; n <= DEGREE; n++) {
    for (int k = DEGREE; k >= 0; k--) { /* power *= f / n; its coefficients below n - 1 are zero */
      mpfr_set_zero(sum, 1);
      for (int j = 1; j <= k; j++) mpfr_fma(sum, f[j], power[k - j], sum, MPFR_RNDN);
      mpfr_div_si(power[k], sum, n, MPFR_RNDN);
    }
    for (int k = 0; k <= DEGREE; k++) mpfr_add(g[k], g[k], power[k], MPFR_RNDN);
  }
  mpfr_set_d(sum, x, MPFR_RNDN);
  mpfr_gamma(sum, sum, MPFR_RNDN);
  for (int k = 0; k <= DEGREE; k++) {
    mpfr_mul(f[k], g[k], sum, MPFR_RNDN);
    mpfr_clear(g[k]);
    mpfr_clear(power[k]);
  }
  mpfr_clear(sum);
}

static tl_real allowed_ulps(int is_log, int k) {
  return (is_log ? LOG_ULPS : GAMMA_ULPS) + (k > TL_MAX_CURVE ? MIXED_ULPS : TL_C(0.0));
}

static void assert_coefficients(const tl_real *c, mpfr_t *exact, double x, int is_log) {
  for (int k = 1; k <= DEGREE; k++) {
    const tl_real expected = real_from_mpfr(exact[k]);
    if (TL_LIBM(fabs)(expected) < SMALLEST) continue;
    assert_real_case(c[k], expected, allowed_ulps(is_log, k) * real_ulp(expected), __FILE__, __LINE__, "%s at %g, coefficient %d",
                     is_log ? "lgamma" : "tgamma", x, k);
  }
}

static void coefficients_of_every_degree_are_zeta_values(void **state) {
  (void)state;
  const double points[] = {0.5, 60.0, 1.0, 2.0, 15.0, 18.0, 97.0, 130.0}; /* of few, one small and one large */
  const int tries = test_tries(sizeof points / sizeof *points);
  jet_space space;
  jet_space_init(&space, (tl_spec){.curve = TL_MAX_CURVE, .nvar = 1, .order = ORDER}, 2);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *c = tl_push(cx, 1);
  mpfr_t exact[DEGREE + 1];
  for (int k = 0; k <= DEGREE; k++) mpfr_init2(exact[k], PRECISION);
  for (int i = 0; i < tries; i++) {
    const double x = points[i];
    tl_real coefficients[DEGREE + 1] = {0.0};
    tl_const(cx, a, (tl_real)x);
    a[tl_index1(&space.shape, 0, 0)] = 1.0;
    a[tl_index(&space.shape, 1, NULL)] = 1.0; /* x + s + t: coefficient of s^k t^m is binomial(k+m,m) f_(k+m) */
    exact_log_series(exact, x);
    for (int pass = 0; pass < (x < LARGEST_FACTORIAL ? 2 : 1); pass++) {
      (pass == 0 ? tl_lgamma : tl_tgamma)(cx, c, a);
      assert_int_equal(cx->status.bits, TL_OK);
      for (int k = 0; k <= TL_MAX_CURVE; k++) coefficients[k] = c[tl_index(&space.shape, k, NULL)];
      for (int k = 1; k <= ORDER; k++) { /* s^64 t^k */
        tl_real binomial = 1.0;
        for (int j = 1; j <= k; j++) binomial = binomial * (tl_real)(TL_MAX_CURVE + j) / (tl_real)j;
        coefficients[TL_MAX_CURVE + k] = c[tl_index(&space.shape, TL_MAX_CURVE, &k)] / binomial;
      }
      if (pass == 1) exponentiate(exact, x);
      assert_coefficients(coefficients, exact, x, pass == 0);
    }
  }
  for (int k = 0; k <= DEGREE; k++) mpfr_clear(exact[k]);
  mpfr_free_cache();
  jet_space_free(&space);
}

/* Gamma(x+1) = x Gamma(x), as jets, on both sides of zero. */
static void gamma_fulfils_its_equation(void **state) {
  (void)state;
  const tl_real tolerance = 500 * TL_EPSILON; /* a product whose terms are up to a hundred times the sum */
  const double points[] = {0.3, -0.4, 3.7, -5.6, 40.2, -40.9, 120.1, -149.5, -150.5, -160.25, -25.5, -30.2};
  jet_space space;
  jet_space_init(&space, (tl_spec){.curve = 1, .nvar = 2, .order = 2}, 4);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *up = tl_push(cx, 1), *c = tl_push(cx, 1);
  for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
    if (fabs(points[i]) > LARGEST_FACTORIAL) continue;
    for (int k = 0; k < space.shape.ncoef; k++) a[k] = (tl_real)(k % 3 - 1);
    a[0] = (tl_real)points[i];
    tl_shift(cx, up, a, 1.0);
    tl_tgamma(cx, up, up);
    tl_tgamma(cx, c, a);
    tl_mul(cx, c, c, a);
    assert_int_equal(cx->status.bits, TL_OK);
    assert_jet_close(c, up, space.shape.ncoef, tolerance, tolerance * TL_LIBM(fabs)(up[0]));
  }
  jet_space_free(&space);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(coefficients_of_every_degree_are_zeta_values),
      cmocka_unit_test(gamma_fulfils_its_equation),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
