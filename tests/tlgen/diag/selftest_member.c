/* Parameters that no command line of a test program could tell it. */
/* tlgen: --lagrangian L --dof 1 --selftest */
struct link { double length; };
struct chain { /* expect: selftest-member */
  int n;
  const struct link *link;
};
double L(const double *q, const double *qd, const struct chain *p)
{
  double s = 0.0;
  for (int i = 0; i < p->n; i++) s += p->link[i].length * qd[0];
  return s - q[0];
}
