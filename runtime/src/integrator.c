/* The start of an integrator, and its steps one by one: nothing that chooses their length, looks into them or ends at a time. */
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

void eom_restart_behind(eom_integrator *it, int same) {
  it->slope0 = SLOPE0_UNKNOWN;
  memset(it->carry + same, 0, (it->stride - (size_t)same) * sizeof(tl_real));
  if (it->interpolates != INTERPOLATES_READY) it->interpolates = INTERPOLATES_NOT; /* f may be another one now */
  it->watched = 0;
}

void eom_integrator_restart(eom_integrator *it) { eom_restart_behind(it, 0); }

eom_status eom_fixed_step(eom_integrator *it, tl_real h, tl_real t1) {
  if (it->scheme) return it->scheme->step(it, h, t1);
  const eom_status status = eom_try_step(it, h, t1);
  return status == EOM_OK ? eom_take_step(it, t1, 0) : status;
}

eom_status eom_integrator_step(eom_integrator *it) {
  it->worst = -1;
  if (it->controlled) return it->controlled(it, TL_LIBM(copysign)(TL_MAX, it->h));
  return eom_fixed_step(it, it->h, it->t0 + (tl_real)(it->steps + 1) * it->h);
}
