/* Lagrangian and constraint of the symmetric top by a quaternion. */
#include "quaternion_top.h"

#include <math.h>

enum { W, X, Y, Z };

void quaternion_top_start(double tilt, double spin, double *q, double *qd)
{
	q[W] = cos(0.5 * tilt), q[X] = sin(0.5 * tilt), q[Y] = q[Z] = 0.0;
	qd[W] = qd[X] = 0.0, qd[Y] = -0.5 * spin * q[X], qd[Z] = 0.5 * spin * q[W];
}

double quaternion_top_upright(const double *q) { return q[W] * q[W] + q[Z] * q[Z] - q[X] * q[X] - q[Y] * q[Y]; }

double quaternion_top_lagrangian(const double *q, const double *qd, const quaternion_top *p)
{
	/* The body's angular velocity, 2 q* qd. */
	const double wx = 2.0 * (q[W] * qd[X] - q[X] * qd[W] - q[Y] * qd[Z] + q[Z] * qd[Y]);
	const double wy = 2.0 * (q[W] * qd[Y] - q[Y] * qd[W] - q[Z] * qd[X] + q[X] * qd[Z]);
	const double wz = 2.0 * (q[W] * qd[Z] - q[Z] * qd[W] - q[X] * qd[Y] + q[Y] * qd[X]);

	return 0.5 * p->across * (wx * wx + wy * wy) + 0.5 * p->along * wz * wz - p->mass * p->gravity * p->height * quaternion_top_upright(q);
}

double quaternion_top_unit(const double *q)
{
	double sum = -1.0;

	for (int i = 0; i < 4; i++)
		sum += q[i] * q[i];
	return sum;
}
