/* Steps by Taylor series: the coefficients, how far they reach, and the state there. */
#include "eom/taylor.h"

#include "baumgarte.h"
#include "eom/solve.h"
#include "evaluate.h"
#include "step.h"

#include <assert.h>
#include <string.h>

enum { LEAST_ORDER = 4 /* of the state */, MOST_ORDER = EOM_TAYLOR_MOST - 1 };

static tl_real larger(tl_real a, tl_real b) { return a > b ? a : b; }
static tl_real size(tl_real x) { return TL_LIBM(fabs)(x); }

/* ---- coefficients ---- */

/* Where the work of a step grew with the square of its order p, a time would be reached with the least work if e^-2 to the power p - 1
 * were the tolerance (Jorba and Zou, section 3.2). It grows less: what surrounds the recurrences does not depend on the order, and of
 * products of series a large part is linear in it. By C'(p)/C(p) = -ln(tolerance)/p^2, with the work C as measured for two to seven
 * coordinates, orders four to eight above theirs take least. */
static int order_for(tl_real tolerance) {
  const tl_real half_ln2 = TL_C(0.34657359027997264), more = TL_C(5.0);
  const tl_real order = TL_LIBM(ceil)(TL_C(1.0) + more - half_ln2 * TL_LIBM(log2)(larger(tolerance, TL_C(0.25) * TL_EPSILON)));
  return order<(tl_real)LEAST_ORDER ? LEAST_ORDER : order>(tl_real) MOST_ORDER ? MOST_ORDER : (int)order;
}

/* The tolerance of the whole state, relative: that of its strictest component. */
static tl_real relative_tolerance(const eom_integrator *it) {
  tl_real norm = TL_MIN, least = TL_MAX;
  for (int i = 0; i < it->dim; i++) {
    const tl_real scale = eom_scale(it, i, it->y[i]);
    norm = larger(norm, size(it->y[i]));
    if (scale < least) least = scale;
  }
  return least < norm ? least / norm : TL_C(1.0);
}

/* Of the motion from (t, y) on, where the acceleration is known to exist. */
static eom_status expand(eom_integrator *it, int order) {
  eom_taylor *v = it->own;
  eom_system *sys = v->sys;
  it->interpolates = INTERPOLATES_NOT;
  eom_status status = eom_start_slope(it);
  if (status != EOM_OK) return status;
  v->order = order + 1;
  const int code = sys->motion->taylor(sys->params, it->y, it->y + sys->n, it->t, v->order, v->coef, sys->workspace->motion_work);
  if (code == 0) return EOM_OK;
  it->rhs_code = (int)eom_motion_verdict(sys, code, it->y, it->y + sys->n, it->t);
  return EOM_RHS_FAILED;
}

/* Accelerations, where they come from the elimination that the coefficients repeat. */
static int acceleration(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  eom_system *sys = user;
  const int code = eom_rhs(sys, t, y, ydot);
  if (code != 0) return code;
  return sys->report.pivot < TL_C(0.0) ? 0 : (int)(sys->report.status = EOM_NO_SERIES);
}

/* q, qd and qdd at h behind the start, less q and qd at the start; any of the three may be null. Even and odd powers beside each other:
 * each sum waits for half as many terms. */
static void sum_up(const eom_taylor *v, tl_real h, tl_real *dq, tl_real *dqd, tl_real *qdd) {
  const tl_real square = h * h;
  for (int i = 0; i < v->sys->n; i++) {
    const tl_real *c = v->coef + (size_t)i * (size_t)(v->order + 1);
    tl_real even[3] = {TL_C(0.0)}, odd[3] = {TL_C(0.0)};
    for (int k = v->order / 2 * 2; k > 1; k -= 2) {
      const tl_real one = c[k], next = k < v->order ? c[k + 1] : TL_C(0.0), weight = (tl_real)k;
      const tl_real first_one = weight * one, first_next = (weight + TL_C(1.0)) * next;
      even[0] = even[0] * square + one;
      odd[0] = odd[0] * square + next;
      even[1] = even[1] * square + first_one;
      odd[1] = odd[1] * square + first_next;
      even[2] = even[2] * square + (weight - TL_C(1.0)) * first_one;
      odd[2] = odd[2] * square + weight * first_next;
    }
    if (dq) dq[i] = (c[1] + (even[0] + odd[0] * h) * h) * h;
    if (dqd) dqd[i] = (even[1] + odd[1] * h) * h;
    if (qdd) qdd[i] = even[2] + odd[2] * h;
  }
}

/* ---- a step ---- */

