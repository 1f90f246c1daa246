/* Functions under conditions, and coordinates that are read there only: where these do not hold, nothing is refused. */
#include <math.h>
double decided_by_sums(const double *q, const double *qd)
{
  double sum = 0.0, T = 0.0;
  for (int k = 0; k < 3; k++) {
    T += 0.5 * qd[k] * qd[k] * (2.0 + cos(q[k]));
    sum += q[k];
  }
  for (int k = 3; k < 6; k++)
    if (q[k] > 0.0) T += sqrt(q[k]) * qd[k];
  if (sum > 0.0)
    T += sqrt(q[0]) * (qd[1] + qd[4]);
  else if (q[1] < q[2])
    T += log(q[2] - q[1]) * qd[2] * qd[3];
  return T;
}
