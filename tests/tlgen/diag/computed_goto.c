/* A jump to an address, in GNU C. */
double L(const double *q)
{
  void *places[2] = {&&first, &&second}; /* expect: goto type */
  goto *places[q[0] > 0];                /* expect: goto */
first:
  return q[0];
second:
  return 2 * q[0];
}
