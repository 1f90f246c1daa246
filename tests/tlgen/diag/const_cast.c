/* Constants, written to behind their backs. */
static const double table[2] = {1.0, 2.0};
struct p { double k; };
static void reset(double *x) { *x = 0.0; }
double L(const double *q, const double *qd, const struct p *p)
{
  static const double local[2] = {1.0, 2.0};
  double *w = (double *)table;
  ((double *)q)[0] = 2.0;       /* expect: write-input */
  *(double *)&local[1] += 1.0;  /* expect: write-input */
  w[1] = 3.0;                   /* expect: write-input */
  reset((double *)qd);          /* expect: write-input */
  ((double *)table)[0] = q[0];  /* expect: write-input active-params */
  *(double *)&p->k = 1.0;       /* expect: write-input */
  return table[0] * q[0] * local[0];
}
