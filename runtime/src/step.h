/* Private: one trial step of a Runge-Kutta method, from (t, y) to a state that is not taken yet. */
#ifndef EOM_STEP_H
#define EOM_STEP_H

#include "eom/integrate.h"

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

/* sum = sum_(j<count) w_j k_j for the block of components that begins with i, with j = 0 and from first on. */
static inline void eom_sum_slopes(const eom_integrator *it, tl_real *restrict sum, size_t i, const tl_real *w, int first, int count) {
  const size_t stride = it->stride;
  const tl_real *k = it->slope + i;
  tl_real of[EOM_BLOCK];
  for (int b = 0; b < EOM_BLOCK; b++) of[b] = w[0] * k[b];
  k += (size_t)first * stride;
  for (int j = first; j < count; j++, k += stride)
    for (int b = 0; b < EOM_BLOCK; b++) of[b] += w[j] * k[b];
  for (int b = 0; b < EOM_BLOCK; b++) sum[b] = of[b];
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

/* One step whose length is chosen, not beyond t_end, and the length of the next one. */
eom_status eom_controlled_step(eom_integrator *it, tl_real t_end);

/* All count numbers are finite. */
int eom_all_finite(const tl_real *x, int count);

/* As eom_integrator_at, in all of the last step, also where an event has cut it short since. */
eom_status eom_interpolate(eom_integrator *it, tl_real t, tl_real *y);

/* Handles the events of the step that was taken; it->t is then the end of the step, or the time of the event that cut it short. STOPPED
 * where one stops; errors of eom_integrator_at and of the user's functions (RHS_FAILED, NOT_FINITE). */
eom_status eom_watch_step(eom_integrator *it);

/* The next step begins at another state than the last one ended with. */
void eom_events_forget(struct eom_events *events);

/* Writes what it->outputs asks for in the last step, not beyond a time in it. Errors of eom_integrator_at. */
eom_status eom_write_outputs(eom_integrator *it, tl_real until);

#endif
