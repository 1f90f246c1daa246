/* Lagrangian, drives and no-slip conditions of the snakeboard. */
#include "snakeboard.h"

#include <math.h>

enum { X, Y, HEADING, ROTOR, BACK, FRONT };

double snakeboard_lagrangian(const double *q, const double *qd, const snakeboard *p)
{
	const double rotor = qd[HEADING] + qd[ROTOR], back = qd[HEADING] + qd[BACK], front = qd[HEADING] + qd[FRONT];
	const double turning = p->board * qd[HEADING] * qd[HEADING] + p->rotor * rotor * rotor + p->axle * (back * back + front * front);

	(void)q;
	return 0.5 * p->mass * (qd[X] * qd[X] + qd[Y] * qd[Y]) + 0.5 * turning;
}

void snakeboard_drives(const double *q, double t, const snakeboard *p, double *out)
{
	const double s = sin(p->rate * t);

	out[0] = q[ROTOR] - p->rotor_swing * s;
	out[1] = q[BACK] + p->steering * s;
	out[2] = q[FRONT] - p->steering * s;
}

/* Velocity along the axle at the distance ahead of the middle, steered by an angle. */
static double slip(const double *q, const double *qd, double steered, double ahead)
{
	const double angle = q[HEADING] + steered;

	return qd[Y] * cos(angle) - qd[X] * sin(angle) + ahead * qd[HEADING] * cos(steered);
}

void snakeboard_slips(const double *q, const double *qd, const snakeboard *p, double *out)
{
	out[0] = slip(q, qd, q[BACK], -p->half_length);
	out[1] = slip(q, qd, q[FRONT], p->half_length);
}
