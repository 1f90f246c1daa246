/* Forward sensitivities: the derivatives of a motion with respect to where it begins and to parameters, integrated beside it.
 *
 * With y = (q,qd), y' = f(t,y,p) and chosen directions c of the initial state, the columns of S = [dy/dc, dy/dp] obey
 *
 *     S' = f_y S + [0, f_p],    S(t0) = [the directions, dy0/dp],
 *
 * whose right-hand side is exact (eom/tangent.h). The motion and its columns are the unknowns of any eom_integrator:
 *
 *     z = (y, S): 2n (1+k) numbers, S: 2n x k row-major, the directions' columns first.
 *
 * Tolerances hold for each by eom_step_control: atol_each for each number of z; with tested = 2n steps are those that y needs, as if
 * there were no columns. Motion under constraints takes directions along which these stay satisfied: eom_sensitivity_project. */
#ifndef EOM_SENSITIVITY_H
#define EOM_SENSITIVITY_H

#include "eom/integrate.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct eom_sensitivity {
  eom_system *sys;
  int directions;       /* of the initial state */
  int parameters;       /* by which y is differentiated, */
  const int *parameter; /* and which: numbers of sys->motion->parameter; null: the first ones */
  int k;                /* directions + parameters, at least 1 */
  int dim;              /* 2n (1+k) */
  tl_real change;       /* the largest change of a number of S by the last projection, */
  int column;           /* and in which column; -1 where there was none */
  tl_real *work;        /* private */
} eom_sensitivity;

/* Numbers (tl_real) of workspace. */
size_t eom_sensitivity_size(const eom_system *sys, int directions, int parameters);

/* Fills *s. work: eom_sensitivity_size numbers, which like parameter live as long as *s. BAD_OPTION where the system has neither
 * EOM_NEED_TANGENT nor EOM_NEED_LINEARISE, for parameters not EOM_NEED_PARAMETERS, a parameter has no such number, or k is 0. */
eom_status eom_sensitivity_init(eom_sensitivity *s, eom_system *sys, int directions, int parameters, const int *parameter,
                                tl_real *work);

/* z = (y, S) with the first directions of the unit vectors of y, and columns of parameters that y0 does not depend on. z: dim, y: 2n.
 */
void eom_sensitivity_start(const eom_sensitivity *s, tl_real *z, const tl_real *y);

/* zdot = f(t,z), an eom_rhs_fn; user is the eom_sensitivity. Returns an eom_status. */
int eom_sensitivity_rhs(void *user, tl_real t, const tl_real *z, tl_real *zdot);

/* Brings the columns of z onto what the constraints at its y allow, by the least change in the mass metric, which s->change and
 * s->column report: A dq = 0 for holonomic rows, and d(phi_dot, psi)/dq dq + A dqd = 0. y itself is to be on the constraints. Columns
 * of parameters that a constraint uses obey other equations and are left alone. z: dim. Nothing changes without constraints. Errors of
 * eom_assemble; NO_INERTIA. */
eom_status eom_sensitivity_project(eom_sensitivity *s, tl_real t, tl_real *z);

/* eom_project_state for y, then eom_sensitivity_project: an eom_correct_fn for steps; user is the eom_sensitivity. */
int eom_sensitivity_correct(void *user, tl_real t, tl_real *z);

/* An event is at the time t where g(t, y(t)) = 0; with g_y and g_t the derivatives of g there,
 *
 *     dt = -g_y S / (g_t + g_y f)    and, where dy is not null,    dy = S + f dt,
 *
 * are those of the event's time and of the state at it. dt: k, dy: 2n x k, g_y: 2n, z: dim at the event. NOT_FINITE where the motion
 * does not pass the event, g_t + g_y f = 0; errors of eom_acceleration. */
eom_status eom_sensitivity_event(const eom_sensitivity *s, tl_real *dt, tl_real *dy, const tl_real *g_y, tl_real g_t, tl_real t,
                                 const tl_real *z);

#ifdef __cplusplus
}
#endif

#endif
