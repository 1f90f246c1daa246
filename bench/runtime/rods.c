/* The runtime as a contender: eom_acceleration of the chain in Cartesian coordinates. With -DGENERAL its general solver alone, which
 * reveals the rank of the constraints and estimates their condition. */
#include "cartesian.h"
#include "cartesian_pendulum_tl.h"
#include "parameters.h"

#include <eom/eom.h>

static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  eom_system *sys = self;
  if (eom_acceleration(sys, q, qd, 0.0) != EOM_OK) return 1;
  memcpy(qdd, sys->qdd, (size_t)sys->n * sizeof *qdd);
  return 0;
}

static const struct cartesian_pendulum *chain(const eom_system *sys) { return sys->params; }

static void to_native(void *self, const double *q, const double *qd, const double *w, double *native_q, double *native_qd,
                      double *native_w) {
  (void)w, (void)native_w;
  cartesian_state(chain(self)->links, chain(self)->length, q, qd, native_q, native_qd);
}

static void from_native(void *self, char need, const double *q, const double *qd, double *qdd, double *qdd_y, double *dqdd) {
  (void)need, (void)qd, (void)qdd_y, (void)dqdd;
  angular_accelerations(chain(self)->links, chain(self)->length, q, qdd);
}

int bench_open(const bench_case *problem, bench_contender *contender) {
  static struct cartesian_pendulum p;
  static eom_motion motion;
  static const eom_motion *motions[] = {&motion};
  static eom_model model;
  p = cartesian_pendulum_parameters(problem);
  motion = cartesian_pendulum_motion;
#ifdef GENERAL
  motion.constrained = NULL;
#endif
  model = cartesian_pendulum_model;
  model.motion = motions;
  eom_system *sys;
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  options.emitter = EOM_EMITTER_MOTION;
  if (eom_system_create(&sys, &model, &p, &options) != EOM_OK) return 1;
  *contender = (bench_contender){
      .self = sys, .lanes = 1, .acceleration = acceleration, .to_native = to_native, .from_native = from_native, .coordinates = sys->n};
  return 0;
}
