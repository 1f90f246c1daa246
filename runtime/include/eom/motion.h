/* What tlgen prints for the motion of one model at one size: functions that evaluate its equations of motion and their derivatives.
 *
 * Every size is a constant inside them: n coordinates, m1 holonomic and m2 nonholonomic constraint rows, m = m1 + m2 (holonomic rows
 * first, functions in the model's order). Matrices are row-major without padding. A dot is a derivative in time, y = (q,qd), and
 *   M qdd = Q + A' lambda,  A qdd = b  (eqs 26, 30),  r = M qdd - Q.
 *
 * Arguments of every function, outputs between inputs and work:
 *   params   the user's parameter struct, null where the model has none. Its numbers may change between calls; its sizes may not
 *   q, qd    coordinates and velocities: n each
 *   t        time, s
 *   qdd      accelerations: n, where given. lambda: multipliers, m; null where m = 0
 *   work     the motion's number of tl_real, aligned to EOM_MOTION_ALIGNMENT bytes; holds nothing from one call to the next; null where
 *            that number is 0
 * Outputs overlap neither inputs nor each other; those of no elements (m = 0, np = 0) may be null. Nothing else is written, nothing
 * allocates.
 *
 * Each returns 0, or one of EOM_MOTION_CODES, or s > 0: the elementary function of sites[s-1] has no value, or no derivative that is
 * needed, at this point. After a failure the outputs hold no usable numbers; with 0 all of them are finite. */
#ifndef EOM_MOTION_H
#define EOM_MOTION_H

#include "eom/model.h"
#include "taylor/lanes.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Every negative code with its meaning. */
#define EOM_MOTION_CODES(X)                                                                                                            \
  X(NOT_FINITE, -1, "a result is not finite, through overflow or through an input that is not")                                        \
  X(PIVOT, -2, "the mass matrix is not safely positive definite: solve its equations by other means")                                  \
  X(SIZE, -3, "the parameters have other sizes than the function was printed for")

enum {
#define EOM_X(name, code, text) EOM_MOTION_##name = code,
  EOM_MOTION_CODES(EOM_X)
#undef EOM_X
};

#define EOM_MOTION_ALIGNMENT TL_ALIGNMENT /* bytes */

/* A mass matrix of order n is safely positive definite where each pivot of its LDL' factorisation, in parts of the diagonal element
 * that it began as, is above this. What is below is rounding. */
#define EOM_MOTION_LEAST_PIVOT(n) (TL_C(8.0) * (tl_real)(n) * TL_EPSILON)

/* Constrained equations are solved by elimination of M, then of A M^-1 A', where each pivot, likewise in parts of its element, is above
 * this. What is below goes to the general solver, which does not square the condition of A. */
#define EOM_MOTION_SAFE_PIVOT TL_C(1e-3)

/* The parts of the equations of motion at a state; none is null but those of no elements. */
struct eom_parts {
  tl_real *M;       /* n x n, symmetric to the bit */
  tl_real *Q;       /* n: Gamma + dL/dq - d/dt(dL/dqd) at qdd = 0 */
  tl_real *phi;     /* m1: phi(q,t) */
  tl_real *phi_dot; /* m1 */
  tl_real *psi;     /* m2: psi(q,qd,t) */
  tl_real *A;       /* m x n: dphi/dq above dpsi/dqd */
  tl_real *b;       /* m: phi'' = A qdd - b, psi' = A qdd - b */
};

/* A place in the user's source where an elementary function can fail. */
typedef struct eom_site {
  tl_fn function;   /* TL_FN_sqrt; TL_FN_div for a division, TL_FN_compose for a function that has a rule of the user */
  const char *file; /* "pendulum.c" */
  int line;
} eom_site;

/* p = dL/dqd (momentum: n), its rate but for constraint forces dL/dq + Gamma - dD/dqd (n), L, and E = p.qd - L (one number each, J). */
typedef int eom_energy_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *momentum, tl_real *momentum_rate,
                          tl_real *lagrangian, tl_real *energy, tl_real *work);

/* Every part of *out. */
typedef int eom_simulate_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const eom_parts *out, tl_real *work);

/* Inverse dynamics. r: n. */
typedef int eom_residual_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd, tl_real *r,
                            tl_real *work);

/* r_y = d(r - A' lambda)/dy: n x 2n, g_y = d(A qdd - b)/dy: m x 2n, both at fixed qdd and lambda. */
typedef int eom_linearise_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd,
                             const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work);

