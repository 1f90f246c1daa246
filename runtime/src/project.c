/* Newton's method on the constraint rows, in the mass metric: M delta - A' mu = 0, A delta = -miss, with the factors of eom_solve. */
#include "eom/project.h"

#include "evaluate.h"
#include "factor.h"

#include <assert.h>
#include <string.h>

enum { MOST_STEPS = 30 };

/* One of the two levels: rows 0..count-1 of A move x, the coordinates or the velocities, to where what they miss is zero. */
typedef struct level {
  tl_real *x;
  const unsigned char *keep;
  int count;
  void (*misses)(const eom_system *sys, tl_real *miss);
} level;

static void misses_of_coordinates(const eom_system *sys, tl_real *miss) {
  for (int r = 0; r < sys->m1; r++) miss[r] = sys->phi[r];
}

static void misses_of_velocities(const eom_system *sys, tl_real *miss) {
  for (int r = 0; r < sys->m1; r++) miss[r] = sys->phi_dot[r];
  for (int r = 0; r < sys->m2; r++) miss[sys->m1 + r] = sys->psi[r];
}

/* What is kept does not move: no row acts on it, and it has an inertia of its own. */
static void hold(eom_system *sys, const unsigned char *keep) {
  const int n = sys->n;
  for (int i = 0; keep && i < n; i++) {
    if (!keep[i]) continue;
    for (int j = 0; j < n; j++) sys->M[i * n + j] = sys->M[j * n + i] = TL_C(0.0);
    sys->M[i * n + i] = TL_C(1.0);
    for (int r = 0; r < sys->m; r++) sys->A[r * n + i] = TL_C(0.0);
  }
}

/* The largest number of x, coordinates scaled to unit inertia. */
static tl_real extent(const eom_system *sys, const tl_real *x) {
  tl_real most = TL_C(0.0);
  for (int i = 0; i < sys->n; i++) most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i] / sys->workspace->factor.S[i]));
  return most;
}

/* Rows that are dependent on the manifold look independent beside it, by about the way that is left: they are taken as dependent, or
 * the step along their difference would be as long as they are alike. */
static void factor_near(eom_system *sys, tl_real way) {
  const tl_real given = sys->options.rank_tolerance, most = TL_C(1e-3);
  sys->options.rank_tolerance = TL_LIBM(fmax)(given, TL_LIBM(fmin)(way, most));
  (void)eom_factor_make(sys);
  sys->options.rank_tolerance = given;
}

/* delta and multipliers of one step, in sys->qdd and sys->lambda. */
static eom_status find_step(eom_system *sys, const level *l, tl_real way) {
  const eom_workspace *ws = sys->workspace;
  const int m = sys->m;
  sys->m = l->count; /* the rows of this level come first */
  hold(sys, l->keep);
  l->misses(sys, ws->miss);
  for (int r = 0; r < sys->m; r++) ws->miss[r] = -ws->miss[r];
  factor_near(sys, way);
  if (sys->report.status == EOM_OK) {
    memset(sys->Qc, 0, (size_t)sys->n * sizeof(tl_real));
    eom_kkt_solve(sys, sys->qdd, sys->lambda, sys->Qc, ws->miss);
    for (int i = 0; i < sys->n; i++)
      if (l->keep && l->keep[i]) sys->qdd[i] = TL_C(0.0);
  }
  sys->m = m;
  return sys->report.status;
}

/* Names the rows that still miss by more than rounding, each miss as a length in the mass metric. */
static eom_status judge(eom_system *sys, const level *l, tl_real size) {
  const eom_workspace *ws = sys->workspace;
  for (int r = 0; r < l->count; r++) {
    if (TL_LIBM(fabs)(ws->miss[r]) * ws->factor.D[r] <= sys->options.consistency_tolerance * size) continue;
    sys->report.status = EOM_INCONSISTENT;
    if (sys->report.nrow < EOM_REPORT_ROWS) {
      sys->report.row[sys->report.nrow] = eom_system_row(sys, r);
      sys->report.row[sys->report.nrow].kind = EOM_ROW_INCONSISTENT;
    }
    sys->report.nrow++;
  }
  return sys->report.status;
}

/* Steps until they are rounding, or no longer fall though they are nearly that: the last digit of the rows then. */
static eom_status descend(eom_system *sys, const level *l, const tl_real *q, const tl_real *qd, tl_real t, int *steps) {
  const tl_real rounding = TL_C(4.0) * TL_EPSILON, nearly = TL_LIBM(sqrt)(TL_EPSILON);
  tl_real last = TL_MAX, way = TL_C(0.0);
  for (*steps = 0; *steps < MOST_STEPS;) {
    if (eom_assemble_parts(sys, q, qd, t) != EOM_OK || find_step(sys, l, way) != EOM_OK) return sys->report.status;
    const tl_real change = extent(sys, sys->qdd), size = TL_LIBM(fmax)(extent(sys, l->x), change);
    if (!(change > rounding * size) || (!(change < last / TL_C(2.0)) && change <= nearly * size)) return judge(sys, l, size);
    for (int i = 0; i < sys->n; i++) l->x[i] += sys->qdd[i];
    ++*steps;
    last = change;
    way = change / size;
  }
  return sys->report.status = EOM_NO_CONSISTENT_STATE;
}

/* The largest change of x, and whose. */
static void measure(int n, const tl_real *x, const tl_real *was, tl_real *change, int *most) {
  *change = TL_C(0.0);
  *most = -1;
  for (int i = 0; i < n; i++) {
    const tl_real d = TL_LIBM(fabs)(x[i] - was[i]);
    if (d > *change) *change = d, *most = i;
  }
}

eom_status eom_project(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_projection *projection) {
  assert(sys && q && qd);
  eom_projection ignored = {0}, *p = projection ? projection : &ignored;
  const int n = sys->n;
  const size_t bytes = (size_t)n * sizeof(tl_real);
  tl_real *was_q = sys->workspace->was, *was_qd = was_q + n;
  if (eom_start(sys, q, qd, t) != EOM_OK) return sys->report.status;
  memcpy(was_q, q, bytes);
  memcpy(was_qd, qd, bytes);
  const level coordinates = {q, p->keep_q, sys->m1, misses_of_coordinates};
  const level velocities = {qd, p->keep_qd, sys->m, misses_of_velocities};
  p->steps_q = p->steps_qd = 0;
  if (sys->m1 > 0) (void)descend(sys, &coordinates, q, qd, t, &p->steps_q);
  if (sys->report.status == EOM_OK && sys->m > 0) (void)descend(sys, &velocities, q, qd, t, &p->steps_qd);
  if (sys->report.status != EOM_OK) {
    memcpy(q, was_q, bytes);
    memcpy(qd, was_qd, bytes);
  }
  measure(n, q, was_q, &p->change_q, &p->most_q);
  measure(n, qd, was_qd, &p->change_qd, &p->most_qd);
  return sys->report.status;
}

int eom_project_state(void *user, tl_real t, tl_real *y) {
  eom_system *sys = user;
  return (int)eom_project(sys, y, y + sys->n, t, NULL);
}
