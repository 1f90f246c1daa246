/* The refined solution of factor.c for EOM_LANES right-hand sides at once; factors and formulas are those of factor.c. */
#include "lanes.h"

#include "factor.h"

#include <string.h>

typedef tl_real row[EOM_LANES];

#define EACH for (int c = 0; c < EOM_LANES; c++)

static void add(row y, tl_real a, const row x) { EACH y[c] += a * x[c]; }
static void scale(row y, tl_real a, const row x) { EACH y[c] = a * x[c]; }

/* y = L^-1 y and y = L^-T y. */
static void solve_lower(int n, const tl_real *l, row *y) {
  for (int i = 0; i < n; i++) {
    for (int j = 0; j < i; j++) add(y[i], -l[i * n + j], y[j]);
    scale(y[i], TL_C(1.0) / l[i * n + i], y[i]);
  }
}
static void solve_lower_transposed(int n, const tl_real *l, row *y) {
  for (int i = n - 1; i >= 0; i--) {
    scale(y[i], TL_C(1.0) / l[i * n + i], y[i]);
    for (int j = 0; j < i; j++) add(y[j], -l[i * n + j], y[i]);
  }
}

/* y = H y with the reflector H = 1 - tau (1,v)(1,v)' on the numbers from j; v stands below number j of b's vector j. */
static void reflect(int n, const tl_real *b, tl_real tau, int j, row *y) {
  const tl_real *v = b + j * n;
  row s;
  memcpy(s, y[j], sizeof s);
  for (int i = j + 1; i < n; i++) add(s, v[i], y[i]);
  scale(s, tau, s);
  add(y[j], TL_C(-1.0), s);
  for (int i = j + 1; i < n; i++) add(y[i], -v[i], s);
}

/* v = R^-T v and w = R^-1 w. */
static void solve_upper_transposed(int n, int m, const tl_real *b, row *v) {
  for (int j = 0; j < m; j++) {
    for (int i = 0; i < j; i++) add(v[j], -b[j * n + i], v[i]);
    scale(v[j], TL_C(1.0) / b[j * n + j], v[j]);
  }
}
static void solve_upper(int n, int m, const tl_real *b, row *w) {
  for (int j = m - 1; j >= 0; j--) {
    scale(w[j], TL_C(1.0) / b[j * n + j], w[j]);
    for (int i = 0; i < j; i++) add(w[i], -b[j * n + i], w[j]);
  }
}

/* v = R11^-T P' D r2, P' D^-1 mu = R11^-1 (v - y1); (y1, y2) becomes (v, y2). */
static void apply_rows(const eom_system *sys, eom_lanes *s, row *y, row *dl, row *r2) {
  const eom_factor *f = &sys->workspace->factor;
  const int n = sys->n, m = f->count;
  row *v = s->v, *w = s->w;
  for (int i = 0; m < sys->m && i < sys->m; i++) memset(dl[i], 0, sizeof(row));
  for (int j = 0; j < m; j++) scale(v[j], f->D[f->pivot[j]], r2[f->pivot[j]]);
  solve_upper_transposed(n, m, f->B, v);
  for (int j = 0; j < m; j++) {
    EACH w[j][c] = v[j][c] - y[j][c];
    memcpy(y[j], v[j], sizeof(row));
  }
  solve_upper(n, m, f->B, w);
  for (int j = 0; j < m; j++) {
    const int i = f->pivot[j];
    EACH dl[i][c] = f->D[i] * w[j][c] - f->W[i] * r2[i][c];
  }
}

/* One pass through the factors. */
static void apply(const eom_system *sys, eom_lanes *s, row *dq, row *dl, row *r1, row *r2) {
  const eom_factor *f = &sys->workspace->factor;
  const int n = sys->n;
  row *y = dq;
  for (int i = 0; i < n; i++) scale(y[i], f->S[i], r1[i]);
  solve_lower(n, f->L, y);
  for (int j = 0; j < f->count; j++) reflect(n, f->B, f->tau[j], j, y);
  apply_rows(sys, s, y, dl, r2);
  for (int j = f->count - 1; j >= 0; j--) reflect(n, f->B, f->tau[j], j, y);
  solve_lower_transposed(n, f->L, y);
  for (int i = 0; i < n; i++) scale(y[i], f->S[i], y[i]);
}

