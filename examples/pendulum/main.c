/* pendulum: the Lyapunov exponents of the planar N-pendulum, computed from nothing but its Lagrangian in plain C. */
#include "csv.h"
#include "figures.h"
#include "folder.h"
#include "host/gnuplot.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/options.h"
#include "table1.h"
#include "workers.h"

#include <math.h>
#include <unistd.h>

const char program[] = "pendulum";

static const double most_steps = 1e12; /* of one run: more would take years */
static const double most_rows = 1e7;   /* of one run: they are kept in memory */

static const char *const scheme_names[] = {"paper", "continuous", "discrete", NULL};
static const eom_lyapunov_scheme schemes[] = {EOM_LYAPUNOV_PAPER, EOM_LYAPUNOV_CONTINUOUS, EOM_LYAPUNOV_DISCRETE};

static const manual text = {
    .summary = "Integrates a chain of N links (1 kg, 1 m each; g = 9.81 m/s^2) from rest and computes all its 2N Lyapunov\n"
               "exponents on the way. The first link starts at an angle from the downward vertical, the others hang down.\n"
               "Ctrl-C ends a run early; what there is by then is written.\n",
    .examples =
        "  pendulum                                   two links, 100 s\n"
        "  pendulum --links 4 --csv p4.csv --plot p4.svg\n"
        "  pendulum --scheme paper --t-end 10         the paper's scheme, which soon overflows; with --step 0.0005 it does not\n"
        "  pendulum --table1 --figures out            Table 1 and all figures; half a minute\n"
        "  pendulum --table1 --t-end 100              the same in seconds, with wider intervals\n",
};

/* The command line. Zero stands for a default that depends on other options. */
typedef struct command {
  int links, scheme;
  double t_end, step, theta0, every;
  const char *csv, *plot, *figures;
  bool table1;
} command;

static command read_command(int argc, char **argv) {
  command c = {.scheme = 2, .theta0 = paper_theta0, .every = 0.5};
  const option table[] = {
      {.name = "--links",
       .kind = OPTION_COUNT,
       .value = &c.links,
       .least = 1,
       .most = PENDULUM_MAX_LINKS,
       .operand = "N",
       .help = "number of links; default 2, with --table1 the largest, default 6"},
      {.name = "--t-end",
       .kind = OPTION_ABOVE,
       .value = &c.t_end,
       .most = HUGE_VAL,
       .operand = "T",
       .help = "length of the motion, s; default 100, with --table1 1000"},
      {.name = "--step",
       .kind = OPTION_ABOVE,
       .value = &c.step,
       .most = HUGE_VAL,
       .operand = "H",
       .help = "fixed step of the integration by the fifth-order method, s; default: steps\n"
               "of order 8, chosen so that the energy error stays below 1e-6 J; with\n"
               "--scheme paper 0.05, as in the paper"},
      {.name = "--theta0",
       .kind = OPTION_REAL,
       .value = &c.theta0,
       .least = -HUGE_VAL,
       .most = HUGE_VAL,
       .operand = "DEG",
       .help = "angle of the first link at the start, degrees; default 75"},
      {.name = "--scheme",
       .kind = OPTION_CHOICE,
       .value = &c.scheme,
       .choices = scheme_names,
       .operand = "paper|continuous|discrete",
       .help = "\npaper: eqs 75-80 as printed, Q is never re-orthonormalised;\n"
               "continuous: the same, Q re-orthonormalised after each step;\n"
               "discrete (default): tangent map and Householder QR"},
      {.name = "--every",
       .kind = OPTION_ABOVE,
       .value = &c.every,
       .most = HUGE_VAL,
       .operand = "DT",
       .help = "time from row to row of the CSV file and the plots, s; default 0.5"},
      {.name = "--csv",
       .kind = OPTION_TEXT,
       .value = &c.csv,
       .operand = "FILE",
       .help = "write the rows: t, lambda_1..lambda_2N (1/s), mean_1.., half_width_1.. of their\n"
               "95 % intervals so far, energy_error |E-E0| (J), orthogonality_error max|Q'Q-I|;\n"
               "with --table1 the table"},
      {.name = "--plot",
       .kind = OPTION_TEXT,
       .value = &c.plot,
       .operand = "FILE",
       .help = "draw the exponents against time (.svg or .png, needs gnuplot);\n"
               "with --table1 the maximal exponent for each N"},
      {.name = "--figures",
       .kind = OPTION_TEXT,
       .value = &c.figures,
       .operand = "DIR",
       .help = "write all figures and the rows of every run into a folder"},
      {.name = "--table1",
       .kind = OPTION_FLAG,
       .value = &c.table1,
       .help = "the paper's Table 1 for N = 1 to 6 beside its own scheme and the exponents"},
  };
  read_options(argc, argv, table, sizeof table / sizeof table[0], &text);
  return c;
}

/* A figure of one row would be a point. */
static void check_rows(const command *c) {
  if ((c->plot != NULL || c->figures != NULL) && c->t_end <= c->every)
    usage_error("--every %g makes one row in %g s, and a figure needs two; take a shorter --every", c->every, c->t_end);
}

