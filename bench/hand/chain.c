/* The planar chain worked out by hand: mass matrix in closed form, forces and linearisation by sums along the chain, M = L D L'.
 *
 *   M_ij = mu_max(i,j) l_i l_j cos(q_i - q_j),   mu_i = sum of the masses from i to the end
 *   r_i = C_i X_i + S_i (Y_i + mu_i g) = (M qdd - Q)_i,   C_i = l_i cos q_i, S_i = l_i sin q_i,
 *   X_i = sum_{k>=i} m_k sum_{j<=k} fx_j,  fx = C qdd - S qd^2,   Y_i likewise with  fy = S qdd + C qd^2
 *   dr_i/dq_j = min(mu_i, mu_j) (S_i fx_j - C_i fy_j) + [i = j] (C_i (Y_i + mu_i g) - S_i X_i)
 *   dr_i/dqd_j = 2 min(mu_i, mu_j) (S_i C_j - C_i S_j) qd_j
 *
 * Built with -DN=links as rows of vectors (-DLANES=4 or 8), or with -DREGISTERS as straight-line code without an array in memory (with
 * -DCOLUMNS=4 or 8: but for J's rows). The parameters are read at each call. A relative_chain is converted to absolute angles outside
 * the timing: what it is worth to know the better coordinates. */
#include "contender.h"
#include "hand/kernels.h"
#include "parameters.h"

enum { NP = PADDED(N), LD = PADDED(N + 1), LDB = PADDED(N + PADDED(N)) };

#ifdef REGISTERS
#define EACH UNROLL
#else
#define EACH
#endif
/* What F, J and V share at one state. */
typedef struct frame {
  double ALIGNED C[NP], S[NP], mu[NP], w2[NP]; /* w2 = qd^2 */
  double ALIGNED M[N * LD], dinv[NP];          /* [M | -r at qdd = 0], upper triangle */
  double ALIGNED L[N * LD];                    /* its factor L' with (L D)^-1 of the last column beside it */
} frame;

/* X_i = sum_{k>=i} m_k sum_{j<=k} f_j. */
INLINE void sum_chain(const double *mass, const double *f, double *X) {
  double sum = 0.0;
  EACH for (int k = 0; k < N; k++) sum += f[k], X[k] = mass[k] * sum;
  EACH for (int k = N - 2; k >= 0; k--) X[k] += X[k + 1];
}

INLINE void read_state(const struct pendulum *p, const double *q, const double *qd, frame *z) {
  double s[NP], c[NP];
  sincos_array(N, q, s, c);
  z->mu[N - 1] = p->mass[N - 1];
  EACH for (int i = N - 2; i >= 0; i--) z->mu[i] = z->mu[i + 1] + p->mass[i];
  EACH for (int i = 0; i < N; i++) z->C[i] = p->length[i] * c[i], z->S[i] = p->length[i] * s[i], z->w2[i] = qd[i] * qd[i];
  EACH for (int i = N; i < NP; i++) z->C[i] = z->S[i] = z->w2[i] = z->mu[i] = 0.0;
}

/* fx, fy at the given accelerations, and the weighted sums X, Y + mu g. */
INLINE void sum_forces(const struct pendulum *p, const frame *z, const double *qdd, double *fx, double *fy, double *X, double *Y) {
  EACH for (int j = 0; j < N; j++) fx[j] = z->C[j] * qdd[j] - z->S[j] * z->w2[j], fy[j] = z->S[j] * qdd[j] + z->C[j] * z->w2[j];
  sum_chain(p->mass, fx, X);
  sum_chain(p->mass, fy, Y);
  EACH for (int i = 0; i < N; i++) Y[i] += z->mu[i] * p->g;
}

/* F. */
INLINE void accelerate(const struct pendulum *p, const double *q, const double *qd, frame *z, double *qdd) {
  double fx[NP], fy[NP], X[NP], Y[NP], PC[NP], PS[NP];
  read_state(p, q, qd, z);
  EACH for (int j = 0; j < N; j++) fx[j] = -z->S[j] * z->w2[j], fy[j] = z->C[j] * z->w2[j];
  sum_chain(p->mass, fx, X);
  sum_chain(p->mass, fy, Y);
  EACH for (int j = 0; j < NP; j++) PC[j] = z->mu[j] * z->C[j], PS[j] = z->mu[j] * z->S[j];
  EACH for (int i = 0; i < N; i++) {
    EACH for (int j = i / CELLS * CELLS; j < N; j += CELLS)
        put_cell(z->M + i * LD + j, z->C[i] * cell_at(PC + j) + z->S[i] * cell_at(PS + j));
    z->M[i * LD + N] = -(z->C[i] * X[i] + z->S[i] * (Y[i] + z->mu[i] * p->g));
  }
  factor(N, z->M, z->L, LD, z->dinv);
  solve_appended(N, qdd, z->L, LD);
}

static int acceleration(void *self, const double *restrict q, const double *restrict qd, double *restrict qdd) {
  frame z;
  double a[NP];
  accelerate(self, q, qd, &z, a);
  EACH for (int i = 0; i < N; i++) qdd[i] = a[i];
  return 0;
}

