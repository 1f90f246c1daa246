/* The choice of steps by their error: error estimate, PI controller, the first step, and what ends the attempts. */
#include "step.h"

#include <string.h>

/* The next step is h times safety error^-(0.85/q) error_before^(0.2/q), q the power of h in the error: a PI controller after K.
 * Gustafsson, with the constants of DOPRI5 in Hairer, Norsett, Wanner (section IV.2), there for q = 5. */
static const tl_real safety = TL_C(0.9);
static const tl_real proportional = TL_C(0.2);
static const tl_real integral = TL_C(0.85);
static const tl_real most_growth = TL_C(6.0), most_shrinking = TL_C(0.2); /* of one step to the next */
static const tl_real least_error = TL_C(1e-4);                            /* below, the error before says little and is not followed */
static const tl_real failure_factor = TL_C(0.25);                         /* shortening of a step that could not be computed */
static const tl_real stretch = TL_C(1.01);                                /* of a step that would leave next to nothing of the way */
enum { MOST_FAILURES = 25 /* in a row: 4^-25 is 1e-15 of the first attempt */ };

static tl_real larger(tl_real a, tl_real b) { return a > b ? a : b; }
static tl_real size(tl_real x) { return TL_LIBM(fabs)(x); }

/* Components that count in the error. */
static int tested(const eom_integrator *it) {
  const int count = it->control.tested;
  return count > 0 && count < it->dim ? count : it->dim;
}

/* Tolerances of some components from i on: all of them count. components: constant. */
TL_INLINE void tolerances(const eom_step_control *c, int components, size_t i, tl_real *rtol, tl_real *atol) {
  if (c->rtol_each)
    memcpy(rtol, c->rtol_each + i, (size_t)components * sizeof(tl_real));
  else
    for (int b = 0; b < components; b++) rtol[b] = c->rtol;
  if (c->atol_each)
    memcpy(atol, c->atol_each + i, (size_t)components * sizeof(tl_real));
  else
    for (int b = 0; b < components; b++) atol[b] = c->atol;
}

/* One over their scales. */
TL_INLINE void inverse_of(int components, tl_real *inverse, const tl_real *y, const tl_real *y1, const tl_real *rtol,
                          const tl_real *atol) {
  for (int b = 0; b < components; b++) inverse[b] = TL_C(1.0) / larger(atol[b] + rtol[b] * larger(size(y[b]), size(y1[b])), TL_MIN);
}

/* One over the scales of the block of components that begins with i: 0 for those that do not count, and for what fills it up. */
static void inverse_scales(const eom_integrator *it, tl_real *inverse, size_t i, const tl_real *y1) {
  const size_t left = (size_t)tested(it) - i;
  tl_real rtol[EOM_BLOCK] = {TL_C(0.0)}, atol[EOM_BLOCK] = {TL_C(0.0)};
  if (left >= EOM_BLOCK)
    tolerances(&it->control, EOM_BLOCK, i, rtol, atol);
  else
    for (size_t b = 0; b < left; b++) tolerances(&it->control, 1, i + b, rtol + b, atol + b);
  inverse_of(EOM_BLOCK, inverse, it->y + i, y1 + i, rtol, atol);
  for (size_t b = left; b < EOM_BLOCK; b++) inverse[b] = TL_C(0.0);
}

/* Adds (E_i / scale_i)^2 of both rows of estimates for some vectors of components from i on. vectors: constant. */
TL_INLINE void add_squares(const eom_integrator *it, int vectors, size_t i, const tl_real *inverse, eom_lane *squares) {
  const eom_method *m = it->method;
  const int count = m->stages + 1;
  for (int row = 0; row < m->error_rows; row++) {
    const tl_real *e = m->error + row * count;
    eom_lane sum[EOM_CHUNK];
    eom_sum_vectors(it, sum, vectors, i, e, eom_first_weight(e, count), count);
    TL_UNROLL
    for (int c = 0; c < vectors; c++) {
      const eom_lane part = sum[c] * EOM_AT_CONST(inverse + c * EOM_LANE);
      squares[row] += part * part;
    }
  }
}

/* sum_i (E_i / scale_i)^2 of each row of estimates, without h. */
static void sum_squares(const eom_integrator *it, tl_real *total) {
  enum { WHOLE = EOM_CHUNK * EOM_LANE };
  const size_t count = (size_t)tested(it);
  tl_real rtol[WHOLE], atol[WHOLE], inverse[WHOLE + EOM_BLOCK];
  const eom_lane none = {TL_C(0.0)};
  eom_lane squares[2] = {none, none};
  size_t i = 0;
  for (; WHOLE % EOM_BLOCK == 0 && i + WHOLE <= count; i += WHOLE) {
    tolerances(&it->control, WHOLE, i, rtol, atol);
    inverse_of(WHOLE, inverse, it->y + i, it->trial + i, rtol, atol);
    add_squares(it, EOM_CHUNK, i, inverse, squares);
  }
  for (; i < count; i += EOM_BLOCK) {
    inverse_scales(it, inverse, i, it->trial);
    add_squares(it, EOM_BLOCK / EOM_LANE, i, inverse, squares);
  }
  for (int row = 0; row < it->method->error_rows; row++) total[row] = eom_sum_lanes(&squares[row]);
}

