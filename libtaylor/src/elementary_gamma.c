/* The gamma function and the logarithm of its size.
 *
 * log|Gamma(x+h)| = log|Gamma(x)| + psi(x) h + sum_{k>=2} (-1)^k zeta(k,x)/k h^k, zeta(k,x) = sum_{n>=0} (x+n)^-k. The series are
 * computed in twice the precision and rounded once, so that neither the zeros of psi nor the neighbourhood of a pole costs digits. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

enum { MAX_DEGREE = TL_MAX_CURVE + TL_MAX_ORDER, NBERNOULLI = TL_MANT_DIG > 64 ? 15 : 10 };

/* B_2j, j = 1..NBERNOULLI. From X = SHIFT up the first term left out, B_22/X^22 or B_32/X^32, is below 1e-22, or 1e-37 of the sum. */
#define RATIO(p, q) (TL_C(p) / TL_C(q))
static const tl_real BERNOULLI[] = {RATIO(1.0, 6.0),
                                    RATIO(-1.0, 30.0),
                                    RATIO(1.0, 42.0),
                                    RATIO(-1.0, 30.0),
                                    RATIO(5.0, 66.0),
                                    RATIO(-691.0, 2730.0),
                                    RATIO(7.0, 6.0),
                                    RATIO(-3617.0, 510.0),
                                    RATIO(43867.0, 798.0),
                                    RATIO(-174611.0, 330.0),
                                    RATIO(854513.0, 138.0),
                                    RATIO(-236364091.0, 2730.0),
                                    RATIO(8553103.0, 6.0),
                                    RATIO(-23749461029.0, 870.0),
                                    RATIO(8615841276005.0, 14322.0)};
static const tl_real SHIFT = TL_MANT_DIG > 64 ? TL_C(32.0) : TL_C(16.0);

static tl_wide add_real(tl_wide a, tl_real x) { return tl_wide_add(a, tl_widen(x)); }

/* psi(x) = log X - h - h^2/3 - sum_{j>1} B_2j/(2j X^2j) - sum_{n<N} 1/(x+n), X = x+N >= SHIFT, h = 1/(2X); x > 0. */
static tl_wide digamma(tl_wide x) {
  const tl_wide minus_one = tl_widen(-TL_C(1.0));
  tl_wide sum = tl_widen(TL_C(0.0));
  for (; x.hi < SHIFT; x = add_real(x, TL_C(1.0))) sum = tl_wide_add(sum, tl_wide_div(minus_one, x));
  const tl_wide h = tl_wide_div(tl_widen(-TL_C(0.5)), x), third = tl_wide_div(tl_wide_mul(h, h), tl_widen(-TL_C(3.0)));
  const tl_real square = TL_C(4.0) * h.hi * h.hi;
  tl_real tail = TL_C(0.0);
  for (int j = NBERNOULLI; j > 1; j--) tail = square * (tail - BERNOULLI[j - 1] / (tl_real)(2 * j));
  return tl_wide_add(tl_wide_add(sum, h), tl_wide_add(tl_wide_log(x), add_real(third, square * tail)));
}

/* The tail of zeta(k,X) over X^(1-k) (Euler, Maclaurin), r = 1/X:
 *     1/(k-1) + r/2 + sum_j B_2j/(2j)! k(k+1)..(k+2j-2) r^2j. */
static tl_wide zeta_tail(int k, tl_wide r) {
  tl_real sum = TL_C(0.0), factor = (tl_real)k * r.hi * r.hi / TL_C(2.0);
  for (int j = 1; j <= NBERNOULLI; j++) {
    sum += BERNOULLI[j - 1] * factor;
    factor *= (tl_real)(k + 2 * j - 1) * (tl_real)(k + 2 * j) * r.hi * r.hi / ((tl_real)(2 * j + 1) * (tl_real)(2 * j + 2));
  }
  const tl_wide whole = tl_wide_div(tl_widen(TL_C(1.0)), tl_widen((tl_real)(k - 1)));
  return add_real(tl_wide_add(whole, tl_wide_mul(r, tl_widen(TL_C(0.5)))), sum);
}

static tl_wide times_real(tl_wide a, tl_real x) { return tl_wide_mul(a, tl_widen(x)); }

/* s[1] = psi(x) shrink, s[k] = zeta(k,x) shrink^k for k = 2..degree; x > 0. The tails start where the terms of degree k still fall
 * quickly. */
