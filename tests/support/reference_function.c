/* Taylor coefficients of the elementary functions by differences in very high precision. */
#include "reference_series.h"

#include <assert.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Distances to the nearest complex singularity. */
static double everywhere(double x, double y) { return (void)x, (void)y, 1.0; }
static double to_zero(double x, double y) { return (void)y, fabs(x); }
static double y_to_zero(double x, double y) { return (void)x, fabs(y); }
static double to_minus_one(double x, double y) { return (void)y, 1.0 + x; }
static double to_ends(double x, double y) { return (void)y, 1.0 - fabs(x); }
static double to_one(double x, double y) { return (void)y, x - 1.0; }
static double to_i(double x, double y) { return (void)y, fmax(1.0, fabs(x)); }
static double to_pole(double x, double y) { return (void)y, fabs(cos(x)); }
static double to_origin(double x, double y) { return fmax(fabs(x), fabs(y)); }
/* For atan2(x, y), whose cut x = 0, y < 0 the differences must not cross. */
static double to_cut(double x, double y) { return y < 0.0 && fabs(x) < 0x1p-90 * fabs(y) ? 0.0 : to_origin(x, y); }
/* To the nearest of 0, -1, -2, .. */
static double to_gamma_pole(double x, double y) { return (void)y, x >= 0.0 ? x : fmin(fabs(x - round(x)), fabs(x)); }
static double gamma_width(double x, double y) { return fmin(to_gamma_pole(x, y), 1.0 / (1.0 + log(1.0 + fabs(x)))); }
/* To the nearest multiple of y at which fmod jumps, and to the nearest halfway point at which remainder does. */
static double to_multiple(double x, double y) {
  const double r = fmod(fabs(x), fabs(y)), above = fabs(y) - r;
  return fabs(x) < fabs(y) ? above : fmin(r, above);
}
static double to_halfway(double x, double y) { return 0.5 * fabs(y) - fabs(remainder(x, y)); }
static double y_to_multiple(double x, double y) { return to_multiple(x, y) / (1.0 + fabs(x / y)); }
static double y_to_halfway(double x, double y) { return to_halfway(x, y) / (1.0 + fabs(x / y)); }
static double gauss_width(double x, double y) { return (void)y, 1.0 / fmax(1.0, fabs(x)); }
static double exponent_width(double x, double y) { return (void)y, 1.0 / (1.0 + fabs(log(x))); }

/* Bits between the value and the much smaller derivatives. */
static double tanh_bits(double x, double y) { return (void)y, 3.0 * fabs(x); }
static double expm1_bits(double x, double y) { return (void)y, x < 0.0 ? -1.5 * x : 0.0; }
static double erf_bits(double x, double y) { return (void)y, 1.5 * x * x; }

/* The constant exponent y of x, or 0 where a negative x has no such power. */
static double exponent_of_sign(double x, double y) { return x > 0.0 || y == floor(y) ? 1.0 : 0.0; }
static double base_of_power(double x, double y) { return (void)x, fmax(y, 0.0); }

/* y^x. */
static int power_of_y(mpfr_t f, const mpfr_t x, const mpfr_t y, mpfr_rnd_t rounding) { return mpfr_pow(f, y, x, rounding); }

/* log|gamma|, whatever the sign of gamma. */
static int log_gamma(mpfr_t f, const mpfr_t x, mpfr_rnd_t rounding) {
  int sign;
  return mpfr_lgamma(f, &sign, x, rounding);
}

#define END ((double)NAN)
#define EITHER(lo, hi) {0.0, 0, lo, hi}
#define ABOVE(anchor, lo, hi) {anchor, 1, lo, hi}
#define BELOW(anchor, lo, hi) {anchor, -1, lo, hi}
#define AROUND(anchor, lo, hi) {anchor, 0, lo, hi}
#define PI 3.14159265358979323846

