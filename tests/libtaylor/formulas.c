/* Other people's formulas for Taylor coefficients, in plain double arithmetic. */
#include "formulas.h"

#include <math.h>

enum { M = FORMULA_ORDER };
typedef plain_series series;

static const double PI = 3.14159265358979323846;

/* c_n += x a_k b_l, n = k + l: homogeneous parts. */
static void add_part(series *c, double x, const series *a, int k, const series *b, int l) {
  for (int i = 0; i <= k; i++) {
    const double ai = x * a->c[i][k - i];
    if (ai == 0.0) continue;
    for (int j = 0; j <= l; j++) c->c[i + j][k + l - i - j] += ai * b->c[j][l - j];
  }
}

static void scale_part(series *c, int n, double x) {
  for (int i = 0; i <= n; i++) c->c[i][n - i] *= x;
}

static void divide_part(series *c, int n, double x) {
  for (int i = 0; i <= n; i++) c->c[i][n - i] /= x;
}

static series constant(double x) {
  series c = {.c = {{x}}};
  return c;
}

static series shifted(const series *a, double x) {
  series c = *a;
  c.c[0][0] += x;
  return c;
}

static series scaled(const series *a, double x) {
  series c = *a;
  for (int n = 0; n <= M; n++) scale_part(&c, n, x);
  return c;
}

static series sum(const series *a, const series *b) {
  series c = *a;
  for (int i = 0; i <= M; i++)
    for (int j = 0; i + j <= M; j++) c.c[i][j] += b->c[i][j];
  return c;
}

static series times_to(const series *a, const series *b, int order) {
  series c = constant(0.0);
  for (int n = 0; n <= order; n++)
    for (int k = 0; k <= n; k++) add_part(&c, 1.0, a, k, b, n - k);
  return c;
}

static series times(const series *a, const series *b) { return times_to(a, b, M); }

/* The textbook. */

/* b_0 c_n = a_n - sum_{k<n} c_k b_(n-k). */
static void divide(series *c, const series *a, const series *b) {
  *c = *a;
  for (int n = 0; n <= M; n++) {
    for (int k = 0; k < n; k++) add_part(c, -1.0, c, k, b, n - k);
    divide_part(c, n, b->c[0][0]);
  }
}

static void multiply(series *c, const series *a, const series *b) { *c = times(a, b); }

/* 2 c_0 c_n = a_n - sum_{0<k<n} c_k c_(n-k). */
static void square_root(series *c, const series *a) {
  *c = *a;
  c->c[0][0] = sqrt(a->c[0][0]);
  for (int n = 1; n <= M; n++) {
    for (int k = 1; k < n; k++) add_part(c, -1.0, c, k, c, n - k);
    divide_part(c, n, 2.0 * c->c[0][0]);
  }
}

/* n a_0 c_n = sum_{k<n} (p (n-k) - k) a_(n-k) c_k. */
static void power(series *c, const series *a, double p, double value) {
  *c = constant(value);
  for (int n = 1; n <= M; n++) {
    for (int k = 0; k < n; k++) add_part(c, p * (n - k) - k, a, n - k, c, k);
    divide_part(c, n, n * a->c[0][0]);
  }
}

static void cube_root(series *c, const series *a) { power(c, a, 1.0 / 3.0, cbrt(a->c[0][0])); }
static void constant_power(series *c, const series *a, const series *b) { power(c, a, b->c[0][0], pow(a->c[0][0], b->c[0][0])); }

/* n c_n = rate sum_{k=1..n} k a_k g_(n-k), for part n alone; g may be c. */
static void integrate_part(series *c, int n, double rate, const series *g, const series *a) {
  scale_part(c, n, 0.0);
  for (int k = 1; k <= n; k++) add_part(c, rate * k, a, k, g, n - k);
  divide_part(c, n, n);
}

static void integrate(series *c, double value, double rate, const series *g, const series *a) {
  *c = constant(value);
  for (int n = 1; n <= M; n++) integrate_part(c, n, rate, g, a);
}

