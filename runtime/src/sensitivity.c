/* Forward sensitivities: the motion with columns of derivatives, and what constraints ask of these. */
#include "eom/sensitivity.h"

#include "eom/project.h"
#include "eom/solve.h"
#include "evaluate.h"
#include "factor.h"
#include "stage.h"
#include "tangent_flow.h"

#include <assert.h>
#include <string.h>

/* ---- the right-hand side ---- */

/* The columns' own workspace; then rates of constraints G: m x n, and one column's parts. */
size_t eom_sensitivity_size(const eom_system *sys, int directions, int parameters) {
  const size_t n = (size_t)sys->n, m = (size_t)sys->m;
  return eom_columns_size(sys, directions + parameters, parameters) + m * n + 4 * n + 2 * m;
}

static eom_columns columns_of(const eom_sensitivity *s) {
  return (eom_columns){.k = s->k, .np = s->parameters, .parameter = s->parameter, .work = s->work};
}

static int parameters_exist(const eom_system *sys, int count, const int *parameter) {
  if (count == 0) return 1;
  if (!(sys->options.needs & EOM_NEED_PARAMETERS) || count > sys->motion->np) return 0;
  for (int i = 0; parameter && i < count; i++)
    if (parameter[i] < 0 || parameter[i] >= sys->motion->np) return 0;
  return 1;
}

eom_status eom_sensitivity_init(eom_sensitivity *s, eom_system *sys, int directions, int parameters, const int *parameter,
                                tl_real *work) {
  assert(s && sys && work);
  *s = (eom_sensitivity){.sys = sys,
                         .directions = directions,
                         .parameters = parameters,
                         .parameter = parameter,
                         .k = directions + parameters,
                         .column = -1,
                         .work = work};
  if (directions < 0 || parameters < 0 || s->k == 0) return EOM_BAD_OPTION;
  if (!(sys->options.needs & (EOM_NEED_TANGENT | EOM_NEED_LINEARISE))) return EOM_BAD_OPTION;
  if (!parameters_exist(sys, parameters, parameter)) return EOM_BAD_OPTION;
  s->dim = 2 * sys->n * (1 + s->k);
  return EOM_OK;
}

void eom_sensitivity_start(const eom_sensitivity *s, tl_real *z, const tl_real *y) {
  const int d = 2 * s->sys->n;
  memcpy(z, y, (size_t)d * sizeof(tl_real));
  for (int i = 0; i < d; i++)
    for (int j = 0; j < s->k; j++) z[d + i * s->k + j] = j == i && j < s->directions ? TL_C(1.0) : TL_C(0.0);
}

int eom_sensitivity_rhs(void *user, tl_real t, const tl_real *z, tl_real *zdot) {
  const eom_sensitivity *s = user;
  const eom_columns columns = columns_of(s);
  return (int)eom_tangent_flow(s->sys, &columns, t, z, zdot);
}

/* ---- constraints ---- */

/* Parts of the workspace behind that of the columns. */
typedef struct parts {
  tl_real *G;             /* m x n: d(phi_dot, psi)/dq */
  tl_real *dq, *dqd;      /* n each: a column */
  tl_real *change, *zero; /* n each */
  tl_real *miss, *mu;     /* m each */
} parts;

static parts parts_of(const eom_sensitivity *s) {
  const size_t n = (size_t)s->sys->n, m = (size_t)s->sys->m;
  parts p = {.G = s->work + eom_columns_size(s->sys, s->k, s->parameters)};
  p.dq = p.G + m * n;
  p.dqd = p.dq + n;
  p.change = p.dqd + n;
  p.zero = p.change + n;
  p.miss = p.zero + n;
  p.mu = p.miss + m;
  memset(p.zero, 0, n * sizeof(tl_real));
  return p;
}

/* The first count rows of A with M, as project.c does. */
static eom_status factor_rows(eom_system *sys, int count) {
  const eom_selection rows = {NULL, count, count, sys->options.rank_tolerance};
  const int m = sys->m;
  sys->m = count;
  const eom_status status = eom_factor_make(sys, &rows);
  sys->m = m;
  return status;
}

/* x += the shortest change in the mass metric with A x = -rest for the rows last factored, rest in p->miss. */
static void move_onto_rows(eom_system *sys, const parts *p, int count, tl_real *x) {
  const int n = sys->n, m = sys->m;
  for (int r = 0; r < count; r++) {
    tl_real sum = p->miss[r];
    for (int i = 0; i < n; i++) sum += sys->A[r * n + i] * x[i];
    p->miss[r] = -sum;
  }
  sys->m = count;
  eom_kkt_solve(sys, p->change, p->mu, p->zero, p->miss);
  sys->m = m;
  for (int i = 0; i < n; i++) x[i] += p->change[i];
}

