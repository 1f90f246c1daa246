/* Comparisons of numbers that fail a CMocka test with index, both values, their difference and the difference in ulps. */
#ifndef TEST_CLOSE_H
#define TEST_CLOSE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* |actual - expected| <= atol + rtol*|expected|; equal infinities are close, a NaN is close to nothing. */
#define assert_close(actual, expected, rtol, atol) assert_close_at((actual), (expected), (rtol), (atol), -1, __FILE__, __LINE__)

/* The same for n numbers; the first that differs fails. */
#define assert_all_close(actual, expected, n, rtol, atol)                                                                              \
  assert_all_close_at((actual), (expected), (n), (rtol), (atol), __FILE__, __LINE__)

/* The same bits, but for the sign of zero. */
#define assert_same(actual, expected) assert_close((actual), (expected), 0.0, 0.0)
#define assert_all_same(actual, expected, n) assert_all_close((actual), (expected), (n), 0.0, 0.0)

/* As assert_close with absolute tolerance and a text that says which case it was (printf format). */
void assert_close_case(double actual, double expected, double atol, const char *file, int line, const char *format, ...);

/* Prints that text, for a comparison that fails. */
void print_case(const char *format, va_list arguments);

/* |actual - expected| in units of the last place of expected. */
double ulp_difference(double actual, double expected);

/* The distance from |x| to the next larger double; that of the smallest normal number below it. */
double ulp_of(double x);

void assert_close_at(double actual, double expected, double rtol, double atol, int index, const char *file, int line);
void assert_all_close_at(const double *actual, const double *expected, int n, double rtol, double atol, const char *file, int line);

#endif