/* One output must not overwrite another. */
static void check_files(const command *c) {
  const char *const name[] = {"--csv", "--plot"}, *const file[] = {c->csv, c->plot};
  if (c->csv != NULL && c->plot != NULL && output_same(c->csv, c->plot))
    usage_error("--csv %s and --plot %s are the same file", c->csv, c->plot);
  for (int i = 0; i < 2; i++)
    if (c->figures != NULL && file[i] != NULL && folder_writes(c->figures, file[i], c->links))
      usage_error("%s %s is the same file as one that --figures %s writes", name[i], file[i], c->figures);
}

/* Fills the defaults and refuses what does not fit together. */
static run_request complete(command *c) {
  if (c->links == 0) c->links = c->table1 ? TABLE1_LINKS : 2;
  if (c->t_end == 0.0) c->t_end = c->table1 ? paper_time : 100.0;
  if (c->step == 0.0 && schemes[c->scheme] == EOM_LYAPUNOV_PAPER) c->step = fmin(paper_step, c->t_end);
  if (c->table1 && c->links > TABLE1_LINKS) usage_error("--links %d: the paper's Table 1 ends at N = %d", c->links, TABLE1_LINKS);
  if (c->table1 && schemes[c->scheme] == EOM_LYAPUNOV_PAPER)
    usage_error("--scheme paper: --table1 shows the paper's scheme in any case; leave --scheme out");
  if (c->step > c->t_end) usage_error("--step %g is longer than the motion; take a shorter step or --t-end %g", c->step, c->step);
  if (c->step > c->every) usage_error("--every %g is shorter than a step; take --every %g or a shorter --step", c->every, c->step);
  if (c->step > 0.0 && c->t_end / c->step > most_steps)
    usage_error("--step %g: that makes more than %g steps; take a longer step or a shorter --t-end", c->step, most_steps);
  if (c->t_end / c->every > most_rows)
    usage_error("--every %g: that makes more than %g rows; take a longer --every", c->every, most_rows);
  check_figure_name("--plot", c->plot);
  check_rows(c);
  check_files(c);
  return (run_request){.links = c->links,
                       .theta0 = c->theta0 * acos(-1.0) / 180.0,
                       .t_end = c->t_end,
                       .step = c->step,
                       .every = c->every,
                       .scheme = schemes[c->scheme]};
}

static void print_run(const run *r, double seconds) {
  printf("Planar pendulum, N = %d: %ld rows to t = %g s in steps of %.6g s; %.1f s of computing\n\n", r->ask.links, r->nrow, r->t,
         r->step, seconds);
  for (int i = 0; i < 2 * r->ask.links; i++) printf("  lambda_%-2d %12.8f 1/s\n", i + 1, r->lambda[i]);
  if (r->blocks > 0) printf("\n  lambda_1 = %.4g +- %.2g 1/s (95 %%, from %d blocks of time)\n", r->mean, r->half_width, r->blocks);
  printf("\nChecks (each is zero in exact arithmetic, the pairing as t grows)\n");
  printf("  sum of the exponents - mean divergence  %9.1e 1/s\n", r->sum_error);
  printf("  largest lambda_i + lambda_(2N+1-i)      %9.1e 1/s\n", r->pairing_error);
  printf("  largest |E - E0|                        %9.1e J\n", r->worst_energy_error);
  printf("  |Q'Q - I| at the end                    %9.1e\n", r->orthogonality_error);
}

static void do_run(void *data) { run_do(data); }

static int exit_status(const run *r) {
  return r->end == RUN_COMPLETE ? EXIT_DONE : r->end == RUN_INTERRUPTED ? EXIT_INTERRUPTED : EXIT_FAILED;
}

/* One run with its outputs. The CSV file is begun first, so that a place that cannot be written to costs no computing. */
static int single(const command *c, run_request ask) {
  output csv;
  run r = {.ask = ask};
  const run *const runs[] = {&r};
  const task only = {do_run, &r, 1.0, &r.done};
  if (c->csv != NULL && csv_begin(&csv, c->csv, ask.links) != 0) return EXIT_FAILED;
  double seconds = do_tasks(&only, 1, program);
  run_complain(&r);
  int status = exit_status(&r);
  if (r.nrow > 0) print_run(&r, seconds);
  if (c->csv != NULL && csv_end(&csv, &r) != 0) status = EXIT_FAILED;
  if (r.nrow > 0 && c->plot != NULL && figure_spectrum(c->plot, &r) != 0) status = EXIT_FAILED;
  if (c->figures != NULL && folder_write(c->figures, runs, NULL, 1) != 0) status = EXIT_FAILED;
  run_free(&r);
  return status;
}

/* Sees before any computing that every output can be made. Returns 0, or -1 after a message; then nothing new is left behind. */
static int prepare(const command *c) {
  bool made = false;
  if ((c->plot != NULL || c->figures != NULL) && find_gnuplot() != 0) return -1;
  if (c->figures != NULL && folder_make(c->figures, &made) != 0) return -1;
  if ((c->csv == NULL || output_check(c->csv) == 0) && (c->plot == NULL || output_check(c->plot) == 0)) return 0;
  if (made) rmdir(c->figures);
  return -1;
}

int main(int argc, char **argv) {
  command c = read_command(argc, argv);
  run_request ask = complete(&c);
  watch_interrupts();
  if (prepare(&c) != 0) return EXIT_FAILED;
  int status;
  if (c.table1)
    status = table1(&(table1_request){.links = c.links, .each = ask, .csv = c.csv, .plot = c.plot, .figures = c.figures});
  else
    status = single(&c, ask);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
