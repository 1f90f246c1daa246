/* Integration by Taylor series (A. Jorba, M. Zou, Experimental Mathematics 14, 2005): the coefficients of the motion in time, of an
 * order that goes with the tolerance, from what tlgen prints for the need taylor. The method of choice for smooth motion of few
 * coordinates and for errors near rounding; inside a step the state is as exact as at its end. */
#ifndef EOM_TAYLOR_H
#define EOM_TAYLOR_H

#include "eom/integrate.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct eom_taylor {
  eom_system *sys;
  /* private */
  int order;     /* of the coordinates */
  tl_real *coef; /* n x (order + 1): of q from t_before on, or of the step under way */
} eom_taylor;

/* Numbers (tl_real) of workspace. */
size_t eom_taylor_size(const eom_system *sys);

/* Starts *it, with which all functions of eom/integrate.h and eom/events.h go on. y = (q,qd): 2n. h: as for eom_integrator_init. *v,
 * *it and work live as long as each other. Steps of fixed length have the highest order that rounding leaves something to. BAD_OPTION
 * where the model has no motion->taylor at its size, or options.baumgarte, options.hold or options.emitter ask for other equations than
 * that solves.
 *
 * A step of *it fails as those of other methods, and with NO_SERIES as rhs_code near positions where the equations can only be solved
 * with a look at their rank. */
eom_status eom_taylor_init(eom_taylor *v, eom_integrator *it, eom_system *sys, tl_real t, const tl_real *y, tl_real h, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