static void exponential(series *c, const series *a) {
  *c = constant(exp(a->c[0][0]));
  for (int n = 1; n <= M; n++) integrate_part(c, n, 1.0, c, a);
}

static void exponential_less_one(series *c, const series *a) {
  exponential(c, a);
  c->c[0][0] -= 1.0;
}

static void power_of_two(series *c, const series *a) {
  const series x = scaled(a, log(2.0));
  exponential(c, &x);
}

/* a_0 c_n = a_n - 1/n sum_{0<k<n} k c_k a_(n-k). */
static void logarithm(series *c, const series *a) {
  *c = constant(log(a->c[0][0]));
  for (int n = 1; n <= M; n++) {
    for (int k = 1; k < n; k++) add_part(c, -k, c, k, a, n - k);
    divide_part(c, n, n);
    for (int i = 0; i <= n; i++) c->c[i][n - i] += a->c[i][n - i];
    divide_part(c, n, a->c[0][0]);
  }
}

static void logarithm_of_base(series *c, const series *a, double base) {
  logarithm(c, a);
  *c = scaled(c, 1.0 / log(base));
}

static void logarithm_2(series *c, const series *a) { logarithm_of_base(c, a, 2.0); }
static void logarithm_10(series *c, const series *a) { logarithm_of_base(c, a, 10.0); }
static void logarithm_past_one(series *c, const series *a) {
  const series x = shifted(a, 1.0);
  logarithm(c, &x);
}

static void general_power(series *c, const series *a, const series *b) {
  series l;
  logarithm(&l, a);
  l = times(b, &l);
  exponential(c, &l);
}

static void constant_base(series *c, const series *a, const series *b) {
  const series x = scaled(a, log(b->c[0][0]));
  exponential(c, &x);
}

/* s' = c a', c' = sign s a'. */
static void circle(series *s, series *c, double sign, const series *a) {
  const double x = a->c[0][0];
  *s = constant(sign < 0.0 ? sin(x) : sinh(x));
  *c = constant(sign < 0.0 ? cos(x) : cosh(x));
  for (int n = 1; n <= M; n++) {
    integrate_part(s, n, 1.0, c, a);
    integrate_part(c, n, sign, s, a);
  }
}

static void sine(series *c, const series *a) {
  series other;
  circle(c, &other, -1.0, a);
}
static void cosine(series *c, const series *a) {
  series other;
  circle(&other, c, -1.0, a);
}
static void hyperbolic_sine(series *c, const series *a) {
  series other;
  circle(c, &other, 1.0, a);
}
static void hyperbolic_cosine(series *c, const series *a) {
  series other;
  circle(&other, c, 1.0, a);
}

/* c' = q a', q = 1 + sign c^2. */
static void tangent_like(series *c, const series *a, double value, double sign) {
  series q = constant(1.0 + sign * value * value);
  *c = constant(value);
  for (int n = 1; n <= M; n++) {
    integrate_part(c, n, 1.0, &q, a);
    for (int k = 0; k <= n; k++) add_part(&q, sign, c, k, c, n - k);
  }
}

static void tangent(series *c, const series *a) { tangent_like(c, a, tan(a->c[0][0]), 1.0); }
static void hyperbolic_tangent(series *c, const series *a) { tangent_like(c, a, tanh(a->c[0][0]), -1.0); }

/* d c' = rate a': d_0 c_n = rate a_n - 1/n sum_{0<k<n} k c_k d_(n-k). */
static void integrate_quotient(series *c, double value, double rate, const series *d, const series *a) {
  *c = constant(value);
  for (int n = 1; n <= M; n++) {
    for (int k = 1; k < n; k++) add_part(c, -k, c, k, d, n - k);
    divide_part(c, n, n);
    for (int i = 0; i <= n; i++) c->c[i][n - i] += rate * a->c[i][n - i];
    divide_part(c, n, d->c[0][0]);
  }
}

