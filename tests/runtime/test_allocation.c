/* No evaluation allocates: malloc and its relatives are interposed and counted. Built twice: with models by hand, and with
 * GENERATED_MODEL for what tlgen makes of the plain C in examples/models. */
#include "close.h"

#ifdef GENERATED_MODEL
#include "pendulum.h"
#include "pendulum_tl.h"
#else
#include "constrained_models.h"
#include "pendulum_motion.h"
#endif

#include "eom/eom.h"

#include <stdlib.h>

/* The C library's own, under its second name. */
extern void *__libc_malloc(size_t), *__libc_calloc(size_t, size_t), *__libc_realloc(void *, size_t);

static volatile long allocations;

void *malloc(size_t bytes) {
  allocations++;
  return __libc_malloc(bytes);
}
void *calloc(size_t count, size_t bytes) {
  allocations++;
  return __libc_calloc(count, bytes);
}
void *realloc(void *old, size_t bytes) {
  allocations++;
  return __libc_realloc(old, bytes);
}

/* Under a tool that replaces malloc itself nothing is counted, and there is nothing to say. */
static void skip_unless_counting(void) {
  const long before = allocations;
  void *volatile block = malloc(1);
  free(block);
  if (allocations == before) skip();
}

static void evaluate(const eom_model *model, const void *params, eom_linalg_choice linalg) {
  eom_options options = eom_options_default();
  options.linalg = linalg;
  eom_system *sys;
  const eom_status status = eom_system_create(&sys, model, params, &options);
  if (status == EOM_BAD_OPTION && linalg == EOM_LINALG_LAPACK) return;
  assert_int_equal(status, EOM_OK);
  double y[128] = {0.6, 0.8, 0.1, 0.2}, work[16 * 128];
  const int n = sys->n;
  eom_integrator it;
  eom_lyapunov *ly;
  eom_lyapunov_options exponents = eom_lyapunov_options_default();
  exponents.interval = 1e-3;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &exponents, 0, y), EOM_OK);

  const long before = allocations;
  assert_int_equal(eom_linearise(sys, y, y + n, 0), EOM_OK);
  eom_integrator_init(&it, &eom_dp5, eom_rhs, sys, 2 * n, 0, y, 1e-3, work);
  assert_int_equal(eom_integrate(&it, 5e-3, NULL, NULL), EOM_OK);
  for (int k = 0; k < 3; k++) assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
  char text[400];
  double mean, half;
  eom_lyapunov_interval(ly, 0, &mean, &half);
  assert_int_equal(allocations - before, 0);
  eom_report_text(&sys->report, text, sizeof text);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

static void no_evaluation_allocates(void **state) {
  (void)state;
  skip_unless_counting();
#ifdef GENERATED_MODEL
  const struct pendulum printed = {.n = 6, .g = 9.81, .mass = {1, 1, 1, 1, 1, 1}, .length = {1, 1, 1, 1, 1, 1}};
  for (eom_linalg_choice linalg = EOM_LINALG_CORE; linalg <= EOM_LINALG_LAPACK; linalg++) evaluate(&pendulum_model, &printed, linalg);
#else
  const pendulum small = {3, 9.81};
  const eom_model by_motion = pendulum_with_motion();
  for (eom_linalg_choice linalg = EOM_LINALG_CORE; linalg <= EOM_LINALG_LAPACK; linalg++) {
    evaluate(&pendulum_model, &small, linalg);
    evaluate(&by_motion, &small, linalg);
    evaluate(&cartesian_double_pendulum, NULL, linalg);
    evaluate(&mixed, NULL, linalg);
  }
#endif
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(no_evaluation_allocates)};
  return cmocka_run_group_tests_name("allocation", tests, NULL, NULL);
}
