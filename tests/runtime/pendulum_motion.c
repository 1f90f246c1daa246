/* The N-pendulum's equations of motion in closed form: with c_ij = n - max(i,j) (counted from 0) and d_ij = q_i - q_j
 *   L = sum_ij c_ij cos(d_ij) qd_i qd_j / 2 + g sum_i (n - i) cos(q_i)
 *   r_i = sum_j c_ij (cos(d_ij) qdd_j + sin(d_ij) qd_j^2) + (n - i) g sin(q_i). */
#include "pendulum_motion.h"

#include <math.h>
#include <string.h>

enum { MOST = 3 };

static tl_real weight(int n, int i, int j) { return (tl_real)(n - (i > j ? i : j)); }

static int verdict(const pendulum *p, int n) {
  if (p->n != n) return EOM_MOTION_SIZE;
  return TL_ISFINITE(p->g) ? 0 : EOM_MOTION_NOT_FINITE;
}

static int energy(int n, const pendulum *p, const tl_real *q, const tl_real *qd, tl_real *momentum, tl_real *rate, tl_real *lagrangian,
                  tl_real *total) {
  tl_real kinetic = 0, potential = 0;
  for (int i = 0; i < n; i++) {
    momentum[i] = 0;
    rate[i] = -(tl_real)(n - i) * p->g * TL_LIBM(sin)(q[i]);
    for (int j = 0; j < n; j++) {
      momentum[i] += weight(n, i, j) * TL_LIBM(cos)(q[i] - q[j]) * qd[j];
      rate[i] -= weight(n, i, j) * TL_LIBM(sin)(q[i] - q[j]) * qd[i] * qd[j];
    }
    kinetic += momentum[i] * qd[i] / 2;
    potential -= (tl_real)(n - i) * p->g * TL_LIBM(cos)(q[i]);
  }
  *lagrangian = kinetic - potential;
  *total = kinetic + potential;
  return verdict(p, n);
}

static int residual(int n, const pendulum *p, const tl_real *q, const tl_real *qd, const tl_real *qdd, tl_real *r) {
  for (int i = 0; i < n; i++) {
    r[i] = (tl_real)(n - i) * p->g * TL_LIBM(sin)(q[i]);
    for (int j = 0; j < n; j++) {
      const tl_real d = q[i] - q[j];
      r[i] += weight(n, i, j) * (TL_LIBM(cos)(d) * qdd[j] + TL_LIBM(sin)(d) * qd[j] * qd[j]);
    }
  }
  return verdict(p, n);
}

static int simulate(int n, const pendulum *p, const tl_real *q, const tl_real *qd, const eom_parts *out) {
  const tl_real zero[MOST] = {0};
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) out->M[i * n + j] = weight(n, i, j) * TL_LIBM(cos)(q[i] - q[j]);
  const int code = residual(n, p, q, qd, zero, out->Q);
  for (int i = 0; i < n; i++) out->Q[i] = -out->Q[i];
  return code;
}

static int linearise(int n, const pendulum *p, const tl_real *q, const tl_real *qd, const tl_real *qdd, tl_real *r_y) {
  memset(r_y, 0, 2 * (size_t)(n * n) * sizeof(tl_real));
  for (int i = 0; i < n; i++) {
    tl_real *row = r_y + i * 2 * n;
    row[i] = (tl_real)(n - i) * p->g * TL_LIBM(cos)(q[i]);
    for (int j = 0; j < n; j++) {
      const tl_real d = q[i] - q[j], c = weight(n, i, j);
      const tl_real by_d = c * (TL_LIBM(cos)(d) * qd[j] * qd[j] - TL_LIBM(sin)(d) * qdd[j]);
      row[i] += by_d;
      row[j] -= by_d;
      row[n + j] = 2 * c * TL_LIBM(sin)(d) * qd[j];
    }
  }
  return verdict(p, n);
}

/* c = a w for a (n x 2n), w (2n x k). */
static void multiply(int n, int k, tl_real *c, const tl_real *a, const tl_real *w) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < k; j++) {
      c[i * k + j] = 0;
      for (int l = 0; l < 2 * n; l++) c[i * k + j] += a[i * 2 * n + l] * w[l * k + j];
    }
}

static int tangent(int n, const pendulum *p, const tl_real *q, const tl_real *qd, const tl_real *qdd, int k, const tl_real *w,
                   tl_real *r_w) {
  tl_real r_y[2 * MOST * MOST];
  const int code = linearise(n, p, q, qd, qdd, r_y);
  multiply(n, k, r_w, r_y, w);
  return code;
}

static int parameters(int n, const pendulum *p, const tl_real *q, tl_real *r_p) {
  for (int i = 0; i < n; i++) r_p[i] = (tl_real)(n - i) * TL_LIBM(sin)(q[i]);
  return verdict(p, n);
}

/* x = M^-1 x for k columns by Gauss-Jordan elimination, the diagonal as pivots. */
static int solve(int n, tl_real *M, int k, tl_real *x) {
  for (int i = 0; i < n; i++) {
    const tl_real pivot = M[i * n + i];
    if (!(pivot > EOM_MOTION_LEAST_PIVOT(n) * weight(n, i, i))) return EOM_MOTION_PIVOT;
    for (int r = 0; r < n; r++) {
      const tl_real factor = M[r * n + i] / pivot;
      if (r == i) continue;
      for (int j = i; j < n; j++) M[r * n + j] -= factor * M[i * n + j];
      for (int j = 0; j < k; j++) x[r * k + j] -= factor * x[i * k + j];
    }
  }
  for (int i = 0; i < n; i++)
    for (int j = 0; j < k; j++) x[i * k + j] /= M[i * n + i];
  return 0;
}

