/* Bases of the motions that constraints allow, and the state matrix in them.
 *
 * With calM = S^-1 L L' S^-1 and the orthogonal factor [Q1 Q2] of B = L^-1 S A' the columns of S L^-T Q2 span null A and are
 * orthonormal in calM. A rotation from the right makes them unique: the rows of N are the columns of N' P = U R, and N U = P R'. */
#include "eom/minimal.h"

#include "evaluate.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

/* Memory beside the results. */
typedef struct work {
  tl_real *N1, *N; /* n x nq, n x nv */
  tl_real *Y;      /* n x nq */
  tl_real *G;      /* m x n */
  tl_real *GN;     /* m x nq */
  tl_real *MN;     /* n x n */
  tl_real *vector; /* n vectors of n */
  tl_real *B1;     /* m1 vectors of n: the QR factorisation of the holonomic rows alone, where there are others */
  tl_real *tau;    /* n */
  tl_real *weight; /* n */
  tl_real *linalg;
  int *pivot; /* max(n, m) */
  int nlinalg;
} work;

static void lay_out(const eom_system *sys, eom_minimal *out, work *w, eom_arena *a) {
  const size_t n = (size_t)sys->n, m = (size_t)sys->m, m1 = (size_t)sys->m1, d = 2 * n;
  w->nlinalg = eom_linalg_work(sys->n, sys->n > sys->m ? sys->n : sys->m);
  out->coordinate = eom_arena_take(a, d, sizeof(int));
  out->Z = eom_arena_reals(a, d * d);
  out->S = eom_arena_reals(a, d * d);
  out->F = eom_arena_reals(a, d * d);
  w->N1 = eom_arena_reals(a, n * n);
  w->N = eom_arena_reals(a, n * n);
  w->Y = eom_arena_reals(a, n * d);
  w->G = eom_arena_reals(a, m * n);
  w->GN = eom_arena_reals(a, m * n);
  w->MN = eom_arena_reals(a, n * n);
  w->vector = eom_arena_reals(a, n * n);
  w->B1 = eom_arena_reals(a, sys->m2 > 0 ? m1 * n : 0);
  w->tau = eom_arena_reals(a, n);
  w->weight = eom_arena_reals(a, n);
  w->pivot = eom_arena_take(a, n > m ? n : m, sizeof(int));
  w->linalg = eom_arena_reals(a, (size_t)w->nlinalg);
}

size_t eom_minimal_bytes(const eom_system *sys) {
  eom_minimal out;
  work w;
  eom_arena count = {0};
  lay_out(sys, &out, &w, &count);
  return count.used + EOM_ALIGNMENT;
}

/* ---- the state must satisfy the constraints ---- */

/* What a row may miss by, as a length in the mass metric: a part of the size of x, and for what rounding leaves where x is zero but
 * lengths of the mechanism are not, a far smaller part of one unit. */
static tl_real permitted(const eom_system *sys, const tl_real *x) {
  tl_real size = TL_C(0.0), unit = TL_C(0.0);
  for (int i = 0; i < sys->n; i++) {
    const tl_real scale = sys->workspace->factor.S[i];
    size = TL_LIBM(fmax)(size, TL_LIBM(fabs)(x[i]) / scale);
    unit = TL_LIBM(fmax)(unit, TL_C(1.0) / scale);
  }
  return sys->options.consistency_tolerance * size + sys->options.rank_tolerance * unit;
}

static bool misses(const eom_system *sys, int row, tl_real permitted_q, tl_real permitted_qd) {
  const tl_real unit = sys->workspace->factor.D[row];
  const tl_real rate = row < sys->m1 ? sys->phi_dot[row] : sys->psi[row - sys->m1];
  if (!(TL_LIBM(fabs)(rate) * unit <= permitted_qd)) return true;
  return row < sys->m1 && !(TL_LIBM(fabs)(sys->phi[row]) * unit <= permitted_q);
}

static eom_status check_state(eom_system *sys, const tl_real *q, const tl_real *qd) {
  eom_report *report = &sys->report;
  const tl_real permitted_q = permitted(sys, q), permitted_qd = permitted(sys, qd);
  for (int r = 0; r < sys->m; r++) {
    if (!misses(sys, r, permitted_q, permitted_qd)) continue;
    if (report->status == EOM_OK) report->nrow = 0;
    report->status = EOM_OFF_CONSTRAINTS;
    if (report->nrow < EOM_REPORT_ROWS) {
      report->row[report->nrow] = eom_system_row(sys, r);
      report->row[report->nrow].kind = EOM_ROW_VIOLATED;
    }
    report->nrow++;
  }
  return report->status;
}

