/* eom lyapunov: Lyapunov exponents along a motion, with intervals, checks and checkpoints. */
#include "eom/lyapunov.h"

#include "checkpoint.h"
#include "command.h"
#include "eom/assemble.h"
#include "eom/trajectory.h"
#include "files.h"
#include "host/gnuplot.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/progress.h"
#include "method.h"
#include "series.h"
#include "setup.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { OWN_OPTIONS = 18 };

static const char *const scheme_names[] = {"discrete", "continuous", "paper", NULL};
static const eom_lyapunov_scheme schemes[] = {EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_CONTINUOUS, EOM_LYAPUNOV_PAPER};
static const double most_rows = 1e8;

/* A row's part of the power below this, in parts of what it is the sum of, is none. */
static const double no_power = 1e-9;

/* A run can be stopped and saved at a mark only: so many steps may lie between two, and rows are every c->marks of them. */
enum { MOST_STEPS = 1000 };
static const long most_marks = 1L << 40;
static const char default_method[] = "dop853";
static const char marks_name[] = "marks from row to row";

typedef struct command {
  setup s;
  int scheme, exponents;
  const char *method, *csv, *npz, *plot, *checkpoint;
  double t_end, every, step, rtol, atol, tangents, until, after, seconds;
  bool resume, replace;
  long marks;  /* from row to row */
  char *terms; /* see checkpoint.h */
} command;

/* A run under way. */
typedef struct course {
  const command *c;
  eom_lyapunov *ly;
  series rows;
  progress line;
  double saved; /* monotonic time of the last checkpoint, s */
  bool failed;  /* to write one, or for memory */
} course;

static const char summary[] =
    "Lyapunov exponents of y = (q,qd) along the motion from the start: k tangents follow it and are made orthonormal again\n"
    "and again. Prints each exponent with its 95 % interval from means over blocks of time, and checks that tell whether the\n"
    "numbers can be trusted: the sum against the mean divergence, the pairing, the exponents that must be zero, the energy,\n"
    "Q'Q - I. On constraints there are only the exponents of motions that these allow. With --checkpoint a run survives\n"
    "anything: the same command with --resume goes on where the file was written, to the same bits as one never stopped.\n\n";

static const char examples[] = "  eom lyapunov pendulum.so --start double.txt --t-end 1000 --csv history.csv --plot exponents.svg\n"
                               "  eom lyapunov pendulum.so --start sixteen.txt --exponents 1 --t-end 1e4 --until 0.01\n"
                               "  eom lyapunov pendulum.so --start six.txt --t-end 1e5 --checkpoint six.run --resume\n";

