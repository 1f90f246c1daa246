/* The paper's own way as a contender: one forward evaluation of L in dense jets over all 2N coordinates and velocities, of second order
 * for F and of third order for J and V, on libtaylor's complete shapes. With y = (x, u) = (q, qd) and r = M qdd - Q, Q without forces:
 *
 *   M_ij = L_{ui uj},   Q_i = L_{xi} - sum_j L_{ui xj} u_j
 *   dr_i/dy_k = sum_j (L_{ui uj yk} qdd_j + L_{ui xj yk} u_j) - L_{xi yk} + [y_k = u_l] L_{ui xl},   M dqdd/dy = -dr/dy
 *
 * Built with -DN=links -DMODEL=name from what tlgen prints for the model. */
#include <eom/model.h>

#include "parameters.h"
#include "taylor/ldl.h"
#include "taylor/taylor.h"

#include <stdlib.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

extern const eom_model JOIN(MODEL, _model);

enum { X = 0, U = N, NY = 2 * N, LD = TL_LDL_ROW(N), LDY = TL_ROW(NY) };

/* The Lagrangian in one complete shape, with derivatives in place of coefficients: derivative = weight * coefficient. */
typedef struct evaluation {
  tl_shape shape;
  tl_ctx context;
  tl_real *q, *qd, *t, *L; /* jets */
  tl_real *weight;         /* alpha! of each monomial */
} evaluation;

typedef struct chain {
  struct MODEL parameters;
  evaluation second, third;
  unsigned *place; /* N x 2 x NY x N: of y_k u_i (u_j, x_j), all j beside each other, in a jet of third order */
  double M[N * LD], dinv[TL_LDL_DIAGONAL(N)]; /* M, then its factors */
  double dr[N * LDY], along[LD];              /* -dr/dy, -dr/dy w */
} chain;

static void *memory(size_t bytes) {
  void *block = aligned_alloc(64, (bytes + 63) / 64 * 64 + 64);
  if (block == NULL) abort();
  return block;
}

static double factorials(const tl_shape *s, int position) {
  int alpha[NY], power;
  double product = 1.0;
  tl_monomial(s, position, &power, alpha);
  for (int i = 0; i < NY; i++)
    for (int k = 2; k <= alpha[i]; k++) product *= k;
  return product;
}

static void open_evaluation(evaluation *e, int order, const void *parameters) {
  const tl_spec spec = tl_complete(NY, order);
  const size_t table = tl_shape_bytes(spec), njet = JOIN(MODEL, _model).lagrangian.frame(parameters);
  if (tl_shape_init(&e->shape, spec, memory(table), table) != 0) abort();
  const size_t ncoef = (size_t)e->shape.ncoef, nreal = tl_ctx_size(&e->shape, njet);
  tl_ctx_init(&e->context, &e->shape, memory(nreal * sizeof(tl_real)), nreal);
  e->q = memory((NY + 3) * ncoef * sizeof(tl_real));
  e->qd = e->q + N * ncoef, e->t = e->q + NY * ncoef, e->L = e->t + ncoef, e->weight = e->L + ncoef;
  for (int k = 0; k < e->shape.ncoef; k++) e->weight[k] = factorials(&e->shape, k);
}

/* Leaves the derivatives of L in e->L. */
static int evaluate(chain *c, evaluation *e, const double *q, const double *qd) {
  const int ncoef = e->shape.ncoef;
  tl_ctx_clear(&e->context);
  for (int i = 0; i < N; i++) {
    tl_seed(&e->context, e->q + i * ncoef, q[i], X + i);
    tl_seed(&e->context, e->qd + i * ncoef, qd[i], U + i);
  }
  tl_const(&e->context, e->t, 0.0);
  JOIN(MODEL, _model).lagrangian.jet(&e->context, e->L, e->q, e->qd, e->t, &c->parameters);
  for (int k = 0; k < ncoef; k++) e->L[k] *= e->weight[k];
  return e->context.status.bits != TL_OK;
}

