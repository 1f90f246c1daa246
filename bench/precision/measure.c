/* One motion by one method at one setting, timed. */
#include "measure.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MOST_REPEATS = 64 };

double cpu_seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---- rows of results ---- */

void print_measurement_head(void) { puts("scene,contender,method,setting,cpu_s,cpu_median_s,error,energy_error,steps,evaluations"); }

static void print_number(const char *format, double x) {
  putchar(',');
  if (isfinite(x)) printf(format, x);
}

static void print_count(long count) {
  putchar(',');
  if (count > 0) printf("%ld", count);
}

void print_measurement(const measurement *m) {
  printf("%s,%s,%s,%s", m->scene, m->contender, m->method, m->setting);
  print_number("%.6g", m->cpu);
  print_number("%.6g", m->cpu_median);
  print_number("%.3e", m->error);
  print_number("%.3e", m->energy_error);
  print_count(m->steps);
  print_count(m->evaluations);
  putchar('\n');
  fflush(stdout);
}

/* ---- scenes ---- */

eom_system *scene_system(const precision_scene *p, const eom_trajectory_method *method, double *y0) {
  scene_start start = {0};
  eom_system *sys;
  eom_options options = eom_options_default();
  options.needs = method->implicit ? EOM_NEED_LINEARISE : EOM_NEED_SIMULATE;
  options.hold.on = p->scene->hold;
  p->scene->begin(&start);
  if (eom_system_create(&sys, p->scene->model, start.params, &options) != EOM_OK) return NULL;
  memcpy(y0, start.q, (size_t)sys->n * sizeof *y0);
  memcpy(y0 + sys->n, start.qd, (size_t)sys->n * sizeof *y0);
  if (sys->m == 0 || eom_project(sys, y0, y0 + sys->n, 0.0, NULL) == EOM_OK) return sys;
  eom_system_destroy(sys);
  return NULL;
}

double scene_balance(const precision_scene *p, eom_system *sys, const double *y, double t) {
  if (!(p->scene->energy > 0.0) || eom_energy(sys, y, y + sys->n, t) != EOM_OK) return (double)NAN;
  return sys->energy - (p->scene->work != NULL ? p->scene->work(y) : 0.0);
}

void judge(measurement *m, const precision_scene *p, eom_system *sys, const double *y0, const double *y) {
  m->error = scene_error(p->scene, p->t_end, y);
  m->energy_error = fabs(scene_balance(p, sys, y, p->t_end) - scene_balance(p, sys, y0, 0.0));
}

/* ---- timing ---- */

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* One motion from the start; *seconds of its integration alone. */
static eom_status follow(measurement *m, const precision_scene *p, eom_system *sys, const double *y0,
                         const eom_trajectory_options *options, double *seconds) {
  eom_trajectory *trajectory;
  eom_status status = eom_trajectory_create(&trajectory, sys, options, 0.0, y0);
  if (status != EOM_OK) return status;
  const double begin = cpu_seconds();
  status = eom_trajectory_to(trajectory, p->t_end, NULL, NULL);
  *seconds = cpu_seconds() - begin;
  const eom_trajectory_work work = eom_trajectory_worked(trajectory);
  m->steps = work.steps;
  m->evaluations = work.evaluations;
  if (status == EOM_OK) judge(m, p, sys, y0, eom_trajectory_state(trajectory));
  eom_trajectory_destroy(trajectory);
  return status;
}

eom_status measure(measurement *m, const precision_scene *p, eom_system *sys, const double *y0, const eom_trajectory_options *options,
                   effort allowed) {
  double taken[MOST_REPEATS], sum = 0.0;
  int count = 0;
  while (count < allowed.repeats && count < MOST_REPEATS && (count == 0 || sum < allowed.seconds)) {
    const eom_status status = follow(m, p, sys, y0, options, &taken[count]);
    if (status != EOM_OK) return status;
    sum += taken[count++];
  }
  qsort(taken, (size_t)count, sizeof *taken, ascending);
  m->cpu = taken[0];
  m->cpu_median = taken[count / 2];
  return EOM_OK;
}
