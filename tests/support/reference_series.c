/* Taylor coefficients of the elementary functions by their differential equations and closed forms in high precision. */
#include "reference_series.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { NCOEF = REF_MAX_DEGREE + 1 };

/* Numbers at work, all of one precision. c: the coefficients, x: the argument, g: those of another series, t and u: for a moment. */
typedef struct work {
  int degree;
  mpfr_prec_t precision;
  mpfr_t c[NCOEF], g[NCOEF], x, t, u;
} work;

static void work_init(work *w, double x, int degree, mpfr_prec_t precision) {
  w->degree = degree;
  w->precision = precision;
  for (int k = 0; k < NCOEF; k++) mpfr_inits2(precision, w->c[k], w->g[k], (mpfr_ptr)0);
  mpfr_inits2(precision, w->x, w->t, w->u, (mpfr_ptr)0);
  mpfr_set_d(w->x, x, MPFR_RNDN);
}

static void work_free(work *w) {
  for (int k = 0; k < NCOEF; k++) mpfr_clears(w->c[k], w->g[k], (mpfr_ptr)0);
  mpfr_clears(w->x, w->t, w->u, (mpfr_ptr)0);
}

/* c_k of a power p/q from c_0: k q x c_k = (p - (k-1) q) c_(k-1). */
static void power(work *w, long p, long q) {
  for (int k = 1; k <= w->degree; k++) {
    mpfr_mul_si(w->c[k], w->c[k - 1], p - (k - 1) * q, MPFR_RNDN);
    mpfr_div(w->c[k], w->c[k], w->x, MPFR_RNDN);
    mpfr_div_si(w->c[k], w->c[k], k * q, MPFR_RNDN);
  }
}

static void square_root(work *w) { mpfr_sqrt(w->c[0], w->x, MPFR_RNDN), power(w, 1, 2); }
static void cube_root(work *w) { mpfr_cbrt(w->c[0], w->x, MPFR_RNDN), power(w, 1, 3); }

/* c_k = rate c_(k-1)/k. */
static void exponential(work *w, mpfr_srcptr rate) {
  for (int k = 1; k <= w->degree; k++) {
    if (rate)
      mpfr_mul(w->c[k], w->c[k - 1], rate, MPFR_RNDN);
    else
      mpfr_set(w->c[k], w->c[k - 1], MPFR_RNDN);
    mpfr_div_si(w->c[k], w->c[k], k, MPFR_RNDN);
  }
}

static void exp_series(work *w) { mpfr_exp(w->c[0], w->x, MPFR_RNDN), exponential(w, NULL); }
static void expm1_series(work *w) { exp_series(w), mpfr_expm1(w->c[0], w->x, MPFR_RNDN); }
static void exp2_series(work *w) {
  mpfr_exp2(w->c[0], w->x, MPFR_RNDN);
  mpfr_const_log2(w->t, MPFR_RNDN);
  exponential(w, w->t);
}

/* c_k = (-1)^(k-1)/(k x^k log base), base 0 standing for e. Takes x out of w->x. */
static void logarithm(work *w, unsigned base) {
  mpfr_set_ui(w->t, 1, MPFR_RNDN);
  if (base) mpfr_log_ui(w->u, base, MPFR_RNDN), mpfr_div(w->t, w->t, w->u, MPFR_RNDN);
  for (int k = 1; k <= w->degree; k++) {
    mpfr_div(w->t, w->t, w->x, MPFR_RNDN);
    mpfr_div_si(w->c[k], w->t, k % 2 ? k : -k, MPFR_RNDN);
  }
}

static void log_series(work *w) { mpfr_log(w->c[0], w->x, MPFR_RNDN), logarithm(w, 0); }
static void log2_series(work *w) { mpfr_log2(w->c[0], w->x, MPFR_RNDN), logarithm(w, 2); }
static void log10_series(work *w) { mpfr_log10(w->c[0], w->x, MPFR_RNDN), logarithm(w, 10); }
static void log1p_series(work *w) {
  mpfr_log1p(w->c[0], w->x, MPFR_RNDN);
  mpfr_add_ui(w->x, w->x, 1, MPFR_RNDN);
  logarithm(w, 0);
}

