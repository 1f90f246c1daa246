/* A size belongs to an integer member of the parameter struct. */
/* tlgen: --lagrangian L --dof n --size n=2 --size m=3 */
struct rope {
  int n;
  double m;
};
double L(const double *q, const double *qd, const struct rope *p) { /* expect: bad-size */
  double sum = 0;
  for (int k = 0; k < p->n; k++) sum += p->m * qd[k] * qd[k] - q[k];
  return sum;
}
