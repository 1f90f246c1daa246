/* Furuta pendulum with a brushed motor. Parameters, coordinates and rates come from lists of X-macros. */
#include <math.h>

#define FURUTA_PARAMETERS(X) \
	X(arm_mass,        0.257,           "kg") \
	X(arm_length,      0.2159,          "m") \
	X(arm_com,         0.0619,          "m") \
	X(arm_inertia,     9.98e-4,         "kg m^2, about its centre of mass") \
	X(pend_mass,       0.127,           "kg") \
	X(pend_com,        0.1556,          "m") \
	X(pend_inertia_x,  1.2e-3,          "kg m^2, about the hinge's direction") \
	X(pend_inertia_y,  1.1e-3,          "kg m^2, across hinge and rod") \
	X(pend_inertia_z,  2.0e-5,          "kg m^2, along the rod") \
	X(resistance,      2.6,             "ohm") \
	X(motor_constant,  0.00768 * 70.0,  "N m/A") \
	X(arm_damping,     2.4e-3,          "N m s") \
	X(pend_damping,    2.4e-4,          "N m s") \
	X(gravity,         9.81,            "m/s^2")

#define FURUTA_COORDINATES(X) X(arm) X(pend)

struct furuta {
#define MEMBER(name, value, unit) double name;
	FURUTA_PARAMETERS(MEMBER)
#undef MEMBER
};

static const struct furuta furuta_lab = {
#define INITIAL(name, value, unit) .name = (value),
	FURUTA_PARAMETERS(INITIAL)
#undef INITIAL
};

enum {
#define INDEX(name) INDEX_##name,
	FURUTA_COORDINATES(INDEX)
#undef INDEX
	N_COORDINATES
};

#define ANGLE(name) const double name = q[INDEX_##name];
#define RATE(name) const double name##_rate = qd[INDEX_##name];
#define DAMPED(name) out[INDEX_##name] = -p->name##_damping * name##_rate;
static double square(double x) { return x * x; }

double furuta_lagrangian(const double *q, const double *qd, const struct furuta *p)
{
	FURUTA_COORDINATES(ANGLE)
	FURUTA_COORDINATES(RATE)
	const double wy = arm_rate * sin(pend), wz = arm_rate * cos(pend);
	double twice = (p->arm_inertia + p->arm_mass * square(p->arm_com)) * square(arm_rate);

	(void)arm;
	twice += p->pend_inertia_x * square(pend_rate) + p->pend_inertia_y * square(wy) + p->pend_inertia_z * square(wz);
	twice += p->pend_mass * (square(p->pend_com * wy) + square(p->arm_length * wz - p->pend_com * pend_rate)
				 + square(p->arm_length * wy));
	return 0.5 * twice - p->pend_mass * p->gravity * p->pend_com * cos(pend);
}

void furuta_force(const double *qd, double t, const struct furuta *p, double *out)
{
	FURUTA_COORDINATES(RATE)
	FURUTA_COORDINATES(DAMPED)
	double current = (1.5 * sin(4.0 * t) - p->motor_constant * arm_rate) / p->resistance;

	out[INDEX_arm] += p->motor_constant * current;
}
