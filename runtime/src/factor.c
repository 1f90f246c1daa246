/* Factorisation and refined solution of M dq - A' dl = r1, A dq = r2 (eqs 30-32).
 *
 *   calM = M + A'WA = S^-1 L L' S^-1            W = 0 where M alone is safely positive definite
 *   B = L^-1 S A',  B D P = Q [R11 R12; 0 R22]  D: columns of unit length, R22 negligible, rank r
 *   [R11 R12]' = U [T; 0]                       where r < m; otherwise U = 1, T = R11'
 *
 * With calM dq = r1 + A' mu, L' S^-1 dq = Q (v, y2) and Q' L^-1 S r1 = (y1, y2):
 *   A dq = r2                 [R11 R12]' v = P' D r2, in the least-squares sense
 *   multipliers               [R11 R12] P' D^-1 mu = v - y1, of least norm, and dl = mu - W r2.
 * A calM^-1 A' is never formed. v alone meets the constraint, so nothing cancels there. */
#include "factor.h"

#include <string.h>

/* Smallest pivot, relative to a unit diagonal, of a matrix taken as safely positive definite: rounding costs at most ten of the sixteen
 * digits of the factors, which refinement gives back. */
#define EOM_SAFE_PIVOT (TL_C(64.0) * TL_LIBM(sqrt)(TL_EPSILON))

/* Smallest pivot with the user's own weights: refinement still gains three digits a step. */
#define EOM_USABLE_PIVOT (TL_C(4096.0) * TL_EPSILON)

/* Smallest pivot that is not rounding in a factorisation of order n. */
static tl_real least_pivot(int n) { return TL_C(8.0) * (tl_real)n * TL_EPSILON; }

/* A matrix that is indefinite along a direction the constraints forbid needs more than weights of its own size. No weight is above
 * this: the stronger A'WA, the fewer digits of M are left beside it, which no pivot shows. */
#define EOM_STRONG_WEIGHT TL_C(4096.0)

static tl_real largest(int n, const tl_real *x) {
  tl_real most = TL_C(0.0);
  for (int i = 0; i < n; i++) most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i]));
  return most;
}

/* ---- calM and its Cholesky factorisation ---- */

/* The lower triangle of M + A'WA in f->L. */
static void build_calM(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  f->kept = false;
  memcpy(f->L, sys->M, (size_t)n * (size_t)n * sizeof(tl_real));
  if (!f->weighted) return;
  for (int r = 0; r < sys->m; r++) {
    const tl_real *a = sys->A + r * n;
    for (int i = 0; i < n; i++) {
      const tl_real wa = f->W[r] * a[i];
      for (int j = 0; j <= i; j++) f->L[i * n + j] += wa * a[j];
    }
  }
}

/* f->L = S calM S with powers of two in S that bring the diagonal near 1. Returns n, or the coordinate whose diagonal is not positive.
 */
static int scale_calM(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  for (int i = 0; i < n; i++) {
    const tl_real d = f->L[i * n + i];
    if (!(d > TL_C(0.0) && d <= TL_MAX)) return i;
    f->S[i] = TL_LIBM(ldexp)(TL_C(1.0), -(TL_LIBM(ilogb)(d) / 2));
  }
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) f->L[i * n + j] *= f->S[i] * f->S[j];
  return n;
}

/* Builds, scales and factors calM with the weights in f->W. Returns the smallest pivot relative to a unit diagonal, 0 where one is not
 * positive. */
static tl_real factor_calM(eom_system *sys, bool weighted) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  f->weighted = weighted;
  build_calM(sys);
  if (scale_calM(sys) < n) return TL_C(0.0);
  for (int i = 0; i < n; i++) f->y[i] = f->L[i * n + i];
  if (sys->workspace->linalg->cholesky(n, f->L) != 0) return TL_C(0.0);
  tl_real least = TL_C(1.0);
  for (int i = 0; i < n; i++) {
    const tl_real l = f->L[i * n + i], pivot = l * l / f->y[i];
    if (!(pivot >= least)) least = pivot;
  }
  return least;
}

/* The same with calM = M. An M of parameters alone is factored again only where its numbers are not those of the last time. */
static tl_real factor_mass(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  if (!f->kept_M) return factor_calM(sys, false);
  const size_t bytes = (size_t)sys->n * (size_t)sys->n * sizeof(tl_real);
  if (!f->kept || memcmp(f->kept_M, sys->M, bytes) != 0) {
    f->kept_pivot = factor_calM(sys, false);
    memcpy(f->kept_M, sys->M, bytes);
    f->kept = f->kept_pivot > TL_C(0.0);
  }
  f->weighted = false;
  return f->kept_pivot;
}

/* Rows that are left out have no weight. */
static void clear_weights(eom_system *sys) { memset(sys->workspace->factor.W, 0, (size_t)sys->m * sizeof(tl_real)); }

