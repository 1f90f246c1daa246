/* Integration of y' = f(t,y) step by step, until a time. */
#include "eom/integrate.h"

#include "step.h"

#include <assert.h>
#include <string.h>

_Static_assert(EOM_INTEGRATOR_SIZE(0, 0, 1) == 6 * EOM_BLOCK, "EOM_INTEGRATOR_SIZE counts whole blocks");

static size_t stride_of(int dim) { return ((size_t)dim + EOM_BLOCK - 1) / EOM_BLOCK * EOM_BLOCK; }

/* y, y_before, the trial point, what rounding y and the trial point has lost, and the slopes with the one at the end of a step. */
size_t eom_integrator_size(const eom_method *method, int dim) {
  return EOM_INTEGRATOR_SIZE((size_t)method->stages, (size_t)method->dense_stages, (size_t)dim);
}

void eom_integrator_init(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, tl_real t,
                         const tl_real *y, tl_real h, tl_real *work) {
  assert(method && rhs && dim > 0 && y && work);
  const size_t stride = stride_of(dim);
  memset(work, 0, eom_integrator_size(method, dim) * sizeof(tl_real));
  *it = (eom_integrator){.method = method, .rhs = rhs, .user = user, .dim = dim, .h = h, .t0 = t, .t = t, .t_before = t};
  it->worst = -1;
  it->stride = stride;
  it->y = work;
  it->before = work + stride;
  it->y_before = it->before;
  it->trial = work + 2 * stride;
  it->carry = work + 3 * stride;
  it->kept = work + 4 * stride;
  it->slope = work + 5 * stride;
  memcpy(it->y, y, (size_t)dim * sizeof(tl_real));
}

void eom_integrator_restart(eom_integrator *it) {
  it->slope0 = SLOPE0_UNKNOWN;
  eom_drop_carry(it);
  if (it->interpolates != INTERPOLATES_READY) it->interpolates = INTERPOLATES_NOT; /* f may be another one now */
  if (it->events) eom_events_forget(it->events);
}

/* ---- fixed steps ---- */

static eom_status fixed_step(eom_integrator *it, tl_real h, tl_real t1) {
  if (it->scheme) return it->scheme->step(it, h, t1);
  const eom_status status = eom_try_step(it, h, t1);
  return status == EOM_OK ? eom_take_step(it, t1, 0) : status;
}

static eom_status whole_step(eom_integrator *it) { return fixed_step(it, it->h, it->t0 + (tl_real)(it->steps + 1) * it->h); }

/* A shortened step, after which steps are counted from the new time. */
static eom_status last_step(eom_integrator *it, tl_real t_end) {
  const eom_status status = fixed_step(it, t_end - it->t, t_end);
  if (status == EOM_OK) it->t0 = t_end - (tl_real)it->steps * it->h;
  return status;
}

/* Rounding of t in parts of h: what is left of the way is then no step. */
static tl_real step_rounding(const eom_integrator *it, tl_real t_end) {
  const tl_real largest = TL_LIBM(fmax)(TL_LIBM(fabs)(it->t), TL_LIBM(fabs)(t_end));
  return TL_C(8.0) * TL_EPSILON * (TL_C(1.0) + largest / TL_LIBM(fabs)(it->h));
}

/* ---- either ---- */

eom_status eom_integrator_step(eom_integrator *it) {
  it->worst = -1;
  return it->controlled ? eom_controlled_step(it, TL_LIBM(copysign)(TL_MAX, it->h)) : whole_step(it);
}

/* No step is left before t_end. */
static int arrived(const eom_integrator *it, tl_real t_end) {
  return it->controlled ? it->t == t_end : (t_end - it->t) / it->h <= step_rounding(it, t_end);
}

static eom_status step_towards(eom_integrator *it, tl_real t_end) {
  it->worst = -1;
  if (it->controlled) return eom_controlled_step(it, t_end);
  return (t_end - it->t) / it->h < TL_C(1.0) - step_rounding(it, t_end) ? last_step(it, t_end) : whole_step(it);
}

/* h leads to t_end, which is a time. */
static int leads_to(eom_integrator *it, tl_real t_end) {
  if (it->controlled) {
    it->h = TL_LIBM(copysign)(it->h, t_end - it->t);
    return TL_ISFINITE(t_end) && TL_ISFINITE(it->h);
  }
  const tl_real way = (t_end - it->t) / it->h, largest = TL_LIBM(fmax)(TL_LIBM(fabs)(it->t), TL_LIBM(fabs)(t_end));
  if (way > TL_C(0.0) && TL_LIBM(fabs)(it->h) < TL_C(0.5) * TL_EPSILON * largest) return 0; /* t + h would be t */
  return way >= TL_C(0.0) && way <= TL_MAX;
}

eom_status eom_integrate(eom_integrator *it, tl_real t_end, eom_observe_fn *observe, void *observer) {
  if (!leads_to(it, t_end)) return EOM_BAD_OPTION;
  const long before = it->steps + it->rejected + it->failed, most = it->control.most_steps;
  eom_status status = eom_write_outputs(it, it->t);
  while (status == EOM_OK && !arrived(it, t_end)) {
    if (most > 0 && it->steps + it->rejected + it->failed - before >= most) return EOM_TOO_MUCH_WORK;
    status = step_towards(it, t_end);
    if (status == EOM_OK && it->events) status = eom_watch_step(it);
    if (status == EOM_OK || status == EOM_STOPPED) {
      const eom_status written = eom_write_outputs(it, it->t);
      if (written != EOM_OK) return written;
      if (observe && observe(observer, it) != 0) return EOM_STOPPED;
    }
  }
  return status;
}
