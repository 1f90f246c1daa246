#ifndef STICK_SLIP_H_
#define STICK_SLIP_H_

enum ElementKind { kSpring, kDamper, kBeltFriction, kAirDrag, kNumKinds };

enum { kGround = -1 };

/* One element of the model between two blocks, or a block and the ground. */
struct Element {
  enum ElementKind kind;
  int from, to;
  double coefficient; /* N/m, N s/m, N, N s^2/m^2 */
  double extra;       /* rest length, m; unused; regularisation, m/s; unused */
};

struct Rig {
  int num_blocks;
  double mass[3];
  double belt_speed;
  double strobe; /* rad/s: the belt's speed wavers */
  double stribeck; /* how much of the friction is lost at speed */
  int num_elements;
  struct Element elements[9];
};

double RigEnergyDifference(const double* q, const double* qd, const struct Rig* rig);
void RigForces(const double* q, const double* qd, double t, const struct Rig* rig, double* out);

#endif  // STICK_SLIP_H_
