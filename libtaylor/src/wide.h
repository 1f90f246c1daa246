/* Numbers of twice the precision: the unevaluated sum hi + lo, |lo| at most half a unit in the last place of hi. For the few scalars
 * whose rounding would go into every coefficient of a jet. Relative error of an operation: a few units of TL_EPSILON^2, relative to the
 * larger operand for a sum. Private to the library. */
#ifndef TAYLOR_WIDE_H
#define TAYLOR_WIDE_H

#include "taylor/real.h"

typedef struct tl_wide {
  tl_real hi, lo;
} tl_wide;

static inline tl_wide tl_widen(tl_real x) { return (tl_wide){.hi = x, .lo = TL_C(0.0)}; }
static inline tl_real tl_narrow(tl_wide a) { return a.hi + a.lo; }
static inline tl_wide tl_wide_neg(tl_wide a) { return (tl_wide){.hi = -a.hi, .lo = -a.lo}; }

/* x + y exactly, for |x| >= |y|, and for any two. */
static inline tl_wide tl_wide_quick_sum(tl_real x, tl_real y) {
  const tl_real sum = x + y;
  return (tl_wide){.hi = sum, .lo = y - (sum - x)};
}
static inline tl_wide tl_wide_sum(tl_real x, tl_real y) {
  const tl_real sum = x + y, part = sum - x;
  return (tl_wide){.hi = sum, .lo = (x - (sum - part)) + (y - part)};
}

/* x * y exactly. */
static inline tl_wide tl_wide_product(tl_real x, tl_real y) {
  const tl_real product = x * y;
  return (tl_wide){.hi = product, .lo = TL_LIBM(fma)(x, y, -product)};
}

static inline tl_wide tl_wide_add(tl_wide a, tl_wide b) {
  const tl_wide high = tl_wide_sum(a.hi, b.hi), low = tl_wide_sum(a.lo, b.lo), sum = tl_wide_quick_sum(high.hi, high.lo + low.hi);
  return tl_wide_quick_sum(sum.hi, sum.lo + low.lo);
}

static inline tl_wide tl_wide_mul(tl_wide a, tl_wide b) {
  const tl_wide p = tl_wide_product(a.hi, b.hi);
  return tl_wide_quick_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
}

/* a/b from two digits of the quotient: q, and the rest a - q b divided by b. */
static inline tl_wide tl_wide_div(tl_wide a, tl_wide b) {
  const tl_real q = a.hi / b.hi;
  const tl_wide p = tl_wide_product(q, b.hi);
  const tl_real rest = ((a.hi - p.hi) - p.lo) + (a.lo - q * b.lo);
  return tl_wide_quick_sum(q, rest / b.hi);
}

/* The root of a positive number: s, and the rest a - s^2 divided by 2 s. */
static inline tl_wide tl_wide_sqrt(tl_wide a) {
  const tl_real s = TL_LIBM(sqrt)(a.hi);
  return tl_wide_quick_sum(s, (TL_LIBM(fma)(-s, s, a.hi) + a.lo) / (TL_C(2.0) * s));
}

extern const tl_wide tl_wide_ln2; /* log 2 */

/* The logarithm of a positive number, to 1e-4 TL_EPSILON. */
tl_wide tl_wide_log(tl_wide a);

/* exp(x), as precise; only as precise as the C library's where it is not a normal number. */
tl_wide tl_wide_exp(tl_real x);

/* Up to this degree of the shape most functions compute their Taylor coefficients in twice the precision and compose them with the jet.
 * In many variables that takes hardly more than one product of jets, as only the last step of Horner's scheme reaches the highest
 * order; a recurrence serves every higher degree. */
enum { TL_WIDE_DEGREE = 6 };

#endif
