/* tlgen's motion functions as a contender. Built with -DMODEL=name, and with the generated source as GENERATED; with -DBENCH_LANES for
 * those of several states at once. */
#include GENERATED

#include "contender.h"

#include <stdlib.h>

#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)

void *adjoint_parameters(const bench_case *problem); /* parameters.c */

#ifdef BENCH_LANES
#define NUMBER tl_lanes
#define FUNCTION(name) JOIN(MODEL, name##_lanes)
#define AT_ZERO (&(const tl_lanes){0.0})
enum { STATES = TL_LANES };
#else
#define NUMBER tl_real
#define FUNCTION(name) JOIN(MODEL, name)
#define AT_ZERO 0.0
enum { STATES = 1 };
#endif

static NUMBER *work;

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  return FUNCTION(_acceleration)(self, (const NUMBER *)q, (const NUMBER *)qd, AT_ZERO, (NUMBER *)qdd, work);
}

static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  return FUNCTION(_jacobian)(self, (const NUMBER *)q, (const NUMBER *)qd, AT_ZERO, (NUMBER *)qdd, (NUMBER *)qdd_y, work);
}

static int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  return FUNCTION(_directional)(self, (const NUMBER *)q, (const NUMBER *)qd, AT_ZERO, 1, (const NUMBER *)w, (NUMBER *)qdd,
                                (NUMBER *)dqdd, work);
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  size_t bytes = (JOIN(MODEL, _motion).work * sizeof *work + EOM_MOTION_ALIGNMENT) / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT;
  void *p = adjoint_parameters(problem);
  work = aligned_alloc(EOM_MOTION_ALIGNMENT, bytes);
  if (work == NULL || !JOIN(MODEL, _motion).fits(p)) return 1;
  *contender =
      (bench_contender){.self = p, .lanes = STATES, .acceleration = acceleration, .jacobian = jacobian, .directional = directional};
  return 0;
}
