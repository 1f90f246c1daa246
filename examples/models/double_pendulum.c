/* Lagrangian of the double pendulum in relative angles: each bar carries a pose from hinge to hinge. */
#include "double_pendulum.h"

#include <math.h>

typedef struct Vec2 {
  double x, y;
} Vec2;

/* Where a hinge is, how it moves, and how the bar below it is turned. */
typedef struct Pose {
  Vec2 pos, vel;
  double angle, rate;
} Pose;

static Vec2 add(Vec2 a, Vec2 b) {
  Vec2 c = {a.x + b.x, a.y + b.y};
  return c;
}

/* The point at distance s along the bar of pose at. */
static Pose along(Pose at, double s) {
  const Vec2 arm = {s * sin(at.angle), -s * cos(at.angle)};
  const Vec2 swing = {-at.rate * arm.y, at.rate * arm.x};
  at.pos = add(at.pos, arm);
  at.vel = add(at.vel, swing);
  return at;
}

static Pose turn(Pose at, double angle, double rate) {
  at.angle += angle;
  at.rate += rate;
  return at;
}

static double bar_lagrangian(Pose hinge, const Bar *bar, double gravity) {
  const Pose centre = along(hinge, bar->centre);
  const double speed2 = centre.vel.x * centre.vel.x + centre.vel.y * centre.vel.y;
  return 0.5 * bar->mass * speed2 + 0.5 * bar->inertia * hinge.rate * hinge.rate - bar->mass * gravity * centre.pos.y;
}

double double_pendulum_lagrangian(const double *q, const double *qd, const DoublePendulum *p) {
  const Pose pivot = {{0.0, 0.0}, {0.0, 0.0}, 0.0, 0.0};
  const Pose shoulder = turn(pivot, q[0], qd[0]);
  const Pose elbow = turn(along(shoulder, p->upper.length), q[1], qd[1]);
  return bar_lagrangian(shoulder, &p->upper, p->gravity) + bar_lagrangian(elbow, &p->lower, p->gravity);
}
