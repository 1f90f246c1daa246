/* What each function reports at the ends of its domain and just beside them, and that no number that is not finite leaves unreported.
 */
#include "close_real.h"
#include "functions.h"
#include "random.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The smallest number of all, the neighbours of 1, the largest number with a finite exponential, and about the largest with a finite
 * factorial. */
#define DENORMAL (TL_MIN * TL_EPSILON)
#define ABOVE_ONE (1 + TL_EPSILON)
#define BELOW_ONE (1 - TL_EPSILON / 2)
#if TL_MAX_EXP < 1024
static const tl_real LOG_MAX = TL_C(0x1.62e42ep6), GAMMA_MAX = 34;
#elif TL_MAX_EXP == 1024
static const tl_real LOG_MAX = TL_C(0x1.62e42fefa39efp9), GAMMA_MAX = 171;
#elif TL_MANT_DIG == 64
static const tl_real LOG_MAX = TL_C(0x1.62e42fefa39ef356p13), GAMMA_MAX = 1754;
#else
static const tl_real LOG_MAX = TL_C(0x1.62e42fefa39ef35793c7673007e5p13), GAMMA_MAX = 1754;
#endif

/* A function of jets, its operands' values, and the status in a shape of degree 0 and in one of order 1 with both values seeded. */
typedef void operation(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
typedef struct boundary {
  operation *f;
  tl_fn function;
  tl_real x, y;
  unsigned value_bits, jet_bits;
} boundary;

#define OPERATION(name)                                                                                                                \
  static void on_##name(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {                                                  \
    (void)b;                                                                                                                           \
    tl_##name(cx, c, a);                                                                                                               \
  }
/* clang-format off */
OPERATION(sqrt) OPERATION(cbrt) OPERATION(exp) OPERATION(expm1) OPERATION(exp2) OPERATION(log) OPERATION(log1p) OPERATION(log2)
OPERATION(log10) OPERATION(sin) OPERATION(cos) OPERATION(tan) OPERATION(asin) OPERATION(acos) OPERATION(atan) OPERATION(sinh)
OPERATION(cosh) OPERATION(tanh) OPERATION(asinh) OPERATION(acosh) OPERATION(atanh) OPERATION(erf) OPERATION(fabs)
OPERATION(erfc) OPERATION(tgamma) OPERATION(lgamma) OPERATION(floor) OPERATION(ceil) OPERATION(trunc) OPERATION(round) OPERATION(rint)
OPERATION(float)
    /* clang-format on */

    static void on_powc(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  tl_powc(cx, c, a, b[0]);
}
static void on_powi(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  tl_powi(cx, c, a, (int)TL_LIBM(fmax)(-99, TL_LIBM(fmin)(99, b[0])));
}
static void on_scalbn(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  tl_scalbn(cx, c, a, (int)TL_LIBM(fmax)(-99999, TL_LIBM(fmin)(99999, b[0])));
}
static void on_rpow(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { tl_rpow(cx, c, a[0], b); }
static void on_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) { tl_fma(cx, c, a, b, a); }
static void on_sincos(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  tl_real *sine = tl_push(cx, 1);
  (void)b;
  tl_sincos(cx, sine, c, a);
  tl_pop(cx, 1);
}

enum { OK = TL_OK, D = TL_DOMAIN, S = TL_SINGULAR, N = TL_NONFINITE };

#define AT(name, x, value, jet) {on_##name, TL_FN_##name, x, 0.0, value, jet}
#define AT2(name, x, y, value, jet) {tl_##name, TL_FN_##name, x, y, value, jet}
#define AT_N(name, x, y, value, jet) {on_##name, TL_FN_##name, x, y, value, jet}
#define POWER(name, x, y, value, jet) {on_##name, TL_FN_pow, x, y, value, jet}

static int all_finite(const tl_real *c, int n) {
  for (int i = 0; i < n; i++)
    if (!TL_ISFINITE(c[i])) return 0;
  return 1;
}

