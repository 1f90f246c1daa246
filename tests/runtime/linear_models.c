/* Lagrangians, constraints and forces of the mechanisms with closed forms. */
#include "linear_models.h"

#include <math.h>

double conical_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double around = q[0] * qd[1];
  return 0.5 * p->mass * (qd[0] * qd[0] + around * around + qd[2] * qd[2]) - p->mass * p->gravity * q[2];
}

double conical_rod(const double *q, const linear_model *p) { return hypot(q[0], q[2]) - p->length; }

double top_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double around = q[0] * qd[2], tilting = qd[2] * sin(q[3]), spinning = qd[4] + qd[2] * cos(q[3]);
  const double translation = 0.5 * p->mass * (qd[0] * qd[0] + qd[1] * qd[1] + around * around);
  const double rotation = 0.5 * p->across * (qd[3] * qd[3] + tilting * tilting) + 0.5 * p->along * spinning * spinning;
  return translation + rotation - p->mass * p->gravity * q[1];
}

void top_tip(const double *q, const linear_model *p, double *out) {
  out[0] = q[0] - p->length * sin(q[3]);
  out[1] = q[1] - p->length * cos(q[3]);
}

double sleeping_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double speed2 = qd[0] * qd[0] + qd[1] * qd[1] + qd[2] * qd[2];
  const double gyroscopic = p->along * p->spin * (q[0] * qd[1] - q[1] * qd[0]) / (1.0 + q[2]);
  return 0.5 * p->across * speed2 + gyroscopic - p->mass * p->gravity * p->length * q[2];
}

double sleeping_unit(const double *q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] - 1.0; }

enum { X, Y, YAW, LEAN, ROLL };

double disk_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double r = p->length, about_diameter = 0.25 * p->mass * r * r, rise = -r * sin(q[LEAN]) * qd[LEAN];
  const double turning = qd[YAW] * cos(q[LEAN]), rolling = qd[ROLL] + qd[YAW] * sin(q[LEAN]);
  const double translation = 0.5 * p->mass * (qd[X] * qd[X] + qd[Y] * qd[Y] + rise * rise);
  const double rotation = 0.5 * about_diameter * (qd[LEAN] * qd[LEAN] + turning * turning + 2.0 * rolling * rolling);
  return translation + rotation - p->mass * p->gravity * r * cos(q[LEAN]);
}

/* The centre moves with roll along the heading; it hangs over sideways by r sin(lean). */
void disk_rolls(const double *q, const double *qd, const linear_model *p, double *out) {
  const double r = p->length, s = sin(q[YAW]), c = cos(q[YAW]);
  const double ahead = r * (qd[ROLL] + qd[YAW] * sin(q[LEAN])), sideways = r * cos(q[LEAN]) * qd[LEAN];
  out[0] = qd[X] - ahead * c - sideways * s;
  out[1] = qd[Y] - ahead * s + sideways * c;
}

double chaplygin_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double vx = qd[0] - p->length * qd[2] * sin(q[2]), vy = qd[1] + p->length * qd[2] * cos(q[2]);
  return 0.5 * p->mass * (vx * vx + vy * vy) + 0.5 * p->across * qd[2] * qd[2];
}

double chaplygin_blade(const double *q, const double *qd) { return qd[0] * sin(q[2]) - qd[1] * cos(q[2]); }

double crane_lagrangian(const double *q, const double *qd, const linear_model *p) {
  const double kinetic = 0.5 * p->cart * qd[0] * qd[0] + 0.5 * p->mass * (qd[1] * qd[1] + qd[2] * qd[2]);
  return kinetic - p->mass * p->gravity * q[2];
}

double crane_rod(const double *q, const linear_model *p) { return hypot(q[1] - q[0], q[2]) - p->length; }

void crane_push(const double *q, const double *qd, const linear_model *p, double *out) {
  (void)q;
  out[0] = p->push - p->damping * qd[0];
}
