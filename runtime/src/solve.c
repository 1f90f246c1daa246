/* Accelerations, multipliers and constraint forces; the verdict on each constraint row. */
#include "eom/solve.h"

#include "baumgarte.h"
#include "evaluate.h"
#include "factor.h"
#include "lanes.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

/* Puts the rows that are not independent in the report. */
static eom_status name_rows(eom_system *sys) {
  eom_report *report = &sys->report;
  report->nrow = 0;
  for (int r = 0; r < sys->m; r++) {
    if (sys->row_kind[r] == EOM_ROW_INDEPENDENT) continue;
    if (report->nrow < EOM_REPORT_ROWS) report->row[report->nrow] = eom_system_row(sys, r);
    report->nrow++;
  }
  return report->status;
}

eom_status eom_mark_rows(eom_system *sys, int rank) {
  const eom_factor *f = &sys->workspace->factor;
  for (int r = 0; r < sys->m; r++) sys->row_kind[r] = EOM_ROW_DEPENDENT;
  for (int j = 0; j < rank; j++) sys->row_kind[f->pivot[j]] = EOM_ROW_INDEPENDENT;
  return name_rows(sys);
}

/* Inconsistent rows keep a residual. Rows in use are compared scaled to unit length in the mass metric, where a residual is an
 * acceleration; the scale is the largest acceleration or term of b. */
static eom_status judge_rows(eom_system *sys) {
  const eom_workspace *ws = sys->workspace;
  const eom_factor *f = &ws->factor;
  eom_report *report = &sys->report;
  const int n = sys->n;
  tl_real scale = TL_C(0.0);
  for (int i = 0; i < n; i++) scale = TL_LIBM(fmax)(scale, TL_LIBM(fabs)(sys->qdd[i] / f->S[i]));
  for (int k = 0; k < f->count; k++) {
    const int r = f->row[k];
    scale = TL_LIBM(fmax)(scale, f->D[r] * TL_LIBM(fmax)(ws->b_size[r], TL_LIBM(fabs)(sys->b[r])));
  }

  bool consistent = true;
  (void)eom_mark_rows(sys, f->rank);
  for (int k = 0; k < f->count; k++) {
    const int r = f->row[k];
    tl_real miss = -sys->b[r];
    for (int i = 0; i < n; i++) miss += sys->A[r * n + i] * sys->qdd[i];
    miss = TL_LIBM(fabs)(miss) * f->D[r];
    if (!(miss <= report->residual)) report->residual = miss;
    if (f->rank == f->count || miss <= sys->options.consistency_tolerance * scale) continue;
    sys->row_kind[r] = EOM_ROW_INCONSISTENT;
    consistent = false;
  }
  if (!consistent) report->status = EOM_INCONSISTENT;
  return name_rows(sys);
}

eom_status eom_factor_rows(eom_system *sys) {
  const eom_held *held = &sys->workspace->held;
  const bool keep = held->rank >= 0;
  const int count = keep ? held->rank : sys->m;
  const eom_selection rows = {keep ? held->row : NULL, count, count, sys->options.rank_tolerance};
  if (eom_factor_make(sys, &rows) != EOM_OK || !keep || sys->report.rank == count) return sys->report.status;
  sys->report.status = EOM_RANK_FELL;
  return eom_mark_rows(sys, sys->report.rank);
}

