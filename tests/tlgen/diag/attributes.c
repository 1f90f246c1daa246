/* Attributes that change what a declaration means. */
double base(double x) { return x * x; }
double other_name(double x) __attribute__((alias("base")));
__attribute__((weak)) double replaceable(double x) { return x; } /* expect: attribute */
static void wipe(double *x) { *x = 0.0; }
static void wipe_there(double **x) { **x = 0.0; }
static double cleaned(double x)
{
  double s = x;
  {
    __attribute__((cleanup(wipe_there))) double *p = &s; /* expect: attribute */
    *p *= 2;
  }
  return s;
}
static double cleaned_too(double x)
{
  __attribute__((cleanup(wipe))) double y = x; /* expect: attribute */
  return y;
}
double L(const double *q)
{
  return other_name(q[0]) + replaceable(q[0]) + cleaned(q[0]) + cleaned_too(q[0]); /* expect: unknown-function */
}
