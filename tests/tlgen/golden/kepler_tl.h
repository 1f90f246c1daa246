/* Model "kepler" on truncated Taylor series, printed by tlgen from kepler.c. Do not edit. */
#ifndef KEPLER_TL_H
#define KEPLER_TL_H

#include "eom/description.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model kepler_model;
extern const eom_description kepler_description;

/* Its motion: what the functions compute is said in eom/motion.h. */
extern const eom_motion kepler_motion;
int kepler_simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);
int kepler_linearise(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work);
int kepler_acceleration(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *work);
int kepler_jacobian(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *qdd_y, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
