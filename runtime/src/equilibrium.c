/* Damped Gauss-Newton on the balance of forces, in minimal coordinates.
 *
 * qdd = 0 where Q + A' mu = 0 and b = 0. With mu from M x = Q + A' mu, A x = 0, and N of the state at hand (eom/minimal.h), whose
 * columns are orthonormal in M and along which A' mu does no work, r = (N'(Q + A' mu), D b),  J = (N' d(Q + A' mu)/dy, D db/dy) Z, both
 * in accelerations of unit inertia; mu is held in J, as N'A' = 0. With W a basis of the changes z that leave alone what is kept, a step
 * z = W w has the least w among those that minimise |r + J W w|^2 + damping |w|^2: no damping at first, more as long as a step is not
 * accepted. After each step the state is projected onto the constraints. */
#include "eom/equilibrium.h"

#include "eom/project.h"
#include "evaluate.h"
#include "factor.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

enum { MOST_STEPS = 100 };

/* Damping in parts of the largest diagonal of (J W)'J W: that of the first failure, what another multiplies it by, where it ends. */
#define LEAST_DAMPING TL_EPSILON
#define MORE_DAMPING TL_C(100.0)
#define MOST_DAMPING (TL_C(1.0) / TL_EPSILON)

/* The search. */
typedef struct search {
  eom_system *sys;
  tl_real *q, *qd, t;
  eom_equilibrium *out;
  eom_projection keep;
  tl_real damping;

  void *minimal; /* memory of out->linear */
  size_t minimal_bytes;
  unsigned char *all;      /* n flags of 1 */
  tl_real *was_q, *was_qd; /* n: the given state */
  tl_real *try_q, *try_qd; /* n: the state after a step */
  tl_real *scale;          /* n: S of the given state's M, so that qdd_i/scale_i are accelerations of unit inertia */
  tl_real *qdd;            /* n: those */
  tl_real first;           /* the largest at first */
  tl_real *D;              /* m: D of the state's rows */
  tl_real *x, *mu, *zero;  /* n, m, m */
  tl_real *r, *r_then;     /* n + m: r, and after a step */
  tl_real *J;              /* (n + m) x d */
  tl_real *kept;           /* 2n vectors of d: rows of Z that must not move, then reflectors */
  tl_real *W;              /* d vectors of d */
  tl_real *C;              /* d vectors of n + m + d: columns of J W above damping */
  tl_real *right;          /* n + m + d */
  tl_real *U;              /* d vectors of d */
  tl_real *w, *z;          /* d */
  tl_real *tau, *tau_u;    /* 2n */
  tl_real *linalg;
  int *pivot; /* 2n */
  int nlinalg;
} search;

static void lay_out(const eom_system *sys, search *s, eom_arena *a) {
  const size_t n = (size_t)sys->n, m = (size_t)sys->m, d = 2 * n;
  s->minimal_bytes = eom_minimal_bytes(sys);
  s->nlinalg = eom_linalg_work(3 * sys->n + sys->m, 2 * sys->n);
  s->minimal = eom_arena_take(a, s->minimal_bytes, 1);
  s->all = eom_arena_take(a, n, 1);
  s->was_q = eom_arena_reals(a, n);
  s->was_qd = eom_arena_reals(a, n);
  s->try_q = eom_arena_reals(a, n);
  s->try_qd = eom_arena_reals(a, n);
  s->scale = eom_arena_reals(a, n);
  s->qdd = eom_arena_reals(a, n);
  s->D = eom_arena_reals(a, m);
  s->x = eom_arena_reals(a, n);
  s->mu = eom_arena_reals(a, m);
  s->zero = eom_arena_reals(a, m);
  s->r = eom_arena_reals(a, n + m);
  s->r_then = eom_arena_reals(a, n + m);
  s->J = eom_arena_reals(a, (n + m) * d);
  s->kept = eom_arena_reals(a, d * d);
  s->W = eom_arena_reals(a, d * d);
  s->C = eom_arena_reals(a, d * (n + m + d));
  s->right = eom_arena_reals(a, n + m + d);
  s->U = eom_arena_reals(a, d * d);
  s->w = eom_arena_reals(a, d);
  s->z = eom_arena_reals(a, d);
  s->tau = eom_arena_reals(a, d);
  s->tau_u = eom_arena_reals(a, d);
  s->pivot = eom_arena_take(a, d, sizeof(int));
  s->linalg = eom_arena_reals(a, (size_t)s->nlinalg);
}

