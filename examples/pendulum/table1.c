/* The paper's Table 1 beside what its own scheme gives and beside the exponents. */
#include "table1.h"

#include "common/interrupt.h"
#include "common/message.h"
#include "common/output.h"
#include "csv.h"
#include "figures.h"
#include "folder.h"
#include "motion.h"
#include "workers.h"

#include <math.h>

/* Table 1 as printed in the paper: the maximal exponent for N = 1..6, 1/s. */
static const double printed[TABLE1_LINKS] = {3e-5, 0.1, 0.8, 1.4, 2.2, 3.1};

/* A step at which the printed scheme need not overflow, s, and the part of t_end over which it is followed. */
static const double shorter_step = 0.002, shorter_part = 0.5;

/* An orthogonality error that is more than rounding and the error of a step: directions off by a degree. */
static const double notable_loss = 0.02;

/* An energy error, J, that is more than a good trajectory has: a millionth of the energy of one link. */
static const double notable_energy_error = 1e-5;

/* One row of the table. */
typedef struct entry {
  run exponents;       /* re-orthonormalised, with a step that keeps the energy */
  run paper;           /* eqs 75-80 as printed, with the paper's step */
  run shorter;         /* the same with shorter_step */
  motion paper_motion; /* the trajectory alone with the paper's step */
} entry;

static void do_run(void *data) { run_do(data); }

static void do_motion(void *data) {
  entry *e = data;
  e->paper_motion = motion_do(&e->paper.ask, paper_step, e->paper.ask.t_end, HUGE_VAL);
}

/* Longest first; a step with tangents costs about as the cube of the number of links. */
static int list_tasks(entry *entries, int links, task *tasks) {
  int count = 0;
  for (int n = links; n >= 1; n--) {
    run *r = &entries[n - 1].exponents, *s = &entries[n - 1].shorter;
    tasks[count++] = (task){do_run, r, pow(n, 3.0), &r->done};
    tasks[count++] = (task){do_run, s, pow(n, 3.0) * shorter_part, &s->done};
  }
  for (int n = links; n >= 1; n--) {
    tasks[count++] = (task){do_run, &entries[n - 1].paper, 0.0, NULL};
    tasks[count++] = (task){do_motion, &entries[n - 1], 0.0, NULL};
  }
  return count;
}

static run_request as_printed(run_request each, double step, double t_end) {
  each.scheme = EOM_LYAPUNOV_PAPER;
  each.t_end = t_end;
  each.step = fmin(step, t_end);
  return each;
}

static double compute(const table1_request *ask, entry *entries) {
  task tasks[4 * TABLE1_LINKS];
  for (int n = 1; n <= ask->links; n++) {
    entry *e = &entries[n - 1];
    run_request each = ask->each;
    each.links = n;
    e->exponents.ask = each;
    e->paper.ask = as_printed(each, paper_step, each.t_end);
    e->shorter.ask = as_printed(each, shorter_step, shorter_part * each.t_end);
  }
  return do_tasks(tasks, list_tasks(entries, ask->links, tasks), "Table 1");
}

/* Whether the printed value lies in the interval of the exponent; false where there is no interval. */
static bool holds(const entry *e) {
  const run *r = &e->exponents;
  return r->blocks > 0 && fabs(printed[r->ask.links - 1] - r->mean) <= r->half_width;
}

static void print_exponents(const entry *e) {
  const run *r = &e->exponents;
  printf(" %d   %7g   %9.5f ", r->ask.links, printed[r->ask.links - 1], r->lambda[0]);
  if (r->blocks > 0)
    printf("  %8.4f .. %-8.4f", r->mean - r->half_width, r->mean + r->half_width);
  else
    printf("  %-20s", "too short a run");
  printf("  %-8.3g  %.1e   %s\n", r->step, r->worst_energy_error, r->blocks == 0 ? "-" : holds(e) ? "inside" : "outside");
}

static void print_when(double t) {
  if (t < 0.0)
    printf("  %-12s", "never");
  else
    printf("  %-12g", t);
}

