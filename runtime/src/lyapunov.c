/* Lyapunov exponents: tangents along the motion by three schemes (eqs 72-81). */
#include "eom/lyapunov.h"

#include "eom/assemble.h"
#include "eom/linearise.h"
#include "workspace.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

typedef struct eom_lyapunov_work {
  tl_real *integrator; /* workspace of the integrator */
  tl_real *before;     /* the integrator's state before a step */
  tl_real *G;          /* 2n x 2n: F Q */
  tl_real *K;          /* 2n x 2n: Q'FQ, S */
  tl_real *vectors;    /* 2n vectors of 2n: QR */
  tl_real *tau;        /* 2n */
  tl_real *sorted;     /* 2n */
  tl_real *seen;       /* 2n: the y at which sys is linearised */
  tl_real seen_t;
  bool seen_valid;
} eom_lyapunov_work;

eom_lyapunov_options eom_lyapunov_options_default(void) { return (eom_lyapunov_options){.scheme = EOM_LYAPUNOV_DISCRETE, .every = 1}; }

/* ---- right-hand sides ---- */

/* Linearises at (t, y) unless that was the last point: after a change of Q alone the motion's part need not be computed again. */
static eom_status linearise_once(eom_lyapunov *ly, tl_real t, const tl_real *y) {
  eom_lyapunov_work *w = ly->work;
  const size_t bytes = (size_t)ly->dim * sizeof(tl_real);
  if (w->seen_valid && t == w->seen_t && memcmp(w->seen, y, bytes) == 0) return EOM_OK;
  w->seen_valid = false;
  const eom_status status = eom_linearise(ly->sys, y, y + ly->sys->n, t);
  if (status != EOM_OK) return status;
  memcpy(w->seen, y, bytes);
  w->seen_t = t;
  w->seen_valid = true;
  return EOM_OK;
}

/* C = A B for a (rows x d), b (d x d), row by row. */
static void multiply(int rows, int d, tl_real *restrict c, const tl_real *restrict a, const tl_real *restrict b) {
  for (int i = 0; i < rows; i++) {
    tl_real *row = c + i * d;
    memset(row, 0, (size_t)d * sizeof(tl_real));
    for (int k = 0; k < d; k++) {
      const tl_real aik = a[i * d + k];
      const tl_real *from = b + k * d;
      for (int j = 0; j < d; j++) row[j] += aik * from[j];
    }
  }
}

/* G = F X with F = [0 I; qdd_y]: the upper half of G is the lower half of X. */
static void times_F(const eom_system *sys, tl_real *G, const tl_real *X) {
  const int n = sys->n, d = 2 * n;
  memcpy(G, X + n * d, (size_t)n * (size_t)d * sizeof(tl_real));
  multiply(n, d, G + n * d, sys->qdd_y, X);
}

/* trace F = sum_i d qdd_i/d qd_i. */
static tl_real trace_F(const eom_system *sys) {
  const int n = sys->n;
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < n; i++) sum += sys->qdd_y[i * 2 * n + n + i];
  return sum;
}

/* y' = f: the part that all schemes share. */
static eom_status motion(eom_lyapunov *ly, tl_real t, const tl_real *z, tl_real *zdot) {
  const eom_status status = linearise_once(ly, t, z);
  if (status != EOM_OK) return status;
  const size_t n = (size_t)ly->sys->n;
  memcpy(zdot, z + n, n * sizeof(tl_real));
  memcpy(zdot + n, ly->sys->qdd, n * sizeof(tl_real));
  return EOM_OK;
}

/* (y, P, divergence)' = (f, F P, trace F). */
static int rhs_discrete(void *user, tl_real t, const tl_real *z, tl_real *zdot) {
  eom_lyapunov *ly = user;
  const int d = ly->dim;
  const eom_status status = motion(ly, t, z, zdot);
  if (status != EOM_OK) return (int)status;
  times_F(ly->sys, zdot + d, z + d);
  zdot[d + d * d] = trace_F(ly->sys);
  return 0;
}

/* K = Q'G. */
static void project(int d, tl_real *restrict K, const tl_real *restrict Q, const tl_real *restrict G) {
  memset(K, 0, (size_t)d * (size_t)d * sizeof(tl_real));
  for (int k = 0; k < d; k++)
    for (int i = 0; i < d; i++) {
      const tl_real q = Q[k * d + i];
      for (int j = 0; j < d; j++) K[i * d + j] += q * G[k * d + j];
    }
}

