/* A potential of functions that exist for some numbers only, one for each coordinate; test_domains.c knows which. */
#include <math.h>

double lagrangian(const double *q, const double *qd) {
  double kinetic = 0.0;
  for (int i = 0; i < 19; i++) kinetic += 0.5 * qd[i] * qd[i];
  return kinetic + log(q[0]) + log2(q[1]) + log10(q[2]) + log1p(q[3]) + atanh(q[4]) + acosh(q[5]) + asin(q[6]) + acos(q[7]) + sqrt(q[8]) +
         pow(q[9], 1.5) + pow(q[10], -0.5) + log(1 / q[11]) + log(-2 * q[12]) + log(q[13] * q[13] * q[13]) + fmax(q[14], 3) + fdim(q[15], 3) + fmin(2 * q[16], 3) + fabs(q[17]) + copysign(2 * q[18], q[0]);
}
