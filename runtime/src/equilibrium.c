/* Damped Gauss-Newton on the accelerations in minimal coordinates.
 *
 * With r = qdd scaled to unit inertia, J = dr/dy Z, and W a basis of the changes z that leave alone what is kept, a step z = W w has
 * the least w among those that minimise |r + J W w|^2 + damping |w|^2: none at first, more as long as r does not fall. After each step
 * the state is projected onto the constraints. */
#include "eom/equilibrium.h"

#include "eom/linearise.h"
#include "eom/project.h"
#include "eom/solve.h"
#include "evaluate.h"
#include "stage.h"

#include <assert.h>
#include <string.h>

enum { MOST_STEPS = 200 };

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
  tl_real *r, *r_then;     /* n: r, and after a step */
  tl_real *J;              /* n x d */
  tl_real *kept;           /* 2n vectors of d: rows of Z that must not move, then reflectors */
  tl_real *W;              /* d vectors of d */
  tl_real *C;              /* d vectors of n + d: columns of J W above damping */
  tl_real *right;          /* n + d */
  tl_real *U;              /* d vectors of d */
  tl_real *w, *z;          /* d */
  tl_real *tau, *tau_u;    /* 2n */
  tl_real *linalg;
  int *pivot; /* 2n */
  int nlinalg;
} search;