/* d = constant + sign a^2, or its root. */
static void inverse(series *c, const series *a, double value, double rate, double one, double sign, int root) {
  series d = times(a, a), r;
  d = scaled(&d, sign);
  d = shifted(&d, one);
  if (root) {
    square_root(&r, &d);
    d = r;
  }
  integrate_quotient(c, value, rate, &d, a);
}

static void arc_sine(series *c, const series *a) { inverse(c, a, asin(a->c[0][0]), 1.0, 1.0, -1.0, 1); }
static void arc_cosine(series *c, const series *a) { inverse(c, a, acos(a->c[0][0]), -1.0, 1.0, -1.0, 1); }
static void arc_tangent(series *c, const series *a) { inverse(c, a, atan(a->c[0][0]), 1.0, 1.0, 1.0, 0); }
static void area_sine(series *c, const series *a) { inverse(c, a, asinh(a->c[0][0]), 1.0, 1.0, 1.0, 1); }
static void area_cosine(series *c, const series *a) { inverse(c, a, acosh(a->c[0][0]), 1.0, -1.0, 1.0, 1); }
static void area_tangent(series *c, const series *a) { inverse(c, a, atanh(a->c[0][0]), 1.0, 1.0, -1.0, 0); }

static void gauss_integral(series *c, const series *a, double value, double sign) {
  series q = times(a, a), g;
  q = scaled(&q, -1.0);
  exponential(&g, &q);
  integrate(c, value, sign * 2.0 / sqrt(PI), &g, a);
}

static void error_function(series *c, const series *a) { gauss_integral(c, a, erf(a->c[0][0]), 1.0); }
static void error_complement(series *c, const series *a) { gauss_integral(c, a, erfc(a->c[0][0]), -1.0); }

static void length(series *c, const series *a, const series *b) {
  const series x = times(a, a), y = times(b, b), d = sum(&x, &y);
  square_root(c, &d);
}

static void angle(series *c, const series *a, const series *b) {
  series q;
  divide(&q, a, b);
  arc_tangent(c, &q);
  c->c[0][0] = atan2(a->c[0][0], b->c[0][0]);
}

/* TaylorSeries.jl, where it differs. */

/* c_n = a_n + sign/n sum_{k<n} (n-k) a_(n-k) q_k, q = c^2. */
static void tangent_of_square(series *c, const series *a, double value, double sign) {
  series q = constant(value * value);
  *c = constant(value);
  for (int n = 1; n <= M; n++) {
    integrate_part(c, n, sign, &q, a);
    for (int i = 0; i <= n; i++) c->c[i][n - i] += a->c[i][n - i];
    for (int k = 0; k <= n; k++) add_part(&q, 1.0, c, k, c, n - k);
  }
}

static void tangent_ts(series *c, const series *a) { tangent_of_square(c, a, tan(a->c[0][0]), 1.0); }
static void hyperbolic_tangent_ts(series *c, const series *a) { tangent_of_square(c, a, tanh(a->c[0][0]), -1.0); }

static void power_by_squaring(series *c, const series *a, double exponent) {
  series square = *a;
  *c = constant(1.0);
  for (int n = (int)exponent; n > 0; n /= 2) {
    if (n % 2) *c = times(c, &square);
    square = times(&square, &square);
  }
}

static int is_natural(double x) { return x >= 0.0 && x < 1e9 && x == floor(x); }

static void constant_power_ts(series *c, const series *a, const series *b) {
  if (is_natural(b->c[0][0]))
    power_by_squaring(c, a, b->c[0][0]);
  else if (b->c[0][0] == 0.5)
    square_root(c, a);
  else
    constant_power(c, a, b);
}

static void logarithm_past_one_ts(series *c, const series *a) {
  logarithm_past_one(c, a);
  c->c[0][0] = log1p(a->c[0][0]);
}

static void exponential_less_one_ts(series *c, const series *a) {
  exponential(c, a);
  c->c[0][0] = expm1(a->c[0][0]);
}

/* DACE: f's coefficients at a_0 in Horner's scheme. */

