/* Baumgarte's stabilisation: a state beside the constraints tends to them as its gains say, contradictions come to light, what it
 * cannot serve is refused, energy does not know it. */
#include "close.h"
#include "constrained_models.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>

static eom_system *start(const eom_model *model, const void *params, double alpha, double beta) {
  eom_options options = eom_options_default();
  options.baumgarte = (eom_baumgarte){alpha, beta};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  return sys;
}

/* The state y after time t. */
static void run(eom_system *sys, double t, double step, double *y) {
  double *work = malloc(eom_integrator_size(&eom_dp5, 2 * sys->n) * sizeof *work);
  assert_non_null(work);
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, eom_rhs, sys, 2 * sys->n, 0, y, step, work);
  assert_int_equal(eom_integrate(&it, t, NULL, NULL), EOM_OK);
  for (int i = 0; i < 2 * sys->n; i++) y[i] = it.y[i];
  free(work);
}

/* Integration at this step is exact to about 1e-13; phi is a difference of numbers near 1. */
#define STEP 1e-3
#define DECAY_TOLERANCE 1e-12

/* phi(t) of phi'' + 2 a phi' + b^2 phi = 0 from phi(0), phi'(0): critically damped, damped and undamped. */
static double decay(double a, double b, double phi, double rate, double t) {
  if (a == b) return exp(-a * t) * (phi + (rate + a * phi) * t);
  if (a > b) {
    const double w = sqrt(a * a - b * b);
    return exp(-a * t) * (phi * cosh(w * t) + (rate + a * phi) / w * sinh(w * t));
  }
  const double w = sqrt(b * b - a * a);
  return exp(-a * t) * (phi * cos(w * t) + (rate + a * phi) / w * sin(w * t));
}

static void violation_decays_as_the_gains_say(void **state) {
  (void)state;
  static const double gains[][2] = {{4, 4}, {6, 2}, {1, 7}, {0, 3}, {3, 0}};
  for (size_t k = 0; k < sizeof gains / sizeof gains[0]; k++) {
    eom_system *sys = start(&cartesian_double_pendulum, NULL, gains[k][0], gains[k][1]);
    double y[8] = {0.6, -0.7, 1.2, -1.6, 0.3, 0.5, -0.4, 0.2};
    assert_int_equal(eom_assemble(sys, y, y + 4, 0), EOM_OK);
    double phi[2], rate[2];
    for (int r = 0; r < 2; r++) phi[r] = sys->phi[r], rate[r] = sys->phi_dot[r];
    for (int at = 1; at <= 4; at++) {
      run(sys, 0.25, STEP, y);
      assert_int_equal(eom_assemble(sys, y, y + 4, 0), EOM_OK);
      for (int r = 0; r < 2; r++)
        assert_close(sys->phi[r], decay(gains[k][0], gains[k][1], phi[r], rate[r], 0.25 * at), 0, DECAY_TOLERANCE);
    }
    eom_system_destroy(sys);
  }
}

/* psi(t) = psi(0) exp(-alpha t). */
static void slip_decays_as_the_gain_says(void **state) {
  (void)state;
  eom_system *sys = start(&sleigh, NULL, 2, 9);
  double y[6] = {0, 0, 0.4, 1, 0.3, 0.5};
  assert_int_equal(eom_assemble(sys, y, y + 3, 0), EOM_OK);
  const double psi = sys->psi[0];
  run(sys, 1, STEP, y);
  assert_int_equal(eom_assemble(sys, y, y + 3, 1), EOM_OK);
  assert_close(sys->psi[0], psi * exp(-2), 0, DECAY_TOLERANCE);
  eom_system_destroy(sys);
}

/* phi and 2 phi agree beside the circle with any gains; phi and 2 phi + bend t^2/2 do not, at a bend that accelerations alone would
 * show too. */
static void dependent_rows_are_judged_with_the_terms(void **state) {
  (void)state;
  redundancy rows = {.rows = 2, .factor = {1, 2}};
  eom_system *sys = start(&redundant, &rows, 30, 20);
  const double q[2] = {0.7, -0.9}, qd[2] = {0.4, 1.3};
  assert_int_equal(eom_acceleration(sys, q, qd, 0.5), EOM_OK);
  assert_int_equal(sys->report.rank, 1);
  rows.bend[1] = 1e-3;
  assert_int_equal(eom_acceleration(sys, q, qd, 0.5), EOM_INCONSISTENT);
  eom_system_destroy(sys);
}

static void energy_does_not_know_it(void **state) {
  (void)state;
  eom_system *with = start(&mixed, NULL, 30, 20), *without = start(&mixed, NULL, 0, 0);
  const double q[3] = {0.3, 0.4, 0.1}, qd[3] = {0.1, 0.2, 0.3};
  assert_int_equal(eom_assemble(with, q, qd, 0.2), EOM_OK);
  assert_int_equal(eom_assemble(without, q, qd, 0.2), EOM_OK);
  assert_same(with->energy, without->energy);
  assert_all_same(with->Q, without->Q, 3);
  assert_true(fabs(with->b[0] - without->b[0]) > 1);
  eom_system_destroy(with), eom_system_destroy(without);
}

static void impossible_gains(void **state) {
  (void)state;
  const double bad[] = {-1, nan(""), HUGE_VAL};
  for (int i = 0; i < 3; i++)
    for (int which = 0; which < 2; which++) {
      eom_options o = eom_options_default();
      o.baumgarte = which ? (eom_baumgarte){bad[i], 1} : (eom_baumgarte){1, bad[i]};
      eom_system *sys;
      assert_int_equal(eom_system_create(&sys, &cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
      assert_null(sys);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(violation_decays_as_the_gains_say),
      cmocka_unit_test(slip_decays_as_the_gain_says),
      cmocka_unit_test(dependent_rows_are_judged_with_the_terms),
      cmocka_unit_test(energy_does_not_know_it),
      cmocka_unit_test(impossible_gains),
  };
  return cmocka_run_group_tests_name("baumgarte", tests, NULL, NULL);
}
