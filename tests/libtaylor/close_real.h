/* Comparisons as in close.h for the number type of libtaylor, whichever it is, and its way to and from MPFR. */
#ifndef TEST_CLOSE_REAL_H
#define TEST_CLOSE_REAL_H

#include "close.h"
#include "taylor/real.h"

#include <mpfr.h>

/* |actual - expected| <= atol + rtol*|expected| for one number, for a jet of n; a NaN is close to nothing. */
#define assert_real_close(actual, expected, rtol, atol)                                                                                \
  assert_real_close_at((actual), (expected), (rtol), (atol), -1, __FILE__, __LINE__)
#define assert_jet_close(actual, expected, n, rtol, atol)                                                                              \
  assert_jet_close_at((actual), (expected), (n), (rtol), (atol), __FILE__, __LINE__)

/* The same bits, but for the sign of zero. */
#define assert_real_same(actual, expected) assert_real_close((actual), (expected), TL_C(0.0), TL_C(0.0))
#define assert_jet_same(actual, expected, n) assert_jet_close((actual), (expected), (n), TL_C(0.0), TL_C(0.0))

/* As assert_real_close with absolute tolerance and a text that says which case it was (printf format). */
void assert_real_case(tl_real actual, tl_real expected, tl_real atol, const char *file, int line, const char *format, ...);

/* The distance from |x| to the next larger number; that of TL_MIN below it. */
tl_real real_ulp(tl_real x);

/* 2^e. */
tl_real real_power_of_two(int e);

/* x rounded to nearest, and a number as it is: result has at least 113 bits. */
tl_real real_from_mpfr(const mpfr_t x);
void real_to_mpfr(mpfr_t result, tl_real x);

void assert_real_close_at(tl_real actual, tl_real expected, tl_real rtol, tl_real atol, int index, const char *file, int line);
void assert_jet_close_at(const tl_real *actual, const tl_real *expected, int n, tl_real rtol, tl_real atol, const char *file, int line);

#endif
