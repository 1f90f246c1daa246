/* Arrays whose length is a parameter that changes later: rows and sizes would follow it. */
#include <stddef.h>
static double rows(const double *x, int n)
{
  double w[2][n], s = 0.0; /* expect: vla */
  for (int i = 0; i < n; i++) w[0][i] = w[1][i] = x[0] * i;
  n = 1;
  s = w[1][n];
  return s;
}
static double size(const double *x, int n)
{
  double w[n], s = 0.0;    /* expect: vla */
  for (int i = 0; i < n; i++) w[i] = x[0];
  while (n-- > 0) s += w[n];
  return s * (double)sizeof w; /* expect: vla */
}
static double shadow(const double *x, int n)
{
  double w[2][n], s = 0.0; /* expect: vla */
  for (int i = 0; i < n; i++) w[0][i] = w[1][i] = x[0] * i;
  for (int n = 0; n < 2; n++) s += w[1][n];
  return s;
}
double L(const double *q) { return rows(q, 3) + size(q, 2) + shadow(q, 2); }
