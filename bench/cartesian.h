/* The way from the pendulum's angles to x and y of its masses, (x_1, y_1, x_2, ..), y upwards, and back with the accelerations. */
#ifndef BENCH_CARTESIAN_H
#define BENCH_CARTESIAN_H

#include "contender.h"

#include <math.h>

/* q, qd: n angles and rates; native: 2n. length: n. */
static inline void cartesian_state(int n, const double *length, const double *q, const double *qd, double *native_q,
                                   double *native_qd) {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;
  for (int k = 0; k < n; k++) {
    const double s = length[k] * sin(q[k]), c = length[k] * cos(q[k]);
    native_q[2 * k] = x += s, native_q[2 * k + 1] = y -= c;
    native_qd[2 * k] = vx += c * qd[k], native_qd[2 * k + 1] = vy += s * qd[k];
  }
}

/* qdd: 2n accelerations of the masses become n of the angles, in place: what each rod's ends differ by across the rod. */
static inline void angular_accelerations(int n, const double *length, const double *q, double *qdd) {
  double x = 0.0, y = 0.0;
  for (int k = 0; k < n; k++) {
    const double ax = qdd[2 * k], ay = qdd[2 * k + 1];
    qdd[k] = ((ax - x) * cos(q[k]) + (ay - y) * sin(q[k])) / length[k];
    x = ax, y = ay;
  }
}

#endif
