/* Accelerations and constraint forces of real mechanisms do not depend on how their constraints are written, nor on W. */
#include "andrews.h"
#include "andrews_tl.h"
#include "cartesian_pendulum.h"
#include "cartesian_pendulum_tl.h"
#include "close.h"
#include "four_bars.h"
#include "four_bars_tl.h"
#include "random.h"
#include "rearranged.h"

#include "eom/eom.h"

#include <math.h>
#include <stdbool.h>

/* What is asked of the project, relative to the largest number. */
#define SAME 1e-10

enum { MOST = 16, STATES = 20 };

/* A mechanism at a state on its constraints. */
typedef struct mechanism {
  const eom_model *model;
  const void *params;
  int n, m, rank;
  double q[MOST], qd[MOST];
  double qdd[MOST], Qc[MOST]; /* as the model stands, W automatic */
} mechanism;

static void take(mechanism *at, rng *random) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, at->model, at->params, NULL), EOM_OK);
  at->n = sys->n, at->m = sys->m;
  for (int i = 0; i < at->n; i++) {
    at->q[i] += rng_uniform(random, -0.05, 0.05) * fabs(at->q[i]);
    at->qd[i] = rng_uniform(random, -2.0, 2.0);
  }
  assert_int_equal(eom_project(sys, at->q, at->qd, 0.0, NULL), EOM_OK);
  assert_int_equal(eom_acceleration(sys, at->q, at->qd, 0.0), EOM_OK);
  at->rank = sys->report.rank;
  for (int i = 0; i < at->n; i++) at->qdd[i] = sys->qdd[i], at->Qc[i] = sys->Qc[i];
  eom_system_destroy(sys);
}

static void all_near(const double *x, const double *truth, int n) {
  double most = 0.0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs(truth[i]));
  assert_all_close(x, truth, n, 0.0, SAME * most);
}

/* weights: of each row; null for automatic ones. */
static void same_motion(const mechanism *at, const eom_model *model, const void *params, const double *weights) {
  eom_system *sys;
  eom_options options = eom_options_default();
  options.weights = weights;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  assert_int_equal(eom_assemble(sys, at->q, at->qd, 0.0), EOM_OK);
  assert_int_equal(eom_solve(sys), EOM_OK);
  assert_int_equal(sys->report.rank, at->rank);
  all_near(sys->qdd, at->qdd, at->n);
  all_near(sys->Qc, at->Qc, at->n);
  eom_system_destroy(sys);
}

static void same_for_weights(const mechanism *at, const eom_model *model, const void *params, int rows) {
  double weights[REARRANGED_MOST];
  same_motion(at, model, params, NULL);
  for (int power = -8; power <= 8; power += 4) {
    for (int i = 0; i < rows; i++) weights[i] = pow(10.0, power);
    same_motion(at, model, params, weights);
  }
  for (int i = 0; i < rows; i++) weights[i] = i % 2 == 0 ? 1e8 : 1e-8;
  same_motion(at, model, params, weights);
}

static void same_rearranged(const mechanism *at, const rearranged *r) {
  eom_function constraint;
  const eom_model model = rearranged_model(r, &constraint);
  same_for_weights(at, &model, r, r->rows);
}

static void same_however_written(const mechanism *at) {
  rearranged r = {.model = at->model, .params = at->params, .rows = at->m};
  same_for_weights(at, at->model, at->params, at->m);
  for (int sign = -1; sign <= 1; sign += 2) { /* scaled: all alike, then by turns */
    for (int i = 0; i < at->m; i++) r.from[i] = i, r.scale[i] = pow(1e8, sign);
    same_rearranged(at, &r);
    for (int i = 0; i < at->m; i++) r.scale[i] = pow(1e8, i % 2 == 0 ? sign : -sign);
    same_rearranged(at, &r);
  }
  for (int i = 0; i < at->m; i++) r.from[i] = at->m - 1 - i, r.scale[i] = 1.0; /* permuted */
  same_rearranged(at, &r);
  r.rows = 2 * at->m;
  for (int i = 0; i < r.rows; i++) r.from[i] = i / 2, r.scale[i] = 1.0; /* duplicated */
  same_rearranged(at, &r);
  for (int i = 0; i < r.rows; i++) r.from[i] = (7 * i + 3) % at->m, r.scale[i] = i % 3 == 0 ? -1e8 : i % 3 == 1 ? 1.0 : 1e-8; /* all */
  same_rearranged(at, &r);
}

static void andrews_mechanism(void **state) {
  (void)state;
  const andrews p = andrews_parameters();
  rng random = {1};
  for (int k = 0; k < STATES; k++) {
    mechanism at = {.model = &andrews_model, .params = &p};
    andrews_start(at.q, at.qd);
    take(&at, &random);
    assert_int_equal(at.rank, ANDREWS_LOOPS);
    same_however_written(&at);
  }
}

static void cartesian_chain(void **state) {
  (void)state;
  const cartesian_pendulum p = {.links = 4, .coordinates = 8, .g = 9.81, .mass = {1.0, 2.0, 0.5, 3.0}, .length = {1.0, 0.7, 1.2, 0.4}};
  rng random = {2};
  for (int k = 0; k < STATES; k++) {
    mechanism at = {.model = &cartesian_pendulum_model, .params = &p};
    for (int i = 0; i < p.coordinates; i++) at.q[i] = (i > 1 ? at.q[i - 2] : 0.0) + rng_uniform(&random, -1.0, 1.0);
    take(&at, &random);
    assert_int_equal(at.rank, p.links);
    same_however_written(&at);
  }
}

static void row_of_four_bars(void **state) {
  (void)state;
  const four_bars p = four_bars_parameters(2);
  rng random = {3};
  for (int k = 0; k < STATES; k++) {
    mechanism at = {.model = &four_bars_model, .params = &p};
    four_bars_start(&p, at.q, at.qd);
    take(&at, &random);
    assert_int_equal(at.rank, p.rods);
    same_however_written(&at);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(andrews_mechanism), cmocka_unit_test(cartesian_chain),
                                     cmocka_unit_test(row_of_four_bars)};
  return cmocka_run_group_tests_name("invariance", tests, NULL, NULL);
}
