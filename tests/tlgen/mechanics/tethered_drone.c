/* A drone on a cable of three segments that only pull. Vector macros in the way of Graphics Gems. */
#include <math.h>

#define NPART 3
#define X 0
#define Y 1
#define Z 2

#define VCOPY(d, a)      ((d)[X] = (a)[X], (d)[Y] = (a)[Y], (d)[Z] = (a)[Z])
#define VSUB(d, a, b)    ((d)[X] = (a)[X] - (b)[X], (d)[Y] = (a)[Y] - (b)[Y], (d)[Z] = (a)[Z] - (b)[Z])
#define VSCALE(d, s, a)  ((d)[X] = (s) * (a)[X], (d)[Y] = (s) * (a)[Y], (d)[Z] = (s) * (a)[Z])
#define VDOT(a, b)       ((a)[X] * (b)[X] + (a)[Y] * (b)[Y] + (a)[Z] * (b)[Z])
#define VLENGTH(a)       sqrt(VDOT(a, a))
#define VCOMB(d, s, a, r, b) do { int _i; for (_i = X; _i <= Z; _i++) (d)[_i] = (s) * (a)[_i] + (r) * (b)[_i]; } while (0)

static const double anchor[3] = {0.0, 0.0, 0.2};
static const double mass[NPART] = {0.08, 0.08, 1.4};
static const double stiffness = 350.0, length = 1.1, gravity = 9.81;

double drone_lagrangian(const double q[3 * NPART], const double qd[3 * NPART])
{
	double d[3], prev[3], stretch, T = 0.0, V = 0.0;
	const double *x = q, *v = qd, *m = mass;

	VCOPY(prev, anchor);
	do {
		VSUB(d, x, prev);
		stretch = VLENGTH(d) - length;
		V += stretch > 0.0 ? 0.5 * stiffness * stretch * stretch : 0.0;
		V += *m * gravity * x[Z];
		T += 0.5 * *m * VDOT(v, v);
		VCOPY(prev, x);
		x += 3, v += 3;
	} while (++m < mass + NPART);
	return T - V;
}

/* Thrust towards a point that circles, gravity compensated, saturated; linear drag in a steady wind. */
void drone_thrust(const double q[3 * NPART], const double qd[3 * NPART], double t, double out[3 * NPART])
{
	static const double wind[3] = {1.5, -0.4, 0.0};
	double target[3] = {2.0 * cos(t), 2.0 * sin(t), 2.4}, error[3], thrust[3], rel[3], size;
	const double *x = q + 3 * (NPART - 1), *v = qd + 3 * (NPART - 1);
	int i;

	for (i = 0; i < NPART; i++) {
		VSUB(rel, wind, qd + 3 * i);
		VSCALE(out + 3 * i, 0.05, rel);
	}
	VSUB(error, target, x);
	VCOMB(thrust, 6.0, error, -3.5, v);
	thrust[Z] += mass[NPART - 1] * gravity;
	size = VLENGTH(thrust);
	if (size > 25.0)
		VSCALE(thrust, 25.0 / size, thrust);
	for (i = 0; i < 3; i++)
		out[3 * (NPART - 1) + i] += thrust[i];
}
