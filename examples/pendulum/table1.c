/* The paper's Table 1 beside what its own scheme gives and beside the exponents. */
#include "table1.h"

#include "csv.h"
#include "figures.h"
#include "folder.h"
#include "host/message.h"
#include "host/output.h"
#include "motion.h"
#include "workers.h"

#include <math.h>

/* Table 1 as printed in the paper: the maximal exponent for N = 1..6, 1/s. */
static const double printed[TABLE1_LINKS] = {3e-5, 0.1, 0.8, 1.4, 2.2, 3.1};

/* A step at which the printed scheme need not overflow, s, and the part of t_end over which it is followed. */
static const double shorter_step = 0.002, shorter_part = 0.5;

/* A value is held against an interval only where it is further than this many half-widths from its middle: motion that wanders slowly
 * between regions, as that of two links does, moves the mean of 1000 s by more than its own blocks tell. */
static const double doubt = 2.0;

/* An orthogonality error that is more than rounding and the error of a step: directions off by a degree. */
static const double notable_loss = 0.02;

/* An energy error, J, that is more than a good trajectory has: a millionth of the energy of one link. */
static const double notable_energy_error = 1e-5;

/* Two angles, degrees, that differ by less are the same start. */
static const double same_angle = 1e-9;

/* What lambda_1 of one link must lose while the time doubles to be called falling; ln(t)/t loses nearly half. */
static const double falling_part = 0.25;

enum { TIME_SIZE = 40 };

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

static double degrees(const run_request *each) { return each->theta0 * 180.0 / acos(-1.0); }

static bool paper_start(const run_request *each) { return fabs(degrees(each) - paper_theta0) < same_angle; }

static bool entry_stopped(const entry *e) {
  return e->exponents.end == RUN_INTERRUPTED || e->paper.end == RUN_INTERRUPTED || e->shorter.end == RUN_INTERRUPTED ||
         e->paper_motion.status == EOM_STOPPED;
}

/* Whether the user has ended any run before its time. */
static bool stopped(const entry *entries, int links) {
  for (int i = 0; i < links; i++)
    if (entry_stopped(&entries[i])) return true;
  return false;
}

/* Whether there is an interval of the exponent, over the whole time. */
static bool has_interval(const entry *e) { return e->exponents.end == RUN_COMPLETE && e->exponents.blocks > 0; }

/* Whether the printed value is near the interval of the exponent; false where there is no interval. */
static bool holds(const entry *e) {
  const run *r = &e->exponents;
  return has_interval(e) && fabs(printed[r->ask.links - 1] - r->mean) <= doubt * r->half_width;
}

/* How a run that has not come to its end came to it; empty for the others. */
static const char *early_end(const run *r, char *text) {
  static const char *const how[] = {
      [RUN_INTERRUPTED] = "stopped at", [RUN_OVERFLOWED] = "overflowed after", [RUN_FAILED] = "failed after"};
  text[0] = '\0';
  if (r->end != RUN_COMPLETE) snprintf(text, TIME_SIZE, "%s %g s", how[r->end], r->t);
  return text;
}

/* The last column: the time where the run ended early, else what the interval says of Table 1; empty where there is nothing to say. */
static const char *verdict(const entry *e, char *text) {
  if (e->exponents.end != RUN_COMPLETE) return early_end(&e->exponents, text);
  if (!paper_start(&e->exponents.ask)) return "";
  return !has_interval(e) ? "-" : holds(e) ? "inside" : "outside";
}

static void print_exponents(const entry *e) {
  const run *r = &e->exponents;
  char text[TIME_SIZE];
  printf(" %d ", r->ask.links);
  if (paper_start(&r->ask)) printf("  %7g ", printed[r->ask.links - 1]);
  printf("  %9.5f ", r->lambda[0]);
  if (r->blocks > 0)
    printf("  %8.4f .. %-8.4f", r->mean - r->half_width, r->mean + r->half_width);
  else
    printf("  %-20s", "too short a run");
  const char *last = verdict(e, text);
  printf("  %-8.3g  %.1e%s%s\n", r->step, r->worst_energy_error, *last != '\0' ? "   " : "", last);
}

/* When something happened in a run, s; negative: never, or not in the time that the run reached. */
static void print_when(const run *r, double t) {
  char text[TIME_SIZE];
  snprintf(text, sizeof text, "not by %g", r->t);
  if (t < 0.0)
    printf("  %-12s", text);
  else
    printf("  %-12g", t);
}

static void print_paper(const entry *e) {
  const run *r = &e->paper;
  const motion *m = &e->paper_motion;
  char text[TIME_SIZE];
  printf(" %d ", r->ask.links);
  print_when(r, r->t_orthogonality_lost);
  print_when(r, r->end == RUN_OVERFLOWED ? r->t : -1.0);
  printf("  %-11.3g %8.1e   %8.1e", r->lambda[0], r->orthogonality_error, r->energy_error);
  if (m->status == EOM_OK || m->status == EOM_STOPPED)
    printf("   %.1e J in %g s", m->worst_energy_error, m->t);
  else
    printf("   overflows after %g s", m->t);
  if (m->status == EOM_STOPPED) printf(" (stopped)");
  if (r->end == RUN_INTERRUPTED || r->end == RUN_FAILED) printf("; Q %s", early_end(r, text));
  putchar('\n');
}

static void print_shorter(const entry *e) {
  const run *r = &e->shorter;
  char text[TIME_SIZE];
  if (r->end == RUN_OVERFLOWED)
    printf(" %d   Q overflows after %g s\n", r->ask.links, r->t);
  else
    printf(" %d   %9.5f   %8.1e   %8.1e%s%s\n", r->ask.links, r->lambda[0], r->orthogonality_error, r->worst_energy_error,
           r->end != RUN_COMPLETE ? "   " : "", early_end(r, text));
}