static void polygammas(tl_wide *s, tl_wide x, int degree, tl_real shrink) {
  const tl_wide one = tl_widen(TL_C(1.0));
  const tl_real start = SHIFT + (tl_real)(TL_MANT_DIG > 64 ? 2 * degree : degree);
  s[1] = times_real(digamma(x), shrink);
  for (int k = 2; k <= degree; k++) s[k] = tl_widen(TL_C(0.0));
  if (degree < 2) return;
  for (; x.hi < start; x = add_real(x, TL_C(1.0))) {
    const tl_wide r = times_real(tl_wide_div(one, x), shrink);
    tl_wide power = r;
    for (int k = 2; k <= degree; k++) {
      power = tl_wide_mul(power, r);
      s[k] = tl_wide_add(s[k], power);
    }
  }
  const tl_wide r = tl_wide_div(one, x);
  tl_wide power = tl_widen(shrink);
  for (int k = 2; k <= degree; k++) {
    power = times_real(tl_wide_mul(power, r), shrink);
    s[k] = tl_wide_add(s[k], tl_wide_mul(power, zeta_tail(k, r)));
  }
}

/* A power of two near the distance to the nearest pole where that is small, otherwise 1. Series are made in a/shrink, since beside a
 * pole their coefficients grow like powers of its distance. */
static tl_real shrink_for(tl_real x) {
  const tl_real close = TL_C(0.25), distance = TL_LIBM(fabs)(x < TL_C(0.0) ? x - TL_LIBM(round)(x) : x);
  return distance < close ? TL_C(1.0) / tl_normaliser(distance) : TL_C(1.0);
}

/* f[k] = coefficient k of log|Gamma(x+h)| times shrink^k, k = 1..degree, for every x but the poles. Below zero the sum over n is cut at
 * the fraction y = x - floor(x) of x: zeta(k,x) = zeta(k,y) + (-1)^k (zeta(k,1-y) - zeta(k,1-x)), and so for psi with k = 1. */
static void log_gamma_series(tl_wide *f, tl_real x, int degree, tl_real shrink) {
  if (degree == 0) return;
  if (x > TL_C(0.0)) {
    polygammas(f, tl_widen(x), degree, shrink);
  } else {
    tl_wide mirrored[MAX_DEGREE + 1], far[MAX_DEGREE + 1];
    const tl_real below = TL_LIBM(floor)(x);
    polygammas(f, tl_wide_sum(x, -below), degree, shrink);
    polygammas(mirrored, tl_wide_sum(below + TL_C(1.0), -x), degree, shrink);
    polygammas(far, tl_wide_sum(TL_C(1.0), -x), degree, shrink);
    for (int k = 1; k <= degree; k++) {
      const tl_wide between = tl_wide_add(mirrored[k], tl_wide_neg(far[k]));
      f[k] = tl_wide_add(f[k], k % 2 ? tl_wide_neg(between) : between);
    }
  }
  for (int k = 2; k <= degree; k++) f[k] = tl_wide_div(f[k], tl_widen((tl_real)(k % 2 ? -k : k)));
}

/* c = sum_k f[k] ((a - a_0)/shrink)^k. */
static void compose_shrunk(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *f, tl_real shrink) {
  tl_real *x = tl_scratch(cx, 1);
  for (int i = 0; i < cx->shape->ncoef; i++) x[i] = a[i] / shrink;
  tl_compose_blocks(cx, c, x, f, cx->shape->degree, 0);
}

/* True where x is no pole; otherwise c is rejected. */
static int off_the_poles(tl_ctx *cx, tl_real *c, tl_real x, tl_fn function) {
  if (!tl_accept(cx, c, x, function)) return 0;
  if (x > TL_C(0.0) || x != TL_LIBM(floor)(x)) return 1;
  tl_reject(cx, c, TL_DOMAIN, function);
  return 0;
}

/* The same for the logarithm, whose coefficient k falls like x^(1-k) above its poles: near x where the last ones would underflow. */
static tl_real log_shrink_for(tl_real x, int degree) {
  const tl_real steep = TL_LIBM(ldexp)(TL_C(1.0), -TL_MIN_EXP / (2 * degree + 2));
  return x > steep ? TL_C(1.0) / tl_normaliser(x) : shrink_for(x);
}

/* From here on log Gamma(x) is x (log x - 1) to the last bit but for smaller terms that are smooth too. */
static const tl_real FAR = TL_C(64.0) / TL_EPSILON;

