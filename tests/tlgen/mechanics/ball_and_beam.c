/* Ball on a motor-driven beam. Inheritance in C: the base is the first member, methods take self. */
#include <math.h>

typedef struct Body {
  double mass, inertia;
} Body;

typedef struct Ball {
  Body base;
  double rolling_radius, rise; /* of its centre over the beam's axis */
} Ball;

typedef struct Beam {
  Body base;
  Ball ball;
  double gain[4];
} Beam;

static double Body_kinetic(const Body *self, double speed2, double spin) {
  return 0.5 * (self->mass * speed2 + self->inertia * spin * spin);
}

static double Body_weight(const Body *self) { return 9.81 * self->mass; }

static const Beam bench = {
  .base = {.inertia = 0.03},
  .ball = {.base = {0.11, 1.76e-5}, .rolling_radius = 0.013, .rise = 0.02},
  .gain = {8.0, 5.0, 25.0, 4.0},
};

static double Ball_speed2(const Ball *self, double along, double rate, double turn) {
  double forward = rate - self->rise * turn, across = along * turn;
  return forward * forward + across * across;
}

static double Ball_height(const Ball *self, double along, double angle) { return along * sin(angle) + self->rise * cos(angle); }

static double Ball_kinetic(const Ball *self, double along, double rate, double turn) {
  return Body_kinetic(&self->base, Ball_speed2(self, along, rate, turn), turn - rate / self->rolling_radius);
}

double Beam_lagrangian(const double *q, const double *qd) {
  const Beam *self = &bench;
  const Ball *ball = &self->ball;
  double energy = Body_kinetic(&self->base, 0.0, qd[1]);

  energy += Ball_kinetic(ball, q[0], qd[0], qd[1]);
  return energy - Body_weight(&ball->base) * Ball_height(ball, q[0], q[1]);
}

void Beam_torque(const double *q, const double *qd, double t, double *out) {
  const Beam *self = &bench;
  const double error[4] = {q[0] - 0.1 * cos(t), qd[0], q[1], qd[1]};
  double command = 0.0;
  const double *gain, *e = error;

  for (gain = self->gain; gain < self->gain + 4; gain++) command -= *gain * *e++;
  out[0] = 0.0;
  out[1] = 2.0 * tanh(0.5 * command);
}
