/* tlgen: --lagrangian L --dof 0 */ /* expect without a line: bad-dof */
double L(const double *q) { return q[0]; }
