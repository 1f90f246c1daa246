/* A cart that carries a chain of links. Modern C: lengths before arrays, restrict, arrays of variable length, prefix sums. */
#include <math.h>
#include <stddef.h>

struct cart {
  int links;
  int coordinates; /* links + 1: the cart first */
  double mass, spring, gravity;
  const double *bob, *rod;
};

static const double bob[] = {0.9, 0.6, 0.4}, rod[] = {0.7, 0.5, 0.45};
static const struct cart cart = {.links = 3, .coordinates = 4, .mass = 2.5, .spring = 12.0, .gravity = 9.81, .bob = bob, .rod = rod};

/* sum[i] = start + terms[0] + .. + terms[i-1], i = 0..n */
static void prefix_sum(int n, double sum[restrict static n + 1], const double terms[restrict static n], double start) {
  sum[0] = start;
  for (int i = 0; i < n; ++i) sum[i + 1] = sum[i] + terms[i];
}

static double dot(int n, const double a[static n], const double b[static n]) {
  double s = 0;
  while (n --> 0) s += a[n] * b[n];
  return s;
}

double cart_lagrangian(const double *restrict q, const double *restrict qd, const struct cart *restrict p) {
  const int n = p->links;
  double ux[n], uy[n], vx[n + 1], vy[n + 1], height[n], y[n + 1];
  double kinetic = p->mass * qd[0] * qd[0] / 2;

  for (int i = 0; i < n; ++i) {
    const double angle = q[i + 1], rate = qd[i + 1];
    ux[i] = p->rod[i] * rate * cos(angle);
    uy[i] = p->rod[i] * rate * sin(angle);
    height[i] = -p->rod[i] * cos(angle);
  }
  prefix_sum(n, vx, ux, qd[0]);
  prefix_sum(n, vy, uy, 0.0);
  prefix_sum(n, y, height, 0.0);
  for (int i = 1; i <= n; ++i) kinetic += p->bob[i - 1] * (vx[i] * vx[i] + vy[i] * vy[i]) / 2;
  return kinetic - p->gravity * dot(n, p->bob, y + 1) - p->spring * q[0] * q[0] / 2;
}

void cart_joint_friction(const double *restrict q, const double *restrict qd, const struct cart *restrict p, double *restrict out) {
  double torque[p->links + 1];
  (void)q;
  torque[p->links] = 0.0;
  for (int i = 0; i < p->links; ++i) torque[i] = -0.02 * (qd[i + 1] - (i ? qd[i] : 0.0));
  out[0] = -0.4 * qd[0];
  for (int i = 0; i < p->links; ++i) out[i + 1] = torque[i] - torque[i + 1];
}
