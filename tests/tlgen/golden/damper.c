/* Mass on a spring in a fluid whose drag grows with the square of the speed. */
#include <math.h>

double damper_lagrangian(const double *q, const double *qd) { return 0.5 * (qd[0] * qd[0] - q[0] * q[0]); }

double damper_loss(const double *qd)
{
  const double speed = fabs(qd[0]);
  return 0.2 * speed * speed * speed / 3.0;
}
