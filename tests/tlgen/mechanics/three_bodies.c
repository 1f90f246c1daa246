/* Three bodies in a plane, softened gravity (Plummer). Arrays of coordinates, x first, then y. */
#include <math.h>
#include <stddef.h>

typedef struct nbody {
  size_t bodies;
  double G, epsilon2;
  double mass[3];
} nbody;

const nbody figure = {3, 1.0, 0.01, {1.0, 1.3, 0.7}};

static double kinetic(size_t count, const double *restrict m, const double *restrict vx, const double *restrict vy) {
  double twice = 0.0;
  const double *const end = m + count;
  while (m < end) {
    twice += *m++ * (*vx * *vx + *vy * *vy);
    ++vx, ++vy;
  }
  return 0.5 * twice;
}

static double potential(const nbody *restrict s, const double *restrict x, const double *restrict y) {
  double u = 0.0;
  for (size_t i = s->bodies; i-- > 1;) {
    const double *xj = x + i, *yj = y + i, *mj = s->mass + i;
    do {
      --xj, --yj, --mj;
      double dx = x[i] - *xj, dy = y[i] - *yj;
      u -= s->G * s->mass[i] * *mj / sqrt(dx * dx + dy * dy + s->epsilon2);
    } while (xj != x);
  }
  return u;
}

double nbody_lagrangian(const nbody *system, const double *restrict q, const double *restrict qd) {
  const size_t n = system->bodies;
  return kinetic(n, system->mass, qd, qd + n) - potential(system, q, q + n);
}
