/* Pointers that leave their array by constants. */
/* tlgen: --lagrangian L --dof 2 */
struct node { double m; };
double L(const double *q)
{
  double a[2] = {q[0], q[1]}, x = q[0], s = 0.0;
  struct node list[2] = {{q[0]}, {q[1]}};
  const double *p = q + 3, *b = q;
  s += *p;             /* expect: index-range */
  b--;
  s += *b;             /* expect: index-range */
  s += *(a + 3);       /* expect: index-range */
  s += (&a[1])[1];     /* expect: index-range */
  s += (&x)[1];        /* expect: index-range */
  s += (list + 2)->m;  /* expect: index-range */
  return s;
}
