/* A motion followed from a start, with its rows: what run, compare and watch share. */
#include "motion.h"

#include "eom/assemble.h"
#include "eom/project.h"
#include "host/interrupt.h"
#include "host/message.h"
#include "host/progress.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two times that differ by less, in parts of the distance from row to row, are the same. */
static const double same_time = 1e-9;

static double largest(const double *x, int count) {
  double most = 0.0;
  for (int i = 0; i < count; i++)
    if (!(fabs(x[i]) <= most)) most = fabs(x[i]); /* a NaN is larger than every number */
  return most;
}

static double larger(double a, double b) { return b <= a ? a : b; }

/* ---- rows ---- */

static void add_row(motion *m, double t, const double *y) {
  const setup *s = m->ask.s;
  const eom_status status = eom_assemble(m->sys, y, y + s->n, t);
  if (status != EOM_OK && m->broken == EOM_OK) m->broken = status;
  double *row = status == EOM_OK ? series_row(&m->rows) : NULL;
  if (status != EOM_OK) return;
  if (row == NULL) {
    m->no_memory = true;
    return;
  }
  const formula_point at = {.m = &s->model, .n = s->n, .q = y, .qd = y + s->n, .t = t};
  double *next = row + 1 + 2 * s->n;
  row[0] = t;
  memcpy(row + 1, y, 2 * (size_t)s->n * sizeof *y);
  if (m->rows.count == 1) m->energy0 = m->sys->energy;
  next[0] = m->sys->energy;
  next[1] = m->sys->energy - m->energy0;
  m->energy_change = larger(m->energy_change, fabs(next[1]));
  next += 2;
  if (s->sys->m > 0) {
    next[0] = largest(m->sys->phi, m->sys->m1);
    next[1] = larger(largest(m->sys->phi_dot, m->sys->m1), largest(m->sys->psi, m->sys->m2));
    m->phi = larger(m->phi, next[0]);
    m->phi_dot = larger(m->phi_dot, next[1]);
    next += 2;
  }
  const derivatives *d = &m->derivatives;
  if (d->count > 0) memcpy(next, d->z + 2 * s->n, 2 * (size_t)s->n * (size_t)d->count * sizeof *next);
  next += 2 * s->n * d->count;
  for (int i = 0; m->ask.columns != NULL && i < m->ask.columns->count; i++) next[i] = formula_value(m->column[i], &at);
}

/* y, or z where there are derivatives. */
static void keep_state(motion *m, const tl_real *y) {
  memcpy(m->y, y, 2 * (size_t)m->ask.s->n * sizeof *m->y);
  if (m->derivatives.count > 0) memcpy(m->derivatives.z, y, (size_t)m->derivatives.columns.dim * sizeof *y);
}

/* A state inside a step is interpolated; where steps are brought onto the constraints it is, too. */
static void write_row(void *user, tl_real t, const tl_real *y) {
  motion *m = user;
  const int n = m->ask.s->n;
  if (m->broken != EOM_OK || m->no_memory) return;
  keep_state(m, y);
  if (m->projects) m->broken = eom_project(m->sys, m->y, m->y + n, t, NULL);
  if (m->broken == EOM_OK) add_row(m, t, m->y);
}

/* "NAME=FORMULA" as one more column. */
static int add_column(motion *m, int i, const char *text) {
  char name[32], error[512];
  const size_t length = strcspn(text, "=");
  if (text[length] == '\0' || length == 0 || length >= sizeof name ||
      strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") != length) {
    complain("--column %s: write NAME=FORMULA, the name of up to %zu letters, digits and _", text, sizeof name - 1);
    return -1;
  }
  memcpy(name, text, length);
  name[length] = '\0';
  for (int k = 0; k < m->rows.groups; k++)
    if (strcmp(m->rows.group[k].name, name) == 0) {
      complain("--column %s: there is a column %s already", text, name);
      return -1;
    }
  m->column[i] = formula_parse(text + length + 1, FORMULA_STATE, &m->ask.s->model, error, sizeof error);
  if (m->column[i] == NULL) {
    complain("--column %s: %s", name, error);
    return -1;
  }
  return series_group_add(&m->rows, name, 0);
}

static int add_columns(motion *m) {
  const setup *s = m->ask.s;
  series *r = &m->rows;
  if (series_group_add(r, "t", 0) != 0 || series_group_add(r, "q", s->n) != 0 || series_group_add(r, "qd", s->n) != 0) return -1;
  for (int i = 0; i < 2 * s->n; i++) snprintf(r->name[1 + i], sizeof r->name[0], "%s", component_name(s, i));
  if (series_group_add(r, "energy", 0) != 0 || series_group_add(r, "energy_change", 0) != 0) return -1;
  if (s->sys->m > 0 && (series_group_add(r, "phi", 0) != 0 || series_group_add(r, "phi_dot", 0) != 0)) return -1;
  if (derivatives_add_columns(&m->derivatives, s, r) != 0) return -1;
  for (int i = 0; m->ask.columns != NULL && i < m->ask.columns->count; i++)
    if (add_column(m, i, m->ask.columns->text[i]) != 0) return -1;
  return 0;
}

