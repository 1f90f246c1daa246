/* The inputs, written to in roundabout ways. */
/* tlgen: --lagrangian L --dof 2 */
struct p { double k[2]; struct part { double m; } part; int n; };
static void swap(double *a, double *b)
{
  double c = *a;
  *a = *b;
  *b = c;
}
static void put(double **to, double x) { *(*to)++ = x; }
static void deep(double *a) { swap(a, a + 1); }
static void scale(const double *a) { ((double *)a)[0] *= 2; }
double L(double *q, double *qd, double t, struct p *p)
{
  double own[2] = {1.0, 2.0}, *walk = qd, *list[2] = {own, q}, (*row)[1] = (double (*)[1])q;
  struct p *other = p;
  swap(q, own);                 /* expect: write-input */
  deep(qd);                     /* expect: write-input */
  put(&walk, t);                /* expect: write-input */
  list[1][0] = 3.0;             /* expect: write-input */
  *(t > 0 ? own : q) = 3.0;     /* expect: write-input */
  row[0][0] = 1.0;              /* expect: write-input */
  q[0]++;                       /* expect: write-input */
  other->k[1] = 2.0;            /* expect: write-input */
  p->part.m -= 1.0;             /* expect: write-input */
  (*p).n = 2;                   /* expect: write-input */
  *p = *other;                  /* expect: write-input */
  scale(q);                     /* expect: write-input */
  return q[0] + qd[0] + own[0];
}
