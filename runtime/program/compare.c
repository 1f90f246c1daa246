/* eom compare: methods and tolerances on one motion, time against true error. */
#include "command.h"
#include "eom/assemble.h"
#include "files.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/page.h"
#include "host/progress.h"
#include "method.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { OWN_OPTIONS = 8, MOST_METHODS = 24, MOST_LEVELS = 24, MOST_RUNS = MOST_METHODS * MOST_LEVELS };

/* The reference is computed at this part of the tightest tolerance, but not below what double precision can tell. */
static const double stricter = 1e-2, least_tolerance = 2e-14;

/* References that differ by more are none. */
static const double no_agreement = 0.1;

/* A run is repeated until it has taken this long in all, s, and at least so often: the fastest one counts. */
static const double enough_time = 0.05;

/* So long is what the clock of the processor's time tells, s: of runs that end earlier several are taken as one, at their mean. */
static const double measurable = 5e-4;

typedef struct command {
  setup s;
  const char *methods_text, *tolerances_text, *steps_text, *csv, *page;
  int repeats;
  double t_end;
  bool free;
  const eom_trajectory_method *method[MOST_METHODS];
  int methods;
  double tolerance[MOST_LEVELS], step[MOST_LEVELS];
  int tolerances, steps;
} command;

/* One method at one tolerance, or step where that is 0. */
typedef struct result {
  const eom_trajectory_method *method;
  double tolerance, step;
  double seconds, error, energy_error;
  double reached; /* s: where it ended */
  eom_trajectory_work work;
  eom_status status;
} result;

typedef struct comparison {
  command *c;
  eom_system *sys;   /* with all that an implicit method needs, */
  eom_system *plain; /* and without */
  double *reference; /* 2n at t_end */
  double scale[2];   /* the largest |q_i| and |qd_i| of the start and the reference */
  double agreement;  /* of two references by different methods; NaN where there is only one */
  const char *judges[2];
  double energy; /* of the reference at t_end, J */
  result *results;
  int count;
  progress line;
} comparison;

/* ---- the command line ---- */

static void read_command(command *c, int argc, char **argv) {
  char whole[8192];
  option table[SETUP_OPTIONS + OWN_OPTIONS];
  const option own[] = {
      setup_t_end(&c->t_end, "time at the end, s; default 10"),
      {.name = "--methods",
       .kind = OPTION_TEXT,
       .value = &c->methods_text,
       .operand = "NAME,..",
       .help = "default: all that there are"},
      {.name = "--tolerances",
       .kind = OPTION_TEXT,
       .value = &c->tolerances_text,
       .operand = "TOL,..",
       .help = "relative and absolute at once; default 1e-4,1e-6,..,1e-12"},
      {.name = "--steps",
       .kind = OPTION_TEXT,
       .value = &c->steps_text,
       .operand = "H,..",
       .help = "s, for methods that have fixed steps only; default: 100, 200,\n.., 3200 of them"},
      {.name = "--repeats",
       .kind = OPTION_COUNT,
       .value = &c->repeats,
       .least = 1,
       .most = 1000,
       .operand = "K",
       .help = "runs of each, of which the fastest counts; default 3"},
      {.name = "--no-projection", .kind = OPTION_FLAG, .value = &c->free, .help = "do not bring states back onto the constraints"},
      {.name = "--csv", .kind = OPTION_TEXT, .value = &c->csv, .operand = "FILE", .help = "write the table"},
      {.name = "--page",
       .kind = OPTION_TEXT,
       .value = &c->page,
       .operand = "FILE.html",
       .help = "write it with work-precision plots as one page for a browser"},
  };
  setup_options(&c->s, table);
  memcpy(table + SETUP_OPTIONS, own, sizeof own);
  snprintf(whole, sizeof whole,
           "Follows one motion by several methods at several tolerances, and prints of each the processor time, the true error\n"
           "at the end, the error of the energy and the steps. True: against a run at a tolerance a hundred times stricter; a\n"
           "second one by another method says how far that can be believed. The error is that of the worst component, in parts\n"
           "of the largest coordinate or velocity.\n\n%s\nMethods\n%s\n"
           "Exit status: 0 done, 1 no reference or an output failed, 2 wrong options, 130 Ctrl-C.\n",
           setup_help, method_list());
  const manual text = {
      .command = "compare",
      .operands = "MODEL.so ",
      .summary = whole,
      .examples = "  eom compare pendulum.so --start double.txt --t-end 5 --page double.html\n"
                  "  eom compare kepler.so --q 1,0 --qd 0,1 --methods dop853,dp5 --tolerances 1e-6,1e-9,1e-12 --csv kepler.csv\n",
  };
  setup_read(&c->s, argc, argv, table, SETUP_OPTIONS + OWN_OPTIONS, &text);
}

