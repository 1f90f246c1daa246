/* What larger code bases have around a model: members that it never touches, unnamed structs, strings as tables, hints to compilers, assert, the size of arrays. */
#include <assert.h>
#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define LIKELY(x) __builtin_expect(!!(x), 1)
#define COUNT(a) (sizeof(a) / sizeof((a)[0]))

typedef double vec3[3];
typedef const vec3 fixed3;

struct log;
struct model {
  char name[7];
  void *user;
  double mass;
  int (*report)(struct log *, const char *);
  union { int i; double d; } tag;
  struct { double linear, angular; } damping;
  struct { double stiffness; bool on; };
  struct { double x; union { int i; double d; } tag; void *context; } more;
  const char *comment;
  double length;
};

static const struct model params = {.name = "habits", .mass = 1.5, .tag.i = 3, .damping = {0.25, 0.75}, .stiffness = 2.0, .on = true,
                                    .more.x = 0.5, .length = 0.5};

static const struct { double at, weight; } gauss[] = {{-0.577, 1.0}, {0.577, 1.0}};
static const struct { const char *name; double (*f)(double); double gain; char unit[4]; } laws[] = {{"sine", sin, 1.5, "rad"}, {"exp", exp, -0.5, "1"}};
static const char layout[] = "XYYX", words[2][3] = {"ab", "c"};
static fixed3 axis = {0.0, 0.6, 0.8};
_Static_assert(sizeof gauss == 4 * sizeof(double), "two points");

static double energy(double x)
{
  double s = 0.0;
  _Static_assert(COUNT(gauss) == 2, "two points");
#pragma GCC unroll 2
  for (size_t i = 0; i < COUNT(gauss); i++) s += gauss[i].weight * exp(gauss[i].at * x);
  return s;
}

static double law(double x)
{
  double s = 0.0;
  for (size_t i = 0; i < sizeof laws / sizeof *laws; i++) s += laws[i].gain * laws[i].f(x) * laws[i].unit[0];
  return s + words[1][0] * x;
}

static double pattern(const double *x)
{
  double s = 0.0;
  for (int i = 0; layout[i]; i++) switch (layout[i]) {
    case 'X':
      s += x[0];
      __attribute__((fallthrough));
    case 'Y': s += x[1] * x[1]; break;
    default: __builtin_unreachable();
    }
  return s;
}

static double mean(const double *x, int n)
{
  double copy[n], squares[n][2], s = 0.0;
  for (size_t i = 0; i < sizeof copy / sizeof copy[0]; i++) copy[i] = x[i];
  for (size_t i = 0; i < sizeof squares / sizeof squares[0]; i++)
    for (size_t j = 0; j < COUNT(squares[0]); j++) squares[i][j] = copy[i] * copy[j];
  for (int i = 0; i < n; i++) s += squares[i][0] + squares[n - 1][1];
  return s / n;
}

double lagrangian(const double *q, const double *qd, double t, const struct model *p)
{
  const struct { double x, y; } force = {-p->damping.linear * qd[0], -p->damping.angular * qd[1]};
  double T = 0.5 * p->mass * (qd[0] * qd[0] + p->length * qd[1] * qd[1]), V = 0.0;
  assert(p->mass > 0.0 && "a mass");
  if (LIKELY(p->on)) V += 0.5 * p->stiffness * q[0] * q[0] + axis[1] * q[1] + axis[2] * t;
  return T - V + energy(q[1]) * force.x + force.y * pattern(q) + mean(q, 2) + law(0.3 * q[0]) + p->more.x * t;
}