size_t eom_equilibrium_bytes(const eom_system *sys) {
  search s;
  eom_arena count = {0};
  lay_out(sys, &s, &count);
  return count.used + EOM_ALIGNMENT;
}

/* ---- the linear problem ---- */

static tl_real norm2(int count, const tl_real *x) {
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < count; i++) sum += x[i] * x[i];
  return sum;
}

/* Numbers of r. */
static int equations(const search *s) { return s->out->linear.nv + s->sys->m; }

/* Column j of N. */
static const tl_real *column(const search *s, int j) { return s->out->linear.Z + s->sys->n * s->out->linear.d + s->out->linear.nq + j; }

/* r of the state that the system holds solved, along the N at hand; fills mu. */
static void read_balance(const search *s, tl_real *r) {
  eom_system *sys = s->sys;
  const int n = sys->n, m = sys->m, nv = s->out->linear.nv;
  eom_kkt_solve(sys, s->x, s->mu, sys->Q, s->zero);
  memcpy(s->x, sys->Q, (size_t)n * sizeof(tl_real));
  for (int k = 0; k < m; k++)
    for (int i = 0; i < n; i++) s->x[i] += sys->A[k * n + i] * s->mu[k];
  for (int j = 0; j < nv; j++) {
    r[j] = TL_C(0.0);
    for (int i = 0; i < n; i++) r[j] += column(s, j)[i * s->out->linear.d] * s->x[i];
  }
  for (int k = 0; k < m; k++) r[nv + k] = s->D[k] * sys->b[k];
}

/* J with the mu of read_balance. */
static eom_status read_jacobian(const search *s) {
  eom_system *sys = s->sys;
  const int n = sys->n, m = sys->m, d = s->out->linear.d, nv = s->out->linear.nv;
  memset(sys->qdd, 0, (size_t)n * sizeof(tl_real));
  if (m > 0) memcpy(sys->lambda, s->mu, (size_t)m * sizeof(tl_real));
  if (eom_linearised_residual(sys, s->q, s->qd, s->t) != EOM_OK) return sys->report.status;
  tl_real *forces = s->C; /* n x d */
  eom_multiply(n, 2 * n, d, forces, sys->qdd_y, s->out->linear.Z);
  if (m > 0) eom_multiply(m, 2 * n, d, s->J + nv * d, sys->lambda_y, s->out->linear.Z);
  for (int j = 0; j < nv; j++)
    for (int k = 0; k < d; k++) {
      s->J[j * d + k] = TL_C(0.0);
      for (int i = 0; i < n; i++) s->J[j * d + k] -= column(s, j)[i * d] * forces[i * d + k];
    }
  for (int r = 0; r < m; r++)
    for (int k = 0; k < d; k++) s->J[(nv + r) * d + k] *= -s->D[r];
  return EOM_OK;
}

/* Rows of Z, scaled to unit inertia, of what is kept. Returns how many. */
static int gather_kept(const search *s) {
  const int n = s->sys->n, d = s->out->linear.d;
  int count = 0;
  for (int i = 0; i < 2 * n; i++) {
    const unsigned char *flags = i < n ? s->keep.keep_q : s->keep.keep_qd;
    if (!flags || !flags[i % n]) continue;
    for (int k = 0; k < d; k++) s->kept[count * d + k] = s->out->linear.Z[i * d + k] / s->scale[i % n];
    count++;
  }
  return count;
}

/* W: an orthonormal basis of the z that move nothing kept. Returns their number. */
static int free_directions(const search *s) {
  const eom_linalg *la = s->sys->workspace->linalg;
  const int d = s->out->linear.d, count = gather_kept(s), least = count < d ? count : d;
  int rank = 0;
  if (count > 0) la->qr(d, count, s->kept, s->pivot, s->tau, s->linalg, s->nlinalg);
  while (rank < least && TL_LIBM(fabs)(s->kept[rank * (d + 1)]) > s->sys->options.rank_tolerance) rank++;
  memset(s->W, 0, (size_t)d * (size_t)d * sizeof(tl_real));
  for (int k = 0; k < d - rank; k++) {
    s->W[k * d + rank + k] = TL_C(1.0);
    if (rank > 0) la->apply_q(d, rank, s->kept, s->tau, s->W + k * d, s->linalg, s->nlinalg);
  }
  return d - rank;
}

