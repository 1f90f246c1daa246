/* What the last iteration has left: values that no iteration takes over from the one before. */
#include <math.h>
double last_values(const double *q, const double *qd)
{
  double last = 0.0, fixed = 0.0, T = 0.0;
  for (int k = 0; k < 6; k++) {
    last = cos(q[k]) * qd[k];
    fixed = qd[2] * qd[2];
    T += 0.5 * qd[k] * qd[k] + last * last;
  }
  for (int k = 5; k >= 0; k--) last = last * q[k] + qd[1];
  double before = 0.0;
  for (int k = 0; k < 6; k++) {
    T += before * before;
    before = qd[k] * sin(q[k]);
  }
  return T + last * last + fixed * before;
}
