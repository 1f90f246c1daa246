/* Comparisons of numbers of libtaylor's type. */
#include "taylor/real.h"
#if TL_REAL == TL_FLOAT128
#define MPFR_WANT_FLOAT128
#endif
#include "close_real.h"

#if TL_REAL == TL_FLOAT
#define FROM_MPFR mpfr_get_flt
#define TO_MPFR mpfr_set_flt
#elif TL_REAL == TL_DOUBLE
#define FROM_MPFR mpfr_get_d
#define TO_MPFR mpfr_set_d
#elif TL_REAL == TL_LONG_DOUBLE
#define FROM_MPFR mpfr_get_ld
#define TO_MPFR mpfr_set_ld
#else
#define FROM_MPFR mpfr_get_float128
#define TO_MPFR mpfr_set_float128
#endif

tl_real real_from_mpfr(const mpfr_t x) { return FROM_MPFR(x, MPFR_RNDN); }
void real_to_mpfr(mpfr_t result, tl_real x) { TO_MPFR(result, x, MPFR_RNDN); }

tl_real real_power_of_two(int e) { return TL_LIBM(ldexp)(TL_C(1.0), e); }

tl_real real_ulp(tl_real x) {
  const tl_real size = TL_LIBM(fabs)(x);
  return size < TL_MIN ? TL_MIN * TL_EPSILON : TL_LIBM(ldexp)(TL_EPSILON, TL_LIBM(ilogb)(size));
}

static int is_close(tl_real actual, tl_real expected, tl_real rtol, tl_real atol) {
  return actual == expected || TL_LIBM(fabs)(actual - expected) <= atol + rtol * TL_LIBM(fabs)(expected);
}

static void print_real(const char *name, tl_real x) {
  mpfr_t text;
  mpfr_init2(text, 128);
  real_to_mpfr(text, x);
  char digits[64];
  mpfr_snprintf(digits, sizeof digits, "%.36Rg", text);
  print_error("%s %s, ", name, digits);
  mpfr_clear(text);
}

static void print_difference(tl_real actual, tl_real expected, tl_real tolerance) {
  const tl_real difference = actual - expected;
  print_real("actual", actual);
  print_real("expected", expected);
  print_error("difference %.3g (%.3g ulp), allowed %.3g (%.3g ulp)\n", (double)difference, (double)(difference / real_ulp(expected)),
              (double)tolerance, (double)(tolerance / real_ulp(expected)));
}

void assert_real_close_at(tl_real actual, tl_real expected, tl_real rtol, tl_real atol, int index, const char *file, int line) {
  if (is_close(actual, expected, rtol, atol)) return;
  if (index >= 0) print_error("[%d] ", index);
  print_difference(actual, expected, atol + rtol * TL_LIBM(fabs)(expected));
  _fail(file, line);
}

void assert_jet_close_at(const tl_real *actual, const tl_real *expected, int n, tl_real rtol, tl_real atol, const char *file,
                         int line) {
  for (int i = 0; i < n; i++) assert_real_close_at(actual[i], expected[i], rtol, atol, i, file, line);
}

void assert_real_case(tl_real actual, tl_real expected, tl_real atol, const char *file, int line, const char *format, ...) {
  if (is_close(actual, expected, TL_C(0.0), atol)) return;
  va_list arguments;
  va_start(arguments, format);
  print_case(format, arguments);
  va_end(arguments);
  print_difference(actual, expected, atol);
  _fail(file, line);
}
