/* An index that leaves q at the size that is asked for. */
/* tlgen: --lagrangian L --holonomic ties:rows --dof n --size n=3 --size rows=3 */
struct chain {
  int n, rows;
  double k;
};
double L(const double *q, const double *qd, const struct chain *p) {
  double sum = 0;
  for (int i = 0; i < p->n; i++) sum += qd[i] * qd[i] - p->k * q[i] * q[i];
  return sum;
}
void ties(const double *q, const struct chain *p, double *out) {
  for (int i = 0; i < p->rows; i++) out[i] = q[i] - q[i + 1]; /* expect: index-range */
}
