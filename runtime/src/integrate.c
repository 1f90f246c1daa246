/* Integration of y' = f(t,y) step by step, until a time. */
#include "step.h"

/* A shortened step, after which steps are counted from the new time. */
static eom_status last_step(eom_integrator *it, tl_real t_end) {
  const eom_status status = eom_fixed_step(it, t_end - it->t, t_end);
  if (status == EOM_OK) it->t0 = t_end - (tl_real)it->steps * it->h;
  return status;
}

/* Rounding of t in parts of h: what is left of the way is then no step. */
static tl_real step_rounding(const eom_integrator *it, tl_real t_end) {
  const tl_real largest = TL_LIBM(fmax)(TL_LIBM(fabs)(it->t), TL_LIBM(fabs)(t_end));
  return TL_C(8.0) * TL_EPSILON * (TL_C(1.0) + largest / TL_LIBM(fabs)(it->h));
}

/* No step is left before t_end. */
static int arrived(const eom_integrator *it, tl_real t_end) {
  return it->controlled ? it->t == t_end : (t_end - it->t) / it->h <= step_rounding(it, t_end);
}

static eom_status step_towards(eom_integrator *it, tl_real t_end) {
  it->worst = -1;
  if (it->controlled) return it->controlled(it, t_end);
  return (t_end - it->t) / it->h < TL_C(1.0) - step_rounding(it, t_end) ? last_step(it, t_end) : eom_integrator_step(it);
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
