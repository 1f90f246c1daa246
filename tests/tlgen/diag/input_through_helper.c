/* The inputs, written to where a helper made a pointer point. */
static void pick(double **to, double *from) { *to = from; }
static void choose(double **to, double *a, double *b, int i) { *to = i ? a : b; }
static void exchange(double **a, double **b)
{
  double *c = *a;
  *a = *b;
  *b = c;
}
double L(double *q, double *qd, double t)
{
  double own[1] = {t}, *x = own, *y, *z = own, *w = qd;
  pick(&x, q);
  x[0] = 2 * t; /* expect: write-input */
  choose(&y, own, q, 0);
  y[0] = 2.0; /* expect: write-input */
  exchange(&z, &w);
  z[0] += 1.0; /* expect: write-input */
  return q[0] * qd[0] * own[0];
}