/* True where the operation reports these bits, with its name and line, and numbers exactly where it reports nothing. */
static int reports(const boundary *at, tl_spec spec, unsigned bits) {
  jet_space space;
  jet_space_init(&space, spec, 4);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  tl_seed(cx, a, at->x, 0);
  tl_seed(cx, b, at->y, 1);
  cx->line = 42;
  at->f(cx, c, a, b);
  const int as_told = cx->status.function == (bits ? at->function : TL_FN_none) && cx->status.line == (bits ? 42 : 0);
  const int right = cx->status.bits == bits && as_told && (bits == TL_OK) == all_finite(c, space.shape.ncoef);
  if (!right)
    print_error("%s(%.17g, %.17g), degree %d: status %u in %s, expected %u; value %g\n", tl_fn_name(at->function), (double)at->x,
                (double)at->y, space.shape.degree, cx->status.bits, tl_fn_name(cx->status.function), bits, (double)c[0]);
  jet_space_free(&space);
  return right;
}

static void the_ends_of_each_domain_are_exact(void **state) {
  (void)state;
  const boundary boundaries[] = {
      AT(sqrt, 0.0, OK, S),
      AT(sqrt, -0.0, OK, S),
      AT(sqrt, DENORMAL, OK, OK),
      AT(sqrt, -DENORMAL, D, D),
      AT(sqrt, TL_MAX, OK, OK),
      AT(cbrt, 0.0, OK, S),
      AT(cbrt, DENORMAL, OK, OK),
      AT(cbrt, -DENORMAL, OK, OK),
      AT(cbrt, -TL_MAX, OK, OK),
      AT(exp, LOG_MAX, OK, OK),
      AT(exp, LOG_MAX + 1, N, N),
      AT(exp, -TL_MAX, OK, OK),
      AT(expm1, LOG_MAX, OK, OK),
      AT(expm1, LOG_MAX + 1, N, N),
      AT(expm1, -TL_MAX, OK, OK),
      AT(expm1, 0.0, OK, OK),
      AT(exp2, TL_MAX_EXP * BELOW_ONE, OK, OK),
      AT(exp2, TL_MAX_EXP, N, N),
      AT(exp2, -TL_MAX, OK, OK),
      AT(log, 0.0, D, D),
      AT(log, -0.0, D, D),
      AT(log, -DENORMAL, D, D),
      AT(log, DENORMAL, OK, N),
      AT(log, TL_MIN, OK, OK),
      AT(log, TL_MAX, OK, OK),
      AT(log1p, -1.0, D, D),
      AT(log1p, -ABOVE_ONE, D, D),
      AT(log1p, -BELOW_ONE, OK, OK),
      AT(log1p, TL_MAX, OK, OK),
      AT(log1p, 0.0, OK, OK),
      AT(log2, 0.0, D, D),
      AT(log2, -DENORMAL, D, D),
      AT(log2, DENORMAL, OK, N),
      AT(log2, TL_MIN, OK, OK),
      AT(log10, 0.0, D, D),
      AT(log10, -DENORMAL, D, D),
      AT(log10, DENORMAL, OK, N),
      AT(log10, TL_MIN, OK, OK),
      AT(sin, TL_MAX, OK, OK),
      AT(cos, TL_MAX, OK, OK),
      AT(tan, TL_MAX, OK, OK),
      AT(tan, TL_C(1.57079632679489661923132169163975144), OK, OK),
      AT(asin, 1.0, OK, S),
      AT(asin, -1.0, OK, S),
      AT(asin, BELOW_ONE, OK, OK),
      AT(asin, ABOVE_ONE, D, D),
      AT(asin, -ABOVE_ONE, D, D),
      AT(asin, TL_MAX, D, D),
      AT(acos, 1.0, OK, S),
      AT(acos, -1.0, OK, S),
      AT(acos, BELOW_ONE, OK, OK),
      AT(acos, ABOVE_ONE, D, D),
      AT(acos, -ABOVE_ONE, D, D),
      AT(acos, -TL_MAX, D, D),
      AT(atan, TL_MAX, OK, OK),
      AT(atan, -TL_MAX, OK, OK),
      AT(asinh, TL_MAX, OK, OK),
      AT(asinh, -TL_MAX, OK, OK),
      AT(sinh, LOG_MAX + TL_C(0.25), OK, OK),
      AT(sinh, LOG_MAX + 1, N, N),
      AT(sinh, -LOG_MAX - 1, N, N),
      AT(cosh, LOG_MAX + TL_C(0.25), OK, OK),
      AT(cosh, -LOG_MAX - 1, N, N),
      AT(tanh, TL_MAX, OK, OK),
      AT(tanh, -TL_MAX, OK, OK),
      AT(erf, TL_MAX, OK, OK),
      AT(erf, -TL_MAX, OK, OK),
      AT(erfc, TL_MAX, OK, OK),
      AT(erfc, -TL_MAX, OK, OK),
      AT(tgamma, 0.0, D, D),
      AT(tgamma, -0.0, D, D),
      AT(tgamma, DENORMAL, N, N),
      AT(tgamma, real_power_of_two(TL_MIN_EXP / 2 + 3), OK, OK),
      AT(tgamma, real_power_of_two(TL_MIN_EXP / 2 - 20), OK, N),
      AT(tgamma, -1.0, D, D),
      AT(tgamma, -ABOVE_ONE, OK, OK),
      AT(tgamma, -BELOW_ONE, OK, OK),
      AT(tgamma, -TL_MAX, D, D),
      AT(tgamma, -1000.5, OK, OK),
      AT(tgamma, -184.0, D, D),
      AT(tgamma, GAMMA_MAX, OK, OK),
      AT(tgamma, GAMMA_MAX + 2, N, N),
      AT(lgamma, 0.0, D, D),
      AT(lgamma, -0.0, D, D),
      AT(lgamma, DENORMAL, OK, N),
      AT(lgamma, -DENORMAL, OK, N),
      AT(lgamma, 4 * TL_MIN, OK, OK),
      AT(lgamma, -1.0, D, D),
      AT(lgamma, -ABOVE_ONE, OK, OK),
      AT(lgamma, -BELOW_ONE, OK, OK),
      AT(lgamma, -1 / TL_EPSILON, D, D),
      AT(lgamma, -1 / TL_EPSILON + TL_C(0.5), OK, OK),
      AT(lgamma, 1.0, OK, OK),
      AT(lgamma, 2.0, OK, OK),
      AT(lgamma, TL_MAX / (LOG_MAX + 10), OK, OK),
      AT(lgamma, TL_MAX, N, N),
      AT(floor, 3.0, OK, S),
      AT(floor, -0.0, OK, S),
      AT(floor, DENORMAL, OK, OK),
      AT(floor, -DENORMAL, OK, OK),
      AT(ceil, 3.0, OK, S),
      AT(ceil, 0.0, OK, S),
      AT(trunc, 0.0, OK, OK),
      AT(trunc, 1.0, OK, S),
      AT(trunc, -BELOW_ONE, OK, OK),
      AT(round, 0.5, OK, S),
      AT(round, TL_C(0.5) - TL_EPSILON / 4, OK, OK),
      AT(round, 1.0, OK, OK),
      AT(rint, -2.5, OK, S),
      AT(rint, 0.0, OK, OK),
      AT(float, (tl_real)FLT_MAX, OK, OK),
      AT(float, TL_MAX, TL_REAL == TL_FLOAT ? OK : N, TL_REAL == TL_FLOAT ? OK : N),
      AT(float, DENORMAL, OK, OK),
      AT_N(scalbn, TL_MAX, 0.0, OK, OK),
      AT_N(scalbn, 1.0, TL_MAX_EXP - 1, OK, OK),
      AT_N(scalbn, 1.0, TL_MAX_EXP, N, N),
      AT_N(scalbn, DENORMAL, TL_MAX_EXP + 1, OK, N),
      AT_N(scalbn, 1.0, -99999, OK, OK),
      AT2(fmod, 5.0, 0.0, D, D),
      AT2(fmod, 0.0, -0.0, D, D),
      AT2(fmod, 0.0, 5.0, OK, OK),
      AT2(fmod, 6.0, 3.0, OK, S),
      AT2(fmod, -6.0, 3.0, OK, S),
      AT2(fmod, 3.0, DENORMAL, OK, S),
      AT2(fmod, DENORMAL, TL_MAX, OK, OK),
      AT2(remainder, 5.0, 0.0, D, D),
      AT2(remainder, 6.0, 3.0, OK, OK),
      AT2(remainder, 4.5, 3.0, OK, S),
      AT2(remainder, -1.5, 3.0, OK, S),
      AT2(remainder, DENORMAL, 2 * DENORMAL, OK, S),
      AT2(remainder, TL_MAX, TL_C(0.7) * TL_MAX, OK, OK),
      AT2(remainder, TL_MAX, TL_MAX, OK, OK),
      AT2(fdim, 1.0, 1.0, OK, S),
      AT2(fdim, ABOVE_ONE, 1.0, OK, OK),
      AT2(fdim, BELOW_ONE, 1.0, OK, OK),
      AT2(fdim, 0.0, -0.0, OK, S),
      AT2(fdim, TL_MAX, -TL_MAX, N, N),
      AT2(fdim, -TL_MAX, TL_MAX, OK, OK),
      AT(acosh, 1.0, OK, S),
      AT(acosh, ABOVE_ONE, OK, OK),
      AT(acosh, BELOW_ONE, D, D),
      AT(acosh, -2.0, D, D),
      AT(acosh, TL_MAX, OK, OK),
      AT(atanh, 1.0, D, D),
      AT(atanh, -1.0, D, D),
      AT(atanh, BELOW_ONE, OK, OK),
      AT(atanh, -BELOW_ONE, OK, OK),
      AT(atanh, ABOVE_ONE, D, D),
      AT(atanh, TL_MAX, D, D),
      AT(fabs, 0.0, OK, S),
      AT(fabs, -0.0, OK, S),
      AT(fabs, DENORMAL, OK, OK),
      AT(fabs, -DENORMAL, OK, OK),
      AT2(div, 1.0, 0.0, D, D),
      AT2(div, 0.0, 0.0, D, D),
      AT2(div, 1.0, -0.0, D, D),
      AT2(div, TL_MAX, 0.5, N, N),
      AT2(div, 0.0, DENORMAL, OK, N),
      AT2(div, TL_MAX, TL_MAX, OK, OK),
      AT2(hypot, 0.0, 0.0, OK, S),
      AT2(hypot, 0.0, DENORMAL, OK, OK),
      AT2(hypot, DENORMAL, DENORMAL, OK, OK),
      AT2(hypot, TL_MAX / 2, TL_MAX / 2, OK, OK),
      AT2(hypot, TL_MAX, TL_MAX, N, N),
      AT2(atan2, 0.0, 0.0, OK, S),
      AT2(atan2, -0.0, -0.0, OK, S),
      AT2(atan2, 0.0, -1.0, OK, OK),
      AT2(atan2, DENORMAL, 0.0, OK, N),
      AT2(atan2, TL_MIN, TL_MIN, OK, OK),
      AT2(atan2, TL_MAX, -TL_MAX, OK, OK),
      AT2(fmin, 1.0, 1.0, OK, S),
      AT2(fmin, 1.0, ABOVE_ONE, OK, OK),
      AT2(fmin, 0.0, -0.0, OK, S),
      AT2(fmax, 1.0, 1.0, OK, S),
      AT2(fmax, BELOW_ONE, 1.0, OK, OK),
      AT2(copysign, 0.0, 1.0, OK, S),
      AT2(copysign, 1.0, 0.0, OK, S),
      AT2(copysign, 1.0, -0.0, OK, S),
      AT2(copysign, -DENORMAL, DENORMAL, OK, OK),
      AT2(pow, 0.0, 0.0, OK, S),
      AT2(pow, 0.0, 1.0, OK, S),
      AT2(pow, 0.0, 2.0, OK, OK),
      AT2(pow, 0.0, -1.0, D, D),
      AT2(pow, -1.0, 2.0, OK, S),
      AT2(pow, -1.0, 0.5, D, D),
      AT2(pow, TL_MIN, 1.0, OK, OK),
      AT2(pow, 1.0, TL_MAX, OK, OK),
      AT2(pow, TL_MAX, 2.0, N, N),
      POWER(powc, 0.0, 0.0, OK, OK),
      POWER(powc, 0.0, 0.5, OK, S),
      POWER(powc, 0.0, BELOW_ONE, OK, S),
      POWER(powc, 0.0, 1.0, OK, OK),
      POWER(powc, 0.0, ABOVE_ONE, OK, OK),
      POWER(powc, 0.0, -1.0, D, D),
      POWER(powc, 0.0, -0.5, D, D),
      POWER(powc, -1.0, 0.5, D, D),
      POWER(powc, -1.0, 3.0, OK, OK),
      POWER(powc, -1.0, -3.0, OK, OK),
      POWER(powc, -1.0, TL_MAX / 16, OK, OK),
      POWER(powc, 2.0, TL_MAX_EXP, N, N),
      POWER(powc, TL_MAX, -TL_MAX, OK, OK),
      POWER(powi, 0.0, 0, OK, OK),
      POWER(powi, 0.0, 1, OK, OK),
      POWER(powi, 0.0, 99, OK, OK),
      POWER(powi, 0.0, -1, D, D),
      POWER(powi, -0.0, -2, D, D),
      POWER(powi, DENORMAL, -1, N, N),
      POWER(rpow, 0.0, 0.0, OK, S),
      POWER(rpow, 0.0, DENORMAL, OK, OK),
      POWER(rpow, 0.0, -1.0, D, D),
      POWER(rpow, -1.0, 2.0, OK, S),
      POWER(rpow, -1.0, 0.5, D, D),
      POWER(rpow, 2.0, TL_MAX_EXP, N, N),
      POWER(rpow, 1.0, TL_MAX, OK, OK),
  };
  int wrong = 0;
  for (size_t i = 0; i < sizeof boundaries / sizeof *boundaries; i++) {
    wrong += !reports(&boundaries[i], tl_complete(2, 0), boundaries[i].value_bits);
    wrong += !reports(&boundaries[i], tl_jacobian(2), boundaries[i].jet_bits);
  }
  assert_int_equal(wrong, 0);
}

