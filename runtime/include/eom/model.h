/* What a model is to the runtime: sizes, names, jet functions, and motion functions where tlgen printed some. tlgen prints one constant
 * eom_model per model. */
#ifndef EOM_MODEL_H
#define EOM_MODEL_H

#include "taylor/context.h"

/* Motion functions: see eom/motion.h, whose one-letter names a program must include before a source of its own that has such macros. */
typedef struct eom_motion eom_motion;
typedef struct eom_parts eom_parts;

/* A source function carried over to jets, in any shape of cx.
 *   out      its results: rows jets; the runtime sets a force's to zero and all others to NaN before the call, so that a row which the
 *            function leaves unwritten is no force, and elsewhere an error that names the row
 *   q, qd    coordinates and velocities: n jets each
 *   t        time: one jet
 *   params   the user's parameter struct (null where the model has none)
 * Failures are left in cx->status; then out holds no usable numbers. */
typedef void eom_jet_fn(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params);

/* One function of the model. */
typedef struct eom_function {
  const char *name;                    /* as in the source */
  const char *source;                  /* "pendulum.c:12": file without its folder, and line */
  eom_jet_fn *jet;                     /* null where the model has no such function */
  int (*rows)(const void *params);     /* number of results */
  size_t (*frame)(const void *params); /* jets that a call takes from the context's frame stack, at most */
} eom_function;

typedef struct eom_model {
  const char *name;
  int (*dof)(const void *params);   /* n, the number of generalized coordinates */
  size_t params_size;               /* bytes of the parameter struct, 0 where there is none */
  eom_function lagrangian;          /* L(q,qd,t), one row, J */
  eom_function force;               /* generalized force, n rows; jet null where there is none */
  eom_function dissipation;         /* Rayleigh's D(q,qd,t), one row, W: the force -dD/dqd beside it; likewise */
  const eom_function *holonomic;    /* phi(q,t) = 0 */
  int nholonomic;                   /* functions, not rows */
  const eom_function *nonholonomic; /* psi(q,qd,t) = 0 */
  int nnonholonomic;
  const eom_motion *const *motion; /* functions for its motion at certain sizes; the jets serve all other sizes and needs */
  int nmotion;
} eom_model;

#endif
