/* Derivatives that would be lost in an integer. */
static int cell(double x) { return (int)(x * 4.0); } /* expect: active-integer */
static double pick(int i) { return i * 0.5; }
double L(const double *q, double t)
{
  int n = t;              /* expect: active-integer */
  unsigned char c;
  long sum = 0;
  c = q[0] * 8.0;         /* expect: active-integer */
  sum += q[0];            /* expect: active-integer */
  n += pick(q[0]);        /* expect: active-integer */
  double a[4] = {0.0};
  a[(int)q[0]] += 1.0;    /* expect: active-integer */
  return n + c + sum + cell(q[0]) + (long long)t + a[0]; /* expect: active-integer */
}
