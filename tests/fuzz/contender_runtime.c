/* The runtime, on jet functions or on motion functions: assembled, solved, linearised. */
#include "contender.h"

#include "eom/eom.h"
#include "eom/tangent.h"

#include <stdio.h>
#include <string.h>

/* Copies a group; one that the reference lacks stays absent. */
static void take(fuzz_numbers *v, int group, const double *from) {
  const int count = fuzz_group_size(&v->sizes, group);
  if (count && v->group[group]) memcpy(v->group[group], from, (size_t)count * sizeof *from);
}

static eom_status assembled(eom_system *sys, const fuzz_point *p, fuzz_numbers *v) {
  const eom_status status = eom_assemble(sys, p->x, p->x + sys->n, p->x[2 * sys->n]);
  if (status) return status;
  take(v, FUZZ_LAGRANGIAN, &sys->lagrangian);
  take(v, FUZZ_MOMENTUM, sys->momentum);
  take(v, FUZZ_RATE, sys->momentum_rate);
  take(v, FUZZ_ENERGY, &sys->energy);
  take(v, FUZZ_MASS, sys->M);
  take(v, FUZZ_FORCE, sys->Q);
  take(v, FUZZ_PHI, sys->phi);
  take(v, FUZZ_PHI_DOT, sys->phi_dot);
  take(v, FUZZ_PSI, sys->psi);
  take(v, FUZZ_CONSTRAINT, sys->A);
  take(v, FUZZ_B, sys->b);
  return eom_residual(sys, v->group[FUZZ_RESIDUAL], p->trial, p->x, p->x + sys->n, p->x[2 * sys->n]);
}

/* Each of the three in its own way, so that every function of the motion is used. */
static eom_status solved(eom_system *sys, const fuzz_point *p, fuzz_numbers *v) {
  const double *const q = p->x, *const qd = q + sys->n, t = p->x[2 * sys->n];
  double **g = v->group;
  eom_status status = eom_acceleration(sys, q, qd, t);
  if (status) return status;
  take(v, FUZZ_QDD, sys->qdd);
  take(v, FUZZ_LAMBDA, sys->lambda);
  status = eom_linearise(sys, q, qd, t);
  if (status) return status;
  take(v, FUZZ_QDD_J, sys->qdd);
  take(v, FUZZ_QDD_Y, sys->qdd_y);
  take(v, FUZZ_LAMBDA_Y, sys->lambda_y);
  status = eom_tangent(sys, g[FUZZ_QDD_W], sys->m ? g[FUZZ_LAMBDA_W] : NULL, v->sizes.k, p->w, q, qd, t);
  if (status) return status;
  take(v, FUZZ_QDD_V, sys->qdd);
  if (!(sys->options.needs & EOM_NEED_PARAMETERS)) return EOM_OK;
  return eom_parameter_derivatives(sys, g[FUZZ_QDD_P], sys->m ? g[FUZZ_LAMBDA_P] : NULL, q, qd, t);
}

static void compute(eom_emitter emitter, int parameters, const eom_model *model, const void *params, const fuzz_point *p,
                    fuzz_numbers *v, char *text, size_t size) {
  eom_system *sys;
  eom_options options = eom_options_default();
  options.emitter = emitter;
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT | (parameters ? EOM_NEED_PARAMETERS : 0);
  eom_status status = eom_system_create(&sys, model, params, &options);
  if (status) {
    snprintf(text, size, "%s", eom_status_text(status));
    return;
  }
  fuzz_make_absent(v, FUZZ_R_Y, FUZZ_QDD);
  if (!parameters) fuzz_make_absent(v, FUZZ_QDD_P, FUZZ_GROUP_COUNT);
  status = assembled(sys, p, v);
  if (status == EOM_OK && v->group[FUZZ_QDD]) status = solved(sys, p, v);
  if (status) {
    eom_report_text(&sys->report, text, size);
    text[strcspn(text, "\n")] = '\0';
  }
  eom_system_destroy(sys);
}

void contender_calls(const eom_model *model, const void *params, const fuzz_point *p, fuzz_numbers *v, char *text, size_t size) {
  compute(EOM_EMITTER_CALLS, 0, model, params, p, v, text, size);
}

void contender_runtime(const eom_model *model, const void *params, const fuzz_point *p, fuzz_numbers *v, char *text, size_t size) {
  if (contender_find_motion(model, params))
    compute(EOM_EMITTER_AUTO, v->sizes.np > 0, model, params, p, v, text, size);
  else
    fuzz_make_absent(v, 0, FUZZ_GROUP_COUNT);
}
