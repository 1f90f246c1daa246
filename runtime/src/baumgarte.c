/* Baumgarte's stabilisation (J. Baumgarte, Comput. Methods Appl. Mech. Eng. 1, 1972): with s = 2 alpha phi' + beta^2 phi for holonomic
 * rows and s = alpha psi for nonholonomic ones, A qdd = b - s. Its derivatives, with brackets as in linearise.c:
 *   ds_r/dx_j = 2 alpha [s x_j] phi + beta^2 A_rj,  ds_r/du_j = 2 alpha A_rj         (holonomic: [x_j] phi = [u_j] phi' = A_rj)
 *   ds_r/dx_j = alpha [x_j] psi,                    ds_r/du_j = alpha A_rj           (nonholonomic) */
#include "baumgarte.h"

#include "stage.h"

bool eom_is_stabilised(const eom_system *sys) {
  const eom_baumgarte *gain = &sys->options.baumgarte;
  return sys->m > 0 && (gain->alpha != TL_C(0.0) || gain->beta != TL_C(0.0));
}

/* The terms count among those that cancel in b. */
static void pull_back(eom_system *sys, int row, tl_real rate, tl_real place) {
  sys->b[row] -= rate + place;
  sys->workspace->b_size[row] += TL_LIBM(fabs)(rate) + TL_LIBM(fabs)(place);
}

void eom_stabilise_holonomic(eom_system *sys) {
  const eom_baumgarte gain = sys->options.baumgarte;
  if (!eom_is_stabilised(sys)) return;
  for (int r = 0; r < sys->m1; r++) pull_back(sys, r, TL_C(2.0) * gain.alpha * sys->phi_dot[r], gain.beta * gain.beta * sys->phi[r]);
}

void eom_stabilise_nonholonomic(eom_system *sys) {
  if (!eom_is_stabilised(sys)) return;
  for (int r = 0; r < sys->m2; r++) pull_back(sys, sys->m1 + r, sys->options.baumgarte.alpha * sys->psi[r], TL_C(0.0));
}

/* g_row += (ds_row/dy) w. */
static void add_row(eom_system *sys, tl_real *g, int k, const tl_real *w, int row) {
  const tl_real *pull = sys->workspace->pull;
  for (int j = 0; j < 2 * sys->n; j++)
    if (!w)
      g[row * k + j] += pull[j];
    else
      for (int c = 0; c < k; c++) g[row * k + c] += pull[j] * w[j * k + c];
}

/* ws->pull = ds_row/dy from the row's derivatives in x: by_x = d(phi' or psi)/dx. */
static void pull_of_row(eom_system *sys, int row, const tl_real *by_x) {
  const eom_baumgarte gain = sys->options.baumgarte;
  const bool holonomic = row < sys->m1;
  const tl_real rate = holonomic ? TL_C(2.0) * gain.alpha : gain.alpha, place = holonomic ? gain.beta * gain.beta : TL_C(0.0);
  const int n = sys->n;
  for (int j = 0; j < n; j++) {
    const tl_real a = sys->A[row * n + j];
    sys->workspace->pull[j] = rate * by_x[j] + place * a;
    sys->workspace->pull[n + j] = rate * a;
  }
}

/* Functions of one kind, from constraint row on; their derivatives d(phi' or psi)/dx stand at that offset of the jets. */
static eom_status add_functions(eom_system *sys, const eom_function *list, int count, int row, int offset, tl_real *g, int k,
                                const tl_real *w) {
  const eom_workspace *ws = sys->workspace;
  for (int f = 0; f < count; f++) {
    if (eom_stage_run(sys, &list[f]) != EOM_OK) return sys->report.status;
    const size_t ncoef = (size_t)ws->cx.shape->ncoef;
    const int rows = list[f].rows(sys->params);
    for (int i = 0; i < rows; i++, row++) {
      pull_of_row(sys, row, ws->jet_out + (size_t)i * ncoef + offset);
      add_row(sys, g, k, w, row);
    }
  }
  return EOM_OK;
}

eom_status eom_stabilise_derivatives(eom_system *sys, tl_real *g, int k, const tl_real *w, const tl_real *q, const tl_real *qd,
                                     tl_real t) {
  if (!eom_is_stabilised(sys)) return EOM_OK;
  const eom_workspace *ws = sys->workspace;
  const eom_model *model = sys->model;
  if (sys->m1 > 0) {
    eom_stage_seed(sys, STAGE_HOLONOMIC, q, qd, NULL, t);
    const int by_s = ws->stage[STAGE_HOLONOMIC].shape->start[1] + sys->n;
    if (add_functions(sys, model->holonomic, model->nholonomic, 0, by_s, g, k, w) != EOM_OK) return sys->report.status;
  }
  if (sys->m2 == 0) return EOM_OK;
  eom_stage_seed(sys, STAGE_NONHOLONOMIC_Q, q, qd, NULL, t);
  return add_functions(sys, model->nonholonomic, model->nnonholonomic, sys->m1, ws->stage[STAGE_NONHOLONOMIC_Q].shape->start[1], g, k,
                       w);
}
