/* Identities between elementary functions at every order: sin^2 + cos^2 = 1, cosh^2 - sinh^2 = 1, a function of its inverse. What one
 * recurrence does to a jet, another undoes. */
#include "close_real.h"
#include "functions.h"
#include "random.h"

/* Orders 1..12 in one and two variables and along a curve, to 6 in eight, and mixtures; __float128, in software, would take long. */
enum { LONG = TL_MANT_DIG > 64 };
static const tl_spec LARGEST[] = {{0, 1, 12}, {12, 0, 0}, {0, 2, LONG ? 8 : 12}, {0, 3, LONG ? 6 : 8}, {0, 8, LONG ? 4 : 6}, {3, 2, 5},
                                  {12, 2, 1}, {40, 0, 0}};
enum { NLARGEST = sizeof LARGEST / sizeof *LARGEST, NJET = 5 };

/* In units of TL_EPSILON times the largest coefficient that a step of the identity has, for each order. Errors of lower orders go into
 * each term of the higher ones; the terms of a coefficient are as many as its monomial has divisors. */
static const tl_real UNITS_PER_ORDER = 4;

typedef struct workplace {
  jet_space space;
  tl_real *a, *jet[NJET];
  tl_real tolerance; /* of identities whose steps are about 1 */
} workplace;

static tl_real largest(const tl_real *a, int n) {
  tl_real m = 0;
  for (int i = 0; i < n; i++) m = TL_LIBM(fmax)(m, TL_LIBM(fabs)(a[i]));
  return m;
}

/* Coefficients that fall from order to order, more so in many variables: the jet, a polynomial, keeps away from all singularities as
 * long as no variable is larger than 1, and so the coefficients of the results do not grow. */
static void draw(workplace *w, rng *r, double value) {
  const tl_shape *s = &w->space.shape;
  const double fall = 0.25 / (s->nvar + (s->curve > 0));
  for (int i = 0; i < s->ncoef; i++) {
    int k, alpha[8];
    tl_monomial(s, i, &k, alpha);
    double size = 1.0;
    for (int v = 0; v < s->nvar; v++) k += alpha[v];
    for (int j = 0; j < k; j++) size *= fall;
    w->a[i] = (tl_real)(size * rng_uniform(r, -1.0, 1.0));
  }
  w->a[0] = (tl_real)value;
}

static void for_each_order(double value, void (*check)(workplace *w)) {
  rng r = {1};
  for (int i = 0; i < NLARGEST; i++) {
    const int orders = LARGEST[i].order > 1 ? LARGEST[i].order : LARGEST[i].curve;
    for (int m = 1; m <= orders; m++) {
      tl_spec spec = LARGEST[i];
      *(LARGEST[i].order > 1 ? &spec.order : &spec.curve) = m;
      workplace w;
      jet_space_init(&w.space, spec, NJET + 1);
      w.a = tl_push(&w.space.cx, 1);
      for (int j = 0; j < NJET; j++) w.jet[j] = tl_push(&w.space.cx, 1);
      w.tolerance = UNITS_PER_ORDER * (tl_real)(w.space.shape.degree + 1) * TL_EPSILON;
      draw(&w, &r, value);
      check(&w);
      assert_int_equal(w.space.cx.status.bits, TL_OK);
      jet_space_free(&w.space);
    }
  }
}

static void check_squares(workplace *w) {
  tl_ctx *cx = &w->space.cx;
  tl_real *s = w->jet[0], *c = w->jet[1], *sum = w->jet[2], *one = w->jet[3];
  tl_const(cx, one, 1);
  tl_sincos(cx, s, c, w->a);
  tl_mul(cx, sum, s, s);
  tl_muladd(cx, sum, c, c);
  assert_jet_close(sum, one, w->space.shape.ncoef, 0, w->tolerance);
  tl_sinh(cx, s, w->a);
  tl_cosh(cx, c, w->a);
  tl_neg(cx, sum, s);
  tl_mul(cx, sum, sum, s);
  tl_muladd(cx, sum, c, c);
  assert_jet_close(sum, one, w->space.shape.ncoef, 0, w->tolerance * largest(c, 1) * largest(c, 1));
}
static void squares_of_sine_and_cosine_add_to_one(void **state) {
  (void)state;
  for_each_order(0.7, check_squares);
}

