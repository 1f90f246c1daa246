/* One step of an explicit Runge-Kutta method from its table: slopes, the new state, and its acceptance. */
#include "step.h"

#include <string.h>

/* The sums are formed first, slope by slope for a block of components at a time: y is rounded once. */
int eom_combine(const eom_integrator *it, tl_real *out, const tl_real *from, tl_real h, const tl_real *w, int count) {
  const int first = eom_first_weight(w, count);
  tl_real not_finite[EOM_BLOCK] = {TL_C(0.0)};
  for (size_t i = 0; i < it->stride; i += EOM_BLOCK) {
    tl_real sum[EOM_BLOCK];
    eom_sum_slopes(it, sum, i, w, first, count);
    for (int b = 0; b < EOM_BLOCK; b++) {
      const tl_real x = from[i + (size_t)b] + h * sum[b];
      out[i + (size_t)b] = x;
      not_finite[b] += x - x;
    }
  }
  tl_real sum = TL_C(0.0);
  for (int b = 0; b < EOM_BLOCK; b++) sum += not_finite[b];
  return sum == TL_C(0.0);
}

int eom_all_finite(const tl_real *x, int count) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < count; i++) sum += x[i] - x[i];
  return sum == TL_C(0.0);
}

eom_status eom_evaluate(eom_integrator *it, tl_real t, const tl_real *y, tl_real *ydot) {
  it->evaluations++;
  it->rhs_code = it->rhs(it->user, t, y, ydot);
  return it->rhs_code == 0 ? EOM_OK : EOM_RHS_FAILED;
}

eom_status eom_start_slope(eom_integrator *it) {
  if (it->slope0 == SLOPE0_AT_END) memcpy(it->slope, eom_slope(it, it->method->stages), (size_t)it->dim * sizeof(tl_real));
  if (it->slope0 == SLOPE0_UNKNOWN) {
    const eom_status status = eom_evaluate(it, it->t, it->y, it->slope);
    if (status != EOM_OK) return status;
    if (!eom_all_finite(it->slope, it->dim)) return EOM_NOT_FINITE;
  }
  it->slope0 = SLOPE0_KNOWN;
  return EOM_OK;
}

eom_status eom_try_step(eom_integrator *it, tl_real h, tl_real t1) {
  const eom_method *m = it->method;
  it->interpolates = INTERPOLATES_NOT;
  eom_status status = eom_start_slope(it);
  for (int i = 1; status == EOM_OK && i <= m->stages; i++) {
    if (!eom_combine(it, it->trial, it->y, h, m->a + i * (i - 1) / 2, i)) return EOM_NOT_FINITE;
    if (i == m->stages) break;
    status = eom_evaluate(it, m->c[i] == TL_C(1.0) ? t1 : it->t + m->c[i] * h, it->trial, eom_slope(it, i));
  }
  return status;
}

eom_status eom_take_step(eom_integrator *it, tl_real t1, int end_known) {
  const size_t bytes = (size_t)it->dim * sizeof(tl_real);
  tl_real *end = eom_slope(it, it->method->stages);
  if (it->correct) {
    it->rhs_code = it->correct(it->user, t1, it->trial);
    if (it->rhs_code != 0) return EOM_RHS_FAILED;
    if (!eom_all_finite(it->trial, it->dim)) return EOM_NOT_FINITE;
  }
  if (!end_known || it->correct) {
    const eom_status status = eom_evaluate(it, t1, it->trial, end);
    if (status != EOM_OK) return status;
  }
  if (!eom_all_finite(end, it->dim)) return EOM_NOT_FINITE;
  memcpy(it->before, it->y, bytes);
  memcpy(it->y, it->trial, bytes);
  it->t_before = it->t;
  it->t = it->t_after = t1;
  it->slope0 = SLOPE0_AT_END;
  it->interpolates = INTERPOLATES;
  it->steps++;
  return EOM_OK;
}