const ref_function ref_functions[] = {
    {.name = "sqrt",
     .one = mpfr_sqrt,
     .reach = to_zero,
     .x = {ABOVE(0, -1021, 1023), ABOVE(0, -8, 8)},
     .hard = {1, 4, 0x1p-1022, 0x1.fffffffffffffp1023, END}},
    {.name = "cbrt",
     .one = mpfr_cbrt,
     .reach = to_zero,
     .x = {EITHER(-1021, 1023), EITHER(-8, 8)},
     .hard = {1, -8, 27, 0x1p-1022, 0x1.fffffffffffffp1023, END}},
    {.name = "exp", .one = mpfr_exp, .reach = everywhere, .x = {EITHER(-60, 9.4), EITHER(-3, 3)}, .hard = {0, 709.5, -700, 1, END}},
    {.name = "expm1",
     .one = mpfr_expm1,
     .reach = everywhere,
     .digits = expm1_bits,
     .x = {EITHER(-1000, 9.4), EITHER(-3, 3)},
     .hard = {0, 709.5, -700, 1e-300, -1e-17, END}},
    {.name = "exp2", .one = mpfr_exp2, .reach = everywhere, .x = {EITHER(-60, 9.9), EITHER(-3, 3)}, .hard = {0, 1023.5, -1000, 1, END}},
    {.name = "log",
     .one = mpfr_log,
     .reach = to_zero,
     .x = {ABOVE(0, -1021, 1023), ABOVE(0, -8, 8), AROUND(1, -52, -1)},
     .hard = {1, 0x1p-1022, 0x1.fffffffffffffp1023, END}},
    {.name = "log1p",
     .one = mpfr_log1p,
     .reach = to_minus_one,
     .x = {ABOVE(0, -1021, 1023), AROUND(0, -60, -1), ABOVE(-1, -52, 0)},
     .hard = {0, -0.5, 1e-300, -1e-17, 0x1.fffffffffffffp1023, END}},
    {.name = "log2",
     .one = mpfr_log2,
     .reach = to_zero,
     .x = {ABOVE(0, -1021, 1023), ABOVE(0, -8, 8), AROUND(1, -52, -1)},
     .hard = {1, 2, 0x1p-1022, 0x1.fffffffffffffp1023, END}},
    {.name = "log10",
     .one = mpfr_log10,
     .reach = to_zero,
     .x = {ABOVE(0, -1021, 1023), ABOVE(0, -8, 8), AROUND(1, -52, -1)},
     .hard = {1, 10, 0x1p-1022, 0x1.fffffffffffffp1023, END}},
    {.name = "sin",
     .one = mpfr_sin,
     .reach = everywhere,
     .x = {EITHER(-1000, 1000), EITHER(-8, 8), AROUND(PI, -50, 0)},
     .hard = {0, PI, PI / 2, 1e22, 1e300, 1e-300, END}},
    {.name = "cos",
     .one = mpfr_cos,
     .reach = everywhere,
     .x = {EITHER(-1000, 1000), EITHER(-8, 8), AROUND(PI / 2, -50, 0)},
     .hard = {0, PI, PI / 2, 1e22, 1e300, 1e-300, END}},
    {.name = "tan",
     .one = mpfr_tan,
     .reach = to_pole,
     .x = {EITHER(-1000, 1000), EITHER(-8, 4), AROUND(PI / 2, -50, 0)},
     .hard = {0, PI, PI / 2, 1e22, 1e300, 1e-300, END}},
    {.name = "asin",
     .one = mpfr_asin,
     .reach = to_ends,
     .x = {EITHER(-1000, -1), BELOW(1, -52, 0), ABOVE(-1, -52, 0)},
     .hard = {0, 0.5, 0x1.fffffffffffffp-1, 1e-300, END}},
    {.name = "acos",
     .one = mpfr_acos,
     .reach = to_ends,
     .x = {EITHER(-1000, -1), BELOW(1, -52, 0), ABOVE(-1, -52, 0)},
     .hard = {0, 0.5, 0x1.fffffffffffffp-1, 1e-300, END}},
    {.name = "atan",
     .one = mpfr_atan,
     .reach = to_i,
     .x = {EITHER(-1000, 1000), EITHER(-8, 8)},
     .hard = {0, 1, -1, 1e-300, 1e300, 0x1.fffffffffffffp1023, END}},
    {.name = "sinh",
     .one = mpfr_sinh,
     .reach = everywhere,
     .x = {EITHER(-1000, 9.4), EITHER(-3, 3)},
     .hard = {0, 1e-300, 710, -710, END}},
    {.name = "cosh",
     .one = mpfr_cosh,
     .reach = everywhere,
     .x = {EITHER(-1000, 9.4), EITHER(-3, 3)},
     .hard = {0, 1e-300, 710, -710, END}},
    {.name = "tanh",
     .one = mpfr_tanh,
     .reach = everywhere,
     .digits = tanh_bits,
     .x = {EITHER(-1000, 8.4), EITHER(-3, 3)},
     .hard = {0, 1e-300, 20, 340, END}},
    {.name = "asinh",
     .one = mpfr_asinh,
     .reach = to_i,
     .x = {EITHER(-1000, 1000), EITHER(-8, 8)},
     .hard = {0, 1, 1e-300, 1e300, 0x1.fffffffffffffp1023, END}},
    {.name = "acosh",
     .one = mpfr_acosh,
     .reach = to_one,
     .x = {ABOVE(1, -52, 1000), ABOVE(1, -8, 8)},
     .hard = {0x1.0000000000001p0, 1.5, 2, 1e300, 0x1.fffffffffffffp1023, END}},
    {.name = "atanh",
     .one = mpfr_atanh,
     .reach = to_ends,
     .x = {EITHER(-1000, -1), BELOW(1, -52, 0), ABOVE(-1, -52, 0)},
     .hard = {0, 0.5, 0x1.fffffffffffffp-1, 1e-300, END}},
    {.name = "erf",
     .one = mpfr_erf,
     .reach = gauss_width,
     .digits = erf_bits,
     .x = {EITHER(-1000, 4.7), EITHER(-3, 3)},
     .hard = {0, 1e-300, 6, 26, END}},
    {.name = "erfc",
     .one = mpfr_erfc,
     .reach = gauss_width,
     .digits = erf_bits,
     .x = {EITHER(-1000, 4.7), EITHER(-3, 3)},
     .hard = {0, 1e-300, 6, 26, END}},
    {.name = "tgamma",
     .one = mpfr_gamma,
     .reach = gamma_width,
     .x = {ABOVE(0, -50, 7.4), EITHER(-3, 5), AROUND(-3, -40, -1), AROUND(1.4616321449683622, -40, -2)},
     .hard = {1, 2, 0.5, 170.5, -170.5, -177.3, -183.99999999999, -190.0000000001, -1.5, 1e-40, -1e-40, END}},
    {.name = "lgamma",
     .one = log_gamma,
     .reach = to_gamma_pole,
     .x = {ABOVE(0, -50, 100), EITHER(-3, 10), AROUND(-3, -40, -1), AROUND(1.4616321449683622, -40, -2)},
     .hard = {1, 2, 0.5, 16, 17, 1e300, -1000.5, -1e6 - 0.1, -1e-40, -0.5, -2.4570247382208006, END}},
    {.name = "fmod",
     .two = mpfr_fmod,
     .reach = to_multiple,
     .reach_y = y_to_multiple,
     .x = {EITHER(-30, 30), EITHER(-2, 4)},
     .y = {EITHER(-15, 15), EITHER(-2, 2)},
     .hard = {0, 1, END}},
    {.name = "remainder",
     .two = mpfr_remainder,
     .reach = to_halfway,
     .reach_y = y_to_halfway,
     .x = {EITHER(-30, 30), EITHER(-2, 4)},
     .y = {EITHER(-15, 15), EITHER(-2, 2)},
     .hard = {0, 1, END}},
    {.name = "mul",
     .two = mpfr_mul,
     .reach = everywhere,
     .reach_y = everywhere,
     .x = {EITHER(-200, 200), EITHER(-2, 2)},
     .y = {EITHER(-200, 200), EITHER(-2, 2)},
     .hard = {0, 1, END}},
    {.name = "div",
     .two = mpfr_div,
     .reach = everywhere,
     .reach_y = y_to_zero,
     .x = {EITHER(-100, 100), EITHER(-2, 2)},
     .y = {EITHER(-100, 100), EITHER(-2, 2)},
     .hard = {0, 1, END}},
    {.name = "pow",
     .two = mpfr_pow,
     .reach = to_zero,
     .reach_y = exponent_width,
     .x = {ABOVE(0, -100, 100), ABOVE(0, -2, 2)},
     .y = {EITHER(-20, 2), EITHER(-2, 2)},
     .hard = {1, 2, END}},
    {.name = "powc",
     .two = mpfr_pow,
     .reach = to_zero,
     .reach_y = exponent_of_sign,
     .x = {EITHER(-100, 100), EITHER(-2, 2)},
     .y = {EITHER(-20, 2), EITHER(-2, 6)},
     .hard = {1, 2, -1, END},
     .nhard_y = 13,
     .hard_y = {-3, -2, -1, -0.5, 1.0 / 3.0, 0.5, 2.0 / 3.0, 1, 1.5, 2, 3, 7, 40}},
    {.name = "rpow",
     .two = power_of_y,
     .reach = everywhere,
     .reach_y = base_of_power,
     .x = {EITHER(-20, 2), EITHER(-2, 8)},
     .y = {ABOVE(0, -20, 20), ABOVE(0, -2, 2), AROUND(1, -52, -1)},
     .hard = {1, 2, -1, 0, 0.5, END},
     .nhard_y = 4,
     .hard_y = {2, 10, 0.5, 1}},
    {.name = "hypot",
     .two = mpfr_hypot,
     .reach = to_origin,
     .reach_y = to_origin,
     .x = {EITHER(-100, 100), EITHER(-8, 8)},
     .y = {EITHER(-100, 100), EITHER(-8, 8)},
     .hard = {1, -3, 0x1p100, END}},
    {.name = "atan2",
     .two = mpfr_atan2,
     .reach = to_cut,
     .reach_y = to_origin,
     .x = {EITHER(-100, 100), EITHER(-8, 8)},
     .y = {EITHER(-100, 100), EITHER(-8, 8)},
     .hard = {1, -3, 0x1p100, END}},
};
const int ref_nfunctions = (int)(sizeof ref_functions / sizeof *ref_functions);