static void read_command(command *c, int argc, char **argv) {
  char whole[4096];
  option table[SETUP_OPTIONS + OWN_OPTIONS];
  const option own[OWN_OPTIONS] = {
      setup_t_end(&c->t_end, "time at the end, s; before --t0: backwards; default 100"),
      setup_every(&c->every, "time from row to row of the history, s; default: a thousand rows"),
      {.name = "--exponents",
       .kind = OPTION_COUNT,
       .value = &c->exponents,
       .least = 1,
       .most = 1e6,
       .operand = "K",
       .help = "the first K exponents only; default: all"},
      {.name = "--scheme",
       .kind = OPTION_CHOICE,
       .value = &c->scheme,
       .choices = scheme_names,
       .operand = "discrete|continuous|paper",
       .help = "\ndiscrete (default): tangent map and Householder QR; continuous:\nQ and rho as unknowns, Q re-orthonormalised; paper: "
               "eqs 75-80,\nQ never re-orthonormalised"},
      method_name(&c->method,
                  "one of the library's own: dop853 (default), dp5, rk4;\nor taylor for the motion, and dop853 for the tangents"),
      method_rtol(&c->rtol, "relative tolerance of the motion; default 1e-10"),
      method_atol(&c->atol, "absolute tolerance of the motion; default 1e-10"),
      {.name = "--tangents",
       .kind = OPTION_ABOVE,
       .value = &c->tangents,
       .most = HUGE_VAL,
       .operand = "TOL",
       .help = "tolerance of the tangents; default 1e-7"},
      method_step(&c->step, "fixed steps of at most H s in the place of tolerances"),
      {.name = "--until",
       .kind = OPTION_ABOVE,
       .value = &c->until,
       .most = HUGE_VAL,
       .operand = "W",
       .help = "end earlier, once lambda_1 is known to +- W 1/s,"},
      {.name = "--after",
       .kind = OPTION_REAL,
       .value = &c->after,
       .most = HUGE_VAL,
       .operand = "T",
       .help = "but not before this much time, s; default 0"},
      {.name = "--csv",
       .kind = OPTION_TEXT,
       .value = &c->csv,
       .operand = "FILE",
       .help = "write the history: t, lambda_1.., energy_error"},
      {.name = "--npz",
       .kind = OPTION_TEXT,
       .value = &c->npz,
       .operand = "FILE",
       .help = "write it for numpy.load: t, lambda, energy_error, and mean,\nhalf_width, Q"},
      {.name = "--plot",
       .kind = OPTION_TEXT,
       .value = &c->plot,
       .operand = "FILE",
       .help = "draw the history (.svg or .png, needs gnuplot)"},
      {.name = "--checkpoint",
       .kind = OPTION_TEXT,
       .value = &c->checkpoint,
       .operand = "FILE",
       .help = "keep the run there, whole at any moment: a new file, or one\nthat --resume goes on from"},
      {.name = "--save-every",
       .kind = OPTION_REAL,
       .value = &c->seconds,
       .most = HUGE_VAL,
       .operand = "S",
       .help = "seconds from checkpoint to checkpoint; default 30"},
      {.name = "--resume", .kind = OPTION_FLAG, .value = &c->resume, .help = "go on from the checkpoint, where there is one"},
      {.name = "--replace", .kind = OPTION_FLAG, .value = &c->replace, .help = "begin anew over a checkpoint that is there"},
  };
  setup_options(&c->s, table);
  memcpy(table + SETUP_OPTIONS, own, sizeof own);
  snprintf(whole, sizeof whole, "%s%s\nExit status: 0 done, 1 the run or an output failed, 2 wrong options, 130 Ctrl-C.\n", summary,
           setup_help);
  const manual text = {.command = "lyapunov", .operands = "MODEL.so ", .summary = whole, .examples = examples};
  setup_read(&c->s, argc, argv, table, (int)(sizeof table / sizeof table[0]), &text);
}

static wanted_files wanted(const command *c) {
  return (wanted_files){{{"--csv", c->csv}, {"--npz", c->npz}, {"--plot", c->plot}, {"--checkpoint", c->checkpoint}}};
}

/* The motion by Taylor series. */
static bool by_series(const command *c) { return c->method != NULL && strcmp(c->method, "taylor") == 0; }

static void check_command(command *c) {
  if (c->method != NULL && !by_series(c) && eom_method_find(c->method) == NULL)
    usage_error("--method %s: choose one of dop853, dp5, rk4, taylor", c->method);
  if (by_series(c) && c->step > 0.0) usage_error("--step: taylor chooses its steps itself; give --rtol and --atol");
  method_complete_tolerances(c->step, &c->rtol, &c->atol);
  if (c->resume && c->checkpoint == NULL) usage_error("--resume wants --checkpoint FILE");
  if (c->scheme == 2 && c->exponents != 0) usage_error("--exponents: the paper's scheme has all of them");
  check_figure_name("--plot", c->plot);
  files_distinct(wanted(c), &c->s);
  if (c->resume && c->replace) usage_error("--resume and --replace: one of them");
  if (c->replace && c->checkpoint == NULL) usage_error("--replace wants --checkpoint FILE");
  if (c->checkpoint != NULL && !c->resume && checkpoint_there(c->checkpoint) && !c->replace)
    usage_error("--checkpoint %s: there is one already; --resume goes on from it, --replace begins anew", c->checkpoint);
}

/* ---- terms ---- */

