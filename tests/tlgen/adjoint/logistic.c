/* What a loop carries changes by a sum whose terms are all negative. */
double logistic(const double *q, const double *qd, double t) {
  for (int k = 0; k < 4; k++)
    for (int j = 0; j < 3; j++) t += 0.4 * t * (1.5 - t * q[0]);
  return 0.5 * qd[1] * qd[1] * (1.0 + t * t) + 0.5 * qd[0] * qd[0];
}