/* trial = y + (increment + carry), in it->kept what rounding loses, and the slope there. */
static eom_status attempt(eom_integrator *it, tl_real h, tl_real t1) {
  const eom_taylor *v = it->own;
  const int n = v->sys->n;
  tl_real *increment = it->trial, *end = eom_slope(it, it->method->stages), *qdd = eom_slope(it, 1);
  sum_up(v, h, increment, increment + n, qdd);
  eom_add_increment(it, increment);
  if (!eom_all_finite(it->trial, it->dim)) return EOM_NOT_FINITE;
  const eom_status status = eom_evaluate(it, t1, it->trial, end);
  if (status != EOM_OK) return status;
  it->error = TL_C(0.0);
  for (int i = n; i < 2 * n; i++) {
    const tl_real rounding = TL_C(64.0) * TL_EPSILON * (size(it->trial[i]) + size(h * end[i]) * (tl_real)v->order);
    const tl_real error = size(h * (qdd[i - n] - end[i])) / ((tl_real)v->order * eom_scale(it, i, it->trial[i]) + rounding);
    if (!(error <= it->error)) it->error = error, it->worst = i;
  }
  return EOM_OK;
}

static eom_status step(eom_integrator *it, tl_real h, tl_real t1) {
  eom_status status = expand(it, order_for(TL_EPSILON));
  if (status == EOM_OK) status = attempt(it, h, t1);
  it->worst = -1;
  return status == EOM_OK ? eom_take_step(it, t1, 1) : status;
}

/* log2 of max_i |coefficient k of y_i| / scale_i. */
static tl_real log_size(const eom_integrator *it, int k) {
  const eom_taylor *v = it->own;
  tl_real most = TL_MIN;
  for (int i = 0; i < v->sys->n; i++) {
    const tl_real *c = v->coef + (size_t)i * (size_t)(v->order + 1);
    most = larger(most, size(c[k]) / eom_scale(it, i, it->y[i]));
    most = larger(most, size((tl_real)(k + 1) * c[k + 1]) / eom_scale(it, v->sys->n + i, it->y[v->sys->n + i]));
  }
  return TL_LIBM(log2)(most);
}

/* The step after which neither of the last two terms is larger than its scale, a little shortened (Jorba and Zou, section 3.3). */
static eom_status choose(eom_integrator *it) {
  const int p = order_for(relative_tolerance(it));
  const eom_status status = expand(it, p);
  if (status != EOM_OK) return status;
  const tl_real last = log_size(it, p) / (tl_real)p, before = log_size(it, p - 1) / (tl_real)(p - 1);
  it->h = TL_LIBM(exp2)(-larger(last, before) - TL_C(1.0) / (tl_real)(p - 1));
  return EOM_OK;
}

static eom_status interpolate(eom_integrator *it, tl_real x, tl_real *y) {
  const eom_taylor *v = it->own;
  sum_up(v, x * (it->t_after - it->t_before), y, y + v->sys->n, NULL);
  for (int i = 0; i < it->dim; i++) y[i] += it->before[i];
  return EOM_OK;
}

/* ---- steps that are kept ---- */

int eom_keep_series(const eom_integrator *it, tl_real part, tl_real *kept) {
  const eom_taylor *v = it->own;
  const int n = v->sys->n, dim = it->dim;
  const tl_real h = it->t_after - it->t_before;
  tl_real power = TL_C(1.0), left_out = TL_C(0.0);
  int rows = v->order;
  for (int row = 0; row < rows; row++, power *= h)
    for (int i = 0; i < n; i++) {
      const tl_real *c = v->coef + (size_t)i * (size_t)(v->order + 1);
      kept[row * dim + i] = power * c[row];
      kept[row * dim + n + i] = power * ((tl_real)(row + 1) * c[row + 1]);
    }
  for (; rows > 1; rows--) {
    tl_real most = TL_C(0.0);
    for (int i = 0; i < dim; i++) most = larger(most, size(kept[(rows - 1) * dim + i]) / (TL_C(1.0) + size(kept[i])));
    left_out += most;
    if (!(left_out <= part)) break;
  }
  return rows;
}

/* ---- start ---- */

static const eom_scheme scheme = {.step = step, .interpolate = interpolate, .choose = choose, .attempt = attempt};

/* What an integrator says of it; slope 1 is room for accelerations, slope 2 the one at the end of a step. */
static const eom_method method = {.name = "taylor", .order = MOST_ORDER, .stages = 2, .dense_order = MOST_ORDER};

size_t eom_taylor_size(const eom_system *sys) {
  return eom_integrator_size(&method, 2 * sys->n) + (size_t)sys->n * (EOM_TAYLOR_MOST + 1);
}

eom_status eom_taylor_init(eom_taylor *v, eom_integrator *it, eom_system *sys, tl_real t, const tl_real *y, tl_real h, tl_real *work) {
  assert(v && it && sys && y && work);
  if (!eom_by_motion(sys, EOM_TASK_ASSEMBLE) || !sys->motion->taylor || eom_is_stabilised(sys) || sys->options.hold.on)
    return EOM_BAD_OPTION;
  *v = (eom_taylor){.sys = sys, .coef = work + eom_integrator_size(&method, 2 * sys->n)};
  eom_integrator_init(it, &method, acceleration, sys, 2 * sys->n, t, y, h, work);
  it->scheme = &scheme;
  it->own = v;
  return EOM_OK;
}