/* c_k (k-1) k = sign c_(k-2) from c_0 and c_1. */
static void oscillator(work *w, int sign) {
  for (int k = 2; k <= w->degree; k++) mpfr_div_si(w->c[k], w->c[k - 2], sign * k * (k - 1), MPFR_RNDN);
}

static void sine(work *w) { mpfr_sin_cos(w->c[0], w->c[1], w->x, MPFR_RNDN), oscillator(w, -1); }
static void cosine(work *w) {
  mpfr_sin_cos(w->c[1], w->c[0], w->x, MPFR_RNDN);
  mpfr_neg(w->c[1], w->c[1], MPFR_RNDN);
  oscillator(w, -1);
}
static void hyperbolic_sine(work *w) { mpfr_sinh_cosh(w->c[0], w->c[1], w->x, MPFR_RNDN), oscillator(w, 1); }
static void hyperbolic_cosine(work *w) { mpfr_sinh_cosh(w->c[1], w->c[0], w->x, MPFR_RNDN), oscillator(w, 1); }

/* c' = g, g' = 2 sign c g, from c_0 and g_0. */
static void tangent_series(work *w, int sign) {
  for (int k = 1; k <= w->degree; k++) {
    mpfr_div_si(w->c[k], w->g[k - 1], k, MPFR_RNDN);
    mpfr_set_zero(w->g[k], 1);
    for (int i = 0; i < k; i++) mpfr_fma(w->g[k], w->c[i], w->g[k - 1 - i], w->g[k], MPFR_RNDN);
    mpfr_mul_si(w->g[k], w->g[k], 2 * sign, MPFR_RNDN);
    mpfr_div_si(w->g[k], w->g[k], k, MPFR_RNDN);
  }
}

static void tangent(work *w) {
  mpfr_tan(w->c[0], w->x, MPFR_RNDN);
  mpfr_sec(w->g[0], w->x, MPFR_RNDN);
  mpfr_sqr(w->g[0], w->g[0], MPFR_RNDN);
  tangent_series(w, 1);
}
static void hyperbolic_tangent(work *w) {
  mpfr_tanh(w->c[0], w->x, MPFR_RNDN);
  mpfr_sech(w->g[0], w->x, MPFR_RNDN);
  mpfr_sqr(w->g[0], w->g[0], MPFR_RNDN);
  tangent_series(w, -1);
}

/* c' = g from g. */
static void integrate(work *w) {
  for (int k = 1; k <= w->degree; k++) mpfr_div_si(w->c[k], w->g[k - 1], k, MPFR_RNDN);
}

/* c' = g = outer (constant + square x^2)^-1 or ^-1/2, by d g' = p d' g. The sum is a product where it is a difference. */
static void inverse(work *w, int constant, int square, int root, int outer) {
  if (constant == square) {
    mpfr_sqr(w->t, w->x, MPFR_RNDN);
    mpfr_add_ui(w->t, w->t, 1, MPFR_RNDN);
  } else {
    mpfr_ui_sub(w->t, 1, w->x, MPFR_RNDN);
    mpfr_add_ui(w->u, w->x, 1, MPFR_RNDN);
    mpfr_mul(w->t, w->t, w->u, MPFR_RNDN);
    mpfr_mul_si(w->t, w->t, constant, MPFR_RNDN);
  }
  mpfr_ui_div(w->g[0], 1, w->t, MPFR_RNDN);
  if (root) mpfr_sqrt(w->g[0], w->g[0], MPFR_RNDN);
  mpfr_mul_si(w->g[0], w->g[0], outer, MPFR_RNDN);
  const int q = root ? 1 : 2;           /* -p in halves */
  for (int k = 1; k < w->degree; k++) { /* k d_0 g_k = (p - k + 1) d_1 g_(k-1) + (2 p - k + 2) d_2 g_(k-2) */
    mpfr_mul(w->g[k], w->g[k - 1], w->x, MPFR_RNDN);
    mpfr_mul_si(w->g[k], w->g[k], (2 - q - 2 * k) * square, MPFR_RNDN);
    if (k > 1) {
      mpfr_mul_si(w->u, w->g[k - 2], (2 - q - k) * square, MPFR_RNDN);
      mpfr_add(w->g[k], w->g[k], w->u, MPFR_RNDN);
    }
    mpfr_div(w->g[k], w->g[k], w->t, MPFR_RNDN);
    mpfr_div_si(w->g[k], w->g[k], k, MPFR_RNDN);
  }
  integrate(w);
}

