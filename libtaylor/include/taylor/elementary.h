/* Elementary functions of jets. Arguments and aliasing as in series.h. Each recurrence stands above its code.
 *
 * The value c[0] is the C library's for the same function, to the bit.
 *
 * A value outside the function's domain sets TL_DOMAIN; a point of the domain where a coefficient of the shape does not exist sets
 * TL_SINGULAR (unless the shape is a single number); an operand whose value is not finite, or a coefficient that overflows, sets
 * TL_NONFINITE. Then c holds no usable numbers.
 *
 *     sqrt                     DOMAIN below 0, SINGULAR at 0         cbrt, fabs         SINGULAR at 0
 *     log, log2, log10         DOMAIN at and below 0                 log1p              DOMAIN at and below -1
 *     asin, acos               DOMAIN past 1, SINGULAR at 1 and -1   atanh              DOMAIN at and past 1 and -1
 *     acosh                    DOMAIN below 1, SINGULAR at 1         hypot, atan2       SINGULAR at (0,0)
 *     fmin, fmax, fdim         SINGULAR at a tie of different jets   copysign           SINGULAR where either value is 0
 *     tgamma, lgamma           DOMAIN at 0, -1, -2, ..               fmod, remainder    DOMAIN at b = 0, SINGULAR at jumps
 *     pow, powc, powi, rpow    as said below                         floor .. rint      SINGULAR at jumps
 *
 * atan2 has its derivatives on the negative x axis too, where its value jumps from -pi to pi.
 *
 * Jumps. The derivatives of floor, ceil, trunc, round and rint are 0, and those of fmod and remainder are da - n db with their quotient
 * n, everywhere but where the value jumps: floor and ceil at integers, trunc at integers other than 0, round and rint halfway between
 * two, fmod where it is 0 and a is not, remainder where it is b/2 or -b/2. There no derivative exists, and whoever reaches such a point
 * hears of it rather than getting the derivative of one side: a table that is looked up at floor(x) has another row on either side of
 * x = 3, so that at 3 itself its slope is not defined. A single number (a shape of degree 0) has the value that C says.
 *
 * docs/status.md lists what every function reports at the ends of its domain and at the neighbouring numbers, order by order.
 *
 * Accuracy: docs/accuracy.md lists the worst error of each order. To degree 6 most functions are series in twice the precision, rounded
 * once and composed with the jet: their coefficients at x + t are right to an ulp or two at numbers of any size.
 *
 * Formulas. E is the Euler operator, E c = t c' in one variable: E c = g E a says that every coefficient of weight n is
 * n c_n = sum_{k=1..n} k a_k g_(n-k). With "series" the coefficients of f at a_0 go through Horner's scheme, c = sum_k f_k (a - a_0)^k.
 *
 * Cost, in products of two jets (see tl_mul): that of a recurrence is said beside its function. A series takes d - 1 products in a
 * shape of degree d, each cut short: in one variable together d^3/6 multiply-adds beside the d^2/2 of one product, in many variables
 * little more than one product. A series in two operands takes d (d+1)/2, cut short too. The coefficients f_k take some 10 d operations
 * in twice the precision, in two operands some 2 d^3. Functions that only copy cost nothing here. */
#ifndef TAYLOR_ELEMENTARY_H
#define TAYLOR_ELEMENTARY_H

#include "taylor/series.h"