/* Positive numbers with commas between them. */
static int read_list(const char *option_name, const char *text, double *list) {
  int count = 0;
  for (const char *at = text; at != NULL && *at != '\0';) {
    char *end;
    const double x = strtod(at, &end);
    if (end == at || !(x > 0.0) || !isfinite(x) || (*end != ',' && *end != '\0'))
      usage_error("%s %s: numbers above zero with commas between them are wanted", option_name, text);
    if (count == MOST_LEVELS) usage_error("%s: at most %d of them", option_name, MOST_LEVELS);
    list[count++] = x;
    at = *end == ',' ? end + 1 : end;
  }
  return count;
}

static void read_methods(command *c) {
  char name[64];
  for (const char *at = c->methods_text; at != NULL && *at != '\0';) {
    const size_t length = strcspn(at, ",");
    if (length >= sizeof name || c->methods == MOST_METHODS) usage_error("--methods %s: too long", c->methods_text);
    memcpy(name, at, length);
    name[length] = '\0';
    c->method[c->methods++] = method_find("--methods", name);
    at += length + (at[length] == ',');
  }
  for (int i = 0; c->methods_text == NULL && c->methods < MOST_METHODS && eom_trajectory_method_at(i) != NULL; i++)
    c->method[c->methods++] = eom_trajectory_method_at(i);
}

static wanted_files wanted(const command *c) { return (wanted_files){{{"--csv", c->csv}, {"--page", c->page}}}; }

static void complete(command *c) {
  read_methods(c);
  c->tolerances =
      read_list("--tolerances", c->tolerances_text != NULL ? c->tolerances_text : "1e-4,1e-6,1e-8,1e-10,1e-12", c->tolerance);
  c->steps = read_list("--steps", c->steps_text, c->step);
  files_distinct(wanted(c), &c->s);
  bool fixed = false;
  for (int i = 0; i < c->methods; i++) fixed = fixed || !c->method[i]->chosen;
  if (c->steps > 0 && !fixed) usage_error("--steps: none of the methods takes fixed steps only");
}

/* ---- runs ---- */

static double seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int observe(void *observer, const eom_trajectory *trajectory) {
  (void)observer;
  (void)trajectory;
  return interrupted();
}

static eom_trajectory_options options_of(const comparison *k, const result *r) {
  return (eom_trajectory_options){.method = r->method->name,
                                  .control = {.rtol = r->tolerance, .atol = r->tolerance},
                                  .h = r->step,
                                  .project = k->plain->m > 0 && !k->c->free && r->method->projects};
}

/* Once from start to end, or to where it fails: y, 2n, and what it took. */
static eom_status once(const comparison *k, result *r, double *y) {
  const setup *s = &k->c->s;
  const eom_trajectory_options options = options_of(k, r);
  eom_trajectory *trajectory;
  const double began = seconds();
  eom_status status = eom_trajectory_create(&trajectory, r->method->implicit ? k->sys : k->plain, &options, s->t0, s->q);
  if (status != EOM_OK) return status;
  status = eom_trajectory_to(trajectory, k->c->t_end, observe, NULL);
  r->seconds = seconds() - began;
  r->reached = eom_trajectory_time(trajectory);
  r->work = eom_trajectory_worked(trajectory);
  memcpy(y, eom_trajectory_state(trajectory), 2 * (size_t)s->n * sizeof *y);
  eom_trajectory_destroy(trajectory);
  return status;
}

