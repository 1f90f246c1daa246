/* Ball under an electromagnet with a series capacitor; x is the gap, z the charge. BSD style, coil in a file of its own. */
#include <math.h>
#include "maglev.h"

static const coil	magnet = { 0.25f, 0.375f, 4.0e-3, 7.5, 2.2e-3 };

double
maglev_lagrangian(double x, double z, double xdot, double i, const coil *c)
{
	const double	m = 0.068, g = 9.81;

	return (m * xdot * xdot / 2 + coil_inductance(c, x) * i * i / 2 +
	    m * g * x - z * z / (2 * c->capacitance));
}

void
maglev_force(double xdot, double i, double t, const coil *c, double *out)
{
	*out++ = -1e-3 * xdot;
	*out = coil_voltage(t) - c->resistance * i;
}
