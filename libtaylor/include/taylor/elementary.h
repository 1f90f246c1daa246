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
 * Accuracy: tests/libtaylor/ulp_table prints the worst error of each order. Up to degree 4 the inverse functions, tan, tanh, cbrt,
 * hypot, atan2 and pow are series in twice the precision composed with the jet, and their coefficients at x + t are rounded once (those
 * of tan, tanh and pow within a few ulp, as they start from rounded values).
 *
 * Cost, in products of two jets: exp.. log.., sqrt, powc, rpow 1; sin, cos, sincos, sinh, cosh 2; erf, erfc 3; powi with n > 0 min(n,
 * degree) - 1; tgamma and lgamma degree - 1, and about 20 (degree + 1) divisions and products of two numbers in twice the precision,
 * three times as many for a < 0. With degree d up to 4: asin.. atanh, tan, tanh, cbrt d - 1, hypot, atan2, pow d (d + 1)/2, most of
 * them cut short, and some ten to fifty operations in twice the precision; above: cbrt 1, tan, tanh 2, asin.. atanh 3, atan2 4, pow 5,
 * hypot
 * 7. The rest are copies. */
#ifndef TAYLOR_ELEMENTARY_H
#define TAYLOR_ELEMENTARY_H

#include "taylor/series.h"

#ifdef __cplusplus
extern "C" {
#endif

void tl_sqrt(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cbrt(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_exp(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_expm1(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_exp2(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log1p(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log2(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_log10(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_sin(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cos(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a); /* the two results may not be the same array */
void tl_tan(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_asin(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_acos(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_atan(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_atan2(tl_ctx *cx, tl_real *c, const tl_real *y, const tl_real *x);
void tl_sinh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_cosh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_tanh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_asinh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_acosh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_atanh(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_erf(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_erfc(tl_ctx *cx, tl_real *c, const tl_real *a);

/* The gamma function and log|gamma|; their stack holds some 700 numbers. The C library's lgamma also writes its
 * global signgam. */
void tl_tgamma(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_lgamma(tl_ctx *cx, tl_real *c, const tl_real *a);

/* c = a^b; a^x and a^n with a constant exponent; x^b with a constant base. A constant exponent is: an integer, with any base but 0
 * below 0 (DOMAIN); or another number, with a base above 0, or 0 where it is larger than the shape's degree (0: SINGULAR for smaller
 * positive ones; DOMAIN otherwise). tl_pow with an exponent that varies needs a base above 0, or 0 and an exponent larger than the
 * degree; other points where the value exists are SINGULAR. tl_rpow needs x > 0, or x = 0 and b[0] > 0. In single precision n must be
 * exact. */
void tl_pow(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_powc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n);
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b);

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
