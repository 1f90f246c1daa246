/* tlgen: --lagrangian L --dof 1 */
#define MARK(role) __attribute__((annotate("tlgen:" #role)))
double L(const double *q) { return q[0]; }
MARK(lagrangian) double K(const double *q) { return q[0] * 2.0; } /* expect: role-twice */
MARK(energy) double H(const double *q) { return q[0] * 2.0; }     /* expect: role-unknown */
