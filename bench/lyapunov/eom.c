/* The spectrum by eom_lyapunov on what tlgen generates for the pendulum. Built with -DLINKS=n. Tangents have a tolerance of their own,
 * as loose as exponents allow that are uncertain by percents: 1e-4, or what the environment's TANGENTS says. */
#include "spectrum.h"

#include "pendulum.h"
#include "pendulum_tl.h"

#include <eom/eom.h>

static int look(void *observer, const eom_lyapunov *ly) {
  spectrum_check(observer, ly->y);
  return 0;
}

static int spectrum_run(double t_end, double tolerance, spectrum *result) {
  struct pendulum p = {.n = LINKS, .g = GRAVITY};
  double y[D];
  eom_system *sys;
  eom_lyapunov *ly;
  for (int i = 0; i < LINKS; i++) p.mass[i] = p.length[i] = 1.0;
  spectrum_start(y);
  if (eom_system_create(&sys, &pendulum_model, &p, NULL) != EOM_OK) return 1;
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.interval = 1.0;
  options.control = (eom_step_control){.rtol = tolerance, .atol = tolerance};
  const char *tangents = getenv("TANGENTS");
  options.tangent_tolerance = tangents ? atof(tangents) : 1e-4;
  eom_status status = eom_lyapunov_create(&ly, sys, &options, 0.0, y);
  if (status == EOM_OK) {
    status = eom_lyapunov_to(ly, t_end, look, result);
    for (int i = 0; i < D; i++) result->rho[i] = ly->rho[i];
    result->t = ly->t;
    result->steps = ly->it.steps;
    eom_lyapunov_destroy(ly);
  }
  eom_system_destroy(sys);
  return status != EOM_OK;
}
