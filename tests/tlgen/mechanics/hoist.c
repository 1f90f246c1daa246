/* Load on a rope under a trolley on a rail. What it loses is one function: the rail's dry friction, smoothed, a brake that closes with
 * time, oil between trolley and load, and the air's drag with the square of the speed. */
#include <math.h>

struct hoist {
	double trolley, load;	/* kg */
	double rope;		/* m */
	double grip, creep;	/* N, m/s */
	double brake;		/* N s/m^2 */
	double oil;		/* N s/m */
	double air;		/* N s^2/m^2 */
	double thrust;		/* N */
};

static const struct hoist harbour = {
	.trolley = 120.0, .load = 350.0, .rope = 4.0,
	.grip = 60.0, .creep = 0.05, .brake = 9.0,
	.oil = 14.0, .air = 2.5, .thrust = 200.0,
};

/* q: trolley along the rail, load along it and upwards from it */
double hoist_lagrangian(const double *q, const double *qd, const struct hoist *p)
{
	double kinetic = 0.5 * p->trolley * qd[0] * qd[0];

	kinetic += 0.5 * p->load * (qd[1] * qd[1] + qd[2] * qd[2]);
	return kinetic - 9.81 * p->load * q[2];
}

double hoist_rope(const double *q, const struct hoist *p)
{
	double x = q[1] - q[0];

	return 0.5 * (x * x + q[2] * q[2] - p->rope * p->rope);
}

static double swing_rate(const double *q, const double *qd)
{
	double x = q[1] - q[0], xd = qd[1] - qd[0];

	return (x * qd[2] - q[2] * xd) / (x * x + q[2] * q[2]);
}

double hoist_losses(const double *q, const double *qd, double t, const struct hoist *p)
{
	double rate = swing_rate(q, qd), speed2 = qd[1] * qd[1] + qd[2] * qd[2];
	double loss = p->grip * sqrt(qd[0] * qd[0] + p->creep * p->creep);

	loss += 0.5 * p->brake * t * qd[0] * qd[0];
	loss += 0.5 * p->oil * rate * rate;
	loss += p->air / 3.0 * speed2 * sqrt(speed2);
	return loss;
}

void hoist_drive(double t, const struct hoist *p, double *out)
{
	out[0] = p->thrust * cos(3.0 * t);
}
