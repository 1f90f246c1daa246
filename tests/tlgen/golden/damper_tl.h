/* Model "damper" on truncated Taylor series, printed by tlgen from damper.c. Do not edit. */
#ifndef DAMPER_TL_H
#define DAMPER_TL_H

#include "eom/description.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model damper_model;
extern const eom_description damper_description;

/* Its motion: what the functions compute is said in eom/motion.h. */
extern const eom_motion damper_motion;
int damper_simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);
int damper_linearise(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work);
int damper_acceleration(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *work);
int damper_jacobian(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *qdd_y, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