/* W_r = strength / |a_r|^2 in coordinates where M has a unit diagonal: then A'WA is of M's size row by row. */
static void automatic_weights(eom_system *sys, tl_real strength) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  tl_real most = TL_C(0.0);
  for (int i = 0; i < n; i++) most = TL_LIBM(fmax)(most, sys->M[i * n + i]);
  if (!(most > TL_C(0.0))) most = TL_C(1.0);
  for (int k = 0; k < f->count; k++) {
    const int r = f->row[k];
    const tl_real *a = sys->A + r * n;
    tl_real sum = TL_C(0.0);
    for (int i = 0; i < n; i++) {
      const tl_real d = sys->M[i * n + i];
      sum += a[i] * a[i] / (d > TL_EPSILON * most ? d : most);
    }
    f->W[r] = sum > TL_C(0.0) && sum <= TL_MAX ? strength / sum : TL_C(0.0);
    if (!(f->W[r] <= TL_MAX)) f->W[r] = TL_C(0.0);
  }
}

/* Those of the options, cut where they are too strong. */
static void users_weights(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  automatic_weights(sys, EOM_STRONG_WEIGHT);
  for (int k = 0; k < f->count; k++) f->W[f->row[k]] = TL_LIBM(fmin)(f->W[f->row[k]], sys->options.weights[f->row[k]]);
}

/* Finds a calM that is positive definite by the pivot test: the user's weights, or M alone, then weights of M's size, then stronger
 * ones. Returns its smallest pivot, or 0. */
static tl_real choose_calM(eom_system *sys) {
  const tl_real none = least_pivot(sys->n);
  if (sys->m == 0) {
    const tl_real pivot = factor_mass(sys);
    return pivot > none ? pivot : TL_C(0.0);
  }
  clear_weights(sys);
  if (sys->options.weights) {
    users_weights(sys);
    const tl_real pivot = factor_calM(sys, true);
    if (pivot >= EOM_USABLE_PIVOT) return pivot;
  } else {
    const tl_real pivot = factor_mass(sys);
    if (pivot >= EOM_SAFE_PIVOT) return pivot;
  }
  automatic_weights(sys, TL_C(1.0));
  const tl_real modest = factor_calM(sys, true);
  if (modest >= EOM_SAFE_PIVOT) return modest;
  automatic_weights(sys, EOM_STRONG_WEIGHT);
  const tl_real strong = factor_calM(sys, true);
  if (strong > modest) return strong > none ? strong : TL_C(0.0);
  automatic_weights(sys, TL_C(1.0));
  return factor_calM(sys, true) > none ? modest : TL_C(0.0);
}

/* A coordinate that moves along x with calM x = 0: where pivot k fails, x = (-L11^-T l_k, 1, 0..0). */
static int coordinate_without_inertia(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  build_calM(sys);
  int k = scale_calM(sys);
  if (k < n) return k;
  k = eom_linalg_core.cholesky(n, f->L) - 1;
  for (int i = 0; k < 0 && i < n; i++)
    if (f->L[i * n + i] * f->L[i * n + i] <= least_pivot(n)) k = i;
  if (k < 0) k = n - 1;
  tl_real *x = f->y;
  for (int i = 0; i < k; i++) x[i] = -f->L[k * n + i];
  int most = k;
  tl_real size = TL_C(1.0);
  for (int i = k - 1; i >= 0; i--) {
    x[i] /= f->L[i * n + i];
    for (int j = 0; j < i; j++) x[j] -= f->L[i * n + j] * x[i];
  }
  for (int i = 0; i < k; i++)
    if (TL_LIBM(fabs)(x[i]) > size * (TL_C(1.0) + TL_LIBM(sqrt)(TL_EPSILON))) {
      size = TL_LIBM(fabs)(x[i]);
      most = i;
    }
  return most;
}

/* ---- B and its rank ---- */

/* Brings a vector to unit length. Returns the factor it was multiplied by, 1 for the zero vector. */
static tl_real normalise(int n, tl_real *x) {
  const tl_real most = largest(n, x);
  if (!(most > TL_C(0.0))) return TL_C(1.0);
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < n; i++) {
    x[i] /= most;
    sum += x[i] * x[i];
  }
  const tl_real length = TL_LIBM(sqrt)(sum);
  for (int i = 0; i < n; i++) x[i] /= length;
  return TL_C(1.0) / (most * length);
}

