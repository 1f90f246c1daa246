/* The hand-written chain's sine and cosine, and its solver in two forms: registers.h (straight-line scalars) and rows.h (vectors). */
#ifndef BENCH_HAND_KERNELS_H
#define BENCH_HAND_KERNELS_H

#include <string.h>

#define INLINE static inline __attribute__((always_inline))
#define UNROLL _Pragma("GCC unroll 64")
#define PADDED(n) (((n) + 7) / 8 * 8) /* a row's length in whole vectors of any width */
#define ALIGNED __attribute__((aligned(64)))

#ifndef LANES
#define LANES 4 /* of a vector: 4 or 8 */
#endif

typedef double vector __attribute__((vector_size(8 * LANES)));
typedef long long integers __attribute__((vector_size(8 * LANES)));

/* Within 1.1 ulp for |x| < 1e6, not checked: pi/2 in two parts, polynomials of Cephes. */
INLINE void sincos_vector(vector x, vector *s, vector *c) {
  const vector round = (vector){0} + 0x1.8p52;
  const vector shifted = x * 0x1.45f306dc9c883p-1 + round, k = shifted - round;
  const vector r = (x - k * 0x1.921fb54442d18p0) - k * 0x1.1a62633145c07p-54;
  const vector z = r * r, z2 = z * z, z4 = z2 * z2;
  const vector sine = r + r * z *
                              ((-1.66666666666666307295e-01 + z * 8.33333333332211858878e-03) +
                               z2 * (-1.98412698295895385996e-04 + z * 2.75573136213857245213e-06) +
                               z4 * (-2.50507477628578072866e-08 + z * 1.58962301576546568060e-10));
  const vector cosine = (1.0 - 0.5 * z) + z2 * ((4.16666666666665929218e-02 + z * -1.38888888888730564116e-03) +
                                                z2 * (2.48015872888517045348e-05 + z * -2.75573141792967388112e-07) +
                                                z4 * (2.08757008419747316778e-09 + z * -1.13585365213876817300e-11));
  const integers q = (integers)shifted, odd = -(q & 1);
  const integers sines = (integers)sine, cosines = (integers)cosine;
  *s = (vector)(((cosines & odd) | (sines & ~odd)) ^ ((q & 2) << 62));
  *c = (vector)(((sines & odd) | (cosines & ~odd)) ^ (((q + 1) & 2) << 62));
}

/* s, c: PADDED(n). */
INLINE void sincos_array(int n, const double *x, double *s, double *c) {
  UNROLL for (int k = 0; k < n; k += LANES) {
    vector v = {0}, sine, cosine;
    if (k + LANES <= n) memcpy(&v, x + k, sizeof v);
    UNROLL for (int i = 0; i < LANES; i++) if (k + LANES > n && k + i < n) v[i] = x[k + i];
    sincos_vector(v, &sine, &cosine);
#ifdef REGISTERS
    UNROLL for (int i = 0; i < LANES; i++) if (k + i < n) s[k + i] = sine[i], c[k + i] = cosine[i];
#else
    memcpy(s + k, &sine, sizeof sine), memcpy(c + k, &cosine, sizeof cosine);
#endif
  }
}

#ifdef REGISTERS
#include "hand/registers.h"
#else
#include "hand/rows.h"
#endif

/* Elements of M (cell) and of J's right-hand sides (entry): single numbers or vectors of neighbours in a row. */
INLINE cell cell_at(const double *x) {
  cell value;
  memcpy(&value, x, sizeof value);
  return value;
}
INLINE void put_cell(double *x, cell value) { memcpy(x, &value, sizeof value); }

INLINE entry entry_at(const double *x) {
  entry value;
  memcpy(&value, x, sizeof value);
  return value;
}
INLINE void put_entry(double *x, entry value) { memcpy(x, &value, sizeof value); }

#endif
