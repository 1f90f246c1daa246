/* Every elementary function in several shapes against differences of MPFR values, and what does not show there: aliasing, sine and
 * cosine together, powers with a constant base or exponent, the kinks. */
#include "close_real.h"
#include "functions.h"
#include "reference_function.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A coefficient's error is measured in units of half of TL_EPSILON (|coefficient| + its sensitivity to relative errors of the operands'
 * coefficients). The
 * bounds are what 300 samples of each function and shape reach, plus about a quarter; cbrt's value alone, glibc's, takes 3. */
static const double UNIT = (double)TL_EPSILON / 2.0;
static const struct {
  const char *name;
  double bound;
} BOUNDS[] = {{"cbrt", 5.0}, {"pow", 5.0},  {"rpow", 4.0},  {"lgamma", 4.0}, {"sqrt", 3.0},
              {"tanh", 3.0}, {"cosh", 3.0}, {"asinh", 3.0}, {"acosh", 3.0},  {"powc", 3.0}};
static const double OTHER_BOUND = 2.5;

/* Outside these sizes a coefficient, or a term of it, can be beyond the range of numbers or lose digits to it. */
static const double LARGEST = TL_MAX_EXP < 1024 ? 1e30 : 1e300, SMALLEST = TL_MAX_EXP < 1024 ? 1e-29 : 1e-290,
                    SMALLEST_RATIO = TL_MAX_EXP < 1024 ? 0x1p-104 : 0x1p-1000;

