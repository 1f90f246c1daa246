/* The motion alone, without tangents, in fixed steps: for the fate of a trajectory. */
#include "motion.h"

#include "host/interrupt.h"

#include <math.h>
#include <stdlib.h>

typedef struct watch {
  eom_system *sys;
  double energy0, bound, worst;
  eom_status status;
} watch;

static double energy_of(watch *w, const eom_integrator *it) {
  w->status = eom_energy(w->sys, it->y, it->y + w->sys->n, it->t);
  return w->sys->energy;
}

static int observe(void *user, const eom_integrator *it) {
  watch *w = user;
  double error = fabs(energy_of(w, it) - w->energy0);
  if (w->status != EOM_OK) return 1;
  w->worst = fmax(w->worst, error);
  return w->worst > w->bound || interrupted();
}

motion motion_do(const run_request *ask, double step, double t_end, double bound) {
  struct pendulum p = run_pendulum(ask->links);
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  motion m = {.status = EOM_NO_MEMORY};
  watch w = {.bound = bound};
  eom_integrator it;
  int dim = 2 * ask->links;
  double y[2 * PENDULUM_MAX_LINKS] = {ask->theta0};
  double *work = malloc(eom_integrator_size(&eom_dp5, dim) * sizeof *work);

  if (work != NULL) m.status = eom_system_create(&w.sys, run_model(ask->links), &p, &options);
  if (work != NULL && m.status == EOM_OK) {
    eom_integrator_init(&it, &eom_dp5, eom_rhs, w.sys, dim, 0.0, y, step, work);
    w.energy0 = energy_of(&w, &it);
    m.status = eom_integrate(&it, t_end, observe, &w);
    if (w.status != EOM_OK) m.status = w.status;
    m.t = it.t;
    m.worst_energy_error = w.worst;
  }
  eom_system_destroy(w.sys);
  free(work);
  return m;
}
