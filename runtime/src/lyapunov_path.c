/* The motion ahead of its tangents. Where steps are chosen, the motion takes those that its own tolerance asks for, which are many, and
 * tangents, which need fewer digits, take longer ones; at their stages they see the motion by the interpolation of its method. */
#include "lyapunov.h"

#include "step.h"

void eom_lyapunov_path_begin(eom_lyapunov *ly, tl_real t_mark) {
  ly->work->path.count = 0;
  ly->work->path.t_mark = t_mark;
  ly->work->path.status = EOM_OK;
}

static int stop_after_step(void *observer, const eom_integrator *it) {
  (void)observer;
  (void)it;
  return 1;
}

/* One more step of the motion, in the place of the oldest one: not while the tangents need that. Their step is then tried again with a
 * shorter one. */
static eom_status extend(eom_lyapunov *ly) {
  eom_lyapunov_path *path = &ly->work->path;
  eom_integrator *it = &ly->it;
  const long slot = path->count % EOM_PATH_STEPS;
  if (path->count >= EOM_PATH_STEPS && (path->end[slot] - ly->tangents.t) / ly->options.interval > TL_C(0.0)) return EOM_NOT_IN_STEP;
  eom_status status = eom_integrate(it, path->t_mark, stop_after_step, NULL);
  if (status == EOM_OK || status == EOM_STOPPED) status = eom_keep_step(it, path->kept + (size_t)slot * path->size);
  if (status == EOM_RHS_FAILED) status = (eom_status)it->rhs_code;
  path->begin[slot] = it->t_before;
  path->end[slot] = it->t;
  path->count++;
  return path->status = status;
}

eom_status eom_lyapunov_path_at(eom_lyapunov *ly, tl_real t, tl_real *y) {
  eom_lyapunov_path *path = &ly->work->path;
  const tl_real way = ly->options.interval;
  if (!((path->t_mark - t) / way > TL_C(0.0))) t = path->t_mark;
  while ((t - ly->it.t) / way > TL_C(0.0)) {
    const eom_status status = path->status == EOM_OK ? extend(ly) : path->status;
    if (status != EOM_OK) return status;
  }
  if (t == ly->it.t) return eom_integrator_at(&ly->it, t, y);
  const long oldest = path->count > EOM_PATH_STEPS ? path->count - EOM_PATH_STEPS : 0;
  for (long i = path->count; i-- > oldest;) {
    const long slot = i % EOM_PATH_STEPS;
    const tl_real x = (t - path->begin[slot]) / (path->end[slot] - path->begin[slot]);
    if (!(x >= TL_C(0.0))) continue;
    eom_kept_at(ly->it.method, ly->it.dim, path->kept + (size_t)slot * path->size, x, y);
    return EOM_OK;
  }
  return EOM_NOT_IN_STEP;
}
