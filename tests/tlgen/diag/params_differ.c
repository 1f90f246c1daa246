/* tlgen: --lagrangian L --force F --dof 1 */
struct a { double m; };
struct b { double k; };
double L(const double *q, const struct a *p) { return q[0] * p->m; }
void F(const double *q, const struct b *p, double *out) { out[0] = q[0] * p->k; } /* expect: params-differ */
