/* Lagrangian and no-slip condition of Chaplygin's sleigh. */
#include "chaplygin_sleigh.h"

#include <math.h>

enum { X, Y, HEADING };

double chaplygin_sleigh_lagrangian(const double *q, const double *qd, const chaplygin_sleigh *p)
{
	const double swing = p->ahead * qd[HEADING];
	const double vx = qd[X] - swing * sin(q[HEADING]), vy = qd[Y] + swing * cos(q[HEADING]);

	return 0.5 * p->mass * (vx * vx + vy * vy) + 0.5 * p->inertia * qd[HEADING] * qd[HEADING];
}

double chaplygin_sleigh_slip(const double *q, const double *qd) { return qd[Y] * cos(q[HEADING]) - qd[X] * sin(q[HEADING]); }