/* ---- bases ---- */

/* The vectors S L^-T Q2 of the reflectors in b, of which r are used. */
static void span_null(const eom_system *sys, const work *w, int r, const tl_real *b, const tl_real *tau) {
  const eom_factor *f = &sys->workspace->factor;
  const eom_linalg *la = sys->workspace->linalg;
  const int n = sys->n, k = n - r;
  memset(w->vector, 0, (size_t)k * (size_t)n * sizeof(tl_real));
  for (int j = 0; j < k; j++) {
    tl_real *x = w->vector + j * n;
    x[r + j] = TL_C(1.0);
    if (r > 0) la->apply_q(n, r, b, tau, x, w->linalg, w->nlinalg);
  }
  la->solve_lower_transposed(n, f->L, k, w->vector);
  for (int j = 0; j < k; j++)
    for (int i = 0; i < n; i++) w->vector[j * n + i] *= f->S[i];
}

/* How much coordinate i counts where the most free one is looked for: its rows of N times this are at most 1 long. Earlier ones count a
 * little more, so that rounding does not choose among equals. */
static void weigh(const eom_system *sys, const work *w) {
  const eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  for (int i = 0; i < n; i++) {
    tl_real inertia = sys->M[i * n + i];
    for (int r = 0; f->weighted && r < sys->m; r++) inertia += f->W[r] * sys->A[r * n + i] * sys->A[r * n + i];
    w->weight[i] = TL_LIBM(sqrt)(inertia) / (TL_C(1.0) + (tl_real)i * TL_LIBM(sqrt)(TL_EPSILON));
  }
}

/* N = P R' with a positive diagonal from the k vectors; which coordinates come first. */
static void rotate(const eom_system *sys, const work *w, int k, tl_real *N, int *coordinate) {
  const int n = sys->n;
  tl_real *rows = w->MN; /* n vectors of k */
  for (int i = 0; i < n; i++)
    for (int j = 0; j < k; j++) rows[i * k + j] = w->vector[j * n + i] * w->weight[i];
  if (k > 0) sys->workspace->linalg->qr(k, n, rows, w->pivot, w->tau, w->linalg, w->nlinalg);
  for (int c = 0; k > 0 && c < n; c++) {
    const int i = w->pivot[c];
    if (c < k) coordinate[c] = i;
    for (int j = 0; j < k; j++) {
      const tl_real x = j <= c ? rows[c * k + j] / w->weight[i] : TL_C(0.0);
      N[i * k + j] = rows[j * (k + 1)] < TL_C(0.0) ? -x : x;
    }
  }
}

/* The rank of the holonomic rows alone, and their reflectors, which are those of all rows where there are no others. */
static int factor_holonomic(const eom_system *sys, const work *w, const tl_real **b, const tl_real **tau) {
  const eom_factor *f = &sys->workspace->factor;
  const eom_linalg *la = sys->workspace->linalg;
  const int n = sys->n, m1 = sys->m1, least = n < m1 ? n : m1;
  *b = f->B;
  *tau = f->tau;
  if (sys->m2 == 0) return f->rank;
  *b = w->B1;
  *tau = w->tau;
  if (m1 == 0) return 0;
  for (int r = 0; r < m1; r++)
    for (int i = 0; i < n; i++) w->B1[r * n + i] = f->D[r] * f->S[i] * sys->A[r * n + i];
  la->solve_lower(n, f->L, m1, w->B1);
  la->qr(n, m1, w->B1, w->pivot, w->tau, w->linalg, w->nlinalg);
  int rank = 0;
  while (rank < least && TL_LIBM(fabs)(w->B1[rank * (n + 1)]) > sys->options.rank_tolerance) rank++;
  return rank;
}

static void make_bases(const eom_system *sys, eom_minimal *out, const work *w) {
  const eom_factor *f = &sys->workspace->factor;
  const tl_real *b, *tau;
  weigh(sys, w);
  const int r1 = factor_holonomic(sys, w, &b, &tau);
  out->n = sys->n;
  out->nq = sys->n - r1;
  out->nv = sys->n - f->rank;
  out->d = out->nq + out->nv;
  span_null(sys, w, r1, b, tau);
  rotate(sys, w, out->nq, w->N1, out->coordinate);
  span_null(sys, w, f->rank, f->B, f->tau);
  rotate(sys, w, out->nv, w->N, out->coordinate + out->nq);
}

/* ---- velocities that positions bring with them ---- */

