/* The linear model on the constraint manifold: as many state variables as there are independent ones, no spurious eigenvalues.
 *
 * The state y = (q,qd) is held to phi(q,t) = 0, phi_dot = 0, psi(q,qd,t) = 0. With A1 the holonomic rows of A, r1 and r the ranks of A1
 * and A, and G = d(phi_dot, psi)/dq, the small changes (x,u) of (q,qd) that these rows allow satisfy A1 x = 0, G x + A u = 0:
 *   (x,u) = Z z,  Z = [N1 0; Y N],  A1 N1 = 0,  A N = 0,  A Y = -G N1 with N' M Y = 0,  N1' calM N1 = 1,  N' M N = 1.
 * z has d = 2n - r1 - r components: n - r1 changes of position, then n - r of velocity beside those that positions bring with them.
 * S = [N1' calM, 0; 0, N' M] has S Z = 1, so that (x,u) = Z z gives z = S (x,u), and z' = F z with F = S F_y Z, F_y = [0 1; qdd_y].
 * calM is M, but where M is singular on the motions that holonomic rows allow M + A'WA (eq 31).
 *
 * At an equilibrium, and along a motion on which q and qd change in ignorable coordinates alone, F is constant: its eigenvalues are the
 * exponents of small motions (eom/modes.h). At any other state it is the matrix of that instant, in the frame z = S dy held fixed. */
#ifndef EOM_MINIMAL_H
#define EOM_MINIMAL_H

#include "eom/system.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Basis vector k is the only one of 0..k of its kind (position or velocity) that moves coordinate[k], which it increases: minimal
 * coordinates are the model's own coordinate[0..], scaled to unit inertia and combined in this order. That makes the basis unique; the
 * coordinates are those most free to move, the first among equals. */
typedef struct eom_minimal {
  int n;           /* of the system */
  int nq, nv, d;   /* n - r1, n - r, nq + nv */
  int *coordinate; /* d */
  tl_real *Z;      /* 2n x d */
  tl_real *S;      /* d x 2n */
  tl_real *F;      /* d x d */
} eom_minimal;

/* Bytes of memory for eom_linearise_minimal. */
size_t eom_minimal_bytes(const eom_system *sys);

/* Linearises at (q, qd, t) as eom_linearise does and fills *minimal, whose arrays are in memory and live as long as that. The system
 * must have EOM_NEED_LINEARISE. OFF_CONSTRAINTS where the state does not satisfy the constraints (report.row; eom_project makes it);
 * NO_MEMORY where bytes are fewer than eom_minimal_bytes; errors of eom_linearise. */
eom_status eom_linearise_minimal(eom_system *sys, eom_minimal *minimal, const tl_real *q, const tl_real *qd, tl_real t, void *memory,
                                 size_t bytes);

/* B = S [0; qdd_p] for z' = F z + B dp: d x k, from qdd_p = d qdd/dp (n x k) of k inputs as eom_parameter_derivatives gives it. An
 * input is a member of the parameter struct that the Lagrangian and forces alone use; one that a constraint uses moves the manifold. */
void eom_minimal_inputs(const eom_minimal *minimal, tl_real *B, int k, const tl_real *qdd_p);

#ifdef __cplusplus
}
#endif

#endif
