/* A stiff mechanism, the flyball governor, whose fastest motion decays at 4e4 1/s while its shaft turns once a second: backward
 * differences with the exact Jacobian take steps that explicit methods cannot. And projected ones, of Andrews' mechanism. */
#include "andrews.h"
#include "andrews_tl.h"
#include "close.h"
#include "flyball.h"
#include "flyball_tl.h"

#include "eom/eom.h"
#include "eom/trajectory.h"

#include <math.h>
#include <string.h>

/* At 1 s, in quad precision. */
static const double truth[8] = {5.5863469658690051897, 0.5218333016255462757,  0.5218333016255462757,  0.50142092237956761202,
                                6.2711257418765544868, 0.14088557947952688734, 0.14088557947952688734, -0.12215149289772888287};

static eom_trajectory_work run(eom_system *sys, const char *method, double tolerance, double *error) {
  double y[8];
  flyball_start(y, y + 4);
  const eom_trajectory_options options = {.method = method, .control = {.rtol = tolerance, .atol = tolerance}};
  eom_trajectory *r;
  assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y), EOM_OK);
  assert_int_equal(eom_trajectory_to(r, 1.0, NULL, NULL), EOM_OK);
  *error = 0;
  for (int i = 0; i < 8; i++) *error = fmax(*error, fabs(eom_trajectory_state(r)[i] - truth[i]));
  const eom_trajectory_work work = eom_trajectory_worked(r);
  print_message("%-16s tolerance %.0e: error %.1e, %ld steps, %ld evaluations, %ld Jacobians\n", method, tolerance, *error, work.steps,
                work.evaluations, work.jacobians);
  eom_trajectory_destroy(r);
  return work;
}

static void backward_differences_take_long_steps(void **state) {
  (void)state;
  const flyball p = flyball_parameters();
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &flyball_model, &p, NULL), EOM_OK);
  double error, least = (double)INFINITY;
  const eom_trajectory_work explicit = run(sys, "dp5", 1e-5, &error);
  for (double tolerance = 1e-5; tolerance > 1e-8; tolerance /= 100) {
    const eom_trajectory_work work = run(sys, "cvode_bdf", tolerance, &error);
    assert_true(error < 1e3 * tolerance && error < least);
    assert_true(10 * work.evaluations < explicit.evaluations);
    assert_true(4 * work.jacobians < work.steps);
    least = error;
  }
  eom_system_destroy(sys);
}

/* At 0.03 s, in quad precision. What projection leaves of rounding in large velocities is more than these tolerances of small ones: by
 * estimates that count it steps go on without end. */
static void rounding_of_projections_does_not_shorten_steps(void **state) {
  (void)state;
  static const double there[7] = {15.810771195153710223,  -15.756371058411843368, 0.040822240119645865136, -0.53473011634207954027,
                                  0.52440996587995406456, 0.53473011634207954027, 1.0480807410419378676};
  const andrews p = andrews_parameters();
  double y[14], last = (double)INFINITY;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &andrews_model, &p, NULL), EOM_OK);
  andrews_start(y, y + 7);
  for (double tolerance = 1e-12; tolerance > 5e-15; tolerance /= 10) {
    const eom_trajectory_options options = {
        .method = "cvode_bdf", .control = {.rtol = tolerance, .atol = tolerance, .most_steps = 10000}, .project = 1};
    eom_trajectory *r;
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y), EOM_OK);
    assert_int_equal(eom_trajectory_to(r, 0.03, NULL, NULL), EOM_OK);
    double error = 0;
    for (int i = 0; i < 7; i++) error = fmax(error, fabs(eom_trajectory_state(r)[i] / there[i] - 1));
    print_message("Andrews, tolerance %.0e: error %.1e, %ld steps\n", tolerance, error, eom_trajectory_worked(r).steps);
    assert_true(error < 1e4 * tolerance && error < last);
    last = error;
    eom_trajectory_destroy(r);
  }
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(backward_differences_take_long_steps),
                                     cmocka_unit_test(rounding_of_projections_does_not_shorten_steps)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