static void print_paper(const entry *e) {
  const run *r = &e->paper;
  const motion *m = &e->paper_motion;
  printf(" %d ", r->ask.links);
  print_when(r->t_orthogonality_lost);
  print_when(r->end == RUN_OVERFLOWED ? r->t : -1.0);
  printf("  %-11.3g %8.1e   %8.1e", r->lambda[0], r->orthogonality_error, r->energy_error);
  if (m->status == EOM_OK || m->status == EOM_STOPPED)
    printf("   %.1e J in %g s\n", m->worst_energy_error, m->t);
  else
    printf("   overflows after %g s\n", m->t);
}

static void print_shorter(const entry *e) {
  const run *r = &e->shorter;
  if (r->end == RUN_OVERFLOWED)
    printf(" %d   Q overflows after %g s\n", r->ask.links, r->t);
  else
    printf(" %d   %9.5f   %8.1e   %8.1e\n", r->ask.links, r->lambda[0], r->orthogonality_error, r->worst_energy_error);
}

static void print_tables(const table1_request *ask, const entry *entries) {
  const run_request *each = &ask->each;
  printf("Maximal Lyapunov exponent of the planar N-pendulum from its Lagrangian, 1/s; t = %g s\n", each->t_end);
  printf("m = l = 1, g = 9.81, theta_1(0) = %g deg, all else 0\n\n", each->theta0 * 180.0 / acos(-1.0));
  printf(" Q re-orthonormalised, step chosen so that |E-E0| stays below %g J\n", energy_bound);
  printf(" N   Table 1  lambda_1(t)  95 %% interval         step, s   |E-E0|    Table 1 is\n");
  for (int n = 1; n <= ask->links; n++) print_exponents(&entries[n - 1]);
  printf("\n The paper's scheme as printed (eqs 75-80, Q never re-orthonormalised) at its stated step of %g s\n", paper_step);
  printf("    |Q'Q-I| > 1   Q overflows   just before, or at the end           the trajectory alone\n");
  printf(" N  after, s      after, s      lambda_1     |Q'Q-I|    |E-E0|     |E-E0|\n");
  for (int n = 1; n <= ask->links; n++) print_paper(&entries[n - 1]);
  printf("\n The same at a step of %g s, t = %g s\n", shorter_step, shorter_part * each->t_end);
  printf(" N   lambda_1(t)  |Q'Q-I|    |E-E0|\n");
  for (int n = 1; n <= ask->links; n++) print_shorter(&entries[n - 1]);
}

static int write_table(const char *path, const entry *entries, int links) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  fputs("N,table1,lambda_1,interval_mean,interval_half_width,step,energy_error,as_printed_orthogonality_lost,as_printed_end,"
        "as_printed_lambda_1,as_printed_orthogonality_error,as_printed_energy_error\n",
        o.file);
  for (int n = 1; n <= links; n++) {
    const run *r = &entries[n - 1].exponents, *p = &entries[n - 1].paper;
    fprintf(o.file, "%d,%g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", n, printed[n - 1], r->lambda[0], r->mean,
            r->half_width, r->step, r->worst_energy_error, p->t_orthogonality_lost, p->t, p->lambda[0], p->orthogonality_error,
            p->energy_error);
  }
  return output_commit(&o);
}

static int write_results(const table1_request *ask, const entry *entries) {
  const run *runs[TABLE1_LINKS], *printed_scheme[TABLE1_LINKS];
  int status = 0;
  for (int i = 0; i < ask->links; i++) runs[i] = &entries[i].exponents, printed_scheme[i] = &entries[i].shorter;
  if (ask->csv != NULL && write_table(ask->csv, entries, ask->links) != 0) status = -1;
  if (ask->plot != NULL && figure_maximal(ask->plot, runs, ask->links) != 0) status = -1;
  if (ask->figures != NULL && folder_write(ask->figures, runs, printed_scheme, ask->links) != 0) status = -1;
  return status;
}

typedef bool entry_test(const entry *e);