static void lay_out(const eom_system *sys, search *s, eom_arena *a) {
  const size_t n = (size_t)sys->n, d = 2 * n;
  s->minimal_bytes = eom_minimal_bytes(sys);
  s->nlinalg = eom_linalg_work(3 * sys->n, 2 * sys->n);
  s->minimal = eom_arena_take(a, s->minimal_bytes, 1);
  s->all = eom_arena_take(a, n, 1);
  s->was_q = eom_arena_reals(a, n);
  s->was_qd = eom_arena_reals(a, n);
  s->try_q = eom_arena_reals(a, n);
  s->try_qd = eom_arena_reals(a, n);
  s->scale = eom_arena_reals(a, n);
  s->r = eom_arena_reals(a, n);
  s->r_then = eom_arena_reals(a, n);
  s->J = eom_arena_reals(a, n * d);
  s->kept = eom_arena_reals(a, d * d);
  s->W = eom_arena_reals(a, d * d);
  s->C = eom_arena_reals(a, d * (n + d));
  s->right = eom_arena_reals(a, n + d);
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

/* r of the accelerations in the system. */
static void read_residual(const search *s, tl_real *r) {
  for (int i = 0; i < s->sys->n; i++) r[i] = s->sys->qdd[i] / s->scale[i];
}

static void read_jacobian(const search *s) {
  const int n = s->sys->n, d = s->out->linear.d;
  eom_multiply(n, 2 * n, d, s->J, s->sys->qdd_y, s->out->linear.Z);
  for (int i = 0; i < n; i++)
    for (int k = 0; k < d; k++) s->J[i * d + k] /= s->scale[i];
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

/* C: J W above sqrt(damping) 1, f vectors of n + f. */
static void build_columns(const search *s, int f) {
  const int n = s->sys->n, d = s->out->linear.d, rows = n + f;
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
  const int rows = s->sys->n + f;
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
  const int n = s->sys->n, rows = n + f;
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
  const int n = s->sys->n, d = s->out->linear.d;
  memset(s->z, 0, (size_t)d * sizeof(tl_real));
  for (int k = 0; k < f; k++)
    for (int i = 0; i < d; i++) s->z[i] += s->W[k * d + i] * s->w[k];
  eom_multiply(n, d, 1, s->right, s->J, s->z);
  for (int i = 0; i < n; i++) s->right[i] += s->r[i];
  return TL_LIBM(sqrt)(norm2(n, s->right) / norm2(n, s->r));
}

/* ---- the search ---- */

/* The largest |x_i - y_i| in parts of the largest |x_i|, scaled to unit inertia. */
static tl_real way(const search *s, const tl_real *x, const tl_real *y) {
  tl_real most = TL_C(0.0), size = TL_C(0.0);
  for (int i = 0; i < s->sys->n; i++) {
    most = TL_LIBM(fmax)(most, TL_LIBM(fabs)(x[i] - y[i]) / s->scale[i]);
    size = TL_LIBM(fmax)(size, TL_LIBM(fabs)(x[i]) / s->scale[i]);
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
  if (eom_acceleration(s->sys, s->try_q, s->try_qd, s->t) != EOM_OK) return false;
  read_residual(s, s->r_then);
  return TL_ISFINITE(norm2(n, s->r_then));
}

/* What forces on coordinate i alone would accelerate it by, at unit inertia. */
static tl_real force_on(const search *s, int i) {
  return s->scale[i] * TL_LIBM(fmax)(TL_LIBM(fabs)(s->sys->Q[i]), TL_LIBM(fabs)(s->sys->Qc[i]));
}

/* Whether the forces on each coordinate balance as well as rounding lets them. */
static bool balanced(const search *s) {
  for (int i = 0; i < s->sys->n; i++)
    if (!(TL_LIBM(fabs)(s->r[i]) <= TL_C(2.0) * TL_EPSILON * force_on(s, i))) return false;
  return true;
}

/* Whether what is left of the accelerations may be rounding of the largest force. */
static bool nearly_balanced(const search *s) {
  tl_real force = TL_C(0.0), left = TL_C(0.0);
  for (int i = 0; i < s->sys->n; i++) {
    force = TL_LIBM(fmax)(force, force_on(s, i));
    left = TL_LIBM(fmax)(left, TL_LIBM(fabs)(s->r[i]));
  }
  return left <= TL_LIBM(sqrt)(TL_EPSILON) * force;
}

typedef enum verdict { GO_ON, ARRIVED, STUCK } verdict;

/* One accepted step, with as much damping as that takes. A step is accepted where |r| falls, or where the step that the same J would
 * make next is shorter: stiff directions, which make |r| large beside a soft one, do not count more there than others. Without any such
 * the search ends: it has arrived where |r| is rounding, or would be zero by a step that is rounding itself. */
static verdict advance(search *s, int f) {
  const tl_real rounding = TL_C(4.0) * TL_EPSILON, nearly = TL_LIBM(sqrt)(TL_EPSILON);
  const int n = s->sys->n;
  const bool small = nearly_balanced(s);
  for (s->damping = s->damping > LEAST_DAMPING ? s->damping / (MORE_DAMPING * MORE_DAMPING) : TL_C(0.0);;) {
    const int rank = factor_columns(s, f);
    const tl_real length = minimise(s, f, rank, s->r), left = step_of(s, f);
    const bool exists = try_step(s), solves = left < TL_C(0.5) || small;
    const tl_real change = TL_LIBM(fmax)(way(s, s->try_q, s->q), way(s, s->try_qd, s->qd));
    if (exists && (norm2(n, s->r_then) < norm2(n, s->r) || minimise(s, f, rank, s->r_then) < length / TL_C(4.0))) {
      memcpy(s->q, s->try_q, (size_t)n * sizeof(tl_real));
      memcpy(s->qd, s->try_qd, (size_t)n * sizeof(tl_real));
      return change > rounding ? GO_ON : solves ? ARRIVED : STUCK;
    }
    if (change <= nearly) return solves ? ARRIVED : STUCK;
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
    if (TL_LIBM(fabs)(s->r[i]) > TL_LIBM(fabs)(s->r[report->index])) report->index = i;
  return report->status = EOM_NO_EQUILIBRIUM;
}

static eom_status run(search *s) {
  eom_system *sys = s->sys;
  eom_projection p = s->keep;
  if (eom_project(sys, s->q, s->qd, s->t, &p) != EOM_OK) return sys->report.status;
  for (s->out->steps = 0;; s->out->steps++) {
    if (eom_linearise_minimal(sys, &s->out->linear, s->q, s->qd, s->t, s->minimal, s->minimal_bytes) != EOM_OK)
      return sys->report.status;
    if (s->out->steps == 0) memcpy(s->scale, sys->workspace->factor.S, (size_t)sys->n * sizeof(tl_real));
    read_residual(s, s->r);
    if (norm2(sys->n, s->r) == TL_C(0.0) || balanced(s)) return EOM_OK;
    if (s->out->steps == MOST_STEPS) return no_equilibrium(s);
    read_jacobian(s);
    const int f = free_directions(s);
    const verdict v = f > 0 ? advance(s, f) : STUCK;
    if (v == STUCK) return no_equilibrium(s);
    if (v == ARRIVED) return eom_linearise_minimal(sys, &s->out->linear, s->q, s->qd, s->t, s->minimal, s->minimal_bytes);
  }
}

/* The largest |x_i - was_i|, and whose. */
static tl_real largest(int n, const tl_real *x, const tl_real *was, int *most) {
  tl_real change = TL_C(0.0);
  *most = -1;
  for (int i = 0; i < n; i++) {
    const tl_real d = TL_LIBM(fabs)(x[i] - was[i]);
    if (d > change) change = d, *most = i;
  }
  return change;
}

eom_status eom_find_equilibrium(eom_system *sys, tl_real *q, tl_real *qd, tl_real t, eom_equilibrium *equilibrium, void *memory,
                                size_t bytes) {
  assert(sys && q && qd && equilibrium && (sys->options.needs & EOM_NEED_LINEARISE));
  const int n = sys->n;
  if (eom_start(sys, q, qd, t) != EOM_OK) return sys->report.status;
  if (!memory || bytes < eom_equilibrium_bytes(sys)) return sys->report.status = EOM_NO_MEMORY;
  search s = {.sys = sys, .q = q, .qd = qd, .t = t, .out = equilibrium};
  eom_arena arena = eom_arena_at(memory);
  lay_out(sys, &s, &arena);
  memset(s.all, 1, (size_t)n);
  s.keep = (eom_projection){.keep_q = equilibrium->keep_q, .keep_qd = equilibrium->keep_qd ? equilibrium->keep_qd : s.all};
  memset(s.r, 0, (size_t)n * sizeof(tl_real));
  memset(s.scale, 0, (size_t)n * sizeof(tl_real));
  memcpy(s.was_q, q, (size_t)n * sizeof(tl_real));
  memcpy(s.was_qd, qd, (size_t)n * sizeof(tl_real));
  const eom_status status = run(&s);
  for (int i = 0; i < n; i++) s.right[i] = s.r[i] * s.scale[i], s.r[i] = TL_C(0.0);
  equilibrium->residual = largest(n, s.right, s.r, &equilibrium->most_qdd);
  if (status != EOM_OK) {
    memcpy(q, s.was_q, (size_t)n * sizeof(tl_real));
    memcpy(qd, s.was_qd, (size_t)n * sizeof(tl_real));
  }
  equilibrium->change_q = largest(n, q, s.was_q, &equilibrium->most_q);
  equilibrium->change_qd = largest(n, qd, s.was_qd, &equilibrium->most_qd);
  return status;
}
