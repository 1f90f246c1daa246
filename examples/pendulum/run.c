/* One run: the Lyapunov exponents of one pendulum along its motion, row by row. */
#include "run.h"

#include "host/interrupt.h"
#include "host/message.h"
#include "pendulum1_tl.h"
#include "pendulum2_tl.h"
#include "pendulum3_tl.h"
#include "pendulum4_tl.h"
#include "pendulum5_tl.h"
#include "pendulum6_tl.h"
#include "pendulum_tl.h"

#include <math.h>
#include <stdlib.h>

const double energy_bound = 1e-6;
const double paper_step = 0.05;
const double paper_theta0 = 75.0, paper_time = 1000.0;

static const double g = 9.81;                /* m/s^2 */
static const double rounding = 1e-12;        /* relative, of a quotient of two times that stands for a whole number */
static const double first_tolerance = 1e-11; /* of chosen steps, rad and rad/s, */
static const double tighter = 0.1;           /* and this part of it where the energy error turned out too large */
static const double marks_per_row = 4.0;     /* where steps are chosen */

int run_width(const run *r) { return 6 * r->ask.links + 3; }

struct pendulum run_pendulum(int links) {
  struct pendulum p = {.n = links, .g = g};
  for (int k = 0; k < links; k++) p.mass[k] = p.length[k] = 1.0;
  return p;
}

const eom_model *run_model(int links) {
  static const eom_model *const sized[] = {&pendulum1_model, &pendulum2_model, &pendulum3_model,
                                           &pendulum4_model, &pendulum5_model, &pendulum6_model};
  return links <= (int)(sizeof sized / sizeof sized[0]) ? sized[links - 1] : &pendulum_model;
}

/* How many parts of at most the given length make up the whole. */
static double whole_parts(double whole, double part) { return ceil(whole / part * (1.0 - rounding)); }

/* The number of rows of the whole run, and the number of the mark nearest to the time of row i; the last row is at t_end. */
static long row_count(const run_request *ask) { return (long)whole_parts(ask->t_end, ask->every); }

static long mark_of_row(const run *r, long i, long marks) {
  return i >= row_count(&r->ask) ? marks : lround((double)i * r->ask.every / r->mark);
}

/* Takes stock at a mark. */
static void measure(run *r, const eom_lyapunov *ly) {
  eom_lyapunov_checks checks;
  r->t = ly->t;
  r->energy_error = fabs(ly->energy - ly->energy0);
  eom_lyapunov_check(ly, &checks);
  r->orthogonality_error = checks.orthogonality;
  r->worst_energy_error = fmax(r->worst_energy_error, r->energy_error);
  if (r->orthogonality_error > 1.0 && r->t_orthogonality_lost < 0.0) r->t_orthogonality_lost = r->t;
}

static void keep_row(run *r, const eom_lyapunov *ly) {
  int width = run_width(r);
  double *row = r->rows + r->nrow++ * width;
  row[0] = r->t;
  eom_lyapunov_exponents(ly, row + 1);
  for (int i = 0; i < ly->k; i++) {
    double *mean = row + 1 + ly->k + i, *half_width = mean + ly->k;
    if (eom_lyapunov_interval(ly, i, mean, half_width) == 0) *half_width = HUGE_VAL;
  }
  row[width - 2] = r->energy_error;
  row[width - 1] = r->orthogonality_error;
}

static void conclude(run *r, const eom_lyapunov *ly) {
  eom_lyapunov_checks checks;
  eom_lyapunov_exponents(ly, r->lambda);
  r->blocks = eom_lyapunov_interval(ly, 0, &r->mean, &r->half_width);
  eom_lyapunov_check(ly, &checks);
  r->sum_error = checks.sum_error;
  r->pairing_error = checks.pairing_error;
}

static bool chooses(const run *r) { return r->ask.step == 0.0; }

static bool over_bound(const run *r) { return chooses(r) && r->worst_energy_error > energy_bound; }