/* C: J W above sqrt(damping) 1, f vectors. */
static void build_columns(const search *s, int f) {
  const int n = equations(s), d = s->out->linear.d, rows = n + f;
  tl_real most = TL_C(0.0);
  memset(s->C, 0, (size_t)f * (size_t)rows * sizeof(tl_real));
  for (int k = 0; k < f; k++) {
    eom_multiply(n, d, 1, s->C + k * rows, s->J, s->W + k * d);
    most = TL_LIBM(fmax)(most, norm2(n, s->C + k * rows));
  }
  for (int k = 0; k < f; k++) s->C[k * rows + n + k] = TL_LIBM(sqrt)(s->damping * most);
}

/* P'w of least norm with [R11 R12] P'w = right, rank < f rows; in s->z. */
static void least_norm(const search *s, int f, int rank, int rows) {
  const eom_linalg *la = s->sys->workspace->linalg;
  for (int i = 0; i < rank; i++)
    for (int k = 0; k < f; k++) s->U[i * f + k] = k < i ? TL_C(0.0) : s->C[k * rows + i];
  la->qr(f, rank, s->U, NULL, s->tau_u, s->linalg, s->nlinalg);
  la->solve_upper_transposed(f, rank, s->U, s->z);
  la->apply_q(f, rank, s->U, s->tau_u, s->z, s->linalg, s->nlinalg);
}

/* The QR factorisation of C with its rank. */
static int factor_columns(const search *s, int f) {
  const int rows = equations(s) + f;
  build_columns(s, f);
  s->sys->workspace->linalg->qr(rows, f, s->C, s->pivot, s->tau, s->linalg, s->nlinalg);
  const tl_real rounding = TL_C(16.0) * (tl_real)rows * TL_EPSILON * TL_LIBM(fabs)(s->C[0]);
  int rank = 0;
  while (rank < f && TL_LIBM(fabs)(s->C[rank * (rows + 1)]) > rounding) rank++;
  return rank;
}

/* w, the least that minimises |r + J W w|^2 + damping |w|^2. Returns |w|^2. */
static tl_real minimise(const search *s, int f, int rank, const tl_real *r) {
  const eom_linalg *la = s->sys->workspace->linalg;
  const int n = equations(s), rows = n + f;
  for (int i = 0; i < rows; i++) s->right[i] = i < n ? -r[i] : TL_C(0.0);
  if (rank > 0) la->apply_qt(rows, rank, s->C, s->tau, s->right, s->linalg, s->nlinalg);
  for (int k = 0; k < f; k++) s->z[k] = k < rank ? s->right[k] : TL_C(0.0);
  if (rank == f)
    la->solve_upper(rows, f, s->C, s->z);
  else if (rank > 0)
    least_norm(s, f, rank, rows);
  for (int k = 0; k < f; k++) s->w[s->pivot[k]] = s->z[k];
  return norm2(f, s->w);
}

/* z = W w. Returns |r + J z| as a part of |r|. */
static tl_real step_of(const search *s, int f) {
  const int n = equations(s), d = s->out->linear.d;
  memset(s->z, 0, (size_t)d * sizeof(tl_real));
  for (int k = 0; k < f; k++)
    for (int i = 0; i < d; i++) s->z[i] += s->W[k * d + i] * s->w[k];
  eom_multiply(n, d, 1, s->right, s->J, s->z);
  for (int i = 0; i < n; i++) s->right[i] += s->r[i];
  return TL_LIBM(sqrt)(norm2(n, s->right) / norm2(n, s->r));
}

/* ---- the search ---- */

/* The largest |x_i - y_i| in parts of the largest |x_i| or |was_i|, scaled to unit inertia. */
static tl_real way(const search *s, const tl_real *x, const tl_real *y, const tl_real *was) {
  tl_real most = TL_C(0.0), size = TL_C(0.0);
  for (int i = 0; i < s->sys->n; i++) {
    most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i] - y[i]) / s->scale[i]);
    size = TL_LIBM(fmax)(size, TL_LIBM(fmax)(TL_LIBM(fabs)(x[i]), TL_LIBM(fabs)(was[i])) / s->scale[i]);
  }
  return most > TL_C(0.0) ? most / size : TL_C(0.0);
}

