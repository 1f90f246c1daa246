/* Trajectories: the table of methods, and those of the library itself. */
#include "stepper.h"

#include "eom/project.h"
#include "eom/solve.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Ours first, then SUNDIALS'. */
static const eom_trajectory_method methods[] = {
    {"dop853", "Dormand and Prince 8(5,3), for smooth motion at any tolerance", 8, 0, 1, 1},
    {"dp5", "Dormand and Prince 5(4), for moderate tolerances", 5, 0, 1, 1},
    {"rk4", "the classical method of Runge and Kutta", 4, 0, 1, 1},
#ifdef EOM_HAVE_SUNDIALS
    {"cvode_adams", "CVODE: Adams methods of order 1 to 12, for motion whose accelerations cost much", 0, 0, 0, 0},
    {"cvode_bdf", "CVODE: backward differences of order 1 to 5 with the exact Jacobian, for stiff motion", 0, 1, 0, 1},
    {"arkode_dp5", "ARKODE: Dormand and Prince 5(4)", 5, 0, 0, 1},
    {"arkode_verner6", "ARKODE: Verner 6(5)", 6, 0, 0, 1},
    {"arkode_fehlberg8", "ARKODE: Fehlberg 8(7)", 8, 0, 0, 1},
#endif
};

enum { METHODS = sizeof methods / sizeof methods[0] };

const eom_trajectory_method *eom_trajectory_method_at(int i) { return i >= 0 && i < METHODS ? &methods[i] : NULL; }

static const eom_trajectory_method *find(const char *name) {
  if (!name) return &methods[0];
  for (int i = 0; i < METHODS; i++)
    if (strcmp(methods[i].name, name) == 0) return &methods[i];
  return NULL;
}

int eom_trajectory_is_controlled(const eom_trajectory_options *options) {
  const eom_step_control *c = &options->control;
  return c->rtol != TL_C(0.0) || c->atol != TL_C(0.0) || c->rtol_each || c->atol_each;
}

/* ---- the library's own methods ---- */

typedef struct own {
  eom_integrator it;
  tl_real work[];
} own;

static eom_status own_create(eom_trajectory *r, const eom_trajectory_method *method) {
  const eom_trajectory_options *options = &r->options;
  const eom_method *table = eom_method_find(method->name);
  own *o = malloc(sizeof *o + eom_integrator_size(table, r->dim) * sizeof(tl_real));
  r->data = o;
  if (!o) return EOM_NO_MEMORY;
  eom_integrator_init(&o->it, table, eom_rhs, r->sys, r->dim, r->t, r->y, options->h, o->work);
  o->it.correct = options->project ? eom_project_state : NULL;
  o->it.events = options->events;
  o->it.outputs = options->outputs;
  return eom_trajectory_is_controlled(options) ? eom_integrator_control(&o->it, &options->control) : EOM_OK;
}

static void take_state(eom_trajectory *r) {
  const own *o = r->data;
  r->t = o->it.t;
  memcpy(r->y, o->it.y, (size_t)r->dim * sizeof(tl_real));
}

static int own_observe(void *observer, const eom_integrator *it) {
  eom_trajectory *r = observer;
  (void)it;
  if (!r->observe) return 0;
  take_state(r);
  return r->observe(r->observer, r);
}

static eom_status own_to(eom_trajectory *r, tl_real t_end) {
  own *o = r->data;
  const eom_status status = eom_integrate(&o->it, t_end, own_observe, r);
  take_state(r);
  return status;
}

static eom_trajectory_work own_worked(const eom_trajectory *r) {
  const eom_integrator *it = &((const own *)r->data)->it;
  return (eom_trajectory_work){.steps = it->steps, .rejected = it->rejected + it->failed, .evaluations = it->evaluations};
}

static void own_destroy(eom_trajectory *r) { free(r->data); }

const eom_stepper eom_own_stepper = {own_create, own_to, own_worked, own_destroy};

/* ---- any method ---- */

/* The library's own are those that take fixed steps. */
static const eom_stepper *stepper_of(const eom_trajectory_method *method) {
#ifdef EOM_HAVE_SUNDIALS
  return method->fixed ? &eom_own_stepper : &eom_sundials_stepper;
#else
  (void)method;
  return &eom_own_stepper;
#endif
}

static int can_do(const eom_trajectory_method *method, const eom_system *sys, const eom_trajectory_options *options) {
  if (!method || (method->implicit && !(sys->options.needs & EOM_NEED_LINEARISE))) return 0;
  if (options->project && !method->projects) return 0;
  return eom_trajectory_is_controlled(options) || method->fixed;
}

static eom_status start(eom_trajectory *r, const eom_trajectory_method *method) {
  const eom_status status = r->options.project && r->sys->m > 0 ? eom_project(r->sys, r->y, r->y + r->sys->n, r->t, NULL) : EOM_OK;
  return status == EOM_OK ? r->stepper->create(r, method) : status;
}

eom_status eom_trajectory_create(eom_trajectory **trajectory, eom_system *sys, const eom_trajectory_options *options, tl_real t,
                                 const tl_real *y) {
  assert(trajectory && sys && options && y);
  const eom_trajectory_method *method = find(options->method);
  const size_t bytes = 2 * (size_t)sys->n * sizeof(tl_real);
  *trajectory = NULL;
  if (!can_do(method, sys, options)) return EOM_BAD_OPTION;
  eom_trajectory *r = malloc(sizeof *r + bytes);
  if (!r) return EOM_NO_MEMORY;
  *r = (eom_trajectory){.sys = sys, .options = *options, .stepper = stepper_of(method), .dim = 2 * sys->n, .t = t};
  r->y = (tl_real *)(void *)(r + 1);
  memcpy(r->y, y, bytes);
  const eom_status status = start(r, method);
  if (status == EOM_OK)
    *trajectory = r;
  else
    eom_trajectory_destroy(r);
  return status;
}

void eom_trajectory_destroy(eom_trajectory *r) {
  if (!r) return;
  r->stepper->destroy(r);
  free(r);
}

eom_status eom_trajectory_to(eom_trajectory *r, tl_real t_end, eom_trajectory_observe_fn *observe, void *observer) {
  if (!TL_ISFINITE(t_end)) return EOM_BAD_OPTION;
  r->observe = observe;
  r->observer = observer;
  return r->stepper->to(r, t_end);
}

tl_real eom_trajectory_time(const eom_trajectory *r) { return r->t; }
const tl_real *eom_trajectory_state(const eom_trajectory *r) { return r->y; }
eom_trajectory_work eom_trajectory_worked(const eom_trajectory *r) { return r->stepper->worked(r); }
