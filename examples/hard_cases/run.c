/* A run of a scene: integration with projection onto the constraints, and the largest errors on the way. */
#include "run.h"

#include "host/interrupt.h"
#include "host/progress.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

/* A run under way. */
typedef struct course {
  run *r;
  const scene *scene;
  eom_system *sys;
  eom_integrator it;
  double energy0;
  progress line;
} course;

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* A NaN is larger than every number. */
static double larger(double a, double b) { return b <= a || isnan(a) ? a : b; }

static double largest(const double *x, int count) {
  double most = 0.0;
  for (int i = 0; i < count; i++) most = larger(most, fabs(x[i]));
  return most;
}

static double balance(const course *c, const double *y) { return c->sys->energy - (c->scene->work != NULL ? c->scene->work(y) : 0.0); }

static void note_rank(run *r, int rank) {
  if (rank < r->worst.rank) r->worst.rank = rank;
  if (rank > r->most_rank) r->most_rank = rank;
}

/* The errors of the state now, as a new row. */
static eom_status observe(course *c) {
  run *r = c->r;
  eom_system *sys = c->sys;
  const double *y = c->it.y, t = c->it.t;
  run_row row = {.t = t, .error = scene_error(c->scene, t, y)};
  eom_status status = eom_assemble(sys, y, y + sys->n, t);
  if (status == EOM_OK) status = eom_solve(sys);
  if (status != EOM_OK) return status;
  row.phi = largest(sys->phi, sys->m1);
  row.phi_dot = larger(largest(sys->phi_dot, sys->m1), largest(sys->psi, sys->m2));
  row.rank = sys->report.rank;
  if (r->nrow == 0) c->energy0 = balance(c, y), r->worst.rank = r->most_rank = row.rank;
  row.energy = fabs(balance(c, y) - c->energy0);
  r->rows[r->nrow++] = row;
  r->worst.t = t;
  if (!isnan(row.error)) r->worst.error = larger(r->worst.error, row.error), r->compared += t > 0.0;
  r->worst.energy = larger(r->worst.energy, row.energy);
  r->worst.phi = larger(r->worst.phi, row.phi);
  r->worst.phi_dot = larger(r->worst.phi_dot, row.phi_dot);
  note_rank(r, row.rank);
  return EOM_OK;
}

static int after_step(void *observer, const eom_integrator *it) {
  course *c = observer;
  if (c->sys->held_rank >= 0) note_rank(c->r, c->sys->held_rank);
  progress_show(&c->line, c->scene->name, it->t / c->r->duration);
  return interrupted();
}

/* From output to output. */
static eom_status advance(course *c, int outputs) {
  eom_status status = observe(c);
  for (int i = 1; i <= outputs && status == EOM_OK; i++) {
    const double begin = now();
    status = eom_integrate(&c->it, c->scene->duration * i / c->scene->outputs, after_step, c);
    c->r->seconds += now() - begin;
    if (status == EOM_OK) status = observe(c);
  }
  return status;
}

/* Equal steps that end at each output, or steps chosen by their error. */
static eom_status set_out(course *c, const eom_method *method, const double *y, double *work) {
  const run_request *ask = &c->r->ask;
  const double between = c->scene->duration / c->scene->outputs;
  const double step = ask->step > 0.0 ? between / ceil(between / ask->step) : 0.0;
  eom_integrator_init(&c->it, method, eom_rhs, c->sys, 2 * c->sys->n, 0.0, y, step, work);
  if (c->sys->m > 0 && ask->drift == DRIFT_PROJECTION) c->it.correct = eom_project_state;
  if (ask->step > 0.0) return EOM_OK;
  return eom_integrator_control(&c->it, &(eom_step_control){.rtol = ask->tolerance, .atol = ask->tolerance});
}

/* A consistent start, then all steps. */
static eom_status start_and_advance(course *c, const scene_start *start, int outputs) {
  eom_system *sys = c->sys;
  const int n = sys->n;
  const eom_method *method = eom_method_find(c->r->ask.method);
  double *y = malloc((size_t)(2 * n) * sizeof *y), *work = malloc(eom_integrator_size(method, 2 * n) * sizeof *work);
  eom_status status = y != NULL && work != NULL ? EOM_OK : EOM_NO_MEMORY;
  for (int i = 0; i < n && status == EOM_OK; i++) y[i] = start->q[i], y[n + i] = start->qd[i];
  if (status == EOM_OK) status = eom_project(sys, y, y + n, 0.0, NULL);
  if (status == EOM_OK) status = set_out(c, method, y, work);
  if (status == EOM_OK) {
    progress_start(&c->line);
    status = advance(c, outputs);
    progress_end(&c->line);
  }
  free(work);
  free(y);
  return status;
}

static eom_status go(run *r, course *c) {
  const scene *s = c->scene;
  scene_start start = {0};
  eom_options options = eom_options_default();
  const int outputs = (int)lround(r->duration / s->duration * s->outputs);
  s->begin(&start);
  options.needs = EOM_NEED_SIMULATE;
  options.hold.on = s->hold;
  if (r->ask.drift == DRIFT_BAUMGARTE) options.baumgarte = (eom_baumgarte){.alpha = r->ask.rate, .beta = r->ask.rate};
  const eom_status status = eom_system_create(&c->sys, s->model, start.params, &options);
  if (status != EOM_OK) return status;
  r->n = c->sys->n, r->m1 = c->sys->m1, r->m = c->sys->m;
  r->rows = calloc((size_t)outputs + 1, sizeof *r->rows);
  return r->rows != NULL ? start_and_advance(c, &start, outputs) : EOM_NO_MEMORY;
}

void run_do(run *r, const run_request *ask) {
  const scene *s = ask->scene;
  *r = (run){.ask = *ask, .duration = ask->duration > 0.0 ? ask->duration : s->duration};
  if (r->ask.method == NULL) r->ask.method = s->method;
  if (!(r->ask.step > 0.0) && !(r->ask.tolerance > 0.0)) r->ask.step = s->step, r->ask.tolerance = s->tolerance;
  course c = {.r = r, .scene = s};
  r->status = go(r, &c);
  if (c.sys != NULL) r->report = c.sys->report;
  eom_system_destroy(c.sys);
}

bool run_passed(const run *r) {
  const scene *s = r->ask.scene;
  return r->status == EOM_OK && r->compared > 0 && r->worst.error <= s->required &&
         (!(s->energy > 0.0) || r->worst.energy <= s->energy);
}

void run_free(run *r) {
  free(r->rows);
  r->rows = NULL;
}