/* K = Q'FQ gives rho_i' = K_ii and S_ij = K_ij below the diagonal, -K_ji above it, 0 on it. */
static void split(int d, tl_real *K, tl_real *rho_dot) {
  for (int i = 0; i < d; i++) {
    rho_dot[i] = K[i * d + i];
    K[i * d + i] = TL_C(0.0);
    for (int j = i + 1; j < d; j++) K[i * d + j] = -K[j * d + i];
  }
}

/* (y, Q, rho, divergence)' = (f, Q S, diag(Q'FQ), trace F): eqs 75-80. */
static int rhs_continuous(void *user, tl_real t, const tl_real *z, tl_real *zdot) {
  eom_lyapunov *ly = user;
  eom_lyapunov_work *w = ly->work;
  const int d = ly->dim;
  const eom_status status = motion(ly, t, z, zdot);
  if (status != EOM_OK) return (int)status;
  const tl_real *Q = z + d;
  times_F(ly->sys, w->G, Q);
  project(d, w->K, Q, w->G);
  split(d, w->K, zdot + d + d * d);
  multiply(d, d, zdot + d, Q, w->K);
  zdot[d + d * d + d] = trace_F(ly->sys);
  return 0;
}

/* ---- re-orthonormalisation ---- */

/* X = Q R by Householder reflections with R_ii > 0. Q may be X. log_R: logarithms of R_ii, may be null. NOT_FINITE where a R_ii is
 * zero. */
static eom_status orthonormalise(eom_lyapunov *ly, tl_real *Q, const tl_real *X, tl_real *log_R) {
  eom_lyapunov_work *w = ly->work;
  const int d = ly->dim;
  for (int j = 0; j < d; j++)
    for (int i = 0; i < d; i++) w->vectors[j * d + i] = X[i * d + j];
  eom_linalg_core.qr(d, d, w->vectors, NULL, w->tau, NULL, 0);
  for (int j = 0; j < d; j++) {
    const tl_real R_jj = w->vectors[j * d + j];
    if (R_jj == TL_C(0.0) || !TL_ISFINITE(R_jj)) return EOM_NOT_FINITE;
    if (log_R) log_R[j] = TL_LIBM(log)(TL_LIBM(fabs)(R_jj));
    tl_real *column = w->sorted;
    memset(column, 0, (size_t)d * sizeof(tl_real));
    column[j] = R_jj > TL_C(0.0) ? TL_C(1.0) : TL_C(-1.0);
    eom_linalg_core.apply_q(d, j + 1, w->vectors, w->tau, column, NULL, 0);
    for (int i = 0; i < d; i++) Q[i * d + j] = column[i];
  }
  return EOM_OK;
}

/* ---- a step ---- */

/* Closes the block under way when it is full; when all blocks are, merges neighbours. */
static void record_block(eom_lyapunov *ly, long steps) {
  const int d = ly->dim;
  ly->block_fill += steps;
  if (ly->block_fill < ly->block_steps) return;
  tl_real *block = ly->block + ly->nblock * d;
  for (int i = 0; i < d; i++) {
    block[i] = ly->rho[i] - ly->block_start[i];
    ly->block_start[i] = ly->rho[i];
  }
  ly->block_fill = 0;
  if (++ly->nblock < EOM_LYAPUNOV_BLOCKS) return;
  for (int b = 0; b < EOM_LYAPUNOV_BLOCKS / 2; b++)
    for (int i = 0; i < d; i++) ly->block[b * d + i] = ly->block[2 * b * d + i] + ly->block[(2 * b + 1) * d + i];
  ly->nblock = EOM_LYAPUNOV_BLOCKS / 2;
  ly->block_steps *= 2;
}

/* P = Q R, rho_i += log R_ii, P = Q. */
static eom_status finish_discrete(eom_lyapunov *ly) {
  eom_lyapunov_work *w = ly->work;
  const int d = ly->dim;
  tl_real *P = ly->it.y + d, *log_R = w->K;
  const eom_status status = orthonormalise(ly, P, P, log_R);
  if (status != EOM_OK) return status;
  memcpy(ly->Q, P, (size_t)d * (size_t)d * sizeof(tl_real));
  for (int i = 0; i < d; i++) ly->rho[i] += log_R[i];
  eom_integrator_restart(&ly->it);
  return EOM_OK;
}

static eom_status finish_continuous(eom_lyapunov *ly) {
  eom_integrator_restart(&ly->it);
  return orthonormalise(ly, ly->Q, ly->Q, NULL);
}

