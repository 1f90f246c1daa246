/* CasADi's generated C as a contender. Built with -DNEED_F, -DNEED_J or -DNEED_V and GENERATED on the include path as generated.c. */
#include "generated.c"

#include "contender.h"

/* The generated code asks of each pointer whether it is null and reads its inputs anew after each output: the compiler may know that no
 * pointer is null, and that no output overlaps an input. It then takes each angle's sine and cosine once. */
#define KNOWING(...) __attribute__((flatten, nonnull(__VA_ARGS__)))

static casadi_int integers[evaluate_SZ_IW + 1];
static double work[evaluate_SZ_W + 1];

#ifdef NEED_F
KNOWING(2, 3, 4) static int acceleration(void *self, const double *restrict q, const double *restrict qd, double *restrict qdd) {
  const double *arg[evaluate_SZ_ARG] = {q, qd};
  double *res[evaluate_SZ_RES] = {qdd};
  (void)self;
  return evaluate(arg, res, integers, work, 0);
}
#define MEMBER .acceleration = acceleration
#elif defined NEED_J
KNOWING(2, 3, 4, 5)
static int jacobian(void *self, const double *restrict q, const double *restrict qd, double *restrict qdd, double *restrict qdd_y) {
  const double *arg[evaluate_SZ_ARG] = {q, qd};
  double *res[evaluate_SZ_RES] = {qdd, qdd_y};
  (void)self;
  return evaluate(arg, res, integers, work, 0);
}
#define MEMBER .jacobian = jacobian
#else
KNOWING(2, 3, 4, 5, 6)
static int directional(void *self, const double *restrict q, const double *restrict qd, const double *restrict w, double *restrict qdd,
                       double *restrict dqdd) {
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
