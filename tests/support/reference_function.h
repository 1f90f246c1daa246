/* Taylor coefficients of the elementary functions by differences of MPFR's values in very high precision: no formula for any derivative
 * is used, so that nothing can be wrong in the same way as a recurrence. */
#ifndef TEST_REFERENCE_FUNCTION_H
#define TEST_REFERENCE_FUNCTION_H

#include "random.h"
#include "reference_jet.h"

enum { REF_MAX_DEGREE = 8 };

/* Where the arguments of a function are drawn from: anchor + side*2^u, u uniform in [lo, hi); side 0 takes either sign. */
typedef struct ref_region {
  double anchor;
  int side;
  double lo, hi;
} ref_region;

/* A function of one variable, or of two. */
typedef struct ref_function {
  const char *name;
  int (*one)(mpfr_t f, const mpfr_t x, mpfr_rnd_t);
  int (*two)(mpfr_t f, const mpfr_t x, const mpfr_t y, mpfr_rnd_t);
  double (*reach)(double x, double y); /* about the distance from x to the nearest complex singularity, or less */
  double (*reach_y)(double x, double y);
  double (*digits)(double x, double y); /* bits by which coefficients differ in size beyond powers of x; null: none */
  ref_region x[4], y[4];                /* as many as have lo < hi */
  double hard[12];                      /* more arguments x, up to the first NaN */
  int nhard_y;
  double hard_y[16]; /* more arguments y */
} ref_function;

extern const ref_function ref_functions[];
extern const int ref_nfunctions;

const ref_function *ref_lookup(const char *name);

/* A random argument from the function's regions. */
void ref_draw(const ref_function *f, rng *r, double *x, double *y);

/* A random argument of either sign, uniform in the exponent over all numbers, subnormal ones too, where the function has a value. */
void ref_draw_anywhere(const ref_function *f, rng *r, double *x, double *y);

/* f[i*(degree+1)+j] = coefficient of h^i g^j of f(x+h, y+g), i+j <= degree (j = 0 for one variable); degree <= REF_MAX_DEGREE. The
 * caller has initialised the (degree+1)^2 numbers to REF_PRECISION. */
void ref_taylor(const ref_function *function, double x, double y, int degree, mpfr_t *f);

/* result = f(a,b); size = the sensitivity of each of its coefficients to relative errors of the coefficients of a and b, so that
 * size_alpha / |result_alpha| is the condition number of coefficient alpha. b is ignored for one variable. */
void ref_apply(const ref_function *function, const ref_shape *s, ref_jet *result, ref_jet *size, const double *a, const double *b);

#endif