/* The largest difference of two states, coordinates and velocities each in parts of their scale. */
static double difference(const comparison *k, const double *a, const double *b) {
  const int n = k->c->s.n;
  double worst = 0.0;
  for (int i = 0; i < 2 * n; i++) {
    const double e = fabs(a[i] - b[i]) / k->scale[i >= n];
    if (!(e <= worst)) worst = e;
  }
  return worst;
}

static void set_scales(comparison *k) {
  const int n = k->c->s.n;
  for (int part = 0; part < 2; part++) {
    k->scale[part] = 0.0;
    for (int i = part * n; i < (part + 1) * n; i++)
      k->scale[part] = fmax(k->scale[part], fmax(fabs(k->reference[i]), fabs(k->c->s.q[i])));
    if (k->scale[part] == 0.0) k->scale[part] = 1.0;
  }
}

/* The first two of these that there are, by different methods, judge. Where two have found no step that is short enough, the motion
 * ends in a singularity, which some of the others would creep towards for ever. */
static int find_reference(comparison *k) {
  static const char *const judges[] = {"dop853", "dp5", "arkode_fehlberg8", "cvode_adams", "cvode_bdf"};
  command *c = k->c;
  double tightest = HUGE_VAL, *other = malloc(2 * (size_t)c->s.n * sizeof *other);
  char what[128] = "no reference";
  eom_status status = EOM_OK;
  int found = 0, lost = 0;
  for (int i = 0; i < c->tolerances; i++) tightest = fmin(tightest, c->tolerance[i]);
  for (size_t j = 0; other != NULL && found < 2 && lost < 2 && j < sizeof judges / sizeof judges[0] && !interrupted(); j++) {
    result r = {.method = NULL, .tolerance = fmax(tightest * stricter, least_tolerance)};
    for (int i = 0; eom_trajectory_method_at(i) != NULL; i++)
      if (strcmp(eom_trajectory_method_at(i)->name, judges[j]) == 0) r.method = eom_trajectory_method_at(i);
    if (r.method == NULL) continue;
    const eom_status ended = once(k, &r, found == 0 ? k->reference : other);
    if (ended == EOM_OK)
      k->judges[found++] = r.method->name;
    else if (status == EOM_OK) {
      const bool reported = ended == EOM_RHS_FAILED && k->plain->report.status != EOM_OK;
      status = reported ? k->plain->report.status : ended;
      snprintf(what, sizeof what, "no reference: no method reaches the end at its tolerance; %s fails at t = %.10g s", judges[j],
               r.reached);
    }
    lost += ended == EOM_STEP_TOO_SMALL;
  }
  if (found > 0) {
    set_scales(k);
    status = eom_energy(k->plain, k->reference, k->reference + c->s.n, c->t_end);
    k->energy = k->plain->energy;
  }
  k->agreement = found == 2 ? difference(k, k->reference, other) : (double)NAN;
  free(other);
  if (interrupted()) return 0;
  if (found == 2 && !(k->agreement <= no_agreement)) {
    complain("no reference: %s and %s differ by %.1e at the end; take an earlier --t-end", k->judges[0], k->judges[1], k->agreement);
    return -1;
  }
  if (found > 0 && status == EOM_OK) return 0;
  complain_status(k->plain, status, what);
  return -1;
}

static void measure(comparison *k, result *r) {
  const command *c = k->c;
  double *state = malloc(2 * (size_t)c->s.n * sizeof *state);
  const double began = seconds();
  double fastest = HUGE_VAL;
  r->status = state == NULL ? EOM_NO_MEMORY : EOM_OK;
  for (int i = 0; r->status == EOM_OK && (i < c->repeats || seconds() - began < enough_time); i++) {
    double spent = 0.0;
    int runs = 0;
    for (; r->status == EOM_OK && spent < measurable; runs++) r->status = once(k, r, state), spent += r->seconds;
    fastest = fmin(fastest, spent / runs);
  }
  r->seconds = fastest;
  if (r->status == EOM_OK) {
    r->error = difference(k, state, k->reference);
    r->status = eom_energy(k->plain, state, state + c->s.n, c->t_end);
    r->energy_error = fabs(k->plain->energy - k->energy);
  }
  free(state);
}

