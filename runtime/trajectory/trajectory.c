/* Trajectories: the table of methods, and those of the library itself. */
#include "stepper.h"

#include "eom/project.h"
#include "eom/solve.h"
#include "eom/taylor.h"
#include "eom/variational.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

/* Ours first, then SUNDIALS'. */
static const eom_trajectory_method methods[] = {
    {"dop853", "Dormand and Prince 8(5,3), for smooth motion at any tolerance", 8, 0, 1, 1, 1, 1},
    {"taylor", "Taylor series of order up to 26, for models with motion functions of the need taylor", 0, 0, 1, 1, 1, 0},
    {"dp5", "Dormand and Prince 5(4), for moderate tolerances", 5, 0, 1, 1, 1, 1},
    {"rk4", "the classical method of Runge and Kutta", 4, 0, 1, 1, 1, 1},
    {"variational2", "variational, Stoermer and Verlet's or RATTLE: symplectic, holds holonomic constraints", 2, 0, 1, 0, 1, 0},
    {"variational4", "variational on three nodes of Lobatto, likewise, for long motion", 4, 0, 1, 0, 1, 0},
    {"variational6", "variational on four nodes of Lobatto, likewise, for long motion and small errors", 6, 0, 1, 0, 1, 0},
#ifdef EOM_HAVE_SUNDIALS
    {"cvode_adams", "CVODE: Adams methods of order 1 to 12, for motion whose accelerations cost much", 0, 0, 0, 1, 0, 1},
    {"cvode_bdf", "CVODE: backward differences of order 1 to 5 with the exact Jacobian, for stiff motion", 0, 1, 0, 1, 1, 1},
    {"arkode_dp5", "ARKODE: Dormand and Prince 5(4)", 5, 0, 0, 1, 1, 1},
    {"arkode_fehlberg8", "ARKODE: Fehlberg 8(7)", 8, 0, 0, 1, 1, 1},
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

eom_rhs_fn *eom_trajectory_rhs(const eom_trajectory *r) { return r->options.sensitivity ? eom_sensitivity_rhs : eom_rhs; }

eom_correct_fn *eom_trajectory_correct(const eom_trajectory *r) {
  return r->options.sensitivity ? eom_sensitivity_correct : eom_project_state;
}

void *eom_trajectory_user(const eom_trajectory *r) { return r->options.sensitivity ? (void *)r->options.sensitivity : (void *)r->sys; }

/* ---- the library's own methods ---- */

typedef struct own {
  eom_integrator it;
  eom_taylor series;           /* of the method taylor */
  eom_variational variational; /* of such a method */
  tl_real work[];
} own;

/* The table of an explicit Runge-Kutta method; null: another one of the library. */
static const eom_method *table_of(const eom_trajectory_method *method) { return eom_method_find(method->name); }

static eom_status own_start(eom_trajectory *r, own *o, const eom_trajectory_method *method) {
  const eom_trajectory_options *options = &r->options;
  if (table_of(method)) {
    eom_integrator_init(&o->it, table_of(method), eom_trajectory_rhs(r), eom_trajectory_user(r), r->dim, r->t, r->y, options->h,
                        o->work);
  } else {
    const eom_status status =
        method->chosen ? eom_taylor_init(&o->series, &o->it, r->sys, r->t, r->y, options->h, o->work)
                       : eom_variational_init(&o->variational, &o->it, r->sys, method->order, r->t, r->y, options->h, o->work);
    if (status != EOM_OK) return status;
  }
  if (method->chosen) o->it.correct = options->project ? eom_trajectory_correct(r) : NULL;
  return eom_trajectory_is_controlled(options) ? eom_integrator_control(&o->it, &options->control) : EOM_OK;
}

static size_t own_work(const eom_trajectory *r, const eom_trajectory_method *method) {
  if (table_of(method)) return eom_integrator_size(table_of(method), r->dim);
  return method->chosen ? eom_taylor_size(r->sys) : eom_variational_size(r->sys, method->order);
}

static eom_status own_create(eom_trajectory *r, const eom_trajectory_method *method) {
  own *o = malloc(sizeof *o + own_work(r, method) * sizeof(tl_real));
  r->data = o;
  if (!o) return EOM_NO_MEMORY;
  const eom_status status = own_start(r, o, method);
  o->it.control.most_steps = r->options.control.most_steps; /* of fixed steps too */
  o->it.events = r->options.events;
  o->it.outputs = r->options.outputs;
  if (status == EOM_OK) memcpy(r->y, o->it.y, (size_t)r->dim * sizeof(tl_real));
  return status;
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

/* The library's own are those that can take fixed steps. */
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
  if (options->sensitivity && (options->sensitivity->sys != sys || !method->columns)) return 0;
  return eom_trajectory_is_controlled(options) ? method->chosen : method->fixed;
}

static eom_status start(eom_trajectory *r, const eom_trajectory_method *method) {
  eom_status status = EOM_OK;
  if (r->options.project && r->sys->m > 0) {
    status = eom_project(r->sys, r->y, r->y + r->sys->n, r->t, NULL);
    if (status == EOM_OK && r->options.sensitivity) status = eom_sensitivity_project(r->options.sensitivity, r->t, r->y);
  }
  return status == EOM_OK ? r->stepper->create(r, method) : status;
}

eom_status eom_trajectory_create(eom_trajectory **trajectory, eom_system *sys, const eom_trajectory_options *options, tl_real t,
                                 const tl_real *y) {
  assert(trajectory && sys && options && y);
  const eom_trajectory_method *method = find(options->method);
  const int dim = options->sensitivity ? options->sensitivity->dim : 2 * sys->n;
  const size_t bytes = (size_t)dim * sizeof(tl_real);
  *trajectory = NULL;
  if (!can_do(method, sys, options)) return EOM_BAD_OPTION;
  eom_trajectory *r = malloc(sizeof *r + bytes);
  if (!r) return EOM_NO_MEMORY;
  *r = (eom_trajectory){.sys = sys, .options = *options, .stepper = stepper_of(method), .dim = dim, .t = t};
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