/* The state after the step, and its r in s->r_then; false where there is none. */
static bool try_step(const search *s) {
  const eom_minimal *m = &s->out->linear;
  const int n = m->n;
  for (int i = 0; i < n; i++) {
    s->try_q[i] = s->q[i];
    s->try_qd[i] = s->qd[i];
    for (int k = 0; k < m->d; k++) {
      if (!s->keep.keep_q || !s->keep.keep_q[i]) s->try_q[i] += m->Z[i * m->d + k] * s->z[k];
      if (!s->keep.keep_qd[i]) s->try_qd[i] += m->Z[(n + i) * m->d + k] * s->z[k];
    }
  }
  eom_projection p = s->keep;
  if (eom_project(s->sys, s->try_q, s->try_qd, s->t, &p) != EOM_OK) return false;
  if (eom_start(s->sys, s->try_q, s->try_qd, s->t) != EOM_OK) return false;
  if (eom_solve_at(s->sys, s->try_q, s->try_qd, s->t) != EOM_OK) return false;
  read_balance(s, s->r_then);
  return TL_ISFINITE(norm2(equations(s), s->r_then));
}

/* What forces on coordinate i alone would accelerate it by, at unit inertia. */
static tl_real force_on(const search *s, int i) {
  return s->scale[i] * TL_LIBM(fmax)(TL_LIBM(fabs)(s->sys->Q[i]), TL_LIBM(fabs)(s->sys->Qc[i]));
}

/* Whether the forces on each coordinate balance as well as rounding lets them. */
static bool balanced(const search *s) {
  for (int i = 0; i < s->sys->n; i++)
    if (!(TL_LIBM(fabs)(s->qdd[i]) <= TL_C(2.0) * TL_EPSILON * force_on(s, i))) return false;
  return true;
}

static tl_real largest(int n, const tl_real *x) {
  tl_real most = TL_C(0.0);
  for (int i = 0; i < n; i++) most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i]));
  return most;
}

/* Whether what is left of the accelerations may be rounding of the largest force, or of those at first. */
static bool nearly_balanced(const search *s) {
  tl_real force = s->first;
  for (int i = 0; i < s->sys->n; i++) force = TL_LIBM(fmax)(force, force_on(s, i));
  return largest(s->sys->n, s->qdd) <= TL_LIBM(sqrt)(TL_EPSILON) * force;
}

typedef enum verdict { GO_ON, ARRIVED, STUCK } verdict;

/* One accepted step, with as much damping as that takes. A step is accepted where |r| falls, or where the step that the same J would
 * make next is shorter: stiff directions, which make |r| large beside a soft one, do not count more there than others. The search ends
 * where steps are rounding, or nearly so and none is accepted although little is left: it has arrived if that, or a step that makes
 * less than half of r, says so. */
static verdict advance(search *s, int f) {
  const tl_real rounding = TL_C(4.0) * TL_EPSILON, nearly = TL_LIBM(sqrt)(TL_EPSILON);
  const int n = s->sys->n, count = equations(s);
  const bool small = nearly_balanced(s);
  for (s->damping = s->damping > LEAST_DAMPING ? s->damping / (MORE_DAMPING * MORE_DAMPING) : TL_C(0.0);;) {
    const int rank = factor_columns(s, f);
    const tl_real length = minimise(s, f, rank, s->r), left = step_of(s, f);
    const bool exists = try_step(s), solves = left < TL_C(0.5) || small;
    const tl_real change = TL_LIBM(fmax)(way(s, s->try_q, s->q, s->was_q), way(s, s->try_qd, s->qd, s->was_qd));
    const bool better =
        exists && (norm2(count, s->r_then) < norm2(count, s->r) || minimise(s, f, rank, s->r_then) < length / TL_C(4.0));
    if (better) {
      memcpy(s->q, s->try_q, (size_t)n * sizeof(tl_real));
      memcpy(s->qd, s->try_qd, (size_t)n * sizeof(tl_real));
    }
    if (change <= rounding) return solves ? ARRIVED : STUCK;
    if (better) return GO_ON;
    if (change <= nearly && small) return ARRIVED;
    s->damping = TL_LIBM(fmax)(LEAST_DAMPING, s->damping * MORE_DAMPING);
    if (s->damping > MOST_DAMPING) return small ? ARRIVED : STUCK;
  }
}

