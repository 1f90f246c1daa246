/* Complex numbers, whole and in parts. */
#include <complex.h>
typedef double complex wave;
static wave turn(wave z, double x) { return z * cexp(I * x); } /* expect: complex unknown-function unsupported */
static double part(double x) { return __real__ x + __imag__ x; } /* expect: complex */
static double length(double x, double y) { return cabs(x + I * y); } /* expect: complex unknown-function unsupported */
struct state { float _Complex z; };
static double member(double x)
{
  struct state s; /* expect: complex */
  s.z = x;        /* expect: complex unsupported */
  return crealf(s.z); /* expect: complex unknown-function */
}
double L(const double *q)
{
  double complex z[2] = {q[0], I}; /* expect: complex unsupported */
  return creal(turn(z[0], q[0])) + part(q[0]) + length(q[0], 1.0) + member(q[0]); /* expect: complex unknown-function */
}
