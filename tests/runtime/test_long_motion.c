/* The energy over a million variational steps: its error swings within the same bounds from the first tenth to the last, and its mean
 * stays. */
#include "close.h"
#include "sensitive_models.h"

#include "chain_tl.h"
#include "planet_tl.h"
#include "rod_tl.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 1000000, TENTHS = 10 };

/* What rounding may leave of an energy of some joules after a million steps: less than one in 1e12. Measured: 3e-13 at most. */
#define ROUNDING 1e-12

typedef struct tenth {
  double most, mean; /* J */
} tenth;

static void follow(const eom_model *model, const void *params, int order, const double *y, double h, tenth *part) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  assert_int_equal(eom_system_emitter(sys, EOM_TASK_ENERGY), EOM_EMITTER_MOTION);
  double *work = malloc(eom_variational_size(sys, order) * sizeof *work);
  eom_variational v;
  eom_integrator it;
  assert_int_equal(eom_variational_init(&v, &it, sys, order, 0, y, h, work), EOM_OK);
  assert_int_equal(eom_energy(sys, it.y, it.y + 2, 0), EOM_OK);
  const double first = sys->energy;
  for (int i = 0; i < STEPS; i++) {
    tenth *now = &part[i / (STEPS / TENTHS)];
    assert_int_equal(eom_integrator_step(&it), EOM_OK);
    assert_int_equal(eom_energy(sys, it.y, it.y + 2, it.t), EOM_OK);
    now->most = fmax(now->most, fabs(sys->energy - first));
    now->mean += (sys->energy - first) / (STEPS / TENTHS);
  }
  free(work);
  eom_system_destroy(sys);
}

static void energy_stays_bounded_over_a_million_steps(void **state) {
  (void)state;
  static const chain links = {{1, 1}, {1, 1}, 9.81};
  static const planet sun = {1};
  static const rod stick = {1, 1, 9.81};
  static const struct {
    const char *name;
    const eom_model *model;
    const void *params;
    double h, y[4];
  } motions[] = {{"double pendulum", &chain_model, &links, 0.01, {0.5, -0.3, 0, 0}},
                 {"Kepler, e = 0.5", &planet_model, &sun, 0.02, {0.5, 0, 0, 1.7320508075688772}},
                 {"constrained pendulum", &rod_model, &stick, 0.01, {1, 0, 0, 0}}};
  print_message("energy error of the first and of the last tenth of %d steps, J: largest, mean\n", STEPS);
  for (size_t k = 0; k < sizeof motions / sizeof motions[0]; k++)
    for (int order = 2; order <= 6; order += 2) {
      tenth part[TENTHS] = {{0}};
      follow(motions[k].model, motions[k].params, order, motions[k].y, motions[k].h, part);
      const tenth first = part[0], last = part[TENTHS - 1];
      print_message("%-22s order %d: %.2e %9.2e   %.2e %9.2e\n", motions[k].name, order, first.most, first.mean, last.most, last.mean);
      assert_true(last.most <= 1.05 * first.most + ROUNDING);
      assert_true(fabs(last.mean - first.mean) <= 0.05 * first.most + ROUNDING);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(energy_stays_bounded_over_a_million_steps)};
  return cmocka_run_group_tests_name("long_motion", tests, NULL, NULL);
}
