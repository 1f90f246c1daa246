/* Motion functions on a system that calls jets: r_y and g_y come from the solved derivatives,
 *   r_y = A' lambda_y - M qdd_y,  g_y = -A qdd_y. */
#include "echo_motion.h"

#include "close.h"

#include "eom/assemble.h"
#include "eom/linearise.h"

#include <stdlib.h>
#include <string.h>

static echo *current;

static void copy(tl_real *to, const tl_real *from, int count) {
  if (count > 0) memcpy(to, from, (size_t)count * sizeof(tl_real));
}

/* The answer for a status of the inner system. */
static int code_of(eom_status status) {
  if (current->refusal != 0) return current->refusal;
  return status == EOM_OK ? 0 : status == EOM_DOMAIN ? 1 : EOM_MOTION_NOT_FINITE;
}

static int fits(const void *params) {
  const eom_model *model = &current->model;
  int rows = 0;
  for (int i = 0; i < model->nholonomic; i++) rows += model->holonomic[i].rows(params);
  return model->dof(params) == current->inner->n && rows == current->inner->m1;
}

static int energy(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *momentum, tl_real *rate,
                  tl_real *lagrangian, tl_real *total, tl_real *work) {
  (void)params, (void)work;
  eom_system *inner = current->inner;
  const eom_status status = eom_energy(inner, q, qd, t);
  copy(momentum, inner->momentum, inner->n);
  copy(rate, inner->momentum_rate, inner->n);
  *lagrangian = inner->lagrangian;
  *total = inner->energy;
  return code_of(status);
}

static int simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work) {
  (void)params, (void)work;
  eom_system *inner = current->inner;
  const int n = inner->n, m = inner->m;
  const eom_status status = eom_assemble(inner, q, qd, t);
  copy(out->M, inner->M, n * n);
  copy(out->Q, inner->Q, n);
  copy(out->phi, inner->phi, inner->m1);
  copy(out->phi_dot, inner->phi_dot, inner->m1);
  copy(out->psi, inner->psi, inner->m2);
  copy(out->A, inner->A, m * n);
  copy(out->b, inner->b, m);
  return code_of(status);
}

static int residual(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, tl_real *r, tl_real *work) {
  (void)params, (void)work;
  return code_of(eom_residual(current->inner, r, qdd, q, qd, t));
}

static int linearise(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda,
                     tl_real *r_y, tl_real *g_y, tl_real *work) {
  (void)params, (void)qdd, (void)lambda, (void)work;
  eom_system *inner = current->inner;
  const int n = inner->n, m = inner->m, d = 2 * n;
  const eom_status status = eom_linearise(inner, q, qd, t);
  if (status != EOM_OK || eom_assemble(inner, q, qd, t) != EOM_OK) return code_of(inner->report.status);
  for (int j = 0; j < d; j++) {
    for (int i = 0; i < n; i++) {
      r_y[i * d + j] = 0;
      for (int r = 0; r < m; r++) r_y[i * d + j] += inner->A[r * n + i] * inner->lambda_y[r * d + j];
      for (int k = 0; k < n; k++) r_y[i * d + j] -= inner->M[i * n + k] * inner->qdd_y[k * d + j];
    }
    for (int r = 0; r < m; r++) {
      g_y[r * d + j] = 0;
      for (int k = 0; k < n; k++) g_y[r * d + j] -= inner->A[r * n + k] * inner->qdd_y[k * d + j];
    }
  }
  return code_of(EOM_OK);
}

/* c = a w for a (rows x d), w (d x k). */
static void multiply(int rows, int d, int k, tl_real *c, const tl_real *a, const tl_real *w) {
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < k; j++) {
      c[i * k + j] = 0;
      for (int l = 0; l < d; l++) c[i * k + j] += a[i * d + l] * w[l * k + j];
    }
}

static int tangent(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, int k,
                   const tl_real *w, tl_real *r_w, tl_real *g_w, tl_real *work) {
  const int n = current->inner->n, m = current->inner->m;
  tl_real *r_y = work, *g_y = work + 2 * n * n;
  const int code = linearise(params, q, qd, t, qdd, lambda, r_y, g_y, NULL);
  if (code != 0) return code;
  multiply(n, 2 * n, k, r_w, r_y, w);
  multiply(m, 2 * n, k, g_w, g_y, w);
  return 0;
}

void echo_start(echo *e, const eom_model *model, const void *params) {
  static const eom_site site = {TL_FN_fabs, "model.c", 7};
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL;
  options.emitter = EOM_EMITTER_CALLS;
  *e = (echo){.model = *model};
  assert_int_equal(eom_system_create(&e->inner, model, params, &options), EOM_OK);
  const eom_system *s = e->inner;
  e->motion = (eom_motion){.n = s->n,
                           .m1 = s->m1,
                           .m2 = s->m2,
                           .fits = fits,
                           .work = 2 * (size_t)(s->n * (s->n + s->m)),
                           .sites = &site,
                           .nsite = 1,
                           .energy = energy,
                           .simulate = simulate,
                           .residual = residual,
                           .linearise = linearise,
                           .tangent = tangent};
  e->list[0] = &e->motion;
  e->model.motion = e->list;
  e->model.nmotion = 1;
  current = e;
}

void echo_end(echo *e) {
  eom_system_destroy(e->inner);
  current = NULL;
}
