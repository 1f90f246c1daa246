/* A mechanical system: a model with its parameters, options, and all numbers of an evaluation grouped by the stage that computes them.
 *
 * Everywhere: n coordinates, m1 holonomic and m2 nonholonomic constraint rows, m = m1 + m2 (holonomic rows first, functions in the
 * model's order); matrices row-major without padding. One system serves one thread. Nothing but eom_system_create allocates. */
#ifndef EOM_SYSTEM_H
#define EOM_SYSTEM_H

#include "eom/motion.h"
#include "eom/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a system will be asked for, bits; memory is reserved for nothing else. */
enum {
  EOM_NEED_SIMULATE = 0,   /* assemble, solve, energy, integrate: always there */
  EOM_NEED_LINEARISE = 1,  /* linearise, Lyapunov exponents */
  EOM_NEED_RESIDUAL = 2,   /* inverse dynamics */
  EOM_NEED_TANGENT = 4,    /* derivatives in given directions */
  EOM_NEED_PARAMETERS = 8, /* derivatives with respect to parameters */
  EOM_NEED_ALL = 15
};

/* What a system evaluates, each by one emitter of tlgen. */
typedef enum eom_task {
  EOM_TASK_ENERGY,
  EOM_TASK_ASSEMBLE, /* and the acceleration */
  EOM_TASK_LINEARISE,
  EOM_TASK_RESIDUAL,
  EOM_TASK_TANGENT,
  EOM_TASK_PARAMETERS,
  EOM_TASK_COUNT
} eom_task;

/* Whose functions evaluate the model. */
typedef enum eom_emitter {
  EOM_EMITTER_AUTO,  /* motion functions where the model has them at this size, else calls */
  EOM_EMITTER_CALLS, /* the model's functions on jets, eom_function */
  EOM_EMITTER_MOTION /* motion functions alone, eom_motion; BAD_OPTION where one that the needs ask for is missing at this size */
} eom_emitter;

/* Who does the dense linear algebra. */
typedef enum eom_linalg_choice {
  EOM_LINALG_AUTO,  /* by size */
  EOM_LINALG_CORE,  /* the library's own C11 code */
  EOM_LINALG_LAPACK /* LAPACKE; BAD_OPTION in a build without it */
} eom_linalg_choice;

/* Baumgarte's stabilisation: phi'' + 2 alpha phi' + beta^2 phi = 0 and psi' + alpha psi = 0 take the place of phi'' = 0 and psi' = 0,
 * so that a state beside the constraints tends to them: alpha = beta without oscillation. In every acceleration, b and derivative. */
typedef struct eom_baumgarte {
  tl_real alpha, beta; /* 1/s, at least 0 */
} eom_baumgarte;

/* Rank as a property of the mechanism: each eom_project decides which constraint rows are independent, at the state that it leaves on
 * the constraints, and all solves until the next one keep to it; rows that it drops get no multiplier. Beside the constraints, at the
 * stages of a Runge-Kutta step, rows that depend on each other look independent by as much as the state is off; to believe that gives
 * accelerations without meaning. Near a singular position a step's error e becomes e/s^2 across rows that are held at a distance s from
 * it, while rows that are dropped miss the force across them for a time like s: at the default tolerances the two are alike for e =
 * 1e-12. */
typedef struct eom_hold {
  int on;             /* 1: as above; default 0: each solve decides for itself by rank_tolerance */
  tl_real drop, take; /* a row is dropped where what it adds to the others falls to drop, and taken back where it exceeds take, both as
                         for rank_tolerance <= drop <= take < 1; default 1e-4, 3e-4 */
  tl_real ahead; /* a row is dropped too where what it adds fell by less than this in the last step and would be gone after another one
                    like it, so that no stage comes near the singular position with it; default 5e-3 */
} eom_hold;

