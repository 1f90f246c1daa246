/* Fixed-step integration: orders by step halving, exact polynomials, the shared stage, failures that keep the last good state. */
#include "close.h"
#include "pendulum_model.h"

#include "eom/eom.h"

#include <math.h>
#include <string.h>

enum { MOST_DIM = 4, MOST_WORK = 32 * MOST_DIM };

/* Starts an integrator in memory of its own. */
static void start(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, const double *y, double h) {
  static double work[MOST_WORK];
  assert_true(eom_integrator_size(method, dim) <= MOST_WORK);
  eom_integrator_init(it, method, rhs, user, dim, 0, y, h, work);
}

/* y'' = -y as (y, y'), whose solution is a rotation; counts its calls. */
static int oscillator(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  (void)t;
  if (user) ++*(long *)user;
  ydot[0] = y[1];
  ydot[1] = -y[0];
  return 0;
}

static double oscillator_error(const eom_method *method, int steps) {
  const double y[2] = {1, 0};
  eom_integrator it;
  start(&it, method, oscillator, NULL, 2, y, 4.0 / steps);
  assert_int_equal(eom_integrate(&it, 4, NULL, NULL), EOM_OK);
  assert_int_equal(it.steps, steps);
  return hypot(it.y[0] - cos(4), it.y[1] + sin(4));
}

/* Halving the step divides the error by 2^p; the next order is still seen. Measured: rk4 16.0, dp5 32.1 and 32.0, dop853 258 and
 * 260. */
static void orders(void **state) {
  (void)state;
  static const struct {
    const char *name;
    int steps;
  } of[] = {{"rk4", 80}, {"dp5", 40}, {"dop853", 8}};
  for (size_t k = 0; k < sizeof of / sizeof of[0]; k++) {
    const eom_method *method = eom_method_find(of[k].name);
    for (int steps = of[k].steps; steps <= 2 * of[k].steps; steps *= 2) {
      const double ratio = oscillator_error(method, steps) / oscillator_error(method, 2 * steps);
      print_message("%s, %d steps: error falls by %.2f\n", method->name, steps, ratio);
      assert_close(ratio, pow(2, method->order), 0.05, 0);
    }
  }
}

/* y' = 1/3: every step is exact but for rounding. */
static int third(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  (void)user, (void)t, (void)y;
  ydot[0] = 1.0 / 3.0;
  return 0;
}

/* What a sum of many small steps loses by rounding is carried along: 3e5 steps keep to 1 ulp of 2; a plain sum is 4e4 ulp off. */
static void roundings_are_carried(void **state) {
  (void)state;
  const double y = 1.0;
  eom_integrator it;
  start(&it, &eom_rk4, third, NULL, 1, &y, 1e-5);
  assert_int_equal(eom_integrate(&it, 3, NULL, NULL), EOM_OK);
  assert_int_equal(it.steps, 300000);
  print_message("1 + 3/3 is off by %g\n", it.y[0] - 2.0);
  assert_close(it.y[0], 2.0, 2 * 2.2204460492503131e-16, 0);
}

/* The same on a motion of the pendulum: errors against a much smaller step. Measured 35.5 and 32.4: the next order is still seen. */
static void order_five_of_a_motion(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &pendulum_model, &p, NULL), EOM_OK);
  double y0[4] = {1.2, 0.3, 0, 0}, end[4][4];
  const int steps[4] = {6400, 200, 400, 800};
  for (int k = 0; k < 4; k++) {
    eom_integrator it;
    start(&it, &eom_dp5, eom_rhs, sys, 4, y0, 1.0 / steps[k]);
    assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_OK);
    memcpy(end[k], it.y, sizeof end[k]);
  }
  double error[4];
  for (int k = 1; k < 4; k++) {
    error[k] = 0;
    for (int i = 0; i < 4; i++) error[k] = hypot(error[k], end[k][i] - end[0][i]);
  }
  print_message("errors %.2e %.2e %.2e\n", error[1], error[2], error[3]);
  assert_close(error[1] / error[2], 32, 0.15, 0);
  assert_close(error[2] / error[3], 32, 0.15, 0);
  eom_system_destroy(sys);
}

/* y' = p t^(p-1): a method of order p is exact. Tests every c and b. */
static int power(void *user, double t, const double *y, double *ydot) {
  (void)y;
  const int p = *(const int *)user;
  ydot[0] = p * pow(t, p - 1);
  return 0;
}

static void exact_for_powers(void **state) {
  (void)state;
  static const char *const names[] = {"rk4", "dp5", "dop853"};
  for (int k = 0; k < 3; k++) {
    const eom_method *method = eom_method_find(names[k]);
    int p = method->order;
    const double y = 0;
    eom_integrator it;
    start(&it, method, power, &p, 1, &y, 1);
    assert_int_equal(eom_integrate(&it, 3, NULL, NULL), EOM_OK);
    assert_close(it.y[0], pow(3, p), 1e-14, 0);
  }
}

