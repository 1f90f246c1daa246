/* Variational integration (J. E. Marsden, M. West, Acta Numerica 10, 2001; S. Ober-Bloebaum, N. Saake, Adv. Comput. Math. 41, 2015):
 * steps that come from a discrete Lagrangian of the same model and so are symplectic. Without forces and explicit time the energy error
 * stays bounded for very long times, momenta of symmetries are kept to rounding; a step back undoes a step.
 *
 * With Lobatto's nodes c_0 = 0 < .. < c_s = 1 and weights b_j, Q(t) the polynomial of degree s through Q_j at t0 + c_j h, V_j its
 * derivatives there, D_ji h^-1 the weights of Q_i in V_j,
 *
 *     L_d(Q_0, .., Q_s) = h sum_j b_j L(Q_j, V_j),    p_j = dL/dqd,    f_j = dL/dq + Gamma - dD/dqd + A' lambda_j,
 *
 * and the discrete Lagrange-d'Alembert principle with phi(Q_j) = 0 gives a step from (q0,p0) to (q1,p1), q0 = Q_0, q1 = Q_s:
 *
 *     h b_i f_i + sum_j b_j D_ji p_j = -p0, 0, .., 0, p1    for i = 0, 1, .., s-1, s,    A(q1) dH/dp(q1,p1) + dphi/dt = 0.
 *
 * s = 1 is the method of Stoermer and Verlet, with constraints RATTLE, for any Lagrangian. Positions and velocities satisfy the
 * constraints to rounding after each step. The equations are solved to rounding by Newton's method with M and A of the step's
 * beginning, and the sums of q and p are compensated (W. Kahan), so that rounding does not add up. Steps have a fixed length: a chosen
 * one would spoil all this. */
#ifndef EOM_VARIATIONAL_H
#define EOM_VARIATIONAL_H

#include "eom/integrate.h"
#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { EOM_VARIATIONAL_NODES = 4 }; /* at most */

typedef struct eom_variational {
  eom_system *sys;
  long iterations; /* of Newton's method, since the start */
  /* private */
  int s;
  tl_real c[EOM_VARIATIONAL_NODES], b[EOM_VARIATIONAL_NODES], D[EOM_VARIATIONAL_NODES][EOM_VARIATIONAL_NODES];
  tl_real K[EOM_VARIATIONAL_NODES][EOM_VARIATIONAL_NODES];       /* sum_j b_j D_ji D_jk, row i = 0..s-1, column k-1, k = 1..s */
  tl_real inverse[EOM_VARIATIONAL_NODES][EOM_VARIATIONAL_NODES]; /* of that */
  tl_real *p, *p_low;                                            /* n each: the momentum, and what rounding took from it */
  tl_real *Z, *dZ;                                               /* s x n: Q_k - q0, k = 1..s, and its last change */
  tl_real *R, *phi;                                              /* s x n, s x m: what the equations miss; phi(Q_k) */
  tl_real *lambda, *mu;                                          /* s x m */
  tl_real *sum;                                                  /* n: h sum b_j f_j */
  tl_real *A0;                                                   /* m x n */
  tl_real *Q, *V;                                                /* n each: a node */
  tl_real *r1, *x, *r2;                                          /* n, n, m: a right-hand side and its solution */
} eom_variational;

/* Numbers (tl_real) of workspace for a method of order 2, 4 or 6; 0 for others. */
size_t eom_variational_size(const eom_system *sys, int order);

/* Starts *it, with which all functions of eom/integrate.h and eom/events.h go on, but for eom_integrator_control: BAD_OPTION. y =
 * (q,qd): 2n, brought onto the constraints; work: eom_variational_size numbers. *v, *it and work live as long as each other. An
 * evaluation of *it is one of p and f. States inside a step are those of a polynomial of degree 5 through both ends' q, qd and qdd,
 * wrong by O(h^5); at events they are brought onto the constraints. BAD_OPTION for another order, or nonholonomic constraints; errors
 * of eom_project.
 *
 * A step of *it fails with RHS_FAILED, where rhs_code is the status of the system, or with NO_STEP, where its equations were not
 * solved: the report's index is the coordinate that is not settled. A step that eom_integrate shortens to end at t_end is another map
 * than the others. */
eom_status eom_variational_init(eom_variational *v, eom_integrator *it, eom_system *sys, int order, tl_real t, const tl_real *y,
                                tl_real h, tl_real *work);

#ifdef __cplusplus
}
#endif

#endif
