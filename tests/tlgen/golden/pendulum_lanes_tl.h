/* Model "pendulum_lanes" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#ifndef PENDULUM_LANES_TL_H
#define PENDULUM_LANES_TL_H

#include "eom/description.h"
#include "taylor/lanes.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model pendulum_lanes_model;
extern const eom_description pendulum_lanes_description;

/* Its motion with n = 2: what the functions compute is said in eom/motion.h. */
extern const eom_motion pendulum_lanes_motion;
int pendulum_lanes_simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);
int pendulum_lanes_linearise(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work);
int pendulum_lanes_acceleration(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *work);
int pendulum_lanes_acceleration_lanes(const void *params, const tl_lanes *q, const tl_lanes *qd, const tl_lanes *t, tl_lanes *solved, tl_lanes *work);
int pendulum_lanes_jacobian(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *qdd_y, tl_real *work);
int pendulum_lanes_jacobian_lanes(const void *params, const tl_lanes *q, const tl_lanes *qd, const tl_lanes *t, tl_lanes *solved, tl_lanes *qdd_y, tl_lanes *work);

#ifdef __cplusplus
}
#endif

#endif