const ref_function *ref_lookup(const char *name) {
  for (int i = 0; i < ref_nfunctions; i++)
    if (strcmp(ref_functions[i].name, name) == 0) return &ref_functions[i];
  return NULL;
}

static double draw_from(const ref_region *region, rng *r) {
  int n = 0;
  while (n < 4 && region[n].lo < region[n].hi) n++;
  if (n == 0) return 0.0;
  region += rng_below(r, n);
  const double side = region->side ? (double)region->side : rng_sign(r);
  return region->anchor + side * rng_exponent(r, region->lo, region->hi);
}

void ref_draw(const ref_function *f, rng *r, double *x, double *y) {
  int n = 0;
  while (!isnan(f->hard[n])) n++;
  do { /* rounding may put a point on a singularity */
    *x = rng_below(r, 16) == 0 ? f->hard[rng_below(r, n)] : draw_from(f->x, r);
    *y = f->nhard_y > 0 && rng_below(r, 4) == 0 ? f->hard_y[rng_below(r, f->nhard_y)] : draw_from(f->y, r);
  } while (!(f->reach(*x, *y) > 0.0) || (f->two && !(f->reach_y(*x, *y) > 0.0)));
}

/* Where mpfr_lgamma and mpfr_gamma would take too long. */
static const double FAR_LEFT = -4000.0;

