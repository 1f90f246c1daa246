/* A crane with a swinging load: helpers with results and out-parameters, structs by value, branches, a while loop, a table, time. */
#include <math.h>

typedef struct { double x, y; } point;

struct crane {
  double mass, load, gravity;
  int sections;
};

/* Height of the boom's top over its angle, m. */
static const double height[4] = {2.0, 3.5, -0.25, 0.125};

static double polynomial(const double *c, int n, double x)
{
  double y = 0.0;
  while (n-- > 0) y = y * x + c[n];
  return y;
}

static point hang(point top, double angle, double length)
{
  top.x += length * sin(angle);
  top.y -= length * cos(angle);
  return top;
}

/* Wind speed and what it presses with; gusts only while the load is high. */
static double wind(double t, point load, double *pressure)
{
  double speed = load.y > 2.0 ? 3.0 + sin(2.0 * t) : 1.0;

  *pressure = 0.5 * speed * fabs(speed);
  if (load.x < 0.0) return -speed;
  return speed;
}

double lagrangian(const double *q, const double *qd, double t, const struct crane *p)
{
  point top = {q[1], polynomial(height, 4, q[0])};
  point load = hang(top, q[2], 1.5 + 0.1 * t);
  double T = 0.5 * p->mass * qd[1] * qd[1], pressure, speed;

  for (int k = 0; k < p->sections; k++) {
    if (k == 1) continue;
    T += 0.125 * (k + 1) * qd[0] * qd[0] * pow(top.y, 2);
  }
  speed = wind(t, load, &pressure);
  return T + 0.5 * p->load * hypot(qd[2], 0.1 * qd[0]) - p->load * p->gravity * load.y + pressure * load.x * speed;
}

void cable(const double q[3], double t, double out[2])
{
  point load = hang((point){q[1], 0.0}, q[2], 1.0);
  out[0] = load.x;
  out[1] = load.y + (t > 1.0 ? 0.5 * (t - 1.0) : 0.0);
}
