/* Literals as C means them: characters with a sign, wide characters, floats from integers, lengths of variable arrays. */
#include <stddef.h>
static void twice(double *x) { *x *= 2.0; }
static void handed_on(double *x) { return twice(x); }
static void cast_away(double *x) { return (void)(*x += 1.0); }

double lagrangian(const double *q, const double *qd)
{
  double s = q[0] * '\xff' + q[1] * ('\xff' < 0 ? 1.0 : 3.0) + '\377' * qd[0] * qd[1], x = q[0] * q[1];
  wchar_t wide = L'\x3b1';
  s += wide * q[0] * 1e-3 + 'a' * q[1];

  int n = 3;
  double a[n];
  for (size_t i = 0; i < sizeof a / sizeof a[0]; i++) a[i] = q[0] * (double)i;
  s += a[2] * (double)(sizeof a / sizeof *a) * q[1];

  int k = 5;
  k *= 1.5;
  char c = 100;
  c += 100;
  short h = 5;
  h <<= 2;
  unsigned char u = 250;
  u += 10;
  float f = 0.5f;
  f += 0.25;
  f *= k;
  s += q[0] * q[0] * k + c * q[1] + h * qd[0] + u * q[0] * q[1] + f * qd[1] * qd[1];
  if (k * h) s *= 2.0;
  _Bool b = 0;
  b++;
  s += b * q[0];
  switch (q[0] > 0.0) {
  case 0: s += q[1]; break;
  default: s += q[0] * q[1];
  }
  handed_on(&x);
  cast_away(&x);
  return s * x;
}
