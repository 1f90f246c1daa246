/* States inside the last step, by the interpolation that belongs to its method. */
#include "step.h"

#include <string.h>

/* Slopes behind the end of the step, then h sum_j d_j k_j for each row of the table, in the place of slopes 1, 2, ..: neither has a
 * weight on these, so that slope 1 can hold the points before. */
static eom_status prepare(eom_integrator *it) {
  const eom_method *m = it->method;
  const int first = m->stages + 1, count = first + m->dense_stages;
  const tl_real h = it->t_after - it->t_before;
  tl_real *point = eom_slope(it, 1);
  for (int i = first; i < count; i++) {
    if (!eom_combine(it, point, it->before, h, m->a + i * (i - 1) / 2, i)) return EOM_NOT_FINITE;
    const eom_status status = eom_evaluate(it, it->t_before + m->c[i] * h, point, eom_slope(it, i));
    if (status != EOM_OK) return status;
  }
  for (int row = 0; row < m->dense_rows; row++) {
    tl_real *d = eom_slope(it, row + 1);
    memset(d, 0, it->stride * sizeof(tl_real));
    if (!eom_combine(it, d, d, h, m->dense + row * count, count)) return EOM_NOT_FINITE;
  }
  it->interpolates = INTERPOLATES_READY;
  return EOM_OK;
}

/* With x = (t - t_before)/h and D = y1 - y, the polynomial
 *
 *     y + x (D + (1-x) (h k_0 - D + x (2 D - h k_0 - h k_s + (1-x) (d_0 + x (d_1 + (1-x) (d_2 + x d_3))))))
 *
 * has the states and slopes of both ends whatever the d: without them it is Hermite's cubic. */
static void evaluate(const eom_integrator *it, tl_real x, tl_real *y) {
  const tl_real h = it->t_after - it->t_before, rest = TL_C(1.0) - x;
  const tl_real *k0 = it->slope, *ks = eom_slope(it, it->method->stages);
  for (int i = 0; i < it->dim; i++) {
    const tl_real change = it->trial[i] - it->before[i], start = h * k0[i] - change, end = change - h * ks[i];
    tl_real sum = TL_C(0.0);
    for (int row = it->method->dense_rows; row > 0; row--) sum = eom_slope(it, row)[i] + (row % 2 ? x : rest) * sum;
    y[i] = it->before[i] + x * (change + rest * (start + x * (end - start + rest * sum)));
  }
}

/* ---- steps that are kept: the coefficients of the polynomial from outside in, row by row ---- */

int eom_kept_rows(const eom_method *method) { return 4 + method->dense_rows; }

/* Hermite's cubic. */
static void keep_cubic(const eom_integrator *it, tl_real *kept) {
  const tl_real h = it->t_after - it->t_before;
  const tl_real *k0 = it->slope, *ks = eom_slope(it, it->method->stages);
  const int dim = it->dim;
  for (int i = 0; i < dim; i++) {
    const tl_real change = it->trial[i] - it->before[i], start = h * k0[i] - change, end = change - h * ks[i];
    kept[i] = it->before[i];
    kept[dim + i] = change;
    kept[2 * dim + i] = start;
    kept[3 * dim + i] = end - start;
  }
}

eom_status eom_keep_step(eom_integrator *it, tl_real *kept) {
  if (it->interpolates != INTERPOLATES_READY) {
    const eom_status status = prepare(it);
    if (status != EOM_OK) return status;
  }
  keep_cubic(it, kept);
  for (int row = 0; row < it->method->dense_rows; row++)
    memcpy(kept + (4 + row) * it->dim, eom_slope(it, row + 1), (size_t)it->dim * sizeof(tl_real));
  return EOM_OK;
}

/* The quintic's term x^2 (1-x)^2 (d_0 + x d_1), from h^2 qdd = 2 (d_0 + rest - start) at its start and 2 (d_0 + d_1 - 2 rest - start)
 * at its end, rest and start those of the cubic; its derivative is the quartic of qd with 5 d_1/h in the place of d_0. */
