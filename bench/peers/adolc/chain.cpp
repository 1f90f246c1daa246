/* ADOL-C as a contender: the model's source on its active numbers, one tape, its vector forward and reverse drivers.
 *
 * The reverse sweep of L along a path y + s a + s^2 b, y = (x, u) = (q, qd), gives the gradient g = (L_x, L_u) along the path:
 *   [s] g = Dg a,   [s^2] g = Dg b + D^2 g[a,a]/2
 * F: [s] for a = (0, e_j) is M, for a = (qd, 0) it makes Q = L_x - (Dg a)_u.
 * J, V: r = (Dg v)_u - L_x with v = (qd, qdd). Along w, with the two paths a = v +- h w, b = +- h (w_u, 0) of second order
 *   dr w = (D^2 g[v,w] + Dg (w_u,0))_u - (Dg w)_x = half the difference of ([s^2] g)_u - ([s] g)_x, over h
 * for each unit vector w, or for one direction.
 *
 * Built with -DN=links -DMODEL=name -DPATHS=paths in one sweep at most; -DRETAPE: a new tape for each state. */
#include "parameters.h"
#include "taylor/ldl.h"

#include <adolc/adolc.h>

#include <cmath>
#include <vector>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define TEXT_(a) #a
#define TEXT(a) TEXT_(a)

/* The model as its author wrote it, on active numbers. */
#define double adouble
#include TEXT(MODEL.c)
#undef double
#define CALL_pendulum(q, qd, p) pendulum_lagrangian(q, qd, 0.0, p)
#define CALL_relative_chain(q, qd, p) relative_chain_lagrangian(q, qd, p)

namespace {

enum { NY = 2 * N, LD = TL_LDL_ROW(N), LDY = TL_ROW(NY), BUFFER = 1 << 16 };

/* ADOL-C allocates this many numbers in each sweep, and goes to a file where they do not last. */
enum { TAYLORS = 100 * N * (1 + 2 * (PATHS > N ? PATHS : N + 1)) };

const short tape_number = 1;

/* Arrays of paths for sweeps of one degree. */
struct sweep {
  int degree, paths;
  double ***in;  /* NY x paths x degree: coefficients from s up */
  double ***out; /* paths x NY x (degree+1): the gradient's, from 1 up */
  double ***value, **adjoint;
  sweep(int degree, int paths)
      : degree(degree), paths(paths), in(myalloc3(NY, paths, degree)), out(myalloc3(paths, NY, degree + 1)),
        value(myalloc3(1, paths, degree)), adjoint(myalloc2(1, degree + 1)) {
    for (int k = 0; k <= degree; k++) adjoint[0][k] = k == 0;
  }
  void run(const double *y) {
    double L;
    hov_wk_forward(tape_number, 1, NY, degree, degree + 1, paths, const_cast<double *>(y), in, &L, value);
    hos_ov_reverse(tape_number, 1, NY, degree, paths, adjoint, out);
  }
};

struct chain {
  struct MODEL parameters;
  sweep motion, columns, one; /* for F, J and V */
  double y[NY], M[N * LD], dinv[TL_LDL_DIAGONAL(N)], dr[N * LDY], along[LD];
  explicit chain(const struct MODEL &p) : parameters(p), motion(1, N + 1), columns(2, PATHS), one(2, 2) {}
};

void tape(const chain &c) {
  std::vector<adouble> y(NY);
  double L;
  trace_on(tape_number, 0, BUFFER, BUFFER, BUFFER, TAYLORS);
  for (int i = 0; i < NY; i++) y[i] <<= c.y[i];
  JOIN(CALL_, MODEL)(y.data(), y.data() + N, &c.parameters) >>= L;
  trace_off();
}

int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  chain &c = *static_cast<chain *>(self);
  memcpy(c.y, q, N * sizeof(double));
  memcpy(c.y + N, qd, N * sizeof(double));
#ifdef RETAPE
  tape(c);
#endif
  for (int i = 0; i < N; i++) c.motion.in[i][N][0] = qd[i]; /* the other paths never change: see bench_open */
  c.motion.run(c.y);
  for (int i = 0; i < N; i++) {
    for (int j = i; j < N; j++) c.M[i * LD + j] = c.motion.out[j][N + i][1];
    qdd[i] = c.motion.out[N][i][0] - c.motion.out[N][N + i][1];
  }
  return !(tl_ldl_factor_solve(N, qdd, c.M, LD, c.dinv, qdd) <= TL_MAX);
}

/* h: of the size of v, so that the difference of two paths loses no digits. */
double step_size(const double *qd, const double *qdd) {
  double largest = 1.0;
  for (int i = 0; i < N; i++) largest = std::fmax(largest, std::fmax(std::fabs(qd[i]), std::fabs(qdd[i])));
  return largest;
}

/* Paths 2k and 2k + 1 of a sweep: v +- h w. */
void set_paths(sweep &s, int k, double h, const double *qd, const double *qdd, const double *w) {
  for (int i = 0; i < NY; i++) {
    const double v = i < N ? qd[i] : qdd[i - N], dv = i < N ? h * w[N + i] : 0.0;
    s.in[i][2 * k][0] = v + h * w[i];
    s.in[i][2 * k + 1][0] = v - h * w[i];
    s.in[i][2 * k][1] = dv;
    s.in[i][2 * k + 1][1] = -dv;
  }
}

/* The i-th number of dr w from paths 2k and 2k + 1. */
double difference(const sweep &s, int k, double h, int i) {
  double **plus = s.out[2 * k], **minus = s.out[2 * k + 1];
  return ((plus[N + i][2] - minus[N + i][2]) - (plus[i][1] - minus[i][1])) / (2 * h);
}

int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  chain &c = *static_cast<chain *>(self);
  if (acceleration(self, q, qd, qdd)) return 1;
  const double h = step_size(qd, qdd);
  for (int first = 0; first < NY; first += PATHS / 2) {
    const int count = NY - first < PATHS / 2 ? NY - first : PATHS / 2;
    for (int k = 0; k < count; k++) {
      double w[NY] = {0};
      w[first + k] = 1.0;
      set_paths(c.columns, k, h, qd, qdd, w);
    }
    c.columns.run(c.y);
    for (int i = 0; i < N; i++)
      for (int k = 0; k < count; k++) c.dr[i * LDY + first + k] = -difference(c.columns, k, h, i);
  }
  tl_ldl_solve_many(N, NY, c.dr, LDY, c.M, LD, c.dinv);
  for (int i = 0; i < N; i++) memcpy(qdd_y + i * NY, c.dr + i * LDY, NY * sizeof(double));
  return 0;
}

int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  chain &c = *static_cast<chain *>(self);
  if (acceleration(self, q, qd, qdd)) return 1;
  const double h = step_size(qd, qdd);
  set_paths(c.one, 0, h, qd, qdd, w);
  c.one.run(c.y);
  for (int i = 0; i < N; i++) c.along[i] = -difference(c.one, 0, h, i);
  tl_ldl_solve(N, dqdd, c.M, LD, c.dinv, c.along);
  return 0;
}

} // namespace

extern "C" int bench_open(const bench_case *problem, bench_contender *contender) {
  if (problem->n != N) return 1;
  chain *c = new chain(JOIN(MODEL, _parameters)(problem));
  for (int i = 0; i < NY; i++) {
    c->y[i] = 0.5;
    for (int j = 0; j <= N; j++) c->motion.in[i][j][0] = i == N + j;
  }
  tape(*c);
  *contender = {c, 1, acceleration, jacobian, directional, nullptr, nullptr};
  return 0;
}