static operation *const OPERATIONS[] = {
    on_sqrt,  on_cbrt, on_exp,   on_expm1,  on_exp2, on_log,       on_log1p,  on_log2,   on_log10,    on_sin,   on_cos,
    on_tan,   on_asin, on_acos,  on_atan,   on_sinh, on_cosh,      on_tanh,   on_asinh,  on_acosh,    on_atanh, on_erf,
    on_fabs,  tl_pow,  tl_hypot, tl_atan2,  tl_div,  tl_mul,       tl_fmin,   tl_fmax,   tl_copysign, on_fma,   on_sincos,
    on_powc,  on_powi, on_rpow,  tl_add,    tl_sub,  on_erfc,      on_tgamma, on_lgamma, on_floor,    on_ceil,  on_trunc,
    on_round, on_rint, on_float, on_scalbn, tl_fmod, tl_remainder, tl_fdim,
};
enum { NOPERATION = sizeof OPERATIONS / sizeof *OPERATIONS };

/* The operation at (x,y) in a shape of this degree reports an operand that is not finite. */
static int reports_operand(operation *f, int degree, tl_real x, tl_real y) {
  jet_space space;
  jet_space_init(&space, tl_univariate(degree), 4);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  for (int i = 1; i <= degree; i++) a[i] = b[i] = 1;
  a[0] = x;
  b[0] = y;
  f(cx, c, a, b);
  const int reported = (cx->status.bits & TL_NONFINITE) != 0;
  jet_space_free(&space);
  return reported;
}

