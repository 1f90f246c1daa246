/* Coordinates and velocities passed one by one. */
#include <math.h>

static double gap(double x, double y) {
  x -= y;
  return sqrt(1 + x * x);
}

double lagrangian(double xd, double x, double y, double yd, double t) {
  double T = 0.5 * (xd * xd + 2 * yd * yd * cos(x));
  return T - gap(x, y) * t;
}

void push(double x, double y, double *out) {
  out[0] = x * y;
  out[1] = sin(x) - y;
}
