/* The linear model in the user's own coordinates v(q) (eq 46).
 *
 * Z(y) = (v, v'), with V = dv/dq and V', V'' its derivatives along the motion; X = dq/dv and X' along v + s v'. Then
 *   DZ = [V 0; V' V],  D2Z f = [V' 0; V'' V'],  DZ^-1 = [X 0; X' X],
 *   D2Z f + DZ F = [V' V; V'' + V F_q, 2V' + V F_u]   with the lower half [F_q F_u] of F,
 * and because V X = 1 the product with DZ^-1 is [0 I; (V'' + V F_q) X + (2V' + V F_u) X', (2V' + V F_u) X]. */
#include "eom/linearise.h"

#include "stage.h"

#include "taylor/series.h"

#include <assert.h>
#include <string.h>

/* The two transformations may differ from inverses of each other by half the digits: inverses such as acos lose that many near the ends
 * of their domains, while a wrong branch or a wrong formula is off by far more. */
static tl_real inverse_tolerance(void) { return TL_LIBM(sqrt)(TL_EPSILON); }

/* Seeds and results of one transformation, and matrices (n x n) read from it. */
typedef struct transform {
  tl_spec spec;
  tl_shape shape;
  size_t ncontext;
  tl_real *jets, *context;
} transform;

typedef struct chart {
  transform v_of_q, q_of_v;
  tl_real *v0, *v1;      /* n: v, v' */
  tl_real *q0;           /* n: q(v(q)) */
  tl_real *V, *V1, *V2;  /* V, V', V'' */
  tl_real *X, *X1;       /* X, X' */
  tl_real *by_q, *by_qd; /* V'' + V F_q, 2V' + V F_u */
} chart;

static bool plan_transform(transform *tr, tl_spec spec, const eom_function *f, const eom_system *sys, eom_arena *a) {
  const size_t n = (size_t)sys->n, bytes = tl_shape_bytes(spec);
  const int ncoef = tl_ncoef(spec);
  if (ncoef <= 0 || !f->jet || !f->rows || !f->frame || f->rows(sys->params) != sys->n) return false;
  tr->spec = spec;
  void *table = eom_arena_take(a, bytes, 1);
  if (a->base && tl_shape_init(&tr->shape, spec, table, bytes) != 0) return false;
  tr->ncontext = tl_ctx_size(&(tl_shape){.ncoef = ncoef}, f->frame(sys->params));
  tr->jets = eom_arena_reals(a, (3 * n + 1) * (size_t)ncoef);
  tr->context = eom_arena_reals(a, tr->ncontext);
  return true;
}

static bool lay_out(chart *c, const eom_system *sys, const eom_coordinates *coordinates, eom_arena *a) {
  const size_t n = (size_t)sys->n;
  if (!plan_transform(&c->v_of_q, tl_motion(2, sys->n), &coordinates->v_of_q, sys, a)) return false;
  if (!plan_transform(&c->q_of_v, tl_motion(1, sys->n), &coordinates->q_of_v, sys, a)) return false;
  c->v0 = eom_arena_reals(a, n);
  c->v1 = eom_arena_reals(a, n);
  c->q0 = eom_arena_reals(a, n);
  tl_real **matrices[] = {&c->V, &c->V1, &c->V2, &c->X, &c->X1, &c->by_q, &c->by_qd};
  for (size_t i = 0; i < sizeof matrices / sizeof matrices[0]; i++) *matrices[i] = eom_arena_reals(a, n * n);
  return !a->overflow;
}

size_t eom_coordinates_bytes(const eom_system *sys, const eom_coordinates *coordinates) {
  chart c;
  eom_arena count = {0};
  return lay_out(&c, sys, coordinates, &count) ? count.used + EOM_ALIGNMENT : 0;
}

