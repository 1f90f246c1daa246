/* One step of an explicit Runge-Kutta method from its table: slopes, the new state, and its acceptance. */
#include "step.h"

#include <string.h>

/* out = from + h sum_j w_j k_j for vectors of components from i on; the sums are formed first: y is rounded once. */
TL_INLINE void combine_vectors(const eom_integrator *it, int vectors, size_t i, tl_real *out, const tl_real *from, tl_real h,
                               const tl_real *w, int first, int count, eom_lane *differences) {
  eom_lane sum[EOM_CHUNK];
  eom_sum_vectors(it, sum, vectors, i, w, first, count);
  TL_UNROLL
  for (int c = 0; c < vectors; c++) {
    const size_t at = i + (size_t)(c * EOM_LANE);
    const eom_lane x = EOM_AT_CONST(from + at) + h * sum[c];
    EOM_AT(out + at) = x;
    *differences += x - x;
  }
}

int eom_combine(const eom_integrator *it, tl_real *out, const tl_real *from, tl_real h, const tl_real *w, int count) {
  const int first = eom_first_weight(w, count);
  eom_lane differences = {TL_C(0.0)};
  size_t i = 0;
  for (; i + EOM_CHUNK * EOM_LANE <= it->stride; i += EOM_CHUNK * EOM_LANE)
    combine_vectors(it, EOM_CHUNK, i, out, from, h, w, first, count, &differences);
  for (; EOM_LANE > 1 && i + 4 * EOM_LANE <= it->stride; i += 4 * EOM_LANE)
    combine_vectors(it, 4, i, out, from, h, w, first, count, &differences);
  for (; EOM_LANE > 1 && i < it->stride; i += EOM_LANE) combine_vectors(it, 1, i, out, from, h, w, first, count, &differences);
  return eom_sum_lanes(&differences) == TL_C(0.0);
}

void eom_add_increment(eom_integrator *it, const tl_real *increment) {
  for (int i = 0; i < it->dim; i++) it->trial[i] = eom_sum_up(it->y[i], increment[i] + it->carry[i], &it->kept[i]);
}

/* The same with the increment h sum_j w_j k_j. */
TL_INLINE void increment_vectors(eom_integrator *it, int vectors, size_t i, tl_real h, const tl_real *w, int first, int count,
                                 eom_lane *differences) {
  eom_lane sum[EOM_CHUNK];
  eom_sum_vectors(it, sum, vectors, i, w, first, count);
  TL_UNROLL
  for (int c = 0; c < vectors; c++) {
    const size_t at = i + (size_t)(c * EOM_LANE);
    const eom_lane y = EOM_AT_CONST(it->y + at), increment = h * sum[c] + EOM_AT_CONST(it->carry + at);
    const eom_lane y1 = y + increment, part = y1 - y;
    EOM_AT(it->trial + at) = y1;
    EOM_AT(it->kept + at) = (y - (y1 - part)) + (increment - part);
    *differences += y1 - y1;
  }
}

/* Returns 1 where all are finite. */
static int add_increment(eom_integrator *it, tl_real h, const tl_real *w, int count) {
  const int first = eom_first_weight(w, count);
  eom_lane differences = {TL_C(0.0)};
  size_t i = 0;
  for (; i + EOM_CHUNK * EOM_LANE <= it->stride; i += EOM_CHUNK * EOM_LANE)
    increment_vectors(it, EOM_CHUNK, i, h, w, first, count, &differences);
  for (; EOM_LANE > 1 && i + 4 * EOM_LANE <= it->stride; i += 4 * EOM_LANE)
    increment_vectors(it, 4, i, h, w, first, count, &differences);
  for (; EOM_LANE > 1 && i < it->stride; i += EOM_LANE) increment_vectors(it, 1, i, h, w, first, count, &differences);
  return eom_sum_lanes(&differences) == TL_C(0.0);
}

int eom_all_finite(const tl_real *x, int count) {
  eom_lane differences = {TL_C(0.0)};
  int i = 0;
  for (; i + EOM_LANE <= count; i += EOM_LANE) differences += EOM_AT_CONST(x + i) - EOM_AT_CONST(x + i);
  tl_real sum = TL_C(0.0);
  for (; i < count; i++) sum += x[i] - x[i];
  return sum + eom_sum_lanes(&differences) == TL_C(0.0);
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
  const tl_real *w = m->a;
  for (int i = 1; status == EOM_OK && i < m->stages; w += i++) {
    if (!eom_combine(it, it->trial, it->y, h, w, i)) return EOM_NOT_FINITE;
    status = eom_evaluate(it, m->c[i] == TL_C(1.0) ? t1 : it->t + m->c[i] * h, it->trial, eom_slope(it, i));
  }
  if (status != EOM_OK) return status;
  return add_increment(it, h, w, m->stages) ? EOM_OK : EOM_NOT_FINITE;
}

void eom_drop_carry(eom_integrator *it) { memset(it->carry, 0, it->stride * sizeof(tl_real)); }

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
  if (it->correct)
    eom_drop_carry(it);
  else
    memcpy(it->carry, it->kept, bytes);
  it->t_before = it->t;
  it->t = it->t_after = t1;
  it->slope0 = SLOPE0_AT_END;
  it->interpolates = INTERPOLATES;
  it->steps++;
  return EOM_OK;
}
