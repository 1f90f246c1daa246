/* The model may not write to what it is given, nor keep values that depend on q there. */
struct p { double k, last[2]; double *store; };
static void keep(struct p *p, double x) { p->k = x; } /* expect: struct-active */
static void fill(double *a, double x) { a[0] = x; }
double L(double *q, double *qd, double t, struct p *p)
{
  q[0] += 1.0;          /* expect: write-input */
  *qd = 0.0;            /* expect: write-input */
  p->k = 2.0;           /* expect: write-input */
  p->last[0] = q[0];    /* expect: write-input active-params */
  p->store[1] = t;      /* expect: write-input active-params */
  keep(p, q[0]);        /* expect: write-input active-params */
  fill(q, 1.0);         /* expect: write-input */
  fill(p->store, t);    /* expect: write-input active-params */
  return q[0] + (t += 1.0);
}