#ifdef __cplusplus
extern "C" {
#endif

/* sqrt: 2 a E c = c E a. Cost 1.
 * cbrt: 3 a E c = c E a; a series to degree 6, from a root refined beyond the C library's. Above: cost 1. */
void tl_sqrt(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cbrt(tl_ctx *cx, tl_real *c, const tl_real *a);

/* exp, and expm1 but for its value: E c = c E a. Cost 1.
 * exp2: E c = log 2 c E a; a series to degree 6, above: cost 1. NONFINITE where they overflow; they underflow to 0. */
void tl_exp(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_expm1(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_exp2(tl_ctx *cx, tl_real *c, const tl_real *a);

/* log, log2, log10: a E c = E a, over log 2 or log 10. Cost 1.
 * log1p: (1 + a) E c = E a; a series to degree 6 from the exact sum 1 + a_0, above: cost 1. */
void tl_log(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log1p(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log2(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log10(tl_ctx *cx, tl_real *c, const tl_real *a);

/* E s = c E a, E c = -s E a, for any a_0 that is finite: the C library reduces the argument. Cost 2, together too.
 * sincos: the two results may not be the same array; failures have the names sin and cos. */
void tl_sin(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cos(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a);

/* E c = (1 + c^2) E a; a series to degree 6, above: cost 2. No double is a pole: the status is OK everywhere. */
void tl_tan(tl_ctx *cx, tl_real *c, const tl_real *a);

/* E c = +-E a/sqrt(1 - a^2), E a/(1 + a^2), from (1-a_0)(1+a_0) near the ends; series to degree 6, above: cost 3. */
void tl_asin(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_acos(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_atan(tl_ctx *cx, tl_real *c, const tl_real *a);

/* (x^2 + y^2) E c = x E y - y E x, the imaginary part of log(x + i y); a series in two operands to degree 6, above: cost 4. Neither the
 * size of (x,y) nor the ratio of its sides costs digits. */
void tl_atan2(tl_ctx *cx, tl_real *c, const tl_real *y, const tl_real *x);

/* E s = c E a, E c = s E a. Cost 2. NONFINITE where they overflow. */
void tl_sinh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cosh(tl_ctx *cx, tl_real *c, const tl_real *a);

/* E c = (1 - c^2) E a, with 1 - c^2 = 4 e/(1+e)^2, e = exp(-2 |a_0|); a series to degree 6, above: cost 2. */
void tl_tanh(tl_ctx *cx, tl_real *c, const tl_real *a);

/* E c = E a/sqrt(a^2 + 1), E a/sqrt((a-1)(a+1)), E a/((1-a)(1+a)); series to degree 6, above: cost 3. */
void tl_asinh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_acosh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_atanh(tl_ctx *cx, tl_real *c, const tl_real *a);

/* E c = +-2/sqrt(pi) exp(-a^2) E a, the exponential from the exact square of a_0; series to degree 6, above: cost 3. */
void tl_erf(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_erfc(tl_ctx *cx, tl_real *c, const tl_real *a);

/* The gamma function and log|gamma|: series of every degree, whose coefficients are psi and Hurwitz' zeta function at a_0,
 *     log|Gamma(a_0 + h)| = log|Gamma(a_0)| + psi(a_0) h + sum_{k>1} (-1)^k zeta(k, a_0)/k h^k,
 * some 20 (degree + 1) divisions and products in twice the precision, three times as many below 0. Their stack holds some 700 numbers.
 * The C library's lgamma also writes its global signgam. */
void tl_tgamma(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_lgamma(tl_ctx *cx, tl_real *c, const tl_real *a);

/* c = a^b; a^x and a^n with a constant exponent, a E c = x c E a; x^b with a constant base, E c = log x c E b. Series to degree 6, pow
 * in two operands, and rpow of every degree; above: powc 1, or a series where n > 0, pow 5. A constant exponent is: an integer, with
 * any base but 0 below 0 (DOMAIN); or another number, with a base above 0, or 0 where it is larger than the shape's degree (0: SINGULAR
 * for smaller positive ones; DOMAIN otherwise). tl_pow with an exponent that varies needs a base above 0, or 0 and an exponent larger
 * than the degree; other points where the value exists are SINGULAR. tl_rpow needs x > 0, or x = 0 and b[0] > 0. In single precision n
 * must be exact. */
void tl_pow(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_powc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n);
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b);

/* hypot: c E c = a E a + b E b; a series in two operands to degree 6, above: cost 7. It squares nothing that could overflow.
 * fabs, fmin, fmax, fdim and copysign copy one of their operands, with a sign. fma costs 1; its value is rounded once. */
void tl_hypot(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fabs(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_fmin(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fmax(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fdim(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);                  /* a - b where a > b, else 0 */
void tl_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *d); /* a*b + d */
void tl_copysign(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);              /* |a| with the sign of b */

/* The value stepwise, all derivatives 0. tl_rint is nearbyint too. */
void tl_floor(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_ceil(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_trunc(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_round(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_rint(tl_ctx *cx, tl_real *c, const tl_real *a);

/* a - n b with n = a/b cut to an integer (fmod) or rounded to the nearest (remainder). The value is exact. In the derivatives n is
 * exact below 1/TL_EPSILON, above it right to about an ulp; a quotient beyond the range of numbers sets TL_NONFINITE unless b is
 * constant. */
void tl_fmod(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_remainder(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);

void tl_scalbn(tl_ctx *cx, tl_real *c, const tl_real *a, int n); /* a 2^n, ldexp too */

/* C's rounding to float, of the value alone: the derivatives are those of the operation before it. A value that is no float any more
 * sets TL_NONFINITE. */
void tl_float(tl_ctx *cx, tl_real *c, const tl_real *a);

#ifdef __cplusplus
}
#endif

#endif
