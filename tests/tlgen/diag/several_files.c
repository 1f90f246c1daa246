/* tlgen: --lagrangian L --dof 1 HERE:parts/other.c */
/* Two files that are not of one program. */
double helper(double x);
double shape(double x);
static double own(double x) { return 2.0 * x; }
double stretch(double x) { return 3.0 * x; }
double L(const double *q) { return helper(q[0]) + own(q[0]) + stretch(q[0]) + /* expect: declaration-differs */
                                   shape(q[0]); }