/* log Gamma at x >= FAR on a brought to the size of 1, where f^(k)(x)/k! = (-1)^k x^(1-k)/(k (k-1)) alone would vanish: with y = scale
 * x coefficient k is (-1)^k x y^-k/(k (k-1)), and the first log x/scale. */
static void log_gamma_far(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real *f) {
  const tl_real scale = tl_normaliser(a[0]), y = scale * a[0];
  tl_real *u = tl_scratch(cx, 1), term = a[0] / y;
  for (int i = 0; i < cx->shape->ncoef; i++) u[i] = scale * a[i];
  f[1] = TL_LIBM(log)(a[0]) / scale;
  for (int k = 2; k <= cx->shape->degree; k++) {
    term = -term / y;
    f[k] = -term / (tl_real)(k * (k - 1));
  }
  tl_compose_blocks(cx, c, u, f, cx->shape->degree, 0);
}

void tl_lgamma(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!off_the_poles(cx, c, a[0], TL_FN_lgamma)) return;
  const int degree = cx->shape->degree;
  tl_wide l[MAX_DEGREE + 1];
  tl_real f[MAX_DEGREE + 1];
  f[0] = TL_LIBM(lgamma)(a[0]);
  if (a[0] >= FAR && degree > 0) {
    log_gamma_far(cx, c, a, f);
  } else {
    const tl_real shrink = log_shrink_for(a[0], degree);
    log_gamma_series(l, a[0], degree, shrink);
    for (int k = 1; k <= degree; k++) f[k] = tl_narrow(l[k]);
    compose_shrunk(cx, c, a, f, shrink);
  }
  tl_check(cx, c, TL_FN_lgamma);
}

/* Below STEEP Gamma may underflow although its derivatives beside a pole do not. Below DEAD they do too: coefficient k is about
 * e^(-k-1)/|DEAD|! at a distance e from the pole, and e is above TL_EPSILON |DEAD|. */
#if TL_MAX_EXP < 1024
static const tl_real STEEP = TL_C(-25.0), DEAD = TL_C(-300.0);
#elif TL_MAX_EXP == 1024
static const tl_real STEEP = TL_C(-150.0), DEAD = TL_C(-1000.0);
#else
static const tl_real STEEP = TL_C(-1500.0), DEAD = TL_C(-3000.0);
#endif

/* p Gamma(x), by Gamma(x) = Gamma(x+n)/(x (x+1) .. (x+n-1)) where Gamma(x) could underflow; the sums x+i are exact. */
static tl_real times_gamma(tl_wide p, tl_real x, tl_real value) {
  if (x >= STEEP) return p.hi * value + p.lo * value;
  if (x < DEAD) return TL_C(0.0);
  const tl_real n = TL_LIBM(ceil)(STEEP - x);
  tl_real product = tl_narrow(p) * TL_LIBM(tgamma)(x + n);
  for (tl_real i = n - TL_C(1.0); i >= TL_C(0.0); i -= TL_C(1.0)) product /= x + i;
  return product;
}

/* Where Gamma may underflow its series is made in a itself, whose growth makes up for it.
 * Gamma(x+h) = Gamma(x) p, k p_k = sum_{j=1..k} j l_j p_(k-j) with l of the logarithm. */
void tl_tgamma(tl_ctx *cx, tl_real *c, const tl_real *a) {
  if (!off_the_poles(cx, c, a[0], TL_FN_tgamma)) return;
  const int degree = cx->shape->degree;
  const tl_real x = a[0], shrink = x < STEEP ? TL_C(1.0) : shrink_for(x), value = TL_LIBM(tgamma)(x);
  tl_wide l[MAX_DEGREE + 1], p[MAX_DEGREE + 1];
  tl_real f[MAX_DEGREE + 1];
  log_gamma_series(l, x, degree, shrink);
  p[0] = tl_widen(TL_C(1.0));
  f[0] = value;
  for (int k = 1; k <= degree; k++) {
    p[k] = tl_widen(TL_C(0.0));
    for (int j = 1; j <= k; j++) p[k] = tl_wide_add(p[k], tl_wide_mul(tl_wide_mul(l[j], tl_widen((tl_real)j)), p[k - j]));
    p[k] = tl_wide_div(p[k], tl_widen((tl_real)k));
    f[k] = times_gamma(p[k], x, value);
  }
  compose_shrunk(cx, c, a, f, shrink);
  tl_check(cx, c, TL_FN_tgamma);
}
