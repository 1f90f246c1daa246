/* Changes of one object without an order between them. */
double L(const double *q)
{
  double a[3] = {q[0], 1.0, 2.0}, x = q[0];
  int i = 0;
  a[i] = i++ + q[0];             /* expect: unsequenced */
  i = i++ + 1;                   /* expect: unsequenced */
  x = x * x + (x = 3.0, x) * 2;  /* expect: unsequenced */
  x = a[i--] - a[i];             /* expect: unsequenced */
  return a[0] + x;
}
