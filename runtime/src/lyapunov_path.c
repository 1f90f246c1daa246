/* The motion ahead of its tangents. Where steps are chosen, the motion takes those that its own tolerance asks for, which are many, and
 * tangents, which need fewer digits, take longer ones; at their stages they see the motion by an interpolation that is good enough for
 * them. */
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

/* What the motion on the path may be wrong by, in parts of the tangents' tolerance. */
static const tl_real path_part = TL_C(0.1);

/* The last step of the motion: from its ends alone where that is good enough, and the method's own interpolation would cost further
 * evaluations. */
static eom_status keep(eom_lyapunov *ly, long slot) {
  eom_lyapunov_path *path = &ly->work->path;
  tl_real *kept = path->kept + (size_t)slot * path->size;
  if (ly->options.taylor) {
    path->rows[slot] = eom_keep_series(&ly->it, path_part * ly->options.tangent_tolerance, kept);
    return EOM_OK;
  }
  if (ly->it.method->dense_stages > 0) {
    path->rows[slot] = EOM_MOTION_ROWS;
    eom_keep_motion(&ly->it, kept);
    if (eom_motion_defect(&ly->it, kept) <= path_part * ly->options.tangent_tolerance) return EOM_OK;
  }
  path->rows[slot] = eom_kept_rows(ly->it.method);
  return eom_keep_step(&ly->it, kept);
}

static tl_real longer(tl_real h, tl_real other) { return TL_LIBM(fabs)(other) > TL_LIBM(fabs)(h) ? other : h; }

/* One more step of the motion, in the place of the oldest one: not while the tangents need that. Their step is then tried again with a
 * shorter one. */
static eom_status extend(eom_lyapunov *ly) {
  eom_lyapunov_path *path = &ly->work->path;
  eom_integrator *it = &ly->it;
  const long slot = path->count % EOM_PATH_STEPS;
  if (path->count >= EOM_PATH_STEPS && (path->end[slot] - ly->tangents.t) / ly->options.interval > TL_C(0.0)) return EOM_NOT_IN_STEP;
  eom_status status = eom_integrate(it, path->t_mark, stop_after_step, NULL);
  if (status == EOM_OK || status == EOM_STOPPED) status = keep(ly, slot);
  if (status == EOM_RHS_FAILED) status = (eom_status)it->rhs_code;
  path->begin[slot] = it->t_before;
  path->end[slot] = it->t;
  path->full[slot] = it->t == path->t_mark ? longer(it->h, it->t - it->t_before) : it->t - it->t_before;
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
    (ly->options.taylor ? eom_series_at : eom_kept_at)(path->rows[slot], ly->it.dim, path->kept + (size_t)slot * path->size, x, y);
    return EOM_OK;
  }
  return EOM_NOT_IN_STEP;
}

/* The first step that is kept and ends behind t; path->count where none does. */
static long step_at(const eom_lyapunov *ly, tl_real t) {
  const eom_lyapunov_path *path = &ly->work->path;
  long i = path->count > EOM_PATH_STEPS ? path->count - EOM_PATH_STEPS : 0;
  while (i < path->count && !((path->end[i % EOM_PATH_STEPS] - t) / ly->options.interval > TL_C(0.0))) i++;
  return i;
}

eom_status eom_lyapunov_path_after(eom_lyapunov *ly, tl_real t, tl_real steps, tl_real *after) {
  eom_lyapunov_path *path = &ly->work->path;
  for (long i = step_at(ly, t); t != path->t_mark; i++) {
    if (i == path->count) {
      const eom_status status = path->status == EOM_OK ? extend(ly) : path->status;
      if (status != EOM_OK) return status;
    }
    const long slot = i % EOM_PATH_STEPS;
    const tl_real part = (path->end[slot] - t) / path->full[slot];
    if (part >= steps) {
      t += steps * path->full[slot];
      break;
    }
    steps -= part;
    t = path->end[slot];
  }
  *after = t;
  return EOM_OK;
}

tl_real eom_lyapunov_path_steps(const eom_lyapunov *ly, tl_real begin, tl_real end) {
  const eom_lyapunov_path *path = &ly->work->path;
  tl_real steps = TL_C(0.0);
  for (long i = step_at(ly, begin); i < path->count; i++) {
    const long slot = i % EOM_PATH_STEPS;
    const bool last = (path->end[slot] - end) / ly->options.interval >= TL_C(0.0);
    steps += ((last ? end : path->end[slot]) - begin) / path->full[slot];
    if (last) break;
    begin = path->end[slot];
  }
  return steps;
}
