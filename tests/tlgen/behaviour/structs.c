/* Structs: nested, in arrays, copied, returned, designated, members of a temporary, pointers to them; of constants and of jets. */
#include <math.h>

typedef struct { double x, y, z; } vec;

struct body {
  double mass;
  vec position, velocity;
  double inertia[2][2];
};

struct arm { double length; vec offset; };

struct setup {
  int bodies;
  struct arm arm[2];
  const double *weight;
};

static const double weights[] = {1.5, 0.25};
static const struct setup params = {2, {{1.0, {0.1, 0.2, 0.3}}, {0.75, {-0.1, 0.0, 0.2}}}, weights};

static vec cross(vec a, vec b) { return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static double dot(const vec *a, const vec *b) { return a->x * b->x + a->y * b->y + a->z * b->z; }
static vec scaled(double k, vec a)
{
  a.x *= k, a.y *= k, a.z *= k;
  return a;
}
static vec pick(int which, vec a, vec b) { return which ? a : b; }

static struct body make(double angle, double rate, double length)
{
  struct body b = {.velocity = {.y = rate, .x = -rate * sin(angle)}, .mass = length, .inertia = {[1] = {angle, 2.0}}};
  b.position = (vec){.z = cos(angle), .x = length};
  return b;
}

double lagrangian(const double q[2], const double qd[2], double t, const struct setup *p)
{
  struct body body[2], copy, *last = body;
  vec zero = {0}, sum = zero, c;
  double L = 0.0;

  for (int i = 0; i < p->bodies; i++) {
    body[i] = make(q[i], qd[i], p->arm[i].length);
    body[i].position.y += p->arm[i].offset.y * t;
    c = p->arm[i].offset;
    sum.x += c.x * body[i].position.x;
  }
  copy = body[1];
  copy.position = body[0].velocity;
  copy.inertia[0][1] = copy.inertia[1][0] * copy.mass;
  body[0] = copy;
  copy.mass = -1.0;
  last++;
  for (int i = 0; i < 2; i++) L += body[i].mass * p->weight[i] * dot(&body[i].velocity, &body[1 - i].position);
  c = cross(last->position, scaled(t, body[0].position));
  c = cross(c, c.x > 0.0 ? last->velocity : body[0].velocity);
  c = (vec){c.y, c.x, c.z + c.y};
  L += c.x + 2.0 * c.y + cross(c, sum).z + pick(q[0] > 0.0, c, sum).x + pick(1, sum, p->arm[1].offset).x;
  L += body[0].inertia[0][1] + last[-1].inertia[1][0] * (*last).inertia[1][1] + copy.mass * copy.position.x;
  L += make(q[1], t, 0.5).velocity.x;
  sum = c = scaled(q[0], c);
  return L + dot(&sum, &c);
}
