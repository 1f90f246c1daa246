/* Motion functions need sizes that are known beforehand: a note says which are missing. */
/* tlgen: --lagrangian L --dof n */
struct rope {
  int n;
};
double L(const double *q, const double *qd, const struct rope *p) { /* notes: no-size */
  double sum = 0;
  for (int k = 0; k < p->n; k++) sum += qd[k] * qd[k] - q[k];
  return sum;
}