/* Everything that the bits of the run depend on. */
static char *make_terms(const command *c) {
  const setup *s = &c->s;
  const eom_description *d = s->model.description;
  char *text = NULL;
  size_t size;
  FILE *file = open_memstream(&text, &size);
  if (file == NULL) return complain("not enough memory"), NULL;
  fprintf(file, "model = %s\n", d->model->name);
  for (int i = 0; i < d->nparameter; i++)
    for (int k = 0; k < parameter_count(&d->parameter[i]); k++) {
      const eom_parameter *p = &d->parameter[i];
      fputs(p->name, file);
      if (p->count > 0) fprintf(file, "[%d]", k);
      fprintf(file, " = %.17g\n", parameter_value(&s->model, p, k));
    }
  fprintf(file, "--t0 = %.17g\n", s->t0);
  for (int i = 0; i < 2 * s->n; i++) fprintf(file, "%s = %.17g\n", component_name(s, i), s->q[i]);
  fprintf(file, "--scheme = %s\n--method = %s\n--exponents = %d\n", scheme_names[c->scheme],
          c->method != NULL ? c->method : default_method, c->exponents);
  fprintf(file, "--rtol = %.17g\n--atol = %.17g\n--tangents = %.17g\n--step = %.17g\n", c->rtol, c->atol, c->tangents, c->step);
  fprintf(file, "--every = %.17g\n%s = %ld\n", c->every, marks_name, c->marks);
  if (fclose(file) == 0) return text;
  free(text);
  return complain("not enough memory"), NULL;
}

/* ---- the run ---- */

static eom_lyapunov_options options_of(const command *c) {
  eom_lyapunov_options o = eom_lyapunov_options_default();
  o.scheme = schemes[c->scheme];
  o.k = c->exponents;
  o.method = c->method != NULL ? eom_method_find(c->method) : NULL;
  o.taylor = by_series(c);
  o.interval = copysign(c->every / (double)c->marks, c->t_end - c->s.t0);
  o.h = c->step;
  if (c->step == 0.0) o.control.rtol = c->rtol, o.control.atol = c->atol, o.tangent_tolerance = c->tangents;
  o.stop_half_width = c->until;
  o.stop_after = c->after;
  return o;
}

static int add_columns(series *rows, int k) {
  if (series_group_add(rows, "t", 0) != 0 || series_group_add(rows, "lambda", k) != 0) return -1;
  for (int i = 0; i < k; i++) snprintf(rows->name[1 + i], sizeof rows->name[0], "lambda_%d", i + 1);
  return series_group_add(rows, "energy_error", 0);
}

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int add_row(course *run) {
  const eom_lyapunov *ly = run->ly;
  double *row = series_row(&run->rows);
  if (row == NULL) return run->failed = true, -1;
  row[0] = ly->t;
  eom_lyapunov_exponents(ly, row + 1);
  row[1 + ly->k] = fabs(ly->energy - ly->energy0);
  return 0;
}

static int observe(void *observer, const eom_lyapunov *ly) {
  course *run = observer;
  const command *c = run->c;
  if (ly->marks % c->marks == 0 && add_row(run) != 0) return 1;
  progress_show(&run->line, program, (ly->t - ly->t0) / (c->t_end - ly->t0));
  if (c->checkpoint != NULL && seconds() - run->saved >= c->seconds) {
    if (checkpoint_write(c->checkpoint, c->terms, ly, &run->rows) != 0) return run->failed = true;
    run->saved = seconds();
  }
  return interrupted();
}

static int stop_at_most(void *steps, const eom_trajectory *trajectory) {
  (void)trajectory;
  return --*(int *)steps <= 0 || interrupted();
}

/* How far the motion alone comes in the first MOST_STEPS, s, or to the first row. What keeps it from going on the run itself will say.
 */
static double reach(const command *c) {
  const setup *s = &c->s;
  const eom_trajectory_options options = {.method = c->method != NULL ? c->method : default_method,
                                          .control = {.rtol = c->rtol, .atol = c->atol},
                                          .project = s->sys->m > 0};
  eom_trajectory *trajectory;
  int steps = MOST_STEPS;
  if (c->step > 0.0) return (double)MOST_STEPS * c->step;
  if (eom_trajectory_create(&trajectory, s->sys, &options, s->t0, s->q) != EOM_OK) return c->every;
  eom_trajectory_to(trajectory, s->t0 + copysign(c->every, c->t_end - s->t0), stop_at_most, &steps);
  const double way = fabs(eom_trajectory_time(trajectory) - s->t0);
  eom_trajectory_destroy(trajectory);
  return way > 0.0 ? way : c->every;
}

