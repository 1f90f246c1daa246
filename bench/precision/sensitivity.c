/* Derivatives of motions by their start and by parameters beside references in 40 digits, at many tolerances. */
#include "sensitivity.h"

#include "chain_tl.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "measure.h"
#include "planet_tl.h"
#include "rod_tl.h"
#include "sprung_tl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A line of the references: a motion from y0 by the parameters to y, and the derivatives S of y where S0 are those of y0, 2n x k: by
 * independent initial values first, then by the parameters. */
typedef struct motion {
  char name[32];
  const eom_model *model;
  int n, k, np;
  double t;
  double params[8], y0[8], S0[80], y[8], S[80];
} motion;

enum { MOST_LINE = 1 << 14, MOST_NUMBERS = 256, MOST_UNKNOWNS = 128, LOOSEST = 4, TIGHTEST = 14 };

/* ---- references ---- */

static const eom_model *model_of(const char *name) {
  static const struct {
    const char *name;
    const eom_model *model;
  } models[] = {{"chain", &chain_model}, {"planet", &planet_model}, {"spring", &sprung_model}, {"rod", &rod_model}};
  for (size_t i = 0; i < sizeof models / sizeof models[0]; i++)
    if (strcmp(models[i].name, name) == 0) return models[i].model;
  return NULL;
}

static const double *take(double *to, const double *from, int count) {
  memcpy(to, from, (size_t)count * sizeof *to);
  return from + count;
}

/* Name and numbers `n k np t p y0 S0 y S`; false where a line is none of these. */
static bool read_motion(char *line, motion *m) {
  double number[MOST_NUMBERS];
  int count = 0;
  char *at = line + strcspn(line, " ");
  *m = (motion){.n = 0};
  snprintf(m->name, sizeof m->name, "%.*s", (int)(at - line), line);
  for (char *end; count < MOST_NUMBERS; count++, at = end) {
    number[count] = strtod(at, &end);
    if (end == at) break;
  }
  m->model = model_of(m->name);
  if (m->model == NULL || count < 4) return false;
  m->n = (int)number[0], m->k = (int)number[1], m->np = (int)number[2], m->t = number[3];
  const int d = 2 * m->n;
  if (count != 4 + m->np + 2 * d * (1 + m->k)) return false;
  const double *x = take(m->params, number + 4, m->np);
  x = take(m->y0, x, d);
  x = take(m->S0, x, d * m->k);
  x = take(m->y, x, d);
  take(m->S, x, d * m->k);
  return true;
}

/* ---- errors ---- */

/* The largest error of columns [from, to) in parts of the largest number of the column. S: 2n x k. */
static double error_of(const motion *m, const double *S, int from, int to) {
  double worst = 0.0;
  for (int j = from; j < to; j++) {
    double difference = 0.0, size = 0.0;
    for (int i = 0; i < 2 * m->n; i++) {
      difference = fmax(difference, fabs(S[i * m->k + j] - m->S[i * m->k + j]));
      size = fmax(size, fabs(m->S[i * m->k + j]));
    }
    worst = fmax(worst, size > 0.0 ? difference / size : difference);
  }
  return worst;
}

static double error_of_state(const motion *m, const double *y) {
  double difference = 0.0, size = 0.0;
  for (int i = 0; i < 2 * m->n; i++) difference = fmax(difference, fabs(y[i] - m->y[i])), size = fmax(size, fabs(m->y[i]));
  return difference / size;
}

/* ---- motions ---- */

/* One motion from z0 to the time of the reference, and what it took, s. columns: null for the motion alone. */
static eom_status follow(eom_system *sys, eom_sensitivity *columns, double tolerance, double t, const double *z0, double *z,
                         double *cpu) {
  const eom_trajectory_options options = {
      .control = {.rtol = tolerance, .atol = tolerance}, .project = sys->m > 0, .sensitivity = columns};
  eom_trajectory *trajectory;
  eom_status status = eom_trajectory_create(&trajectory, sys, &options, 0.0, z0);
  if (status != EOM_OK) return status;
  const double begin = cpu_seconds();
  status = eom_trajectory_to(trajectory, t, NULL, NULL);
  *cpu = cpu_seconds() - begin;
  memcpy(z, eom_trajectory_state(trajectory), (size_t)(columns != NULL ? columns->dim : 2 * sys->n) * sizeof *z);
  eom_trajectory_destroy(trajectory);
  return status;
}

static eom_system *system_of(const motion *m, const double *params, unsigned needs) {
  eom_system *sys;
  eom_options options = eom_options_default();
  options.needs = needs;
  return eom_system_create(&sys, m->model, params, &options) == EOM_OK ? sys : NULL;
}