/* The place of y_i y_j, i <= j. */
static int pair(const tl_shape *s, int i, int j) { return s->start[2] + i * NY - i * (i - 1) / 2 + j - i; }

/* M and Q, and from them qdd. */
static int solve_motion(chain *c, const evaluation *e, const double *qd, double *qdd) {
  const tl_shape *s = &e->shape;
  const double *gradient = e->L + s->start[1];
  for (int i = 0; i < N; i++) {
    double Q = gradient[X + i];
    for (int j = 0; j < N; j++) Q -= e->L[pair(s, X + j, U + i)] * qd[j];
    for (int j = i; j < N; j++) c->M[i * LD + j] = e->L[pair(s, U + i, U + j)];
    qdd[i] = Q;
  }
  return !(tl_ldl_factor_solve(N, qdd, c->M, LD, c->dinv, qdd) <= TL_MAX);
}

/* c->dr = -dr/dy. */
static void linearise(chain *c, const evaluation *e, const double *qd, const double *qdd) {
  const tl_shape *s = &e->shape;
  const unsigned *by_u = c->place;
  for (int i = 0; i < N; i++)
    for (int k = 0; k < NY; k++, by_u += 2 * N) {
      const unsigned *by_x = by_u + N;
      double sum = k >= U ? e->L[pair(s, k - U, U + i)] - e->L[pair(s, X + i, k)] : -e->L[pair(s, i < k ? i : k, i < k ? k : i)];
      for (int j = 0; j < N; j++) sum += e->L[by_u[j]] * qdd[j] + e->L[by_x[j]] * qd[j];
      c->dr[i * LDY + k] = -sum;
    }
}

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain *c = self;
  return evaluate(c, &c->second, q, qd) || solve_motion(c, &c->second, qd, qdd);
}

static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  chain *c = self;
  if (evaluate(c, &c->third, q, qd) || solve_motion(c, &c->third, qd, qdd)) return 1;
  linearise(c, &c->third, qd, qdd);
  tl_ldl_solve_many(N, NY, c->dr, LDY, c->M, LD, c->dinv);
  for (int i = 0; i < N; i++) memcpy(qdd_y + i * NY, c->dr + i * LDY, NY * sizeof(double));
  return 0;
}

static int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  chain *c = self;
  if (evaluate(c, &c->third, q, qd) || solve_motion(c, &c->third, qd, qdd)) return 1;
  linearise(c, &c->third, qd, qdd);
  for (int i = 0; i < N; i++) {
    c->along[i] = 0.0;
    for (int k = 0; k < NY; k++) c->along[i] += c->dr[i * LDY + k] * w[k];
  }
  tl_ldl_solve(N, dqdd, c->M, LD, c->dinv, c->along);
  return 0;
}

static unsigned triple(const tl_shape *s, int i, int j, int k) {
  int alpha[NY] = {0};
  alpha[i]++, alpha[j]++, alpha[k]++;
  return (unsigned)tl_index(s, 0, alpha);
}

static void find_places(chain *c) {
  unsigned *place = c->place = memory(sizeof(unsigned) * 2 * N * N * NY);
  for (int i = 0; i < N; i++)
    for (int k = 0; k < NY; k++) {
      for (int j = 0; j < N; j++) *place++ = triple(&c->third.shape, U + i, U + j, k);
      for (int j = 0; j < N; j++) *place++ = triple(&c->third.shape, U + i, X + j, k);
    }
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  if (problem->n != N) return 1;
  chain *c = memory(sizeof *c);
  c->parameters = JOIN(MODEL, _parameters)(problem);
  open_evaluation(&c->second, 2, &c->parameters);
  open_evaluation(&c->third, 3, &c->parameters);
  find_places(c);
  *contender = (bench_contender){.self = c, .lanes = 1, .acceleration = acceleration, .jacobian = jacobian, .directional = directional};
  return 0;
}