/* The vectors of B become those of L^-1 S A', of unit length; pivots: rows of A. */
static void factor_rows(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  const eom_linalg *la = sys->workspace->linalg;
  const int n = sys->n, count = f->count;
  for (int k = 0; k < count; k++)
    for (int i = 0; i < n; i++) f->B[k * n + i] = f->S[i] * sys->A[f->row[k] * n + i];
  la->solve_lower(n, f->L, count, f->B);
  for (int k = 0; k < count; k++) f->D[f->row[k]] = normalise(n, f->B + k * n);
  la->qr(n, count, f->B, f->pivot, f->tau, f->work, f->nwork);
  for (int j = 0; j < count; j++) f->pivot[j] = f->row[f->pivot[j]];
}

tl_real eom_factor_pivot(const eom_system *sys, int j) { return TL_LIBM(fabs)(sys->workspace->factor.B[j * (sys->n + 1)]); }

int eom_factor_rank(const eom_system *sys, tl_real tolerance) {
  const eom_factor *f = &sys->workspace->factor;
  const int n = sys->n, least = n < f->count ? n : f->count;
  int rank = 0;
  while (rank < least && eom_factor_pivot(sys, rank) > tolerance) rank++;
  return rank;
}

/* [R11 R12]' = U [T; 0] where rows are dependent. */
static void factor_dependence(eom_system *sys) {
  eom_factor *f = &sys->workspace->factor;
  const int n = sys->n, count = f->count;
  if (f->rank == count) return;
  for (int i = 0; i < f->rank; i++)
    for (int j = 0; j < count; j++) f->U[i * count + j] = j < i ? TL_C(0.0) : f->B[j * n + i];
  sys->workspace->linalg->qr(count, f->rank, f->U, NULL, f->tau_u, f->work, f->nwork);
}

static void select_rows(eom_factor *f, const eom_selection *rows) {
  f->count = rows->count;
  for (int k = 0; k < rows->count; k++) f->row[k] = rows->row ? rows->row[k] : k;
}

eom_status eom_factor_make(eom_system *sys, const eom_selection *rows) {
  eom_factor *f = &sys->workspace->factor;
  eom_report *report = &sys->report;
  report->rank = 0;
  report->condition = TL_C(1.0);
  select_rows(f, rows);
  report->pivot = choose_calM(sys);
  report->weighted = f->weighted;
  f->rank = 0;
  if (!(report->pivot > TL_C(0.0))) {
    report->status = EOM_NO_INERTIA;
    report->index = coordinate_without_inertia(sys);
    return EOM_NO_INERTIA;
  }
  if (f->count == 0) return EOM_OK;
  factor_rows(sys);
  f->rank = eom_factor_rank(sys, rows->tolerance);
  if (f->rank > rows->rank) f->rank = rows->rank;
  factor_dependence(sys);
  report->rank = f->rank;
  if (f->rank > 0) report->condition = TL_LIBM(fabs)(f->B[0] / f->B[(f->rank - 1) * (sys->n + 1)]);
  return EOM_OK;
}

/* ---- solutions ---- */

/* Full rank: v = R11^-T P' D r2, P' D^-1 mu = R11^-1 (v - y1). y: (y1, y2) becomes (v, y2). */
static void apply_full(const eom_system *sys, eom_factor *f, tl_real *dl, const tl_real *r2) {
  const eom_linalg *la = sys->workspace->linalg;
  const int n = sys->n, m = f->count;
  for (int j = 0; j < m; j++) f->v[j] = f->D[f->pivot[j]] * r2[f->pivot[j]];
  la->solve_upper_transposed(n, m, f->B, f->v);
  for (int j = 0; j < m; j++) {
    f->w[j] = f->v[j] - f->y[j];
    f->y[j] = f->v[j];
  }
  la->solve_upper(n, m, f->B, f->w);
  for (int j = 0; j < m; j++) {
    const int row = f->pivot[j];
    dl[row] = f->D[row] * f->w[j] - f->W[row] * r2[row];
  }
}

/* Rank r < m: v = T^-1 (U' P' D r2)_1; P' D^-1 mu = U (T^-T (v - y1), 0); and P' D^-1 W r2 is cut to its part in the range of U1. */
static void apply_deficient(const eom_system *sys, eom_factor *f, tl_real *dl, const tl_real *r2) {
  const eom_linalg *la = sys->workspace->linalg;
  const int m = f->count, r = f->rank;
  for (int j = 0; j < m; j++) {
    const int row = f->pivot[j];
    f->v[j] = f->D[row] * r2[row];
    f->w[j] = f->W[row] * r2[row] / f->D[row];
  }
  la->apply_qt(m, r, f->U, f->tau_u, f->v, f->work, f->nwork);
  la->apply_qt(m, r, f->U, f->tau_u, f->w, f->work, f->nwork);
  la->solve_upper(m, r, f->U, f->v);
  for (int j = 0; j < r; j++) {
    const tl_real z = f->v[j] - f->y[j];
    f->y[j] = f->v[j];
    f->v[j] = z;
  }
  la->solve_upper_transposed(m, r, f->U, f->v);
  for (int j = 0; j < m; j++) f->w[j] = j < r ? f->v[j] - f->w[j] : TL_C(0.0);
  la->apply_q(m, r, f->U, f->tau_u, f->w, f->work, f->nwork);
  for (int j = 0; j < m; j++) dl[f->pivot[j]] = f->D[f->pivot[j]] * f->w[j];
}

