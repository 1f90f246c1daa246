/* Structs of numbers that depend on q: no pointers in them, and none to their integers. */
struct mixed { int n, list[2]; double x; };
struct linked { double x; const double *more; };
static double value(struct mixed m) { return m.x * m.n; }
static void count(int *n) { ++*n; }
static int first(const int *list) { return list[0]; }
static double more(struct linked m) { return m.x * m.more[0]; } /* expect: struct-active */
double L(const double *q)
{
  static const double table[] = {1.0};
  struct mixed m = {2, {0, 1}, q[0]};
  struct linked k = {q[0], table}; /* expect: struct-active */
  count(&m.n);                     /* expect: struct-active */
  int *p = m.list;                 /* expect: struct-active */
  return value(m) + first(m.list) + p[0] + more(k); /* expect: struct-active */
}
