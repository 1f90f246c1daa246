/* Accelerations, multipliers and constraint forces; the verdict on each constraint row. */
#include "eom/solve.h"

#include "eom/assemble.h"
#include "factor.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

/* Dependent rows are those beyond the rank in the order of exchange; inconsistent ones keep a residual. Rows are compared scaled to
 * unit length in the mass metric, where a residual is an acceleration; the scale is the largest acceleration or term of b. */
static eom_status judge_rows(eom_system *sys) {
  const eom_workspace *ws = sys->workspace;
  const eom_factor *f = &ws->factor;
  eom_report *report = &sys->report;
  const int n = sys->n, m = sys->m;
  for (int j = 0; j < m; j++) sys->row_kind[f->pivot[j]] = j < f->rank ? EOM_ROW_INDEPENDENT : EOM_ROW_DEPENDENT;

  tl_real scale = TL_C(0.0);
  for (int i = 0; i < n; i++) scale = TL_LIBM(fmax)(scale, TL_LIBM(fabs)(sys->qdd[i] / f->S[i]));
  for (int r = 0; r < m; r++) scale = TL_LIBM(fmax)(scale, f->D[r] * TL_LIBM(fmax)(ws->b_size[r], TL_LIBM(fabs)(sys->b[r])));

  bool consistent = true;
  for (int r = 0; r < m; r++) {
    tl_real miss = -sys->b[r];
    for (int i = 0; i < n; i++) miss += sys->A[r * n + i] * sys->qdd[i];
    miss = TL_LIBM(fabs)(miss) * f->D[r];
    if (!(miss <= report->residual)) report->residual = miss;
    if (f->rank == m || miss <= sys->options.consistency_tolerance * scale) continue;
    sys->row_kind[r] = EOM_ROW_INCONSISTENT;
    consistent = false;
  }
  for (int r = 0; r < m; r++) {
    if (sys->row_kind[r] == EOM_ROW_INDEPENDENT) continue;
    if (report->nrow < EOM_REPORT_ROWS) report->row[report->nrow] = eom_system_row(sys, r);
    report->nrow++;
  }
  if (!consistent) report->status = EOM_INCONSISTENT;
  return report->status;
}

eom_status eom_solve(eom_system *sys) {
  assert(sys && sys->workspace);
  const int n = sys->n, m = sys->m;
  sys->report = (eom_report){.status = EOM_OK, .index = -1, .rank = -1, .condition = TL_C(1.0)};
  if (eom_factor_make(sys) != EOM_OK) return sys->report.status;
  eom_kkt_solve(sys, sys->qdd, sys->lambda, sys->Q, sys->b);
  memset(sys->Qc, 0, (size_t)n * sizeof(tl_real));
  for (int r = 0; r < m; r++)
    for (int i = 0; i < n; i++) sys->Qc[i] += sys->A[r * n + i] * sys->lambda[r];
  if (eom_check_finite(sys, "acceleration", sys->qdd, n) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "multiplier", sys->lambda, m) != EOM_OK) return sys->report.status;
  if (eom_check_finite(sys, "constraint force", sys->Qc, n) != EOM_OK) return sys->report.status;
  return m > 0 ? judge_rows(sys) : EOM_OK;
}

eom_status eom_acceleration(eom_system *sys, const tl_real *q, const tl_real *qd, tl_real t) {
  const eom_status status = eom_assemble(sys, q, qd, t);
  return status == EOM_OK ? eom_solve(sys) : status;
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