/* The same in k >= 1 directions, the columns of w (2n x k): r_w = r_y w: n x k, g_w = g_y w: m x k. */
typedef int eom_tangent_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd,
                           const tl_real *lambda, int k, const tl_real *w, tl_real *r_w, tl_real *g_w, tl_real *work);

/* r_p = d(r - A' lambda)/dp: n x np, g_p = d(A qdd - b)/dp: m x np, both at fixed y, qdd and lambda. */
typedef int eom_parameters_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, const tl_real *qdd,
                              const tl_real *lambda, tl_real *r_p, tl_real *g_p, tl_real *work);

/* Solved forms, of models without constraints: qdd = M^-1 Q. qdd: n. */
typedef int eom_acceleration_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *qdd, tl_real *work);

/* qdd and qdd_y = d qdd/dy: n x 2n. */
typedef int eom_jacobian_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *qdd, tl_real *qdd_y,
                            tl_real *work);

/* qdd and its derivatives in k >= 1 directions, the columns of w (2n x k): dqdd = qdd_y w: n x k. */
typedef int eom_directional_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, int k, const tl_real *w,
                               tl_real *qdd, tl_real *dqdd, tl_real *work);

/* The solved form of models with constraints: qdd, lambda and the constraint force Qc = A' lambda. qdd: n, lambda: m, Qc: n.
 * EOM_MOTION_PIVOT where a pivot is not above EOM_MOTION_SAFE_PIVOT. */
typedef int eom_constrained_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *qdd, tl_real *lambda,
                               tl_real *Qc, tl_real *work);

/* Coefficients of the motion in time from this state on, q_i(t + s) = sum_(k=0..order) coef[i (order + 1) + k] s^k: n x (order + 1),
 * for 2 <= order <= EOM_TAYLOR_MOST. By elimination without a look at its pivots: to be called where the solved form has succeeded. */
#define EOM_TAYLOR_MOST 27
typedef int eom_taylor_fn(const void *params, const tl_real *q, const tl_real *qd, tl_real t, int order, tl_real *coef, tl_real *work);

/* The solved forms of TL_LANES states at once: element [i] of an array holds the i-th numbers of all states, *t their times. Arrays are
 * aligned to EOM_MOTION_ALIGNMENT bytes. Parameters are the same for all. What is returned is not 0 where it would not be for one of
 * the states: then no output is usable, and the function for one state says which state it is and gives the results of the others. */
typedef int eom_acceleration_lanes_fn(const void *params, const tl_lanes *q, const tl_lanes *qd, const tl_lanes *t, tl_lanes *qdd,
                                      tl_lanes *work);
typedef int eom_jacobian_lanes_fn(const void *params, const tl_lanes *q, const tl_lanes *qd, const tl_lanes *t, tl_lanes *qdd,
                                  tl_lanes *qdd_y, tl_lanes *work);
typedef int eom_directional_lanes_fn(const void *params, const tl_lanes *q, const tl_lanes *qd, const tl_lanes *t, int k,
                                     const tl_lanes *w, tl_lanes *qdd, tl_lanes *dqdd, tl_lanes *work);

/* A model's motion at one size. Functions that the model was not asked for are null; so are the
 * first three solved forms where m > 0, and the last one where m = 0. */
struct eom_motion {
  int n, m1, m2;
  int (*fits)(const void *params); /* 1 where the parameters have these sizes, 0 elsewhere */
  size_t work;                     /* numbers (tl_real; tl_lanes where those are asked for) of workspace, enough for each function */
  int autonomous;                  /* 1: proved that t occurs nowhere, in L, forces and constraints */
  int constant_mass;               /* 1: proved that M depends on params alone */
  const eom_site *sites;
  int nsite;
  const char *const *parameter; /* np: what p is, as in "p->mass[2]" */
  int np;
  eom_energy_fn *energy;
  eom_simulate_fn *simulate;
  eom_residual_fn *residual;
  eom_linearise_fn *linearise;
  eom_tangent_fn *tangent;
  eom_parameters_fn *parameters;
  eom_acceleration_fn *acceleration;
  eom_jacobian_fn *jacobian;
  eom_directional_fn *directional;
  eom_constrained_fn *constrained; /* of models with constraints, where their equations are small or sparse enough */
  eom_taylor_fn *taylor;
  int lanes; /* TL_LANES of the three that follow; 0 where tlgen was not asked for them (--lanes) */
  eom_acceleration_lanes_fn *acceleration_lanes;
  eom_jacobian_lanes_fn *jacobian_lanes;
  eom_directional_lanes_fn *directional_lanes;
};

#ifdef __cplusplus
}
#endif

#endif
