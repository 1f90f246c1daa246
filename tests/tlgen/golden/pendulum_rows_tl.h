/* Model "pendulum_rows" on truncated Taylor series, printed by tlgen from pendulum.c. Do not edit. */
#ifndef PENDULUM_ROWS_TL_H
#define PENDULUM_ROWS_TL_H

#include "eom/description.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model pendulum_rows_model;
extern const eom_description pendulum_rows_description;

/* Its motion with n = 6: what the functions compute is said in eom/motion.h. */
extern const eom_motion pendulum_rows_motion;
int pendulum_rows_simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);
int pendulum_rows_acceleration(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
