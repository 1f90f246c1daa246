/* The closed loop: the machine, its sensors and the controller. A control step is loop_sense, controller_step(&l->control, l->measured)
 * and loop_move. */
#ifndef LOOP_H
#define LOOP_H

#include "controller.h"

#include <eom/integrate.h>
#include <stdint.h>

typedef struct loop {
  plant_params params; /* the machine's own, with the push of now: the controller has another copy */
  eom_integrator integrator;
  tl_real work[EOM_INTEGRATOR_SIZE(4, 0, D)];
  controller control;
  uint32_t random;
  tl_real measured[N];
} loop;

/* The machine at the state start (D numbers), the controller near it; the sensors' noise begins with seed, which is not 0. */
void loop_init(loop *l, const tl_real *start, uint32_t seed);

/* The machine's state: D numbers. */
const tl_real *loop_state(const loop *l);

/* l->measured: the coordinates and noise of up to one count of a sensor, rounded to a whole one. */
void loop_sense(loop *l);

/* The machine for one control period with the controller's push. Returns 0, or the status of the model's functions. */
int loop_move(loop *l);

#endif
