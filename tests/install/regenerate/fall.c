/* A unit mass in free fall. */
#include "gravity.h"
double lagrangian(const double *q, const double *qd) { return 0.5 * qd[0] * qd[0] - GRAVITY * q[0]; }
