/* A charge among magnets: L = m v^2/2 + e v.A - e U, with a magnetic dipole, a uniform magnetic field and a uniform electric field. */
#include "dipole_vec.h"

struct magnet { vec place, moment; };

struct trap {
  double mass, charge;
  vec uniform_b, uniform_e;
  struct magnet magnets[2];
};

const struct trap trap = {
  .mass = 0.9,
  .charge = -1.6,
  .uniform_b = {.z = 1.1, .y = -0.2},
  .uniform_e = {0.3, 0.0, 0.4},
  .magnets = {{.place = {0, 0, 0}, .moment = {0.1, 0.0, 0.8}}, {.place = {2.5, -1.0, 0.5}, .moment = {-0.5, 0.6, 0.1}}},
};

/* mu x r / r^3 */
static vec magnet_potential(const struct magnet *magnet, vec at)
{
  const vec r = vec_minus(at, magnet->place);
  const double length = vec_length(r);
  return vec_times(1 / (length * length * length), vec_cross(magnet->moment, r));
}

static vec vector_potential(const struct trap *s, vec at)
{
  vec a = vec_times(0.5, vec_cross(s->uniform_b, at));
  for (unsigned i = 0; i < sizeof s->magnets / sizeof *s->magnets; i++) a = vec_plus(a, magnet_potential(&s->magnets[i], at));
  return a;
}

double charge_lagrangian(double x, double y, double z, double xd, double yd, double zd, const struct trap *s)
{
  const vec at = {x, y, z}, v = {xd, yd, zd};
  const double kinetic = 0.5 * s->mass * vec_dot(v, v);
  const double electric = -vec_dot(s->uniform_e, at);
  return kinetic + s->charge * (vec_dot(v, vector_potential(s, at)) - electric);
}