/* Runs a transformation along x + t + s x1 + s^2/2 x2; row i of the result jets is then at out + i*ncoef. */
static eom_status run(eom_system *sys, transform *tr, const eom_function *f, const tl_real *x, const tl_real *x1, const tl_real *x2,
                      tl_real t, tl_real **out) {
  const size_t n = (size_t)sys->n, ncoef = (size_t)tr->shape.ncoef;
  tl_ctx cx;
  tl_ctx_init(&cx, &tr->shape, tr->context, tr->ncontext);
  tl_real *time = tr->jets + n * ncoef, *unused = time + ncoef;
  *out = unused + n * ncoef;
  for (int i = 0; i < sys->n; i++) {
    tl_real *jet = tr->jets + (size_t)i * ncoef;
    tl_seed(&cx, jet, x[i], i);
    jet[1] = x1[i];
    if (x2) jet[2] = x2[i] / TL_C(2.0);
    tl_const(&cx, unused + (size_t)i * ncoef, TL_C(0.0));
  }
  tl_const(&cx, time, t);
  time[1] = TL_C(1.0);
  f->jet(&cx, *out, tr->jets, unused, time, sys->params);
  return eom_jet_verdict(sys, f, cx.status);
}

/* Row i of a matrix from block (1, k) of result i, times a factor. */
static void read_matrix(const eom_system *sys, const transform *tr, const tl_real *out, int k, tl_real factor, tl_real *matrix) {
  const int n = sys->n;
  for (int i = 0; i < n; i++) {
    const tl_real *row = out + (size_t)i * (size_t)tr->shape.ncoef + tr->shape.start[1] + k * n;
    for (int j = 0; j < n; j++) matrix[i * n + j] = factor * row[j];
  }
}

/* c += a b for n x n matrices; b has row stride ldb. */
static void multiply_add(int n, tl_real *c, const tl_real *a, const tl_real *b, int ldb) {
  for (int i = 0; i < n; i++)
    for (int k = 0; k < n; k++)
      for (int j = 0; j < n; j++) c[i * n + j] += a[i * n + k] * b[k * ldb + j];
}

static eom_status not_inverse(eom_system *sys, const eom_function *f, int i) {
  sys->report.status = EOM_NOT_INVERSE;
  sys->report.function = f->name;
  sys->report.source = f->source;
  sys->report.index = i;
  return EOM_NOT_INVERSE;
}

/* q(v(q)) = q to rounding, which is as large as eps (|q_i| + sum_j |X_ij v_j|). */
static bool returns(const chart *c, int n, int i, tl_real q_i) {
  tl_real size = TL_LIBM(fabs)(q_i);
  for (int j = 0; j < n; j++) size += TL_LIBM(fabs)(c->X[i * n + j] * c->v0[j]);
  return TL_LIBM(fabs)(c->q0[i] - q_i) <= inverse_tolerance() * size;
}

/* (V X)_ij = 1 or 0, to rounding in the largest V_ik and X_kj. */
static bool derivatives_agree(const chart *c, int n, int i, int j) {
  tl_real miss = i == j ? TL_C(-1.0) : TL_C(0.0), most_V = TL_C(0.0), most_X = TL_C(0.0);
  for (int k = 0; k < n; k++) {
    miss += c->V[i * n + k] * c->X[k * n + j];
    most_V = TL_LIBM(fmax)(most_V, TL_LIBM(fabs)(c->V[i * n + k]));
    most_X = TL_LIBM(fmax)(most_X, TL_LIBM(fabs)(c->X[k * n + j]));
  }
  return TL_LIBM(fabs)(miss) <= inverse_tolerance() * most_V * most_X;
}

static eom_status check_inverse(eom_system *sys, const chart *c, const eom_function *inverse, const tl_real *q) {
  const int n = sys->n;
  for (int i = 0; i < n; i++)
    if (!returns(c, n, i, q[i])) return not_inverse(sys, inverse, i);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++)
      if (!derivatives_agree(c, n, i, j)) return not_inverse(sys, inverse, i);
  return EOM_OK;
}