static void evaluate(series *c, const double *f, const series *a, int order) {
  series h = *a;
  h.c[0][0] = 0.0;
  *c = constant(f[order]);
  for (int k = order - 1; k >= 0; k--) {
    *c = times_to(c, &h, order);
    c->c[0][0] = f[k];
  }
}

/* a/a_0, whose powers take the place of (a - a_0)^k. */
static series over_value(const series *a) {
  series c = *a;
  for (int n = 0; n <= M; n++) divide_part(&c, n, a->c[0][0]);
  return c;
}

static void root_dace(series *c, const series *a, double exponent) {
  const double x = a->c[0][0];
  double f[M + 1] = {copysign(pow(fabs(x), exponent), x)};
  for (int k = 1; k <= M; k++) f[k] = f[k - 1] / k * (exponent - (k - 1));
  const series h = over_value(a);
  evaluate(c, f, &h, M);
}

static void square_root_dace(series *c, const series *a) { root_dace(c, a, 0.5); }
static void cube_root_dace(series *c, const series *a) { root_dace(c, a, 1.0 / 3.0); }

/* 1/a: to order 2 by the series, then by Newton's c (2 - a c), which doubles the order. */
static void reciprocal_dace(series *c, const series *a) {
  double f[M + 1] = {1.0 / a->c[0][0]};
  for (int k = 1; k <= M; k++) f[k] = -f[k - 1];
  const series h = over_value(a);
  evaluate(c, f, &h, 2);
  for (int order = 3; order <= M; order *= 2) {
    const int reached = 2 * order - 1 < M ? 2 * order - 1 : M;
    series rest = times_to(a, c, reached);
    rest = scaled(&rest, -1.0);
    rest = shifted(&rest, 2.0);
    *c = times_to(c, &rest, reached);
  }
}

static void divide_dace(series *c, const series *a, const series *b) {
  series r;
  reciprocal_dace(&r, b);
  *c = times(a, &r);
}

static void constant_power_dace(series *c, const series *a, const series *b) {
  const double p = b->c[0][0];
  series r;
  if (p != rint(p)) {
    root_dace(c, a, p);
  } else {
    power_by_squaring(&r, a, fabs(p));
    if (p < 0.0)
      reciprocal_dace(c, &r);
    else
      *c = r;
  }
}

static void exponential_dace(series *c, const series *a) {
  double f[M + 1] = {exp(a->c[0][0])};
  for (int k = 1; k <= M; k++) f[k] = f[k - 1] / k;
  evaluate(c, f, a, M);
}

static void logarithm_dace(series *c, const series *a) {
  double f[M + 1] = {log(a->c[0][0]), 1.0};
  for (int k = 2; k <= M; k++) f[k] = -f[k - 1] / k * (k - 1);
  const series h = over_value(a);
  evaluate(c, f, &h, M);
}

static void logarithm_2_dace(series *c, const series *a) {
  logarithm_dace(c, a);
  *c = scaled(c, 1.0 / log(2.0));
}
static void logarithm_10_dace(series *c, const series *a) {
  logarithm_dace(c, a);
  *c = scaled(c, 1.0 / log(10.0));
}

static void general_power_dace(series *c, const series *a, const series *b) {
  series l;
  logarithm_dace(&l, a);
  l = times(b, &l);
  exponential_dace(c, &l);
}

static void oscillate_dace(series *c, const series *a, double value, double slope, double sign) {
  double f[M + 1] = {value, slope};
  for (int k = 2; k <= M; k++) f[k] = sign * f[k - 2] / (k * (k - 1));
  evaluate(c, f, a, M);
}

static void sine_dace(series *c, const series *a) { oscillate_dace(c, a, sin(a->c[0][0]), cos(a->c[0][0]), -1.0); }
static void cosine_dace(series *c, const series *a) { oscillate_dace(c, a, cos(a->c[0][0]), -sin(a->c[0][0]), -1.0); }
static void hyperbolic_sine_dace(series *c, const series *a) { oscillate_dace(c, a, sinh(a->c[0][0]), cosh(a->c[0][0]), 1.0); }
static void hyperbolic_cosine_dace(series *c, const series *a) { oscillate_dace(c, a, cosh(a->c[0][0]), sinh(a->c[0][0]), 1.0); }