static int has_value(const ref_function *f, double x, double y) {
  mpfr_t at, at_y, value;
  if (!(f->reach(x, y) > 0.0) || (f->two && !(f->reach_y(x, y) > 0.0))) return 0;
  if ((f->one == mpfr_gamma || f->one == log_gamma) && x < FAR_LEFT) return 0;
  mpfr_inits2(64, at, at_y, value, (mpfr_ptr)0);
  mpfr_set_d(at, x, MPFR_RNDN);
  mpfr_set_d(at_y, y, MPFR_RNDN);
  if (f->one)
    f->one(value, at, MPFR_RNDN);
  else
    f->two(value, at, at_y, MPFR_RNDN);
  const int has = mpfr_number_p(value) != 0;
  mpfr_clears(at, at_y, value, (mpfr_ptr)0);
  return has;
}

void ref_draw_anywhere(const ref_function *f, rng *r, double *x, double *y) {
  do {
    *x = rng_sign(r) * rng_exponent(r, -1074.0, 1024.0);
    *y = f->two ? rng_sign(r) * rng_exponent(r, -1074.0, 1024.0) : 0.0;
  } while (!has_value(f, *x, *y));
}

/* Differences on the nodes -n..n times the step: coefficient k of the interpolating polynomial is
 * step^-k sum_j value_j weight[j][k], weight[j] the coefficients of the Lagrange polynomial prod_{i != j} (u - i)/(j - i). Its error is
 * of relative size (step/reach)^2, far below the last bit of a double. */
