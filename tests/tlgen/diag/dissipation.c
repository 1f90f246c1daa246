/* Dissipation is one number of the velocities. */
/* tlgen: --lagrangian L --dof 1 --dissipation D */
#define MARK(role) __attribute__((annotate("tlgen:" #role)))
double L(const double *q, const double *qd) { return qd[0] * qd[0] - q[0]; }
double D(const double *q, double t) { return q[0] * t; }                                  /* expect: role-missing */
MARK(dissipation) double E(const double *qd) { return qd[0] * qd[0]; }                    /* expect: role-twice */