/* Degree 7 too: above 6 some functions go another way. */
static const tl_spec SPECS[] = {
    {0, 1, 0}, {0, 1, 1}, {0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {4, 0, 0}, {0, 3, 2},
    {0, 3, 3}, {1, 3, 2}, {2, 1, 1}, {5, 0, 0}, {1, 2, 4}, {7, 0, 0}, {2, 2, 5},
};
enum { NSPEC = sizeof SPECS / sizeof *SPECS };

static double bound_of(const char *name) {
  for (size_t i = 0; i < sizeof BOUNDS / sizeof *BOUNDS; i++)
    if (strcmp(BOUNDS[i].name, name) == 0) return BOUNDS[i].bound;
  return OTHER_BOUND;
}

/* The number that a tl_real holds, as a double: that has the reference for its operands. */
static double held(double x) { return (double)(tl_real)x; }
static int is_in_range(double x) { return x == 0.0 || ((tl_real)fabs(x) >= TL_MIN && (tl_real)fabs(x) <= TL_MAX); }

/* A point of the function's domain that a tl_real holds. */
static void draw_point(const ref_function *f, rng *r, double *x, double *y) {
  int is_point;
  do {
    ref_draw(f, r, x, y);
    is_point = is_in_range(*x) && is_in_range(*y);
    if (!is_point) continue;
    *x = held(*x);
    *y = held(*y);
    is_point = f->reach(*x, *y) > 0.0 && (!f->two || f->reach_y(*x, *y) > 0.0);
  } while (!is_point);
}

/* A random jet: coefficients of the size of the distance to the nearest singularity, so that all terms matter; some are zero. */
static void draw_numbers(rng *r, double *a, int n, double value, double size) {
  a[0] = value;
  for (int i = 1; i < n; i++) a[i] = rng_below(r, 5) == 0 ? 0.0 : held(size * rng_uniform(r, -1.0, 1.0));
}
static void copy_numbers(tl_real *c, const double *a, int n) {
  for (int i = 0; i < n; i++) c[i] = (tl_real)a[i];
}
static void draw_jet(rng *r, tl_real *a, int n, double value, double size) {
  double numbers[REF_MAX_COEF];
  draw_numbers(r, numbers, n, value, size);
  copy_numbers(a, numbers, n);
}

static double largest(const double *a, int n) {
  double m = 0.0;
  for (int i = 0; i < n; i++) m = fmax(m, fabs(a[i]));
  return m;
}

static int is_finite_jet(const tl_real *c, int n) {
  for (int i = 0; i < n; i++)
    if (!TL_ISFINITE(c[i])) return 0;
  return 1;
}
static double mpfr_largest(const ref_jet *a) {
  double m = 0.0;
  for (int i = 0; i < a->n; i++) m = fmax(m, fabs(mpfr_get_d(a->c[i], MPFR_RNDN)));
  return m;
}

static void assert_matches(const jet_function *f, const ref_shape *s, const tl_real *c, const ref_jet *result, const ref_jet *size,
                           const double *a, const double *b) {
  const double operand = fmax(largest(a, s->n), f->one ? 0.0 : largest(b, s->n));
  if (!is_finite_jet(c, s->n) && mpfr_largest(result) > LARGEST) return; /* TL_NONFINITE */
  for (int i = 0; i < s->n; i++) {
    const double scale = fabs(mpfr_get_d(result->c[i], MPFR_RNDN)) + mpfr_get_d(size->c[i], MPFR_RNDN);
    if (scale > LARGEST || scale < SMALLEST || scale < operand * SMALLEST_RATIO) continue;
    assert_real_case(c[i], real_from_mpfr(result->c[i]), (tl_real)(bound_of(f->name) * UNIT * scale), __FILE__, __LINE__,
                     "%s(%.17g, %.17g), shape {%d,%d,%d}, coefficient %d", f->name, a[0], f->one ? 0.0 : b[0], s->curve, s->nvar,
                     s->order, i);
  }
}

/* A point where a function is tried; of the samples, each has its own. */
typedef struct point {
  double x, y;
} point;

/* The function at the point, or at points of its domain where there is none. */
static void assert_function(const jet_function *f, tl_spec spec, int samples, const point *at, rng *r) {
  const ref_function *ref = ref_lookup(f->name);
  static ref_shape s;
  static double x[REF_MAX_COEF], y[REF_MAX_COEF];
  ref_shape_init(&s, spec.curve, spec.nvar, spec.order);
  jet_space space;
  jet_space_init(&space, spec, 3);
  tl_real *a = tl_push(&space.cx, 1), *b = tl_push(&space.cx, 1), *c = tl_push(&space.cx, 1);
  ref_jet result = ref_new(&s), size = ref_new(&s);
  for (int k = 0; k < samples; k++) {
    double x0 = at ? at->x : 0.0, y0 = at ? at->y : 0.0;
    if (!at) draw_point(ref, r, &x0, &y0);
    draw_numbers(r, x, s.n, x0, ref->reach(x0, y0));
    draw_numbers(r, y, s.n, y0, f->two ? ref->reach_y(x0, y0) : 0.0);
    ref_apply(ref, &s, &result, &size, x, f->one ? NULL : y);
    copy_numbers(a, x, s.n);
    copy_numbers(b, y, s.n);
    jet_apply(f, &space.cx, c, a, b);
    assert_matches(f, &s, c, &result, &size, x, y);
  }
  ref_free(&result);
  ref_free(&size);
  jet_space_free(&space);
}

static int samples = 6; /* of each function in each shape; the program's argument sets another number */

static void functions_agree_with_mpfr_in_every_shape(void **state) {
  (void)state;
  rng r = {1};
  for (int i = 0; i < njet_functions; i++)
    for (int k = 0; k < NSPEC; k++) assert_function(&jet_functions[i], SPECS[k], samples, NULL, &r);
}

static const jet_function *jet_named(const char *name) {
  for (int i = 0; i < njet_functions; i++)
    if (strcmp(jet_functions[i].name, name) == 0) return &jet_functions[i];
  return NULL;
}

/* Points that random ones hardly meet, or only in one number type. */
static void functions_agree_with_mpfr_at_hard_points(void **state) {
  (void)state;
  const double large_base = 1090.0, least = (TL_MIN_EXP + TL_MANT_DIG - 4) / log2(large_base);
  const struct {
    const char *name;
    point at;
  } points[] = {
      {"lgamma", {8.0 / (double)TL_EPSILON, 0.0}}, /* its last coefficients underflow */
      {"lgamma", {2e8, 0.0}},
      {"lgamma", {1e-9, 0.0}},
      {"powc", {2882.576904296875, 0.99687749147415161}}, /* an exponent near an integer, whose coefficients nearly vanish */
      {"powc", {0.990875601768493, 1.0250952243804932}},
      {"powc", {1.5, 2.0001220703125}},
      {"powc", {1.5, 5.99993896484375}},
      {"powc", {2.5, 0.625}},
      {"powc", {large_base, least}}, /* near the smallest number */
      {"powc", {1.0 / large_base, -least}},
      {"hypot", {0.93737351894378662, -1.6618897914886475}},
  };
  rng r = {12};
  for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
    const point at = {held(points[i].at.x), held(points[i].at.y)};
    for (int k = 0; k < NSPEC; k++) assert_function(jet_named(points[i].name), SPECS[k], 3 * samples, &at, &r);
  }
}