/* Whether a method can follow this model at a tolerance, or with a step, is known by trying. */
static bool does(comparison *k, const eom_trajectory_method *by, double tolerance, double step) {
  const result r = {.method = by, .tolerance = tolerance, .step = step};
  const eom_trajectory_options options = options_of(k, &r);
  eom_trajectory *trajectory;
  const eom_status status = eom_trajectory_create(&trajectory, by->implicit ? k->sys : k->plain, &options, k->c->s.t0, k->c->s.q);
  eom_trajectory_destroy(trajectory);
  return status != EOM_BAD_OPTION;
}

static void plan(comparison *k) {
  command *c = k->c;
  for (int i = 0; c->steps == 0 && i < 6; i++) c->step[i] = fabs(c->t_end - c->s.t0) / (100 << i);
  if (c->steps == 0) c->steps = 6;
  for (int i = 0; i < c->methods; i++) {
    const bool tolerances = c->method[i]->chosen;
    if (!does(k, c->method[i], tolerances ? c->tolerance[0] : 0.0, tolerances ? 0.0 : c->step[0])) {
      complain("%s is left out: it cannot follow this model (%s)", c->method[i]->name, c->method[i]->text);
      continue;
    }
    for (int j = 0; j < (tolerances ? c->tolerances : c->steps); j++)
      k->results[k->count++] = (result){.method = c->method[i],
                                        .tolerance = tolerances ? c->tolerance[j] : 0.0,
                                        .step = tolerances ? 0.0 : copysign(c->step[j], c->t_end - c->s.t0)};
  }
}

static void run_all(comparison *k) {
  progress_start(&k->line);
  for (int i = 0; i < k->count && !interrupted(); i++) {
    measure(k, &k->results[i]);
    progress_show(&k->line, program, (i + 1.0) / k->count);
    if (interrupted()) k->count = i;
  }
  progress_end(&k->line);
}

/* ---- what comes out ---- */

#ifdef __clang__
static const char compiler[] = __VERSION__;
#else
static const char compiler[] = "gcc " __VERSION__;
#endif

enum { COLUMNS = 9, CELL = 32 };
static const char *const heads[COLUMNS + 1] = {
    "method", "tolerance", "step, s", "CPU time, ms", "error", "energy error, J", "steps", "refused", "evaluations",
};

/* A line of the table as texts. */
static void cells_of(const result *r, char cell[COLUMNS][CELL]) {
  const bool good = r->status == EOM_OK;
  memset(cell, 0, COLUMNS * sizeof cell[0]);
  snprintf(cell[0], CELL, "%s", r->method->name);
  if (r->tolerance > 0.0) snprintf(cell[1], CELL, "%.0e", r->tolerance);
  if (r->tolerance == 0.0) snprintf(cell[2], CELL, "%.4g", fabs(r->step));
  if (!good) {
    snprintf(cell[3], CELL, "failed");
    return;
  }
  snprintf(cell[3], CELL, "%.3f", 1e3 * r->seconds);
  snprintf(cell[4], CELL, "%.1e", r->error);
  snprintf(cell[5], CELL, "%.1e", r->energy_error);
  snprintf(cell[6], CELL, "%ld", r->work.steps);
  snprintf(cell[7], CELL, "%ld", r->work.rejected);
  snprintf(cell[8], CELL, "%ld", r->work.evaluations);
}

static void reference_text(const comparison *k, char *text, size_t size) {
  if (k->judges[1] != NULL)
    snprintf(text, size, "Reference: %s; it agrees with %s to %.1e: errors below that say nothing.", k->judges[0], k->judges[1],
             k->agreement);
  else
    snprintf(text, size, "Reference: %s alone; no other method reached the end to confirm it.", k->judges[0]);
}

