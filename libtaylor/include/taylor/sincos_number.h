/* Sine and cosine of one number without the C library, for float and double where there are no vectors: on a small processor both at
 * once take half the time and a fifth of the code of its two functions, and none of their stack.
 *
 * x = q pi/2 + r + tail with |r| <= pi/4 and |tail| below half a unit in r's last place; then polynomials: fdlibm's, and for float
 * those of FreeBSD's msun. Where the processor has such numbers and x is small, x - k pi/2 is found with parts of pi/2 whose products
 * with k are exact but for the last. Elsewhere it is x 2/pi mod 4 in integers (M. Payne and R. Hanek, Radian reduction for
 * trigonometric functions, 1983): of 2/pi only the bits count that are worth less than 4 after the product with x's last bit, and so
 * many more that those cover what can cancel, 2^-31 for float and 2^-62 for double, and a significand and its tail. */
#ifndef TAYLOR_SINCOS_NUMBER_H
#define TAYLOR_SINCOS_NUMBER_H

#include <stdint.h>
#include <string.h>

#include "taylor/kernel.h"

#if TL_REAL == TL_FLOAT
typedef uint32_t tl_sincos_bits;
#define TL_SINCOS_QUARTER 0x1.921fb6p-1f /* pi/4, and the next number for the largest without reduction */
#define TL_SINCOS_SMALL 100.0f           /* |k| <= 64 */
#define TL_SINCOS_TINY 0x1p-12f
enum { TL_SINCOS_BITS = 32, TL_SINCOS_BIAS = 127, TL_SINCOS_WORDS = 3, TL_SINCOS_FACTORS = 1, TL_SINCOS_TABLE = 10 };
#else
typedef uint64_t tl_sincos_bits;
#define TL_SINCOS_QUARTER 0x1.921fb54442d18p-1
#define TL_SINCOS_SMALL 0x1.9p20 /* |k| <= 2^20 */
#define TL_SINCOS_TINY 0x1p-27
enum { TL_SINCOS_BITS = 64, TL_SINCOS_BIAS = 1023, TL_SINCOS_WORDS = 6, TL_SINCOS_FACTORS = 2, TL_SINCOS_TABLE = 41 };
#endif

typedef struct tl_sincos_pair {
  tl_real sine, cosine;
} tl_sincos_pair;

typedef struct tl_sincos_rest {
  tl_real r, tail;
  uint32_t quadrant; /* mod 4 */
} tl_sincos_rest;

/* 32 bits from bit `shift` on, 0..31. */
static inline uint32_t tl_sincos_word(const uint32_t *words, int shift) {
  return (uint32_t)((((uint64_t)words[0] << 32 | words[1]) << shift) >> 32);
}

/* The upper half of a product. */
static inline tl_sincos_bits tl_sincos_times_quarter(tl_sincos_bits x) {
#if TL_REAL == TL_FLOAT
  return (uint32_t)((uint64_t)x * 0xc90fdaa2u >> 32);
#else
  const uint64_t high = x >> 32, low = (uint32_t)x, c1 = 0xc90fdaa2u, c0 = 0x2168c235u;
  const uint64_t a = low * c0 >> 32, b = high * c0 + a, c = low * c1 + (uint32_t)b;
  return high * c1 + (b >> 32) + (c >> 32);
#endif
}

/* In integers. |x| > TL_SINCOS_TINY, finite. */
static inline tl_sincos_rest tl_sincos_by_integers(tl_real x) {
  static const uint32_t two_over_pi[] = {
      0x00000000u, 0x00000000u, 0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu, 0xdebbc561u,
#if TL_REAL != TL_FLOAT
      0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu, 0xe88235f5u, 0x2ebb4484u, 0xe99c7026u, 0xb45f7e41u,
      0x3991d639u, 0x835339f4u, 0x9c845f8bu, 0xbdf9283bu, 0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u,
      0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u, 0x1f8d5d08u, 0x56033046u, 0xfc7b6babu,
      0xf0cfbc20u,
#endif
  };
  _Static_assert(sizeof two_over_pi / sizeof *two_over_pi == TL_SINCOS_TABLE, "of words that can be asked for");
  enum { DIGITS = TL_MANT_DIG, FRACTION = DIGITS - 1, REST = TL_SINCOS_BITS - DIGITS };
  tl_sincos_bits bits;
  memcpy(&bits, &x, sizeof bits);
  const int negative = (int)(bits >> (TL_SINCOS_BITS - 1));
  bits = bits << 1 >> 1;
  const int from = (int)(bits >> FRACTION) - TL_SINCOS_BIAS - FRACTION + 62; /* x = m 2^(from - 62) */
  const tl_sincos_bits m = (bits & (((tl_sincos_bits)1 << FRACTION) - 1)) | (tl_sincos_bits)1 << FRACTION;

  /* m 2/pi mod 4, as a number of quarter turns: the two first bits before the point. */
  const uint32_t *window = two_over_pi + from / 32;
  uint32_t product[TL_SINCOS_WORDS + 1] = {0};
  for (int factor = 0; factor < TL_SINCOS_FACTORS; factor++) {
    const uint32_t part = (uint32_t)(m >> 16 * factor >> 16 * factor);
    uint64_t sum = 0;
    for (int i = TL_SINCOS_WORDS - 1; i >= factor; i--) {
      sum = (sum >> 32) + product[i - factor] + (uint64_t)part * tl_sincos_word(window + i, from % 32);
      product[i - factor] = (uint32_t)sum;
    }
  }

  /* To the nearest quarter turn: a fraction within 1/2, of which the sign goes apart. */
  const uint32_t beyond = product[0] >> 29 & 1;
  tl_sincos_rest rest = {.quadrant = (product[0] >> 30) + beyond};
  for (int i = 0; i < TL_SINCOS_WORDS; i++) product[i] ^= 0u - beyond;
  product[0] &= 0x1fffffffu;
  int zeros = 0;
  const uint32_t *first = product;
  for (; zeros < 32 * (TL_SINCOS_WORDS - TL_SINCOS_FACTORS) && *first == 0; zeros += 32) first++;
  int shift = 0;
  for (int step = 16; step > 0; step /= 2)
    if (*first << shift >> (32 - step) == 0) shift += step;
  zeros += shift;
  tl_sincos_bits fraction = tl_sincos_word(first, shift);
#if TL_REAL != TL_FLOAT
  fraction = fraction << 32 | tl_sincos_word(first + 1, shift);
#endif

  /* In radians: as many bits as r has, and the rest of them. */
  const tl_sincos_bits radians = tl_sincos_times_quarter(fraction), tail = radians & (((tl_sincos_bits)1 << REST) - 1);
  const tl_sincos_bits exponent = (tl_sincos_bits)(TL_SINCOS_BIAS + 3 - zeros - TL_SINCOS_BITS) << FRACTION;
  tl_real unit;
  memcpy(&unit, &exponent, sizeof unit);
  if ((int)beyond != negative) unit = -unit;
#if TL_REAL == TL_FLOAT
  rest.r = (tl_real)(radians - tail) * unit;
#else
  rest.r = ((tl_real)(uint32_t)(radians >> 32) * TL_C(0x1p32) + (tl_real)(uint32_t)(radians - tail)) * unit;
#endif
  rest.tail = (tl_real)(uint32_t)tail * unit;
  if (negative) rest.quadrant = 0u - rest.quadrant;
  return rest;
}

