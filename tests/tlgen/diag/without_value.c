/* Variables that are read before they have a value, of every kind. */
static double selfish(double y)
{
  double x = x; /* expect: uninitialized */
  return x * y;
}
static double index(const double *a)
{
  int i;
  return a[i]; /* expect: uninitialized */
}
static double pointer(double x)
{
  double *p;
  return *p * x; /* expect: uninitialized */
}
static double jumped(double y)
{
  double x;
  goto end;
  x = 3.0;
end:
  return x * y; /* expect: uninitialized */
}
static double counter(double y)
{
  int n;
  while (n-- > 0) y *= 2; /* expect: uninitialized */
  return y;
}
static double sum(double y)
{
  double s;
  for (int i = 0; i < 3; i++) s += y; /* expect: uninitialized */
  return s;
}
static double length(double y)
{
  int n;
  double a[n]; /* expect: uninitialized */
  a[0] = y;
  return a[0];
}
double L(const double *q)
{
  return selfish(q[0]) + index(q) + pointer(q[0]) + jumped(q[0]) + counter(q[0]) + sum(q[0]) + length(q[0]);
}
