/* precision: times the library's motions beside their truth, and judges those of others, for scripts/report. */
#include "host/interrupt.h"
#include "host/message.h"
#include "host/options.h"
#include "host/progress.h"
#include "measure.h"
#include "sensitivity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char program[] = "precision";

static const manual text = {
    .operands = "scenes | methods | time | judge | energy | sensitivity ",
    .summary = "Measures for the report of speed against error, as CSV on standard output.\n"
               "  scenes   what other programs need to follow the scenes: a line of JSON for each\n"
               "  methods  the names of this build's methods of integration\n"
               "  time     CPU time and true error at the end of each scene, by every method and setting of this build\n"
               "  judge    reads rows `scene,contender,method,setting,cpu_s,cpu_median_s,steps,evaluations,state..` of other programs\n"
               "           from standard input and prints them with their errors in the place of the state\n"
               "  energy   the largest energy error so far, over a long time\n"
               "  sensitivity  reads references as tests/data/sensitivity.txt has them from standard input and prints the errors of\n"
               "           derivatives of motions, and of differences of motions, at many tolerances\n",
    .examples = "  precision time --scene kepler05\n"
                "  precision time --quick      two settings of each method, once; seconds\n",
};

typedef struct command {
  const char *scene, *method; /* null: all */
  bool quick;
} command;

/* What one setting may take, and when a finer one would take too long, s. */
static const effort whole_effort = {.seconds = 0.2, .repeats = 25}, quick_effort = {.repeats = 1};
static const double longest_run = 0.6, quick_run = 0.05;

/* A run that takes so many times the longest one, or so many steps where none went before, is given up. */
static const double most_overrun = 3.0;
static const long first_most_steps = 200000;

/* Where halved steps leave an error below the first that is not less than this part of the last one, it is made of rounding. */
static const double most_rounding = 1e-9, least_gain = 0.9;

/* Errors above it are no solutions. */
static const double most_error = 0.1;

/* Tolerances are powers of ten between these. */
enum { LOOSEST = 3, TIGHTEST = 16, MOST_HALVINGS = 14 };

static bool wanted_method(const command *c, const eom_trajectory_method *method) {
  return c->method == NULL || strcmp(c->method, method->name) == 0;
}

static bool wanted(const command *c, const precision_scene *p) { return c->scene == NULL || strcmp(c->scene, p->name) == 0; }

/* ---- scenes ---- */

static void print_numbers(const double *x, int count) {
  for (int i = 0; i < count; i++) printf("%s%.17g", i > 0 ? "," : "", x[i]);
}

static int do_scenes(const command *c) {
  for (int i = 0; i < precision_scene_count; i++) {
    const precision_scene *p = &precision_scenes[i];
    double y0[2 * SCENE_MOST_COORDINATES];
    if (!wanted(c, p)) continue;
    eom_system *sys = scene_system(p, eom_trajectory_method_at(0), y0);
    if (sys == NULL) return EXIT_FAILED;
    printf("{\"scene\":\"%s\",\"t_end\":%.17g,\"q\":[", p->name, p->t_end);
    print_numbers(y0, sys->n);
    fputs("],\"qd\":[", stdout);
    print_numbers(y0 + sys->n, sys->n);
    puts("]}");
    eom_system_destroy(sys);
  }
  return EXIT_DONE;
}

/* ---- time ---- */

/* A series of settings of one method. */
typedef struct series {
  const precision_scene *scene;
  const eom_trajectory_method *method;
  eom_system *sys;
  const double *y0;
  bool quick;
} series;

/* What the settings of a method have shown so far: steps per second of CPU time, 0 before there is one; and the last error. */
typedef struct outlook {
  double rate, error;
} outlook;

/* Measures one setting and prints it if it is a solution. Returns whether a finer one is worth the time: not where it takes long, nor
 * where rounding is all that is left of the error. */
static bool measure_setting(const series *s, const eom_trajectory_options *options, const char *setting, const char *suffix,
                            outlook *so_far) {
  char method[64];
  snprintf(method, sizeof method, "%s%s", s->method->name, suffix);
  measurement m = {.scene = s->scene->name, .contender = s->method->fixed ? "own" : "sundials", .method = method, .setting = setting};
  const eom_status status = measure(&m, s->scene, s->sys, s->y0, options, s->quick ? quick_effort : whole_effort);
  if (status == EOM_OK && m.error < most_error) print_measurement(&m);
  if (interrupted()) return false;
  if (status != EOM_OK) return true;
  const bool rounding = options->h > 0.0 && m.error < most_rounding && m.error > least_gain * so_far->error;
  *so_far = (outlook){.rate = (double)m.steps / m.cpu, .error = m.error};
  return m.cpu < (s->quick ? quick_run : longest_run) && !rounding;
}

