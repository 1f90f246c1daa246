/* Published multibody benchmarks against solutions in quad precision. */
#include "andrews.h"
#include "andrews_tl.h"
#include "close.h"
#include "flyball.h"
#include "flyball_tl.h"

#include "eom/eom.h"

#include <stdio.h>
#include <stdlib.h>

/* The state at t_end, in y, and the largest |phi| and |phi_dot| there. */
static void run(const eom_model *model, const void *params, double step, double t_end, double *y) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  double *work = malloc(eom_integrator_size(&eom_dp5, 2 * sys->n) * sizeof *work);
  assert_non_null(work);
  assert_int_equal(eom_project(sys, y, y + sys->n, 0.0, NULL), EOM_OK);
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, eom_rhs, sys, 2 * sys->n, 0.0, y, step, work);
  if (sys->m > 0) it.correct = eom_project_state;
  assert_int_equal(eom_integrate(&it, t_end, NULL, NULL), EOM_OK);
  for (int i = 0; i < 2 * sys->n; i++) y[i] = it.y[i];
  free(work);
  eom_system_destroy(sys);
}

/* At 0.03 s, from a solution in quad precision whose digits agree at two tolerances; the published ones differ by up to 1e-9. */
static void andrews_squeezing_mechanism(void **state) {
  (void)state;
  static const double truth[7] = {15.810771195153710223,  -15.756371058411843368, 0.040822240119645865136, -0.53473011634207954027,
                                  0.52440996587995406456, 0.53473011634207954027, 1.0480807410419378676};
  const andrews p = andrews_parameters();
  double y[14];
  andrews_start(y, y + 7);
  run(&andrews_model, &p, 2.5e-6, 0.03, y);
  for (int i = 0; i < 7; i++) assert_close(y[i], truth[i], 1e-10, 0.0);
}

/* At 1 s; the fastest motion has an eigenvalue of -4e4 1/s. */
static void flyball_governor(void **state) {
  (void)state;
  static const double truth[8] = {5.5863469658690051897, 0.5218333016255462757,  0.5218333016255462757,  0.50142092237956761202,
                                  6.2711257418765544868, 0.14088557947952688734, 0.14088557947952688734, -0.12215149289772888287};
  const flyball p = flyball_parameters();
  double y[8];
  flyball_start(y, y + 4);
  run(&flyball_model, &p, 4e-5, 1.0, y);
  for (int i = 0; i < 8; i++) assert_close(y[i], truth[i], 1e-10, 0.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(andrews_squeezing_mechanism), cmocka_unit_test(flyball_governor)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
