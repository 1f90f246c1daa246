/* Writes to the parameters by a way that the caller does not see: through helpers, copies of structs, and pointers that a helper sets. */
struct inner { double *c; };
struct par { double *c; int *n, **rows; struct inner in[2]; };
struct two { const struct par *p; };
struct outer { struct inner w; };
static void set(const struct par *p) { p->c[0] = 2.0; }
static void count(const struct par *p) { ++*p->n; }
static void deep(const struct par *p) { p->rows[0][1] = 2; }
static void carried(struct two w) { w.p->c[0] = 3.0; }
static void found(double **o, const struct par *p) { *o = p->c; }
double L(const double *q, const double *qd, const struct par *p)
{
  struct outer o = {{p->c}}, o2 = o;
  struct inner copy[2] = {p->in[0], p->in[1]};
  double *c;
  set(p);                       /* expect: write-input */
  count(p);                     /* expect: write-input */
  deep(p);                      /* expect: write-input */
  carried((struct two){p});     /* expect: write-input */
  found(&c, p);
  c[0] = 1.0;                   /* expect: write-input */
  o2.w.c[0] = 2.0;              /* expect: write-input */
  copy[1].c[0] = 2.0;           /* expect: write-input */
  return q[0] * qd[0];
}
