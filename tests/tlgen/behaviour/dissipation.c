/* Rayleigh's dissipation through out, not quadratic, with q, t and a loop; a force of time alone. */
#include <math.h>

typedef struct { int n; double mass, viscosity[3], dry, slow; } losses_t;
static const losses_t params = {3, 1.5, {0.2, 0.3, 0.1}, 0.7, 0.05};

double energy(const double *q, const double *qd, const losses_t *p)
{
  double sum = 0.0;
  for (int i = 0; i < p->n; i++) sum += 0.5 * (p->mass + i + 0.2 * cos(q[i])) * qd[i] * qd[i] - sin(q[i]);
  return sum;
}

/* Viscous, smoothed dry, and turbulent friction of the first coordinate that grows with time. */
void losses(const losses_t *p, const double *q, const double *qd, double t, double *out)
{
  double loss = 0.0;
  for (int i = 0; i < p->n; i++) {
    const double slip = i ? qd[i] - qd[i - 1] : qd[i];
    loss += 0.5 * p->viscosity[i] * (1.0 + q[i] * q[i]) * slip * slip;
    loss += p->dry * sqrt(slip * slip + p->slow * p->slow);
  }
  out[0] = loss + (1.0 + 0.1 * t) * pow(fabs(qd[0]), 3.0) / 3.0;
}

void drive(double t, const losses_t *p, double *out) { out[1] = p->dry * cos(2.0 * t); }

double closure(const double *q) { return q[0] * q[0] + q[1] - 0.3; }
