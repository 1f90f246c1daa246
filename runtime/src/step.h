/* Private: one trial step of a Runge-Kutta method, from (t, y) to a state that is not taken yet. */
#ifndef EOM_STEP_H
#define EOM_STEP_H

#include "eom/integrate.h"
#include "eom/motion.h"
#include "taylor/kernel.h"

#include <string.h>

/* What slope 0, the derivative at the start of the next step, is known to be. */
enum { SLOPE0_UNKNOWN, SLOPE0_KNOWN, SLOPE0_AT_END /* in the place of the slope at the end of the last step */ };

/* What is there of the last step to interpolate: its ends and slopes, and what eom_interpolate adds to them. A new trial spoils it. */
enum { INTERPOLATES_NOT, INTERPOLATES, INTERPOLATES_READY };

/* Slope k_i: stride numbers, of which those from dim on are zero. */
static inline tl_real *eom_slope(const eom_integrator *it, int i) { return it->slope + (size_t)i * it->stride; }

/* Components that are computed side by side, in vector registers where there are: vectors are filled up with zeros to whole blocks. */
enum { EOM_BLOCK = 4 };

/* The first slope after k_0 with a weight: most rows of a table go on with zeros after their first weight, and none after that. */
static inline int eom_first_weight(const tl_real *w, int count) {
  int first = 1;
  while (first < count && w[first] == TL_C(0.0)) first++;
  return first;
}

/* As many components as a vector of the processor or two hold, at any place in memory. */
#if TL_VECTORS
typedef tl_v4 eom_lane;
#else
typedef tl_real eom_lane;
#endif
/* Vectors whose sums are formed together, at most; where they are single numbers, a block. */
enum { EOM_LANE = sizeof(eom_lane) / sizeof(tl_real), EOM_CHUNK = EOM_LANE > 1 ? 8 : EOM_BLOCK };
#define EOM_AT(address) (*(eom_lane *)(address))
#define EOM_AT_CONST(address) (*(const eom_lane *)(address))

/* sum[c] = sum_(j<count) w_j k_j for the vectors of components from i on, with j = 0 and from first on. vectors: constant. */
TL_INLINE void eom_sum_vectors(const eom_integrator *it, eom_lane *sum, int vectors, size_t i, const tl_real *w, int first, int count) {
  const size_t stride = it->stride;
  const tl_real *k = it->slope + i;
  TL_UNROLL
  for (int c = 0; c < vectors; c++) sum[c] = w[0] * EOM_AT_CONST(k + c * EOM_LANE);
  k += (size_t)first * stride;
  for (int j = first; j < count; j++, k += stride) {
    const tl_real weight = w[j];
    TL_UNROLL
    for (int c = 0; c < vectors; c++) sum[c] += weight * EOM_AT_CONST(k + c * EOM_LANE);
  }
}

static inline tl_real eom_sum_lanes(const eom_lane *x) {
  tl_real part[EOM_LANE], sum = TL_C(0.0);
  memcpy(part, x, sizeof part);
  for (int b = 0; b < EOM_LANE; b++) sum += part[b];
  return sum;
}

/* The same for the block of components that begins with i. */
static inline void eom_sum_slopes(const eom_integrator *it, tl_real *restrict sum, size_t i, const tl_real *w, int first, int count) {
  eom_lane of[EOM_BLOCK / EOM_LANE];
  eom_sum_vectors(it, of, EOM_BLOCK / EOM_LANE, i, w, first, count);
  for (int c = 0; c < EOM_BLOCK / EOM_LANE; c++) EOM_AT(sum + c * EOM_LANE) = of[c];
}

/* out = from + h sum_(j<count) w_j k_j; stride numbers each, out may be from. Returns 1 where all are finite. */
int eom_combine(const eom_integrator *it, tl_real *out, const tl_real *from, tl_real h, const tl_real *w, int count);

/* ydot = f(t,y), counted. RHS_FAILED. */
eom_status eom_evaluate(eom_integrator *it, tl_real t, const tl_real *y, tl_real *ydot);

/* Slopes 0 to stages-1 of a step of h to t1, and trial = y1. RHS_FAILED, NOT_FINITE. */
eom_status eom_try_step(eom_integrator *it, tl_real h, tl_real t1);

/* Slope 0. RHS_FAILED. */
eom_status eom_start_slope(eom_integrator *it);

/* Takes the trial step: correct, the slope at its end, then t and y. end_known: 1 where that slope is there already. RHS_FAILED,
 * NOT_FINITE: then nothing is taken. */
