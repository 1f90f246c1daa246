/* Functions without a body here: of the C library, of others, and of the compiler. */
#include <errno.h>
#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
double spline(double x);
double j0(double x);
static double noisy(double x) { return x + rand(); } /* expect: unknown-function */
static double printed(double x)
{
  printf("%g\n", x); /* expect: unknown-function unsupported */
  return x;
}
static double checked(double x)
{
  errno = 0; /* expect: unknown-function */
  return sqrt(x);
}
static double rounded(double x)
{
  fesetround(FE_UPWARD); /* expect: unknown-function */
  return 2 * x;
}
static double kept(double x)
{
  double *room = malloc(sizeof *room); /* expect: unknown-function pointer-cast */
  *room = x;
  x = *room;
  free(room); /* expect: unknown-function pointer-cast */
  return x;
}
static double parts(double x)
{
  double n;
  int e;
  x += modf(x, &n); /* expect: unknown-function */
  return frexp(x, &e) + e + n; /* expect: unknown-function */
}
static double bessel(double x) { return j0(x); } /* expect: unknown-function */
static double parsed(double x) { return x * atof("2"); } /* expect: unknown-function unsupported */
double L(const double *q)
{
  if (q[0] > 9) abort(); /* expect: unknown-function */
  return spline(q[0]) + noisy(q[0]) + printed(q[0]) + checked(q[0]) + rounded(q[0]) + kept(q[0]) + /* expect: unknown-function */
         parts(q[0]) + bessel(q[0]) + parsed(q[0]);
}