/* Of finite numbers. */
static eom_status solve(eom_system *sys) {
  const int n = sys->n, m = sys->m;
  sys->report = (eom_report){.status = EOM_OK, .index = -1, .rank = -1, .condition = TL_C(1.0)};
  if (eom_factor_rows(sys) != EOM_OK) return sys->report.status;
  eom_kkt_solve(sys, sys->qdd, sys->lambda, sys->Q, sys->b);
  memset(sys->Qc, 0, (size_t)n * sizeof(tl_real));
  for (int r = 0; r < m; r++)
    for (int i = 0; i < n; i++) sys->Qc[i] += sys->A[r * n + i] * sys->lambda[r];
  if (eom_check_finite(sys, "acceleration", sys->qdd, n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "multiplier", sys->lambda, m) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint force", sys->Qc, n) != EOM_OK) return sys->report.status;
  return m > 0 ? judge_rows(sys) : EOM_OK;
}

eom_status eom_solve(eom_system *sys) {
  assert(sys && sys->workspace);
  const int n = sys->n, m = sys->m;
  sys->report = (eom_report){.status = EOM_OK, .index = -1, .rank = -1};
  if (eom_check_finite(sys, "mass matrix", sys->M, n * n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "generalized force", sys->Q, n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint matrix", sys->A, m * n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint vector b", sys->b, m) != EOM_OK) return sys->report.status;
  return solve(sys);
}

/* By motion functions the size of cancelling terms in b is at first taken as zero: the strictest judgement, which consistent rows pass
 * in nearly all cases. */
eom_status eom_solve_at(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  if (eom_assemble_parts(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (solve(sys) != EOM_INCONSISTENT || !eom_by_motion(sys, EOM_TASK_ASSEMBLE)) return sys->report.status;
  return eom_size_rows(sys, q, qd, t) == EOM_OK ? solve(sys) : sys->report.status;
}

eom_status eom_solved_by_motion(eom_system *sys, int code, const tl_real *q, const tl_real *qd, tl_real t) {
  if (code != 0) return eom_motion_verdict(sys, code, q, qd, t);
  sys->report.rank = 0;
  sys->report.pivot = TL_C(-1.0);
  sys->report.condition = TL_C(1.0);
  return EOM_OK;
}

/* Without Baumgarte's terms, and no row dropped. */
static bool all_rows_as_they_are(const eom_system *sys) {
  const int rank = sys->workspace->held.rank;
  return !eom_is_stabilised(sys) && (rank < 0 || rank == sys->m);
}

/* A solved form of constrained equations, whose rows are independent. */
static eom_status constrained_by_motion(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const int code = sys->motion->constrained(sys->params, q, qd, t, sys->qdd, sys->lambda, sys->Qc, sys->workspace->motion_work);
  if (code == EOM_MOTION_PIVOT) return eom_solve_at(sys, q, qd, t);
  if (eom_solved_by_motion(sys, code, q, qd, t) != EOM_OK) return sys->report.status;
  for (int i = 0; i < sys->n; i++) sys->Qc[i] += TL_C(0.0); /* 0 for -0, as in sums that begin with 0 */
  for (int r = 0; r < sys->m; r++) sys->row_kind[r] = EOM_ROW_INDEPENDENT;
  sys->report.rank = sys->m;
  sys->report.condition = sys->report.residual = TL_C(-1.0);
  return EOM_OK;
}

eom_status eom_acceleration(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const bool by_motion = eom_by_motion(sys, EOM_TASK_ASSEMBLE);
  const bool constrained = by_motion && sys->motion->constrained && all_rows_as_they_are(sys);
  if (!constrained && !(by_motion && sys->motion->acceleration))
    return eom_start(sys, q, qd, t) == EOM_OK ? eom_solve_at(sys, q, qd, t) : sys->report.status;
  if (eom_start_sized(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (constrained) return constrained_by_motion(sys, q, qd, t);
  const int code = sys->motion->acceleration(sys->params, q, qd, t, sys->qdd, sys->workspace->motion_work);
  return code == EOM_MOTION_PIVOT ? eom_solve_at(sys, q, qd, t) : eom_solved_by_motion(sys, code, q, qd, t);
}

/* Where rows are dependent, one by one. */
static void solve_each(eom_system *sys, int k, tl_real *r, tl_real *g) {
  eom_workspace *ws = sys->workspace;
  const int n = sys->n, m = sys->m;
  for (int j = 0; j < k; j++) {
    for (int i = 0; i < n; i++) ws->rhs1[i] = -r[i * k + j];
    for (int i = 0; i < m; i++) ws->rhs2[i] = -g[i * k + j];
    eom_kkt_solve(sys, ws->sol1, ws->sol2, ws->rhs1, ws->rhs2);
    for (int i = 0; i < n; i++) r[i * k + j] = ws->sol1[i];
    for (int i = 0; i < m; i++) g[i * k + j] = ws->sol2[i];
  }
}

void eom_solve_columns(eom_system *sys, int k, tl_real *r, tl_real *g) {
  if (sys->workspace->factor.rank == sys->workspace->factor.count)
    eom_lanes_solve(sys, k, r, g);
  else
    solve_each(sys, k, r, g);
}

static eom_status check_columns(eom_system *sys, const char *name, int k, const tl_real *x, const tl_real *y) {
  if (eom_check_finite(sys, name, x, sys->n * k) != EOM_OK) return sys->report.status;
  return eom_check_finite(sys, name, y, sys->m * k);
}

eom_status eom_solve_more(eom_system *sys, int k, tl_real *x, tl_real *y) {
  assert(sys && k > 0 && x && (y || sys->m == 0) && sys->workspace->sol1);
  if (check_columns(sys, "right-hand side", k, x, y) != EOM_OK) return sys->report.status;
  for (int i = 0; i < sys->n * k; i++) x[i] = -x[i];
  for (int i = 0; i < sys->m * k; i++) y[i] = -y[i];
  eom_solve_columns(sys, k, x, y);
  return check_columns(sys, "solution", k, x, y);
}

int eom_rhs(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  eom_system *sys = user;
  const size_t n = (size_t)sys->n;
  const eom_status status = eom_acceleration(sys, y, y + n, t);
  if (status != EOM_OK) return (int)status;
  memcpy(ydot, y + n, n * sizeof(tl_real));
  memcpy(ydot + n, sys->qdd, n * sizeof(tl_real));
  return 0;
}