/* M Y = A' mu, A Y = -G N1. */
static void follow(eom_system *sys, const eom_minimal *out, const work *w) {
  const int n = sys->n, nq = out->nq;
  memset(w->Y, 0, (size_t)n * (size_t)nq * sizeof(tl_real));
  if (sys->m == 0 || nq == 0) return;
  eom_multiply(sys->m, n, nq, w->GN, w->G, w->N1);
  eom_solve_columns(sys, nq, w->Y, w->GN);
}

/* ---- the matrices ---- */

static void fill_Z(const eom_minimal *out, const work *w) {
  const int n = out->n, nq = out->nq, nv = out->nv, d = out->d;
  memset(out->Z, 0, 2 * (size_t)n * (size_t)d * sizeof(tl_real));
  for (int i = 0; i < n; i++) {
    memcpy(out->Z + i * d, w->N1 + i * nq, (size_t)nq * sizeof(tl_real));
    memcpy(out->Z + (n + i) * d, w->Y + i * nq, (size_t)nq * sizeof(tl_real));
    memcpy(out->Z + (n + i) * d + nq, w->N + i * nv, (size_t)nv * sizeof(tl_real));
  }
}

/* k rows of S from (M + psi_qd' W psi_qd) N, N: n x k; the weighted rows vanish where they hold N. */
static void fill_S(const eom_system *sys, const eom_minimal *out, const work *w, int k, const tl_real *N, bool weighted, int row,
                   int column) {
  const int n = out->n;
  eom_multiply(n, n, k, w->MN, sys->M, N);
  for (int r = sys->m1; weighted && r < sys->m; r++)
    for (int j = 0; j < k; j++) {
      const tl_real *a = sys->A + r * n;
      tl_real along = TL_C(0.0);
      for (int i = 0; i < n; i++) along += a[i] * N[i * k + j];
      for (int i = 0; i < n; i++) w->MN[i * k + j] += sys->workspace->factor.W[r] * a[i] * along;
    }
  for (int j = 0; j < k; j++)
    for (int i = 0; i < n; i++) out->S[(row + j) * 2 * n + column + i] = w->MN[i * k + j];
}

/* F = [N1' calM (Y N); N' M qdd_y Z]. */
static void fill_F(const eom_minimal *out, const work *w) {
  const int n = out->n, d = out->d;
  for (int k = 0; k < d; k++) {
    const tl_real *s = out->S + k * 2 * n + (k < out->nq ? 0 : n);
    const tl_real *right = k < out->nq ? out->Z + n * d : w->Y;
    eom_multiply(1, n, d, out->F + k * d, s, right);
  }
}

static void fill(const eom_system *sys, const eom_minimal *out, const work *w) {
  const int n = out->n;
  fill_Z(out, w);
  memset(out->S, 0, (size_t)out->d * 2 * (size_t)n * sizeof(tl_real));
  fill_S(sys, out, w, out->nq, w->N1, sys->workspace->factor.weighted, 0, 0);
  fill_S(sys, out, w, out->nv, w->N, false, out->nq, n);
  eom_multiply(n, 2 * n, out->d, w->Y, sys->qdd_y, out->Z); /* Y is in Z now */
  fill_F(out, w);
}

eom_status eom_linearise_minimal(eom_system *sys, eom_minimal *minimal, const tl_real *q, const tl_real *qd, tl_real t, void *memory,
                                 size_t bytes) {
  assert(sys && minimal);
  if (eom_start_needing(sys, EOM_NEED_LINEARISE, q, qd, t) != EOM_OK) return sys->report.status;
  if (!memory || bytes < eom_minimal_bytes(sys)) return sys->report.status = EOM_NO_MEMORY;
  eom_arena arena = eom_arena_at(memory);
  work w;
  lay_out(sys, minimal, &w, &arena);
  if (eom_linearise_factored(sys, q, qd, t) != EOM_OK || check_state(sys, q, qd) != EOM_OK) return sys->report.status;
  make_bases(sys, minimal, &w);
  if (eom_constraint_rates(sys, w.G, q, qd, t) != EOM_OK) return sys->report.status;
  follow(sys, minimal, &w);
  fill(sys, minimal, &w);
  return eom_check_finite(sys, "state matrix in minimal coordinates", minimal->F, minimal->d * minimal->d);
}

void eom_minimal_inputs(const eom_minimal *minimal, tl_real *B, int k, const tl_real *qdd_p) {
  const int n = minimal->n, nq = minimal->nq;
  memset(B, 0, (size_t)nq * (size_t)k * sizeof(tl_real));
  for (int j = nq; j < minimal->d; j++) eom_multiply(1, n, k, B + j * k, minimal->S + j * 2 * n + n, qdd_p);
}
