/* Swings the poles up by their energy, holds them up by a linear-quadratic regulator whose model is linearised anew in every control
 * step, and knows the state by an extended Kalman filter that uses the same derivatives. No heap; all memory is in the struct. */
#ifndef CONTROLLER_H
#define CONTROLLER_H

#include "riccati.h"

#define CONTROL_PERIOD TL_C(1e-3)    /* s */
#define CONTROL_MOST_PUSH TL_C(20.0) /* N */

/* What a sensor resolves: coordinates are measured in whole multiples of it. */
#define SENSOR_CART TL_C(1e-4) /* m */
#define SENSOR_POLE TL_C(1e-3) /* rad */

typedef enum control_mode { CONTROL_SWING, CONTROL_HOLD } control_mode;

typedef struct controller {
  plant_params params; /* with the push of now */
  control_mode mode;
  tl_real y[D];     /* the state's estimate */
  tl_real P[D * D]; /* its covariance */
  plant_model model;
  tl_real K[D];
  tl_real A[D * D], B[D]; /* y+ = y + .. over one period */
  riccati work;           /* the filter's too */
} controller;

/* Begins near the state y: D numbers. */
void controller_init(controller *c, const plant_params *params, const tl_real *y);

/* One control step: from N measured coordinates to the push until the next one, c->params.push. Returns 0, or the status of a model's
 * function (eom/motion.h; EOM_MOTION_PIVOT too for a gain that does not exist), with no push. */
int controller_step(controller *c, const tl_real *measured);

#endif
