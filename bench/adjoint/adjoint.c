/* tlgen's motion functions as a contender. Built with -DMODEL=name, and with the generated source as GENERATED. */
#include GENERATED

#include "contender.h"

#include <stdlib.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

void *adjoint_parameters(const bench_case *problem); /* parameters.c */

static tl_real *work;

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  return JOIN(MODEL, _acceleration)(self, q, qd, 0.0, qdd, work);
}

static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  return JOIN(MODEL, _jacobian)(self, q, qd, 0.0, qdd, qdd_y, work);
}

static int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  return JOIN(MODEL, _directional)(self, q, qd, 0.0, 1, w, qdd, dqdd, work);
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  size_t bytes = (JOIN(MODEL, _motion).work * sizeof *work + EOM_MOTION_ALIGNMENT) / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT;
  void *p = adjoint_parameters(problem);
  work = aligned_alloc(EOM_MOTION_ALIGNMENT, bytes);
  if (work == NULL || !JOIN(MODEL, _motion).fits(p)) return 1;
  *contender = (bench_contender){.self = p, .lanes = 1, .acceleration = acceleration, .jacobian = jacobian, .directional = directional};
  return 0;
}
