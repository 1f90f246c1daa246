/* The mathematics of the firmware, -DTL_MATH_HEADER='"mathematics.h"': math.h but for sine and cosine, which are made here of sums and
 * products alone. Built without contraction of them, every processor that rounds as IEEE 754 says gives the same bits.
 *
 * With k the integer nearest to 2x/pi and r = x - k pi/2, sin x and cos x are +-sin r and +-cos r, or the other way round. pi/2 is the
 * sum of numbers of which all but the last have so few digits that their products with k are exact. sin r and cos r are Taylor
 * polynomials that economisation has made equally wrong over |r| <= pi/4: fdlibm's (k_sin.c, k_cos.c), and in single precision those of
 * Cephes (sinf.c). Within 2.5 ulp in single precision and 1.6 in double for |x| <= MATHEMATICS_LIMIT; not a number beyond, where an
 * angle has lost its meaning and the model's functions return EOM_MOTION_NOT_FINITE. */
#ifndef MATHEMATICS_H
#define MATHEMATICS_H

#include <math.h>

#define MATHEMATICS_LIMIT 8192 /* rad */

/* k, and x - k pi/2. */
static inline float mathematics_reduce_f(float *r, float x) {
  const float shift = 0x1.8p23f, k = (x * 0x1.45f306p-1f + shift) - shift; /* the nearest integer */
  *r = (((x - k * 0x1.92p0f) - k * 0x1.fb4p-12f) - k * 0x1.444p-24f) - k * 0x1.68c23400p-39f;
  return k;
}

static inline float mathematics_kernel_f(int cosine, float r) {
  const float z = r * r;
  if (cosine) return (1.0f - 0.5f * z) + z * z * (4.166664568298827e-2f + z * (-1.388731625493765e-3f + z * 2.443315711809948e-5f));
  return r + r * z * (-1.6666654611e-1f + z * (8.3321608736e-3f + z * -1.9515295891e-4f));
}

static inline double mathematics_reduce(double *r, double x) {
  const double shift = 0x1.8p52, k = (x * 0x1.45f306dc9c883p-1 + shift) - shift;
  *r = ((x - k * 0x1.921fb544p0) - k * 0x1.0b46p-34) - k * 0x1.1a62633145c07p-54;
  return k;
}

static inline double mathematics_kernel(int cosine, double r) {
  const double z = r * r;
  if (cosine)
    return (1.0 - 0.5 * z) +
           z * z *
               (4.16666666666666019037e-02 +
                z * (-1.38888888888741095749e-03 +
                     z * (2.48015872894767294178e-05 +
                          z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  return r + r * z *
                 (-1.66666666666666324348e-01 +
                  z * (8.33333333332248946124e-03 +
                       z * (-1.98412698298579493134e-04 +
                            z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
}

/* Sine for quarters = 0, cosine for 1: of x + quarters pi/2. */
#define MATHEMATICS_WAVE(real, name, reduce, kernel)                                                                                   \
  static inline real name(real x, int quarters) {                                                                                      \
    real r;                                                                                                                            \
    if (!(x <= (real)MATHEMATICS_LIMIT && x >= -(real)MATHEMATICS_LIMIT)) return (real)NAN;                                            \
    const int turned = (int)reduce(&r, x) + quarters;                                                                                  \
    const real wave = kernel(turned & 1, r);                                                                                           \
    return turned & 2 ? -wave : wave;                                                                                                  \
  }

MATHEMATICS_WAVE(float, mathematics_wave_f, mathematics_reduce_f, mathematics_kernel_f)
MATHEMATICS_WAVE(double, mathematics_wave, mathematics_reduce, mathematics_kernel)

#define sinf(x) mathematics_wave_f(x, 0)
#define cosf(x) mathematics_wave_f(x, 1)
#define sin(x) mathematics_wave(x, 0)
#define cos(x) mathematics_wave(x, 1)

#endif
