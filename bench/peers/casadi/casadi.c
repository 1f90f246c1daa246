/* CasADi's generated C as a contender. Built with -DNEED_F, -DNEED_J or -DNEED_V and GENERATED on the include path as generated.c. */
#include "generated.c"

#include "contender.h"

static casadi_int integers[evaluate_SZ_IW + 1];
static double work[evaluate_SZ_W + 1];

#ifdef NEED_F
static int acceleration(void *self, const double *q, const double *qd, double *qdd) {
  const double *arg[evaluate_SZ_ARG] = {q, qd};
  double *res[evaluate_SZ_RES] = {qdd};
  (void)self;
  return evaluate(arg, res, integers, work, 0);
}
#define MEMBER .acceleration = acceleration
#elif defined NEED_J
static int jacobian(void *self, const double *q, const double *qd, double *qdd, double *qdd_y) {
  const double *arg[evaluate_SZ_ARG] = {q, qd};
  double *res[evaluate_SZ_RES] = {qdd, qdd_y};
  (void)self;
  return evaluate(arg, res, integers, work, 0);
}
#define MEMBER .jacobian = jacobian
#else
static int directional(void *self, const double *q, const double *qd, const double *w, double *qdd, double *dqdd) {
  const double *arg[evaluate_SZ_ARG] = {q, qd, w};
  double *res[evaluate_SZ_RES] = {qdd, dqdd};
  (void)self;
  return evaluate(arg, res, integers, work, 0);
}
#define MEMBER .directional = directional
#endif

int bench_open(const bench_case *problem, bench_contender *contender) {
  (void)problem;
  *contender = (bench_contender){.lanes = 1, MEMBER};
  return 0;
}
