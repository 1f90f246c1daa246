/* tlgen: --lagrangian L */ /* expect without a line: no-dof */
double L(const double *q) { return q[0]; }