static void arc_sine(work *w) { mpfr_asin(w->c[0], w->x, MPFR_RNDN), inverse(w, 1, -1, 1, 1); }
static void arc_cosine(work *w) { mpfr_acos(w->c[0], w->x, MPFR_RNDN), inverse(w, 1, -1, 1, -1); }
static void arc_tangent(work *w) { mpfr_atan(w->c[0], w->x, MPFR_RNDN), inverse(w, 1, 1, 0, 1); }
static void area_sine(work *w) { mpfr_asinh(w->c[0], w->x, MPFR_RNDN), inverse(w, 1, 1, 1, 1); }
static void area_cosine(work *w) { mpfr_acosh(w->c[0], w->x, MPFR_RNDN), inverse(w, -1, 1, 1, 1); }
static void area_tangent(work *w) { mpfr_atanh(w->c[0], w->x, MPFR_RNDN), inverse(w, 1, -1, 0, 1); }

/* c' = g = rate 2/sqrt(pi) exp(-x^2), g' = -2 x g. */
static void gauss_integral(work *w, int rate) {
  mpfr_sqr(w->t, w->x, MPFR_RNDN);
  mpfr_neg(w->t, w->t, MPFR_RNDN);
  mpfr_exp(w->g[0], w->t, MPFR_RNDN);
  mpfr_const_pi(w->t, MPFR_RNDN);
  mpfr_sqrt(w->t, w->t, MPFR_RNDN);
  mpfr_div(w->g[0], w->g[0], w->t, MPFR_RNDN);
  mpfr_mul_si(w->g[0], w->g[0], 2 * rate, MPFR_RNDN);
  for (int k = 1; k < w->degree; k++) {
    mpfr_mul(w->g[k], w->g[k - 1], w->x, MPFR_RNDN);
    if (k > 1) mpfr_add(w->g[k], w->g[k], w->g[k - 2], MPFR_RNDN);
    mpfr_mul_si(w->g[k], w->g[k], -2, MPFR_RNDN);
    mpfr_div_si(w->g[k], w->g[k], k, MPFR_RNDN);
  }
  integrate(w);
}

static void error_function(work *w) { mpfr_erf(w->c[0], w->x, MPFR_RNDN), gauss_integral(w, 1); }
static void error_complement(work *w) { mpfr_erfc(w->c[0], w->x, MPFR_RNDN), gauss_integral(w, -1); }

/* g_k = sum_{n>=0} (x+n)^-k, k = 2..degree, by Euler and Maclaurin's sum from X = x+n >= FAR on:
 *     sum_{n<N} (x+n)^-k + X^(1-k)/(k-1) + X^-k/2 + sum_j B_2j/(2j)! k (k+1) .. (k+2j-2) X^(1-k-2j).
 * The first term left out is below 2^-229 of the sum. B_2j/(2j)! = (-1)^(j+1) 2 zeta(2j)/(2 pi)^2j. */
enum { FAR = 40, NTERM = 36, GAMMA_PRECISION = 280 };

/* zeta(2j), j = 1..NTERM; computed once. */
static mpfr_srcptr even_zeta(int j) {
  static mpfr_t value[NTERM + 1];
  static int known = 0;
  for (; known < NTERM; known++) {
    mpfr_init2(value[known + 1], REF_PRECISION);
    mpfr_zeta_ui(value[known + 1], 2 * (unsigned long)(known + 1), MPFR_RNDN);
  }
  return value[j];
}

