/* Lagrangian and rolling conditions of the thin disk. */
#include "rolling_disk.h"

#include <math.h>

enum { X, Y, YAW, LEAN, SPIN };

double rolling_disk_lagrangian(const double *q, const double *qd, const rolling_disk *p)
{
	const double c = cos(q[LEAN]), s = sin(q[LEAN]), r = p->radius;
	/* Velocity of the centre ahead, to the left and up, with the contact's velocity turned into these directions. */
	const double ahead = qd[X] * cos(q[YAW]) + qd[Y] * sin(q[YAW]) + r * s * qd[YAW];
	const double left = qd[Y] * cos(q[YAW]) - qd[X] * sin(q[YAW]) - r * c * qd[LEAN];
	const double up = -r * s * qd[LEAN];
	const double diameter = 0.25 * p->mass * r * r, axle = 2.0 * diameter; /* moments of inertia */
	const double about_axle = qd[SPIN] + qd[YAW] * s, upright = qd[YAW] * c;

	return 0.5 * p->mass * (ahead * ahead + left * left + up * up) + 0.5 * diameter * (qd[LEAN] * qd[LEAN] + upright * upright)
		+ 0.5 * axle * about_axle * about_axle - p->mass * p->gravity * r * c;
}

void rolling_disk_slip(const double *q, const double *qd, const rolling_disk *p, double *out)
{
	out[0] = qd[X] - p->radius * qd[SPIN] * cos(q[YAW]);
	out[1] = qd[Y] - p->radius * qd[SPIN] * sin(q[YAW]);
}