int motion_open(motion *m, const motion_request *ask) {
  static const option_texts none;
  const setup *s = ask->s;
  *m = (motion){.ask = *ask};
  if (derivatives_open(&m->derivatives, s, ask->how, ask->sensitivity) != 0) return -1;
  if (events_open(&m->met, ask->events != NULL ? ask->events : &none, s) != 0) return derivatives_close(&m->derivatives), -1;
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  m->y = calloc(2 * (size_t)s->n, sizeof *m->y);
  if (m->y != NULL && add_columns(m) == 0 &&
      eom_system_create(&m->sys, s->model.description->model, s->model.params, &options) == EOM_OK)
    return 0;
  motion_close(m);
  return -1;
}

void motion_close(motion *m) {
  events_close(&m->met);
  derivatives_close(&m->derivatives);
  series_free(&m->rows);
  for (int i = 0; i < OPTION_MOST_TEXTS; i++) formula_free(m->column[i]);
  eom_system_destroy(m->sys);
  free(m->y);
  m->sys = NULL, m->y = NULL;
}

/* ---- the motion ---- */

static int observe(void *observer, const eom_trajectory *trajectory) {
  motion *m = observer;
  const double t0 = m->ask.s->t0, t = eom_trajectory_time(trajectory);
  if (m->line != NULL) progress_show(m->line, program, (t - t0) / (m->ask.t_end - t0));
  return interrupted() || m->broken != EOM_OK || m->no_memory;
}

/* How it ended, with a message where it should not have. */
static motion_end judge(const motion *m, const eom_system *sys, eom_status status) {
  char what[128];
  if (m->no_memory || m->met.no_memory) return MOTION_FAILED; /* the message has been given */
  if (m->broken != EOM_OK) {
    complain_status(m->sys, m->broken, "a row could not be evaluated");
    return MOTION_FAILED;
  }
  if (status == EOM_OK) return MOTION_COMPLETE;
  if (status == EOM_STOPPED && m->met.stopped >= 0) return MOTION_EVENT;
  if (status == EOM_STOPPED) {
    complain("stopped by the user at t = %.6g s", m->t);
    return MOTION_INTERRUPTED;
  }
  if (m->met.broken >= 0) {
    complain("the event '%s' is not a number at t = %.10g s", m->met.text[m->met.broken], m->met.t_broken);
    return MOTION_FAILED;
  }
  snprintf(what, sizeof what, "%s failed at t = %.10g s", m->ask.how->found->name, m->t);
  if (sys->report.status != EOM_OK && status == EOM_RHS_FAILED) status = sys->report.status;
  complain_status(sys, status, what);
  return MOTION_FAILED;
}

/* Rows at t0 + k every; the last one where the motion ends. */
void motion_follow(motion *m) {
  const setup *s = m->ask.s;
  const double way = m->ask.t_end - s->t0, every = copysign(m->ask.every, way);
  progress line;
  eom_outputs outputs = {
      .write = write_row, .user = m, .first = s->t0, .every = every, .count = (long)floor(way / every + same_time) + 1};
  eom_trajectory_options options = method_trajectory_options(m->ask.how, s);
  eom_trajectory *trajectory = NULL;
  m->projects = options.project;
  options.outputs = &outputs;
  m->met.watched.apart = m->ask.every;
  options.events = m->met.watched.count > 0 ? &m->met.watched : NULL;
  progress_start(&line);
  m->line = m->ask.quiet ? NULL : &line;
  m->t = s->t0;
  memcpy(m->y, s->q, 2 * (size_t)s->n * sizeof *m->y);
  derivatives *d = &m->derivatives;
  eom_system *sys = d->count > 0 ? d->sys : s->sys;
  eom_status status = d->count > 0 ? derivatives_start(d, s) : EOM_OK;
  if (d->count > 0) options.sensitivity = &d->columns;
  if (status == EOM_OK) status = eom_trajectory_create(&trajectory, sys, &options, s->t0, d->count > 0 ? d->z : s->q);
  if (status == EOM_OK) {
    status = eom_trajectory_to(trajectory, m->ask.t_end, observe, m);
    m->t = eom_trajectory_time(trajectory);
    keep_state(m, eom_trajectory_state(trajectory));
    m->work = eom_trajectory_worked(trajectory);
  }
  if (m->line != NULL) progress_end(&line);
  if (trajectory == NULL) {
    m->end = MOTION_FAILED;
    if (status == EOM_BAD_OPTION)
      complain("%s cannot follow this model like that; it is: %s", m->ask.how->found->name, m->ask.how->found->text);
    else
      complain_status(s->sys, status, "the motion cannot be started");
    return;
  }
  const double last = m->rows.count > 0 ? m->rows.rows[(m->rows.count - 1) * m->rows.width] : (double)NAN;
  if (m->broken == EOM_OK && !m->no_memory && !(fabs(last - m->t) <= same_time * m->ask.every)) add_row(m, m->t, m->y);
  m->end = judge(m, sys, status);
  eom_trajectory_destroy(trajectory);
}