/* exp(n t) by its recurrence, coefficient k = n/k times the one before, to the bit: each weight divides, by no rounded reciprocal. */
static void exponentials_are_divided_by_each_weight_once(void **state) {
  (void)state;
  const tl_spec specs[] = {{7, 0, 0}, {0, 1, 7}, {0, 2, 7}, {7, 1, 1}};
  for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
    jet_space space;
    jet_space_init(&space, specs[i], 1);
    tl_real *a = tl_push(&space.cx, 1);
    for (int n = 1; n <= 20; n++) {
      const int along_s = specs[i].curve > 0;
      tl_const(&space.cx, a, 0.0);
      a[tl_index(&space.shape, along_s, along_s ? NULL : (int[]){1, 0})] = (tl_real)n;
      tl_exp(&space.cx, a, a);
      tl_real expected = 1.0;
      for (int k = 1; k <= 7; k++) {
        expected = expected * (tl_real)n / (tl_real)k;
        assert_real_same(along_s ? tl_coef(&space.shape, a, k, NULL) : tl_coef(&space.shape, a, 0, (int[]){k, 0}), expected);
      }
    }
    jet_space_free(&space);
  }
}

/* Where the condition number is large a formula could lose many digits unseen by the test above, although the argument itself is exact:
 * the first derivative at such points, in ulp. */