static eom_trajectory_options options_of(const series *s) {
  return (eom_trajectory_options){.method = s->method->name, .project = s->method->projects && s->sys->m > 0};
}

/* No run goes on for much longer than the longest that is wanted: its steps are bounded by the rate of the last one. */
static void measure_tolerances(const series *s) {
  bool more = true;
  outlook so_far = {.error = HUGE_VAL};
  for (int k = LOOSEST; k <= TIGHTEST && more; k += s->quick ? 6 : 1) {
    char setting[32];
    eom_trajectory_options options = options_of(s);
    options.control.rtol = options.control.atol = pow(10.0, -k);
    options.control.most_steps = so_far.rate > 0.0 ? lround(most_overrun * longest_run * so_far.rate) : first_most_steps;
    snprintf(setting, sizeof setting, "tolerance 1e-%d", k);
    more = measure_setting(s, &options, setting, "", &so_far);
  }
}

/* The setting begins with coarsest steps and halves them. */
static void measure_steps(const series *s) {
  bool more = true;
  outlook so_far = {.error = HUGE_VAL};
  for (int i = 0; i < (s->quick ? 2 : MOST_HALVINGS) && more; i++) {
    char setting[32];
    const long steps = s->scene->coarsest << i;
    eom_trajectory_options options = options_of(s);
    options.h = s->scene->t_end / (double)steps;
    snprintf(setting, sizeof setting, "%ld steps", steps);
    more = measure_setting(s, &options, setting, " fixed", &so_far);
  }
}

static int measure_method(const precision_scene *p, const eom_trajectory_method *method, bool quick) {
  double y0[2 * SCENE_MOST_COORDINATES];
  const series s = {.scene = p, .method = method, .sys = scene_system(p, method, y0), .y0 = y0, .quick = quick};
  if (s.sys == NULL) {
    complain("%s has no start", p->name);
    return EXIT_FAILED;
  }
  measure_tolerances(&s);
  if (method->fixed) measure_steps(&s);
  eom_system_destroy(s.sys);
  return interrupted() ? EXIT_INTERRUPTED : EXIT_DONE;
}

static int do_methods(const command *c) {
  (void)c;
  for (int k = 0; eom_trajectory_method_at(k) != NULL; k++) puts(eom_trajectory_method_at(k)->name);
  return EXIT_DONE;
}

static int do_time(const command *c) {
  progress line;
  int status = EXIT_DONE, methods = 0;
  while (eom_trajectory_method_at(methods) != NULL) methods++;
  print_measurement_head();
  progress_start(&line);
  for (int i = 0; i < precision_scene_count; i++)
    for (int k = 0; k < methods && status == EXIT_DONE && wanted(c, &precision_scenes[i]); k++) {
      if (!wanted_method(c, eom_trajectory_method_at(k))) continue;
      progress_show(&line, precision_scenes[i].title, (double)(i * methods + k) / (precision_scene_count * methods));
      status = measure_method(&precision_scenes[i], eom_trajectory_method_at(k), c->quick);
    }
  progress_end(&line);
  return status;
}

/* ---- judge ---- */

enum { FIELDS = 8, MOST_LINE = 1 << 14 };

/* Splits at commas, as many as there are fields; the last one keeps the rest. Returns how many there were. */
static int split(char *line, char **field) {
  int count = 0;
  line[strcspn(line, "\n")] = '\0';
  for (char *at = line; at != NULL && count <= FIELDS; count++) {
    field[count] = at;
    at = count < FIELDS ? strchr(at, ',') : NULL;
    if (at != NULL) *at++ = '\0';
  }
  return count;
}

static int read_numbers(char *at, double *x, int most) {
  int count = 0;
  for (char *end; count < most; count++, at = end + (*end == ',')) {
    x[count] = strtod(at, &end);
    if (end == at) break;
  }
  return count;
}

static int judge_line(char *line) {
  char *field[FIELDS + 1];
  double y[2 * SCENE_MOST_COORDINATES], y0[2 * SCENE_MOST_COORDINATES];
  const precision_scene *p = split(line, field) == FIELDS + 1 ? precision_scene_find(field[0]) : NULL;
  eom_system *sys = p != NULL ? scene_system(p, eom_trajectory_method_at(0), y0) : NULL;
  if (sys == NULL || read_numbers(field[FIELDS], y, 2 * SCENE_MOST_COORDINATES) != 2 * sys->n) {
    complain("a row that is none: %s", field[0]);
    eom_system_destroy(sys);
    return EXIT_FAILED;
  }
  measurement m = {.scene = field[0], .contender = field[1], .method = field[2], .setting = field[3]};
  m.cpu = strtod(field[4], NULL), m.cpu_median = strtod(field[5], NULL);
  m.steps = strtol(field[6], NULL, 10), m.evaluations = strtol(field[7], NULL, 10);
  judge(&m, p, sys, y0, y);
  if (m.error < most_error) print_measurement(&m);
  eom_system_destroy(sys);
  return EXIT_DONE;
}

