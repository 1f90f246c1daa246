/* volatile by a cast. */
static double latest(const double *x) { return *(const volatile double *)x; } /* expect: volatile */
double L(const double *q)
{
  double a[2] = {q[0], 1.0};
  ((volatile double *)a)[1] = 2.0; /* expect: volatile */
  volatile double *p = a;          /* expect: volatile */
  return latest(q) + a[1] + *p;
}
