/* Blocks: the homogeneous parts (order p in t, power k of s) of jets, and the sums over them that every recurrence is made of.
 *
 * The Euler operator E = s d/ds + sum t_i d/dt_i multiplies block B = (p,k) by its weight |B| = p+k. A univariate recurrence
 * k c_k = sum j a_j g_(k-j) from c' = g a' is therefore, word for word, the recurrence |B| c_B = sum |B1| a_B1 g_B2 over B1 + B2 = B
 * from E c = g E a, in every shape. Private to the library. */
#ifndef TAYLOR_BLOCK_H
#define TAYLOR_BLOCK_H

#include "taylor/series.h"

#include <assert.h>

/* True for shapes that have one monomial of each degree: a curve, and one variable. Their jets are plain univariate series. */
static inline int tl_is_series(const tl_shape *s) { return s->ncoef == s->degree + 1; }

/* One block: its monomials stand at jet[at .. at+n-1]. */
typedef struct tl_block {
  int p, k; /* order in t, power of s */
  int weight;
  int at, n;
} tl_block;

/* The blocks above the value in ascending order: for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)). */
static inline tl_block tl_make_block(const tl_shape *s, int p, int k) {
  return (tl_block){.p = p, .k = k, .weight = p + k, .at = s->start[p] + k * s->nhom[p], .n = s->nhom[p]};
}
static inline tl_block tl_next_block(const tl_shape *s, tl_block b) {
  if (b.k < s->curve) return tl_make_block(s, b.p, b.k + 1);
  if (b.p < s->order) return tl_make_block(s, b.p + 1, 0);
  return (tl_block){.n = 0};
}
static inline tl_block tl_first_block(const tl_shape *s) { return tl_next_block(s, tl_make_block(s, 0, 0)); }

/* The factor z + u|B1| + v|B2| of a term a_B1 b_B2. */
typedef struct tl_factor {
  tl_real z, u, v;
} tl_factor;

/* out += sum over B1 + B2 = B with B1, B2 > 0 of (z + u|B1| + v|B2|) a_B1 b_B2. out: b.n numbers outside all blocks of a and b below
 * B. a, b: jets, of which only blocks below B are read. */
void tl_add_interior(const tl_shape *s, tl_block b, tl_real *out, tl_factor f, const tl_real *a, const tl_real *g);

/* Elementwise on one block of n numbers. */
void tl_row_zero(int n, tl_real *c);
void tl_row_scale(int n, tl_real *c, tl_real x);                                                  /* c *= x */
void tl_row_divide(int n, tl_real *c, tl_real d);                                                 /* c /= d */
void tl_row_divide_weight(int n, tl_real *c, int w);                                              /* c /= w, a block's weight */
void tl_row_add(int n, tl_real *c, tl_real x, const tl_real *a);                                  /* c += x*a; c may not be a */
void tl_row_combine(int n, tl_real *c, tl_real x, const tl_real *a, tl_real y, const tl_real *b); /* c = x*a + y*b; c may be a or b */

/* Records a failure and fills c with NaN. */
void tl_reject(tl_ctx *cx, tl_real *c, unsigned bits, tl_fn function);
void tl_reject_in_lane(tl_ctx *cx, tl_real *c, unsigned bits, tl_fn function, int lane);

/* True where x is finite; otherwise c is rejected with TL_NONFINITE. */
int tl_accept(tl_ctx *cx, tl_real *c, tl_real x, tl_fn function);

/* Sets TL_NONFINITE where a number of c is not finite. */
void tl_check(tl_ctx *cx, const tl_real *c, tl_fn function);

/* Scratch jet number i. */
static inline tl_real *tl_scratch(tl_ctx *cx, int i) {
  assert(cx->scratch && i < TL_NSCRATCH);
  return cx->scratch + (size_t)i * (size_t)cx->shape->ncoef;
}

/* a itself, or its copy in scratch jet i where a is the result c. */
const tl_real *tl_unaliased(tl_ctx *cx, const tl_real *a, const tl_real *c, int i);

/* The power of two by which a jet with value x (finite) is multiplied to bring the value to [1,2); both the factor and its reciprocal
 * are normal numbers. 1 for x = 0. For one number, not for lanes. */
tl_real tl_normaliser(tl_real x);

/* By how much a recurrence may exceed its largest coefficient on the way. */
#define TL_HEADROOM TL_C(1024.0)

/* Recurrences that several functions share. Each takes the value c[0] as given and fills the rest.
 *
 *   tl_exp_blocks        E c = u c E a             c may not be a
 *   tl_integral_blocks   E c = x g E a             c may not be a or g
 *   tl_circle_blocks     E s = c E a, E c = sign s E a       a may be neither s nor c
 *   tl_power_blocks      q a E c = p c E a         c = constant * a^(p/q); c may not be a; a[0] not 0
 *   tl_log_blocks        a E c = rate E a                           c may not be a; a[0] not 0
 *   tl_quotient_blocks   c = a/b                   c may be a, not b; b[0] not 0
 *   tl_product_blocks    c = a b                   without the value; c may be a or b
 *   tl_square_blocks     c = x a^2                 without the value; c may not be a
 *   tl_horner_step       c = c (h - h[0]) + f      with the value, in the blocks of weight at most top; c may not be h
 *   tl_compose_blocks    c = sum f_k (a - a[0])^k  with the value, k = 0..top <= degree; uses scratch jet i; c may be a
 *   tl_compose_n_blocks  c = sum f_alpha prod (args_i - args_i[0])^alpha_i with the value, |alpha| <= degree, places as tl_rule_index;
 *                        uses scratch jets 0..nargs-1, which args may not be; c may be any of args */
void tl_exp_blocks(const tl_shape *s, tl_real *c, tl_real u, const tl_real *a);
void tl_integral_blocks(const tl_shape *s, tl_real *c, tl_real x, const tl_real *g, const tl_real *a);
void tl_circle_blocks(const tl_shape *s, tl_real *sine, tl_real *cosine, tl_real sign, const tl_real *a);
void tl_power_blocks(const tl_shape *s, tl_real *c, tl_real p, tl_real q, const tl_real *a);
void tl_log_blocks(const tl_shape *s, tl_real *c, tl_real rate, const tl_real *a);
void tl_quotient_blocks(const tl_shape *s, tl_real *c, const tl_real *a, const tl_real *b);
void tl_product_blocks(const tl_shape *s, tl_real *c, const tl_real *a, const tl_real *b);
void tl_square_blocks(const tl_shape *s, tl_real *c, tl_real x, const tl_real *a);
void tl_horner_step(const tl_shape *s, tl_real *c, const tl_real *h, tl_real f, int top);
void tl_compose_blocks(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *f, int top, int i);
void tl_compose_n_blocks(tl_ctx *cx, tl_real *c, int nargs, const tl_real *const *args, const tl_real *f);

#endif
