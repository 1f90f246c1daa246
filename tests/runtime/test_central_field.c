/* The central field in (r, u): M, Q, A, b and the acceleration against closed forms (eqs 67-71) for any weights. */
#include "close.h"
#include "constrained_models.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>

/* The bound asked of the project, in parts of the largest number of each result. Measured: see the printed line. */
#define CENTRAL_FIELD_TOLERANCE 1e-13
#define STATES 1000
#define MASS 2.0
#define MU 1.7

typedef struct closed_form {
  double M[16], Q[4], A[4], b[1], qdd[4];
} closed_form;

/* With m/2 |r' u + r u'|^2 + mu m/r, |u|^2 = 1 and states on the manifold, u.u' = 0:
 *   M = m [|u|^2, r u'; r u, r^2 1],  Q = -2 m r' (u.u', r u') - (mu m/r^2, 0),  A = (0, 2 u),  b = -2 |u'|^2,
 *   r'' = r |u'|^2 - mu/r^2,  u'' = -2 r'/r u' - |u'|^2 u. */
static closed_form by_hand(const double *q, const double *qd) {
  closed_form c = {{0}, {0}, {0}, {0}, {0}};
  const double r = q[0], rd = qd[0];
  double u2 = 0, ud2 = 0, uud = 0;
  for (int i = 1; i < 4; i++) {
    u2 += q[i] * q[i];
    ud2 += qd[i] * qd[i];
    uud += q[i] * qd[i];
  }
  c.M[0] = MASS * u2;
  c.Q[0] = -2 * MASS * rd * uud - MU * MASS / (r * r);
  c.b[0] = -2 * ud2;
  c.qdd[0] = r * ud2 - MU / (r * r);
  for (int i = 1; i < 4; i++) {
    c.M[i] = c.M[4 * i] = MASS * r * q[i];
    c.M[5 * i] = MASS * r * r;
    c.Q[i] = -2 * MASS * r * rd * qd[i];
    c.A[i] = 2 * q[i];
    c.qdd[i] = -2 * rd / r * qd[i] - ud2 * q[i];
  }
  return c;
}

/* A state on the manifold: u from a random direction, u' its part across u. */
static void random_state(rng *r, double *q, double *qd) {
  double length = 0, along = 0;
  q[0] = rng_uniform(r, 0.5, 3);
  qd[0] = rng_uniform(r, -1, 1);
  for (int i = 1; i < 4; i++) {
    q[i] = rng_uniform(r, -1, 1);
    qd[i] = rng_uniform(r, -1, 1);
    length += q[i] * q[i];
  }
  for (int i = 1; i < 4; i++) {
    q[i] /= sqrt(length);
    along += q[i] * qd[i];
  }
  for (int i = 1; i < 4; i++) qd[i] -= along * q[i];
}

static double error_of(const double *actual, const double *truth, int count) {
  double size = 0, worst = 0;
  for (int i = 0; i < count; i++) size = fmax(size, fabs(truth[i]));
  assert_all_close(actual, truth, count, 0, CENTRAL_FIELD_TOLERANCE * size);
  for (int i = 0; i < count; i++) worst = fmax(worst, fabs(actual[i] - truth[i]) / size);
  return worst;
}

static void agrees_with_closed_forms(void **state) {
  (void)state;
  for (double w = 1e-8; w < 2e8; w *= 100) {
    eom_options options = eom_options_default();
    options.weights = &w;
    eom_system *sys;
    assert_int_equal(eom_system_create(&sys, &central_field, NULL, &options), EOM_OK);
    rng r = {67};
    double worst[5] = {0}, q[4], qd[4];
    for (int k = 0; k < STATES; k++) {
      random_state(&r, q, qd);
      assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
      assert_int_equal(eom_solve(sys), EOM_OK);
      const closed_form c = by_hand(q, qd);
      worst[0] = fmax(worst[0], error_of(sys->M, c.M, 16));
      worst[1] = fmax(worst[1], error_of(sys->Q, c.Q, 4));
      worst[2] = fmax(worst[2], error_of(sys->A, c.A, 4));
      worst[3] = fmax(worst[3], error_of(sys->b, c.b, 1));
      worst[4] = fmax(worst[4], error_of(sys->qdd, c.qdd, 4));
    }
    print_message("W=%g: largest relative error of M %.1e, Q %.1e, A %.1e, b %.1e, qdd %.1e\n", w, worst[0], worst[1], worst[2],
                  worst[3], worst[4]);
    eom_system_destroy(sys);
  }
}

/* A circular orbit for ten turns: |u|^2 = 1, energy and momentum m r^2 u x u' are kept to the error of the method. */
static void circular_orbit(void **state) {
  (void)state;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &central_field, NULL, NULL), EOM_OK);
  const double turn = sqrt(MU), y0[8] = {1, 1, 0, 0, 0, 0, turn, 0}, period = 2 * acos(-1.0) / turn;
  double *work = malloc(eom_integrator_size(&eom_dp5, 8) * sizeof *work);
  assert_non_null(work);
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, eom_rhs, sys, 8, 0, y0, period / 400, work);
  assert_int_equal(eom_integrate(&it, 10 * period, NULL, NULL), EOM_OK);
  assert_all_close(it.y, y0, 8, 0, 1e-7); /* 4000 steps of an error of (2 pi/400)^6/720 */
  assert_int_equal(eom_energy(sys, it.y, it.y + 4, it.t), EOM_OK);
  const double energy = sys->energy;
  assert_int_equal(eom_energy(sys, y0, y0 + 4, 0), EOM_OK);
  assert_close(energy, sys->energy, 1e-8, 0);
  eom_system_destroy(sys);
  free(work);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(agrees_with_closed_forms), cmocka_unit_test(circular_orbit)};
  return cmocka_run_group_tests_name("central_field", tests, NULL, NULL);
}
