// Six-axis arm: kinetic energy by Uicker's trace of dT J dT', matrices as structs that go by value.
#include "spatial_arm.h"

#include <math.h>

#define HALF_PI 1.5707963267948966
enum { AXES = 6 };

static const dh_row table[AXES] = {
  { .theta = 0.0, .d = 0.67, .a = 0.00, .alpha = -HALF_PI, .mass = 12.0, .com = { 0.02, 0.11, 0.05 }, .gyration = { 0.021, 0.014, 0.018 } },
  { .theta = -HALF_PI, .d = 0.00, .a = 0.43, .alpha = 0.0, .mass = 15.5, .com = { -0.22, 0.01, 0.16 }, .gyration = { 0.012, 0.041, 0.043 } },
  { .d = 0.15, .a = -0.02, .alpha = HALF_PI, .mass = 5.2, .com = { 0.02, -0.07, 0.03 }, .gyration = { 0.016, 0.004, 0.015 } },
  { .d = 0.43, .alpha = -HALF_PI, .mass = 1.3, .com = { 0.00, 0.10, 0.01 }, .gyration = { 0.005, 0.003, 0.004 } },
  { .alpha = HALF_PI, .mass = 0.7, .com = { 0.01, 0.0, 0.02 }, .gyration = { 0.001, 0.002, 0.0015 } },
  { .d = 0.06, .mass = 0.4, .com = { 0.0, 0.005, 0.03 }, .gyration = { 0.0012, 0.0011, 0.0007 } },
};

static mat4 identity(void) { return (mat4){ { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } } }; }

static mat4 mul(mat4 a, mat4 b)
{
  mat4 c = { { { 0 } } };
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j)
      for (size_t k = 0; k < 4; ++k)
        c.m[i][j] += a.m[i][k] * b.m[k][j];
  return c;
}

static mat4 add(mat4 a, mat4 b)
{
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j)
      a.m[i][j] += b.m[i][j];
  return a;
}

static mat4 scale(double s, mat4 a)
{
  for (size_t i = 0; i < 4; ++i)
    for (size_t j = 0; j < 4; ++j)
      a.m[i][j] *= s;
  return a;
}

// from frame i to frame i-1
static mat4 dh_transform(const dh_row *r, double q)
{
  const double c = cos(q + r->theta), s = sin(q + r->theta), ca = cos(r->alpha), sa = sin(r->alpha);
  return (mat4){ {
    { c, -s * ca, s * sa, r->a * c },
    { s, c * ca, -c * sa, r->a * s },
    { 0, sa, ca, r->d },
    { 0, 0, 0, 1 },
  } };
}

// d/dq of it: a turn about the previous z axis
static mat4 dh_derivative(mat4 t)
{
  mat4 d = { .m = { [0] = { 0 } } };
  for (size_t j = 0; j < 4; ++j) {
    d.m[0][j] = -t.m[1][j];
    d.m[1][j] = t.m[0][j];
  }
  return d;
}

// integral of r r' dm, r = (x, y, z, 1)
static mat4 pseudo_inertia(const dh_row *r)
{
  const double h[4] = { r->com.x, r->com.y, r->com.z, 1.0 };
  const vec3 g = r->gyration;
  const double own[3] = { (g.y + g.z - g.x) / 2, (g.x + g.z - g.y) / 2, (g.x + g.y - g.z) / 2 };
  mat4 j;
  for (size_t i = 0; i < 4; ++i)
    for (size_t k = 0; k < 4; ++k)
      j.m[i][k] = r->mass * (h[i] * h[k] + (i == k && i < 3 ? own[i] : 0.0));
  return j;
}

static double trace_dt_j_dt(mat4 dt, mat4 j)
{
  double sum = 0;
  mat4 dj = mul(dt, j);
  for (size_t i = 0; i < 4; ++i)
    for (size_t k = 0; k < 4; ++k)
      sum += dj.m[i][k] * dt.m[i][k];
  return sum;
}

double arm6_lagrangian(const double q[6], const double qd[6])
{
  mat4 t = identity(), dt = scale(0, t);
  double energy = 0;
  for (const dh_row *r = table; r != table + AXES; ++r) {
    const ptrdiff_t i = r - table;
    const mat4 a = dh_transform(r, q[i]);
    dt = add(mul(dt, a), scale(qd[i], mul(t, dh_derivative(a))));
    t = mul(t, a);
    const double height = t.m[2][0] * r->com.x + t.m[2][1] * r->com.y + t.m[2][2] * r->com.z + t.m[2][3];
    energy += trace_dt_j_dt(dt, pseudo_inertia(r)) / 2 - 9.81 * r->mass * height;
  }
  return energy;
}
