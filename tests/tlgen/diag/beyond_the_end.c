/* Constant indices that leave their array: of structs, rows, members, parameters and tables. */
struct node { double x[2], m; };
static const double table[3] = {1.0, 2.0, 3.0};
static double sum(const double a[static 3]) { return a[0] + a[1] + a[2]; }
double L(const double *q)
{
  struct node n = {{q[0], 1.0}, 2.0}, list[2] = {{{q[0]}}};
  double m[2][3] = {{q[0]}}, v[2] = {q[0]}, s = 0.0;
  s += n.x[2];        /* expect: index-range */
  s += list[2].m;     /* expect: index-range */
  s += list[1].x[-1]; /* expect: index-range */
  s += m[0][3];       /* expect: index-range */
  s += m[2][0];       /* expect: index-range */
  m[1][-2] = 1.0;     /* expect: index-range */
  s += table[3];      /* expect: index-range */
  s += (-1)[table];   /* expect: index-range */
  s += sum(v);        /* expect: index-range */
  return s;
}
