/* Two parameters with one role. */
/* tlgen: --lagrangian L --dof 1 --arg q=x */
double L(const double *q, const double *x) { return q[0] * x[0]; } /* expect: role-twice */