/* r1 = R1 + A' dl - M dq,  r2 = R2 - A dq. */
static void residual(const eom_system *sys, eom_lanes *s) {
  const int n = sys->n, m = sys->m;
  for (int i = 0; i < n; i++) {
    memcpy(s->r1[i], s->R1[i], sizeof(row));
    for (int j = 0; j < n; j++) add(s->r1[i], -sys->M[i * n + j], s->dq[j]);
    for (int r = 0; r < m; r++) add(s->r1[i], sys->A[r * n + i], s->dl[r]);
  }
  for (int r = 0; r < m; r++) {
    memcpy(s->r2[r], s->R2[r], sizeof(row));
    for (int j = 0; j < n; j++) add(s->r2[r], -sys->A[r * n + j], s->dq[j]);
  }
}

static void raise(row most, tl_real factor, const row x) {
  EACH {
    const tl_real size = TL_LIBM(fabs)(factor * x[c]);
    most[c] = size > most[c] ? size : most[c];
  }
}

/* The size of accelerations and of constraint forces, coordinates scaled to unit inertia. */
static void extent(const eom_system *sys, row q, row l, row *dq, row *dl) {
  const eom_factor *f = &sys->workspace->factor;
  memset(q, 0, sizeof(row));
  memset(l, 0, sizeof(row));
  for (int i = 0; i < sys->n; i++) {
    row force = {TL_C(0.0)};
    for (int r = 0; r < sys->m; r++) add(force, sys->A[r * sys->n + i], dl[r]);
    raise(q, TL_C(1.0) / f->S[i], dq[i]);
    raise(l, f->S[i], force);
  }
}

/* A lane goes on while the change of either part falls by half, until both are at rounding. */
static void refine(const eom_system *sys, eom_lanes *s) {
  const eom_factor *f = &sys->workspace->factor;
  const tl_real rounding = TL_C(2.0) * TL_EPSILON;
  row applied = {TL_C(0.0)}, last_q, last_l, going;
  for (int i = 0; i < sys->n; i++) raise(applied, f->S[i], s->R1[i]);
  EACH {
    last_q[c] = last_l[c] = TL_MAX;
    going[c] = TL_C(1.0);
  }
  for (int pass = 0; pass < EOM_REFINEMENTS; pass++) {
    row change_q, change_l, size_q, size_l;
    residual(sys, s);
    apply(sys, s, s->change_q, s->change_l, s->r1, s->r2);
    extent(sys, change_q, change_l, s->change_q, s->change_l);
    extent(sys, size_q, size_l, s->dq, s->dl);
    EACH if (!(change_q[c] < last_q[c] / TL_C(2.0)) && !(change_l[c] < last_l[c] / TL_C(2.0))) going[c] = TL_C(0.0);
    for (int i = 0; i < sys->n; i++) EACH if (going[c] != TL_C(0.0)) s->dq[i][c] += s->change_q[i][c];
    for (int r = 0; r < sys->m; r++) EACH if (going[c] != TL_C(0.0)) s->dl[r][c] += s->change_l[r][c];
    tl_real any = TL_C(0.0);
    EACH {
      const tl_real q = TL_LIBM(fmax)(size_q[c], applied[c]), l = TL_LIBM(fmax)(size_l[c], applied[c]);
      if (change_q[c] <= rounding * q && change_l[c] <= rounding * l) going[c] = TL_C(0.0);
      any += going[c];
      last_q[c] = change_q[c];
      last_l[c] = change_l[c];
    }
    if (any == TL_C(0.0)) return;
  }
}

/* Columns from first on become lanes, the last ones zero. */
static void gather(row *to, int rows, int k, int first, const tl_real *from) {
  for (int i = 0; i < rows; i++) EACH to[i][c] = first + c < k ? -from[i * k + first + c] : TL_C(0.0);
}
static void scatter(tl_real *to, int rows, int k, int first, row *from) {
  for (int i = 0; i < rows; i++)
    for (int c = 0; c < EOM_LANES && first + c < k; c++) to[i * k + first + c] = from[i][c];
}

void eom_lanes_solve(eom_system *sys, int k, tl_real *r, tl_real *g) {
  eom_lanes *s = &sys->workspace->lanes;
  for (int first = 0; first < k; first += EOM_LANES) {
    gather(s->R1, sys->n, k, first, r);
    gather(s->R2, sys->m, k, first, g);
    apply(sys, s, s->dq, s->dl, s->R1, s->R2);
    if (sys->m > 0) refine(sys, s);
    scatter(r, sys->n, k, first, s->dq);
    scatter(g, sys->m, k, first, s->dl);
  }
}