static void zeta_tail(work *w, int k) {
  mpfr_t term, square;
  mpfr_inits2(w->precision, term, square, (mpfr_ptr)0);
  mpfr_pow_si(term, w->x, -k, MPFR_RNDN);
  mpfr_div_ui(w->u, term, 2, MPFR_RNDN);
  mpfr_add(w->g[k], w->g[k], w->u, MPFR_RNDN);
  mpfr_mul(w->u, term, w->x, MPFR_RNDN);
  mpfr_div_si(w->u, w->u, k - 1, MPFR_RNDN);
  mpfr_add(w->g[k], w->g[k], w->u, MPFR_RNDN);
  mpfr_mul_si(term, term, 2 * k, MPFR_RNDN);
  mpfr_div(term, term, w->x, MPFR_RNDN);
  mpfr_const_pi(square, MPFR_RNDN);
  mpfr_mul_ui(square, square, 2, MPFR_RNDN);
  mpfr_sqr(square, square, MPFR_RNDN);
  mpfr_div(term, term, square, MPFR_RNDN);
  mpfr_mul(square, square, w->x, MPFR_RNDN);
  mpfr_mul(square, square, w->x, MPFR_RNDN);
  mpfr_ui_div(square, 1, square, MPFR_RNDN);
  for (int j = 1; j <= NTERM; j++) { /* term = 2 (-1)^(j+1) k .. (k+2j-2) X^(1-k-2j)/(2 pi)^2j */
    mpfr_fma(w->g[k], even_zeta(j), term, w->g[k], MPFR_RNDN);
    mpfr_mul_si(term, term, -(k + 2 * j - 1) * (k + 2 * j), MPFR_RNDN);
    mpfr_mul(term, term, square, MPFR_RNDN);
  }
  mpfr_clears(term, square, (mpfr_ptr)0);
}

/* c_k, k >= 1, of log|Gamma|: psi(x), then (-1)^k zeta(k,x)/k. */
static void log_gamma_series(work *w) {
  mpfr_digamma(w->c[1], w->x, MPFR_RNDN);
  for (int k = 2; k <= w->degree; k++) mpfr_set_zero(w->g[k], 1);
  for (; mpfr_cmp_ui(w->x, FAR) < 0; mpfr_add_ui(w->x, w->x, 1, MPFR_RNDN)) {
    mpfr_ui_div(w->t, 1, w->x, MPFR_RNDN);
    mpfr_set(w->u, w->t, MPFR_RNDN);
    for (int k = 2; k <= w->degree; k++) {
      mpfr_mul(w->u, w->u, w->t, MPFR_RNDN);
      mpfr_add(w->g[k], w->g[k], w->u, MPFR_RNDN);
    }
  }
  for (int k = 2; k <= w->degree; k++) {
    zeta_tail(w, k);
    mpfr_div_si(w->c[k], w->g[k], k % 2 ? -k : k, MPFR_RNDN);
  }
}

static void log_gamma(work *w) {
  int sign;
  mpfr_lgamma(w->c[0], &sign, w->x, MPFR_RNDN);
  log_gamma_series(w);
}

/* Gamma = Gamma(x) g, k g_k = sum_{j=1..k} j c_j g_(k-j). */
static void gamma_series(work *w) {
  mpfr_gamma(w->c[0], w->x, MPFR_RNDN);
  log_gamma_series(w);
  mpfr_set_ui(w->g[0], 1, MPFR_RNDN);
  for (int k = 1; k <= w->degree; k++) {
    mpfr_set_zero(w->g[k], 1);
    for (int j = 1; j <= k; j++) {
      mpfr_mul_si(w->t, w->c[j], j, MPFR_RNDN);
      mpfr_fma(w->g[k], w->t, w->g[k - j], w->g[k], MPFR_RNDN);
    }
    mpfr_div_si(w->g[k], w->g[k], k, MPFR_RNDN);
  }
  for (int k = 1; k <= w->degree; k++) mpfr_mul(w->c[k], w->g[k], w->c[0], MPFR_RNDN);
}