eom_status eom_lyapunov_step(eom_lyapunov *ly) {
  eom_integrator *it = &ly->it;
  const bool discrete = ly->options.scheme == EOM_LYAPUNOV_DISCRETE;
  memcpy(ly->work->before, it->y, (size_t)it->dim * sizeof(tl_real));
  eom_status status = eom_integrator_step(it);
  if (status == EOM_RHS_FAILED) return ly->sys->report.status;
  if (status != EOM_OK) return status;

  const bool due = !discrete || it->steps % ly->options.every == 0;
  status = eom_energy(ly->sys, it->y, it->y + ly->sys->n, it->t);
  if (status == EOM_OK && discrete && due) status = finish_discrete(ly);
  if (status == EOM_OK && ly->options.scheme == EOM_LYAPUNOV_CONTINUOUS) status = finish_continuous(ly);
  if (status != EOM_OK) {
    memcpy(it->y, ly->work->before, (size_t)it->dim * sizeof(tl_real));
    eom_integrator_restart(it);
    it->steps--;
    it->t = ly->t;
    return status;
  }
  ly->t = it->t;
  ly->energy = ly->sys->energy;
  if (!due) return EOM_OK;
  ly->t_rho = it->t;
  ly->divergence = it->y[it->dim - 1];
  record_block(ly, discrete ? ly->options.every : 1);
  return EOM_OK;
}

/* ---- what is read from a run ---- */

void eom_lyapunov_exponents(const eom_lyapunov *ly, tl_real *lambda) {
  const tl_real time = ly->t_rho - ly->t0;
  for (int i = 0; i < ly->dim; i++) lambda[i] = time == TL_C(0.0) ? TL_C(0.0) : ly->rho[i] / time;
}

static tl_real finite_or_max(tl_real x) { return TL_ISFINITE(x) ? x : TL_MAX; }

tl_real eom_lyapunov_orthogonality(const eom_lyapunov *ly) {
  const int d = ly->dim;
  tl_real worst = TL_C(0.0);
  for (int i = 0; i < d; i++)
    for (int j = 0; j <= i; j++) {
      tl_real sum = i == j ? TL_C(-1.0) : TL_C(0.0);
      for (int k = 0; k < d; k++) sum += ly->Q[k * d + i] * ly->Q[k * d + j];
      worst = TL_LIBM(fmax)(worst, TL_LIBM(fabs)(finite_or_max(sum)));
    }
  return worst;
}

tl_real eom_lyapunov_sum_error(const eom_lyapunov *ly) {
  if (ly->t_rho == ly->t0) return TL_C(0.0);
  tl_real sum = -ly->divergence;
  for (int i = 0; i < ly->dim; i++) sum += ly->rho[i];
  return TL_LIBM(fabs)(finite_or_max(sum / (ly->t_rho - ly->t0)));
}

/* Sorts falling, by insertion: the spectrum is short and nearly sorted. */
static void sort_falling(int count, tl_real *x) {
  for (int i = 1; i < count; i++) {
    const tl_real value = x[i];
    int j = i;
    for (; j > 0 && x[j - 1] < value; j--) x[j] = x[j - 1];
    x[j] = value;
  }
}

tl_real eom_lyapunov_pairing_error(const eom_lyapunov *ly) {
  const int d = ly->dim;
  tl_real *lambda = ly->work->sorted, worst = TL_C(0.0);
  eom_lyapunov_exponents(ly, lambda);
  sort_falling(d, lambda);
  for (int i = 0; i < d; i++) worst = TL_LIBM(fmax)(worst, TL_LIBM(fabs)(finite_or_max(lambda[i] + lambda[d - 1 - i])));
  return worst;
}

/* ---- start and end ---- */

static bool options_are_valid(const eom_lyapunov_options *o) {
  return (o->scheme == EOM_LYAPUNOV_DISCRETE || o->scheme == EOM_LYAPUNOV_CONTINUOUS || o->scheme == EOM_LYAPUNOV_PAPER) &&
         o->every >= 1;
}

static const eom_method *method_of(const eom_lyapunov_options *o) { return o->method ? o->method : &eom_dp5; }

/* Numbers of the integrated state. */
static int state_size(const eom_system *sys, const eom_lyapunov_options *o) {
  const int d = 2 * sys->n;
  return d + d * d + (o->scheme == EOM_LYAPUNOV_DISCRETE ? 0 : d) + 1;
}

