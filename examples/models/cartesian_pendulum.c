/* Lagrangian and rod constraints of the N-pendulum in Cartesian coordinates. */
#include "cartesian_pendulum.h"

double cartesian_pendulum_lagrangian(const double *q, const double *qd, const cartesian_pendulum *p)
{
	double sum = 0.0;
	int k = p->links;

	while (k-- > 0) {
		const double *v = &qd[2 * k];

		sum += p->mass[k] * (0.5 * (v[0] * v[0] + v[1] * v[1]) - p->g * q[2 * k + 1]);
	}
	return sum;
}

void cartesian_pendulum_rods(const double *q, const cartesian_pendulum *p, double *out)
{
	double x0 = 0.0, y0 = 0.0;
	int k;

	for (k = 0; k < p->links; ++k) {
		const double x = q[2 * k], y = q[2 * k + 1];
		const double dx = x - x0, dy = y - y0;

		out[k] = dx * dx + dy * dy - p->length[k] * p->length[k];
		x0 = x;
		y0 = y;
	}
}
