/* A nonholonomic constraint without velocities. */
/* tlgen: --lagrangian L --dof 1 --nonholonomic psi */
double L(const double *q) { return q[0]; }
double psi(const double *q) { return q[0]; } /* expect: role-missing */
