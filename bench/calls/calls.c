/* The reference among the generated forms: jets carried forward by calls on libtaylor, assembled and solved by the runtime. Built with
 * -DMODEL=name. */
#include <eom/eom.h>

#include "parameters.h"

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

extern const eom_model JOIN(MODEL, _model);

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  eom_system *sys = self;
  if (eom_acceleration(sys, q, qd, 0.0) != EOM_OK) return 1;
  memcpy(qdd, sys->qdd, (size_t)sys->n * sizeof *qdd);
  return 0;
}

static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  eom_system *sys = self;
  if (eom_linearise(sys, q, qd, 0.0) != EOM_OK) return 1;
  memcpy(qdd, sys->qdd, (size_t)sys->n * sizeof *qdd);
  memcpy(qdd_y, sys->qdd_y, 2 * (size_t)sys->n * (size_t)sys->n * sizeof *qdd_y);
  return 0;
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  static struct MODEL p;
  eom_system *sys;
  p = JOIN(MODEL, _parameters)(problem);
  if (eom_system_create(&sys, &JOIN(MODEL, _model), &p, NULL) != EOM_OK) return 1;
  *contender = (bench_contender){.self = sys, .lanes = 1, .acceleration = acceleration, .jacobian = jacobian};
  return 0;
}
