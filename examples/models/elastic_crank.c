/* Lagrangian and constraints of the slider crank with an elastic rod. */
#include "elastic_crank.h"

#include <math.h>

enum { CRANK, ROD, BLOCK, ACROSS1, ACROSS2, MIDDLE, END };

elastic_crank elastic_crank_parameters(void)
{
	const elastic_crank p = {.m2 = 0.151104, .m3 = 0.075552, .j1 = 0.002727, .j2 = 0.0045339259, .l1 = 0.15, .l2 = 0.30,
		.width = 0.008, .height = 0.008, .density = 7870.0, .modulus = 0.2e12, .pi = 3.1415927, .omega = 150.0};
	return p;
}

void elastic_crank_start(double *q, double *qd)
{
	const elastic_crank p = elastic_crank_parameters();

	q[CRANK] = q[ROD] = q[ACROSS1] = q[ACROSS2] = 0.0;
	q[MIDDLE] = 0.103339863e-4;
	q[END] = 0.169327969e-4;
	q[BLOCK] = p.l1 + p.l2 + q[END];
	qd[CRANK] = p.omega;
	qd[ROD] = -p.l1 * p.omega / (p.l2 + q[END]);
	qd[ACROSS1] = 0.444896105;
	qd[ACROSS2] = 0.463434311e-2;
	qd[MIDDLE] = -0.178591076e-5;
	qd[END] = qd[BLOCK] = -0.268938672e-5;
}

/* Integrals over the undeformed rod, of its displacement along (u) and across (w); v is a vector of q1..q4 or of their rates. */
static double mean_along(const double *v) { return 2.0 / 3.0 * v[2] + v[3] / 6.0; }
static double mean_across(const double *v, const elastic_crank *p) { return 2.0 / p->pi * v[0]; }
static double moment_along(const double *v) { return v[2] / 3.0 + v[3] / 6.0; }
static double moment_across(const double *v, const elastic_crank *p) { return (v[0] - 0.5 * v[1]) / p->pi; }

/* The mass matrix of the deformation, between two vectors; the numbers along are those of the Test Set. */
static double inertia(const double *v, const double *w)
{
	return 0.5 * (v[0] * w[0] + v[1] * w[1]) + 8.0 * v[2] * w[2] + v[2] * w[3] + v[3] * w[2] + 2.0 * v[3] * w[3];
}

/* Turning of the deformed rod by a deformation that changes: integral of u w' - w u'. */
static double swirl(const double *v, const double *rate, const elastic_crank *p)
{
	const double cube = p->pi * p->pi * p->pi, middle = 16.0 / cube, end = 8.0 / cube - 1.0 / p->pi, second = 0.5 / p->pi;

	return middle * (v[2] * rate[0] - v[0] * rate[2]) + end * (v[0] * rate[3] - v[3] * rate[0]) + second * (v[1] * rate[3] - v[3] * rate[1]);
}

static double bending_and_stretching(const double *v, const elastic_crank *p)
{
	const double stiffness = p->modulus * p->width * p->height / p->l2;
	const double slender = p->pi * p->pi * p->height / p->l2;
	const double bending = slender * slender * (v[0] * v[0] / 24.0 + v[1] * v[1] * 2.0 / 3.0);
	const double stretching = (16.0 * v[2] * v[2] - 16.0 * v[2] * v[3] + 7.0 * v[3] * v[3]) / 3.0;

	return 0.5 * stiffness * (bending + stretching);
}

double elastic_crank_lagrangian(const double *q, const double *qd, const elastic_crank *p)
{
	const double *v = &q[ACROSS1], *rate = &qd[ACROSS1];
	const double mass = p->density * p->width * p->height * p->l2;
	const double s = sin(q[CRANK] - q[ROD]), c = cos(q[CRANK] - q[ROD]);
	const double carried = qd[ROD] * (s * mean_across(v, p) + c * mean_along(v)) + c * mean_across(rate, p) - s * mean_along(rate);
	const double crank = 0.5 * (p->j1 + p->m2 * p->l1 * p->l1) * qd[CRANK] * qd[CRANK];
	const double rod = 0.5 * p->j2 * qd[ROD] * qd[ROD] + 0.5 * p->l1 * p->l2 * p->m2 * c * qd[CRANK] * qd[ROD];
	const double turning = 0.5 * inertia(v, v) + p->l2 * moment_along(v);
	const double relative = 0.5 * inertia(rate, rate) + qd[ROD] * (p->l2 * moment_across(rate, p) + swirl(v, rate, p));
	const double T = crank + rod + 0.5 * p->m3 * qd[BLOCK] * qd[BLOCK]
		+ mass * (p->l1 * qd[CRANK] * carried + turning * qd[ROD] * qd[ROD] + relative);

	return T - bending_and_stretching(v, p);
}

void elastic_crank_loops(const double *q, double t, const elastic_crank *p, double *out)
{
	const double length = p->l2 + q[END];

	out[0] = p->l1 * sin(q[CRANK]) + length * sin(q[ROD]);
	out[1] = q[BLOCK] - p->l1 * cos(q[CRANK]) - length * cos(q[ROD]);
	out[2] = q[CRANK] - p->omega * t;
}
