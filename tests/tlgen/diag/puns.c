/* The bytes of a number seen as something else. */
#include <stdint.h>
struct pair { double a, b; };
struct two { double x[2]; };
union view { double d; uint64_t bits; };
struct hidden { union { double d; uint64_t bits; } u; };
static double sign(union view v) /* expect: union */
{
  v.bits ^= (uint64_t)1 << 63;
  return v.d;
}
static double member(double x)
{
  struct hidden h; /* expect: union */
  h.u.d = x; /* expect: union */
  return h.u.bits * 1.0; /* expect: union */
}
static double fast_inverse(double x)
{
  long long i = *(long long *)&x; /* expect: pointer-cast */
  i = 0x5fe6eb50c7b537a9 - (i >> 1);
  return *(double *)&i; /* expect: pointer-cast */
}
static double as_struct(const double *q) { return ((const struct pair *)q)->b; } /* expect: pointer-cast */
static double as_other_struct(struct pair p) { return ((struct two *)&p)->x[1]; } /* expect: pointer-cast */
static float as_float(const double *q) { return *(const float *)q; } /* expect: pointer-cast */
static int parity(const double *q) { return (int)((intptr_t)&q[1] & 8); } /* expect: pointer-cast */
double L(const double *q)
{
  union view v = {q[0]}; /* expect: union */
  struct pair p = {q[0], 1.0};
  return sign(v) + member(q[0]) + fast_inverse(q[0]) + as_struct(q) + as_other_struct(p) + as_float(q) + parity(q);
}