static void print_table(const comparison *k) {
  static const int widths[COLUMNS] = {-16, 10, 10, 13, 9, 16, 9, 8, 12};
  char cell[COLUMNS][CELL], text[256];
  reference_text(k, text, sizeof text);
  printf("%s\n", text);
  for (int j = 0; j < COLUMNS; j++) printf("%*s%s", widths[j], heads[j], j + 1 < COLUMNS ? " " : "\n");
  for (int i = 0; i < k->count; i++) {
    cells_of(&k->results[i], cell);
    for (int j = 0; j < COLUMNS; j++) printf("%*s%s", widths[j], cell[j], j + 1 < COLUMNS ? " " : "\n");
  }
}

static int write_csv(const comparison *k, const char *path) {
  output o;
  if (output_open(&o, path) != 0) return -1;
  fputs("method,tolerance,step,seconds,error,energy_error,steps,refused,evaluations,status\n", o.file);
  for (int i = 0; i < k->count; i++) {
    const result *r = &k->results[i];
    const double numbers[] = {r->tolerance, fabs(r->step), r->status == EOM_OK ? r->seconds : 0.0, r->error, r->energy_error};
    fprintf(o.file, "%s,", r->method->name);
    for (size_t j = 0; j < sizeof numbers / sizeof *numbers; j++) {
      output_number(&o, numbers[j]);
      fputc(',', o.file);
    }
    fprintf(o.file, "%ld,%ld,%ld,%s\n", r->work.steps, r->work.rejected, r->work.evaluations,
            r->status == EOM_OK ? "ok" : eom_status_text(r->status));
  }
  return output_commit(&o);
}

/* What a plot takes from a result. */
typedef double quantity(const result *r);
static double milliseconds(const result *r) { return 1e3 * r->seconds; }
static double true_error(const result *r) { return r->error; }
static double energy_error(const result *r) { return r->energy_error; }
static double evaluations(const result *r) { return (double)r->work.evaluations; }

static void draw(page *p, const comparison *k, const char *title, const char *note, const char *x_label, quantity *x,
                 const char *y_label, quantity *y) {
  page_series series[MOST_METHODS];
  double *numbers = malloc(2 * (size_t)k->count * sizeof *numbers), *next = numbers;
  int count = 0;
  for (int i = 0; numbers != NULL && i < k->count;) {
    page_series *s = &series[count];
    const eom_trajectory_method *by = k->results[i].method;
    *s = (page_series){.name = by->name, .style = PAGE_LINE_POINTS, .look = count, .x = next, .y = next + k->count};
    for (; i < k->count && k->results[i].method == by; i++) {
      if (k->results[i].status != EOM_OK) continue;
      next[s->count] = x(&k->results[i]);
      next[k->count + s->count++] = y(&k->results[i]);
    }
    next += s->count;
    if (s->count > 0) count++;
  }
  const page_plot plot = {.title = title,
                          .note = note,
                          .x = {.label = x_label, .log = true},
                          .y = {.label = y_label, .log = true},
                          .series = series,
                          .count = count};
  if (count > 0) page_draw(p, &plot);
  free(numbers);
}

static void page_parameters(page *p, const comparison *k) {
  const setup *s = &k->c->s;
  const char *const columns[] = {"name", "value", "what it is", NULL};
  char name[160], value[256];
  page_table(p, "Parameters and start", "lrl", columns);
  for (int i = 0; i < s->model.description->nparameter; i++) {
    const eom_parameter *q = &s->model.description->parameter[i];
    int length = 0;
    for (int j = 0; j < parameter_count(q) && j < s->n && length < (int)sizeof value - 32; j++)
      length += snprintf(value + length, sizeof value - (size_t)length, "%s%.10g", j > 0 ? " " : "", parameter_value(&s->model, q, j));
    snprintf(name, sizeof name, "%s", q->name);
    if (parameter_count(q) > 0) page_row(p, (const char *const[]){name, value, q->text});
  }
  for (int i = 0; i < 2 * s->n; i++) {
    snprintf(value, sizeof value, "%.10g", s->q[i]);
    page_row(p, (const char *const[]){component_name(s, i), value, i < s->n ? "coordinate at the start" : "velocity at the start"});
  }
  page_table_end(p);
}

