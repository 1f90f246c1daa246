/* Arrays whose length is not known from the parameters alone. */
static double total(int n, const double *x)
{
  double copy[n], s = 0; /* expect: vla */
  for (int i = 0; i < n; i++) copy[i] = x[i] * x[i];
  for (int i = 0; i < n; i++) s += copy[i];
  return s;
}
double L(const double *q)
{
  int n = 1 + (q[0] > 0);
  double f[n]; /* expect: vla */
  f[0] = q[0];
  return f[0] + total(n, q);
}
