/* Derivatives of the motion in several directions at once, by the cheapest way that a system has: what sensitivities and Lyapunov
 * exponents integrate. */
#ifndef EOM_TANGENT_FLOW_H
#define EOM_TANGENT_FLOW_H

#include "eom/system.h"

/* Columns of derivatives. The last np of them also take the derivative with respect to a parameter: where x depends on p, dx/dp obeys
 * the equations of any other direction and the derivative by p at fixed x. */
typedef struct eom_columns {
  int k;                /* at least 1 */
  int np;               /* 0..k; more than 0 only where the system has EOM_NEED_PARAMETERS */
  const int *parameter; /* np numbers of sys->motion->parameter; null: 0..np-1 */
  tl_real *work;        /* eom_columns_size(sys, k, np) numbers */
} eom_columns;

/* Numbers (tl_real) of workspace. */
size_t eom_columns_size(const eom_system *sys, int k, int np);

/* Accelerations at (q, qd, t) as eom_acceleration; with them their derivatives: dqdd = d qdd/d(q,qd) w, and d qdd/dp in the last np
 * columns. dqdd: n x k, w: 2n x k. The system must have EOM_NEED_TANGENT or EOM_NEED_LINEARISE. Errors of eom_linearise. */
eom_status eom_tangents(eom_system *sys, const eom_columns *columns, tl_real *dqdd, const tl_real *w, const tl_real *q,
                        const tl_real *qd, tl_real t);

/* zdot = f(t,z) with z = (q, qd, W), W: 2n x k: the motion and W' = [0 1; qdd_y] W + [0; qdd_p]. Errors of eom_tangents. */
eom_status eom_tangent_flow(eom_system *sys, const eom_columns *columns, tl_real t, const tl_real *z, tl_real *zdot);

#endif