/* A value that is not finite is reported, whatever the function makes of it, and on each of its ways. */
static void operands_that_are_not_finite_are_reported(void **state) {
  (void)state;
  static operation *const of_two[] = {tl_pow, tl_hypot, tl_atan2,     tl_div,  tl_mul, tl_fmin, tl_fmax, tl_copysign,
                                      tl_add, tl_fmod,  tl_remainder, tl_fdim, tl_sub, on_powc, on_rpow, on_fma};
  const tl_real wild[] = {(tl_real)INFINITY, -(tl_real)INFINITY, (tl_real)NAN};
  for (int k = 0; k < 3; k++)
    for (int degree = 1; degree <= 7; degree += 6) {
      for (int i = 0; i < NOPERATION; i++) { /* the exponent of two of them is an int */
        const int whole = OPERATIONS[i] == on_powi || OPERATIONS[i] == on_scalbn;
        if (!reports_operand(OPERATIONS[i], degree, wild[k], whole ? 2 : wild[k])) fail_msg("operation %d at %g", i, (double)wild[k]);
      }
      for (size_t i = 0; i < sizeof of_two / sizeof *of_two; i++) {
        if (!reports_operand(of_two[i], degree, wild[k], 2)) fail_msg("operation %zu of two at (%g, 2)", i, (double)wild[k]);
        if (!reports_operand(of_two[i], degree, 2, wild[k])) fail_msg("operation %zu of two at (2, %g)", i, (double)wild[k]);
      }
    }
}

