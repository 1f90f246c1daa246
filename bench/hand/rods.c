/* The chain in Cartesian coordinates worked out by hand: rods as constraints, A M^-1 A' tridiagonal, gravity the same for all masses.
 *
 *   d_k = x_k - x_{k-1}, e_k likewise of the velocities,  x_k'' = (d_k z_k - d_{k+1} z_{k+1}) / m_k + g,
 *   (1/m_{k-1} + 1/m_k) |d_k|^2 z_k - (d_k.d_{k-1} / m_{k-1}) z_{k-1} - (d_k.d_{k+1} / m_k) z_{k+1} = -|e_k|^2 - [k = 1] d_1.g
 *
 * Built with -DN=links. The parameters are read at each call. */
#include "cartesian.h"
#include "parameters.h"

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  const struct cartesian_pendulum *p = self;
  double dx[N + 1], dy[N + 1], z[N + 1], diagonal[N], beside[N], w[N];
  dx[N] = dy[N] = z[N] = 0.0;
  dx[0] = q[0], dy[0] = q[1], z[0] = dy[0] * p->g - (qd[0] * qd[0] + qd[1] * qd[1]);
  for (int k = 0; k < N; k++) w[k] = 1.0 / p->mass[k];
  for (int k = 1; k < N; k++) {
    const double ex = qd[2 * k] - qd[2 * k - 2], ey = qd[2 * k + 1] - qd[2 * k - 1];
    dx[k] = q[2 * k] - q[2 * k - 2], dy[k] = q[2 * k + 1] - q[2 * k - 1];
    z[k] = -(ex * ex + ey * ey);
  }
  diagonal[0] = w[0] * (dx[0] * dx[0] + dy[0] * dy[0]);
  for (int k = 1; k < N; k++) {
    diagonal[k] = (w[k - 1] + w[k]) * (dx[k] * dx[k] + dy[k] * dy[k]);
    beside[k - 1] = -w[k - 1] * (dx[k] * dx[k - 1] + dy[k] * dy[k - 1]);
  }
  for (int k = 0; k < N; k++) {
    diagonal[k] = 1.0 / diagonal[k];
    if (k + 1 == N) break;
    const double factor = beside[k] * diagonal[k];
    diagonal[k + 1] -= factor * beside[k];
    z[k + 1] -= factor * z[k];
  }
  z[N - 1] *= diagonal[N - 1];
  for (int k = N - 2; k >= 0; k--) z[k] = (z[k] - beside[k] * z[k + 1]) * diagonal[k];
  for (int k = 0; k < N; k++) {
    qdd[2 * k] = (dx[k] * z[k] - dx[k + 1] * z[k + 1]) * w[k];
    qdd[2 * k + 1] = (dy[k] * z[k] - dy[k + 1] * z[k + 1]) * w[k] - p->g;
  }
  return 0;
}

static void to_native(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd,
                      double *native_w) {
  const struct cartesian_pendulum *p = self;
  (void)w, (void)native_w;
  cartesian_state(N, p->length, q, qd, native_q, native_qd);
}

static void from_native(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd) {
  const struct cartesian_pendulum *p = self;
  (void)need, (void)qd, (void)qdd_y, (void)dqdd;
  angular_accelerations(N, p->length, q, qdd);
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  static struct cartesian_pendulum p;
  p = cartesian_pendulum_parameters(problem);
  *contender = (bench_contender){
      .self = &p, .lanes = 1, .acceleration = acceleration, .to_native = to_native, .from_native = from_native, .coordinates = 2 * N};
  return 0;
}
