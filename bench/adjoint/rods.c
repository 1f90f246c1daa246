/* tlgen's solved form of constrained equations as a contender. Built with the generated source as GENERATED. */
#include GENERATED

#include "cartesian.h"

#include <stdlib.h>

void *adjoint_parameters(const bench_case *problem); /* parameters.c */

/* One case, with its results beside the accelerations. */
typedef struct chain {
  void *params;
  int n;
  const double *length;
  tl_real *work, *lambda, *Qc;
} chain;

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  const chain *c = self;
  return cartesian_pendulum_constrained(c->params, q, qd, 0.0, qdd, c->lambda, c->Qc, c->work);
}

static void to_native(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd,
                      double *native_w) {
  const chain *c = self;
  (void)w, (void)native_w;
  cartesian_state(c->n, c->length, q, qd, native_q, native_qd);
}

static void from_native(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd) {
  const chain *c = self;
  (void)need, (void)qd, (void)qdd_y, (void)dqdd;
  angular_accelerations(c->n, c->length, q, qdd);
}

static tl_real *numbers(size_t count) {
  const size_t bytes = (count * sizeof(tl_real) + EOM_MOTION_ALIGNMENT) / EOM_MOTION_ALIGNMENT * EOM_MOTION_ALIGNMENT;
  return aligned_alloc(EOM_MOTION_ALIGNMENT, bytes);
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  static chain c;
  c = (chain){.params = adjoint_parameters(problem), .n = problem->n, .length = problem->length};
  c.work = numbers(cartesian_pendulum_motion.work), c.lambda = numbers((size_t)c.n), c.Qc = numbers(2 * (size_t)c.n);
  if (!c.work || !c.lambda || !c.Qc || !cartesian_pendulum_motion.fits(c.params)) return 1;
  *contender = (bench_contender){
      .self = &c, .lanes = 1, .acceleration = acceleration, .to_native = to_native, .from_native = from_native, .coordinates = 2 * c.n};
  return 0;
}