static eom_status no_equilibrium(search *s) {
  eom_report *report = &s->sys->report;
  report->function = report->source = NULL;
  report->jet = (tl_status){.bits = TL_OK};
  report->nrow = 0;
  report->index = 0;
  for (int i = 1; i < s->sys->n; i++)
    if (TL_LIBM(fabs)(s->qdd[i]) > TL_LIBM(fabs)(s->qdd[report->index])) report->index = i;
  return report->status = EOM_NO_EQUILIBRIUM;
}

/* The linear model at the state, its accelerations and r. */
static eom_status look(search *s) {
  eom_system *sys = s->sys;
  const int n = sys->n;
  if (eom_linearise_minimal(sys, &s->out->linear, s->q, s->qd, s->t, s->minimal, s->minimal_bytes) != EOM_OK) return sys->report.status;
  const eom_factor *f = &sys->workspace->factor;
  if (s->out->steps == 0) memcpy(s->scale, f->S, (size_t)n * sizeof(tl_real));
  if (sys->m > 0) memcpy(s->D, f->D, (size_t)sys->m * sizeof(tl_real));
  for (int i = 0; i < n; i++) s->qdd[i] = sys->qdd[i] / s->scale[i];
  if (s->out->steps == 0) s->first = largest(n, s->qdd);
  read_balance(s, s->r);
  return EOM_OK;
}

static eom_status run(search *s) {
  eom_system *sys = s->sys;
  eom_projection p = s->keep;
  if (eom_project(sys, s->q, s->qd, s->t, &p) != EOM_OK) return sys->report.status;
  for (s->out->steps = 0;; s->out->steps++) {
    if (look(s) != EOM_OK) return sys->report.status;
    if (norm2(equations(s), s->r) == TL_C(0.0) || balanced(s)) return EOM_OK;
    if (s->out->steps == MOST_STEPS) return no_equilibrium(s);
    if (read_jacobian(s) != EOM_OK) return sys->report.status;
    const int f = free_directions(s);
    const verdict v = f > 0 ? advance(s, f) : STUCK;
    if (v == STUCK) return no_equilibrium(s);
    if (v == ARRIVED) return look(s);
  }
}

eom_status eom_find_equilibrium(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_equilibrium *equilibrium, void *memory,
                                size_t bytes) {
  assert(sys && q && qd && equilibrium);
  const int n = sys->n;
  if (eom_start_needing(sys, EOM_NEED_LINEARISE, q, qd, t) != EOM_OK) return sys->report.status;
  if (!memory || bytes < eom_equilibrium_bytes(sys)) return sys->report.status = EOM_NO_MEMORY;
  search s = {.sys = sys, .q = q, .qd = qd, .t = t, .out = equilibrium};
  eom_arena arena = eom_arena_at(memory);
  lay_out(sys, &s, &arena);
  memset(s.all, 1, (size_t)n);
  s.keep = (eom_projection){.keep_q = equilibrium->keep_q, .keep_qd = equilibrium->keep_qd ? equilibrium->keep_qd : s.all};
  for (int r = 0; r < sys->m; r++) s.zero[r] = TL_C(0.0);
  memset(s.qdd, 0, (size_t)n * sizeof(tl_real));
  memset(s.scale, 0, (size_t)n * sizeof(tl_real));
  memcpy(s.was_q, q, (size_t)n * sizeof(tl_real));
  memcpy(s.was_qd, qd, (size_t)n * sizeof(tl_real));
  const eom_status status = run(&s);
  for (int i = 0; i < n; i++) s.qdd[i] *= s.scale[i], s.x[i] = TL_C(0.0);
  equilibrium->residual = eom_largest_change(n, s.qdd, s.x, &equilibrium->most_qdd);
  if (status != EOM_OK) {
    memcpy(q, s.was_q, (size_t)n * sizeof(tl_real));
    memcpy(qd, s.was_qd, (size_t)n * sizeof(tl_real));
  }
  equilibrium->change_q = eom_largest_change(n, q, s.was_q, &equilibrium->most_q);
  equilibrium->change_qd = eom_largest_change(n, qd, s.was_qd, &equilibrium->most_qd);
  return status;
}