/* Numbers of every kind: any bits of a double, ends of the range, any exponent, small integers, ordinary. */
static tl_real draw_wild(rng *r) {
  const tl_real special[] = {0,
                             -TL_C(0.0),
                             1,
                             -1,
                             TL_MAX,
                             -TL_MAX,
                             TL_MIN,
                             DENORMAL,
                             TL_C(0.5),
                             2,
                             real_power_of_two(TL_MIN_EXP / 2 - 20),
                             real_power_of_two(TL_MAX_EXP / 2 + 20),
                             -real_power_of_two(TL_MAX_EXP / 2 + 20),
                             TL_EPSILON / 16,
                             LOG_MAX - TL_C(0.7),
                             -LOG_MAX * TL_C(1.05)};
  const uint64_t bits = rng_bits(r);
  double x;
  switch (rng_below(r, 8)) {
  case 0:
    memcpy(&x, &bits, sizeof x);
    return (tl_real)x;
  case 1:
  case 2:
    return special[rng_below(r, sizeof special / sizeof *special)];
  case 3:
    return (tl_real)(rng_sign(r) * rng_uniform(r, 1.0, 2.0)) *
           real_power_of_two(rng_below(r, TL_MAX_EXP - TL_MIN_EXP + TL_MANT_DIG) + TL_MIN_EXP - TL_MANT_DIG);
  default:
    return (tl_real)rng_uniform(r, -3.0, 3.0);
  }
}

