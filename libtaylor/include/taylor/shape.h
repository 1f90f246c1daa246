/* Shapes: which monomials a jet carries, and where each one stands in its flat array.
 *
 * A shape is the downward-closed set of monomials
 *
 *     s^k t^alpha,   0 <= k <= curve,   |alpha| <= order,   alpha a multi-index over nvar variables,
 *
 * where s is the curve parameter (time along a motion) and t_1..t_nvar are the directions of differentiation. The algebra
 * R[s,t] / <every monomial outside the shape> is nilpotent apart from its constants. The named shapes are members of this one family:
 *
 *     Jacobian J(v)     curve 0, v variables, order 1        univariate T(1,m)     curve m, no variables
 *     Hessian H(v)      curve 0, v variables, order 2        motion K x {1,t}      curve d, v tangents, order 1
 *     third order       curve 0, v variables, order 3        general T(v,m)        curve 0, v variables, order m
 *
 * Layout. The coefficients of one (order p in t, power k of s) stand together and are called a block; blocks are sorted by p, then
 * by k. So c[0] is the value, a complete shape is in graded order, and a motion shape is |K| scalars followed by one row of v
 * tangents per power of s. Within a block of order p the monomials t_i1 t_i2 .. t_ip (i1 <= i2 <= .. <= ip) are in lexicographic
 * order of (i1,..,ip); p = 2 is the packed upper triangle, row by row.
 *
 * A coefficient is not a derivative: derivative = k! alpha! * coefficient. */
#ifndef TAYLOR_SHAPE_H
#define TAYLOR_SHAPE_H

#include "taylor/config.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a caller asks for. */
typedef struct tl_spec {
  int curve; /* highest power of the curve parameter s, 0..TL_MAX_CURVE */
  int nvar;  /* number of variables t, >= 0 */
  int order; /* highest order in t, 0..TL_MAX_ORDER */
} tl_spec;

/* A shape with its tables. Read-only after tl_shape_init and free to be shared between threads. */
typedef struct tl_shape {
  int curve, nvar, order;      /* as asked; order is 0 where nvar is 0 */
  int ncoef;                   /* coefficients of one jet */
  int nblock;                  /* (curve+1)*(order+1) */
  int degree;                  /* curve+order: the (degree+1)-th power of a jet without value vanishes */
  int nhom[TL_MAX_ORDER + 1];  /* monomials of each order p in t: binomial(nvar+p-1, p) */
  int start[TL_MAX_ORDER + 1]; /* position of block (p, k=0); block (p,k) starts at start[p] + k*nhom[p] */
  const unsigned *product[TL_MAX_ORDER + 1][TL_MAX_ORDER + 1];
  /* product[p][q][i*nhom[q]+j]: place, in order p+q, of monomial i of order p times monomial j of order q, for 1 <= p <= q and
   * q >= 2; null elsewhere (order 0 scales, and the product of two rows needs no table) */
} tl_shape;

/* The named shapes as specifications. */
tl_spec tl_jacobian(int nvar);
tl_spec tl_hessian(int nvar);
tl_spec tl_third_order(int nvar);
tl_spec tl_complete(int nvar, int order);
tl_spec tl_univariate(int order);
tl_spec tl_motion(int curve, int ntangent);

/* Number of coefficients of one jet; 0 where the specification is invalid or does not fit an int. */
int tl_ncoef(tl_spec spec);

/* Bytes of table memory that tl_shape_init needs (may be 0 for a valid shape: ask tl_ncoef whether it is valid). */
size_t tl_shape_bytes(tl_spec spec);

/* Fills *s, its tables in memory (aligned as for unsigned, at least tl_shape_bytes(spec) bytes, which must live as long as the shape).
 * Returns 0, or -1 where the specification is invalid or bytes too few; then *s is unusable and memory unread. */
int tl_shape_init(tl_shape *s, tl_spec spec, void *memory, size_t bytes);

/* Position of s^k t^alpha (alpha: nvar exponents, may be null for all zero); -1 where the monomial is outside the shape. */
int tl_index(const tl_shape *s, int k, const int *alpha);

/* The same for s^k t_i, and for s^k t_i t_j (any order of i, j). */
int tl_index1(const tl_shape *s, int k, int i);
int tl_index2(const tl_shape *s, int k, int i, int j);

/* The monomial at a position: its power of s in *k and its exponents in alpha (nvar). The inverse of tl_index. */
void tl_monomial(const tl_shape *s, int position, int *k, int *alpha);

#ifdef __cplusplus
}
#endif

#endif
