/* tlgen: --lagrangian L --dof n */ /* expect without a line: bad-dof */
struct p { double n; };
double L(const double *q, const struct p *p) { return q[0] * p->n; }