static void first_derivatives_keep_their_digits_near_the_ends(void **state) {
  (void)state;
  const tl_real allowed = 4.0;
  const struct {
    const char *name;
    double x[6];
  } cases[] = {
      {"asin", {1 - 0x1p-20, 1 - 0x1p-31, 1 - 0x1.3p-40, -1 + 0x1.7p-45, 1 - 0x1p-53, 1 - 0x1.7p-9}},
      {"acos", {1 - 0x1p-20, 1 - 0x1p-31, 1 - 0x1.3p-40, -1 + 0x1.7p-45, 1 - 0x1p-53, 1 - 0x1.7p-9}},
      {"atanh", {1 - 0x1p-20, 1 - 0x1p-31, 1 - 0x1.3p-40, -1 + 0x1.7p-45, 1 - 0x1p-53, 1 - 0x1.7p-9}},
      {"acosh", {1 + 0x1p-20, 1 + 0x1p-31, 1 + 0x1.3p-40, 1 + 0x1.7p-45, 1 + 0x1p-52, 1 + 0x1.7p-9}},
      {"log1p", {-1 + 0x1p-20, -1 + 0x1p-53, -1 + 0x1.3p-40, -0.5, 1e-20, -1 + 0x1.7p-9}},
      {"tanh", {5.3, -9.7, 18.4, 50.1, -200.3, 339.9}},
      {"erf", {3.3, -5.7, 9.1, 15.3, -20.9, 25.7}},
      {"lgamma", {1.46, 1.4617, -0.504, -0.5041, -1 + 0x1p-30, 1e-20}},
      {"tgamma", {1.46, 1.4617, -0.504, -170.3, -180 + 0x1p-40, -184 - 0x1.8p-44}},
      {"exp", {-700.3, 700.3, 300.7, -30.1, 1e-9, 88.8}},
      {"tan", {1.5707, 1.57079632, 1.5707963267948, 0x1.921fb54442d18p0, -1.5708, 1e22}},
  };
  jet_space space;
  jet_space_init(&space, tl_jacobian(1), 2);
  tl_real *a = tl_push(&space.cx, 1), *c = tl_push(&space.cx, 1);
  mpfr_t exact[4];
  for (int i = 0; i < 4; i++) mpfr_init2(exact[i], REF_PRECISION);
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
    for (int k = 0; k < 6; k++) {
      const double x = cases[i].x[k];
      ref_taylor(ref_lookup(cases[i].name), x, 0.0, 1, exact);
      const tl_real value = real_from_mpfr(exact[0]), slope = real_from_mpfr(exact[2]);
      if (held(x) != x || value - value != 0.0 || slope - slope != 0.0 || TL_LIBM(fabs)(slope) < TL_MIN) continue; /* no such tl_real */
      tl_seed(&space.cx, a, (tl_real)x, 0);
      jet_named(cases[i].name)->one(&space.cx, c, a);
      assert_real_case(c[1], slope, allowed * real_ulp(slope), __FILE__, __LINE__, "%s'(%.17g)", cases[i].name, x);
    }
  for (int i = 0; i < 4; i++) mpfr_clear(exact[i]);
  jet_space_free(&space);
}

/* The value is the C library's to the bit. */
static void values_are_those_of_the_c_library(void **state) {
  (void)state;
  static tl_real (*const library[])(tl_real) = {TL_LIBM(sqrt),  TL_LIBM(cbrt),  TL_LIBM(exp),  TL_LIBM(expm1),  TL_LIBM(exp2),
                                                TL_LIBM(log),   TL_LIBM(log1p), TL_LIBM(log2), TL_LIBM(log10),  TL_LIBM(sin),
                                                TL_LIBM(cos),   TL_LIBM(tan),   TL_LIBM(asin), TL_LIBM(acos),   TL_LIBM(atan),
                                                TL_LIBM(sinh),  TL_LIBM(cosh),  TL_LIBM(tanh), TL_LIBM(asinh),  TL_LIBM(acosh),
                                                TL_LIBM(atanh), TL_LIBM(erf),   TL_LIBM(erfc), TL_LIBM(tgamma), TL_LIBM(lgamma)};
  jet_space space;
  jet_space_init(&space, tl_jacobian(1), 2);
  tl_real *a = tl_push(&space.cx, 1), *c = tl_push(&space.cx, 1);
  rng r = {2};
  for (size_t i = 0; i < sizeof library / sizeof *library; i++)
    for (int k = 0; k < 200; k++) {
      double x, y;
      draw_point(ref_lookup(jet_functions[i].name), &r, &x, &y);
      tl_seed(&space.cx, a, (tl_real)x, 0);
      jet_functions[i].one(&space.cx, c, a);
      if (space.cx.status.bits == TL_OK) assert_real_same(c[0], library[i]((tl_real)x));
      tl_ctx_clear(&space.cx);
    }
  jet_space_free(&space);
}

static void aliased_operands_give_the_same_bits(void **state) {
  (void)state;
  rng r = {3};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 4);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1);
    for (int i = 0; i < njet_functions; i++) {
      const jet_function *f = &jet_functions[i];
      draw_jet(&r, a, n, f->one == tl_acosh ? 1.5 : 0.6, 0.3);
      draw_jet(&r, b, n, 0.7, 0.3);
      jet_apply(f, cx, expected, a, b);
      tl_copy(cx, c, a);
      jet_apply(f, cx, c, c, b);
      assert_jet_same(c, expected, n);
      if (!f->two) continue;
      tl_copy(cx, c, b);
      jet_apply(f, cx, c, a, c);
      assert_jet_same(c, expected, n);
      tl_copy(cx, c, a);
      f->two(cx, expected, a, c);
      f->two(cx, c, c, c);
      assert_jet_same(c, expected, n);
    }
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

