/* Declared lengths that are not those of the model. */
/* tlgen: --lagrangian L --dof 2 --holonomic phi:2 */
double L(const double *q, const double qd[3]) { return qd[1] * q[0]; } /* expect: index-range */
void phi(const double q[2], double out[1]) { out[0] = q[0]; }          /* expect: index-range */