/* Marks from row to row: a power of 2, so that rows are at the same times for each. */
static long count_marks(const command *c) {
  const double way = reach(c);
  long marks = 1;
  while (c->every / (double)marks > way && marks < most_marks) marks *= 2;
  return marks;
}

/* The first row at or behind the end. */
static double last_row(const command *c) {
  const double nearly = 1e-6; /* of a row: rounding of t_end */
  const double way = c->t_end - c->s.t0;
  return c->s.t0 + copysign(ceil(fabs(way) / c->every - nearly) * c->every, way);
}

static int resume(const command *c, course *run) {
  if (checkpoint_read(c->checkpoint, c->terms, run->ly, &run->rows) != 0) return -1;
  const double ahead = copysign(1.0, c->t_end - c->s.t0) * (run->ly->t - last_row(c));
  if (ahead <= 1e-6 * c->every / (double)c->marks) return 0;
  complain("--t-end %g: the run of --checkpoint %s is at t = %.10g s already", c->t_end, c->checkpoint, run->ly->t);
  return -1;
}

static int start(const command *c, course *run) {
  const eom_lyapunov_options options = options_of(c);
  eom_status status = eom_lyapunov_create(&run->ly, c->s.sys, &options, c->s.t0, c->s.q);
  if (status == EOM_BAD_OPTION && by_series(c) && !(c->s.sys->motion && c->s.sys->motion->taylor)) {
    complain("--method taylor: the model has no motion functions of the need taylor at this size");
    return -1;
  }
  if (status == EOM_BAD_OPTION && c->exponents > 0) { /* the rest has been looked at */
    complain("--exponents %d: the constraints leave fewer", c->exponents);
    return -1;
  }
  if (status != EOM_OK) {
    complain_status(c->s.sys, status, "the run cannot be started");
    return -1;
  }
  if (add_columns(&run->rows, run->ly->k) != 0) return -1;
  return c->resume ? resume(c, run) : 0;
}

/* ---- what comes out ---- */

static void print_check(const char *name, double value, const char *unit) {
  if (value < 0.0) return; /* not known */
  if (value >= TL_MAX)
    printf("  %-44s overflow\n", name);
  else
    printf("  %-44s %9.1e %s\n", name, value, unit);
}

/* Whether the nonholonomic rows take part in the power at the start and now: lambda' A qd, where psi = 0 is not A qd = 0. */
static bool constraints_work(const course *run) {
  eom_system *sys = run->c->s.sys;
  const int n = sys->n;
  for (int now = 0; now < 2; now++) {
    const double *y = now ? run->ly->y : run->c->s.q, t = now ? run->ly->t : run->ly->t0;
    if (eom_assemble(sys, y, y + n, t) != EOM_OK) return true;
    for (int r = sys->m1; r < sys->m; r++) {
      double sum = 0.0, size = 0.0;
      for (int i = 0; i < n; i++) sum += sys->A[r * n + i] * y[n + i], size += fabs(sys->A[r * n + i] * y[n + i]);
      if (!(fabs(sum) <= no_power * size)) return true;
    }
  }
  return false;
}

