/* Structs with members that stand elsewhere than their types say. */
typedef double wide __attribute__((aligned(16)));
struct par { double a; wide b; };
#pragma pack(push, 1)
struct tight { char c; double x; };
#pragma pack(pop)
static double packed(const struct tight *s) { return s->x; } /* expect: attribute */
double L(const double *q, const struct par *p) /* expect: attribute */
{
  static const struct tight s = {'a', 1.0}; /* expect: attribute */
  return q[0] * p->b + packed(&s);
}