/* Row i of -dr/d(q,qd) into b[0..N) and b[N..2N). */
INLINE void linear_row(const frame *z, int i, const double *fx, const double *fy, const double *v, double diagonal, double *b) {
  double C = z->C[i], S = z->S[i];
  EACH_ENTRY for (int j = 0; j < N; j += ENTRIES)
      put_entry(b + j, smaller(z->mu[i], entry_at(z->mu + j)) * (C * entry_at(fy + j) - S * entry_at(fx + j)));
  EACH_ENTRY for (int j = 0; j < N; j += ENTRIES) put_entry(
      b + N + j, smaller(z->mu[i], entry_at(z->mu + j)) * (C * entry_at(z->S + j) - S * entry_at(z->C + j)) * entry_at(v + j));
  b[i] -= diagonal;
}

static int jacobian(void *self, const double *restrict q, const double *restrict qd, double *restrict qdd, double *restrict qdd_y) {
  const struct pendulum *p = self;
  frame z;
  double ALIGNED a[NP], fx[NP], fy[NP], X[NP], Y[NP], v[NP], B[N * LDB];
  accelerate(p, q, qd, &z, a);
  sum_forces(p, &z, a, fx, fy, X, Y);
  EACH_ENTRY for (int j = N; j < NP; j++) fx[j] = fy[j] = 0.0;
  EACH_ENTRY for (int j = 0; j < N; j++) v[j] = 2.0 * qd[j];
  double *b = LDB == 2 * N ? qdd_y : B;
  EACH_ENTRY for (int i = 0; i < N; i++) linear_row(&z, i, fx, fy, v, z.C[i] * Y[i] - z.S[i] * X[i], b + i * LDB);
  solve_many(N, 2 * N, b, LDB, z.L, LD, z.dinv);
  EACH for (int i = 0; i < N; i++) qdd[i] = a[i];
  if (b == B) EACH_ENTRY for (int i = 0; i < N; i++) EACH_ENTRY for (int j = 0; j < 2 * N; j++) qdd_y[i * 2 * N + j] = B[i * LDB + j];
  return 0;
}

static int directional(void *self, const double *restrict q, const double *restrict qd, const double *restrict w, double *restrict qdd,
                       double *restrict dqdd) {
  const struct pendulum *p = self;
  frame z;
  double a[NP], fx[NP], fy[NP], X[NP], Y[NP], gx[NP], gy[NP], U[NP], V[NP], b[NP];
  accelerate(p, q, qd, &z, a);
  sum_forces(p, &z, a, fx, fy, X, Y);
  EACH for (int j = 0; j < N; j++) {
    double dw2 = 2.0 * qd[j] * w[N + j];
    gx[j] = -fy[j] * w[j] - z.S[j] * dw2, gy[j] = fx[j] * w[j] + z.C[j] * dw2;
  }
  sum_chain(p->mass, gx, U);
  sum_chain(p->mass, gy, V);
  EACH for (int i = 0; i < N; i++) b[i] = -(z.C[i] * U[i] + z.S[i] * V[i] + (z.C[i] * Y[i] - z.S[i] * X[i]) * w[i]);
  solve_one(N, b, z.L, LD, z.dinv);
  EACH for (int i = 0; i < N; i++) qdd[i] = a[i], dqdd[i] = b[i];
  return 0;
}

static void add_up(const double *x, double *sum) {
  sum[0] = x[0];
  for (int i = 1; i < N; i++) sum[i] = sum[i - 1] + x[i];
}

static void to_absolute(void *self, const double *q, const double *qd, const double *w, double *aq, double *aqd, double *aw) {
  (void)self;
  add_up(q, aq), add_up(qd, aqd), add_up(w, aw), add_up(w + N, aw + N);
}

/* x_i - x_(i-1), of numbers that are stride apart. */
static void take_apart(double *x, int stride) {
  for (int i = N - 1; i > 0; i--) x[i * stride] -= x[(i - 1) * stride];
}

/* The sum of the columns from j on, for a derivative by relative angles. */
static void to_relative(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd) {
  (void)self, (void)q, (void)qd;
  take_apart(qdd, 1);
  if (need == 'V') take_apart(dqdd, 1);
  if (need != 'J') return;
  for (int j = 0; j < 2 * N; j++) take_apart(qdd_y + j, 2 * N);
  for (int i = 0; i < N; i++)
    for (int j = N - 2; j >= 0; j--)
      qdd_y[i * 2 * N + j] += qdd_y[i * 2 * N + j + 1], qdd_y[i * 2 * N + N + j] += qdd_y[i * 2 * N + N + j + 1];
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  static struct pendulum p;
  int relative = strcmp(problem->model, "relative_chain") == 0;
  if (problem->n != N || (!relative && strcmp(problem->model, "pendulum") != 0)) return 1;
  p = pendulum_parameters(problem);
  *contender =
      (bench_contender){.self = &p, .lanes = 1, .acceleration = acceleration, .jacobian = jacobian, .directional = directional};
  if (relative) contender->to_native = to_absolute, contender->from_native = to_relative;
  return 0;
}
