/* Lagrangian and rods of N four-bar linkages side by side. */
#include "four_bars.h"

four_bars four_bars_parameters(int loops)
{
	const four_bars p = {.loops = loops, .coordinates = 2 * (loops + 1), .rods = 2 * loops + 1, .length = 1.0, .mass = 1.0, .g = 9.81};
	return p;
}

void four_bars_start(const four_bars *p, double *q, double *qd)
{
	for (int i = 0; i <= p->loops; i++) {
		q[2 * i] = i * p->length, q[2 * i + 1] = p->length;
		qd[2 * i] = 1.0, qd[2 * i + 1] = 0.0;
	}
}

static double dot(const double *a, const double *b)
{
	return a[0] * b[0] + a[1] * b[1];
}

/* A uniform rod whose ends have velocities u and v has m (u.u + u.v + v.v)/6. */
double four_bars_lagrangian(const double *q, const double *qd, const four_bars *p)
{
	double twice = 0.0, heights = 0.0;

	for (int i = 0; i <= p->loops; i++) {
		twice += dot(&qd[2 * i], &qd[2 * i]);
		heights += 0.5 * q[2 * i + 1];
	}
	for (int i = 0; i < p->loops; i++) {
		const double *u = &qd[2 * i], *v = &qd[2 * i + 2];

		twice += dot(u, u) + dot(u, v) + dot(v, v);
		heights += 0.5 * (q[2 * i + 1] + q[2 * i + 3]);
	}
	return p->mass * (twice / 6.0 - p->g * heights);
}

void four_bars_rods(const double *q, const four_bars *p, double *out)
{
	const double square = p->length * p->length;

	for (int i = 0; i <= p->loops; i++) {
		const double rod[2] = {q[2 * i] - i * p->length, q[2 * i + 1]};

		out[i] = dot(rod, rod) - square;
	}
	for (int i = 0; i < p->loops; i++) {
		const double rod[2] = {q[2 * i + 2] - q[2 * i], q[2 * i + 3] - q[2 * i + 1]};

		out[p->loops + 1 + i] = dot(rod, rod) - square;
	}
}
