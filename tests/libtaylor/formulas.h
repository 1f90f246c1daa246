/* Other people's formulas for Taylor coefficients, in plain double arithmetic, for libtaylor's errors to be compared with. */
#ifndef TEST_FORMULAS_H
#define TEST_FORMULAS_H

enum { FORMULA_ORDER = 6, FORMULA_SIZE = FORMULA_ORDER + 1 };

/* A truncated power series: c[i][j] belongs to h^i g^j, i + j <= FORMULA_ORDER. */
typedef struct plain_series {
  double c[FORMULA_SIZE][FORMULA_SIZE];
} plain_series;

/* c = f(a) or f(a,b) by one school's formulas. */
typedef struct formula {
  const char *school, *function; /* function as in functions.h */
  void (*one)(plain_series *c, const plain_series *a);
  void (*two)(plain_series *c, const plain_series *a, const plain_series *b);
} formula;

/* textbook: the recurrences of Moore, Griewank and Walther, Neidinger: c' = g a' for each function, with the C library's values, and
 *     expm1 a = exp a - 1, log1p a = log(1+a), hypot = sqrt(a^2+b^2), atan2 = atan(a/b), pow = exp(b log a), cbrt a = a^(1/3).
 * DACE (version 2): f's Taylor coefficients at a_0, put into Horner's scheme; tan, tanh, asin and others from simpler functions.
 * TaylorSeries.jl: the textbook's, but for the functions listed here. */
extern const formula formulas[];
extern const int nformulas;

#endif
