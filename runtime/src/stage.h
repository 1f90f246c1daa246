/* Stages: each runs model functions in one shape, with the motion curve and the tangents seeded. */
#ifndef EOM_STAGE_H
#define EOM_STAGE_H

#include "workspace.h"

/* Prepares the jets of q, qd and t for a stage, with x_i and u_i the tangents on q_i and qd_i that the stage carries:
 *   q(s) = q + x + s qd + s^2/2 qdd,  qd(s) = qd + u + s qdd,  t(s) = t + s.
 * qdd null: zero. Forgets earlier failures of jets. */
void eom_stage_seed(eom_system *sys, eom_stage_id id, const tl_real *q, const tl_real *qd, const tl_real *qdd, tl_real t);

/* Runs a function at the seeds; its result jets are then in workspace->jet_out. A failure is put in the report. */
eom_status eom_stage_run(eom_system *sys, const eom_function *function);

/* Puts a failure of a function's jets in the report; EOM_OK where there is none. */
eom_status eom_jet_verdict(eom_system *sys, const eom_function *function, tl_status jet);

/* Sets the report's status with the place of the first number of a (count) that is not finite; EOM_OK where all are. */
eom_status eom_check_finite(eom_system *sys, const char *name, const tl_real *a, int count);

#endif
