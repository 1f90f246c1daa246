/* Comparisons of numbers. */
#include "close.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

double ulp_of(double x) {
  const double size = fabs(x);
  return size < DBL_MIN ? DBL_MIN * DBL_EPSILON : ldexp(DBL_EPSILON, ilogb(size));
}

double ulp_difference(double actual, double expected) { return fabs(actual - expected) / ulp_of(expected); }

static int is_close(double actual, double expected, double rtol, double atol) {
  return actual == expected || fabs(actual - expected) <= atol + rtol * fabs(expected);
}

static void print_difference(double actual, double expected, double tolerance) {
  print_error("actual %.17g, expected %.17g, difference %.3g (%.3g ulp), allowed %.3g\n", actual, expected, actual - expected,
              ulp_difference(actual, expected), tolerance);
}

void assert_close_at(double actual, double expected, double rtol, double atol, int index, const char *file, int line) {
  if (is_close(actual, expected, rtol, atol)) return;
  if (index >= 0) print_error("[%d] ", index);
  print_difference(actual, expected, atol + rtol * fabs(expected));
  _fail(file, line);
}

void assert_all_close_at(const double *actual, const double *expected, int n, double rtol, double atol, const char *file, int line) {
  for (int i = 0; i < n; i++) assert_close_at(actual[i], expected[i], rtol, atol, i, file, line);
}

void print_case(const char *format, va_list arguments) {
  char text[256];
  vsnprintf(text, sizeof text, format, arguments);
  print_error("%s: ", text);
}

void assert_close_case(double actual, double expected, double atol, const char *file, int line, const char *format, ...) {
  if (is_close(actual, expected, 0.0, atol)) return;
  va_list arguments;
  va_start(arguments, format);
  print_case(format, arguments);
  va_end(arguments);
  print_difference(actual, expected, atol);
  _fail(file, line);
}