typedef struct eom_options {
  unsigned needs;         /* EOM_NEED_ bits; default EOM_NEED_LINEARISE */
  const tl_real *weights; /* W of eq 31: m positive numbers, copied by init; null (default): used only where M needs it, scaled to M.
                             Accelerations and constraint forces do not depend on it. Weights are cut at 4096 times the automatic ones,
                             beside which M loses digits; those that leave calM singular are replaced by the automatic ones. */
  tl_real rank_tolerance; /* a row is dependent where what it adds to the others is at most this part of its length, in the mass
                             metric; default 1e-10: between rounding (1e-15) and the condition of 1e7 that must still be resolved */
  tl_real consistency_tolerance; /* dependent rows are inconsistent where they ask for accelerations that differ by more than this
                                    part of the largest acceleration; default sqrt(epsilon) */
  eom_linalg_choice linalg;      /* default EOM_LINALG_AUTO */
  eom_emitter emitter;           /* default EOM_EMITTER_AUTO */
  eom_baumgarte baumgarte;       /* default none: 0, 0. BAD_OPTION with EOM_NEED_PARAMETERS where there are constraints: derivatives
                                    with respect to parameters do not know them */
  eom_hold hold;                 /* default off */
  tl_real most_jump; /* a projection after a step is refused (VELOCITY_JUMP) where it changes a velocity by more than this part of the
                        largest so far, in the mass metric; default 0.1: far above what a step leaves over, and what passing a
                        singular position with options.hold takes. Infinite: never */
} eom_options;

/* All defaults. */
eom_options eom_options_default(void);

typedef struct eom_workspace eom_workspace; /* private */

typedef struct eom_system {
  const eom_model *model;
  const void *params;  /* the model's parameters: read at every evaluation, may change between them as long as the sizes stay */
  eom_options options; /* weights point into the system's own memory */
  int n, m1, m2, m;
  const eom_motion *motion; /* the motion functions in use; null where calls do everything */

  /* energy, assemble */
  tl_real *momentum;      /* n: p = dL/dqd */
  tl_real *momentum_rate; /* n: dL/dq + Gamma - dD/dqd, which is dp/dt but for the constraint forces */
  tl_real lagrangian;     /* L, J */
  tl_real energy;         /* E = p.qd - L, J */

  /* assemble: M qdd = Q + A' lambda, A qdd = b (eqs 26, 30) */
  tl_real *M;       /* n x n, symmetric to the bit */
  tl_real *Q;       /* n: Gamma + dL/dq - d/dt(dL/dqd) at qdd = 0 */
  tl_real *A;       /* m x n: dphi/dq above dpsi/dqd */
  tl_real *b;       /* m; with the terms of options.baumgarte */
  tl_real *phi;     /* m1: phi(q,t), zero on the manifold */
  tl_real *phi_dot; /* m1: d phi/dt, zero on the manifold */
  tl_real *psi;     /* m2: psi(q,qd,t), zero on the manifold */

  /* solve, acceleration (which leaves the fields above unspecified) */
  tl_real *qdd;    /* n */
  tl_real *lambda; /* m: the physical multipliers; of least norm among equals where rows are dependent (rows scaled to unit length), 0
                      for those that options.hold has dropped */
  tl_real *Qc;     /* n: constraint force A' lambda */
  eom_row_kind *row_kind; /* m */

  /* project, with options.hold */
  int held_rank;     /* rows held as independent; -1: nothing is held */
  long rank_changes; /* how often a projection after a step has changed that number: events for who integrates */

  /* linearise (null without EOM_NEED_LINEARISE) */
  tl_real *qdd_y;    /* n x 2n: d qdd/d(q,qd), the lower rows of F; the upper ones are [0 I] */
  tl_real *lambda_y; /* m x 2n: d lambda/d(q,qd) */

  eom_report report;
  eom_workspace *workspace;
} eom_system;

/* Bytes of memory that eom_system_init needs; 0 where the model or an option is invalid. */
size_t eom_system_bytes(const eom_model *model, const void *params, const eom_options *options);

/* Starts a system in memory (at least that many bytes, aligned for any type, which must live as long as the system). params may be null
 * where the model has none; options null for the defaults. BAD_MODEL, BAD_OPTION, NO_MEMORY. */
eom_status eom_system_init(eom_system *sys, const eom_model *model, const void *params, const eom_options *options, void *memory,
                           size_t bytes);

/* The same with memory from malloc. *sys is null unless EOM_OK. Destroy takes null. */
eom_status eom_system_create(eom_system **sys, const eom_model *model, const void *params, const eom_options *options);
void eom_system_destroy(eom_system *sys);

/* Who evaluates a task: EOM_EMITTER_MOTION or EOM_EMITTER_CALLS; EOM_EMITTER_AUTO where the system's needs do not include it. */
eom_emitter eom_system_emitter(const eom_system *sys, eom_task task);

/* Name and source of constraint row i, 0 <= i < m; kind is that of the last solve. */
eom_row eom_system_row(const eom_system *sys, int i);

#ifdef __cplusplus
}
#endif

#endif
