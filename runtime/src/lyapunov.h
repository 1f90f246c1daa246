/* Private parts of a run of Lyapunov exponents. One file per purpose: lyapunov_start.c (options, memory, the first directions;
 * lyapunov_host.c where malloc gives it), lyapunov_scheme.c (what is integrated), lyapunov_path.c (the motion ahead of its tangents),
 * lyapunov_frame.c (QR), lyapunov_run.c (steps and marks), lyapunov_check.c and interval.c (what is read from a run), lyapunov_image.c
 * (checkpoints). */
#ifndef EOM_LYAPUNOV_PRIVATE_H
#define EOM_LYAPUNOV_PRIVATE_H

#include "eom/lyapunov.h"
#include "eom/taylor.h"
#include "workspace.h"

/* What a failure within an interval goes back to. */
typedef struct eom_lyapunov_moment {
  eom_integrator it, tangents; /* but for their vectors */
  tl_real *z;                  /* y, then what tangents integrate */
  tl_real *carry;              /* 2n: what rounding of y has lost, see eom_add_increment */
  tl_real *rho;                /* k */
  tl_real span;
  long qrs;
} eom_lyapunov_moment;

enum { EOM_PATH_STEPS = 16 }; /* kept */

/* The motion by its own steps, which are ahead of those of the tangents: the last ones are kept. */
typedef struct eom_lyapunov_path {
  tl_real *kept; /* EOM_PATH_STEPS of them, in a ring */
  size_t size;   /* numbers of one */
  int rows[EOM_PATH_STEPS];
  tl_real begin[EOM_PATH_STEPS], end[EOM_PATH_STEPS]; /* s */
  tl_real full[EOM_PATH_STEPS];                       /* s: what a step would have been if it had not ended at a mark */
  long count;                                         /* since the last mark */
  tl_real t_mark;                                     /* s: no step goes beyond */
  eom_status status;                                  /* of the motion */
} eom_lyapunov_path;

typedef struct eom_lyapunov_work {
  /* the frame: C = d(phi, phi_dot, psi)/dy by its rows, X by its columns */
  int rows;             /* of C: m1 + m */
  int rank;             /* how many of them are independent, at the start and from then on */
  tl_real *C;           /* rows vectors of 2n, then their QR factorisation */
  tl_real *rates;       /* m x n: d(phi_dot, psi)/dq */
  tl_real *tau_C;       /* 2n */
  int *pivot;           /* rows */
  tl_real *vectors;     /* k vectors of 2n - rank: the QR factorisation of X */
  tl_real *tau;         /* 2n */
  tl_real *column;      /* 2n */
  tl_real *log_R;       /* k: of the last QR */
  tl_real loss;         /* largest log |X_j|/R_jj of the last QR: digits that its directions lose to those before them */
  tl_real log_volume;   /* log |R_jj| of C summed; of use where all rows are independent */
  tl_real log_volume_0; /* at t0 */

  /* the right-hand side */
  tl_real *FX;      /* 2n x k: F Q; null for DISCRETE */
  tl_real *K;       /* k x k: Q'FQ; likewise */
  tl_real *dlambda; /* m x k; by directions only */
  tl_real *seen;    /* 2n: the y at which sys is linearised, */
  tl_real seen_t;   /* and the time; s */
  bool seen_valid;

  /* the integration */
  bool together;            /* y and tangents in the same steps */
  int dim;                  /* numbers that are integrated: y, X, rho, the divergence */
  tl_real *integrator;      /* workspace of ly->it */
  tl_real *tangents;        /* and of ly->tangents, where these have steps of their own */
  tl_real *rtol, *atol;     /* tolerances of each number */
  eom_lyapunov_path path;   /* likewise */
  eom_taylor taylor;        /* where options.taylor */
  tl_real *y;               /* 2n: on the path */
  tl_real reach;            /* of the tangents' next step, in steps of the motion */
  long steps_per_mark;      /* where steps are fixed */
  tl_real t_qr;             /* s: of the last QR, */
  tl_real span;             /* s: and the time from there after which the next one is due */
  eom_lyapunov_moment mark; /* as it was at the last mark */
  tl_real *scratch;         /* as many numbers as are integrated */
} eom_lyapunov_work;

/* What tangents integrate: X or Q (2n x k), rho (k, but for DISCRETE), the integral of trace F. Together with y it stands behind it. */
static inline int eom_lyapunov_rho_at(const eom_lyapunov *ly) { return 2 * ly->sys->n * ly->k; }

/* The integrator whose steps the tangents take, and their numbers in it. */
static inline eom_integrator *eom_lyapunov_stepper(eom_lyapunov *ly) { return ly->work->together ? &ly->it : &ly->tangents; }
static inline tl_real *eom_lyapunov_X(const eom_lyapunov *ly) {
  return ly->work->together ? ly->it.y + 2 * ly->sys->n : ly->tangents.y;
}

/* Derivatives by the scheme: of y (ydot may be null), and of what tangents integrate. Returns an eom_status. */
eom_status eom_lyapunov_rates(eom_lyapunov *ly, tl_real t, const tl_real *y, const tl_real *X, tl_real *ydot, tl_real *Xdot);

/* The motion at time t, not before the step that the tangents began last: y, 2n. What ended the motion; NOT_IN_STEP where the steps
 * that are kept are all later. */
eom_status eom_lyapunov_path_at(eom_lyapunov *ly, tl_real t, tl_real *y);

/* The time after that many steps of the motion, which need not be whole, from t on; t_mark where that is less. What ended the motion;
 * NOT_IN_STEP where it cannot go on as far without losing the steps that the tangents need. */
eom_status eom_lyapunov_path_after(eom_lyapunov *ly, tl_real t, tl_real steps, tl_real *after);

/* How many steps of the motion there are from begin to end, between which they are kept. */
tl_real eom_lyapunov_path_steps(const eom_lyapunov *ly, tl_real begin, tl_real end);

/* The motion begins anew at y of the last mark, on to that of t_mark. */
void eom_lyapunov_path_begin(eom_lyapunov *ly, tl_real t_mark);

/* Forgets where sys was linearised last. */
void eom_lyapunov_forget(eom_lyapunov *ly);

/* QR factorisation of C' at (t, y): rank, log_volume. Errors of eom_assemble. */
eom_status eom_lyapunov_factor_rows(eom_lyapunov *ly, tl_real t, const tl_real *y);

/* X = Q R with R_ii > 0 within the motions that the rows last factored allow, Q in the place of X (2n x k); fills log_R and loss.
 * NOT_FINITE where a R_ii is zero or no number. */
eom_status eom_lyapunov_orthonormalise(eom_lyapunov *ly, tl_real *X);

/* The first k directions of those that the rows last factored allow; the first unit vectors where there are no rows. */
void eom_lyapunov_span(eom_lyapunov *ly, tl_real *Q);

/* Energy, divergence and held rows for the state at it.t, which becomes the last mark. Errors of eom_energy and eom_project. */
eom_status eom_lyapunov_take_mark(eom_lyapunov *ly);

/* ly->divergence of the last mark, and the moment to go back to. */
void eom_lyapunov_keep_mark(eom_lyapunov *ly);

/* Integration goes on from z and carry of the moment to go back to. */
void eom_lyapunov_put_mark(eom_lyapunov *ly);

/* Decides which rows are held (eom_hold) by the state at a mark alone, so that it does not matter how the run came there. y: 2n. Errors
 * of eom_project. */
eom_status eom_lyapunov_hold_rows(eom_lyapunov *ly, tl_real t, const tl_real *y);

#endif
