/* What a loop has summed up so far, stored with twice the last term: no state that the sum ever has. */
#include <math.h>
double partial_sums(const double *q, const double *qd)
{
  double x = 0.0, at[6], T = 0.0;
  for (int k = 0; k < 6; k++) {
    double dx = cos(q[k]) * qd[k];
    at[k] = x + 2.0 * dx;
    x += dx;
  }
  for (int k = 0; k < 6; k++) T += 0.5 * at[k] * at[k] + 0.5 * qd[k] * qd[k];
  return T;
}
