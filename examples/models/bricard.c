/* Lagrangian and joints of Bricard's mechanism. */
#include "bricard.h"

enum { AXES = 12 }; /* where the axes begin in q */

static const double end[3] = {0.0, 0.0, 1.0}, first_axis[3] = {0.0, 1.0, 0.0}, last_axis[3] = {1.0, 0.0, 0.0};
static const double zero[3] = {0.0, 0.0, 0.0};

bricard bricard_parameters(void)
{
	const bricard p = {.length = 1.0, .section = 0.0, .mass = 1.0, .g = 9.81};
	return p;
}

void bricard_start(double *q, double *qd)
{
	static const double start[BRICARD_COORDINATES] = {1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 1.0, -1.0, 1.0, 0.0, -1.0, 1.0,
		0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

	for (int i = 0; i < BRICARD_COORDINATES; i++) {
		q[i] = start[i];
		qd[i] = 0.0;
	}
}

static double dot(const double *a, const double *b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Copies joint i = 0..5 of q: the ground's are at 0 and last. */
static void pick(double *to, const double *q, int i, const double *ground, const double *last)
{
	for (int k = 0; k < 3; k++)
		to[k] = i == 0 ? ground[k] : i == BRICARD_RODS ? last[k] : q[3 * (i - 1) + k];
}

/* A rod whose ends have velocities u and v and whose axes have rates r and s: m (u.u + u.v + v.v)/6 + m section^2/12 (r.r + s.s)/2. */
double bricard_lagrangian(const double *q, const double *qd, const bricard *p)
{
	double T = 0.0, height = 0.0, u[3], v[3], r[3], s[3], below[3], above[3];

	for (int i = 0; i < BRICARD_RODS; i++) {
		pick(u, qd, i, zero, zero), pick(v, qd, i + 1, zero, zero);
		pick(r, qd + AXES, i, zero, zero), pick(s, qd + AXES, i + 1, zero, zero);
		pick(below, q, i, zero, end), pick(above, q, i + 1, zero, end);
		T += (dot(u, u) + dot(u, v) + dot(v, v)) / 6.0 + p->section * p->section * (dot(r, r) + dot(s, s)) / 24.0;
		height += 0.5 * (below[1] + above[1]);
	}
	return p->mass * (T - p->g * height);
}

void bricard_joints(const double *q, const bricard *p, double *out)
{
	double from[3], to[3], a[3], b[3], rod[3];

	for (int i = 0; i < BRICARD_RODS; i++) {
		pick(from, q, i, zero, end), pick(to, q, i + 1, zero, end);
		pick(a, q + AXES, i, first_axis, last_axis), pick(b, q + AXES, i + 1, first_axis, last_axis);
		for (int k = 0; k < 3; k++)
			rod[k] = to[k] - from[k];
		out[4 * i] = dot(rod, rod) - p->length * p->length;
		out[4 * i + 1] = dot(rod, a);
		out[4 * i + 2] = dot(rod, b);
		out[4 * i + 3] = dot(a, b);
	}
	for (int i = 0; i < BRICARD_RODS - 1; i++)
		out[4 * BRICARD_RODS + i] = dot(q + AXES + 3 * i, q + AXES + 3 * i) - 1.0;
}
