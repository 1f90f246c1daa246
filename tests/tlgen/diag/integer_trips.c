/* Numbers that depend on q and go through an integer on their way. */
enum side { LEFT, RIGHT };
struct cell { int column; };
static double fixed_point(double x) { return (double)(long)(x * 1e6) * 1e-6; } /* expect: active-integer */
static double half(int n) { return 0.5 * n; }
static int whole(double x) { return x; } /* expect: active-integer */
static void split(double x, int *n) { *n = (int)x; } /* expect: active-integer */
static double in_enum(double x)
{
  enum side s = x; /* expect: active-integer */
  return s;
}
static double in_array(double x)
{
  short table[2] = {x, 1}; /* expect: active-integer */
  return table[0];
}
static double in_struct(double x)
{
  struct cell c = {x}; /* expect: active-integer */
  c.column = 3 * x;    /* expect: active-integer */
  return c.column;
}
static double assigned(double x)
{
  int n = 0;
  return (n = x) + 1; /* expect: active-integer */
}
static double counted(double x)
{
  unsigned char n = 3;
  n *= x;        /* expect: active-integer */
  n -= x;        /* expect: active-integer */
  _Bool b = 0;
  b += x; /* warns: active-equality */
  return n + b;
}
static double selected(double x)
{
  switch ((int)x) { /* expect: active-integer */
  case 1: return 2 * x;
  }
  return x;
}
static double walked(const double *a, double x) { return *(a + (long)x); } /* expect: active-integer */
static double repeated(double x)
{
  double s = 0;
  for (int i = 0; i < (int)x; i++) s += x; /* expect: active-integer */
  return s;
}
double L(const double *q, double t)
{
  int n;
  split(q[0], &n);
  return fixed_point(q[0]) + half(q[0]) + whole(q[0]) + n + in_enum(q[0]) + in_array(q[0]) + /* expect: active-integer */
         in_struct(q[0]) + assigned(q[0]) + counted(t) + selected(q[0]) + walked(q, t) + repeated(q[0]);
}
