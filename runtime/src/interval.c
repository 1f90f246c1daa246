/* Confidence intervals of Lyapunov exponents from block means.
 *
 * The growth of rho_i in B blocks of equal time gives B means x of the local exponent, of a stationary process as it is assumed, with
 * autocovariances g_k. The variance of their mean is S/B with S = g_0 + 2 sum_(k>0) g_k. In a motion that obeys the same law backwards
 * in time G_j = g_2j + g_2j+1 are positive and fall (C. J. Geyer, Practical Markov chain Monte Carlo, Statist. Sci. 7, 1992,
 * section 3.3: the initial monotone sequence), so that the sum ends before the first measured G_j <= 0 and none counts for more than
 * the one before:
 *
 *     S = -g_0 + 2 sum_j min(G_0, .., G_j) over L/2 pairs, L lags.
 *
 * Deviations from the blocks' own mean lose S/B in each g_k, (2L-1) S/B in all: S is divided by 1 - (2L-1)/B. A sum over L lags is
 * known as well as the variance of B/2L blocks of 2L: Student's distribution with B/2L - 1 degrees of freedom, and at least 2, takes
 * the place of the normal one. Where S comes out below g_0/2, neighbours make up for each other; the blocks then count as independent
 * ones: an interval is never narrower than for these. */
#include "eom/lyapunov.h"

#include <assert.h>

#define EOM_FEWEST_BLOCKS 8

typedef struct sample {
  int count;
  tl_real x[EOM_LYAPUNOV_BLOCKS];
} sample;

/* 97.5 % point of Student's distribution, five terms of Fisher's expansion (Abramowitz and Stegun 26.7.5): 2e-4 at 7 degrees, 0.04
 * at 2. */
static tl_real student(tl_real v) {
  const tl_real z = TL_C(1.959963984540054), z2 = z * z;
  const tl_real g1 = (z2 + TL_C(1.0)) / TL_C(4.0);
  const tl_real g2 = ((TL_C(5.0) * z2 + TL_C(16.0)) * z2 + TL_C(3.0)) / TL_C(96.0);
  const tl_real g3 = (((TL_C(3.0) * z2 + TL_C(19.0)) * z2 + TL_C(17.0)) * z2 - TL_C(15.0)) / TL_C(384.0);
  const tl_real g4 = ((((TL_C(79.0) * z2 + TL_C(776.0)) * z2 + TL_C(1482.0)) * z2 - TL_C(1920.0)) * z2 - TL_C(945.0)) / TL_C(92160.0);
  return z * (TL_C(1.0) + (g1 + (g2 + (g3 + g4 / v) / v) / v) / v);
}

/* x becomes deviations from the mean, which is returned. */
static tl_real centre(sample *s) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < s->count; i++) sum += s->x[i];
  const tl_real mean = sum / (tl_real)s->count;
  for (int i = 0; i < s->count; i++) s->x[i] -= mean;
  return mean;
}

/* g_k of deviations. */
static tl_real covariance(const sample *s, int k) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i + k < s->count; i++) sum += s->x[i] * s->x[i + k];
  return sum / (tl_real)s->count;
}

/* S, and how many lags it has. */
static tl_real sum_covariances(const sample *s, int *lags) {
  tl_real least = TL_MAX, sum = -covariance(s, 0);
  int k = 0;
  for (; k + 1 < s->count; k += 2) {
    const tl_real pair = covariance(s, k) + covariance(s, k + 1);
    if (!(pair > TL_C(0.0))) break;
    least = TL_LIBM(fmin)(least, pair);
    sum += TL_C(2.0) * least;
  }
  *lags = k;
  return sum;
}

/* Half the width, from deviations. */
static tl_real half_of(const sample *s) {
  const tl_real B = (tl_real)s->count, g0 = covariance(s, 0);
  int lags;
  const tl_real S = sum_covariances(s, &lags);
  if (S <= TL_C(0.5) * g0) return student(B - TL_C(1.0)) * TL_LIBM(sqrt)(g0 / (B - TL_C(1.0)));
  const tl_real L = (tl_real)lags, left = TL_LIBM(fmax)(TL_C(1.0) - (TL_C(2.0) * L - TL_C(1.0)) / B, TL_C(0.1));
  const tl_real degrees = TL_LIBM(fmax)(B / (TL_C(2.0) * L) - TL_C(1.0), TL_C(2.0));
  return student(degrees) * TL_LIBM(sqrt)(TL_LIBM(fmax)(S, g0) / (left * B));
}

int eom_lyapunov_interval(const eom_lyapunov *ly, int i, tl_real *mean, tl_real *half_width) {
  assert(i >= 0 && i < ly->k);
  sample s = {.count = ly->nblock};
  const tl_real time = (tl_real)ly->block_marks * ly->options.interval;
  for (int b = 0; b < s.count; b++) s.x[b] = ly->block[b * ly->k + i] / time;
  *half_width = TL_MAX;
  *mean = ly->t == ly->t0 ? TL_C(0.0) : ly->rho[i] / (ly->t - ly->t0);
  if (s.count < EOM_FEWEST_BLOCKS) return 0;
  *mean = centre(&s);
  *half_width = half_of(&s);
  return s.count;
}