static void print_run(const course *run) {
  const eom_lyapunov *ly = run->ly;
  const double *last = run->rows.rows + (run->rows.count - 1) * run->rows.width; /* of ly->t: see finish */
  eom_lyapunov_checks checks;
  printf("Lyapunov exponents from t = %g s to %.10g s, %s, by %s: %d of %d\n", ly->t0, ly->t, scheme_names[run->c->scheme],
         ly->it.method->name, ly->k, ly->d);
  for (int i = 0; i < ly->k; i++) {
    tl_real mean, half;
    const int blocks = eom_lyapunov_interval(ly, i, &mean, &half);
    printf("  lambda_%-3d %13.8f 1/s", i + 1, last[1 + i]);
    if (blocks > 0) printf("   %.4g +- %.2g (95 %%, %d blocks of time)", mean, half, blocks);
    putchar('\n');
  }
  eom_lyapunov_check(ly, &checks);
  printf("Checks (zero in exact arithmetic, exponents and pairs of them as t grows)\n");
  print_check("|sum of the exponents - mean divergence|", checks.sum_error, "1/s");
  print_check("|Q'Q - I|", checks.orthogonality, "");
  if (setup_driven(&run->c->s)) return; /* time alone moves it: no exponent need be zero */
  print_check("least |lambda_i|", checks.zero[0], "1/s");
  if (model_has_forces(&run->c->s.model) || constraints_work(run)) return; /* for these the rest is not zero */
  print_check("second least |lambda_i|", checks.zero[1], "1/s");
  if (run->c->s.sys->m2 == 0)
    print_check("largest |lambda_i + its partner|", checks.pairing_error, "1/s"); /* of Hamilton's equations */
  print_check("largest |E - E0|", checks.energy_error, "J");
}

static int write_npz(const course *run, const char *path) {
  const eom_lyapunov *ly = run->ly;
  const long k[] = {ly->k}, tall[] = {2 * run->c->s.n, ly->k};
  double *mean = calloc(2 * (size_t)ly->k, sizeof *mean), *half = mean != NULL ? mean + ly->k : NULL;
  npz z;
  int status = -1;
  for (int i = 0; mean != NULL && i < ly->k; i++)
    if (eom_lyapunov_interval(ly, i, &mean[i], &half[i]) == 0) half[i] = HUGE_VAL;
  if (mean != NULL && npz_open(&z, path) == 0 && series_npz(&run->rows, &z) == 0 && npz_add(&z, "mean", mean, 1, k, 0) == 0 &&
      npz_add(&z, "half_width", half, 1, k, 0) == 0 && npz_add(&z, "Q", ly->Q, 2, tall, 0) == 0)
    status = npz_close(&z);
  free(mean);
  return status;
}

enum { MOST_NAMES = 24 };

static int draw(const course *run, const char *path) {
  const series *r = &run->rows;
  const int k = run->ly->k;
  gnuplot g;
  if (r->count < 2) {
    complain("'%s' is left out: a curve needs two rows", path);
    return 0;
  }
  if (gnuplot_open(&g, path, 900, 540) != 0) return -1;
  fputs("$rows << EOD\n", g.script);
  double next = 0.0;
  for (long i = 0; i < r->count; i++) {
    const double *row = r->rows + i * r->width, t = fabs(row[0] - run->ly->t0);
    if (t < next && i + 1 < r->count) continue; /* closer points cannot be told apart on a logarithmic axis */
    next = 1.01 * t;
    fprintf(g.script, "%.8g", t);
    for (int j = 0; j < k; j++) fprintf(g.script, " %.6g", row[1 + j]);
    fputc('\n', g.script);
  }
  fprintf(g.script,
          "EOD\nset grid back linecolor '#d0d0d0' linewidth 0.5\nset border 3 back\nset tics nomirror out\n"
          "set key outside right center samplen 2\nset logscale x\nset format x '%%g'\nset xlabel 'time, s'\nset ylabel 'λᵢ(t), 1/s'\n"
          "set title 'Lyapunov exponents of %s'\nset xzeroaxis linecolor '#404040'\nunset colorbox\n"
          "set palette defined (0 '#b2182b', 0.35 '#ef8a62', 0.5 '#8a8a8a', 0.65 '#67a9cf', 1 '#2166ac')\n",
          run->c->s.model.description->model->name);
  for (int i = 0; i < k; i++) {
    fprintf(g.script, "%s$rows using 1:%d with lines linecolor palette frac %.4f linewidth 1.6", i == 0 ? "plot " : ", ", i + 2,
            k > 1 ? (double)i / (k - 1) : 0.0);
    if (i % (1 + k / MOST_NAMES) == 0)
      fprintf(g.script, " title 'λ %d'", i + 1);
    else
      fputs(" notitle", g.script);
  }
  fputc('\n', g.script);
  return gnuplot_close(&g);
}