eom_status eom_take_step(eom_integrator *it, tl_real t1, int end_known);

/* y is no longer what the steps so far have summed up. */
void eom_drop_carry(eom_integrator *it);

/* As eom_integrator_restart, where the first same numbers of y are still those of the last step. */
void eom_restart_behind(eom_integrator *it, int same);

/* y + increment, and what rounding it loses (D. Knuth's TwoSum). */
static inline tl_real eom_sum_up(tl_real y, tl_real increment, tl_real *lost) {
  const tl_real sum = y + increment, part = sum - y;
  *lost = (y - (sum - part)) + (increment - part);
  return sum;
}

/* trial = y + (increment + carry), and in it->kept what rounding that sum loses: compensated summation of the state, as Hairer, Lubich
 * and Wanner advise for long runs (Geometric Numerical Integration, section VIII.5). increment may be trial. */
void eom_add_increment(eom_integrator *it, const tl_real *increment);

/* What component i of the state, about y, may be wrong by. */
static inline tl_real eom_scale(const eom_integrator *it, int i, tl_real y) {
  const eom_step_control *c = &it->control;
  const tl_real scale = (c->atol_each ? c->atol_each[i] : c->atol) + (c->rtol_each ? c->rtol_each[i] : c->rtol) * TL_LIBM(fabs)(y);
  return scale > TL_MIN ? scale : TL_MIN;
}

/* Steps that are not those of an explicit Runge-Kutta method; all that is around them stays the same. */
typedef struct eom_scheme {
  eom_status (*step)(eom_integrator *it, tl_real h, tl_real t1);        /* tries and takes */
  eom_status (*interpolate)(eom_integrator *it, tl_real x, tl_real *y); /* the state at t_before + x h in the last step, 0 <= x <= 1 */
  eom_status (*choose)(eom_integrator *it);                             /* it->h for the next step; null: steps are fixed */
  eom_status (*attempt)(eom_integrator *it, tl_real h, tl_real t1);     /* trial, the slope there, it->error and it->worst; likewise */
} eom_scheme;

/* Tries and takes a step of h to t1, whatever its error. RHS_FAILED, NOT_FINITE. */
eom_status eom_fixed_step(eom_integrator *it, tl_real h, tl_real t1);

/* All count numbers are finite. */
int eom_all_finite(const tl_real *x, int count);

/* As eom_integrator_at, in all of the last step, also where an event has cut it short since. */
eom_status eom_interpolate(eom_integrator *it, tl_real t, tl_real *y);

/* The last step in a form that outlives it: that many rows of dim numbers, for eom_kept_at. RHS_FAILED, NOT_FINITE. */
int eom_kept_rows(const eom_method *method);
eom_status eom_keep_step(eom_integrator *it, tl_real *kept);

/* The same without an evaluation, where y = (q,qd) and y' = (qd,qdd): q by the quintic that has q, qd and qdd of both ends of the step,
 * qd by its derivative, which is wrong by O(h^5). */
enum { EOM_MOTION_ROWS = 6 };
void eom_keep_motion(const eom_integrator *it, tl_real *kept);

/* To be called before the next step, and before anything interpolates in the last one: the largest h |derivative of qd - qdd| in parts
 * of 1 + |qd|, at the stage nearest the middle of the step; five times (dop853) what qd is then wrong by elsewhere in the step. */
tl_real eom_motion_defect(const eom_integrator *it, const tl_real *kept);

/* The state in a kept step, as eom_interpolate; x: the part of the step that has passed, 0..1. y: dim. */
void eom_kept_at(int rows, int dim, const tl_real *kept, tl_real x, tl_real *y);

/* The last step of Taylor series (eom_taylor_init), for eom_series_at: row j holds what x^j has as its factors. Only as many rows, as
 * it returns, that those left out add at most that part of 1 + |y_i| to y. */
enum { EOM_SERIES_ROWS = EOM_TAYLOR_MOST };
int eom_keep_series(const eom_integrator *it, tl_real part, tl_real *kept);

void eom_series_at(int rows, int dim, const tl_real *kept, tl_real x, tl_real *y);

/* Handles the events of the step that was taken; it->t is then the end of the step, or the time of the event that cut it short. STOPPED
 * where one stops; errors of eom_integrator_at and of the user's functions (RHS_FAILED, NOT_FINITE). */
eom_status eom_watch_step(eom_integrator *it);

/* Writes what it->outputs asks for in the last step, not beyond a time in it. Errors of eom_integrator_at. */
eom_status eom_write_outputs(eom_integrator *it, tl_real until);

#endif