static int write_page(const comparison *k, const char *path) {
  const setup *s = &k->c->s;
  char title[160], text[256], cell[COLUMNS][CELL];
  page p;
  snprintf(title, sizeof title, "Methods on the model %s", s->model.description->model->name);
  if (page_open(&p, path, title) != 0) return -1;
  reference_text(k, text, sizeof text);
  page_text(&p, "One motion from t = %g s to %g s by every method at several tolerances. %s", s->t0, k->c->t_end, text);
  page_text(&p,
            "Errors are those at the end, of the worst component, in parts of the largest coordinate or velocity. Times are of one "
            "processor core, the "
            "fastest of several runs; compiled by `%s`.",
            compiler);
  page_heading(&p, 2, "Work and precision");
  draw(&p, k, "CPU time against true error", "Left and below is better.", "error", true_error, "CPU time, ms", milliseconds);
  draw(&p, k, "CPU time against energy error", NULL, "error of the energy at the end, J", energy_error, "CPU time, ms", milliseconds);
  draw(&p, k, "Evaluations against true error", "What the method itself needs, whatever an evaluation costs.", "error", true_error,
       "evaluations of the accelerations", evaluations);
  page_heading(&p, 2, "All runs");
  page_table(&p, NULL, "lrrrrrrrr", heads);
  for (int i = 0; i < k->count; i++) {
    const char *row[COLUMNS];
    cells_of(&k->results[i], cell);
    for (int j = 0; j < COLUMNS; j++) row[j] = cell[j];
    page_row(&p, row);
  }
  page_table_end(&p);
  page_heading(&p, 2, "The motion");
  page_parameters(&p, k);
  return page_close(&p);
}

/* ---- the whole ---- */

static int prepare(comparison *k) {
  const setup *s = &k->c->s;
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  k->sys = s->sys;
  k->reference = malloc(2 * (size_t)s->n * sizeof *k->reference);
  k->results = calloc(MOST_RUNS, sizeof *k->results);
  eom_status status = k->reference == NULL || k->results == NULL
                          ? EOM_NO_MEMORY
                          : eom_system_create(&k->plain, s->model.description->model, s->model.params, &options);
  if (status == EOM_OK) return 0;
  complain_status(s->sys, status, "the start");
  return -1;
}

static int compare(comparison *k) {
  if (prepare(k) != 0 || find_reference(k) != 0) return EXIT_FAILED;
  if (!interrupted()) {
    plan(k);
    run_all(k);
  }
  if (interrupted()) complain("stopped by the user after %d runs", k->count);
  int status = interrupted() ? EXIT_INTERRUPTED : EXIT_DONE;
  if (k->count == 0) return status;
  print_table(k);
  if (k->c->csv != NULL && write_csv(k, k->c->csv) != 0) status = EXIT_FAILED;
  if (k->c->page != NULL && write_page(k, k->c->page) != 0) status = EXIT_FAILED;
  return status;
}

int compare_command(int argc, char **argv) {
  command c = {.t_end = 10.0, .repeats = 3};
  comparison k = {.c = &c};
  read_command(&c, argc, argv);
  complete(&c);
  watch_interrupts();
  if (files_possible(wanted(&c)) != 0) return EXIT_FAILED;
  if (setup_load(&c.s, c.s.model.path, NULL) != 0) return refuse();
  int status;
  if (c.t_end == c.s.t0) {
    complain("--t-end %g is the time of the start", c.t_end);
    status = refuse();
  } else {
    setup_print(&c.s);
    status = setup_consistent(&c.s) == 0 ? compare(&k) : EXIT_FAILED;
  }
  eom_system_destroy(k.plain);
  free(k.reference);
  free(k.results);
  setup_close(&c.s);
  return finish_stdout() == 0 ? status : EXIT_FAILED;
}
