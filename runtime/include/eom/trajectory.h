/* The motion of a system over time by any method, by its name: the library's own (eom/method.h) and, in a build with SUNDIALS, its
 * CVODE and ARKODE. For hosts: it allocates. A library of its own (taylor::trajectory), so that programs without it need no SUNDIALS.
 */
#ifndef EOM_TRAJECTORY_H
#define EOM_TRAJECTORY_H

#include "eom/events.h"
#include "eom/sensitivity.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A method that this build has. */
typedef struct eom_trajectory_method {
  const char *name;
  const char *text; /* a line about it */
  int order;        /* of one step; 0: it varies */
  int implicit;     /* 1: for stiff motion, best with options.baumgarte or nothing in the place of projection, whose changes a stiff
                       spring in their way answers; takes the exact Jacobian of the system, which must have EOM_NEED_LINEARISE */
  int fixed;        /* 1: takes steps of fixed length */
  int chosen;       /* 1: takes steps that are chosen by tolerances */
  int projects;     /* 1: can bring its steps onto the constraints */
  int columns;      /* 1: can follow sensitivities */
} eom_trajectory_method;

/* Method number i from 0 on, the default one first; null after the last. */
const eom_trajectory_method *eom_trajectory_method_at(int i);

/* Zeros make a choice. */
typedef struct eom_trajectory_options {
  const char *method; /* null: the default */
  eom_step_control
      control; /* of methods that choose their steps; without tolerances steps have the fixed length h; h_min, rtol_each and tested are
                  for the library's own methods alone; SUNDIALS' want atol > 0 where a component may be zero (BAD_OPTION then) */
  tl_real h;   /* s: the length of each step, or the first to be tried; 0: chosen */
  int project; /* 1: after each step, and at the start, the state is brought onto the constraints (eom/project.h) */
  eom_events *events; /* null: none. With SUNDIALS' methods tolerance, parts and apart are SUNDIALS' own; ARKODE interpolates to order 5
                         at most, so that events and outputs inside its long steps are less exact than its steps */
  eom_outputs *outputs;         /* null: none */
  eom_sensitivity *sensitivity; /* of the same system; null: none. Then the state is z = (y, S) of eom/sensitivity.h in the place of y
                                   everywhere, tolerances too, by Runge-Kutta methods and SUNDIALS'. cvode_bdf follows S by CVODES'
                                   staggered corrector, does not project it, has S in the error or, with control.tested = 2n, not, and
                                   its events see no S */
} eom_trajectory_options;

/* Since the start. */
typedef struct eom_trajectory_work {
  long steps, rejected; /* taken; tried and refused */
  long evaluations;     /* of accelerations, those for differences and events included */
  long jacobians;       /* of the linearised system */
} eom_trajectory_work;

typedef struct eom_trajectory eom_trajectory;

/* Starts at (t, y), y = (q,qd): 2n, or z, copied. *trajectory is null unless EOM_OK. The system must live as long. BAD_OPTION where
 * there is no such method, or it cannot do what is asked (fixed or chosen steps, projection, a system without EOM_NEED_LINEARISE for an
 * implicit one, nonholonomic constraints for a variational one, sensitivities for that and for taylor); NO_MEMORY; errors of
 * eom_project. Destroy takes null. */
eom_status eom_trajectory_create(eom_trajectory **trajectory, eom_system *sys, const eom_trajectory_options *options, tl_real t,
                                 const tl_real *y);
void eom_trajectory_destroy(eom_trajectory *trajectory);

/* Called after each step with the state there; any other number than 0 ends with EOM_STOPPED. */
typedef int eom_trajectory_observe_fn(void *observer, const eom_trajectory *trajectory);

/* Goes on until t_end exactly. observe may be null. EOM_STOPPED by an event or the observer; RHS_FAILED, where the report of the system
 * says more; NO_STEP from variational methods; STEP_TOO_SMALL, also where CVODE's nonlinear equations cannot be solved; TOO_MUCH_WORK;
 * NOT_FINITE; BAD_OPTION for a t_end that a fixed step does not lead to. At a failure the state is the last good one. */
eom_status eom_trajectory_to(eom_trajectory *trajectory, tl_real t_end, eom_trajectory_observe_fn *observe, void *observer);

tl_real eom_trajectory_time(const eom_trajectory *trajectory);
const tl_real *eom_trajectory_state(const eom_trajectory *trajectory); /* 2n, or dim of the sensitivity */
eom_trajectory_work eom_trajectory_worked(const eom_trajectory *trajectory);

#ifdef __cplusplus
}
#endif

#endif
