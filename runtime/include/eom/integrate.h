/* Fixed-step explicit Runge-Kutta integration of y' = f(t,y) in the caller's memory. */
#ifndef EOM_INTEGRATE_H
#define EOM_INTEGRATE_H

#include "eom/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ydot = f(t,y). Returns 0, or any other number to stop the integration before the step. */
typedef int eom_rhs_fn(void *user, tl_real t, const tl_real *y, tl_real *ydot);

/* A Butcher tableau. Where fsal is 1 the last stage is the derivative at the end of the step and serves the next step. */
typedef struct eom_method {
  const char *name;
  int order, stages, fsal;
  const tl_real *a; /* strict lower triangle row by row: a[i*(i-1)/2 + j], j < i */
  const tl_real *b; /* stages */
  const tl_real *c; /* stages */
} eom_method;

extern const eom_method eom_dp5; /* Dormand and Prince 5, seven stages, the last one shared with the next step */

/* The method of that name, or null. */
const eom_method *eom_method_find(const char *name);

/* Changes the new state of a step, as eom_project_state does. Returns 0, or any other number to refuse the step. */
typedef int eom_correct_fn(void *user, tl_real t, tl_real *y);

typedef struct eom_integrator {
  const eom_method *method;
  eom_rhs_fn *rhs;
  void *user;
  eom_correct_fn *correct; /* with the same user, after each step; null: none. To be set after eom_integrator_init */
  int dim;
  tl_real h;        /* step, s; positive or negative */
  tl_real t0;       /* time of step 0; t = t0 + steps*h without accumulated rounding */
  tl_real t;        /* time now, s */
  tl_real *y;       /* dim: state now */
  long steps;       /* since t0 */
  long evaluations; /* of rhs */
  int rhs_code;     /* what rhs or correct returned at a failure */
  int first_known;  /* 1 where stage 0 already holds f(t,y) */
  tl_real *stage;   /* stages x dim */
  tl_real *trial;   /* dim */
} eom_integrator;

/* Numbers (tl_real) of workspace for dim unknowns. */
size_t eom_integrator_size(const eom_method *method, int dim);

/* Starts at (t, y) with step h. y: dim, copied. work: eom_integrator_size numbers that live as long as *it. */
void eom_integrator_init(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, tl_real t,
                         const tl_real *y, tl_real h, tl_real *work);

/* To be called after the caller has changed y, or anything that f depends on: forgets the stage kept from the last step. */
void eom_integrator_restart(eom_integrator *it);

/* One step of h. At a failure t and y are those before the step. RHS_FAILED (rhs_code has its number), NOT_FINITE. */
eom_status eom_integrator_step(eom_integrator *it);

/* Called after each step; any other number than 0 ends the integration with EOM_STOPPED. */
typedef int eom_observe_fn(void *observer, const eom_integrator *it);

/* Steps until t_end; the last step is shortened where t_end is not a whole number of steps away. observe may be null.
 * BAD_OPTION where h is zero, not finite or leads away from t_end; errors of eom_integrator_step; EOM_STOPPED. */
eom_status eom_integrate(eom_integrator *it, tl_real t_end, eom_observe_fn *observe, void *observer);

#ifdef __cplusplus
}
#endif

#endif
