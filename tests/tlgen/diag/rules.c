/* tlgen: --lagrangian L --dof 1 --rule state:state_taylor --rule many:many_taylor --rule name:name_taylor --rule sum:sum_taylor */
/* Rules for functions of other types than numbers. */
double state(double x, double *y);
double many(double a, double b, double c, double d, double e);
double name(double x, int n);
float sum(float x);
double L(const double *q)
{
  double y = 1.0;
  return state(q[0], &y) +               /* expect: rule-type */
         many(q[0], 1.0, 2.0, 3.0, 4.0) + /* expect: rule-type */
         name(q[0], 2) +                 /* expect: rule-type */
         (double)sum((float)q[0]);       /* expect: rule-type */
}
