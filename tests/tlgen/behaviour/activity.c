/* The same helper with constants and with coordinates, results that are constant though arguments are not, and the reverse. */
#include <math.h>

struct constants { int n; double k[3]; const double *table; };
static const double table[] = {0.5, 1.5, -1.0};
static const struct constants params = {2, {1.0, 2.0, 3.0}, table};

static double dot(const double *a, const double *b, int n)
{
  double s = 0.0;
  for (int i = 0; i < n; i++) s += a[i] * b[i];
  return s;
}

static double cube(double x) { return x * x * x; }
static double first(double x, double y) { (void)y; return x; }
static int sign(double x) { return (x > 0.0) - (x < 0.0); }
static double threshold(double x) { return x > 0.25 ? 1.0 : -0.5; }
static void store(double x, double *y) { *y = x; }
static void store_all(double *to, const double *from, int n) { for (int i = 0; i < n; i++) store(from[i], &to[i]); }
static double nothing(void) { return 0.25; }
static double both(const double *a, const double *b, double *out)
{
  *out = a[0] + b[1];
  return b[0];
}

double lagrangian(const double *q, const double *qd, double t, const struct constants *p)
{
  double a = dot(p->k, p->table, 3), b = dot(q, p->k, p->n), c = dot(p->k, qd, p->n), d = dot(q, qd, p->n);
  double late = 1.0, early = 0.0, work[3], other[3], L, kept;
  double k = 0.0;

  L = a * b + c * d + cube(a) * cube(b) + cube(2.0);
  for (int i = 0; i < 3; i++) {
    L += early * qd[0]; /* depends on q from the second round on */
    early = late * q[0];
    late = t;
  }
  store(2.0, &k);
  L += k * t;
  store_all(work, p->table, 3);
  L += work[1] * q[1];
  store_all(other, p->table, 3);
  store(q[0], &other[1]);
  L += dot(other, work, 3) + dot(other, other, 2);
  L += first(q[0], 2.0) * first(2.0, q[0]) + first(3.0, 4.0) + sign(q[1]) * t + threshold(qd[0]) * q[0] + nothing() * t;
  L += both(q, p->k, &kept);
  L *= kept;
  L += both(p->k, p->table, &kept);
  L -= sign(q[0]) > 0 ? threshold(t) : cube(threshold(q[1]));
  L += kept + (double)sign(-0.5) + (q[0] > q[1]) * q[1];
  return L;
}