enum { MAX_NODES = 4, NVALUE = 2 * MAX_NODES + 1, STEP_BITS = 100, GUARD_BITS = 400, NOISE_BITS = 60, TRUNCATION_BITS = 450 };

/* n: the interpolation's degree 2n is above that of the coefficients. */
static int nodes_for(int degree) { return degree < MAX_NODES * 2 - 1 ? MAX_NODES - 1 : MAX_NODES; }

static void lagrange(int nodes, int j, long *numerator, long *denominator) {
  memset(numerator, 0, NVALUE * sizeof *numerator);
  numerator[0] = *denominator = 1;
  for (int i = -nodes, degree = 0; i <= nodes; i++) {
    if (i == j) continue;
    degree++;
    for (int k = degree; k >= 0; k--) numerator[k] = (k > 0 ? numerator[k - 1] : 0) - i * numerator[k];
    *denominator *= j - i;
  }
}

/* c[k] = coefficient k of the polynomial through value[], for step 2^step. A coefficient that is nothing but the values' rounding, of
 * size 2^noise each, is zero. */
static void interpolate(mpfr_t *c, int degree, mpfr_t *value, long step, long noise, mpfr_prec_t precision) {
  long numerator[NVALUE], denominator;
  const int nodes = nodes_for(degree);
  mpfr_t term;
  mpfr_init2(term, precision);
  for (int k = 0; k <= degree; k++) mpfr_set_zero(c[k], 1);
  for (int j = 0; j <= 2 * nodes; j++) {
    lagrange(nodes, j - nodes, numerator, &denominator);
    for (int k = 0; k <= degree; k++) {
      mpfr_mul_si(term, value[j], numerator[k], MPFR_RNDN);
      mpfr_div_si(term, term, denominator, MPFR_RNDN);
      mpfr_add(c[k], c[k], term, MPFR_RNDN);
    }
  }
  for (int k = 0; k <= degree; k++) {
    if (!mpfr_zero_p(c[k]) && mpfr_get_exp(c[k]) < noise + NOISE_BITS) mpfr_set_zero(c[k], 1);
    mpfr_mul_2si(c[k], c[k], -k * step, MPFR_RNDN);
  }
  mpfr_clear(term);
}

