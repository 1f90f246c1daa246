/* A mass matrix of parameters alone is factored once, and again as soon as its numbers are others: at every state and after every
 * change of the parameters a system says to the bit what a new one says. */
#include "close.h"
#include "random.h"

#include "cartesian_pendulum.h"
#include "cartesian_pendulum_tl.h"

#include "eom/eom.h"
#include "kkt_truth.h"
#include "workspace.h"

#include <stdbool.h>

enum { LINKS = 3, N = 2 * LINKS, STATES = 4 };

static cartesian_pendulum pendulum(void) {
  return (cartesian_pendulum){.links = LINKS, .coordinates = N, .g = 9.81, .mass = {1, 0.5, 2}, .length = {1, 1.5, 0.75}};
}

static eom_system *start(const cartesian_pendulum *p, const double *weights) {
  eom_options options = eom_options_default();
  options.emitter = EOM_EMITTER_MOTION;
  options.weights = weights;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &cartesian_pendulum_model, p, &options), EOM_OK);
  assert_true(sys->motion->constant_mass);
  return sys;
}

/* At random states. */
static void same_as_new(eom_system *sys, const cartesian_pendulum *p, const double *weights, rng *r) {
  for (int k = 0; k < STATES; k++) {
    double q[N], qd[N];
    for (int i = 0; i < N; i++) {
      q[i] = rng_uniform(r, -1, 1);
      qd[i] = rng_uniform(r, -1, 1);
    }
    eom_system *fresh = start(p, weights);
    assert_int_equal(eom_linearise(fresh, q, qd, 0), EOM_OK);
    assert_int_equal(eom_linearise(sys, q, qd, 0), EOM_OK);
    assert_all_same(sys->qdd, fresh->qdd, N);
    assert_all_same(sys->lambda, fresh->lambda, LINKS);
    assert_all_same(sys->qdd_y, fresh->qdd_y, 2 * N * N);
    assert_same(sys->report.pivot, fresh->report.pivot);
    assert_int_equal(sys->report.weighted, fresh->report.weighted);
    eom_system_destroy(fresh);
  }
}

static void parameters_may_change_between_calls(void **state) {
  (void)state;
  cartesian_pendulum p = pendulum();
  eom_system *sys = start(&p, NULL);
  rng r = {7};
  same_as_new(sys, &p, NULL, &r);
  p.mass[1] = 3; /* in M */
  same_as_new(sys, &p, NULL, &r);
  p.g = 1.62, p.length[0] = 2; /* not in M */
  same_as_new(sys, &p, NULL, &r);
  p.mass[1] = 0.5;
  same_as_new(sys, &p, NULL, &r);
  eom_system_destroy(sys);
}

/* With weights of the user's calM is not M. */
static void weights_are_taken(void **state) {
  (void)state;
  const double weights[LINKS] = {0.5, 2, 1};
  cartesian_pendulum p = pendulum();
  eom_system *sys = start(&p, weights);
  rng r = {8};
  same_as_new(sys, &p, weights, &r);
  assert_true(sys->report.weighted);
  eom_system_destroy(sys);
}

/* A factorisation that fails, which tries weights, leaves nothing behind. */
static void failures_are_not_kept(void **state) {
  (void)state;
  cartesian_pendulum p = pendulum();
  eom_system *sys = start(&p, NULL);
  rng r = {9};
  same_as_new(sys, &p, NULL, &r);
  const double q[N] = {0, -1, 0, -2, 0, -3}, qd[N] = {0};
  for (int repeat = 0; repeat < 2; repeat++) {
    p.mass[0] = -1;
    assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_NO_INERTIA);
    const int coordinate = sys->report.index;
    assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_NO_INERTIA);
    assert_int_equal(sys->report.index, coordinate);
    p.mass[0] = 1;
    same_as_new(sys, &p, NULL, &r);
  }
  eom_system_destroy(sys);
}

/* By the general solver. */
static void solve(eom_system *sys, const double *q, const double *qd, double t) {
  assert_int_equal(eom_assemble(sys, q, qd, t), EOM_OK);
  assert_int_equal(eom_solve(sys), EOM_OK);
}

/* A mark on what is kept: seen while M stays, gone when it changes. */
static void factors_are_kept(void **state) {
  (void)state;
  const double mark = 0.625, q[N] = {0.6, -0.8, 1.2, -1.6, 1.2, -2.6}, qd[N] = {0};
  cartesian_pendulum p = pendulum();
  eom_system *sys = start(&p, NULL);
  solve(sys, q, qd, 0);
  sys->workspace->factor.kept_pivot = mark;
  solve(sys, q, qd, 1);
  assert_same(sys->report.pivot, mark);
  p.mass[LINKS - 1] += 1;
  solve(sys, q, qd, 1);
  assert_true(sys->report.pivot != mark);
  eom_system_destroy(sys);
}

/* Rods in a line with a heavy mass at their end: the pivots of A M^-1 A' fall with its mass. Up to EOM_MOTION_SAFE_PIVOT the solved
 * form serves, with an error that grows with it; beyond, the general solver, whose error does not. Truth is quad precision. */
static void solved_form_and_its_end(void **state) {
  (void)state;
  const double q[N] = {0, -1, 0, -2.5, 0, -3.25}, qd[N] = {0.3, 0, 0.7, 0, 0.2, 0};
  cartesian_pendulum p = pendulum();
  eom_system *sys = start(&p, NULL);
  assert_non_null(sys->motion->constrained);
  for (double mass = 1; mass < 1e9; mass *= 10) {
    double truth[N + LINKS];
    p.mass[LINKS - 1] = mass;
    solve(sys, q, qd, 0);
    kkt_truth(N, LINKS, sys->M, sys->A, sys->Q, sys->b, truth);
    assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
    const bool solved_form = sys->report.pivot < 0;
    assert_true(mass > 10 || solved_form);
    assert_true(mass < 1e4 || !solved_form);
    assert_int_equal(sys->report.rank, LINKS);
    const double limit = solved_form ? 4e-16 * (4 + mass) : 1e-14;
    for (int i = 0; i < N; i++) assert_close(sys->qdd[i], truth[i], 0, limit * 10);
    for (int i = 0; i < LINKS; i++) assert_close(sys->lambda[i], truth[N + i], limit, 0);
    for (int i = 0; i < N; i++) {
      double force = 0;
      for (int r = 0; r < LINKS; r++) force += sys->A[r * N + i] * sys->lambda[r];
      assert_close(sys->Qc[i], force, 1e-14, 1e-14 * mass);
    }
  }
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(parameters_may_change_between_calls), cmocka_unit_test(weights_are_taken),
                                     cmocka_unit_test(failures_are_not_kept), cmocka_unit_test(factors_are_kept),
                                     cmocka_unit_test(solved_form_and_its_end)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