void eom_keep_motion(const eom_integrator *it, tl_real *kept) {
  const tl_real h = it->t_after - it->t_before;
  const tl_real *k0 = it->slope, *ks = eom_slope(it, it->method->stages);
  const int dim = it->dim, n = dim / 2;
  keep_cubic(it, kept);
  for (int i = 0; i < n; i++) {
    const tl_real start = kept[2 * dim + i], rest = kept[3 * dim + i], half = TL_C(0.5) * h * h;
    const tl_real d1 = half * (ks[n + i] - k0[n + i]) + TL_C(3.0) * rest;
    kept[4 * dim + i] = half * k0[n + i] + start - rest;
    kept[5 * dim + i] = d1;
    kept[4 * dim + n + i] = TL_C(5.0) * d1 / h;
    kept[5 * dim + n + i] = TL_C(0.0);
  }
}

/* Of the stages that is nearest the middle of a step. */
static int middle_stage(const eom_method *m) {
  int middle = 0;
  for (int i = 1; i < m->stages; i++)
    if (TL_LIBM(fabs)(m->c[i] - TL_C(0.5)) <= TL_LIBM(fabs)(m->c[middle] - TL_C(0.5))) middle = i;
  return middle;
}

tl_real eom_motion_defect(const eom_integrator *it, const tl_real *kept) {
  const int dim = it->dim, n = dim / 2, stage = middle_stage(it->method);
  const tl_real h = it->t_after - it->t_before, x = it->method->c[stage], rest = TL_C(1.0) - x, *k = eom_slope(it, stage);
  tl_real worst = TL_C(0.0);
  for (int i = n; i < dim; i++) {
    const tl_real *own = kept + i;
    const tl_real slope =
        own[dim] + (rest - x) * (own[2 * dim] + TL_C(2.0) * x * rest * own[4 * dim]) + x * (TL_C(2.0) - TL_C(3.0) * x) * own[3 * dim];
    const tl_real defect = TL_LIBM(fabs)(slope - h * k[i]) / (TL_C(1.0) + TL_LIBM(fabs)(own[0]));
    if (!(defect <= worst)) worst = defect;
  }
  return worst;
}

/* row_0 + even (row_1 + odd (row_2 + even (..))). */
static void nest(int rows, int dim, const tl_real *kept, tl_real even, tl_real odd, tl_real *y) {
  const tl_real factor[2] = {even, odd};
  int i = 0;
  for (; i + EOM_LANE <= dim; i += EOM_LANE) {
    eom_lane sum = EOM_AT_CONST(kept + (rows - 1) * dim + i);
    for (int row = rows - 2; row >= 0; row--) sum = EOM_AT_CONST(kept + row * dim + i) + factor[row % 2] * sum;
    EOM_AT(y + i) = sum;
  }
  for (; i < dim; i++) {
    tl_real sum = kept[(rows - 1) * dim + i];
    for (int row = rows - 2; row >= 0; row--) sum = kept[row * dim + i] + factor[row % 2] * sum;
    y[i] = sum;
  }
}

void eom_kept_at(int rows, int dim, const tl_real *kept, tl_real x, tl_real *y) { nest(rows, dim, kept, x, TL_C(1.0) - x, y); }

void eom_series_at(int rows, int dim, const tl_real *kept, tl_real x, tl_real *y) { nest(rows, dim, kept, x, x, y); }

eom_status eom_interpolate(eom_integrator *it, tl_real t, tl_real *y) {
  if (!it->interpolates) return EOM_NOT_IN_STEP;
  const tl_real x = (t - it->t_before) / (it->t_after - it->t_before);
  if (!(x >= TL_C(0.0) && x <= TL_C(1.0))) return EOM_NOT_IN_STEP;
  if (it->scheme) return it->scheme->interpolate(it, x, y);
  if (it->interpolates != INTERPOLATES_READY) {
    const eom_status status = prepare(it);
    if (status != EOM_OK) return status;
  }
  evaluate(it, x, y);
  return EOM_OK;
}

/* The state that is integrated does not change; what is computed for the interpolation is kept in *it and its memory. */
eom_status eom_integrator_at(const eom_integrator *it, tl_real t, tl_real *y) {
  if (t == it->t) {
    memcpy(y, it->y, (size_t)it->dim * sizeof(tl_real));
    return EOM_OK;
  }
  if (!((t - it->t_before) * (it->t - t) >= TL_C(0.0))) return EOM_NOT_IN_STEP;
  return eom_interpolate((eom_integrator *)it, t, y);
}