static void sine_and_cosine_together_are_those_apart(void **state) {
  (void)state;
  rng r = {4};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 5);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *s = tl_push(cx, 1), *c = tl_push(cx, 1), *s1 = tl_push(cx, 1), *c1 = tl_push(cx, 1);
    draw_jet(&r, a, n, 2.0, 1.0);
    tl_sin(cx, s1, a);
    tl_cos(cx, c1, a);
    for (int alias = 0; alias < 3; alias++) {
      tl_real *x = alias == 0 ? a : alias == 1 ? s : c;
      tl_copy(cx, x, a);
      tl_sincos(cx, s, c, x);
      assert_jet_same(s, s1, n);
      assert_jet_same(c, c1, n);
    }
    jet_space_free(&space);
  }
}

/* Powers with an integer exponent against repeated multiplication of integer jets, also at zero and below: exact. */
static void integer_powers_are_repeated_products(void **state) {
  (void)state;
  const tl_real values[] = {0.0, -2.0, 3.0, 1.0};
  rng r = {5};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 4);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1), *x = tl_push(cx, 1);
    for (int v = 0; v < 4; v++) {
      for (int i = 0; i < n; i++) a[i] = (tl_real)(rng_below(&r, 5) - 2);
      a[0] = values[v];
      tl_const(cx, expected, 1.0);
      for (int power = 0; power <= 7; power++) {
        tl_powi(cx, c, a, power);
        assert_jet_same(c, expected, n);
        tl_powc(cx, c, a, (tl_real)power);
        assert_jet_same(c, expected, n);
        tl_const(cx, x, (tl_real)power);
        tl_pow(cx, c, a, x);
        assert_jet_same(c, expected, n);
        tl_copy(cx, c, a);
        tl_powi(cx, c, c, power);
        assert_jet_same(c, expected, n);
        tl_mul(cx, expected, expected, a);
      }
    }
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

static const tl_real ROUNDINGS = 450.0;

/* a^-n against 1/a^n: a quotient of polynomials with terms up to 1e3 times the result, rounded a few dozen times. */
static void negative_powers_are_reciprocals(void **state) {
  (void)state;
  const tl_real tolerance = ROUNDINGS * TL_EPSILON;
  rng r = {6};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 3);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1);
    for (int power = 1; power <= 4; power++) {
      draw_jet(&r, a, n, power % 2 ? -1.5 : 1.5, 0.5);
      tl_powi(cx, expected, a, power);
      tl_rdiv(cx, expected, 1.0, expected);
      tl_powi(cx, c, a, -power);
      assert_jet_close(c, expected, n, tolerance, tolerance);
    }
    jet_space_free(&space);
  }
}

/* Powers with a constant exponent or base against the general power, which the reference covers. */
static void constant_exponents_and_bases_agree_with_the_general_power(void **state) {
  (void)state;
  const double exponents[] = {0.5, -1.75, 2.5, 3.0000001, 1.0 / 3.0};
  const tl_real tolerance = ROUNDINGS * TL_EPSILON, tiny = TL_EPSILON * TL_EPSILON;
  rng r = {7};
  for (int k = 1; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 4);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1);
    for (int i = 0; i < 5; i++) {
      draw_jet(&r, a, n, 1.3, 0.4);
      tl_const(cx, b, (tl_real)exponents[i]);
      b[n - 1] = tiny; /* a variable exponent, far below the tolerance */
      tl_pow(cx, expected, a, b);
      tl_powc(cx, c, a, (tl_real)exponents[i]);
      assert_jet_close(c, expected, n, tolerance, tolerance);
      draw_jet(&r, b, n, exponents[i], 0.4);
      tl_const(cx, a, TL_C(1.3));
      a[n - 1] = tiny;
      tl_pow(cx, expected, a, b);
      tl_rpow(cx, c, TL_C(1.3), b);
      assert_jet_close(c, expected, n, tolerance, tolerance);
    }
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

