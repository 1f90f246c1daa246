/* Explicit Runge-Kutta steps of fixed length from a tableau, and the tableau of Dormand and Prince. */
#include "eom/integrate.h"

#include <assert.h>
#include <string.h>

/* J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6 (1980). */
static const tl_real dp5_c[] = {
    TL_C(0.0), TL_C(1.0) / TL_C(5.0), TL_C(3.0) / TL_C(10.0), TL_C(4.0) / TL_C(5.0), TL_C(8.0) / TL_C(9.0), TL_C(1.0), TL_C(1.0)};
static const tl_real dp5_a[] = {
    TL_C(1.0) / TL_C(5.0), /* stage 1 */
    TL_C(3.0) / TL_C(40.0),     TL_C(9.0) / TL_C(40.0),        TL_C(44.0) / TL_C(45.0),       TL_C(-56.0) / TL_C(15.0),
    TL_C(32.0) / TL_C(9.0),     TL_C(19372.0) / TL_C(6561.0),  TL_C(-25360.0) / TL_C(2187.0), TL_C(64448.0) / TL_C(6561.0),
    TL_C(-212.0) / TL_C(729.0), TL_C(9017.0) / TL_C(3168.0),   TL_C(-355.0) / TL_C(33.0),     TL_C(46732.0) / TL_C(5247.0),
    TL_C(49.0) / TL_C(176.0),   TL_C(-5103.0) / TL_C(18656.0), TL_C(35.0) / TL_C(384.0),      TL_C(0.0),
    TL_C(500.0) / TL_C(1113.0), TL_C(125.0) / TL_C(192.0),     TL_C(-2187.0) / TL_C(6784.0),  TL_C(11.0) / TL_C(84.0)};
static const tl_real dp5_b[] = {
    TL_C(35.0) / TL_C(384.0), TL_C(0.0), TL_C(500.0) / TL_C(1113.0), TL_C(125.0) / TL_C(192.0), TL_C(-2187.0) / TL_C(6784.0),
    TL_C(11.0) / TL_C(84.0),  TL_C(0.0)};

const eom_method eom_dp5 = {.name = "dp5", .order = 5, .stages = 7, .fsal = 1, .a = dp5_a, .b = dp5_b, .c = dp5_c};

const eom_method *eom_method_find(const char *name) {
  static const eom_method *const all[] = {&eom_dp5};
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
    if (strcmp(all[i]->name, name) == 0) return all[i];
  return NULL;
}

size_t eom_integrator_size(const eom_method *method, int dim) { return ((size_t)method->stages + 2) * (size_t)dim; }

void eom_integrator_init(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, tl_real t,
                         const tl_real *y, tl_real h, tl_real *work) {
  assert(method && rhs && dim > 0 && y && work);
  const size_t d = (size_t)dim;
  *it = (eom_integrator){.method = method, .rhs = rhs, .user = user, .dim = dim, .h = h, .t0 = t, .t = t};
  it->y = work;
  it->trial = work + d;
  it->stage = work + 2 * d;
  memcpy(it->y, y, d * sizeof(tl_real));
}

void eom_integrator_restart(eom_integrator *it) { it->first_known = 0; }

static eom_status evaluate(eom_integrator *it, tl_real t, const tl_real *y, tl_real *ydot) {
  it->evaluations++;
  it->rhs_code = it->rhs(it->user, t, y, ydot);
  return it->rhs_code == 0 ? EOM_OK : EOM_RHS_FAILED;
}

/* trial = y + h sum_j a_j k_j. The sum is formed first: zeros cost nothing and y is rounded once. */
static void combine(eom_integrator *it, tl_real h, const tl_real *a, int count) {
  const size_t d = (size_t)it->dim;
  memset(it->trial, 0, d * sizeof(tl_real));
  for (int j = 0; j < count; j++) {
    if (a[j] == TL_C(0.0)) continue;
    const tl_real *k = it->stage + (size_t)j * d;
    for (size_t i = 0; i < d; i++) it->trial[i] += a[j] * k[i];
  }
  for (size_t i = 0; i < d; i++) it->trial[i] = it->y[i] + h * it->trial[i];
}

static int all_finite(const tl_real *x, int count) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < count; i++) sum += x[i] - x[i];
  return sum == TL_C(0.0);
}

/* k_i = f(t + c_i h, y + h sum_j<i a_ij k_j), y = y + h sum_i b_i k_i. In a tableau with fsal the last trial point is the new y. */
static eom_status step(eom_integrator *it, tl_real h, tl_real t_new) {
  const eom_method *m = it->method;
  const size_t d = (size_t)it->dim;
  if (!it->first_known) {
    const eom_status status = evaluate(it, it->t, it->y, it->stage);
    if (status != EOM_OK) return status;
    it->first_known = 1;
  }
  for (int i = 1; i < m->stages; i++) {
    combine(it, h, m->a + i * (i - 1) / 2, i);
    if (!all_finite(it->trial, it->dim)) return EOM_NOT_FINITE;
    const tl_real t = m->c[i] == TL_C(1.0) ? t_new : it->t + m->c[i] * h;
    const eom_status status = evaluate(it, t, it->trial, it->stage + (size_t)i * d);
    if (status != EOM_OK) return status;
  }
  if (!m->fsal) combine(it, h, m->b, m->stages);
  if (!all_finite(it->trial, it->dim)) return EOM_NOT_FINITE;
  if (it->correct && (it->rhs_code = it->correct(it->user, t_new, it->trial)) != 0) return EOM_RHS_FAILED;
  memcpy(it->y, it->trial, d * sizeof(tl_real));
  it->first_known = m->fsal && !it->correct;
  if (it->first_known) memcpy(it->stage, it->stage + (size_t)(m->stages - 1) * d, d * sizeof(tl_real));
  it->t = t_new;
  return EOM_OK;
}

eom_status eom_integrator_step(eom_integrator *it) {
  const eom_status status = step(it, it->h, it->t0 + (tl_real)(it->steps + 1) * it->h);
  if (status == EOM_OK) it->steps++;
  return status;
}

/* Rounding of t in parts of h: what is left of the way is then no step. */
static tl_real step_rounding(const eom_integrator *it, tl_real t_end) {
  const tl_real largest = TL_LIBM(fmax)(TL_LIBM(fabs)(it->t), TL_LIBM(fabs)(t_end));
  return TL_C(8.0) * TL_EPSILON * (TL_C(1.0) + largest / TL_LIBM(fabs)(it->h));
}

/* A shortened step, after which steps are counted from the new time. */
static eom_status last_step(eom_integrator *it, tl_real t_end) {
  const eom_status status = step(it, t_end - it->t, t_end);
  if (status != EOM_OK) return status;
  it->t0 = t_end - (tl_real)(it->steps + 1) * it->h;
  it->steps++;
  return EOM_OK;
}

eom_status eom_integrate(eom_integrator *it, tl_real t_end, eom_observe_fn *observe, void *observer) {
  const tl_real way = (t_end - it->t) / it->h;
  if (!(way >= TL_C(0.0) && way <= TL_MAX)) return EOM_BAD_OPTION;
  for (;;) {
    const tl_real left = (t_end - it->t) / it->h;
    const tl_real rounding = step_rounding(it, t_end);
    if (left <= rounding) return EOM_OK;
    const eom_status status = left < TL_C(1.0) - rounding ? last_step(it, t_end) : eom_integrator_step(it);
    if (status != EOM_OK) return status;
    if (observe && observe(observer, it) != 0) return EOM_STOPPED;
  }
}