/* Functions of (x,y): coefficient of h^i g^j at f[i*n + j], n = degree + 1; all zero at first. w->c and w->g serve as one likes. */
static void product(work *w, double y, mpfr_t *f) {
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_mul(f[0], w->x, w->t, MPFR_RNDN);
  if (w->degree < 1) return;
  mpfr_set(f[1], w->x, MPFR_RNDN);
  mpfr_set(f[w->degree + 1], w->t, MPFR_RNDN);
  if (w->degree > 1) mpfr_set_ui(f[w->degree + 2], 1, MPFR_RNDN);
}

/* (x+h)/(y+g) = (x+h) sum_j (-g)^j/y^(j+1). */
static void quotient(work *w, double y, mpfr_t *f) {
  mpfr_set_ui(w->t, 1, MPFR_RNDN);
  for (int j = 0; j <= w->degree; j++) {
    mpfr_div_d(w->t, w->t, y, MPFR_RNDN);
    mpfr_mul(f[j], w->x, w->t, MPFR_RNDN);
    if (j < w->degree) mpfr_set(f[w->degree + 1 + j], w->t, MPFR_RNDN);
    mpfr_neg(w->t, w->t, MPFR_RNDN);
  }
}

/* w->g[k] = coefficient of g^k of binomial(y+g, i) x^-i, k <= i: from i-1 to i times (y - i + 1 + g)/(i x). */
static void next_binomial(work *w, double y, int i) {
  mpfr_set_zero(w->g[i], 1);
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_sub_si(w->t, w->t, i - 1, MPFR_RNDN);
  for (int k = i; k >= 0; k--) {
    mpfr_mul(w->g[k], w->g[k], w->t, MPFR_RNDN);
    if (k > 0) mpfr_add(w->g[k], w->g[k], w->g[k - 1], MPFR_RNDN);
    mpfr_div(w->g[k], w->g[k], w->x, MPFR_RNDN);
    mpfr_div_si(w->g[k], w->g[k], i, MPFR_RNDN);
  }
}

/* x^(y+g) (1 + h/x)^(y+g), the first factor's coefficients in w->c, the second's of h^i in w->g. x > 0. */
static void general_power(work *w, double y, mpfr_t *f) {
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_pow(w->c[0], w->x, w->t, MPFR_RNDN);
  mpfr_log(w->u, w->x, MPFR_RNDN);
  exponential(w, w->u);
  mpfr_set_ui(w->g[0], 1, MPFR_RNDN);
  for (int i = 0; i <= w->degree; i++) {
    if (i > 0) next_binomial(w, y, i);
    for (int j = 0; i + j <= w->degree; j++)
      for (int k = 0; k <= i && k <= j; k++)
        mpfr_fma(f[i * (w->degree + 1) + j], w->g[k], w->c[j - k], f[i * (w->degree + 1) + j], MPFR_RNDN);
  }
}

/* x^y, y constant: binomial(y,k) x^(y-k), x of any sign, and 0 with an integer y >= 0. */
static void constant_power(work *w, double y, mpfr_t *f) {
  mpfr_set_ui(w->u, 1, MPFR_RNDN);
  for (int k = 0; k <= w->degree; k++) {
    mpfr_set_d(w->t, y, MPFR_RNDN);
    mpfr_sub_si(w->t, w->t, k, MPFR_RNDN);
    mpfr_ptr c = f[k * (w->degree + 1)];
    if (mpfr_zero_p(w->u)) return;
    mpfr_pow(c, w->x, w->t, MPFR_RNDN);
    mpfr_mul(c, c, w->u, MPFR_RNDN);
    mpfr_mul(w->u, w->u, w->t, MPFR_RNDN);
    mpfr_div_si(w->u, w->u, k + 1, MPFR_RNDN);
  }
}

/* y^x, y constant. */
static void constant_base(work *w, double y, mpfr_t *f) {
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_pow(w->c[0], w->t, w->x, MPFR_RNDN);
  mpfr_log(w->t, w->t, MPFR_RNDN);
  exponential(w, w->t);
  for (int k = 0; k <= w->degree; k++) mpfr_set(f[k * (w->degree + 1)], w->c[k], MPFR_RNDN);
}

