/* The models of the pendulum's runs: up to the size of Table 1 each has motion functions, and they are of as many links. */
#include "close.h"
#include "run.h"

const char program[] = "test_pendulum_models";

/* Two ways of computing the same accelerations, rad/s^2, of some units. */
#define ROUNDING 1e-12

enum { TABLE1_SIZES = 6, MOST = TABLE1_SIZES + 2 };

static eom_system *system_of(int links, eom_emitter emitter) {
  static struct pendulum p[MOST + 1];
  eom_system *sys;
  eom_options options = eom_options_default();
  options.emitter = emitter;
  p[links] = run_pendulum(links);
  assert_int_equal(eom_system_create(&sys, run_model(links), &p[links], &options), EOM_OK);
  return sys;
}

static void who_serves_a_size(void **state) {
  (void)state;
  for (int n = 1; n <= MOST; n++) {
    const eom_emitter wanted = n <= TABLE1_SIZES ? EOM_EMITTER_MOTION : EOM_EMITTER_CALLS;
    eom_system *sys = system_of(n, EOM_EMITTER_AUTO);
    assert_int_equal(sys->n, n);
    assert_int_equal(eom_system_emitter(sys, EOM_TASK_ENERGY), wanted);
    assert_int_equal(eom_system_emitter(sys, EOM_TASK_ASSEMBLE), wanted);
    assert_int_equal(eom_system_emitter(sys, EOM_TASK_LINEARISE), wanted);
    eom_system_destroy(sys);
  }
}

static void both_ways_agree(void **state) {
  (void)state;
  for (int n = 1; n <= TABLE1_SIZES; n++) {
    const double q[TABLE1_SIZES] = {1.3, 0.2, -0.4, 0.7, -1.1, 0.5}, qd[TABLE1_SIZES] = {0.3, -0.8, 0.5, 1.2, -0.6, 0.9};
    eom_system *fast = system_of(n, EOM_EMITTER_AUTO), *slow = system_of(n, EOM_EMITTER_CALLS);
    assert_int_equal(eom_acceleration(fast, q, qd, 0.0), EOM_OK);
    assert_int_equal(eom_acceleration(slow, q, qd, 0.0), EOM_OK);
    assert_all_close(fast->qdd, slow->qdd, n, ROUNDING, ROUNDING);
    eom_system_destroy(fast);
    eom_system_destroy(slow);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(who_serves_a_size), cmocka_unit_test(both_ways_agree)};
  return cmocka_run_group_tests_name("pendulum_models", tests, NULL, NULL);
}
