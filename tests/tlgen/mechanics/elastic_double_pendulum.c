/* Two point masses on two springs in series, q = (r1, theta1, r2, theta2). Many tiny pure functions, everything const. */
#include <math.h>

struct polar { const double r, theta, rdot, thetadot; };

static double sq(const double x) { return x * x; }
static double half(const double x) { return x / 2; }

static double mass(const int i) { return i == 1 ? 0.7 : 0.4; }
static double stiffness(const int i) { return i == 1 ? 85.0 : 60.0; }
static double rest_length(const int i) { return i == 1 ? 0.5 : 0.35; }
static double g(void) { return 9.81; }

static double along(const struct polar p) { return p.rdot; }
static double across(const struct polar p) { return p.r * p.thetadot; }
static double drop(const struct polar p) { return p.r * cos(p.theta); }
static double speed_squared(const struct polar p) { return sq(along(p)) + sq(across(p)); }

/* v1 . v2 by the angle between the two links */
static double scalar_product(const struct polar a, const struct polar b)
{
	return (along(a) * along(b) + across(a) * across(b)) * cos(a.theta - b.theta)
	     + (across(a) * along(b) - along(a) * across(b)) * sin(b.theta - a.theta);
}

static double kinetic(const struct polar a, const struct polar b)
{
	return half(mass(1) * speed_squared(a))
	     + half(mass(2) * (speed_squared(a) + speed_squared(b) + 2 * scalar_product(a, b)));
}

static double elastic(const int i, const struct polar p) { return half(stiffness(i) * sq(p.r - rest_length(i))); }
static double weight(const int i, const double depth) { return -mass(i) * g() * depth; }

static double potential(const struct polar a, const struct polar b)
{
	return elastic(1, a) + elastic(2, b) + weight(1, drop(a)) + weight(2, drop(a) + drop(b));
}

static double difference(const struct polar a, const struct polar b) { return kinetic(a, b) - potential(a, b); }

double elastic_double_pendulum(const double q[], const double qd[])
{
	return difference((struct polar){ q[0], q[1], qd[0], qd[1] }, (struct polar){ q[2], q[3], qd[2], qd[3] });
}