void eom_factor_apply(eom_system *sys, tl_real *dq, tl_real *dl, const tl_real *r1, const tl_real *r2) {
  eom_factor *f = &sys->workspace->factor;
  const eom_linalg *la = sys->workspace->linalg;
  const int n = sys->n;
  for (int i = 0; i < n; i++) f->y[i] = f->S[i] * r1[i];
  la->solve_lower(n, f->L, 1, f->y);
  for (int r = 0; f->count < sys->m && r < sys->m; r++) dl[r] = TL_C(0.0);
  if (f->count > 0) {
    la->apply_qt(n, f->rank, f->B, f->tau, f->y, f->work, f->nwork);
    if (f->rank == f->count)
      apply_full(sys, f, dl, r2);
    else
      apply_deficient(sys, f, dl, r2);
    la->apply_q(n, f->rank, f->B, f->tau, f->y, f->work, f->nwork);
  }
  la->solve_lower_transposed(n, f->L, 1, f->y);
  for (int i = 0; i < n; i++) dq[i] = f->S[i] * f->y[i];
}

/* r1 = R1 + A' dl - M dq,  r2 = R2 - A dq. */
static void residual(const eom_system *sys, tl_real *r1, tl_real *r2, const tl_real *dq, const tl_real *dl, const tl_real *R1,
                     const tl_real *R2) {
  const int n = sys->n, m = sys->m;
  for (int i = 0; i < n; i++) {
    tl_real sum = R1[i];
    for (int j = 0; j < n; j++) sum -= sys->M[i * n + j] * dq[j];
    r1[i] = sum;
  }
  for (int r = 0; r < m; r++) {
    tl_real sum = R2[r];
    for (int j = 0; j < n; j++) {
      r1[j] += sys->A[r * n + j] * dl[r];
      sum -= sys->A[r * n + j] * dq[j];
    }
    r2[r] = sum;
  }
}

/* How large a solution is, or by how much it changes: accelerations dq_i/S_i and constraint forces S_i (A'dl)_i, coordinates scaled to
 * unit inertia. */
typedef struct extent {
  tl_real q, l;
} extent;

static extent extent_of(const eom_system *sys, const tl_real *dq, const tl_real *dl) {
  const eom_factor *f = &sys->workspace->factor;
  extent e = {TL_C(0.0), TL_C(0.0)};
  for (int i = 0; i < sys->n; i++) {
    tl_real force = TL_C(0.0);
    for (int r = 0; r < sys->m; r++) force += sys->A[r * sys->n + i] * dl[r];
    e.q = TL_LIBM(fmax)(e.q, TL_LIBM(fabs)(dq[i] / f->S[i]));
    e.l = TL_LIBM(fmax)(e.l, TL_LIBM(fabs)(force * f->S[i]));
  }
  return e;
}

/* Refinement goes on while the change of either part falls by half, until both are at rounding: that of the solution or of the forces
 * that balance in it. Without constraints Cholesky alone is as good as the data. */
void eom_kkt_solve(eom_system *sys, tl_real *dq, tl_real *dl, const tl_real *r1, const tl_real *r2) {
  eom_workspace *ws = sys->workspace;
  eom_factor_apply(sys, dq, dl, r1, r2);
  if (sys->m == 0) return;
  tl_real applied = TL_C(0.0);
  for (int i = 0; i < sys->n; i++) applied = TL_LIBM(fmax)(applied, TL_LIBM(fabs)(r1[i] * ws->factor.S[i]));
  extent last = {TL_MAX, TL_MAX};
  for (int pass = 0; pass < EOM_REFINEMENTS; pass++) {
    residual(sys, ws->r1, ws->r2, dq, dl, r1, r2);
    eom_factor_apply(sys, ws->dq, ws->dl, ws->r1, ws->r2);
    const extent change = extent_of(sys, ws->dq, ws->dl), size = extent_of(sys, dq, dl);
    if (!(change.q < last.q / TL_C(2.0)) && !(change.l < last.l / TL_C(2.0))) return;
    for (int i = 0; i < sys->n; i++) dq[i] += ws->dq[i];
    for (int r = 0; r < sys->m; r++) dl[r] += ws->dl[r];
    const tl_real rounding = TL_C(2.0) * TL_EPSILON;
    if (change.q <= rounding * TL_LIBM(fmax)(size.q, applied) && change.l <= rounding * TL_LIBM(fmax)(size.l, applied)) return;
    last = change;
  }
}
