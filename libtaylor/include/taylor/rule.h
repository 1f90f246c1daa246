/* Functions with a rule of the user's: external C functions whose Taylor coefficients the user supplies. Arguments and aliasing as in
 * series.h; failures are recorded under the name compose, and the line tells which call it was. */
#ifndef TAYLOR_RULE_H
#define TAYLOR_RULE_H

#include "taylor/series.h"

#ifdef __cplusplus
extern "C" {
#endif

/* c = f(a): rule fills f[0..degree] with Taylor coefficients f^(k)(x)/k! at x and returns status bits, TL_OK or what went wrong. */
typedef unsigned tl_rule(tl_real *f, tl_real x, int degree, const void *user);
void tl_apply(tl_ctx *cx, tl_real *c, const tl_real *a, tl_rule *rule, const void *user);

/* The same for a function of nargs arguments, 1 <= nargs <= TL_RULE_ARGS: rule fills f with the Taylor coefficients
 * (D^alpha f)(x)/alpha! of all |alpha| <= degree, each at f[tl_rule_index(nargs, alpha)], and returns status bits. f is NaN before, so
 * that one which the rule forgets sets TL_NONFINITE.
 *
 * The order is that of the complete shape {0, nargs, degree}: by |alpha|, then the monomial with more of the first argument first. For
 * two arguments (x,y) and degree 2:
 *
 *     f[0] = f    f[1] = f_x    f[2] = f_y    f[3] = f_xx/2    f[4] = f_xy    f[5] = f_yy/2
 *
 * and degree 3 goes on with x^3, x^2 y, x y^2, y^3: a coefficient's place does not depend on the degree. There are
 * tl_rule_size(nargs, degree) = binomial(nargs + degree, nargs) of them, at most TL_RULE_MAX: that is degree 16 with three arguments
 * and degree 10 with four; a larger degree sets TL_NO_SPACE. c may be any of args. No frame is taken; the stack holds TL_RULE_MAX
 * numbers. Cost: binomial(nargs + degree - 1, nargs) products of two jets, most of which are cut short. */
typedef unsigned tl_rule_n(tl_real *f, const tl_real *x, int degree, const void *user);
void tl_apply_n(tl_ctx *cx, tl_real *c, int nargs, const tl_real *const *args, tl_rule_n *rule, const void *user);

#define TL_RULE_ARGS 4
#ifndef TL_RULE_MAX
#define TL_RULE_MAX 1001 /* define it smaller where the stack is small: 35 serve four arguments up to degree 3 */
#endif

/* Number of coefficients, and the place of the one with exponents alpha (nargs numbers); nargs as above, 0 <= degree <= TL_MAX_CURVE +
 * TL_MAX_ORDER. */
int tl_rule_size(int nargs, int degree);
int tl_rule_index(int nargs, const int *alpha);

#ifdef __cplusplus
}
#endif

#endif