/* Goes on until t_end or until something ends the run; leaves r->end. */
static void advance(run *r, eom_lyapunov *ly) {
  long marks = lround(r->ask.t_end / r->mark);
  long next_row = mark_of_row(r, 1, marks);
  r->end = RUN_COMPLETE;
  for (long i = 1; i <= marks && r->end == RUN_COMPLETE && !over_bound(r); i++) {
    r->status = eom_lyapunov_step(ly);
    if (r->status != EOM_OK) {
      r->end = r->status == EOM_NOT_FINITE ? RUN_OVERFLOWED : RUN_FAILED;
      break;
    }
    measure(r, ly);
    r->done = (double)i / (double)marks;
    if (interrupted()) r->end = RUN_INTERRUPTED;
    if (i == next_row) {
      keep_row(r, ly);
      next_row = mark_of_row(r, r->nrow + 1, marks);
    }
  }
  bool kept = r->nrow > 0 && r->rows[(r->nrow - 1) * run_width(r)] == r->t;
  if (r->end != RUN_COMPLETE && r->t > 0.0 && !kept) keep_row(r, ly); /* the last state that there was */
}

/* A fixed step as the paper's, shortened a little where t_end is not a whole number of steps away; or chosen ones. */
static eom_lyapunov_options options_of(run *r, double tolerance) {
  eom_lyapunov_options options = eom_lyapunov_options_default();
  double part = chooses(r) ? fmin(r->ask.every, r->ask.t_end) / marks_per_row : r->ask.step;
  r->mark = r->ask.t_end / whole_parts(r->ask.t_end, part);
  options.scheme = r->ask.scheme;
  options.interval = r->mark;
  options.control = (eom_step_control){.rtol = tolerance, .atol = tolerance};
  if (!chooses(r)) {
    options.method = &eom_dp5;
    options.h = r->mark;
  }
  return options;
}

/* The whole run. */
static void attempt(run *r, eom_system *sys, double tolerance) {
  eom_lyapunov_options options = options_of(r, tolerance);
  eom_lyapunov *ly;
  double y[2 * PENDULUM_MAX_LINKS] = {r->ask.theta0};

  r->nrow = 0;
  r->worst_energy_error = 0.0;
  r->t_orthogonality_lost = -1.0;
  r->step = r->mark;
  r->status = eom_lyapunov_create(&ly, sys, &options, 0.0, y);
  r->end = RUN_FAILED;
  if (r->status != EOM_OK) return;
  advance(r, ly);
  conclude(r, ly);
  if (ly->it.steps > 0) r->step = r->t / (double)ly->it.steps;
  eom_lyapunov_destroy(ly);
}

void run_do(run *r) {
  struct pendulum p = run_pendulum(r->ask.links);
  eom_system *sys = NULL;

  r->end = RUN_FAILED;
  r->status = EOM_NO_MEMORY;
  r->rows = calloc((size_t)row_count(&r->ask) + 1, (size_t)run_width(r) * sizeof *r->rows);
  if (r->rows != NULL) r->status = eom_system_create(&sys, run_model(r->ask.links), &p, NULL);
  if (r->rows != NULL && r->status == EOM_OK) {
    double tolerance = first_tolerance;
    attempt(r, sys, tolerance);
    while (r->end == RUN_COMPLETE && over_bound(r)) attempt(r, sys, tolerance *= tighter);
    r->report = sys->report;
  }
  r->done = 1.0;
  eom_system_destroy(sys);
}

void run_free(run *r) {
  free(r->rows);
  r->rows = NULL;
}

void run_complain(const run *r) {
  char text[2000];
  if (r->end == RUN_INTERRUPTED) complain("stopped by the user at t = %g s of %g s", r->t, r->ask.t_end);
  if (r->end == RUN_OVERFLOWED)
    complain("N = %d: a number overflowed after t = %g s of %g s (|Q'Q-I| = %.1e, |E-E0| = %.1e J); take a shorter --step%s",
             r->ask.links, r->t, r->ask.t_end, r->orthogonality_error, r->energy_error,
             r->ask.scheme == EOM_LYAPUNOV_PAPER ? ", or another --scheme" : "");
  if (r->end != RUN_FAILED) return;
  complain("N = %d: no result after t = %g s: %s", r->ask.links, r->t, eom_status_text(r->status));
  eom_report_text(&r->report, text, sizeof text);
  fputs(text, stderr);
}
