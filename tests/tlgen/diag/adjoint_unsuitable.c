/* Single precision is carried by the functions on jets alone. */
double L(const double *q, const double *qd) {
  float x = (float)q[0]; /* notes: adjoint-unsuitable */
  return qd[0] * qd[0] - x * x;
}
