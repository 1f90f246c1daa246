/* Status and report: what went wrong, with the names of the user's own functions. The library prints nothing. */
#ifndef EOM_STATUS_H
#define EOM_STATUS_H

#include "taylor/context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Every status with the sentence that eom_status_text returns for it. */
#define EOM_STATUSES(X)                                                                                                                \
  X(OK, "no failure")                                                                                                                  \
  X(BAD_MODEL, "the model is incomplete or has impossible sizes")                                                                      \
  X(NO_PARAMS, "the model has a parameter struct, and none was given")                                                                 \
  X(SIZES_CHANGED, "the parameters no longer have the sizes that the system was started with")                                         \
  X(BAD_OPTION, "an option is outside its range")                                                                                      \
  X(NO_MEMORY, "the memory is too small or could not be allocated")                                                                    \
  X(DOMAIN, "a model function does not exist, or has no derivative, at this state")                                                    \
  X(NOT_FINITE, "a number is not finite")                                                                                              \
  X(NO_INERTIA, "the mass matrix is not positive definite on the motions that the constraints allow")                                  \
  X(INCONSISTENT, "constraints contradict each other")                                                                                 \
  X(RANK_FELL, "constraints that are held as independent have become dependent before the next projection")                            \
  X(VELOCITY_JUMP, "the projection after a step would change a velocity by more than the option most_jump allows")                     \
  X(NO_CONSISTENT_STATE, "no state that satisfies the constraints was found near this one")                                            \
  X(OFF_CONSTRAINTS, "the state does not satisfy the constraints")                                                                     \
  X(NO_EQUILIBRIUM, "no state without acceleration was found near this one")                                                           \
  X(NO_EIGENVALUES, "the eigenvalues were not found")                                                                                  \
  X(NOT_INVERSE, "the two coordinate transformations are not inverse to each other")                                                   \
  X(RHS_FAILED, "the right-hand side reported a failure of its own")                                                                   \
  X(NO_SERIES, "the equations are too near to singular for the series of their solution")                                              \
  X(NO_STEP, "the equations of an implicit step were not solved; a shorter step usually helps")                                        \
  X(STEP_TOO_SMALL, "no step is short enough for the tolerances")                                                                      \
  X(NOT_IN_STEP, "the time is not in the last step")                                                                                   \
  X(TOO_MUCH_WORK, "the integration took as many steps as it was allowed")                                                             \
  X(STOPPED, "the observer or an event asked to stop")                                                                                 \
  X(BAD_CHECKPOINT, "the checkpoint is damaged, or of another version, or none")                                                       \
  X(OTHER_CHECKPOINT, "the checkpoint is of another model, size or options, or of a program that computes other bits")

typedef enum eom_status {
#define EOM_X(name, text) EOM_##name,
  EOM_STATUSES(EOM_X)
#undef EOM_X
} eom_status;

/* The sentence of a status; a static string. */
const char *eom_status_text(eom_status status);

/* A constraint row that the solver had something to say about. */
typedef enum eom_row_kind { EOM_ROW_INDEPENDENT, EOM_ROW_DEPENDENT, EOM_ROW_INCONSISTENT, EOM_ROW_VIOLATED } eom_row_kind;

typedef struct eom_row {
  const char *name;   /* of the constraint function in the user's source */
  const char *source; /* "file.c:12" */
  int row;            /* of that function's results, from 0 */
  eom_row_kind kind;
} eom_row;

#define EOM_REPORT_ROWS 8

/* The outcome of the last evaluation. Holds static strings and the model's names only: copy it freely while the model lives. */
typedef struct eom_report {
  eom_status status;
  const char *function; /* the model function or argument that failed; the model where a motion function did; null where none did */
  const char *source;   /* its "file.c:12", null where unknown */
  tl_status jet;        /* the failing elementary function and the source line, where a model or motion function failed */
  int index;            /* coordinate without inertia or equilibrium, or place in a not finite array; -1 elsewhere */
  /* filled by every solve, also where it succeeds */
  int rank;          /* independent constraint rows */
  int weighted;      /* 1 where calM = M + A'WA took the place of M */
  tl_real pivot;     /* smallest pivot of the Cholesky factorisation of calM scaled to a unit diagonal, 0..1; -1 where a motion
                        function solved, which keeps it above EOM_MOTION_LEAST_PIVOT(n) and does not say more */
  tl_real condition; /* estimate of the condition of the constraint rows in the mass metric, each scaled to unit length; 1 for none; -1
                        where a motion function solved, which takes safe pivots alone */
  tl_real residual;  /* largest |A qdd - b|, each row scaled to unit length in the mass metric; -1 likewise */
  int nrow;          /* rows that are dependent or inconsistent; the first EOM_REPORT_ROWS of them are in row[] */
  eom_row row[EOM_REPORT_ROWS];
} eom_report;

/* Writes the report as text of one or more lines, each ended by '\n', at most size bytes with the closing 0. Returns the length that
 * the whole text has (as snprintf does). */
int eom_report_text(const eom_report *report, char *text, size_t size);

#ifdef __cplusplus
}
#endif

#endif