/* What is measured of a motion at one tolerance: errors, and the least time of the repeats. */
typedef struct result {
  double state, initial, parameters, cpu;
} result;

/* y and S together, steps by the errors of all. */
static bool by_tangents(const motion *m, double tolerance, int repeats, result *r) {
  double z0[MOST_UNKNOWNS], z[MOST_UNKNOWNS], cpu;
  const int d = 2 * m->n, directions = m->k - m->np;
  eom_system *sys = system_of(m, m->params, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS);
  eom_sensitivity columns;
  double *work = sys != NULL ? malloc(eom_sensitivity_size(sys, directions, m->np) * sizeof *work) : NULL;
  bool good = work != NULL && eom_sensitivity_init(&columns, sys, directions, m->np, NULL, work) == EOM_OK;
  memcpy(z0, m->y0, (size_t)d * sizeof *z0);
  memcpy(z0 + d, m->S0, (size_t)(d * m->k) * sizeof *z0);
  r->cpu = HUGE_VAL;
  for (int i = 0; i < repeats && good; i++) {
    good = follow(sys, &columns, tolerance, m->t, z0, z, &cpu) == EOM_OK;
    r->cpu = fmin(r->cpu, cpu);
  }
  eom_system_destroy(sys);
  free(work);
  if (!good) return false;
  r->state = error_of_state(m, z);
  r->initial = error_of(m, z + d, 0, directions);
  r->parameters = error_of(m, z + d, directions, m->k);
  return true;
}

/* One of the two motions of a central difference: column j of S0 and, behind the initial values, a parameter moved by h. */
static bool moved(const motion *m, int j, double h, double tolerance, double *y, double *cpu) {
  double y0[8], params[8];
  const int d = 2 * m->n, parameter = j - (m->k - m->np);
  memcpy(params, m->params, sizeof params);
  if (parameter >= 0) params[parameter] += h;
  for (int i = 0; i < d; i++) y0[i] = m->y0[i] + h * m->S0[i * m->k + j];
  eom_system *sys = system_of(m, params, EOM_NEED_SIMULATE);
  const bool good = sys != NULL && follow(sys, NULL, tolerance, m->t, y0, y, cpu) == EOM_OK;
  eom_system_destroy(sys);
  return good;
}

/* What one does without tangents: differences of the whole motion, with the step that balances the errors of motion and difference. */
static bool by_differences(const motion *m, double tolerance, int repeats, result *r) {
  const double h = cbrt(tolerance);
  double S[80], ahead[8], behind[8], first, second;
  const int d = 2 * m->n;
  r->cpu = HUGE_VAL;
  for (int i = 0; i < repeats; i++) {
    double cpu = 0.0;
    for (int j = 0; j < m->k; j++, cpu += first + second) {
      if (!moved(m, j, h, tolerance, ahead, &first) || !moved(m, j, -h, tolerance, behind, &second)) return false;
      for (int l = 0; l < d; l++) S[l * m->k + j] = (ahead[l] - behind[l]) / (2.0 * h);
    }
    r->cpu = fmin(r->cpu, cpu);
  }
  r->state = (double)NAN;
  r->initial = error_of(m, S, 0, m->k - m->np);
  r->parameters = error_of(m, S, m->k - m->np, m->k);
  return true;
}

/* ---- rows ---- */

static void print_row(const motion *m, const char *way, int power, const result *r) {
  printf("%s,%s,%d,%d,1e-%d,", m->name, way, m->k - m->np, m->np, power);
  if (isfinite(r->state)) printf("%.3e", r->state);
  printf(",%.3e,%.3e,%.4g\n", r->initial, r->parameters, r->cpu);
}

int sensitivity(FILE *references, bool quick) {
  static char line[MOST_LINE];
  const int repeats = quick ? 1 : 15;
  puts("model,way,directions,parameters,tolerance,state_error,initial_error,parameter_error,cpu_s");
  while (fgets(line, sizeof line, references) != NULL && !interrupted()) {
    motion m;
    result r;
    if (line[0] == '#') continue;
    if (!read_motion(line, &m)) {
      complain("a reference that is none: %.40s", line);
      return EXIT_FAILED;
    }
    for (int power = LOOSEST; power <= TIGHTEST; power += quick ? 4 : 1) {
      if (by_tangents(&m, pow(10.0, -power), repeats, &r)) print_row(&m, "tangents", power, &r);
      if (by_differences(&m, pow(10.0, -power), repeats, &r)) print_row(&m, "differences", power, &r);
    }
  }
  return interrupted() ? EXIT_INTERRUPTED : EXIT_DONE;
}
