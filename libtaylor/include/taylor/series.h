/* Jets and their arithmetic. A jet is an array of shape->ncoef coefficients in the layout of shape.h.
 *
 * Everywhere: cx gives the shape and takes the status; c is the result, a and b are operands, each ncoef numbers; c may be a, b or
 * both; operands may not overlap in part. A result with a number that is not finite sets TL_NONFINITE. */
#ifndef TAYLOR_SERIES_H
#define TAYLOR_SERIES_H

#include "taylor/context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* c = x, a constant: all other coefficients zero. */
void tl_const(tl_ctx *cx, tl_real *c, tl_real x);

/* c = n, a constant that is an integer: TL_NONFINITE where a tl_real does not hold it exactly. */
void tl_integer(tl_ctx *cx, tl_real *c, long long n);

/* c = x + t_i: the seed of variable i, 0 <= i < nvar. */
void tl_seed(tl_ctx *cx, tl_real *c, tl_real x, int i);

/* c = a. */
void tl_copy(tl_ctx *cx, tl_real *c, const tl_real *a);

/* Copies n jets, one behind the other, as they are: what is not a number yet is none afterwards, and nothing is reported. */
void tl_move(tl_ctx *cx, tl_real *c, const tl_real *a, ptrdiff_t n);

/* c = a + b, a - b, -a. */
void tl_add(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_sub(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_neg(tl_ctx *cx, tl_real *c, const tl_real *a);

/* c = x*a, a + x, x - a, c + x*a with a constant x. */
void tl_scale(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
void tl_shift(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
void tl_rsub(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a);
void tl_axpy(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a);

/* c = a*b, and c += a*b (there c may be neither a nor b). Cost: one multiply-add per pair of monomials whose product is in the shape.
 */
void tl_mul(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_muladd(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);

/* c = a/b, x/b, a/x. TL_DOMAIN where the divisor's value is 0. */
void tl_div(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
void tl_rdiv(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *b);
void tl_divc(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);

/* c = f(a) from f's Taylor coefficients at a[0]: f[k] = f^(k)(a[0])/k!, k = 0..shape->degree. */
void tl_compose(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *f);

/* The coefficient, and the partial derivative d^(k+|alpha|)/ds^k dt^alpha at zero; 0 outside the shape. alpha as in tl_index. */
tl_real tl_coef(const tl_shape *s, const tl_real *a, int k, const int *alpha);
tl_real tl_deriv(const tl_shape *s, const tl_real *a, int k, const int *alpha);

#ifdef __cplusplus
}
#endif

#endif
