/* The start of an evaluation, and the choice between motion functions and calls. */
#include "evaluate.h"

#include "stage.h"
#include "step.h"

#include <assert.h>

/* ---- the choice ---- */

/* The model's motion functions at the sizes of the system, or null. */
static const eom_motion *fitting_motion(const eom_system *sys) {
  for (int i = 0; i < sys->model->nmotion; i++) {
    const eom_motion *f = sys->model->motion[i];
    if (f->n == sys->n && f->m1 == sys->m1 && f->m2 == sys->m2 && f->fits(sys->params)) return f;
  }
  return NULL;
}

/* Solved forms need the others beside them, for a mass matrix that is not safely positive definite. */
static bool has_function(const eom_motion *f, eom_task task) {
  switch (task) {
  case EOM_TASK_ENERGY:
    return f->energy;
  case EOM_TASK_ASSEMBLE:
    return f->simulate;
  case EOM_TASK_LINEARISE:
    return f->linearise;
  case EOM_TASK_RESIDUAL:
    return f->residual;
  case EOM_TASK_TANGENT:
    return f->tangent;
  case EOM_TASK_PARAMETERS:
    return f->parameters;
  case EOM_TASK_COUNT:
    break;
  }
  return false;
}

static bool is_needed(unsigned needs, eom_task task) {
  static const unsigned bit[EOM_TASK_COUNT] = {[EOM_TASK_LINEARISE] = EOM_NEED_LINEARISE,
                                               [EOM_TASK_RESIDUAL] = EOM_NEED_RESIDUAL,
                                               [EOM_TASK_TANGENT] = EOM_NEED_TANGENT,
                                               [EOM_TASK_PARAMETERS] = EOM_NEED_PARAMETERS};
  return bit[task] == EOM_NEED_SIMULATE || (needs & bit[task]);
}

bool eom_choose_emitters(eom_system *sys, eom_workspace *ws) {
  const eom_emitter choice = sys->options.emitter;
  if (choice != EOM_EMITTER_AUTO && choice != EOM_EMITTER_CALLS && choice != EOM_EMITTER_MOTION) return false;
  const eom_motion *motion = choice == EOM_EMITTER_CALLS ? NULL : fitting_motion(sys);
  const bool tangents = motion && motion->tangent;
  if (sys->options.needs & EOM_NEED_TANGENT && !tangents) sys->options.needs |= EOM_NEED_LINEARISE; /* dqdd = qdd_y w */
  for (int task = 0; task < EOM_TASK_COUNT; task++) {
    if (!is_needed(sys->options.needs, (eom_task)task)) continue;
    if (motion && has_function(motion, (eom_task)task)) {
      ws->emitter[task] = EOM_EMITTER_MOTION;
      sys->motion = motion;
    } else if (choice != EOM_EMITTER_MOTION && task != EOM_TASK_PARAMETERS) {
      ws->emitter[task] = EOM_EMITTER_CALLS;
    } else {
      return false;
    }
  }
  return true;
}

bool eom_by_motion(const eom_system *sys, eom_task task) { return sys->workspace->emitter[task] == EOM_EMITTER_MOTION; }

eom_emitter eom_system_emitter(const eom_system *sys, eom_task task) {
  assert(task < EOM_TASK_COUNT);
  return sys->workspace->emitter[task];
}

/* ---- the start ---- */

/* As an empty report, but what nrow leaves out is not written: that would cost more than a small evaluation. */
static void clear(eom_report *r) {
  r->status = EOM_OK;
  r->function = r->source = NULL;
  r->jet = (tl_status){.bits = TL_OK};
  r->index = -1;
  r->rank = -1;
  r->weighted = 0;
  r->pivot = r->condition = r->residual = TL_C(0.0);
  r->nrow = 0;
}

eom_status eom_start_sized(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  assert(sys && sys->workspace && q && qd);
  clear(&sys->report);
  if (qd == q + sys->n && t - t == TL_C(0.0) && eom_all_finite(q, 2 * sys->n)) return EOM_OK; /* as integrators have them: one look */
  if (eom_check_finite(sys, "argument q", q, sys->n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "argument qd", qd, sys->n) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "argument t", &t, 1);
}

eom_status eom_start(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  assert(sys && sys->workspace);
  if (eom_sizes_hold(sys)) return eom_start_sized(sys, q, qd, t);
  clear(&sys->report);
  sys->report.function = sys->model->name;
  return sys->report.status = EOM_SIZES_CHANGED;
}

eom_status eom_start_needing(eom_system *sys, unsigned need, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_start(sys, q, qd, t) != EOM_OK || sys->options.needs & need) return sys->report.status;
  sys->report.function = "options.needs";
  return sys->report.status = EOM_BAD_OPTION;
}

tl_real eom_largest_change(int n, const tl_real *x, const tl_real *was, int *most) {
  tl_real change = TL_C(0.0);
  *most = -1;
  for (int i = 0; i < n; i++) {
    const tl_real d = TL_LIBM(fabs)(x[i] - was[i]);
    if (d > change) change = d, *most = i;
  }
  return change;
}

/* ---- failures ---- */

static eom_status run_all(eom_system *sys, const eom_function *list, int count) {
  for (int i = 0; i < count; i++)
    if (eom_stage_run(sys, &list[i]) != EOM_OK) break;
  return sys->report.status;
}

/* The failure as calls see it, by jets along a direction that changes every argument: names the model's function. EOM_OK where they see
 * none. */
static eom_status locate(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_model *model = sys->model;
  const eom_workspace *ws = sys->workspace;
  const int ncoef = ws->stage[STAGE_LOCATE].shape->ncoef;
  eom_stage_seed(sys, STAGE_LOCATE, q, qd, NULL, t);
  for (int i = 0; i < sys->n; i++) ws->jet_q[i * ncoef + 1] = ws->jet_qd[i * ncoef + 1] = TL_C(1.0);
  if (run_all(sys, &model->lagrangian, 1) != EOM_OK) return sys->report.status;
  if (model->force.jet && run_all(sys, &model->force, 1) != EOM_OK) return sys->report.status;
  if (model->dissipation.jet && run_all(sys, &model->dissipation, 1) != EOM_OK) return sys->report.status;
  if (run_all(sys, model->holonomic, model->nholonomic) != EOM_OK) return sys->report.status;
  return run_all(sys, model->nonholonomic, model->nnonholonomic);
}

static eom_status failed_at(eom_system *sys, const eom_site *site) {
  sys->report.jet = (tl_status){.bits = TL_DOMAIN | TL_SINGULAR, .function = site->function, .line = site->line, .file = site->file};
  return sys->report.status = EOM_DOMAIN;
}

eom_status eom_motion_verdict(eom_system *sys, int code, const tl_real *q, const tl_real *qd, tl_real t) {
  if (code == 0) return EOM_OK;
  sys->report.function = sys->model->name;
  if (code == EOM_MOTION_SIZE) return sys->report.status = EOM_SIZES_CHANGED;
  if (code == EOM_MOTION_PIVOT) return sys->report.status = EOM_NO_INERTIA;
  if (locate(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (code == EOM_MOTION_NOT_FINITE) return sys->report.status = EOM_NOT_FINITE;
  assert(code > 0 && code <= sys->motion->nsite);
  return failed_at(sys, &sys->motion->sites[code - 1]);
}
