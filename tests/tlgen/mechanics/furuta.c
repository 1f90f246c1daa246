// SPDX-License-Identifier: GPL-2.0
/*
 * Furuta (rotary inverted) pendulum with a brushed DC motor.
 *
 * Units: SI. Angles: arm from the bench's mark, pendulum from upright.
 */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define ARRAY_SIZE(arr) (sizeof(arr) / sizeof((arr)[0]))
#define FURUTA_ARM	0
#define FURUTA_PEND	1

struct furuta_link {
	double mass;
	double length;
	double com;
	double inertia[3];
};

struct furuta_motor {
	double resistance;
	double kt;
	bool backemf;
};

struct furuta_device {
	struct furuta_link link[2];
	struct furuta_motor motor;
	double damping[2];
	double gravity;
};

static const struct furuta_device furuta_dev = {
	.link = {
		[FURUTA_ARM]  = { .mass = 0.257, .length = 0.2159, .com = 0.0619, .inertia = { 0.0, 0.0, 9.98e-4 } },
		[FURUTA_PEND] = { .mass = 0.127, .length = 0.3365, .com = 0.1556, .inertia = { 1.2e-3, 1.1e-3, 2.0e-5 } },
	},
	.motor = { .resistance = 2.6, .kt = 0.00768 * 70.0, .backemf = true },
	.damping = { 2.4e-3, 2.4e-4 },
	.gravity = 9.81,
};

static inline double furuta_arm_energy(const struct furuta_link *arm, double rate)
{
	double inertia = arm->inertia[2] + arm->mass * arm->com * arm->com;

	return 0.5 * inertia * rate * rate;
}

/* The pendulum's frame: x radial (hinge), y tangential and tilted, z along the rod. */
static void furuta_pend_rates(double *w, double arm_rate, double angle, double rate)
{
	w[0] = rate;
	w[1] = arm_rate * sin(angle);
	w[2] = arm_rate * cos(angle);
}

double furuta_lagrangian(const double *q, const double *qd, const struct furuta_device *p)
{
	const struct furuta_link *pend = &p->link[FURUTA_PEND];
	const struct furuta_link *arm = &p->link[FURUTA_ARM];
	double w[3], v[3], energy;
	size_t i;

	energy = furuta_arm_energy(arm, qd[FURUTA_ARM]);

	furuta_pend_rates(w, qd[FURUTA_ARM], q[FURUTA_PEND], qd[FURUTA_PEND]);
	v[0] = pend->com * w[1];
	v[1] = arm->length * w[2] - pend->com * w[0];
	v[2] = -arm->length * w[1];

	for (i = 0; i < ARRAY_SIZE(w); i++)
		energy += 0.5 * (pend->inertia[i] * w[i] * w[i] + pend->mass * v[i] * v[i]);

	return energy - pend->mass * p->gravity * pend->com * cos(q[FURUTA_PEND]);
}

static double furuta_motor_torque(const struct furuta_motor *motor, double volts, double rate)
{
	if (!motor->resistance)
		return 0.0;

	if (motor->backemf)
		volts -= motor->kt * rate;

	return motor->kt * volts / motor->resistance;
}

void furuta_force(const double *qd, double t, const struct furuta_device *p, double *out)
{
	double volts = 1.5 * sin(4.0 * t);
	int i;

	for (i = 0; i < 2; i++)
		out[i] = -p->damping[i] * qd[i];

	out[FURUTA_ARM] += furuta_motor_torque(&p->motor, volts, qd[FURUTA_ARM]);
}