/* x^2.5 at an even power of two: the value underflows to 0, the derivatives 2.5 x^1.5 and 1.875 x^0.5 do not. */
static void powers_keep_derivatives_that_outlive_the_value(void **state) {
  (void)state;
  const int e = TL_MIN_EXP * 29 / 100 * 2;
  const tl_real tolerance = 4 * TL_EPSILON; /* pow and two products */
  jet_space space;
  jet_space_init(&space, tl_hessian(1), 1);
  tl_real *a = tl_push(&space.cx, 1);
  tl_seed(&space.cx, a, real_power_of_two(e), 0);
  tl_powc(&space.cx, a, a, 2.5);
  assert_real_same(a[0], 0.0);
  assert_real_close(a[1], TL_C(2.5) * real_power_of_two(e / 2 * 3), tolerance, 0.0);
  assert_real_close(a[2], TL_C(1.875) * real_power_of_two(e / 2), tolerance, 0.0);
  jet_space_free(&space);
}

/* Length and angle at both ends of the range of numbers: those of arguments scaled to about 1, scaled back; 4 ulp for hypot's own. */
static void lengths_and_angles_scale_with_powers_of_two(void **state) {
  (void)state;
  const tl_real tolerance = 4 * TL_EPSILON, scales[] = {real_power_of_two(TL_MAX_EXP - 24), real_power_of_two(24 - TL_MAX_EXP)};
  rng r = {9};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 4);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1);
    for (int i = 0; i < 2; i++) {
      draw_jet(&r, a, n, -1.5, 0.5);
      draw_jet(&r, b, n, 0.7, 0.5);
      tl_hypot(cx, expected, a, b);
      tl_scale(cx, a, a, scales[i]);
      tl_scale(cx, b, b, scales[i]);
      tl_hypot(cx, c, a, b);
      tl_scale(cx, c, c, TL_C(1.0) / scales[i]);
      assert_jet_close(c, expected, n, tolerance, tolerance);
      tl_atan2(cx, expected, a, b);
      tl_scale(cx, a, a, TL_C(1.0) / scales[i]);
      tl_scale(cx, b, b, TL_C(1.0) / scales[i]);
      tl_atan2(cx, c, a, b);
      assert_jet_close(c, expected, n, tolerance, tolerance);
    }
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

/* Beside a subnormal x, hypot(x+h, y+g) = y + g + (x+h)^2/(2 (y+g)) - ..: the coefficients of h g^j are (-1)^j x y^(-j-1), subnormal
 * too and right to the last place. */
static void short_sides_keep_their_digits(void **state) {
  (void)state;
  enum { ORDER = 6 };
  jet_space space;
  jet_space_init(&space, tl_complete(2, ORDER), 3);
  tl_real *a = tl_push(&space.cx, 1), *b = tl_push(&space.cx, 1), *c = tl_push(&space.cx, 1);
  const tl_real unit = TL_MIN * TL_EPSILON, x = -100000 * unit, y = TL_C(-1.75);
  tl_seed(&space.cx, a, x, 0);
  tl_seed(&space.cx, b, y, 1);
  tl_hypot(&space.cx, c, a, b);
  tl_real expected = -x / unit;
  for (int j = 0; j < ORDER; j++) {
    expected = -expected / (j == 0 ? -y : y);
    assert_real_close(tl_coef(&space.shape, c, 0, (int[]){1, j}) / unit, expected, 0, 1);
  }
  assert_int_equal(space.cx.status.bits, TL_OK);
  jet_space_free(&space);
}

