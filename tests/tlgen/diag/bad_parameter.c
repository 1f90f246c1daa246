/* Parameters to differentiate by are numbers, or arrays of them, of the parameter struct. */
/* tlgen: --lagrangian L --dof 1 --need all --parameter mass,stifness */
struct spring { double mass, stiffness; };
double L(const double *q, const double *qd, const struct spring *p) { /* expect: bad-parameter */
  return 0.5 * (p->mass * qd[0] * qd[0] - p->stiffness * q[0] * q[0]);
}