static void tangent_dace(series *c, const series *a) {
  series s, k;
  sine_dace(&s, a);
  cosine_dace(&k, a);
  divide_dace(c, &s, &k);
}
static void hyperbolic_tangent_dace(series *c, const series *a) {
  series s, k;
  hyperbolic_sine_dace(&s, a);
  hyperbolic_cosine_dace(&k, a);
  divide_dace(c, &s, &k);
}

/* atan a = atan a_0 + atan((a - a_0)/(1 + a a_0)). */
static void arc_tangent_dace(series *c, const series *a) {
  const double x = a->c[0][0];
  double f[M + 1] = {atan(x)};
  for (int k = 1; k <= M; k += 2) f[k] = (k % 4 == 1 ? 1.0 : -1.0) / k;
  series divisor = scaled(a, x), h = shifted(a, -x), q;
  divisor = shifted(&divisor, 1.0);
  divide_dace(&q, &h, &divisor);
  evaluate(c, f, &q, M);
}

static void arc_sine_dace(series *c, const series *a) {
  series d = times(a, a), root;
  d = scaled(&d, -1.0);
  d = shifted(&d, 1.0);
  square_root_dace(&root, &d);
  divide_dace(&d, a, &root);
  arc_tangent_dace(c, &d);
}
static void arc_cosine_dace(series *c, const series *a) {
  arc_sine_dace(c, a);
  *c = scaled(c, -1.0);
  c->c[0][0] += PI / 2;
}

/* log(a + sqrt(a^2 + one)). */
static void area_dace(series *c, const series *a, double one) {
  series d = times(a, a), root;
  d = shifted(&d, one);
  square_root_dace(&root, &d);
  d = sum(a, &root);
  logarithm_dace(c, &d);
}
static void area_sine_dace(series *c, const series *a) { area_dace(c, a, 1.0); }
static void area_cosine_dace(series *c, const series *a) { area_dace(c, a, -1.0); }
static void area_tangent_dace(series *c, const series *a) {
  series over = shifted(a, 1.0), under = scaled(a, -1.0), q;
  under = shifted(&under, 1.0);
  divide_dace(&q, &over, &under);
  logarithm_dace(c, &q);
  *c = scaled(c, 0.5);
}

/* (-1)^(k-1)/k! H_(k-1)(x) 2/sqrt(pi) exp(-x^2), H_k = 2 x H_(k-1) - 2 (k-1) H_(k-2). */
static void gauss_integral_dace(series *c, const series *a, double value, double sign) {
  const double x = a->c[0][0];
  double factor = sign * 2.0 * exp(-x * x) / sqrt(PI), before = 1.0, hermite = 2.0 * x, f[M + 1] = {value, factor};
  for (int k = 2; k <= M; k++) {
    factor /= -k;
    f[k] = factor * hermite;
    const double next = 2.0 * x * hermite - 2.0 * (k - 1) * before;
    before = hermite;
    hermite = next;
  }
  evaluate(c, f, a, M);
}
static void error_function_dace(series *c, const series *a) { gauss_integral_dace(c, a, erf(a->c[0][0]), 1.0); }
static void error_complement_dace(series *c, const series *a) { gauss_integral_dace(c, a, erfc(a->c[0][0]), -1.0); }

static void length_dace(series *c, const series *a, const series *b) {
  const series x = times(a, a), y = times(b, b), d = sum(&x, &y);
  square_root_dace(c, &d);
}

static void angle_dace(series *c, const series *a, const series *b) {
  const double y = a->c[0][0], x = b->c[0][0];
  series q;
  if (fabs(y) > fabs(x)) {
    divide_dace(&q, b, a);
    arc_tangent_dace(c, &q);
    *c = scaled(c, -1.0);
    c->c[0][0] += copysign(PI / 2, y);
  } else {
    divide_dace(&q, a, b);
    arc_tangent_dace(c, &q);
    if (x < 0.0) c->c[0][0] += y > 0.0 ? PI : -PI;
  }
}

