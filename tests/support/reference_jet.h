/* Truncated power series in high precision, as plainly as possible: a list of monomials, products by comparing every pair. It knows the
 * layout that libtaylor documents and derives it by itself. */
#ifndef TEST_REFERENCE_JET_H
#define TEST_REFERENCE_JET_H

#include <mpfr.h>

enum { REF_PRECISION = 400, REF_MAX_VAR = 8, REF_MAX_COEF = 1024 };

/* All monomials s^e[0] t_1^e[1] .. t_nvar^e[nvar] with e[0] <= curve and e[1]+..+e[nvar] <= order, in libtaylor's order. */
typedef struct ref_shape {
  int curve, nvar, order, degree, n;
  int exponent[REF_MAX_COEF][REF_MAX_VAR + 1];
} ref_shape;

void ref_shape_init(ref_shape *s, int curve, int nvar, int order);

/* Position of the monomial with these exponents, -1 where there is none. */
int ref_find(const ref_shape *s, const int *exponent);

typedef struct ref_jet {
  int n;
  mpfr_t *c;
} ref_jet;

ref_jet ref_new(const ref_shape *s); /* zero */
void ref_free(ref_jet *a);

void ref_set(ref_jet *c, const double *a);
void ref_mul(const ref_shape *s, ref_jet *c, const ref_jet *a, const ref_jet *b); /* c may be a or b */
void ref_add_scaled(ref_jet *c, mpfr_srcptr x, const ref_jet *a);                 /* c += x*a */

/* c = sum over i+j <= degree of f[i*(degree+1)+j] (a-a_0)^i (b-b_0)^j. */
void ref_compose2(const ref_shape *s, ref_jet *c, const ref_jet *a, const ref_jet *b, mpfr_t *f, int degree);

/* size_alpha += sum_beta |a_beta| |d_(alpha-beta)|: what a relative error of 1 in each coefficient of a does to f(a), d = f'(a). */
void ref_add_sensitivity(const ref_shape *s, ref_jet *size, const ref_jet *a, const ref_jet *d);

#endif
