/* The N-pendulum: accelerations, their exact derivative and energy against closed forms in quadruple precision. Built twice: with the
 * jet model by hand, and with GENERATED_MODEL for what tlgen makes of the plain C in examples/models. */
#include "close.h"
#include "pendulum_truth.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdio.h>

#define GRAVITY 9.81

#ifdef GENERATED_MODEL
#define PRINTED_SIZE 6 /* of the motion functions */

#include "pendulum.h"
#include "pendulum_tl.h"

typedef struct pendulum pendulum;
static pendulum links(int n) {
  pendulum p = {.n = n, .g = GRAVITY};
  for (int i = 0; i < n; i++) p.mass[i] = p.length[i] = 1;
  return p;
}
#else
#include "pendulum_model.h"

static pendulum links(int n) { return (pendulum){.n = n, .g = GRAVITY}; }
#endif

#define STATES 100
#define MOST 16

/* The bound asked of the project: worst error at 100 random states in parts of the largest number of the result. Conditions of M up to
 * 1e3 cost three of the sixteen digits. */
#define PENDULUM_TOLERANCE 1e-12

static double largest(const double *x, int n) {
  double most = 0;
  for (int i = 0; i < n; i++) most = fmax(most, fabs(x[i]));
  return most;
}

/* Worst relative error of count numbers, kept in *worst. */
static void compare(const double *actual, const double *truth, int count, double *worst) {
  const double size = largest(truth, count);
  assert_all_close(actual, truth, count, 0.0, PENDULUM_TOLERANCE * size);
  for (int i = 0; i < count; i++) *worst = fmax(*worst, fabs(actual[i] - truth[i]) / size);
}

static void agrees_with_closed_form(void **state) {
  (void)state;
  static const int sizes[] = {1, 2, 3, 6, 16};
  rng r = {2016};
  for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
    const pendulum p = links(sizes[s]);
    const int n = p.n;
    eom_system *sys;
    assert_int_equal(eom_system_create(&sys, &pendulum_model, &p, NULL), EOM_OK);
#ifdef GENERATED_MODEL
    assert_int_equal(eom_system_emitter(sys, EOM_TASK_LINEARISE), n == PRINTED_SIZE ? EOM_EMITTER_MOTION : EOM_EMITTER_CALLS);
#endif
    double worst_a = 0, worst_F = 0, worst_E = 0;
    for (int k = 0; k < STATES; k++) {
      double q[MOST], qd[MOST], qdd[MOST], F[2 * MOST * MOST], E;
      for (int i = 0; i < n; i++) {
        q[i] = rng_uniform(&r, -4, 4);
        qd[i] = rng_uniform(&r, -3, 3);
      }
      pendulum_truth(n, GRAVITY, q, qd, qdd, F, &E);
      assert_int_equal(eom_linearise(sys, q, qd, 0), EOM_OK);
      compare(sys->qdd, qdd, n, &worst_a);
      compare(sys->qdd_y, F, 2 * n * n, &worst_F);
      assert_int_equal(eom_energy(sys, q, qd, 0), EOM_OK);
      compare(&sys->energy, &E, 1, &worst_E);
    }
    print_message("N=%d by %s: largest relative error of qdd %.1e, of its derivative %.1e, of the energy %.1e\n", n,
                  sys->motion ? "motion functions" : "calls", worst_a, worst_F, worst_E);
    eom_system_destroy(sys);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(agrees_with_closed_form)};
  return cmocka_run_group_tests_name("pendulum", tests, NULL, NULL);
}
