/* Rayleigh's dissipation is the force -dD/dqd: the same numbers as of a model with that force by hand, by motion functions and by
 * calls, in every evaluation; and where D has no derivative, a failure that names it. */
#include "close.h"
#include "damper.h"
#include "damper_by_force_tl.h"
#include "damper_by_loss_tl.h"
#include "random.h"

#include "eom/eom.h"

enum { N = 3, M = 1, K = 2, P = 2, TRIES = 30 };

/* Other formulas for numbers below 1e3: a few last digits of the terms they are made of. */
#define TOLERANCE 1e-11

static const damper parameters = {2.0, 0.8, 0.1, 0.6};

static eom_system *start(const eom_model *model, eom_emitter emitter) {
  eom_options options = eom_options_default();
  options.emitter = emitter;
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT;
  if (emitter == EOM_EMITTER_MOTION) options.needs |= EOM_NEED_PARAMETERS;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, &parameters, &options), EOM_OK);
  return sys;
}

static void assert_same_motion(eom_system *loss, eom_system *force, rng *r) {
  double q[N], qd[N], qdd[N], w[2 * N * K], by_loss[N * K], by_force[N * K], l_loss[M * K], l_force[M * K];
  for (int i = 0; i < N; i++) q[i] = rng_uniform(r, 0.3, 1), qd[i] = rng_uniform(r, -1, 1), qdd[i] = rng_uniform(r, -1, 1);
  for (int i = 0; i < 2 * N * K; i++) w[i] = rng_uniform(r, -1, 1);
  const double t = rng_uniform(r, 0, 1);
  assert_int_equal(eom_assemble(loss, q, qd, t), EOM_OK);
  assert_int_equal(eom_assemble(force, q, qd, t), EOM_OK);
  assert_all_close(loss->Q, force->Q, N, TOLERANCE, TOLERANCE);
  assert_all_close(loss->M, force->M, N * N, 0, 0);
  assert_close(loss->energy, force->energy, 0, 0);
  assert_int_equal(eom_residual(loss, by_loss, qdd, q, qd, t), EOM_OK);
  assert_int_equal(eom_residual(force, by_force, qdd, q, qd, t), EOM_OK);
  assert_all_close(by_loss, by_force, N, TOLERANCE, TOLERANCE);
  assert_int_equal(eom_linearise(loss, q, qd, t), EOM_OK);
  assert_int_equal(eom_linearise(force, q, qd, t), EOM_OK);
  assert_all_close(loss->qdd, force->qdd, N, TOLERANCE, TOLERANCE);
  assert_all_close(loss->lambda, force->lambda, M, TOLERANCE, TOLERANCE);
  assert_all_close(loss->qdd_y, force->qdd_y, 2 * N * N, TOLERANCE, TOLERANCE);
  assert_all_close(loss->lambda_y, force->lambda_y, 2 * N * M, TOLERANCE, TOLERANCE);
  assert_int_equal(eom_tangent(loss, by_loss, l_loss, K, w, q, qd, t), EOM_OK);
  assert_int_equal(eom_tangent(force, by_force, l_force, K, w, q, qd, t), EOM_OK);
  assert_all_close(by_loss, by_force, N * K, TOLERANCE, TOLERANCE);
  assert_all_close(l_loss, l_force, M * K, TOLERANCE, TOLERANCE);
  if (!(loss->options.needs & force->options.needs & EOM_NEED_PARAMETERS)) return; /* motion functions have it */
  assert_int_equal(eom_parameter_derivatives(loss, by_loss, l_loss, q, qd, t), EOM_OK);
  assert_int_equal(eom_parameter_derivatives(force, by_force, l_force, q, qd, t), EOM_OK);
  assert_all_close(by_loss, by_force, N * P, TOLERANCE, TOLERANCE);
  assert_all_close(l_loss, l_force, M * P, TOLERANCE, TOLERANCE);
}

static const eom_emitter emitters[] = {EOM_EMITTER_CALLS, EOM_EMITTER_MOTION};

static void dissipation_is_the_force_by_hand(void **state) {
  (void)state;
  for (int by = 0; by < 4; by++) { /* each emitter with each */
    eom_system *loss = start(&damper_by_loss_model, emitters[by % 2]), *force = start(&damper_by_force_model, emitters[by / 2]);
    rng r = {7};
    for (int k = 0; k < TRIES; k++) assert_same_motion(loss, force, &r);
    eom_system_destroy(loss), eom_system_destroy(force);
  }
}

/* |v|^3 by a root: at rest it has no derivative of the shape that a linearisation takes. */
static void a_failure_names_the_function(void **state) {
  (void)state;
  const double q[N] = {1, 0.6, 0.8}, qd[N] = {0};
  for (int by = 0; by < 2; by++) {
    eom_system *sys = start(&damper_by_loss_model, emitters[by]);
    assert_int_equal(eom_linearise(sys, q, qd, 0), EOM_DOMAIN);
    assert_string_equal(sys->report.function, "damper_loss");
    eom_system_destroy(sys);
  }
}

static int two_rows(const void *params) {
  (void)params;
  return 2;
}

static void dissipation_has_one_row(void **state) {
  (void)state;
  eom_model model = damper_by_loss_model;
  eom_system *sys;
  model.dissipation.rows = two_rows;
  assert_int_equal(eom_system_create(&sys, &model, &parameters, NULL), EOM_BAD_MODEL);
  model.dissipation.rows = NULL;
  assert_int_equal(eom_system_create(&sys, &model, &parameters, NULL), EOM_BAD_MODEL);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(dissipation_is_the_force_by_hand), cmocka_unit_test(a_failure_names_the_function),
                                     cmocka_unit_test(dissipation_has_one_row)};
  return cmocka_run_group_tests_name("dissipation", tests, NULL, NULL);
}
