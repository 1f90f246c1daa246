/* Landau and Lifshitz, Mechanics, paragraph 32: thin rods OA and AB hinged at A; OA turns about O, the end B slides along an axis
 * through O. Here with weight, and a spring at B. Written with objects: each rod knows its state and answers for its own energies. */
#include <math.h>

#define new_rod(...) ((struct rod){__VA_ARGS__})

struct rod {
	double mass, length;
	double angle, rate;           /* from the axis, counter-clockwise */
	double x, y, vx, vy;          /* of the end that it hangs on */
};

struct spring {
	double stiffness, rest;
};

struct mechanism {
	struct rod driver, follower;
	struct spring spring;
};

static void rod_point(const struct rod *self, double part, double *x, double *y)
{
	*x = self->x + part * self->length * cos(self->angle);
	*y = self->y + part * self->length * sin(self->angle);
}

static void rod_velocity(const struct rod *self, double part, double *vx, double *vy)
{
	*vx = self->vx - part * self->length * self->rate * sin(self->angle);
	*vy = self->vy + part * self->length * self->rate * cos(self->angle);
}

static double rod_lagrangian(const struct rod *self)
{
	double x, y, vx, vy, inertia = self->mass * self->length * self->length / 12;

	rod_point(self, 0.5, &x, &y);
	rod_velocity(self, 0.5, &vx, &vy);
	return self->mass * (vx * vx + vy * vy) / 2 + inertia * self->rate * self->rate / 2 - self->mass * 9.81 * y;
}

static double spring_energy(const struct spring *self, double length)
{
	return self->stiffness * (length - self->rest) * (length - self->rest) / 2;
}

static struct rod rod_attach(struct rod self, const struct rod *other)
{
	rod_point(other, 1, &self.x, &self.y);
	rod_velocity(other, 1, &self.vx, &self.vy);
	return self;
}

static struct mechanism mechanism_new(double phi, double rate)
{
	struct mechanism self;

	self.driver = new_rod(0.6, 0.5, phi, rate, 0, 0, 0, 0);
	self.follower = rod_attach(new_rod(.mass = 0.6, .length = 0.5, .angle = -phi, .rate = -rate), &self.driver);
	self.spring.stiffness = 40;
	self.spring.rest = 0.8;
	return self;
}

static double mechanism_lagrangian(const struct mechanism *self)
{
	double x, y;

	rod_point(&self->follower, 1, &x, &y);
	return rod_lagrangian(&self->driver) + rod_lagrangian(&self->follower) - spring_energy(&self->spring, x);
}

double rods(const double *q, const double *qd)
{
	struct mechanism mechanism = mechanism_new(q[0], qd[0]);

	return mechanism_lagrangian(&mechanism);
}
