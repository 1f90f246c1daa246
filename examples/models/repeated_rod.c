/* Lagrangian and constraints of the rod whose length is demanded several times. */
#include "repeated_rod.h"

double repeated_rod_lagrangian(const double *q, const double *qd, const repeated_rod *p)
{
	return p->mass * (0.5 * (qd[0] * qd[0] + qd[1] * qd[1]) - p->gravity * q[1]);
}

void repeated_rod_lengths(const double *q, const repeated_rod *p, double *out)
{
	for (int i = 0; i < p->rows; i++)
		out[i] = p->scale[i] * (q[0] * q[0] + q[1] * q[1] - p->length * p->length);
}