static int acceleration(int n, const pendulum *p, const tl_real *q, const tl_real *qd, tl_real *qdd) {
  tl_real M[MOST * MOST];
  const eom_parts parts = {.M = M, .Q = qdd};
  const int code = simulate(n, p, q, qd, &parts);
  return code ? code : solve(n, M, 1, qdd);
}

static int directional(int n, const pendulum *p, const tl_real *q, const tl_real *qd, int k, const tl_real *w, tl_real *qdd,
                       tl_real *dqdd) {
  tl_real M[MOST * MOST], Q[MOST];
  const eom_parts parts = {.M = M, .Q = Q};
  int code = acceleration(n, p, q, qd, qdd);
  if (code == 0) code = simulate(n, p, q, qd, &parts);
  if (code == 0) code = tangent(n, p, q, qd, qdd, k, w, dqdd);
  for (int i = 0; i < n * k; i++) dqdd[i] = -dqdd[i];
  return code ? code : solve(n, M, k, dqdd);
}

static int jacobian(int n, const pendulum *p, const tl_real *q, const tl_real *qd, tl_real *qdd, tl_real *qdd_y) {
  tl_real unit[4 * MOST * MOST] = {0};
  for (int i = 0; i < 2 * n; i++) unit[i * 2 * n + i] = 1;
  return directional(n, p, q, qd, 2 * n, unit, qdd, qdd_y);
}

static const char *const parameter[] = {"p->g"};

/* The functions above at one size, as tlgen would print them. */
#define STATE const void *p, const tl_real *q, const tl_real *qd, tl_real t
#define UNUSED (void)t, (void)work
#define AT_SIZE(links, name)                                                                                                           \
  static int fits_##links(const void *p) { return ((const pendulum *)p)->n == links; }                                                 \
  static int energy_##links(STATE, tl_real *momentum, tl_real *rate, tl_real *lagrangian, tl_real *total, tl_real *work) {             \
    return UNUSED, energy(links, p, q, qd, momentum, rate, lagrangian, total);                                                         \
  }                                                                                                                                    \
  static int simulate_##links(STATE, const eom_parts *out, tl_real *work) { return UNUSED, simulate(links, p, q, qd, out); }           \
  static int residual_##links(STATE, const tl_real *qdd, tl_real *r, tl_real *work) {                                                  \
    return UNUSED, residual(links, p, q, qd, qdd, r);                                                                                  \
  }                                                                                                                                    \
  static int linearise_##links(STATE, const tl_real *qdd, const tl_real *lambda, tl_real *r_y, tl_real *g_y, tl_real *work) {          \
    return (void)lambda, (void)g_y, UNUSED, linearise(links, p, q, qd, qdd, r_y);                                                      \
  }                                                                                                                                    \
  static int tangent_##links(STATE, const tl_real *qdd, const tl_real *lambda, int k, const tl_real *w, tl_real *r_w, tl_real *g_w,    \
                             tl_real *work) {                                                                                          \
    return (void)lambda, (void)g_w, UNUSED, tangent(links, p, q, qd, qdd, k, w, r_w);                                                  \
  }                                                                                                                                    \
  static int parameters_##links(STATE, const tl_real *qdd, const tl_real *lambda, tl_real *r_p, tl_real *g_p, tl_real *work) {         \
    return (void)qd, (void)qdd, (void)lambda, (void)g_p, UNUSED, parameters(links, p, q, r_p);                                         \
  }                                                                                                                                    \
  static int acceleration_##links(STATE, tl_real *qdd, tl_real *work) { return UNUSED, acceleration(links, p, q, qd, qdd); }           \
  static int jacobian_##links(STATE, tl_real *qdd, tl_real *qdd_y, tl_real *work) {                                                    \
    return UNUSED, jacobian(links, p, q, qd, qdd, qdd_y);                                                                              \
  }                                                                                                                                    \
  static int directional_##links(STATE, int k, const tl_real *w, tl_real *qdd, tl_real *dqdd, tl_real *work) {                         \
    return UNUSED, directional(links, p, q, qd, k, w, qdd, dqdd);                                                                      \
  }                                                                                                                                    \
  const eom_motion name = {.n = links,                                                                                                 \
                           .fits = fits_##links,                                                                                       \
                           .parameter = parameter,                                                                                     \
                           .np = 1,                                                                                                    \
                           .energy = energy_##links,                                                                                   \
                           .simulate = simulate_##links,                                                                               \
                           .residual = residual_##links,                                                                               \
                           .linearise = linearise_##links,                                                                             \
                           .tangent = tangent_##links,                                                                                 \
                           .parameters = parameters_##links,                                                                           \
                           .acceleration = acceleration_##links,                                                                       \
                           .jacobian = jacobian_##links,                                                                               \
                           .directional = directional_##links};

AT_SIZE(1, pendulum_motion_1)
AT_SIZE(3, pendulum_motion_3)

eom_model pendulum_with_motion(void) {
  static const eom_motion *const sizes[] = {&pendulum_motion_1, &pendulum_motion_3};
  eom_model model = pendulum_model;
  model.motion = sizes;
  model.nmotion = 2;
  return model;
}
