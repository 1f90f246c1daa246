/* What is read from a run of Lyapunov exponents, and what tells whether it can be trusted. */
#include "lyapunov.h"

void eom_lyapunov_exponents(const eom_lyapunov *ly, tl_real *lambda) {
  const tl_real time = ly->t - ly->t0;
  for (int i = 0; i < ly->k; i++) lambda[i] = time == TL_C(0.0) ? TL_C(0.0) : ly->rho[i] / time;
}

int eom_lyapunov_settled(const eom_lyapunov *ly) {
  const eom_lyapunov_options *o = &ly->options;
  tl_real mean, half_width;
  if (o->stop_half_width == TL_C(0.0) || TL_LIBM(fabs)(ly->t - ly->t0) < o->stop_after) return 0;
  return eom_lyapunov_interval(ly, o->stop_exponent, &mean, &half_width) > 0 && half_width <= o->stop_half_width;
}

/* ---- checks ---- */

static tl_real finite_or_max(tl_real x) { return TL_ISFINITE(x) ? x : TL_MAX; }

static tl_real size(tl_real x) { return TL_LIBM(fabs)(finite_or_max(x)); }

static tl_real orthogonality(const eom_lyapunov *ly) {
  const int k = ly->k;
  tl_real worst = TL_C(0.0);
  for (int i = 0; i < k; i++)
    for (int j = 0; j <= i; j++) {
      tl_real sum = i == j ? TL_C(-1.0) : TL_C(0.0);
      for (int l = 0; l < 2 * ly->sys->n; l++) sum += ly->Q[l * k + i] * ly->Q[l * k + j];
      worst = TL_LIBM(fmax)(worst, size(sum));
    }
  return worst;
}

/* Sorts falling, by insertion: the spectrum is short and nearly sorted. */
static void sort_falling(int count, tl_real *x) {
  for (int i = 1; i < count; i++) {
    const tl_real value = x[i];
    int j = i;
    for (; j > 0 && x[j - 1] < value; j--) x[j] = x[j - 1];
    x[j] = value;
  }
}

/* The checks of a whole spectrum. */
static void check_spectrum(const eom_lyapunov *ly, eom_lyapunov_checks *c) {
  tl_real *lambda = ly->work->column;
  eom_lyapunov_exponents(ly, lambda);
  sort_falling(ly->k, lambda);
  c->pairing_error = TL_C(0.0);
  c->zero[0] = c->zero[1] = TL_MAX;
  for (int i = 0; i < ly->k; i++) {
    c->pairing_error = TL_LIBM(fmax)(c->pairing_error, size(lambda[i] + lambda[ly->k - 1 - i]));
    const tl_real a = size(lambda[i]);
    if (a < c->zero[0]) {
      c->zero[1] = c->zero[0];
      c->zero[0] = a;
    } else if (a < c->zero[1])
      c->zero[1] = a;
  }
}

/* The volume of C is that of all its rows. */
static bool divergence_is_known(const eom_lyapunov *ly) {
  return ly->options.product == EOM_LYAPUNOV_BY_JACOBIAN && ly->work->rank == ly->work->rows;
}

void eom_lyapunov_check(const eom_lyapunov *ly, eom_lyapunov_checks *checks) {
  const tl_real time = ly->t - ly->t0, unknown = TL_C(-1.0);
  eom_lyapunov_checks c = {.orthogonality = orthogonality(ly), .energy_error = ly->energy_error};
  c.sum_error = c.pairing_error = c.zero[0] = c.zero[1] = unknown;
  for (int i = 0; i < ly->k; i++) c.sum += time == TL_C(0.0) ? TL_C(0.0) : ly->rho[i] / time;
  if (divergence_is_known(ly)) {
    c.divergence = time == TL_C(0.0) ? TL_C(0.0) : ly->divergence / time;
    if (ly->k == ly->d) c.sum_error = size(c.sum - c.divergence);
  }
  c.sum = finite_or_max(c.sum);
  if (ly->k == ly->d) check_spectrum(ly, &c);
  *checks = c;
}