static bool outside(const entry *e) { return e->exponents.blocks > 0 && !holds(e); }
static bool overflows(const entry *e) { return e->paper.end == RUN_OVERFLOWED; }

static bool refuted(const entry *e) { return outside(e) && overflows(e); }

/* At the shorter step the printed scheme keeps the energy but not Q. */
static bool loses(const entry *e) {
  const run *s = &e->shorter;
  bool kept_energy = s->worst_energy_error < notable_energy_error;
  return kept_energy && (s->end == RUN_OVERFLOWED || (s->end == RUN_COMPLETE && s->orthogonality_error > notable_loss));
}

/* And gives more than the exponent without an overflow. */
static bool inflated(const entry *e) {
  const run *s = &e->shorter, *r = &e->exponents;
  return loses(e) && s->end == RUN_COMPLETE && r->blocks > 0 && s->lambda[0] > r->mean + r->half_width;
}

/* "N = 1, 2" of the entries that pass the test. */
static void print_numbers(const entry *entries, int links, entry_test *test) {
  int seen = 0;
  for (int i = 0; i < links; i++)
    if (test(&entries[i])) printf("%s%d", seen++ > 0 ? ", " : "N = ", i + 1);
}

static bool any(const entry *entries, int links, entry_test *test) {
  for (int i = 0; i < links; i++)
    if (test(&entries[i])) return true;
  return false;
}

static void print_sentence(const char *before, const entry *entries, int links, entry_test *test, const char *after) {
  if (!any(entries, links, test)) return;
  printf(" %s ", before);
  print_numbers(entries, links, test);
  printf("%s\n", after);
}

/* One link is not chaotic: its lambda_1 falls as ln(t)/t. */
static void print_one_link(const run *r) {
  long half = r->nrow / 2;
  if (half == 0 || r->end != RUN_COMPLETE) return;
  const double *row = r->rows + (half - 1) * run_width(r);
  printf(" One link is not chaotic: lambda_1 falls to zero, %.2g at %g s and %.2g at %g s.\n", row[1], row[0], r->lambda[0], r->t);
}

/* What the numbers say; every sentence follows from the entries. */
static void print_reading(const entry *entries, int links) {
  putchar('\n');
  print_sentence("Table 1 is inside the interval of the exponent for", entries, links, holds, ".");
  print_sentence("Table 1 is outside the interval of the exponent for", entries, links, outside, ".");
  print_one_link(&entries[0].exponents);
  print_sentence("The printed scheme overflows at the stated step, so that it cannot have given Table 1, for", entries, links,
                 overflows, ".");
  print_sentence("At the shorter step it keeps the energy and still loses the orthogonality of Q, or overflows, for", entries, links,
                 loses, ".");
  print_sentence("Without the orthogonality it gives more than the exponent for", entries, links, inflated, ".");
  print_sentence("So the values of Table 1 are not the exponents of this system for", entries, links, refuted,
                 ";\n lost orthogonality is their likely source, which these numbers suggest and do not prove.");
}

static int conclusion(const entry *entries, int links) {
  int status = EXIT_DONE;
  for (int i = 0; i < links; i++) {
    const run *r = &entries[i].exponents;
    if (r->end == RUN_FAILED || r->end == RUN_OVERFLOWED) {
      run_complain(r);
      status = EXIT_FAILED;
    }
  }
  if (!interrupted()) return status;
  complain("stopped by the user; the table holds what there was by then");
  return EXIT_INTERRUPTED;
}

int table1(const table1_request *ask) {
  entry entries[TABLE1_LINKS] = {0};
  double seconds = compute(ask, entries);
  print_tables(ask, entries);
  print_reading(entries, ask->links);
  printf("\n%.0f s of computing\n", seconds);
  int status = conclusion(entries, ask->links);
  if (write_results(ask, entries) != 0) status = EXIT_FAILED;
  for (int i = 0; i < ask->links; i++) {
    run_free(&entries[i].exponents);
    run_free(&entries[i].paper);
    run_free(&entries[i].shorter);
  }
  return status;
}
