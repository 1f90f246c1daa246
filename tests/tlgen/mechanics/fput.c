// SPDX-License-Identifier: BSD-3-Clause
/*
 * fput.c - Fermi-Pasta-Ulam-Tsingou chain, both ends fixed
 *
 * The bond between mass i-1 and i stretches by q[i] - q[i-1]; the walls
 * stand for masses -1 and n.
 */

#define ARRAY_SIZE(a)	(sizeof(a) / sizeof((a)[0]))
#define likely(x)	__builtin_expect(!!(x), 1)

struct fput_bond {
	double k;
	double alpha;
	double beta;
};

struct fput_chain {
	int nr_masses;
	const double mass[5];
	struct fput_bond bonds[6];
};

#define for_each_mass(i, chain) \
	for ((i) = 0; (i) < (chain)->nr_masses; (i)++)

#define for_each_bond(bond, chain) \
	for ((bond) = (chain)->bonds; (bond) <= &(chain)->bonds[(chain)->nr_masses]; (bond)++)

const struct fput_chain fput_default = {
	.nr_masses = 5,
	.mass	   = { 1.0, 1.0, 1.2, 1.0, 0.9 },
	.bonds	   = {
		{ .k = 1.0, .alpha = 0.25, .beta = 0.5 },
		{ .k = 1.0, .alpha = 0.25, .beta = 0.5 },
		{ .k = 1.1, .alpha = -0.25, .beta = 0.5 },
		{ .k = 1.0, .alpha = 0.25, .beta = 0.7 },
		{ .k = 1.0, .alpha = 0.25 },
		{ .k = 0.8, .beta = 0.3 },
	},
};

static double fput_bond_energy(const struct fput_bond *bond, double r)
{
	return r * r * (bond->k / 2 + r * (bond->alpha / 3 + r * bond->beta / 4));
}

/*
 * Displacement of a mass, or zero at a wall.
 */
static double fput_displacement(const struct fput_chain *chain,
				const double *q, int i)
{
	if (likely(i >= 0 && i < chain->nr_masses))
		return q[i];

	return 0;
}

double fput_lagrangian(const struct fput_chain *chain, const double *q,
		       const double *qd)
{
	const struct fput_bond *bond;
	double ret = 0;
	int i;

	for_each_mass(i, chain)
		ret += chain->mass[i] * qd[i] * qd[i] / 2;

	i = 0;
	for_each_bond(bond, chain) {
		double right = fput_displacement(chain, q, i);
		double left = fput_displacement(chain, q, i - 1);

		ret -= fput_bond_energy(bond, right - left);
		i++;
	}

	return ret;
}
