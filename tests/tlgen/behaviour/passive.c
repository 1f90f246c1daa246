/* A model with functions that do not depend on anything, or not on what they take. */
#include <math.h>

struct size { int n; double k; };
static const struct size params = {1, 2.0};

static double constant(const struct size *p) { return p->k * 3.0; }

double lagrangian(const double *q, const struct size *p) { (void)q; return constant(p); }
void push(const double *q, const double *qd, double *out) { (void)q; (void)qd; out[0] = 4.0; }
void fixed(const double *q, double *out) { out[0] = 0.5; out[1] = q[0]; out[1] = 1.0; }
double zero(const double *qd) { return 0 * qd[0]; }