typedef void function(tl_ctx *cx, tl_real *c, const tl_real *a);
static void square(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_mul(cx, c, a, a); }
static void cube(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_powi(cx, c, a, 3); }
static void reciprocal(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_rdiv(cx, c, 1, a); }
static void power(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_powc(cx, c, a, 2.5); }
static void root(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_powc(cx, c, a, TL_C(0.4)); }
static void tenth_power(tl_ctx *cx, tl_real *c, const tl_real *a) { tl_rpow(cx, c, 10, a); }

/* outer(inner(a)) = a at a value of each that is far from the ends of both. */
static const struct inverse {
  const char *name;
  function *outer, *inner;
} INVERSES[] = {
    {"exp o log", tl_exp, tl_log},         {"log o exp", tl_log, tl_exp},         {"expm1 o log1p", tl_expm1, tl_log1p},
    {"log1p o expm1", tl_log1p, tl_expm1}, {"exp2 o log2", tl_exp2, tl_log2},     {"log2 o exp2", tl_log2, tl_exp2},
    {"10^log10", tenth_power, tl_log10},   {"sin o asin", tl_sin, tl_asin},       {"asin o sin", tl_asin, tl_sin},
    {"cos o acos", tl_cos, tl_acos},       {"acos o cos", tl_acos, tl_cos},       {"tan o atan", tl_tan, tl_atan},
    {"atan o tan", tl_atan, tl_tan},       {"sinh o asinh", tl_sinh, tl_asinh},   {"asinh o sinh", tl_asinh, tl_sinh},
    {"acosh o cosh", tl_acosh, tl_cosh},   {"tanh o atanh", tl_tanh, tl_atanh},   {"atanh o tanh", tl_atanh, tl_tanh},
    {"sqrt^2", square, tl_sqrt},           {"sqrt of a square", tl_sqrt, square}, {"cbrt^3", cube, tl_cbrt},
    {"cbrt of a cube", tl_cbrt, cube},     {"1/(1/a)", reciprocal, reciprocal},   {"a^2.5^0.4", root, power},
};

static void check_inverses(workplace *w) {
  tl_ctx *cx = &w->space.cx;
  const int n = w->space.shape.ncoef;
  for (size_t i = 0; i < sizeof INVERSES / sizeof *INVERSES; i++) {
    tl_real *inner = w->jet[0], *back = w->jet[1];
    INVERSES[i].inner(cx, inner, w->a);
    INVERSES[i].outer(cx, back, inner);
    const tl_real allowed = w->tolerance * (1 + largest(inner, n));
    for (int k = 0; k < n; k++)
      assert_real_case(back[k], w->a[k], allowed, __FILE__, __LINE__, "%s, shape {%d,%d,%d}, coefficient %d", INVERSES[i].name,
                       w->space.shape.curve, w->space.shape.nvar, w->space.shape.order, k);
  }
}
static void functions_of_their_inverses_are_the_argument(void **state) {
  (void)state;
  for_each_order(0.6, check_inverses);
}

/* sin(a+b) and exp(a+b) by products of functions of a and of b. */
static void check_sums(workplace *w) {
  tl_ctx *cx = &w->space.cx;
  const int n = w->space.shape.ncoef;
  tl_real *b = w->jet[0], *s = w->jet[1], *c = w->jet[2], *sum = w->jet[3], *expected = w->jet[4];
  tl_copy(cx, b, w->a);
  for (int i = 1; i < n; i += 2) b[i] = -b[i];
  tl_add(cx, expected, w->a, b);
  tl_sin(cx, expected, expected);
  tl_sin(cx, s, w->a);
  tl_cos(cx, c, b);
  tl_mul(cx, sum, s, c);
  tl_cos(cx, c, w->a);
  tl_sin(cx, s, b);
  tl_muladd(cx, sum, s, c);
  assert_jet_close(sum, expected, n, 0, w->tolerance);
  tl_add(cx, expected, w->a, b);
  tl_exp(cx, expected, expected);
  tl_exp(cx, s, w->a);
  tl_exp(cx, c, b);
  tl_mul(cx, sum, s, c);
  assert_jet_close(sum, expected, n, 0, w->tolerance * largest(expected, n));
}
static void functions_of_sums_are_products(void **state) {
  (void)state;
  for_each_order(0.4, check_sums);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(squares_of_sine_and_cosine_add_to_one),
      cmocka_unit_test(functions_of_their_inverses_are_the_argument),
      cmocka_unit_test(functions_of_sums_are_products),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
