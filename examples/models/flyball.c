/* Lagrangian and dampers of the flyball governor. */
#include "flyball.h"

#include <math.h>

enum { TURN, ARM, HEIGHT = ARM + FLYBALL_ARMS };

flyball flyball_parameters(void)
{
	const flyball p = {.arm_length = 1.0, .arm_mass = 0.3, .section = 0.01, .ball_mass = 5.0, .shaft_mass = 0.3, .slider_mass = 3.0,
		.slider_side = 0.1, .hinge_radius = 0.05, .hinge_height = 1.0, .stiffness = 8e5, .damping = 4e4, .rest = 0.5, .gravity = 9.81};
	return p;
}

void flyball_start(double *q, double *qd)
{
	const double pi = 3.14159265358979323846;

	q[TURN] = 0.0, q[ARM] = q[ARM + 1] = pi / 6.0, q[HEIGHT] = 0.5;
	qd[TURN] = 2.0 * pi, qd[ARM] = qd[ARM + 1] = 0.0, qd[HEIGHT] = 0.0;
}

/* From the slider's end of a spring to the middle of its arm. */
struct spring {
	double out, up, length;
};

static struct spring spring_of(const double *q, int arm, const flyball *p)
{
	struct spring s;

	s.out = 0.5 * p->arm_length * cos(q[ARM + arm]);
	s.up = p->hinge_height - 0.5 * p->arm_length * sin(q[ARM + arm]) - q[HEIGHT];
	s.length = sqrt(s.out * s.out + s.up * s.up);
	return s;
}

/* An arm with its ball: kinetic less potential energy. */
static double arm_with_ball(double alpha, double rate, double turn, const flyball *p)
{
	const double l = p->arm_length, across = p->arm_mass * (l * l + p->section * p->section) / 12.0;
	const double along = p->arm_mass * p->section * p->section / 6.0, c = cos(alpha), s = sin(alpha);
	const double middle = p->hinge_radius + 0.5 * l * c, end = p->hinge_radius + l * c;
	const double about_shaft = p->arm_mass * middle * middle + p->ball_mass * end * end + across * c * c + along * s * s;
	const double about_hinge = (0.25 * p->arm_mass + p->ball_mass) * l * l + across;
	const double height = p->arm_mass * (p->hinge_height - 0.5 * l * s) + p->ball_mass * (p->hinge_height - l * s);

	return 0.5 * about_shaft * turn * turn + 0.5 * about_hinge * rate * rate - p->gravity * height;
}

double flyball_lagrangian(const double *q, const double *qd, const flyball *p)
{
	const double inertia = (p->shaft_mass * p->section * p->section + p->slider_mass * p->slider_side * p->slider_side) / 6.0;
	double L = 0.5 * inertia * qd[TURN] * qd[TURN] + p->slider_mass * (0.5 * qd[HEIGHT] * qd[HEIGHT] - p->gravity * q[HEIGHT]);

	for (int i = 0; i < FLYBALL_ARMS; i++) {
		const double stretch = spring_of(q, i, p).length - p->rest;

		L += arm_with_ball(q[ARM + i], qd[ARM + i], qd[TURN], p) - 0.5 * p->stiffness * stretch * stretch;
	}
	return L;
}

void flyball_dampers(const double *q, const double *qd, const flyball *p, double *out)
{
	out[TURN] = out[HEIGHT] = 0.0;
	for (int i = 0; i < FLYBALL_ARMS; i++) {
		const struct spring s = spring_of(q, i, p);
		const double half = 0.5 * p->arm_length;
		const double by_angle = -half * (s.out * sin(q[ARM + i]) + s.up * cos(q[ARM + i])) / s.length, by_height = -s.up / s.length;
		const double force = -p->damping * (by_angle * qd[ARM + i] + by_height * qd[HEIGHT]);

		out[ARM + i] = force * by_angle;
		out[HEIGHT] += force * by_height;
	}
}