static tl_real *row_of(const eom_sensitivity *s, tl_real *z, int i) { return z + 2 * s->sys->n + i * s->k; }

/* A column's part of coordinates (first = 0) or of velocities (first = n). */
static void read_column(const eom_sensitivity *s, tl_real *z, int first, int j, tl_real *x) {
  for (int i = 0; i < s->sys->n; i++) x[i] = row_of(s, z, first + i)[j];
}

static void write_column(eom_sensitivity *s, tl_real *z, int first, int j, const tl_real *x) {
  for (int i = 0; i < s->sys->n; i++) {
    tl_real *at = row_of(s, z, first + i) + j;
    const tl_real change = TL_LIBM(fabs)(x[i] - *at);
    if (change > s->change) s->change = change, s->column = j;
    *at = x[i];
  }
}

/* dq of each direction onto A dq = 0. */
static eom_status project_coordinates(eom_sensitivity *s, const parts *p, tl_real *z) {
  eom_system *sys = s->sys;
  if (sys->m1 == 0) return EOM_OK;
  if (factor_rows(sys, sys->m1) != EOM_OK) return sys->report.status;
  for (int j = 0; j < s->directions; j++) {
    read_column(s, z, 0, j, p->dq);
    memset(p->miss, 0, (size_t)sys->m * sizeof(tl_real));
    move_onto_rows(sys, p, sys->m1, p->dq);
    write_column(s, z, 0, j, p->dq);
  }
  return EOM_OK;
}

/* dqd of each direction onto A dqd = -G dq. */
static eom_status project_velocities(eom_sensitivity *s, const parts *p, tl_real *z) {
  eom_system *sys = s->sys;
  if (sys->m2 > 0 && factor_rows(sys, sys->m) != EOM_OK) return sys->report.status;
  for (int j = 0; j < s->directions; j++) {
    read_column(s, z, 0, j, p->dq);
    read_column(s, z, sys->n, j, p->dqd);
    eom_multiply(sys->m, sys->n, 1, p->miss, p->G, p->dq);
    move_onto_rows(sys, p, sys->m, p->dqd);
    write_column(s, z, sys->n, j, p->dqd);
  }
  return EOM_OK;
}

eom_status eom_sensitivity_project(eom_sensitivity *s, tl_real t, tl_real *z) {
  eom_system *sys = s->sys;
  const tl_real *q = z, *qd = z + sys->n;
  s->change = TL_C(0.0);
  s->column = -1;
  if (sys->m == 0) return EOM_OK;
  const parts p = parts_of(s);
  if (eom_start(sys, q, qd, t) != EOM_OK || eom_constraint_rates(sys, p.G, q, qd, t) != EOM_OK) return sys->report.status;
  if (eom_assemble_parts(sys, q, qd, t) != EOM_OK || project_coordinates(s, &p, z) != EOM_OK) return sys->report.status;
  if (project_velocities(s, &p, z) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, "sensitivity", z + 2 * sys->n, 2 * sys->n * s->k);
}

int eom_sensitivity_correct(void *user, tl_real t, tl_real *z) {
  eom_sensitivity *s = user;
  const int code = eom_project_state(s->sys, t, z);
  return code == 0 ? (int)eom_sensitivity_project(s, t, z) : code;
}

/* ---- events ---- */

eom_status eom_sensitivity_event(const eom_sensitivity *s, tl_real *dt, tl_real *dy, const tl_real *g_y, tl_real g_t, tl_real t,
                                 const tl_real *z) {
  eom_system *sys = s->sys;
  const int n = sys->n, k = s->k;
  const tl_real *qd = z + n, *S = z + 2 * n;
  if (eom_acceleration(sys, z, qd, t) != EOM_OK) return sys->report.status;
  tl_real rate = g_t;
  for (int i = 0; i < n; i++) rate += g_y[i] * qd[i] + g_y[n + i] * sys->qdd[i];
  eom_multiply(1, 2 * n, k, dt, g_y, S);
  for (int j = 0; j < k; j++) dt[j] /= -rate;
  for (int i = 0; dy && i < 2 * n; i++)
    for (int j = 0; j < k; j++) dy[i * k + j] = S[i * k + j] + (i < n ? qd[i] : sys->qdd[i - n]) * dt[j];
  return eom_check_finite(sys, "derivative of the event's time", dt, k);
}
