/* The motion alone, without tangents, in fixed steps: for the fate of a trajectory. */
#ifndef PENDULUM_MOTION_H
#define PENDULUM_MOTION_H

#include "run.h"

typedef struct motion {
  eom_status status;         /* EOM_OK where t_end was reached, EOM_STOPPED where the user or the bound ended it */
  double t;                  /* reached, s */
  double worst_energy_error; /* J */
} motion;

/* Integrates the pendulum of a request with the given step until t_end, the energy error exceeds bound, or the user interrupts. */
motion motion_do(const run_request *ask, double step, double t_end, double bound);

#endif
