/* The spectrum by eom_lyapunov on what tlgen generates for the pendulum. Built with -DLINKS=n. Tangents have a tolerance of their own,
 * as loose as exponents allow that are uncertain by percents: 1e-4, or what the environment's TANGENTS says. SERIES in the environment:
 * the motion by Taylor series, where the model was printed for them. EXPONENTS=k in the
 * environment: the first k alone, or for 0 the motion alone; how they are computed, and how many evaluations that took, is told on
 * stderr. */
#include "spectrum.h"

#include "pendulum.h"
#include "pendulum_tl.h"

#include <eom/eom.h>

static int look(void *observer, const eom_lyapunov *ly) {
  spectrum_check(observer, ly->y);
  return 0;
}

/* The motion alone, from mark to mark. */
static int motion_run(eom_system *sys, const eom_lyapunov_options *o, const double *y, double t_end, spectrum *result) {
  static double work[EOM_INTEGRATOR_SIZE(12, 3, D)]; /* of eom_dop853 */
  eom_integrator it;
  eom_integrator_init(&it, &eom_dop853, eom_rhs, sys, D, 0.0, y, 0.0, work);
  eom_status status = eom_integrator_control(&it, &o->control);
  for (double t = o->interval; status == EOM_OK && t <= t_end; t += o->interval) {
    status = eom_integrate(&it, t, NULL, NULL);
    eom_integrator_restart(&it);
    spectrum_check(result, it.y);
  }
  result->t = it.t;
  result->steps = it.steps;
  fprintf(stderr, "motion %ld\n", it.evaluations);
  return status != EOM_OK;
}

static int exponents_run(eom_system *sys, const eom_lyapunov_options *o, const double *y, double t_end, spectrum *result) {
  eom_lyapunov *ly;
  eom_status status = eom_lyapunov_create(&ly, sys, o, 0.0, y);
  if (status != EOM_OK) return 1;
  status = eom_lyapunov_to(ly, t_end, look, result);
  for (int i = 0; i < ly->k; i++) result->rho[i] = ly->rho[i];
  result->t = ly->t;
  result->steps = ly->it.steps;
  if (getenv("EXPONENTS"))
    fprintf(stderr, "%s %ld\n", ly->options.product == EOM_LYAPUNOV_BY_JACOBIAN ? "Jacobian" : "directions",
            ly->tangents.dim > 0 ? ly->tangents.evaluations : ly->it.evaluations);
  eom_lyapunov_destroy(ly);
  return status != EOM_OK;
}

static int spectrum_run(double t_end, double tolerance, spectrum *result) {
  struct pendulum p = {.n = LINKS, .g = GRAVITY};
  const char *tangents = getenv("TANGENTS"), *exponents = getenv("EXPONENTS");
  double y[D];
  eom_system *sys;
  for (int i = 0; i < LINKS; i++) p.mass[i] = p.length[i] = 1.0;
  spectrum_start(y);
  eom_options needs = eom_options_default();
  if (exponents) needs.needs |= EOM_NEED_TANGENT;
  if (eom_system_create(&sys, &pendulum_model, &p, &needs) != EOM_OK) return 1;
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.interval = 1.0;
  options.k = exponents ? atoi(exponents) : D;
  options.control = (eom_step_control){.rtol = tolerance, .atol = tolerance};
  options.taylor = getenv("SERIES") != NULL;
  options.tangent_tolerance = tangents ? atof(tangents) : 1e-4;
  const int failed = (options.k > 0 ? exponents_run : motion_run)(sys, &options, y, t_end, result);
  eom_system_destroy(sys);
  return failed;
}
