/* Swings the poles up (swing.h), holds them up by a linear-quadratic regulator, both with a model that is linearised anew in every
 * control step, and knows the state by an extended Kalman filter that uses the same derivatives. No heap; all memory is in the struct.
 *
 * Where the model has no value at what the sensors say, they are not believed; where it has none at all, a regulator goes on with its
 * last gain and the sensors, and nothing else pushes. Either way the caller hears of it. */
#ifndef CONTROLLER_H
#define CONTROLLER_H

#include "riccati.h"

#define CONTROL_PERIOD TL_C(1e-3)    /* s */
#define CONTROL_MOST_PUSH TL_C(20.0) /* N */

/* What a sensor resolves: coordinates are measured in whole multiples of it. */
#define SENSOR_CART TL_C(1e-4) /* m */
#define SENSOR_POLE TL_C(1e-3) /* rad */

/* What a control step costs: e' diag(weights) e + CONTROL_WEIGHT_PUSH push^2. */
#define CONTROL_WEIGHT(i) (CONTROL_PERIOD * ((i) == 0 ? TL_C(10.0) : (i) < N ? TL_C(100.0) : TL_C(1.0)))
#define CONTROL_WEIGHT_PUSH (CONTROL_PERIOD * TL_C(0.1))

typedef enum control_mode { CONTROL_REST, CONTROL_SWING, CONTROL_HOLD, CONTROL_MODES } control_mode;

typedef struct controller {
  plant_params params; /* with the push of now */
  control_mode mode;
  int swung;        /* control steps on the way up, of two poles */
  tl_real y[D];     /* the state's estimate */
  tl_real P[D * D]; /* its covariance */
  plant_model model;
  tl_real K[D];
  tl_real A[D * D], B[D]; /* y+ = y + .. over one period */
  riccati work;           /* the filter's too */
} controller;

/* Begins near the state y: D numbers. */
void controller_init(controller *c, const plant_params *params, const tl_real *y);

/* One control step: from N measured coordinates to the push until the next one, c->params.push, which is finite whatever happens.
 * Returns 0, or the status of a model's function (eom/motion.h; EOM_MOTION_PIVOT too for a gain that does not exist). */
int controller_step(controller *c, const tl_real *measured);

/* For swing.h. e: y - from (D numbers each), angles between -pi and pi. Whether angles are nearer to those of `from` than so much. The
 * push of the regulator to a state of equilibrium: 0, or EOM_MOTION_PIVOT where there is no gain. */
void controller_away(tl_real *e, const tl_real *y, const tl_real *from);
int controller_within(const tl_real *y, const tl_real *from, tl_real angle);
int controller_regulate(controller *c, const tl_real *to, tl_real *push);

/* x, but between -most and most, and 0 where x is no number. */
static inline tl_real controller_clamp(tl_real x, tl_real most) { return x > most ? most : x < -most ? -most : x == x ? x : TL_C(0.0); }

#endif
