/* A run of a scene: integration with projection onto the constraints, and the largest errors on the way. */
#ifndef HARD_CASES_RUN_H
#define HARD_CASES_RUN_H

#include "scene.h"

#include <stdbool.h>

/* What keeps the constraints. */
typedef enum run_drift { DRIFT_NONE, DRIFT_BAUMGARTE, DRIFT_PROJECTION } run_drift;

typedef struct run_request {
  const scene *scene;
  double duration;    /* s; 0: the scene's */
  const char *method; /* of integration; null: the scene's */
  double step;        /* s */
  double tolerance;   /* of steps chosen by their error; 0 for it and for step: the scene's */
  run_drift drift;
  double rate; /* alpha = beta of DRIFT_BAUMGARTE, 1/s */
} run_request;

/* One output. */
typedef struct run_row {
  double t;            /* s */
  double error;        /* as in scene.h; NaN where there is no truth */
  double energy;       /* |energy - work - that of the start|, J */
  double phi, phi_dot; /* largest |phi|; largest of |phi_dot| and |psi| */
  int rank;            /* of the constraint rows */
} run_row;

typedef struct run {
  run_request ask;
  int n, m1, m;    /* coordinates, rows of constraints on coordinates, of all constraints */
  double duration; /* s: what was asked for */
  run_row *rows;   /* of each output; freed by run_free */
  int nrow;
  int compared;  /* outputs after the start that have a truth */
  run_row worst; /* the largest of each, from t = 0 on; t: how far the run got; rank: the least */
  int most_rank;
  double seconds; /* of computation, without the outputs */
  eom_status status;
  eom_report report; /* of a status that is not OK */
} run;

/* Runs to the end, to a failure (status) or until the user interrupts (EOM_STOPPED). */
void run_do(run *r, const run_request *ask);

/* Whether the run got to its end, was compared with a truth on the way, and kept the scene's bounds. */
bool run_passed(const run *r);

void run_free(run *r);

#endif