/* Exponent of the rounding of values as large as the largest of these. */
static long noise_of(mpfr_t *value, int nodes, mpfr_prec_t precision) {
  long largest = LONG_MIN / 2;
  for (int j = 0; j <= 2 * nodes; j++)
    if (!mpfr_zero_p(value[j]) && mpfr_get_exp(value[j]) > largest) largest = mpfr_get_exp(value[j]);
  return largest - precision;
}

static long exponent_of(double x) { return x == 0.0 ? 0 : ilogb(x); }
static long step_of(double reach) { return exponent_of(reach) - STEP_BITS; }

/* Bits so that the highest difference keeps GUARD_BITS: powers of the step, and the distance in size between argument and reach. */
static mpfr_prec_t precision_for(double x, double reach, double extra) {
  return (mpfr_prec_t)((NVALUE + 1) * STEP_BITS + GUARD_BITS + labs(exponent_of(x)) + labs(exponent_of(x) - exponent_of(reach)) +
                       (long)extra);
}

static void init_all(mpfr_t *v, int n, mpfr_prec_t precision) {
  for (int i = 0; i < n; i++) mpfr_init2(v[i], precision);
}

static void clear_all(mpfr_t *v, int n) {
  for (int i = 0; i < n; i++) mpfr_clear(v[i]);
}

static void node(mpfr_t at, double x, int j, long step) {
  mpfr_set_si_2exp(at, j, step, MPFR_RNDN);
  mpfr_add_d(at, at, x, MPFR_RNDN);
}

static void taylor_one(const ref_function *function, double x, int degree, mpfr_t *f) {
  const double reach = function->reach(x, 0.0), extra = function->digits ? function->digits(x, 0.0) : 0.0;
  const long step = step_of(reach);
  const int nodes = nodes_for(degree);
  const mpfr_prec_t precision = precision_for(x, reach, extra);
  mpfr_t at, value[NVALUE], c[NVALUE];
  mpfr_init2(at, precision);
  init_all(value, NVALUE, precision);
  init_all(c, NVALUE, precision);
  for (int j = 0; j <= 2 * nodes; j++) {
    node(at, x, j - nodes, step);
    function->one(value[j], at, MPFR_RNDN);
  }
  interpolate(c, degree, value, step, noise_of(value, nodes, precision), precision);
  for (int i = 0; i <= degree; i++)
    for (int j = 0; j <= degree; j++) mpfr_set_zero(f[i * (degree + 1) + j], 1);
  for (int i = 0; i <= degree; i++) mpfr_set(f[i * (degree + 1)], c[i], MPFR_RNDN);
  clear_all(c, NVALUE);
  clear_all(value, NVALUE);
  mpfr_clear(at);
}

/* Drops coefficients that are nothing but the differences' own error, (step/reach)^6 relative to the largest, all taken times powers of
 * the reaches. This drops true coefficients that small too: do not ask for such. */
static void drop_truncation(mpfr_t *f, int degree, long reach, long reach_y) {
  const int n = degree + 1;
  long largest = LONG_MIN / 2;
  for (int pass = 0; pass < 2; pass++)
    for (int i = 0; i < n; i++)
      for (int j = 0; j < n; j++) {
        if (mpfr_zero_p(f[i * n + j])) continue;
        const long size = mpfr_get_exp(f[i * n + j]) + i * reach + j * reach_y;
        if (pass == 0 && size > largest) largest = size;
        if (pass == 1 && size < largest - TRUNCATION_BITS) mpfr_set_zero(f[i * n + j], 1);
      }
}

