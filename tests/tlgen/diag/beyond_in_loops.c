/* Indices that leave their array in a loop of known length, or through a variable of known value. */
/* tlgen: --lagrangian L --dof 2 */
double L(const double *q)
{
  double a[2] = {q[0], q[1]}, b[3] = {0.0}, s = 0.0;
  int i, k = 7, n = 2;
  double v[n];
  unsigned u = 0;
  for (i = 0; i < 2; i++) v[i] = q[i];
  s += q[i];                                    /* expect: index-range */
  for (int j = 0; j <= 2; j++) s += a[j];       /* expect: index-range */
  for (int j = 0; j <= 2; j++) s += q[j];       /* expect: index-range */
  for (int j = 0; j < 3; j++) b[j + 1] = q[0];  /* expect: index-range */
  for (int j = 2; j >= -1; j--) s += b[j];      /* expect: index-range */
  s += a[k];                                    /* expect: index-range */
  s += v[n];                                    /* expect: index-range */
  s += a[u - 1];                                /* expect: index-range */
  return s;
}
