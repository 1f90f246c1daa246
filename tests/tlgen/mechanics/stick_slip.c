// Blocks on a moving belt, coupled by springs: a list of elements of several kinds.

#include "stick_slip.h"

#include <assert.h>
#include <math.h>

const struct Rig kBrakeRig = {
    .num_blocks = 3,
    .mass = {1.0, 0.6, 1.4},
    .belt_speed = 0.35,
    .strobe = 7.0,
    .stribeck = 0.4,
    .num_elements = 9,
    .elements =
        {
            {kSpring, kGround, 0, 40.0, 0.1},
            {kSpring, 0, 1, 25.0, 0.3},
            {kSpring, 1, 2, 30.0, 0.25},
            {kDamper, kGround, 0, 0.2},
            {kDamper, 0, 1, 0.3},
            {kBeltFriction, kGround, 0, 3.5, 0.02},
            {kBeltFriction, kGround, 1, 2.0, 0.05},
            {kBeltFriction, kGround, 2, 4.5, 0.1},
            {kAirDrag, kGround, 2, 0.7},
        },
};

static double At(const double* x, int block) { return block == kGround ? 0.0 : x[block]; }

// Friction of a dry contact at a relative speed: Coulomb's with a steep tanh, falling with speed as Stribeck has it.
static double DryFriction(double normal_force, double width, double stribeck, double speed) {
  return normal_force * tanh(speed / width) * (1.0 - stribeck + stribeck * exp(-fabs(speed)));
}

// The force that the element exerts on its second end.
static double ElementForce(const struct Element* e, const double* qd, double belt, double stribeck) {
  const double rate = At(qd, e->to) - At(qd, e->from);
  switch (e->kind) {
    case kDamper:
      return -e->coefficient * rate;
    case kBeltFriction:
      return -DryFriction(e->coefficient, e->extra, stribeck, rate - belt);
    case kAirDrag:
      return -e->coefficient * rate * fabs(rate);
    case kSpring:  // in the potential
    default:
      return 0.0;
  }
}

double RigEnergyDifference(const double* q, const double* qd, const struct Rig* rig) {
  double difference = 0.0;
  for (int i = 0; i < rig->num_blocks; ++i) difference += 0.5 * rig->mass[i] * qd[i] * qd[i];
  for (int i = 0; i < rig->num_elements; ++i) {
    const struct Element* e = &rig->elements[i];
    if (e->kind != kSpring) continue;
    const double stretch = At(q, e->to) - At(q, e->from) - e->extra;
    difference -= 0.5 * e->coefficient * stretch * stretch;
  }
  return difference;
}

void RigForces(const double* q, const double* qd, double t, const struct Rig* rig, double* out) {
  const double belt = rig->belt_speed * (1.0 + 0.1 * sin(rig->strobe * t));
  (void)q;
  for (int i = 0; i < rig->num_blocks; ++i) out[i] = 0.0;
  for (int i = 0; i < rig->num_elements; ++i) {
    const struct Element* e = &rig->elements[i];
    const double force = ElementForce(e, qd, belt, rig->stribeck);
    out[e->to] += force;
    if (e->from != kGround) out[e->from] -= force;
  }
}