/* A step costs one call for each stage: the slope at its end is the first of the next one, also where the state there was corrected.
 * One more at the start, and after a restart. */
static int halve(void *user, double t, double *y) {
  (void)user, (void)t;
  y[0] *= 0.5;
  return 0;
}

static void last_stage_is_shared(void **state) {
  (void)state;
  static const char *const names[] = {"rk4", "dp5", "dop853"};
  for (int k = 0; k < 6; k++) {
    const eom_method *method = eom_method_find(names[k / 2]);
    long calls = 0;
    const double y[2] = {1, 0};
    eom_integrator it;
    start(&it, method, oscillator, &calls, 2, y, 0.1);
    if (k % 2) it.correct = halve;
    for (int i = 0; i < 10; i++) assert_int_equal(eom_integrator_step(&it), EOM_OK);
    assert_int_equal(calls, 10 * method->stages + 1);
    assert_int_equal(it.evaluations, calls);
    const double before = it.y[0];
    eom_integrator_restart(&it);
    assert_int_equal(eom_integrator_step(&it), EOM_OK);
    assert_int_equal(calls, 11 * method->stages + 2);
    assert_true(it.y[0] != before);
  }
}

/* t is t0 + steps*h, and the last step ends where asked, forwards and backwards. */
static void ends_at_the_time_asked(void **state) {
  (void)state;
  const double y[2] = {1, 0};
  eom_integrator it;
  start(&it, &eom_dp5, oscillator, NULL, 2, y, 0.01);
  assert_int_equal(eom_integrate(&it, 1.005, NULL, NULL), EOM_OK);
  assert_int_equal(it.steps, 101);
  assert_close(it.t, 1.005, 0, 0);
  assert_close(it.y[0], cos(1.005), 0, 1e-12);
  assert_int_equal(eom_integrate(&it, 2.005, NULL, NULL), EOM_OK);
  assert_int_equal(it.steps, 201);
  assert_close(it.t, 2.005, 1e-15, 0);
  assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_BAD_OPTION);
  it.h = -0.01;
  it.t0 = it.t;
  it.steps = 0;
  assert_int_equal(eom_integrate(&it, 0, NULL, NULL), EOM_OK);
  assert_close(it.y[0], 1, 0, 1e-11);
  it.h = 1e-40; /* 1 + h is 1 */
  assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_BAD_OPTION);
  it.h = 0;
  assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_BAD_OPTION);
}

/* Fails with code 42 once t passes a limit. */
static int fails_late(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  oscillator(NULL, t, y, ydot);
  return t > *(const double *)user ? 42 : 0;
}

static void failure_keeps_the_last_state(void **state) {
  (void)state;
  double limit = 0.5;
  const double y[2] = {1, 0};
  eom_integrator it;
  start(&it, &eom_dp5, fails_late, &limit, 2, y, 0.1);
  assert_int_equal(eom_integrate(&it, 2, NULL, NULL), EOM_RHS_FAILED);
  assert_int_equal(it.rhs_code, 42);
  assert_int_equal(it.steps, 5);
  assert_close(it.t, 0.5, 0, 0);
  assert_close(it.y[0], cos(0.5), 0, 1e-7);
  limit = 10; /* goes on from there */
  assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_OK);
  assert_close(it.y[0], cos(1), 0, 1e-7);
}

/* y' = y^2 overflows at t = 1; it is never asked at a point that is not finite. */
static int explosion(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  (void)user, (void)t;
  assert_true(isfinite(y[0]));
  ydot[0] = y[0] * y[0];
  return 0;
}

static void overflow_is_reported(void **state) {
  (void)state;
  const double y = 1;
  eom_integrator it;
  start(&it, &eom_dp5, explosion, NULL, 1, &y, 0.25);
  assert_int_equal(eom_integrate(&it, 3, NULL, NULL), EOM_NOT_FINITE);
  assert_true(isfinite(it.y[0]));
}

static int stop_at_three(void *observer, const eom_integrator *it) {
  ++*(int *)observer;
  return it->steps == 3;
}

static void observer_stops(void **state) {
  (void)state;
  int seen = 0;
  const double y[2] = {1, 0};
  eom_integrator it;
  start(&it, &eom_dp5, oscillator, NULL, 2, y, 0.1);
  assert_int_equal(eom_integrate(&it, 2, stop_at_three, &seen), EOM_STOPPED);
  assert_int_equal(seen, 3);
  assert_close(it.t, 0.3, 1e-15, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(orders),
                                     cmocka_unit_test(roundings_are_carried),
                                     cmocka_unit_test(order_five_of_a_motion),
                                     cmocka_unit_test(exact_for_powers),
                                     cmocka_unit_test(last_stage_is_shared),
                                     cmocka_unit_test(ends_at_the_time_asked),
                                     cmocka_unit_test(failure_keeps_the_last_state),
                                     cmocka_unit_test(overflow_is_reported),
                                     cmocka_unit_test(observer_stops)};
  return cmocka_run_group_tests_name("integrate", tests, NULL, NULL);
}
