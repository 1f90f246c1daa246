/* Constructs of GNU C that have no rule. */
typedef double pair __attribute__((vector_size(16)));
struct flags { unsigned fixed : 1; double m; };
struct open { int n; double x[]; };
static double vector(double x)
{
  pair v = {x, 1.0}; /* expect: type */
  return v[0];
}
static double chosen(double x) { return __builtin_choose_expr(1, x, 2.0); } /* expect: unsupported */
static double generic(double x) { return _Generic(x, double: x, default: 0.0); } /* expect: unsupported */
static double elvis(double x) { return x ?: 1.0; } /* expect: unsupported */
static double extended(double x) { return __extension__ x; } /* expect: unsupported */
static double bits(double x)
{
  struct flags f = {1, x}; /* expect: type */
  return f.m;
}
static double open_end(const struct open *o) { return o->x[0]; } /* expect: type */
double L(const double *q)
{
  return vector(q[0]) + chosen(q[0]) + generic(q[0]) + elvis(q[0]) + extended(q[0])
         + bits(q[0]) + open_end(0);
}
