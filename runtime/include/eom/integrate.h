/* Explicit Runge-Kutta integration of y' = f(t,y) in the caller's memory, with fixed steps or steps chosen by their error. */
#ifndef EOM_INTEGRATE_H
#define EOM_INTEGRATE_H

#include "eom/method.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ydot = f(t,y). Returns 0, or any other number where there is no f: a step of fixed length fails, one whose length is chosen is tried
 * again with a shorter one. */
typedef int eom_rhs_fn(void *user, tl_real t, const tl_real *y, tl_real *ydot);

/* Changes the new state of a step, as eom_project_state does. Returns 0, or any other number to refuse the step. */
typedef int eom_correct_fn(void *user, tl_real t, tl_real *y);

/* What a step may be wrong by. With E the error estimate of a step from y to y1, a step counts as good where
 *
 *     error = sqrt(1/dim sum_i (E_i / scale_i)^2) <= 1,    scale_i = atol_i + rtol_i max(|y_i|, |y1_i|).
 *
 * atol is in the unit of its component: coordinates and velocities of one size need no more than the scalar; where they differ, as in
 * motion that is much faster or slower than one unit of length in one unit of time, atol_each says so. Zeros leave a choice to the
 * integrator. */
typedef struct eom_step_control {
  tl_real rtol, atol;                   /* >= 0, one of them above */
  const tl_real *rtol_each, *atol_each; /* dim each, in the place of rtol, of atol; to live as long as the integrator; null: none */
  int tested; /* the first so many components make the error, and dim in it; the others go along with the steps that these need; 0: all
               */
  tl_real h_min, h_max; /* s, bounds of |h|; 0: as far as t can tell two times apart; none */
  long most_steps;      /* that one eom_integrate may try; 0: no bound */
} eom_step_control;

typedef struct eom_integrator {
  const eom_method *method;
  eom_rhs_fn *rhs;
  void *user;
  eom_correct_fn *correct;     /* with the same user, after each good step; null: none. To be set after eom_integrator_init */
  struct eom_events *events;   /* eom/events.h; null: none; likewise */
  struct eom_outputs *outputs; /* likewise */
  int dim;

  tl_real h;               /* step, s; positive or negative; where steps are chosen the next one to be tried, 0 before the first */
  tl_real t0;              /* fixed steps: time of step 0; t = t0 + steps*h without accumulated rounding */
  tl_real t;               /* time now, s */
  tl_real *y;              /* dim: state now */
  tl_real t_before;        /* where the last step began, s */
  const tl_real *y_before; /* dim: its state */

  eom_step_control control; /* read only; set by eom_integrator_control */
  /* A step whose length is chosen, not beyond t_end; null: steps are fixed. Likewise. */
  eom_status (*controlled)(struct eom_integrator *it, tl_real t_end);
  tl_real error; /* of the last step tried, as in eom_step_control */
  int worst;     /* the component with the largest E_i / scale_i at a STEP_TOO_SMALL, -1 elsewhere */

  long steps;       /* taken, since t0 */
  long rejected;    /* tried and refused for their error */
  long failed;      /* tried and refused because rhs or correct failed or a number was not finite; only where steps are chosen */
  long evaluations; /* of rhs */
  int rhs_code;     /* what rhs or correct returned at a failure */

  /* private */
  unsigned char slope0, interpolates, watched;
  tl_real t_after, log_error;
  size_t stride;
  tl_real *slope, *trial, *before, *carry, *kept;
  const struct eom_scheme *scheme; /* steps of another kind than the method's table; null: none */
  void *own;                       /* of that */
} eom_integrator;

/* Numbers (tl_real) of workspace for dim unknowns: also as a constant, for a method with such numbers of stages and dense_stages. */
#define EOM_INTEGRATOR_SIZE(stages, dense_stages, dim) (((stages) + 1 + (dense_stages) + 5) * (((dim) + 3) / 4 * 4))
size_t eom_integrator_size(const eom_method *method, int dim);

/* Starts at (t, y) with steps of h. y: dim, copied. work: eom_integrator_size numbers that live as long as *it. */
void eom_integrator_init(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, tl_real t,
                         const tl_real *y, tl_real h, tl_real *work);

/* From now on steps are chosen by their error, beginning with h if it is not zero. Its sign does not matter to eom_integrate.
 * BAD_OPTION where a tolerance or bound is negative or not a number, both tolerances are zero, or tested is not 0..dim, and for steps
 * that can only be fixed. */
eom_status eom_integrator_control(eom_integrator *it, const eom_step_control *control);

/* To be called after the caller has changed y, or anything that f depends on: forgets what is kept from the last step. */
void eom_integrator_restart(eom_integrator *it);

/* One step: of h, or the first good one of a length that its error allows, forwards where h is 0. At a failure t and y are those before
 * it. RHS_FAILED (rhs_code has its number; steps that are chosen have been shortened many times by then), NOT_FINITE (likewise),
 * STEP_TOO_SMALL. */
eom_status eom_integrator_step(eom_integrator *it);

/* The state at time t of the last step, from t_before to it->t, wrong by O(h^(r+1)) for a method of dense_order r: y, dim numbers. The
 * first time in a step it evaluates f dense_stages times. To be called before the next step begins. NOT_IN_STEP elsewhere; RHS_FAILED,
 * NOT_FINITE. */
eom_status eom_integrator_at(const eom_integrator *it, tl_real t, tl_real *y);

/* Called after each step; any other number than 0 ends the integration with EOM_STOPPED. */
typedef int eom_observe_fn(void *observer, const eom_integrator *it);

/* Steps until t_end; the last step is shortened to end there. observe may be null. Events and outputs that are attached are those of
 * eom/events.h. BAD_OPTION where a fixed h is zero, not finite, leads away from t_end or is too short to change t; TOO_MUCH_WORK after
 * most_steps; errors of eom_integrator_step, and of eom_integrator_at where there are events or outputs; EOM_STOPPED. */
eom_status eom_integrate(eom_integrator *it, tl_real t_end, eom_observe_fn *observe, void *observer);

#ifdef __cplusplus
}
#endif

#endif