#define TEXTBOOK "textbook"
#define DACE "DACE"
#define JULIA "TaylorSeries"

const formula formulas[] = {
    {TEXTBOOK, "sqrt", square_root, 0},
    {TEXTBOOK, "cbrt", cube_root, 0},
    {TEXTBOOK, "exp", exponential, 0},
    {TEXTBOOK, "expm1", exponential_less_one, 0},
    {TEXTBOOK, "exp2", power_of_two, 0},
    {TEXTBOOK, "log", logarithm, 0},
    {TEXTBOOK, "log1p", logarithm_past_one, 0},
    {TEXTBOOK, "log2", logarithm_2, 0},
    {TEXTBOOK, "log10", logarithm_10, 0},
    {TEXTBOOK, "sin", sine, 0},
    {TEXTBOOK, "cos", cosine, 0},
    {TEXTBOOK, "tan", tangent, 0},
    {TEXTBOOK, "asin", arc_sine, 0},
    {TEXTBOOK, "acos", arc_cosine, 0},
    {TEXTBOOK, "atan", arc_tangent, 0},
    {TEXTBOOK, "sinh", hyperbolic_sine, 0},
    {TEXTBOOK, "cosh", hyperbolic_cosine, 0},
    {TEXTBOOK, "tanh", hyperbolic_tangent, 0},
    {TEXTBOOK, "asinh", area_sine, 0},
    {TEXTBOOK, "acosh", area_cosine, 0},
    {TEXTBOOK, "atanh", area_tangent, 0},
    {TEXTBOOK, "erf", error_function, 0},
    {TEXTBOOK, "erfc", error_complement, 0},
    {TEXTBOOK, "mul", 0, multiply},
    {TEXTBOOK, "div", 0, divide},
    {TEXTBOOK, "pow", 0, general_power},
    {TEXTBOOK, "powc", 0, constant_power},
    {TEXTBOOK, "rpow", 0, constant_base},
    {TEXTBOOK, "hypot", 0, length},
    {TEXTBOOK, "atan2", 0, angle},
    {JULIA, "tan", tangent_ts, 0},
    {JULIA, "tanh", hyperbolic_tangent_ts, 0},
    {JULIA, "powc", 0, constant_power_ts},
    {JULIA, "log1p", logarithm_past_one_ts, 0},
    {JULIA, "expm1", exponential_less_one_ts, 0},
    {DACE, "sqrt", square_root_dace, 0},
    {DACE, "cbrt", cube_root_dace, 0},
    {DACE, "exp", exponential_dace, 0},
    {DACE, "log", logarithm_dace, 0},
    {DACE, "log2", logarithm_2_dace, 0},
    {DACE, "log10", logarithm_10_dace, 0},
    {DACE, "sin", sine_dace, 0},
    {DACE, "cos", cosine_dace, 0},
    {DACE, "tan", tangent_dace, 0},
    {DACE, "asin", arc_sine_dace, 0},
    {DACE, "acos", arc_cosine_dace, 0},
    {DACE, "atan", arc_tangent_dace, 0},
    {DACE, "sinh", hyperbolic_sine_dace, 0},
    {DACE, "cosh", hyperbolic_cosine_dace, 0},
    {DACE, "tanh", hyperbolic_tangent_dace, 0},
    {DACE, "asinh", area_sine_dace, 0},
    {DACE, "acosh", area_cosine_dace, 0},
    {DACE, "atanh", area_tangent_dace, 0},
    {DACE, "erf", error_function_dace, 0},
    {DACE, "erfc", error_complement_dace, 0},
    {DACE, "div", 0, divide_dace},
    {DACE, "pow", 0, general_power_dace},
    {DACE, "powc", 0, constant_power_dace},
    {DACE, "hypot", 0, length_dace},
    {DACE, "atan2", 0, angle_dace},
};
const int nformulas = (int)(sizeof formulas / sizeof *formulas);