/* The error of the trial step of h as in eom_step_control; with two estimates as in DOP853 of Hairer, Norsett, Wanner (section II.10).
 */
static tl_real error_of(const eom_integrator *it, tl_real h) {
  tl_real total[2] = {TL_C(0.0)};
  sum_squares(it, total);
  const tl_real high = total[0], low = total[1];
  if (high == TL_C(0.0)) return TL_C(0.0);
  const tl_real damped = it->method->error_rows == 1 ? TL_C(1.0) : high / (high + TL_C(0.01) * low);
  return size(h) * TL_LIBM(sqrt)(damped * high / (tl_real)tested(it));
}

static int worst_component(const eom_integrator *it) {
  const int count = it->method->stages + 1;
  int worst = 0;
  tl_real most = TL_C(-1.0), sum[EOM_BLOCK], inverse[EOM_BLOCK];
  for (int i = 0; i < tested(it); i++) {
    const int b = i % EOM_BLOCK;
    if (b == 0) {
      eom_sum_slopes(it, sum, (size_t)i, it->method->error, 1, count);
      inverse_scales(it, inverse, (size_t)i, it->trial);
    }
    if (size(sum[b] * inverse[b]) > most) most = size(sum[b] * inverse[b]), worst = i;
  }
  return worst;
}

/* ---- the length of steps ---- */

static tl_real least_step(const eom_integrator *it) {
  return larger(it->control.h_min, larger(TL_C(4.0) * TL_EPSILON * size(it->t), TL_MIN));
}

/* h between the bounds. */
static tl_real bounded(const eom_integrator *it, tl_real h) {
  const tl_real most = it->control.h_max, least = least_step(it);
  if (size(h) < least) return TL_LIBM(copysign)(least, h);
  return most > TL_C(0.0) && size(h) > most ? TL_LIBM(copysign)(most, h) : h;
}

/* After a good step. */
static tl_real growth(eom_integrator *it, int refused) {
  const tl_real q = (tl_real)it->method->error_power;
  const tl_real log_error = TL_LIBM(log2)(larger(it->error, TL_MIN));
  const tl_real factor = safety * TL_LIBM(exp2)((proportional * it->log_error - integral * log_error) / q);
  it->log_error = TL_LIBM(log2)(larger(it->error, least_error));
  const tl_real most = refused ? TL_C(1.0) : most_growth;
  return factor < most_shrinking ? most_shrinking : factor > most ? most : factor;
}

/* After a step whose error is too large. */
static tl_real shrinking(const eom_integrator *it) {
  const tl_real factor = safety * TL_LIBM(pow)(it->error, TL_C(-1.0) / (tl_real)it->method->error_power);
  return larger(factor, most_shrinking);
}

/* sqrt(1/dim sum (v_i / scale_i)^2), without components whose scale is zero until they have moved. */
static tl_real norm(const eom_integrator *it, const tl_real *v) {
  tl_real sum = TL_C(0.0), inverse[EOM_BLOCK];
  for (int i = 0; i < tested(it); i++) {
    if (i % EOM_BLOCK == 0) inverse_scales(it, inverse, (size_t)i, it->y);
    if (inverse[i % EOM_BLOCK] >= TL_C(1.0) / TL_MIN) continue;
    const tl_real e = v[i] * inverse[i % EOM_BLOCK];
    sum += e * e;
  }
  return TL_LIBM(sqrt)(sum / (tl_real)tested(it));
}

/* The first step after Hairer, Norsett, Wanner (section II.4): such that neither |h f| nor |h^2 f'|, from a trial of Euler's method, is
 * large. */
static eom_status first_step(eom_integrator *it, tl_real way) {
  eom_status status = eom_start_slope(it);
  if (status != EOM_OK) return status;
  const tl_real d0 = norm(it, it->y), d1 = norm(it, it->slope), tiny = TL_C(1e-5);
  tl_real h0 = d0 < tiny || d1 < tiny ? TL_C(1e-6) : TL_C(0.01) * d0 / d1;
  h0 = bounded(it, h0 < size(way) ? h0 : size(way));
  const tl_real one = TL_C(1.0);
  it->interpolates = INTERPOLATES_NOT;
  tl_real *k1 = eom_slope(it, 1);
  for (int tries = 0;; tries++) {
    status = eom_combine(it, it->trial, it->y, TL_LIBM(copysign)(h0, way), &one, 1)
                 ? eom_evaluate(it, it->t + TL_LIBM(copysign)(h0, way), it->trial, k1)
                 : EOM_NOT_FINITE;
    if (status == EOM_OK) break;
    it->failed++;
    if (tries == MOST_FAILURES) return status;
    h0 *= failure_factor;
  }
  for (int i = 0; i < it->dim; i++) k1[i] -= it->slope[i];
  const tl_real d2 = norm(it, k1) / h0, d = larger(d1, d2), least = h0 * TL_C(1e-3), most = h0 * TL_C(100.0);
  const tl_real h1 = d > TL_C(1e-15) ? TL_LIBM(pow)(TL_C(0.01) / d, TL_C(1.0) / (tl_real)it->method->error_power) : TL_C(1e-6);
  it->h = TL_LIBM(copysign)(h1 > most ? most : larger(h1, least), way);
  return EOM_OK;
}

