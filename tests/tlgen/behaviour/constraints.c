/* A force and constraints of both kinds, with one row and several, returned and through out, some with constants in their rows. */
#include <math.h>

struct linkage { int coordinates, links; double length[2], ratio; };
static const struct linkage params = {4, 2, {1.0, 0.5}, 0.25};

static double square(double x) { return x * x; }

double energy(const struct linkage *p, const double *q, const double *qd)
{
  double T = 0.0;
  for (int i = 0; i < p->coordinates; i++) T += 0.5 * square(qd[i]);
  return T - 9.81 * (q[1] + q[3]);
}

void friction(const double *qd, const struct linkage *p, double *out)
{
  for (int i = 0; i < p->coordinates; i++) out[i] = 0.0;
  out[1] = -0.1 * qd[1];
  for (int i = 2; i < p->coordinates; i++) {
    double speed = sqrt(1.0 + square(qd[i]));
    out[i] -= speed * qd[i];
  }
}

void rods(const double *q, double t, const struct linkage *p, double *out)
{
  const double *from = q;
  out[0] = square(q[0] - 0.1 * t) + square(q[1]) - square(p->length[0]);
  for (int k = 1; k < p->links; k++, from += 2)
    *++out = square(from[2] - from[0]) + square(from[3] - from[1]) - square(p->length[k]);
}

double ground(const double *q) { return q[3] + 0.5; }

void rolling(const double *q, const double *qd, double t, const struct linkage *p, double *out)
{
  out[0] = qd[0] * sin(q[1]) - qd[1] * cos(q[1]);
  out[1] = qd[2] - p->ratio * qd[3] * exp(q[0]);
  out[2] = 0.0;
  out[2] += t * qd[0];
}

double sleigh(const double *q, const double *qd) { return qd[0] * q[2] - q[0] * qd[2]; }