static void nothing_wild_leaves_with_status_ok(void **state) {
  (void)state;
  const int samples = 3000;
  const tl_spec specs[] = {{0, 1, 0}, {0, 1, 1}, {0, 2, 3}, {4, 0, 0}, {1, 2, 2}};
  int accepted = 0;
  for (size_t k = 0; k < sizeof specs / sizeof *specs; k++) {
    jet_space space;
    jet_space_init(&space, specs[k], 4);
    tl_ctx *cx = &space.cx;
    rng r = {k};
    const int n = space.shape.ncoef;
    tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
    for (int j = 0; j < samples; j++) {
      for (int i = 0; i < n; i++) {
        a[i] = i == 0 || j % 2 ? draw_wild(&r) : (tl_real)rng_uniform(&r, -1.0, 1.0);
        b[i] = i == 0 || j % 2 ? draw_wild(&r) : 0;
      }
      tl_ctx_clear(cx);
      const int which = rng_below(&r, NOPERATION);
      OPERATIONS[which](cx, c, a, b);
      if (cx->status.bits == TL_OK && !all_finite(c, n))
        fail_msg("operation %d at (%.17g, %.17g), shape %zu", which, (double)a[0], (double)b[0], k);
      if (cx->status.bits != TL_OK && cx->status.function == TL_FN_none) fail_msg("operation %d fails without a name", which);
      accepted += cx->status.bits == TL_OK;
    }
    jet_space_free(&space);
  }
  assert_true(accepted > samples); /* of five times as many: the fuzz reaches results too */
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(the_ends_of_each_domain_are_exact),
      cmocka_unit_test(operands_that_are_not_finite_are_reported),
      cmocka_unit_test(nothing_wild_leaves_with_status_ok),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
