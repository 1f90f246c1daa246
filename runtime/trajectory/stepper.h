/* What stands behind a trajectory: one of its kinds of method. */
#ifndef EOM_STEPPER_H
#define EOM_STEPPER_H

#include "eom/trajectory.h"

/* The functions of a kind. Its data is its own. */
typedef struct eom_stepper {
  /* Takes over from (t, y) in *trajectory. */
  eom_status (*create)(eom_trajectory *trajectory, const eom_trajectory_method *method);
  eom_status (*to)(eom_trajectory *trajectory, tl_real t_end);
  eom_trajectory_work (*worked)(const eom_trajectory *trajectory);
  void (*destroy)(eom_trajectory *trajectory);
} eom_stepper;

struct eom_trajectory {
  eom_system *sys;
  eom_trajectory_options options;
  const eom_stepper *stepper;
  void *data; /* of the stepper */
  int dim;
  tl_real t;
  tl_real *y; /* dim: the state at t */
  eom_trajectory_observe_fn *observe;
  void *observer;
};

/* The right-hand side of the state, and what brings it onto the constraints, with their user. */
eom_rhs_fn *eom_trajectory_rhs(const eom_trajectory *trajectory);
eom_correct_fn *eom_trajectory_correct(const eom_trajectory *trajectory);
void *eom_trajectory_user(const eom_trajectory *trajectory);

/* Whether steps are chosen by their error. */
int eom_trajectory_is_controlled(const eom_trajectory_options *options);

extern const eom_stepper eom_own_stepper;
#ifdef EOM_HAVE_SUNDIALS
extern const eom_stepper eom_sundials_stepper;
#endif

#endif
