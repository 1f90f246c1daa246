/* Lagrangian, torque and loop closures of Andrews' squeezing mechanism. */
#include "andrews.h"

#include <math.h>

enum { BETA, THETA, GAMMA, PHI, DELTA, OMEGA, EPSILON };

andrews andrews_parameters(void)
{
	const andrews p = {
		.m1 = 0.04325, .m2 = 0.00365, .m3 = 0.02373, .m4 = 0.00706, .m5 = 0.07050, .m6 = 0.00706, .m7 = 0.05498,
		.i1 = 2.194e-6, .i2 = 4.410e-7, .i3 = 5.255e-6, .i4 = 5.667e-7, .i5 = 1.169e-5, .i6 = 5.667e-7, .i7 = 1.912e-5,
		.xa = -0.06934, .ya = -0.00227, .xb = -0.03635, .yb = 0.03273, .xc = 0.014, .yc = 0.072,
		.d = 28e-3, .da = 115e-4, .e = 2e-2, .ea = 1421e-5, .rr = 7e-3, .ra = 92e-5, .ss = 35e-3, .sa = 1874e-5,
		.sb = 1043e-5, .sc = 18e-3, .sd = 2e-2, .ta = 2308e-5, .tb = 916e-5, .u = 4e-2, .ua = 1228e-5, .ub = 449e-5,
		.zf = 2e-2, .zt = 4e-2, .fa = 1421e-5, .c0 = 4530.0, .l0 = 0.07785, .mom = 0.033};
	return p;
}

void andrews_start(double *q, double *qd)
{
	static const double start[ANDREWS_COORDINATES] = {
		-0.0617138900142764496, 0.0, 0.455279819163070380, 0.222668390165885885, 0.487364979543842550, -0.222668390165885885,
		1.23054744454982119};

	for (int i = 0; i < ANDREWS_COORDINATES; i++) {
		q[i] = start[i];
		qd[i] = 0.0;
	}
}

/* Bodies 1 and 2: crank and rod. */
static double crank(const double *q, const double *qd, const andrews *p)
{
	const double along = p->da * p->rr * cos(q[THETA]);
	const double m11 = p->m1 * p->ra * p->ra + p->m2 * (p->rr * p->rr - 2.0 * along + p->da * p->da) + p->i1 + p->i2;
	const double m12 = p->m2 * (p->da * p->da - along) + p->i2, m22 = p->m2 * p->da * p->da + p->i2;

	return 0.5 * m11 * qd[BETA] * qd[BETA] + m12 * qd[BETA] * qd[THETA] + 0.5 * m22 * qd[THETA] * qd[THETA];
}

/* Bodies 4 and 5, and likewise 6 and 7: a rod on a lever. */
static double lever(double turn, double rate_of_rod, double rate_of_lever, double arm, double reach, double m_rod, double i_rod, double m_lever,
                    double i_lever, double across, double along)
{
	const double rod = m_rod * arm * arm + i_rod, mixed = m_rod * (arm * arm + reach * arm * turn) + i_rod;
	const double both = m_rod * (reach * reach + 2.0 * reach * arm * turn + arm * arm) + m_lever * (across * across + along * along)
		+ i_rod + i_lever;

	return 0.5 * rod * rate_of_rod * rate_of_rod + mixed * rate_of_rod * rate_of_lever + 0.5 * both * rate_of_lever * rate_of_lever;
}

static double spring(const double *q, const andrews *p)
{
	const double x = p->xb + p->sd * cos(q[GAMMA]) + p->sc * sin(q[GAMMA]) - p->xc;
	const double y = p->yb + p->sd * sin(q[GAMMA]) - p->sc * cos(q[GAMMA]) - p->yc;
	const double stretch = sqrt(x * x + y * y) - p->l0;

	return 0.5 * p->c0 * stretch * stretch;
}

double andrews_lagrangian(const double *q, const double *qd, const andrews *p)
{
	const double turning = p->m3 * (p->sa * p->sa + p->sb * p->sb) + p->i3;
	double T = crank(q, qd, p) + 0.5 * turning * qd[GAMMA] * qd[GAMMA];

	T += lever(sin(q[PHI]), qd[PHI], qd[DELTA], p->e - p->ea, p->zt, p->m4, p->i4, p->m5, p->i5, p->ta, p->tb);
	T += lever(-sin(q[OMEGA]), qd[OMEGA], qd[EPSILON], p->zf - p->fa, p->u, p->m6, p->i6, p->m7, p->i7, p->ua, p->ub);
	return T - spring(q, p);
}

void andrews_torque(const andrews *p, double *out)
{
	for (int i = 0; i < ANDREWS_COORDINATES; i++)
		out[i] = i == BETA ? p->mom : 0.0;
}

void andrews_loops(const double *q, const andrews *p, double *out)
{
	const double x = p->rr * cos(q[BETA]) - p->d * cos(q[BETA] + q[THETA]);
	const double y = p->rr * sin(q[BETA]) - p->d * sin(q[BETA] + q[THETA]);

	out[0] = x - p->ss * sin(q[GAMMA]) - p->xb;
	out[1] = y + p->ss * cos(q[GAMMA]) - p->yb;
	out[2] = x - p->e * sin(q[PHI] + q[DELTA]) - p->zt * cos(q[DELTA]) - p->xa;
	out[3] = y + p->e * cos(q[PHI] + q[DELTA]) - p->zt * sin(q[DELTA]) - p->ya;
	out[4] = x - p->zf * cos(q[OMEGA] + q[EPSILON]) - p->u * sin(q[EPSILON]) - p->xa;
	out[5] = y - p->zf * sin(q[OMEGA] + q[EPSILON]) + p->u * cos(q[EPSILON]) - p->ya;
}
