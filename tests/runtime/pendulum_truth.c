/* The planar N-pendulum in closed form, in quadruple precision: shares nothing with the jets.
 *
 *   M_ij = (N - max(i,j) + 1) cos(q_i - q_j)                                       (i, j from 1)
 *   sum_j M_ij qdd_j = -sum_j (N - max(i,j) + 1) sin(q_i - q_j) qd_j^2 - (N - i + 1) g sin q_i =: Q_i
 *   M d(qdd) = dQ - dM qdd */
#include "pendulum_truth.h"
#include "kkt_truth.h"

#include <stdlib.h>

extern quad sinf128(quad), cosf128(quad);

static quad weight(int n, int i, int j) { return (quad)(n - (i > j ? i : j)); }

static void mass(int n, const double *q, quad *M) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) M[i * n + j] = weight(n, i, j) * cosf128((quad)q[i] - (quad)q[j]);
}

static void force(int n, quad g, const double *q, const double *qd, quad *Q) {
  for (int i = 0; i < n; i++) {
    Q[i] = -(quad)(n - i) * g * sinf128((quad)q[i]);
    for (int j = 0; j < n; j++) Q[i] -= weight(n, i, j) * sinf128((quad)q[i] - (quad)q[j]) * (quad)qd[j] * (quad)qd[j];
  }
}

/* dQ - dM qdd: column k for q_k, column n+k for qd_k. Only cos and sin of q_i - q_j depend on q_i and q_j. */
static void derivative(int n, quad g, const double *q, const double *qd, const quad *qdd, quad *R) {
  for (int i = 0; i < 2 * n * n; i++) R[i] = 0;
  for (int i = 0; i < n; i++) {
    quad *r = R + i * 2 * n;
    r[i] -= (quad)(n - i) * g * cosf128((quad)q[i]);
    for (int j = 0; j < n; j++) {
      const quad w = weight(n, i, j), s = sinf128((quad)q[i] - (quad)q[j]), c = cosf128((quad)q[i] - (quad)q[j]);
      const quad by_difference = w * (s * qdd[j] - c * (quad)qd[j] * (quad)qd[j]);
      r[i] += by_difference;
      r[j] -= by_difference;
      r[n + j] -= 2 * w * s * (quad)qd[j];
    }
  }
}

/* E = qd'M qd/2 - g sum (N - i + 1) cos q_i. */
static quad energy_of(int n, quad g, const double *q, const double *qd, const quad *M) {
  quad e = 0;
  for (int i = 0; i < n; i++) {
    e -= (quad)(n - i) * g * cosf128((quad)q[i]);
    for (int j = 0; j < n; j++) e += (quad)qd[i] * M[i * n + j] * (quad)qd[j] / 2;
  }
  return e;
}

void pendulum_truth(int n, double g, const double *q, const double *qd, double *qdd, double *dqdd_dy, double *energy) {
  const size_t count = (size_t)n;
  quad *M = malloc(count * count * sizeof(quad)), *a = malloc(count * sizeof(quad)), *R = malloc(2 * count * count * sizeof(quad));
  mass(n, q, M);
  if (energy) *energy = (double)energy_of(n, (quad)g, q, qd, M);
  force(n, (quad)g, q, qd, a);
  gauss(n, M, 1, a);
  for (int i = 0; qdd && i < n; i++) qdd[i] = (double)a[i];
  if (dqdd_dy) {
    derivative(n, (quad)g, q, qd, a, R);
    mass(n, q, M);
    gauss(n, M, 2 * n, R);
    for (int i = 0; i < 2 * n * n; i++) dqdd_dy[i] = (double)R[i];
  }
  free(M);
  free(a);
  free(R);
}