static int do_judge(const command *c) {
  static char line[MOST_LINE];
  (void)c;
  print_measurement_head();
  while (fgets(line, sizeof line, stdin) != NULL)
    if (judge_line(line) != EXIT_DONE) return EXIT_FAILED;
  return EXIT_DONE;
}

/* ---- energy ---- */

enum { WATCHED = 50 };
static const double watched_tolerance = 1e-8;

/* The largest error so far at evenly spaced times, by steps chosen at one tolerance, or by equal steps. */
static void watch(const precision_scene *p, const eom_trajectory_method *method, double h, const char *setting, double duration) {
  double y0[2 * SCENE_MOST_COORDINATES], worst = 0.0;
  eom_trajectory *trajectory = NULL;
  eom_trajectory_options options = {.method = method->name, .h = h};
  if (!(h > 0.0)) options.control.rtol = options.control.atol = watched_tolerance;
  eom_system *sys = scene_system(p, method, y0);
  eom_status status = sys != NULL ? eom_trajectory_create(&trajectory, sys, &options, 0.0, y0) : EOM_NO_MEMORY;
  const double before = sys != NULL ? scene_balance(p, sys, y0, 0.0) : 0.0;
  for (int i = 1; i <= WATCHED && status == EOM_OK && !interrupted(); i++) {
    const double t = duration * i / (double)WATCHED;
    status = eom_trajectory_to(trajectory, t, NULL, NULL);
    if (status != EOM_OK) break;
    worst = fmax(worst, fabs(scene_balance(p, sys, eom_trajectory_state(trajectory), t) - before));
    printf("%s,%s,%s,%.6g,%.3e\n", p->name, method->name, setting, t, worst);
  }
  eom_trajectory_destroy(trajectory);
  eom_system_destroy(sys);
}

static int do_energy(const command *c) {
  puts("scene,method,setting,t,energy_error");
  for (int i = 0; i < precision_scene_count; i++) {
    const precision_scene *p = &precision_scenes[i];
    const double duration = c->quick ? p->orbit / 20.0 : p->orbit, h = p->t_end / (double)(8 * p->coarsest);
    if (!wanted(c, p) || !(duration > 0.0)) continue;
    for (int k = 0; eom_trajectory_method_at(k) != NULL; k++) {
      const eom_trajectory_method *method = eom_trajectory_method_at(k);
      char setting[48];
      if (!method->fixed) continue; /* SUNDIALS': their steps are of the same kinds */
      watch(p, method, 0.0, "tolerance 1e-8", duration);
      snprintf(setting, sizeof setting, "steps of %.4g s", h);
      watch(p, method, h, setting, duration);
    }
  }
  return interrupted() ? EXIT_INTERRUPTED : EXIT_DONE;
}

static int do_sensitivity(const command *c) { return sensitivity(stdin, c->quick); }

/* ---- the program ---- */

static const struct {
  const char *name;
  int (*run)(const command *c);
} actions[] = {{"scenes", do_scenes}, {"methods", do_methods}, {"time", do_time},
               {"judge", do_judge},   {"energy", do_energy},   {"sensitivity", do_sensitivity}};

int main(int argc, char **argv) {
  command c = {.quick = false};
  const option table[] = {
      {.name = "--scene", .kind = OPTION_TEXT, .value = &c.scene, .operand = "NAME", .help = "this one alone"},
      {.name = "--method", .kind = OPTION_TEXT, .value = &c.method, .operand = "NAME", .help = "likewise, of integration"},
      {.name = "--quick", .kind = OPTION_FLAG, .value = &c.quick, .help = "few settings, once each: to see that it works"},
  };
  const bool named = argc > 1 && argv[1][0] != '-';
  read_options(argc - named, argv + named, table, sizeof table / sizeof table[0], &text);
  if (c.scene != NULL && precision_scene_find(c.scene) == NULL) usage_error("there is no scene '%s'", c.scene);
  watch_interrupts();
  for (size_t i = 0; named && i < sizeof actions / sizeof actions[0]; i++) {
    if (strcmp(argv[1], actions[i].name) != 0) continue;
    const int status = actions[i].run(&c);
    return finish_stdout() == 0 ? status : EXIT_FAILED;
  }
  usage_error("what to do: scenes, methods, time, judge, energy or sensitivity");
}