/* ---- a step ---- */

static eom_status try_with_error(eom_integrator *it, tl_real h, tl_real t1, int end_counts) {
  eom_status status = eom_try_step(it, h, t1);
  if (status == EOM_OK && end_counts) status = eom_evaluate(it, t1, it->trial, eom_slope(it, it->method->stages));
  if (status == EOM_OK) it->error = error_of(it, h);
  return status;
}

/* Tries a step of h to t1, and takes it where its error allows; *good says so. RHS_FAILED, NOT_FINITE. */
static eom_status attempt(eom_integrator *it, tl_real h, tl_real t1, int *good) {
  const int end_counts = it->scheme || it->method->error[it->method->stages] != TL_C(0.0);
  *good = 0;
  eom_status status = it->scheme ? it->scheme->attempt(it, h, t1) : try_with_error(it, h, t1, end_counts);
  if (status != EOM_OK) return status;
  if (it->error != it->error) return EOM_NOT_FINITE;
  if (it->error > TL_C(1.0)) return EOM_OK;
  *good = 1;
  return eom_take_step(it, t1, end_counts);
}

/* By the scheme, in the direction of the way. */
static eom_status choose(eom_integrator *it, tl_real way) {
  const eom_status status = it->scheme->choose(it);
  if (status == EOM_OK) it->h = TL_LIBM(copysign)(it->h, way);
  return status;
}

/* One step, not beyond t_end, and the length of the next one. */
static eom_status controlled_step(eom_integrator *it, tl_real t_end) {
  const tl_real way = t_end - it->t;
  eom_status status = it->scheme ? choose(it, way) : it->h == TL_C(0.0) ? first_step(it, way) : eom_start_slope(it);
  if (status != EOM_OK) return status;
  int good = 0, failures = 0, refused = 0;
  for (;;) {
    const tl_real h = refused ? it->h : bounded(it, it->h);
    const int last = size(h) * stretch >= size(way);
    const tl_real t1 = last ? t_end : it->t + h;
    if (refused && size(h) < least_step(it)) break;
    status = attempt(it, t1 - it->t, t1, &good);
    if (status == EOM_OK && good) {
      it->worst = -1;
      const tl_real next = (t1 - it->t_before) * (it->scheme ? TL_C(1.0) : growth(it, refused));
      if (!last || refused || size(next) > size(it->h)) it->h = next;
      return EOM_OK;
    }
    refused = 1;
    if (status != EOM_OK) {
      it->failed++;
      if (failures++ == MOST_FAILURES) return status;
      it->h = (t1 - it->t) * failure_factor;
    } else {
      it->rejected++;
      failures = 0;
      it->h = (t1 - it->t) * shrinking(it);
    }
  }
  if (status != EOM_OK) return status;
  if (!it->scheme) it->worst = worst_component(it);
  return EOM_STEP_TOO_SMALL;
}

/* ---- options ---- */

static int is_bound(tl_real x) { return x >= TL_C(0.0) && x <= TL_MAX; }

static int are_bounds(const tl_real *x, int count) {
  for (int i = 0; x && i < count; i++)
    if (!is_bound(x[i])) return 0;
  return 1;
}

eom_status eom_integrator_control(eom_integrator *it, const eom_step_control *control) {
  const eom_step_control *c = control;
  if (it->scheme && !it->scheme->choose) return EOM_BAD_OPTION;
  if (!is_bound(c->rtol) || !is_bound(c->atol) || !is_bound(c->h_min) || !is_bound(c->h_max) || c->most_steps < 0 || c->tested < 0 ||
      c->tested > it->dim || !are_bounds(c->rtol_each, it->dim) || !are_bounds(c->atol_each, it->dim))
    return EOM_BAD_OPTION;
  if (!c->rtol_each && !c->atol_each && c->rtol == TL_C(0.0) && c->atol == TL_C(0.0)) return EOM_BAD_OPTION;
  it->control = *control;
  it->controlled = controlled_step;
  it->log_error = TL_C(0.0);
  return EOM_OK;
}
