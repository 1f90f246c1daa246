/* Confidence intervals of Lyapunov exponents from block means.
 *
 * The growth of rho_i in B blocks of equal time gives B means of the local exponent. Their mean is lambda_i over those blocks; for
 * independent blocks t = (mean - true)/sqrt(s2/B) has Student's distribution with B-1 degrees of freedom. Blocks shorter than the
 * correlation time are not independent: while the correlation r of neighbours is more than chance (2/sqrt(B)) neighbours are merged,
 * down to EOM_FEWEST_BLOCKS; what correlation is left widens the interval as for an autoregressive process, by sqrt((1+r)/(1-r)). */
#include "eom/lyapunov.h"

#include <assert.h>

#define EOM_FEWEST_BLOCKS 8

typedef struct sample {
  int count;
  tl_real x[EOM_LYAPUNOV_BLOCKS];
} sample;

/* 97.5 % point of Student's distribution, five terms of Fisher's expansion (Abramowitz and Stegun 26.7.5): 2e-4 at 7 degrees. */
static tl_real student(int degrees) {
  const tl_real z = TL_C(1.959963984540054), z2 = z * z, v = (tl_real)degrees;
  const tl_real g1 = (z2 + TL_C(1.0)) / TL_C(4.0);
  const tl_real g2 = ((TL_C(5.0) * z2 + TL_C(16.0)) * z2 + TL_C(3.0)) / TL_C(96.0);
  const tl_real g3 = (((TL_C(3.0) * z2 + TL_C(19.0)) * z2 + TL_C(17.0)) * z2 - TL_C(15.0)) / TL_C(384.0);
  const tl_real g4 = ((((TL_C(79.0) * z2 + TL_C(776.0)) * z2 + TL_C(1482.0)) * z2 - TL_C(1920.0)) * z2 - TL_C(945.0)) / TL_C(92160.0);
  return z * (TL_C(1.0) + (g1 + (g2 + (g3 + g4 / v) / v) / v) / v);
}

static tl_real mean_of(const sample *s) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < s->count; i++) sum += s->x[i];
  return sum / (tl_real)s->count;
}

/* Variance, and correlation of neighbours in *r (0 where all are equal). */
static tl_real variance_of(const sample *s, tl_real mean, tl_real *r) {
  tl_real own = TL_C(0.0), next = TL_C(0.0);
  for (int i = 0; i < s->count; i++) {
    const tl_real d = s->x[i] - mean;
    own += d * d;
    if (i + 1 < s->count) next += d * (s->x[i + 1] - mean);
  }
  *r = own > TL_C(0.0) ? next / own : TL_C(0.0);
  return own / (tl_real)(s->count - 1);
}

/* Merges neighbours; of an odd number the first block, where directions are still turning into place, is left out. */
static void merge(sample *s) {
  const int odd = s->count % 2;
  s->count /= 2;
  for (int i = 0; i < s->count; i++) s->x[i] = (s->x[odd + 2 * i] + s->x[odd + 2 * i + 1]) / TL_C(2.0);
}

int eom_lyapunov_interval(const eom_lyapunov *ly, int i, tl_real *mean, tl_real *half_width) {
  assert(i >= 0 && i < ly->k);
  sample s = {.count = ly->nblock};
  const tl_real time = (tl_real)ly->block_marks * ly->options.interval;
  for (int b = 0; b < s.count; b++) s.x[b] = ly->block[b * ly->k + i] / time;
  *half_width = TL_MAX;
  *mean = ly->t == ly->t0 ? TL_C(0.0) : ly->rho[i] / (ly->t - ly->t0);
  if (s.count < EOM_FEWEST_BLOCKS) return 0;

  tl_real r = TL_C(0.0), m = mean_of(&s), variance = variance_of(&s, m, &r);
  while (r > TL_C(2.0) / TL_LIBM(sqrt)((tl_real)s.count) && s.count >= 2 * EOM_FEWEST_BLOCKS) {
    merge(&s);
    m = mean_of(&s);
    variance = variance_of(&s, m, &r);
  }
  const tl_real widen = r > TL_C(0.0) ? (TL_C(1.0) + r) / (TL_C(1.0) - r) : TL_C(1.0);
  *mean = m;
  *half_width = student(s.count - 1) * TL_LIBM(sqrt)(variance * widen / (tl_real)s.count);
  return s.count;
}
