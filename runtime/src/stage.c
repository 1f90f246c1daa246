/* Seeding of the motion curve and running of model functions. */
#include "stage.h"

#include "step.h"

#include "taylor/series.h"

static void seed_coordinate(tl_ctx *cx, tl_real *jet, tl_real x0, tl_real x1, tl_real x2, int tangent) {
  if (tangent >= 0)
    tl_seed(cx, jet, x0, tangent);
  else
    tl_const(cx, jet, x0);
  const tl_shape *s = cx->shape;
  if (s->curve >= 1) jet[s->start[0] + 1] = x1;
  if (s->curve >= 2) jet[s->start[0] + 2] = x2;
}

void eom_stage_seed(eom_system *sys, eom_stage_id id, const tl_real *q, const tl_real *qd, const tl_real *qdd, tl_real t) {
  eom_workspace *ws = sys->workspace;
  const eom_stage *stage = &ws->stage[id];
  const size_t n = (size_t)sys->n, ncoef = (size_t)stage->shape->ncoef;
  tl_ctx *cx = &ws->cx;
  tl_ctx_init(cx, stage->shape, ws->context, stage->context);
  ws->jet_q = ws->jets;
  ws->jet_qd = ws->jet_q + n * ncoef;
  ws->jet_t = ws->jet_qd + n * ncoef;
  ws->jet_out = ws->jet_t + ncoef;
  for (int i = 0; i < sys->n; i++) {
    const tl_real a = qdd ? qdd[i] : TL_C(0.0);
    const size_t at = (size_t)i * ncoef;
    seed_coordinate(cx, ws->jet_q + at, q[i], qd[i], a / TL_C(2.0), stage->first_q < 0 ? -1 : stage->first_q + i);
    seed_coordinate(cx, ws->jet_qd + at, qd[i], a, TL_C(0.0), stage->first_qd < 0 ? -1 : stage->first_qd + i);
  }
  seed_coordinate(cx, ws->jet_t, t, TL_C(1.0), TL_C(0.0), -1);
}

/* A function that leaves a row unwritten must not find an earlier result there: such a row is no force, and any other function's fault.
 */
eom_status eom_stage_run(eom_system *sys, const eom_function *function) {
  eom_workspace *ws = sys->workspace;
  const int rows = function->rows(sys->params), ncoef = ws->cx.shape->ncoef;
  const tl_real unwritten = function == &sys->model->force ? TL_C(0.0) : (tl_real)NAN;
  for (int i = 0; i < rows * ncoef; i++) ws->jet_out[i] = unwritten;
  function->jet(&ws->cx, ws->jet_out, ws->jet_q, ws->jet_qd, ws->jet_t, sys->params);
  if (eom_jet_verdict(sys, function, ws->cx.status) != EOM_OK) return sys->report.status;
  for (int row = 0; row < rows; row++)
    if (eom_check_finite(sys, function->name, ws->jet_out + row * ncoef, ncoef) != EOM_OK) {
      sys->report.source = function->source;
      sys->report.index = row;
      return EOM_NOT_FINITE;
    }
  return EOM_OK;
}

eom_status eom_jet_verdict(eom_system *sys, const eom_function *function, tl_status jet) {
  if (jet.bits == TL_OK) return EOM_OK;
  eom_report *r = &sys->report;
  r->status = (jet.bits & TL_NO_SPACE) ? EOM_NO_MEMORY : (jet.bits & (TL_DOMAIN | TL_SINGULAR)) ? EOM_DOMAIN : EOM_NOT_FINITE;
  r->function = function->name;
  r->source = function->source;
  r->jet = jet;
  return r->status;
}

eom_status eom_check_finite(eom_system *sys, const char *name, const tl_real *a, int count) {
  if (eom_all_finite(a, count)) return EOM_OK;
  int i = 0;
  while (TL_ISFINITE(a[i])) i++;
  sys->report.status = EOM_NOT_FINITE;
  sys->report.function = name;
  sys->report.source = NULL;
  sys->report.index = i;
  return EOM_NOT_FINITE;
}