/* The lower half of F_z from the matrices of the chart. */
static void fill(const eom_system *sys, chart *c, tl_real *F_z) {
  const int n = sys->n;
  const size_t square = (size_t)n * (size_t)n * sizeof(tl_real);
  for (int i = 0; i < n * n; i++) c->by_qd[i] = TL_C(2.0) * c->V1[i];
  memcpy(c->by_q, c->V2, square);
  multiply_add(n, c->by_q, c->V, sys->qdd_y, 2 * n);
  multiply_add(n, c->by_qd, c->V, sys->qdd_y + n, 2 * n);
  tl_real *left = c->V1, *right = c->V2;
  memset(left, 0, square);
  memset(right, 0, square);
  multiply_add(n, left, c->by_q, c->X, n);
  multiply_add(n, left, c->by_qd, c->X1, n);
  multiply_add(n, right, c->by_qd, c->X, n);
  memset(F_z, 0, 4 * square);
  for (int i = 0; i < n; i++) {
    F_z[i * 2 * n + n + i] = TL_C(1.0);
    memcpy(F_z + (n + i) * 2 * n, left + i * n, (size_t)n * sizeof(tl_real));
    memcpy(F_z + (n + i) * 2 * n + n, right + i * n, (size_t)n * sizeof(tl_real));
  }
}

eom_status eom_linearise_in(eom_system *sys, const eom_coordinates *coordinates, tl_real *F_z, tl_real *z, const tl_real *q,
                            const tl_real *qd, tl_real t, void *memory, size_t bytes) {
  assert(sys && coordinates && F_z && q && qd);
  const int n = sys->n;
  const size_t need = eom_coordinates_bytes(sys, coordinates);
  sys->report = (eom_report){.status = EOM_OK, .index = -1, .rank = -1};
  if (need == 0) return sys->report.status = EOM_BAD_MODEL;
  if (!memory || bytes < need) return sys->report.status = EOM_NO_MEMORY;
  chart c = {0};
  eom_arena arena = eom_arena_at(memory);
  if (!lay_out(&c, sys, coordinates, &arena)) return sys->report.status = EOM_NO_MEMORY;
  if (eom_linearise(sys, q, qd, t) != EOM_OK) return sys->report.status;

  tl_real *out;
  if (run(sys, &c.v_of_q, &coordinates->v_of_q, q, qd, sys->qdd, t, &out) != EOM_OK) return sys->report.status;
  for (int i = 0; i < n; i++) {
    const tl_real *jet = out + (size_t)i * (size_t)c.v_of_q.shape.ncoef;
    c.v0[i] = jet[0];
    c.v1[i] = jet[1];
  }
  read_matrix(sys, &c.v_of_q, out, 0, TL_C(1.0), c.V);
  read_matrix(sys, &c.v_of_q, out, 1, TL_C(1.0), c.V1);
  read_matrix(sys, &c.v_of_q, out, 2, TL_C(2.0), c.V2);

  if (run(sys, &c.q_of_v, &coordinates->q_of_v, c.v0, c.v1, NULL, t, &out) != EOM_OK) return sys->report.status;
  for (int i = 0; i < n; i++) c.q0[i] = out[(size_t)i * (size_t)c.q_of_v.shape.ncoef];
  read_matrix(sys, &c.q_of_v, out, 0, TL_C(1.0), c.X);
  read_matrix(sys, &c.q_of_v, out, 1, TL_C(1.0), c.X1);
  if (check_inverse(sys, &c, &coordinates->q_of_v, q) != EOM_OK) return sys->report.status;

  fill(sys, &c, F_z);
  if (eom_check_finite(sys, "state matrix in the given coordinates", F_z, 4 * n * n) != EOM_OK) return sys->report.status;
  if (z) {
    memcpy(z, c.v0, (size_t)n * sizeof(tl_real));
    memcpy(z + n, c.v1, (size_t)n * sizeof(tl_real));
  }
  return EOM_OK;
}
