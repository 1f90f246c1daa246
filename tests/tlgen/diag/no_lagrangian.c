/* tlgen: --dof 1 */ /* expect without a line: no-lagrangian */
double L(const double *q) { return q[0]; }
