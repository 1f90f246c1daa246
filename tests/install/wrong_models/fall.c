/* A unit mass in free fall. */
double lagrangian(const double *q, const double *qd) { return 0.5 * qd[0] * qd[0] - 9.81 * q[0]; }
