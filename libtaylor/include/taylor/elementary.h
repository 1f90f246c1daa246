/* Elementary functions of jets. Arguments and aliasing as in series.h. Each recurrence stands above its code.
 *
 * A value outside the function's domain sets TL_DOMAIN; a point of the domain where a coefficient of the shape does not exist sets
 * TL_SINGULAR (unless the shape is a single number). Then c holds no usable numbers. */
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

/* c = a^b; a^x and a^n with a constant exponent; x^b with a constant base. tl_powc takes a negative base where x is an integer. */
void tl_pow(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_powc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
void tl_powi(tl_ctx *cx, tl_real *c, const tl_real *a, int n);
void tl_rpow(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b);

void tl_hypot(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fabs(tl_ctx *cx, tl_real *c, const tl_real *a);
void tl_fmin(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fmax(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *d); /* a*b + d */
void tl_copysign(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);              /* |a| with the sign of b */

#ifdef __cplusplus
}
#endif

#endif