static void print_exponents_head(const run_request *each) {
  bool compared = paper_start(each);
  if (each->step > 0.0)
    printf(" Q re-orthonormalised, step %g s\n", each->step);
  else
    printf(" Q re-orthonormalised, steps chosen so that |E-E0| stays below %g J\n", energy_bound);
  printf(" N %s  lambda_1(t)  95 %% interval         mean step |E-E0|%s\n", compared ? "  Table 1" : "",
         compared ? "    Table 1 is" : "");
}

static void print_tables(const table1_request *ask, const entry *entries) {
  const run_request *each = &ask->each;
  const char *on_the_way = stopped(entries, ask->links) ? "stopped on the way to " : "";
  printf("Maximal Lyapunov exponent of the planar N-pendulum from its Lagrangian, 1/s; %st = %g s\n", on_the_way, each->t_end);
  printf("m = l = 1, g = 9.81, theta_1(0) = %g deg, all else 0\n\n", degrees(each));
  print_exponents_head(each);
  for (int n = 1; n <= ask->links; n++) print_exponents(&entries[n - 1]);
  printf("\n The paper's scheme as printed (eqs 75-80, Q never re-orthonormalised) at its stated step of %g s\n", paper_step);
  printf("    |Q'Q-I| > 1   Q overflows   just before, or at the end           the trajectory alone\n");
  printf(" N  after, s      after, s      lambda_1     |Q'Q-I|    |E-E0|     |E-E0|\n");
  for (int n = 1; n <= ask->links; n++) print_paper(&entries[n - 1]);
  printf("\n The same at a step of %g s, %st = %g s\n", shorter_step, on_the_way, shorter_part * each->t_end);
  printf(" N   lambda_1(t)  |Q'Q-I|    |E-E0|\n");
  for (int n = 1; n <= ask->links; n++) print_shorter(&entries[n - 1]);
}

static int write_table(const char *path, const entry *entries, int links) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  fputs("N,table1,t,lambda_1,interval_mean,interval_half_width,step,energy_error,as_printed_orthogonality_lost,as_printed_end,"
        "as_printed_lambda_1,as_printed_orthogonality_error,as_printed_energy_error\n",
        o.file);
  for (int n = 1; n <= links; n++) {
    const run *r = &entries[n - 1].exponents, *p = &entries[n - 1].paper;
    fprintf(o.file, "%d,", n);
    if (paper_start(&r->ask)) fprintf(o.file, "%g", printed[n - 1]);
    fprintf(o.file, ",%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,%.17g\n", r->t, r->lambda[0], r->mean, r->half_width,
            r->step, r->worst_energy_error, p->t_orthogonality_lost, p->t, p->lambda[0], p->orthogonality_error, p->energy_error);
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

static bool outside(const entry *e) { return has_interval(e) && !holds(e); }
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
  return loses(e) && s->end == RUN_COMPLETE && has_interval(e) && s->lambda[0] > r->mean + doubt * r->half_width;
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
  if (!(r->lambda[0] < (1.0 - falling_part) * row[1])) return;
  printf(" One link is not chaotic: lambda_1 falls with time, %.2g at %g s and %.2g at %g s.\n", row[1], row[0], r->lambda[0], r->t);
}

/* For what the reading holds: Table 1 has a start and a time of its own. */
static void print_scope(const run_request *each) {
  if (!paper_start(each))
    printf(" Table 1 starts from theta_1(0) = %g deg, these runs from %g deg: its column and what it would say are left out.\n",
           paper_theta0, degrees(each));
  else if (each->t_end < paper_time)
    printf(" Table 1 is of %g s, these runs are of %g s: what follows holds for %g s.\n", paper_time, each->t_end, each->t_end);
}

/* Table 1 beside the intervals. */
static void print_comparison(const entry *entries, int links) {
  print_sentence("Table 1 is inside twice the interval of the exponent for", entries, links, holds, ".");
  print_sentence("Table 1 is outside twice the interval of the exponent for", entries, links, outside, ".");
}

/* What becomes of the printed scheme; an overflow within a shorter time is one within the paper's too. */
static void print_scheme_reading(const entry *entries, int links, bool compared) {
  print_sentence(compared ? "The printed scheme overflows at the stated step, so that it cannot have given Table 1, for"
                          : "The printed scheme overflows at the stated step for",
                 entries, links, overflows, ".");
  print_sentence("At the shorter step it keeps the energy and still loses the orthogonality of Q, or overflows, for", entries, links,
                 loses, ".");
  print_sentence("Without the orthogonality it gives more than the exponent for", entries, links, inflated, ".");
}

/* What the numbers say; every sentence follows from the entries. */
static void print_reading(const run_request *each, const entry *entries, int links) {
  bool compared = paper_start(each);
  putchar('\n');
  if (stopped(entries, links)) {
    puts(" Some runs did not reach their end: no conclusions are drawn.");
    return;
  }
  print_scope(each);
  if (compared) print_comparison(entries, links);
  print_one_link(&entries[0].exponents);
  print_scheme_reading(entries, links, compared);
  if (compared && each->t_end < paper_time)
    printf(" What the intervals of %g s would say of Table 1 is left open.\n", paper_time);
  else if (compared)
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
  if (!stopped(entries, links)) return status;
  complain("stopped by the user; the table holds what there was by then");
  return EXIT_INTERRUPTED;
}

int table1(const table1_request *ask) {
  entry entries[TABLE1_LINKS] = {0};
  double seconds = compute(ask, entries);
  print_tables(ask, entries);
  print_reading(&ask->each, entries, ask->links);
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
