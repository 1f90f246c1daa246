/* Lagrangian and rods of a slider-crank. */
#include "slider_crank.h"

double slider_crank_lagrangian(const double *q, const double *qd, const slider_crank *p)
{
	(void)q;
	return 0.5 * p->pin_mass * (qd[0] * qd[0] + qd[1] * qd[1]) + 0.5 * p->slider_mass * qd[2] * qd[2];
}

void slider_crank_rods(const double *q, const slider_crank *p, double *out)
{
	const double along = q[2] - q[0];

	out[0] = q[0] * q[0] + q[1] * q[1] - p->crank * p->crank;
	out[1] = along * along + q[1] * q[1] - p->rod * p->rod;
}
