/* The coil of the levitation: inductance by air gap, and what the supply does. */
#include <math.h>
#include "maglev.h"

/* Iron saturates: log(1 + x) in place of x */
static double
saturate(double x)
{
	return log1p(x);
}

double
coil_inductance(const coil *c, double x)
{
	return c->l_far + c->l_gap * saturate(1.0 / (1.0 + x / c->gap));
}

double
coil_voltage(double t)
{
	if (t < 0)
		return 0;
	return 12 + 2 * sin(300 * t) * exp(-t);
}