static int write_all(const course *run) {
  const command *c = run->c;
  int status = 0;
  if (c->csv != NULL && series_csv(&run->rows, c->csv) != 0) status = -1;
  if (c->npz != NULL && write_npz(run, c->npz) != 0) status = -1;
  if (c->plot != NULL && draw(run, c->plot) != 0) status = -1;
  return status;
}

static int end_of(const course *run, eom_status status) {
  char what[96];
  if (run->failed) return EXIT_FAILED;
  if (status == EOM_OK) return EXIT_DONE;
  if (status == EOM_STOPPED) {
    complain("stopped by the user at t = %.6g s%s", run->ly->t, run->c->checkpoint != NULL ? "; --resume goes on from there" : "");
    return EXIT_INTERRUPTED;
  }
  snprintf(what, sizeof what, "the run failed behind t = %.10g s", run->ly->t);
  complain_status(run->c->s.sys, status, what);
  return EXIT_FAILED;
}

/* A run that ended between two rows shows where it ended; its checkpoint does not: going on, there will be no such row. */
static int finish(course *run) {
  const command *c = run->c;
  int status = 0;
  if (c->checkpoint != NULL && checkpoint_write(c->checkpoint, c->terms, run->ly, &run->rows) != 0) status = -1;
  if (run->ly->marks % c->marks != 0 && add_row(run) != 0) return -1;
  print_run(run);
  return write_all(run) == 0 ? status : -1;
}

static int follow(const command *c) {
  course run = {.c = c};
  int status = EXIT_FAILED;
  if (start(c, &run) == 0) {
    progress_start(&run.line);
    run.saved = seconds();
    const eom_status ended = eom_lyapunov_to(run.ly, last_row(c), observe, &run);
    progress_end(&run.line);
    status = end_of(&run, ended);
    if (run.ly->marks > 0 && finish(&run) != 0) status = EXIT_FAILED;
  }
  series_free(&run.rows);
  eom_lyapunov_destroy(run.ly);
  return status;
}

static int check_times(command *c) {
  const double way = fabs(c->t_end - c->s.t0);
  if (c->exponents > 2 * c->s.n) return complain("--exponents %d: this motion has %d at most", c->exponents, 2 * c->s.n), -1;
  if (c->scheme == 2 && c->s.sys->m > 0) return complain("--scheme paper: it is for models without constraints"), -1;
  if (way == 0.0) return complain("--t-end %g is the time of the start", c->t_end), -1;
  if (method_check_step(c->step, c->s.t0, c->t_end) != 0) return -1;
  if (c->every > way) return complain("--every %g is longer than the motion", c->every), -1;
  if (c->every == 0.0) c->every = checkpoint_term(c->terms, "--every");
  if (c->every == 0.0) c->every = way / 1000.0;
  if (way / c->every > most_rows) return complain("--every %g: that makes more than %g rows", c->every, most_rows), -1;
  return 0;
}

/* The terms of the checkpoint, where there is one, become those of this run. */
static int settle_terms(command *c) {
  c->marks = (long)checkpoint_term(c->terms, marks_name);
  if (c->marks < 1) c->marks = count_marks(c);
  free(c->terms);
  return (c->terms = make_terms(c)) != NULL ? 0 : -1;
}

static int begin(command *c) {
  if (c->resume && checkpoint_terms(c->checkpoint, &c->terms) != 0) return EXIT_FAILED;
  if (check_times(c) != 0) return refuse();
  setup_print(&c->s);
  if (setup_consistent(&c->s) != 0 || settle_terms(c) != 0) return EXIT_FAILED;
  if (!interrupted()) return follow(c);
  complain("stopped by the user at the start");
  return EXIT_INTERRUPTED;
}

int lyapunov_command(int argc, char **argv) {
  command c = {.t_end = 100.0, .rtol = -1.0, .atol = -1.0, .tangents = 1e-7, .seconds = 30.0};
  eom_options options = eom_options_default();
  read_command(&c, argc, argv);
  check_command(&c);
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_TANGENT;
  watch_interrupts();
  if (files_possible(wanted(&c)) != 0) return EXIT_FAILED;
  if (setup_load(&c.s, c.s.model.path, &options) != 0) return refuse();
  const int status = begin(&c);
  free(c.terms);
  setup_close(&c.s);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
