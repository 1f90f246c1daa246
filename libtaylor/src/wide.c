/* The logarithm and the exponential in twice the precision. */
#include "wide.h"

/* log 2: the first 24 bits, which are exact in every precision, and the rest. */
const tl_wide tl_wide_ln2 = {.hi = TL_C(0.693147182464599609375), .lo = TL_C(-1.9046542999577678785418234319244998656397446e-9)};
static const tl_real ROOT_HALF = TL_C(0.707106781186547524401);

/* log a = e log 2 + 2 atanh z, a = 2^e m, m between the roots of 1/2 and 2, z = (m-1)/(m+1), |z| < 0.172; z + z^3/3 in twice the
 * precision, the other terms, below 2e-4 of the sum, not. */
tl_wide tl_wide_log(tl_wide a) {
  enum { NTERM = TL_MANT_DIG / 5 + 4 }; /* a term more gives 5 bits */
  int e = 0;
  if (TL_LIBM(frexp)(a.hi, &e) < ROOT_HALF) e--;
  const tl_wide m = {.hi = TL_LIBM(ldexp)(a.hi, -e), .lo = TL_LIBM(ldexp)(a.lo, -e)}, one = tl_widen(TL_C(1.0));
  const tl_wide z = tl_wide_div(tl_wide_add(m, tl_wide_neg(one)), tl_wide_add(m, one)), square = tl_wide_mul(z, z);
  tl_real sum = TL_C(0.0);
  for (int j = NTERM; j > 1; j--) sum = square.hi * (sum + TL_C(1.0) / (tl_real)(2 * j + 1));
  const tl_wide third = tl_wide_div(square, tl_widen(TL_C(3.0))), rest = tl_wide_add(third, tl_widen(square.hi * sum));
  const tl_wide half = tl_wide_add(z, tl_wide_mul(z, rest));
  return tl_wide_add(tl_wide_mul(tl_wide_ln2, tl_widen((tl_real)e)), tl_wide_add(half, half));
}

/* One step of Newton's method for log e = x from the C library's e. */
tl_wide tl_wide_exp(tl_real x) {
  const tl_real e = TL_LIBM(exp)(x);
  if (!(e >= TL_MIN / TL_EPSILON && TL_ISFINITE(e))) return tl_widen(e);
  const tl_wide error = tl_wide_add(tl_widen(x), tl_wide_neg(tl_wide_log(tl_widen(e))));
  return tl_wide_quick_sum(e, e * tl_narrow(error));
}
