/* tlgen: --lagrangian L --dof 1 --holonomic phi:-2 */ /* expect without a line: bad-rows */
double L(const double *q) { return q[0]; }
void phi(const double *q, double *out) { out[0] = q[0]; }
