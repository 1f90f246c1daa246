/* Model "bead" on truncated Taylor series, printed by tlgen from bead.c. Do not edit. */
#ifndef BEAD_TL_H
#define BEAD_TL_H

#include "eom/description.h"

#ifndef TLGEN_STRUCT_bead
#define TLGEN_STRUCT_bead
struct bead {
  tl_real mass;
  tl_real gravity;
  tl_real drag;
  tl_real spin;
};
#endif

#ifdef __cplusplus
extern "C" {
#endif

extern const eom_model bead_model;
extern const eom_description bead_description;

/* Its motion: what the functions compute is said in eom/motion.h. */
extern const eom_motion bead_motion;
int bead_energy(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *momentum, tl_real *momentum_rate, tl_real *lagrangian, tl_real *energy, tl_real *work);
int bead_simulate(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);
int bead_linearise(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work);
int bead_parameters(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, const tl_real *lambda, tl_real *r_p, tl_real *g_p, tl_real *work);
int bead_constrained(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *solved, tl_real *lambda, tl_real *Qc, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