/* The angle keeps its derivatives across the cut of atan2, where only the value jumps. */
static void atan2_has_derivatives_on_its_cut(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_hessian(2), 3);
  tl_ctx *cx = &space.cx;
  tl_real *x = tl_push(cx, 1), *y = tl_push(cx, 1), *c = tl_push(cx, 1);
  for (int side = 0; side < 2; side++) {
    tl_seed(cx, x, -2.0, 0);
    tl_seed(cx, y, side ? -TL_C(0.0) : TL_C(0.0), 1);
    tl_atan2(cx, c, y, x);
    const tl_real pi = TL_C(3.14159265358979323846264338327950288), expected[] = {side ? -pi : pi, 0.0, -0.5, 0.0, -0.25, 0.0};
    assert_jet_same(c, expected, 6);
  }
  jet_space_free(&space);
}

static void kinked_functions_follow_the_value(void **state) {
  (void)state;
  rng r = {8};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 5);
    tl_ctx *cx = &space.cx;
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1), *minus = tl_push(cx, 1), *x = tl_push(cx, 1);
    draw_jet(&r, a, n, 2.0, 1.0);
    draw_jet(&r, b, n, -3.0, 1.0);
    tl_neg(cx, minus, a);
#define SAME(call, expected)                                                                                                           \
  call;                                                                                                                                \
  assert_jet_same(c, expected, n)
    SAME(tl_fabs(cx, c, a), a);
    SAME(tl_fabs(cx, c, minus), a);
    SAME(tl_fmin(cx, c, a, b), b);
    SAME(tl_fmin(cx, c, b, a), b);
    SAME(tl_fmax(cx, c, a, b), a);
    SAME(tl_fmax(cx, c, b, a), a);
    tl_sub(cx, x, a, b);
    SAME(tl_fdim(cx, c, a, b), x);
    SAME(tl_copy(cx, c, b); tl_fdim(cx, c, a, c), x);
    tl_const(cx, x, 0.0);
    SAME(tl_fdim(cx, c, b, a), x);
    SAME(tl_copy(cx, c, a); tl_fdim(cx, c, a, c), x); /* a tie of equal jets */
    SAME(tl_copysign(cx, c, a, b), minus);
    SAME(tl_copysign(cx, c, minus, b), minus);
    SAME(tl_copysign(cx, c, minus, a), a);
    tl_copy(cx, x, a);
    SAME(tl_fmin(cx, c, a, x), a); /* a tie of equal jets */
    SAME(tl_copy(cx, c, b); tl_copysign(cx, c, a, c), minus);
    SAME(tl_copy(cx, c, b); tl_fmax(cx, c, a, c), a);
#undef SAME
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

int main(int argc, char **argv) {
  samples = test_tries(argc > 1 ? atoi(argv[1]) : samples);
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(functions_agree_with_mpfr_in_every_shape),
      cmocka_unit_test(functions_agree_with_mpfr_at_hard_points),
      cmocka_unit_test(exponentials_are_divided_by_each_weight_once),
      cmocka_unit_test(first_derivatives_keep_their_digits_near_the_ends),
      cmocka_unit_test(values_are_those_of_the_c_library),
      cmocka_unit_test(aliased_operands_give_the_same_bits),
      cmocka_unit_test(sine_and_cosine_together_are_those_apart),
      cmocka_unit_test(integer_powers_are_repeated_products),
      cmocka_unit_test(negative_powers_are_reciprocals),
      cmocka_unit_test(constant_exponents_and_bases_agree_with_the_general_power),
      cmocka_unit_test(powers_keep_derivatives_that_outlive_the_value),
      cmocka_unit_test(lengths_and_angles_scale_with_powers_of_two),
      cmocka_unit_test(short_sides_keep_their_digits),
      cmocka_unit_test(atan2_has_derivatives_on_its_cut),
      cmocka_unit_test(kinked_functions_follow_the_value),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