static void lay_out(eom_lyapunov *ly, eom_lyapunov_work *w, eom_arena *a) {
  const int size = state_size(ly->sys, &ly->options);
  const size_t d = (size_t)ly->dim;
  ly->work = eom_arena_take(a, 1, sizeof(eom_lyapunov_work));
  w->integrator = eom_arena_reals(a, eom_integrator_size(method_of(&ly->options), size));
  w->before = eom_arena_reals(a, (size_t)size);
  w->G = eom_arena_reals(a, d * d);
  w->K = eom_arena_reals(a, d * d);
  w->vectors = eom_arena_reals(a, d * d);
  w->tau = eom_arena_reals(a, d);
  w->sorted = eom_arena_reals(a, d);
  w->seen = eom_arena_reals(a, d);
  ly->block = eom_arena_reals(a, d * EOM_LYAPUNOV_BLOCKS);
  ly->block_start = eom_arena_reals(a, d);
  if (ly->options.scheme != EOM_LYAPUNOV_DISCRETE) return;
  ly->Q = eom_arena_reals(a, d * d);
  ly->rho = eom_arena_reals(a, d);
}

/* The fields that sizes depend on. */
static eom_lyapunov outline(eom_system *sys, const eom_lyapunov_options *options) {
  return (eom_lyapunov){.sys = sys, .options = options ? *options : eom_lyapunov_options_default(), .dim = 2 * sys->n};
}

size_t eom_lyapunov_bytes(const eom_system *sys, const eom_lyapunov_options *options) {
  const eom_lyapunov_options o = options ? *options : eom_lyapunov_options_default();
  if (!options_are_valid(&o)) return 0;
  eom_system sizes = {.n = sys->n};
  eom_lyapunov ly = outline(&sizes, &o);
  eom_lyapunov_work work;
  eom_arena count = {0};
  lay_out(&ly, &work, &count);
  return count.overflow ? 0 : count.used + EOM_ALIGNMENT;
}

eom_status eom_lyapunov_init(eom_lyapunov *ly, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                             tl_real h, void *memory, size_t bytes) {
  assert(ly && sys && y);
  if (!(sys->options.needs & EOM_NEED_LINEARISE)) return EOM_BAD_OPTION;
  *ly = outline(sys, options);
  if (!options_are_valid(&ly->options) || !TL_ISFINITE(h) || h == TL_C(0.0)) return EOM_BAD_OPTION;
  const size_t need = eom_lyapunov_bytes(sys, &ly->options);
  if (need == 0 || bytes < need || !memory) return EOM_NO_MEMORY;
  memset(memory, 0, bytes);
  eom_arena arena = eom_arena_at(memory);
  eom_lyapunov_work work = {0};
  lay_out(ly, &work, &arena);
  *ly->work = work;

  if (eom_energy(sys, y, y + sys->n, t) != EOM_OK) return sys->report.status;
  ly->energy0 = ly->energy = sys->energy;
  ly->t0 = ly->t = ly->t_rho = t;
  ly->block_steps = ly->options.scheme == EOM_LYAPUNOV_DISCRETE ? ly->options.every : 1;

  const int d = ly->dim, size = state_size(sys, &ly->options);
  tl_real *start = ly->work->before;
  memcpy(start, y, (size_t)d * sizeof(tl_real));
  for (int i = 0; i < d; i++) start[d + i * d + i] = TL_C(1.0);
  const bool discrete = ly->options.scheme == EOM_LYAPUNOV_DISCRETE;
  eom_integrator_init(&ly->it, method_of(&ly->options), discrete ? rhs_discrete : rhs_continuous, ly, size, t, start, h,
                      ly->work->integrator);
  ly->y = ly->it.y;
  if (discrete)
    memcpy(ly->Q, start + d, (size_t)d * (size_t)d * sizeof(tl_real));
  else {
    ly->Q = ly->it.y + d;
    ly->rho = ly->Q + d * d;
  }
  return EOM_OK;
}

eom_status eom_lyapunov_create(eom_lyapunov **out, eom_system *sys, const eom_lyapunov_options *options, tl_real t, const tl_real *y,
                               tl_real h) {
  *out = NULL;
  const size_t bytes = eom_lyapunov_bytes(sys, options);
  if (bytes == 0) return EOM_BAD_OPTION;
  eom_lyapunov *ly = malloc(sizeof(eom_lyapunov) + bytes);
  if (!ly) return EOM_NO_MEMORY;
  const eom_status status = eom_lyapunov_init(ly, sys, options, t, y, h, ly + 1, bytes);
  if (status == EOM_OK)
    *out = ly;
  else
    free(ly);
  return status;
}

void eom_lyapunov_destroy(eom_lyapunov *ly) { free(ly); }
