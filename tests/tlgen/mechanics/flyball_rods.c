/* The flyball governor of the examples with rods that do not give in place of its springs. */
#include "../../../examples/models/flyball.c"

static const flyball *with_rods(void) {
  static flyball p;
  p = flyball_parameters();
  p.stiffness = 0.0;
  p.damping = 40.0;
  return &p;
}

void rods(const double *q, const flyball *p, double *out) {
  for (int i = 0; i < FLYBALL_ARMS; i++) out[i] = spring_of(q, i, p).length - p->rest;
}
