/* Each parameter's role must be clear, be there once, and fit the type. */
/* tlgen: --lagrangian L --force F --holonomic phi --holonomic chi --nonholonomic psi --dof 1 */
double L(const double *q, const double *x) { return q[0] * x[0]; }                /* expect: role-unknown */
void F(const float *q, const double *qd, double *out) { out[0] = q[0] + qd[0]; }  /* expect: role-type */
double phi(const double *q, const double *qd) { return q[0] + qd[0]; }            /* expect: role-missing */
int chi(const double *q) { return q[0] > 0.0; }                                   /* expect: role-missing */
double psi(double t) { return t; }                                                /* expect: role-missing */
