/* Private: one trial step of a Runge-Kutta method, from (t, y) to a state that is not taken yet. */
#ifndef EOM_STEP_H
#define EOM_STEP_H

#include "eom/integrate.h"

/* What slope 0, the derivative at the start of the next step, is known to be. */
enum { SLOPE0_UNKNOWN, SLOPE0_KNOWN, SLOPE0_AT_END /* in the place of the slope at the end of the last step */ };

/* Slope k_i: stride numbers, of which those from dim on are zero. */
static inline tl_real *eom_slope(const eom_integrator *it, int i) { return it->slope + (size_t)i * it->stride; }

/* out = from + h sum_(j<count) w_j k_j; stride numbers each, out may be from. Returns 1 where all are finite. */
int eom_combine(const eom_integrator *it, tl_real *out, const tl_real *from, tl_real h, const tl_real *w, int count);

/* The slope i at its time and trial point. RHS_FAILED. */
eom_status eom_evaluate_slope(eom_integrator *it, int i, tl_real t);

/* Slopes 0 to stages-1 of a step of h to t1, and trial = y1. RHS_FAILED, NOT_FINITE. */
eom_status eom_try_step(eom_integrator *it, tl_real h, tl_real t1);

/* Slope 0. RHS_FAILED. */
eom_status eom_start_slope(eom_integrator *it);

/* Takes the trial step: correct, the slope at its end, then t and y. end_known: 1 where that slope is there already. RHS_FAILED,
 * NOT_FINITE: then nothing is taken. */
eom_status eom_take_step(eom_integrator *it, tl_real t1, int end_known);

/* One step whose length is chosen, not beyond t_end, and the length of the next one. */
eom_status eom_controlled_step(eom_integrator *it, tl_real t_end);

#endif