/* w->c[k] + i w->g[k] = 1/(x + i y)^k. */
static void inverse_powers(work *w, double y) {
  mpfr_sqr(w->u, w->x, MPFR_RNDN);
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_fma(w->u, w->t, w->t, w->u, MPFR_RNDN);
  mpfr_set_ui(w->c[0], 1, MPFR_RNDN);
  mpfr_set_zero(w->g[0], 1);
  for (int k = 1; k <= w->degree; k++) { /* times (x - i y)/(x^2 + y^2) */
    mpfr_fmma(w->c[k], w->c[k - 1], w->x, w->g[k - 1], w->t, MPFR_RNDN);
    mpfr_fmms(w->g[k], w->g[k - 1], w->x, w->c[k - 1], w->t, MPFR_RNDN);
    mpfr_div(w->c[k], w->c[k], w->u, MPFR_RNDN);
    mpfr_div(w->g[k], w->g[k], w->u, MPFR_RNDN);
  }
}

/* i^j (re + i im) = factor to the result's part: its real part, or its imaginary one. */
static mpfr_srcptr turned(work *w, int k, int j, int imaginary, int *sign) {
  const int quarter = (imaginary ? j + 3 : j) % 4; /* Im z = Re(-i z) */
  *sign = quarter == 0 || quarter == 3 ? 1 : -1;
  return quarter % 2 ? w->g[k] : w->c[k];
}

static long binomial(int n, int k) {
  long b = 1;
  for (int i = 1; i <= k; i++) b = b * (n - k + i) / i;
  return b;
}

/* atan2(x+h, y+g) = Im log(z + w), z = y + i x, w = g + i h: (-1)^(k-1)/k Im((g + i h)^k/z^k). */
static void angle(work *w, double y, mpfr_t *f) {
  mpfr_set_d(w->t, y, MPFR_RNDN);
  mpfr_atan2(f[0], w->x, w->t, MPFR_RNDN);
  const double x = mpfr_get_d(w->x, MPFR_RNDN);
  mpfr_set_d(w->x, y, MPFR_RNDN);
  inverse_powers(w, x);
  for (int k = 1; k <= w->degree; k++)
    for (int j = 0; j <= k; j++) { /* h^j g^(k-j) */
      int sign;
      mpfr_ptr c = f[j * (w->degree + 1) + k - j];
      mpfr_srcptr part = turned(w, k, j, 1, &sign);
      mpfr_mul_si(c, part, sign * (k % 2 ? 1 : -1) * binomial(k, j), MPFR_RNDN);
      mpfr_div_si(c, c, k, MPFR_RNDN);
    }
}

/* hypot(x+h, y+g): c = sqrt(d) by 2 d E c = c E d with d = (x+h)^2 + (y+g)^2, E = h d/dh + g d/dg:
 *     2 n d_0 c_ij = (3 - 2 n) (2 x c_(i-1,j) + 2 y c_(i,j-1)) + (6 - 2 n) (c_(i-2,j) + c_(i,j-2)),   n = i + j. */
static void length(work *w, double y, mpfr_t *f) {
  const int n = w->degree + 1;
  mpfr_t d, two_y;
  mpfr_inits2(w->precision, d, two_y, (mpfr_ptr)0);
  mpfr_set_d(two_y, y, MPFR_RNDN);
  mpfr_fmma(d, w->x, w->x, two_y, two_y, MPFR_RNDN);
  mpfr_sqrt(f[0], d, MPFR_RNDN);
  mpfr_mul_ui(w->x, w->x, 2, MPFR_RNDN);
  mpfr_mul_ui(two_y, two_y, 2, MPFR_RNDN);
  for (int k = 1; k <= w->degree; k++)
    for (int i = 0; i <= k; i++) {
      const int j = k - i;
      mpfr_set_zero(w->t, 1);
      mpfr_set_zero(w->u, 1);
      if (i > 0) mpfr_fma(w->t, w->x, f[(i - 1) * n + j], w->t, MPFR_RNDN);
      if (j > 0) mpfr_fma(w->t, two_y, f[i * n + j - 1], w->t, MPFR_RNDN);
      if (i > 1) mpfr_add(w->u, w->u, f[(i - 2) * n + j], MPFR_RNDN);
      if (j > 1) mpfr_add(w->u, w->u, f[i * n + j - 2], MPFR_RNDN);
      mpfr_mul_si(w->t, w->t, 3 - 2 * k, MPFR_RNDN);
      mpfr_mul_si(w->u, w->u, 6 - 2 * k, MPFR_RNDN);
      mpfr_add(w->t, w->t, w->u, MPFR_RNDN);
      mpfr_div(w->t, w->t, d, MPFR_RNDN);
      mpfr_div_si(f[i * n + j], w->t, 2 * k, MPFR_RNDN);
    }
  mpfr_clears(d, two_y, (mpfr_ptr)0);
}

