/* Planar four-bar linkage: absolute angles of crank, coupler and rocker; the loop is closed by two equations.
   Points and lines as compound literals, passed by address, C99 geometry style. */
#include <math.h>

typedef struct { double x, y; } point;
typedef struct { double mass, length, com, inertia; } bar;
enum { CRANK, COUPLER, ROCKER, BARS };

static const bar bars[BARS] = {
  [CRANK]   = {0.5, 0.12, 0.06, 8.0e-4},
  [COUPLER] = {1.1, 0.38, 0.17, 1.5e-2},
  [ROCKER]  = {0.8, 0.29, 0.14, 6.0e-3},
};
static const point pivot = {0.34, 0.05}; /* of the rocker, seen from the crank's */

#define POLAR(r, a) (&(point){(r) * cos(a), (r) * sin(a)})
#define MOVED(r, a, w) (&(point){-(r) * (w) * sin(a), (r) * (w) * cos(a)}) /* d/dt of the same */

static point sum(const point *a, const point *b) { return (point){a->x + b->x, a->y + b->y}; }
static double length2(const point *a) { return a->x * a->x + a->y * a->y; }

static double energy(const bar *b, const point *com, const point *velocity, double rate)
{
  return b->mass * length2(velocity) / 2 + b->inertia * rate * rate / 2 - 9.81 * b->mass * com->y;
}

double linkage(const double q[BARS], const double qd[BARS])
{
  const bar *b = bars;
  point joint = *POLAR(b[CRANK].length, q[CRANK]), joint_velocity = *MOVED(b[CRANK].length, q[CRANK], qd[CRANK]);
  double total = energy(&b[CRANK], POLAR(b[CRANK].com, q[CRANK]), MOVED(b[CRANK].com, q[CRANK], qd[CRANK]), qd[CRANK]);

  total += energy(&b[COUPLER],
                  &(point){sum(&joint, POLAR(b[COUPLER].com, q[COUPLER])).x, sum(&joint, POLAR(b[COUPLER].com, q[COUPLER])).y},
                  &(point){sum(&joint_velocity, MOVED(b[COUPLER].com, q[COUPLER], qd[COUPLER])).x,
                           sum(&joint_velocity, MOVED(b[COUPLER].com, q[COUPLER], qd[COUPLER])).y},
                  qd[COUPLER]);
  point rocker = sum(&pivot, POLAR(b[ROCKER].com, q[ROCKER]));
  total += energy(b + ROCKER, &rocker, MOVED(b[ROCKER].com, q[ROCKER], qd[ROCKER]), qd[ROCKER]);
  double twist = q[ROCKER] - 1.4;
  return total - 2.0 * twist * twist / 2; /* torsion spring at the rocker's pivot */
}

void loop_closure(const double q[BARS], double out[2])
{
  point through_coupler = sum(POLAR(bars[CRANK].length, q[CRANK]), POLAR(bars[COUPLER].length, q[COUPLER]));
  point through_rocker = sum(&pivot, POLAR(bars[ROCKER].length, q[ROCKER]));
  out[0] = through_coupler.x - through_rocker.x;
  out[1] = through_coupler.y - through_rocker.y;
}

void motor(const double qd[BARS], double t, double out[BARS])
{
  out[CRANK] = 0.3 * (1 - exp(-t)) - 0.05 * qd[CRANK];
  out[COUPLER] = out[ROCKER] = 0;
}
