/* Sine and cosine of vectors of numbers (see sincos_array.h), for vectors of type TL_V: included once for each.
 *
 *     TL_V_BITS                    the numbers' bits
 *     TL_V_NAME(name)              the name of a function for this type; there is tl_sincos_any, whether some number of a mask is true
 *     TL_SINCOS_LESS(rest, k, p)   rest - k p, rounded once, where the processor can; else not defined
 *
 * All but the functions are undefined at the end. */

/* x - k pi/2, k an integer and |k| <= 2^20: r + tail, |tail| at most half a unit in r's last place. near is r but for a part of 2^-53,
 * and there sooner. */
TL_INLINE void TL_V_NAME(tl_sincos_reduce)(TL_V *r, TL_V *tail, TL_V *near, const TL_V *x, const TL_V *k) {
#ifdef TL_SINCOS_LESS
  const TL_V first = TL_SINCOS_LESS(*x, *k, 0x1.921fb54442d18p0);
  *near = TL_SINCOS_LESS(first, *k, 0x1.1a62633145c06p-54);
  *tail = TL_SINCOS_LESS(first - *near, *k, 0x1.1a62633145c06p-54);
  *r = TL_SINCOS_LESS(*near, *k, 0x1.c1cd129024e08p-107);
#else
  const TL_V first = *x - *k * 0x1.921fb544p0 - *k * 0x1.0b46p-34;
  *near = first - *k * 0x1.1a626331p-54;
  *tail = (first - *near) - *k * 0x1.1a626331p-54;
  *r = *near - *k * 0x1.1701b839a252p-88;
#endif
}

/* All at once. 1 where one of them is too large, or no number, and has no result. */
TL_INLINE int TL_V_NAME(tl_sincos_vector)(TL_V *sine, TL_V *cosine, const TL_V *argument) {
  const TL_V x = *argument;
  const tl_real shift = 0x1.8p52; /* plus a number it has the nearest integer in its last bits */
  const unsigned long long sign = 1ULL << 63;
  /* Each sum has one product at most, so that a compiler that contracts them has no choice, and a number's result no company. */
  const TL_V shifted = x * 0x1.45f306dc9c883p-1 + shift, k = shifted - shift;
  TL_V r, tail, near;
  TL_V_NAME(tl_sincos_reduce)(&r, &tail, &near, &x, &k);

  const TL_V z = near * near, z2 = z * z, cube = near * z;
  tail = (TL_V)((TL_V_BITS)tail & (TL_V_BITS)(z > 0x1p-60));
  const TL_V p0 = -1.66666666666666307295e-01 + z * 8.33333333332211858878e-03;
  const TL_V p1 = -1.98412698295895385996e-04 + z * 2.75573136213857245213e-06;
  const TL_V p2 = -2.50507477628578072866e-08 + z * 1.58962301576546568060e-10;
  const TL_V q0 = 4.16666666666665929218e-02 + z * -1.38888888888730564116e-03;
  const TL_V q1 = 2.48015872888517045348e-05 + z * -2.75573141792967388112e-07;
  const TL_V q2 = 2.08757008419747316778e-09 + z * -1.13585363213876817300e-11;
  const TL_V p12 = p1 + z2 * p2, s = r + ((tail + cube * p0) + cube * z2 * p12);
  const TL_V q12 = q1 + z2 * q2, most = 1.0 - 0.5 * z, rest = ((1.0 - most) - 0.5 * z) - near * tail;
  const TL_V c = most + (rest + z2 * (q0 + z2 * q12));

  const TL_V_BITS quarter = (TL_V_BITS)shifted, odd = -(quarter & 1);
  const TL_V_BITS s_bits = (TL_V_BITS)s | ((TL_V_BITS)r & sign), c_bits = (TL_V_BITS)c; /* the sum above loses the sign of zero */
  *sine = (TL_V)(((c_bits & odd) | (s_bits & ~odd)) ^ ((quarter & 2) << 62));
  *cosine = (TL_V)(((s_bits & odd) | (c_bits & ~odd)) ^ (((quarter + 1) & 2) << 62));

  const TL_V_BITS large = ~(TL_V_BITS)((TL_V)((TL_V_BITS)x & ~sign) <= TL_SINCOS_LIMIT);
  return TL_V_NAME(tl_sincos_any)(&large);
}

/* The C library for those of the first `count` numbers that are too large for vectors. x may be s or c. */
static inline void TL_V_NAME(tl_sincos_large)(int count, TL_V *sine, TL_V *cosine, const TL_V *x) {
  for (int i = 0; i < count; i++) {
    const tl_real xi = (*x)[i];
    if (TL_LIBM(fabs)(xi) <= TL_SINCOS_LIMIT) continue;
    (*sine)[i] = TL_LIBM(sin)(xi);
    (*cosine)[i] = TL_LIBM(cos)(xi);
  }
}

#undef TL_V
#undef TL_V_BITS
#undef TL_V_NAME
#undef TL_SINCOS_LESS
