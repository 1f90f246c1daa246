/* The hand-written chain's sine, cosine and solver: scalars without an array in memory (REGISTERS; with COLUMNS > 1
 * the right-hand sides of J are vectors), or libtaylor's kernels for rows. */
#ifndef BENCH_HAND_KERNELS_H
#define BENCH_HAND_KERNELS_H

#include "taylor/ldl.h"
#include "taylor/sincos_array.h"

#ifdef REGISTERS

#include <string.h>

#ifndef COLUMNS
#define COLUMNS 1 /* right-hand sides that are solved for at a time */
#endif
#if COLUMNS == 1
#define EACH_RIGHT_SIDE TL_UNROLL
#else
#define EACH_RIGHT_SIDE
#endif

#define FIRST_COLUMN(i) (i)
#define END_COLUMN(n, padded) (n)

typedef double hand_vector __attribute__((vector_size(32)));
typedef long long hand_integers __attribute__((vector_size(32)));
enum { HAND_LANES = 4 };

/* Within 1.1 ulp for |x| < 1e6, not checked; pi/2 in two parts, polynomials of Cephes. */
TL_INLINE void hand_sincos_vector(hand_vector x, hand_vector *s, hand_vector *c) {
  const hand_vector round = (hand_vector){0} + 0x1.8p52;
  const hand_vector shifted = x * 0x1.45f306dc9c883p-1 + round, k = shifted - round;
  const hand_vector r = (x - k * 0x1.921fb54442d18p0) - k * 0x1.1a62633145c07p-54;
  const hand_vector z = r * r, z2 = z * z, z4 = z2 * z2;
  const hand_vector sine = r + r * z *
                                   ((-1.66666666666666307295e-01 + z * 8.33333333332211858878e-03) +
                                    z2 * (-1.98412698295895385996e-04 + z * 2.75573136213857245213e-06) +
                                    z4 * (-2.50507477628578072866e-08 + z * 1.58962301576546568060e-10));
  const hand_vector cosine = (1.0 - 0.5 * z) + z2 * ((4.16666666666665929218e-02 + z * -1.38888888888730564116e-03) +
                                                     z2 * (2.48015872888517045348e-05 + z * -2.75573141792967388112e-07) +
                                                     z4 * (2.08757008419747316778e-09 + z * -1.13585365213876817300e-11));
  const hand_integers q = (hand_integers)shifted, odd = -(q & 1);
  const hand_integers sines = (hand_integers)sine, cosines = (hand_integers)cosine;
  *s = (hand_vector)(((cosines & odd) | (sines & ~odd)) ^ ((q & 2) << 62));
  *c = (hand_vector)(((sines & odd) | (cosines & ~odd)) ^ (((q + 1) & 2) << 62));
}

TL_INLINE void hand_sincos(int n, const double *x, double *s, double *c) {
  TL_UNROLL for (int k = 0; k < n; k += HAND_LANES) {
    hand_vector v = {0}, sine, cosine;
    TL_UNROLL for (int i = 0; i < HAND_LANES; i++) if (k + i < n) v[i] = x[k + i];
    hand_sincos_vector(v, &sine, &cosine);
    TL_UNROLL for (int i = 0; i < HAND_LANES; i++) if (k + i < n) s[k + i] = sine[i], c[k + i] = cosine[i];
  }
}

/* M becomes D and L (unit, by rows of L'). */
TL_INLINE void hand_factor(int n, double *w, int ld, double *dinv) {
  TL_UNROLL for (int i = 0; i < n; i++) {
    dinv[i] = 1.0 / w[i * ld + i];
    TL_UNROLL for (int p = i + 1; p < n; p++) {
      double l = w[i * ld + p] * dinv[i];
      TL_UNROLL for (int j = p; j < n; j++) w[p * ld + j] -= l * w[i * ld + j];
    }
    TL_UNROLL for (int j = i + 1; j < n; j++) w[i * ld + j] *= dinv[i];
  }
}

TL_INLINE void hand_back(int n, double *x, const double *w, int ld) {
  TL_UNROLL for (int i = n - 1; i > 0; i--) TL_UNROLL for (int j = 0; j < i; j++) x[j] -= w[j * ld + i] * x[i];
}

TL_INLINE void hand_solve(int n, double *x, const double *w, int ld, const double *dinv) {
  TL_UNROLL for (int i = 0; i < n; i++) TL_UNROLL for (int j = i + 1; j < n; j++) x[j] -= w[i * ld + j] * x[i];
  TL_UNROLL for (int i = 0; i < n; i++) x[i] *= dinv[i];
  hand_back(n, x, w, ld);
}

TL_INLINE void hand_factor_solve(int n, double *x, double *w, int ld, double *dinv) {
  hand_factor(n, w, ld, dinv);
  hand_solve(n, x, w, ld, dinv);
}

#if COLUMNS == 1
typedef double hand_columns;
#else
typedef double hand_columns __attribute__((vector_size(8 * COLUMNS)));
#endif

/* COLUMNS right-hand sides at a time. */
TL_INLINE void hand_solve_many(int n, int k, double *b, int ldb, const double *w, int ld, const double *dinv) {
  EACH_RIGHT_SIDE for (int column = 0; column < k; column += COLUMNS) {
    hand_columns x[N];
    TL_UNROLL for (int i = 0; i < n; i++) memcpy(&x[i], b + i * ldb + column, sizeof x[i]);
    TL_UNROLL for (int i = 0; i < n; i++) TL_UNROLL for (int j = i + 1; j < n; j++) x[j] -= w[i * ld + j] * x[i];
    TL_UNROLL for (int i = 0; i < n; i++) x[i] *= dinv[i];
    TL_UNROLL for (int i = n - 1; i > 0; i--) TL_UNROLL for (int j = 0; j < i; j++) x[j] -= w[j * ld + i] * x[i];
    TL_UNROLL for (int i = 0; i < n; i++) memcpy(b + i * ldb + column, &x[i], sizeof x[i]);
  }
}

#else

#define FIRST_COLUMN(i) ((i) / TL_ROW_PAD * TL_ROW_PAD) /* whole vectors */
#define END_COLUMN(n, padded) (padded)

TL_INLINE void hand_sincos(int n, const double *x, double *s, double *c) { tl_sincos_array(n, x, s, c); }

TL_INLINE void hand_factor_solve(int n, double *x, double *w, int ld, double *dinv) { (void)tl_ldl_factor_solve(n, x, w, ld, dinv, x); }

TL_INLINE void hand_solve(int n, double *x, const double *w, int ld, double *dinv) { tl_ldl_solve(n, x, w, ld, dinv, x); }

TL_INLINE void hand_solve_many(int n, int k, double *b, int ldb, const double *w, int ld, double *dinv) {
  tl_ldl_solve_many(n, k, b, ldb, w, ld, dinv);
}

#endif

#endif
