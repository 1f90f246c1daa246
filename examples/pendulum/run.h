/* One run: the Lyapunov exponents of one pendulum along its motion, row by row. */
#ifndef PENDULUM_RUN_H
#define PENDULUM_RUN_H

#include <eom/eom.h>
#include <stdbool.h>
#include <stdio.h>

#include "pendulum.h"

/* What is asked for. */
typedef struct run_request {
  int links;
  double theta0; /* of the first link, rad; the other links hang down, all are at rest */
  double t_end;  /* s */
  double step;   /* fixed, s; 0: steps are chosen, so that the energy error stays below energy_bound */
  double every;  /* time from row to row, s */
  eom_lyapunov_scheme scheme;
} run_request;

/* Largest energy error, J, of a run that chooses its steps itself. */
extern const double energy_bound;

/* The step that the paper states for its Table 1, s. */
extern const double paper_step;

/* The start that the paper states for it, degrees, and the time, s. */
extern const double paper_theta0, paper_time;

/* How a run ended. */
typedef enum run_end {
  RUN_COMPLETE,
  RUN_INTERRUPTED, /* by the user */
  RUN_OVERFLOWED,  /* a number outgrew its type: what becomes of tangents that are never re-orthonormalised, or of too long a step */
  RUN_FAILED       /* anything else; the report says what */
} run_end;

typedef struct run {
  run_request ask;
  _Atomic double done; /* part of the run that is done, 0..1; any thread may look */

  /* filled by run_do */
  double *rows; /* nrow rows of run_width numbers: t, lambda_1..lambda_2N, the means and half-widths of their intervals by then (the
                   half-width infinite where there is none), |E-E0|, |Q'Q-I| */
  long nrow;
  run_end end;
  eom_status status;
  eom_report report;                        /* where status is not EOM_OK */
  double step;                              /* taken, s; the mean where steps are chosen */
  double mark;                              /* s: after each of these times the run is measured: a fixed step, or a part of a row */
  double t;                                 /* reached, s */
  double energy_error, orthogonality_error; /* at t: |E-E0|, J, and max |Q'Q-I| */
  double worst_energy_error;                /* up to t, J */
  double t_orthogonality_lost;              /* when |Q'Q-I| first exceeded 1, s; negative: never */
  double lambda[2 * PENDULUM_MAX_LINKS];    /* at t, 1/s */
  double mean, half_width;                  /* of lambda_1 with its 95 % half-width */
  int blocks;                               /* that the interval rests on; 0: no interval */
  double sum_error, pairing_error;          /* 1/s */
} run;

/* Numbers in one row. */
int run_width(const run *r);

/* The pendulum of this demonstration: n links of 1 kg and 1 m, g = 9.81 m/s^2. */
struct pendulum run_pendulum(int links);

/* The model of as many links: with motion functions up to the size of Table 1, by calls beyond. */
const eom_model *run_model(int links);

/* Computes the run in r->ask and fills the rest. Thread-safe for different runs. */
void run_do(run *r);

/* Gives the rows back. */
void run_free(run *r);

/* Says on standard error why a run did not reach its end. */
void run_complain(const run *r);

#endif