static const struct {
  const char *name;
  void (*one)(work *w);
  void (*two)(work *w, double y, mpfr_t *f);
} SERIES[] = {
    {"sqrt", square_root, NULL},
    {"cbrt", cube_root, NULL},
    {"exp", exp_series, NULL},
    {"expm1", expm1_series, NULL},
    {"exp2", exp2_series, NULL},
    {"log", log_series, NULL},
    {"log1p", log1p_series, NULL},
    {"log2", log2_series, NULL},
    {"log10", log10_series, NULL},
    {"sin", sine, NULL},
    {"cos", cosine, NULL},
    {"tan", tangent, NULL},
    {"asin", arc_sine, NULL},
    {"acos", arc_cosine, NULL},
    {"atan", arc_tangent, NULL},
    {"sinh", hyperbolic_sine, NULL},
    {"cosh", hyperbolic_cosine, NULL},
    {"tanh", hyperbolic_tangent, NULL},
    {"asinh", area_sine, NULL},
    {"acosh", area_cosine, NULL},
    {"atanh", area_tangent, NULL},
    {"erf", error_function, NULL},
    {"erfc", error_complement, NULL},
    {"tgamma", gamma_series, NULL},
    {"lgamma", log_gamma, NULL},
    {"mul", NULL, product},
    {"div", NULL, quotient},
    {"pow", NULL, general_power},
    {"powc", NULL, constant_power},
    {"rpow", NULL, constant_base},
    {"hypot", NULL, length},
    {"atan2", NULL, angle},
};

static int find_series(const char *name) {
  for (int i = 0; i < (int)(sizeof SERIES / sizeof *SERIES); i++)
    if (strcmp(SERIES[i].name, name) == 0) return i;
  return -1;
}

static long exponent_of(double x) { return x == 0.0 ? 0 : ilogb(x); }

/* Below this the gamma functions would take too many terms. */
static const double MANY_TERMS = -4000.0;

void ref_series(const ref_function *function, double x, double y, int degree, mpfr_t *f) {
  const int i = find_series(function->name), n = degree + 1;
  assert(degree <= REF_MAX_DEGREE);
  const int gamma = i >= 0 && (SERIES[i].one == gamma_series || SERIES[i].one == log_gamma);
  if (i < 0 || (gamma && x < MANY_TERMS)) {
    ref_taylor(function, x, y, degree, f);
    return;
  }
  work w; /* polar functions lose as many bits as the sides differ in size, twice */
  const long apart = SERIES[i].two == length || SERIES[i].two == angle ? 4 * labs(exponent_of(x) - exponent_of(y)) : 0;
  work_init(&w, x, degree, gamma ? GAMMA_PRECISION : REF_PRECISION + apart);
  mpfr_t *wide = apart ? malloc((size_t)(n * n) * sizeof *wide) : NULL, *out = wide ? wide : f;
  if (wide)
    for (int k = 0; k < n * n; k++) mpfr_init2(wide[k], w.precision);
  for (int k = 0; k < n * n; k++) mpfr_set_zero(out[k], 1);
  if (SERIES[i].one) {
    SERIES[i].one(&w);
    for (int k = 0; k <= degree; k++) mpfr_set(f[k * n], w.c[k], MPFR_RNDN);
  } else {
    SERIES[i].two(&w, y, out);
  }
  if (wide)
    for (int k = 0; k < n * n; k++) {
      mpfr_set(f[k], wide[k], MPFR_RNDN);
      mpfr_clear(wide[k]);
    }
  free(wide);
  work_free(&w);
}