#if !TL_SOFT_NUMBERS
/* With numbers. |x| <= TL_SINCOS_SMALL. */
static inline tl_sincos_rest tl_sincos_by_numbers(tl_real x) {
#if TL_REAL == TL_FLOAT
  const tl_real shift = 0x1.8p23f, shifted = x * 0x1.45f306p-1f + shift, k = shifted - shift;
  const tl_real first = x - k * 0x1.921f8p+0f, second = k * 0x1.aa22p-19f, third = k * 0x1.68c234p-39f;
#else
  const tl_real shift = 0x1.8p52, shifted = x * 0x1.45f306dc9c883p-1 + shift, k = shifted - shift;
  const tl_real first = x - k * 0x1.921fb544p0 - k * 0x1.0b46p-34, second = k * 0x1.1a626331p-54, third = k * 0x1.1701b839a252p-88;
#endif
  const tl_real near = first - second;
  const tl_sincos_rest rest = {near - third, (first - near) - second, (uint32_t)(int32_t)k};
  return rest;
}
#endif

/* sin and cos of r + tail. */
static inline tl_sincos_pair tl_sincos_polynomials(tl_real r, tl_real tail) {
  const tl_real z = r * r, half = TL_C(0.5) * z, most = TL_C(1.0) - half;
#if TL_REAL == TL_FLOAT
  const tl_real s = -0x1.555556p-3f + z * (0x1.111108p-7f + z * (-0x1.a00f9ep-13f + z * 0x1.6cd878p-19f));
  const tl_real c = 0x1.55553ep-5f + z * (-0x1.6c087ep-10f + z * 0x1.99342ep-16f);
#else
  const tl_real s4 = -2.50507477628578072866e-08 + z * 1.58962301576546568060e-10;
  const tl_real s = -1.66666666666666307295e-01 +
                    z * (8.33333333332211858878e-03 + z * (-1.98412698295895385996e-04 + z * (2.75573136213857245213e-06 + z * s4)));
  const tl_real c3 = -2.75573141792967388112e-07 + z * (2.08757008419747316778e-09 + z * -1.13585363213876817300e-11);
  const tl_real c = 4.16666666666665929218e-02 + z * (-1.38888888888730564116e-03 + z * (2.48015872888517045348e-05 + z * c3));
#endif
  const tl_sincos_pair pair = {r + (tail + r * z * s), most + (((TL_C(1.0) - most) - half) + (z * z * c - r * tail))};
  return pair;
}

/* sin x and cos x, each within 1.1 ulp; where x is infinite or no number, neither is one. */
static inline tl_sincos_pair tl_sincos_number(tl_real x) {
  const tl_real size = TL_LIBM(fabs)(x);
  if (size <= TL_SINCOS_QUARTER) {
    const tl_sincos_pair tiny = {x, TL_C(1.0)};
    return size < TL_SINCOS_TINY ? tiny : tl_sincos_polynomials(x, TL_C(0.0));
  }
  if (!(size <= TL_MAX)) {
    const tl_sincos_pair none = {x - x, x - x};
    return none;
  }
#if TL_SOFT_NUMBERS
  const tl_sincos_rest rest = tl_sincos_by_integers(x);
#else
  const tl_sincos_rest rest = size <= TL_SINCOS_SMALL ? tl_sincos_by_numbers(x) : tl_sincos_by_integers(x);
#endif
  tl_sincos_pair pair = tl_sincos_polynomials(rest.r, rest.tail);
  if ((rest.quadrant & 1) != 0) {
    const tl_real sine = pair.sine;
    pair.sine = pair.cosine;
    pair.cosine = -sine;
  }
  if ((rest.quadrant & 2) != 0) {
    pair.sine = -pair.sine;
    pair.cosine = -pair.cosine;
  }
  return pair;
}

#endif
