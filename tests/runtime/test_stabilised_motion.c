/* Baumgarte's terms are the same for motion functions as for calls, in accelerations, multipliers and every derivative. */
#include "blade.h"
#include "blade_tl.h"
#include "close.h"
#include "random.h"

#include "eom/eom.h"

enum { N = 3, M = 2, K = 4, TRIES = 50 };

/* Another order of sums: a few last digits of numbers below 1e3. */
#define TOLERANCE 1e-11

static const blade parameters = {2.0, 0.3};

static eom_system *start(eom_emitter emitter, unsigned needs) {
  eom_options options = eom_options_default();
  options.baumgarte = (eom_baumgarte){3, 5};
  options.emitter = emitter;
  options.needs = needs;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &blade_model, &parameters, &options), EOM_OK);
  return sys;
}

static void motion_agrees_with_calls(void **state) {
  (void)state;
  const unsigned needs = EOM_NEED_LINEARISE | EOM_NEED_TANGENT;
  eom_system *calls = start(EOM_EMITTER_CALLS, needs), *motion = start(EOM_EMITTER_MOTION, needs);
  rng r = {5};
  for (int k = 0; k < TRIES; k++) {
    double q[N], qd[N], w[2 * N * K], by_calls[N * K], by_motion[N * K], l_calls[M * K], l_motion[M * K];
    for (int i = 0; i < N; i++) q[i] = rng_uniform(&r, 0.3, 1), qd[i] = rng_uniform(&r, -1, 1);
    for (int i = 0; i < 2 * N * K; i++) w[i] = rng_uniform(&r, -1, 1);
    const double t = rng_uniform(&r, 0, 1);
    assert_int_equal(eom_linearise(calls, q, qd, t), EOM_OK);
    assert_int_equal(eom_linearise(motion, q, qd, t), EOM_OK);
    assert_all_close(motion->qdd, calls->qdd, N, TOLERANCE, TOLERANCE);
    assert_all_close(motion->lambda, calls->lambda, M, TOLERANCE, TOLERANCE);
    assert_all_close(motion->qdd_y, calls->qdd_y, 2 * N * N, TOLERANCE, TOLERANCE);
    assert_all_close(motion->lambda_y, calls->lambda_y, 2 * N * M, TOLERANCE, TOLERANCE);
    assert_int_equal(eom_tangent(calls, by_calls, l_calls, K, w, q, qd, t), EOM_OK);
    assert_int_equal(eom_tangent(motion, by_motion, l_motion, K, w, q, qd, t), EOM_OK);
    assert_all_close(by_motion, by_calls, N * K, TOLERANCE, TOLERANCE);
    assert_all_close(l_motion, l_calls, M * K, TOLERANCE, TOLERANCE);
  }
  eom_system_destroy(calls), eom_system_destroy(motion);
}

static void parameters_are_refused(void **state) {
  (void)state;
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_PARAMETERS;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &blade_model, &parameters, &options), EOM_OK);
  eom_system_destroy(sys);
  options.baumgarte.alpha = 1;
  assert_int_equal(eom_system_create(&sys, &blade_model, &parameters, &options), EOM_BAD_OPTION);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(motion_agrees_with_calls), cmocka_unit_test(parameters_are_refused)};
  return cmocka_run_group_tests_name("stabilised_motion", tests, NULL, NULL);
}