static void taylor_two(const ref_function *function, double x, double y, int degree, mpfr_t *f) {
  const double reach = function->reach(x, y), reach_y = function->reach_y(x, y);
  const long step = step_of(reach), step_y = step_of(reach_y);
  const int nodes = nodes_for(degree);
  const mpfr_prec_t precision = precision_for(x, reach, 0.0) + precision_for(y, reach_y, 0.0);
  mpfr_t at, at_y, value[NVALUE], along_y[NVALUE][NVALUE], c[NVALUE];
  mpfr_inits2(precision, at, at_y, (mpfr_ptr)0);
  init_all(value, NVALUE, precision);
  init_all(c, NVALUE, precision);
  long noise = LONG_MIN / 2;
  for (int i = 0; i <= 2 * nodes; i++) { /* along_y[i][l]: coefficient l in y at node i of x */
    init_all(along_y[i], NVALUE, precision);
    node(at, x, i - nodes, step);
    for (int j = 0; j <= 2 * nodes; j++) {
      node(at_y, y, j - nodes, step_y);
      function->two(value[j], at, at_y, MPFR_RNDN);
    }
    const long here = noise_of(value, nodes, precision);
    if (here > noise) noise = here;
    interpolate(along_y[i], degree, value, step_y, here, precision);
  }
  for (int l = 0; l <= degree; l++) {
    for (int i = 0; i <= 2 * nodes; i++) mpfr_set(value[i], along_y[i][l], MPFR_RNDN);
    interpolate(c, degree, value, step, noise - l * step_y, precision);
    for (int i = 0; i <= degree; i++) mpfr_set(f[i * (degree + 1) + l], c[i], MPFR_RNDN);
  }
  drop_truncation(f, degree, step + STEP_BITS, step_y + STEP_BITS);
  for (int i = 0; i <= 2 * nodes; i++) clear_all(along_y[i], NVALUE);
  clear_all(c, NVALUE);
  clear_all(value, NVALUE);
  mpfr_clears(at, at_y, (mpfr_ptr)0);
}

void ref_taylor(const ref_function *function, double x, double y, int degree, mpfr_t *f) {
  assert(degree <= REF_MAX_DEGREE);
  if (function->one)
    taylor_one(function, x, degree, f);
  else
    taylor_two(function, x, y, degree, f);
}

/* The coefficients of df/dx (variable 0) or df/dy (1) from those of f. */
static void differentiate(mpfr_t *d, mpfr_t *f, int degree, int variable) {
  const int n = degree + 1;
  for (int i = 0; i <= degree; i++)
    for (int j = 0; j <= degree; j++) {
      const int up = variable == 0 ? i + 1 : j + 1;
      const int from = variable == 0 ? (i + 1) * n + j : i * n + j + 1;
      if (i + j < degree)
        mpfr_mul_si(d[i * n + j], f[from], up, MPFR_RNDN);
      else
        mpfr_set_zero(d[i * n + j], 1);
    }
}

void ref_apply(const ref_function *function, const ref_shape *s, ref_jet *result, ref_jet *size, const double *a, const double *b) {
  enum { N = (REF_MAX_DEGREE + 1) * (REF_MAX_DEGREE + 1) };
  const int degree = s->degree + 1; /* one more, for the derivatives */
  mpfr_t f[N], d[N];
  ref_jet x = ref_new(s), y = ref_new(s), slope = ref_new(s);
  init_all(f, N, REF_PRECISION);
  init_all(d, N, REF_PRECISION);
  ref_set(&x, a);
  if (b) ref_set(&y, b);
  ref_series(function, a[0], b ? b[0] : 0.0, degree, f);
  ref_compose2(s, result, &x, &y, f, degree);
  for (int i = 0; i < size->n; i++) mpfr_set_zero(size->c[i], 1);
  differentiate(d, f, degree, 0);
  ref_compose2(s, &slope, &x, &y, d, degree);
  ref_add_sensitivity(s, size, &x, &slope);
  if (b) {
    differentiate(d, f, degree, 1);
    ref_compose2(s, &slope, &x, &y, d, degree);
    ref_add_sensitivity(s, size, &y, &slope);
  }
  clear_all(f, N);
  clear_all(d, N);
  ref_free(&x);
  ref_free(&y);
  ref_free(&slope);
}
