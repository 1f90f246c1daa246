/* Integration by Taylor series: a pendulum whose motion is known, by chosen and fixed steps, both ways, inside steps and to events. */
#include "bob_tl.h"
#include "close.h"
#include "exp_motion_tl.h"
#include "swing_tl.h"

#include "eom/eom.h"
#include "eom/taylor.h"
#ifdef HAVE_TRAJECTORY
#include "eom/trajectory.h"
#endif

#include <math.h>
#include <stdlib.h>

static double work[4096];

static eom_system *system_of(const eom_model *model, const eom_options *options) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, NULL, options), EOM_OK);
  assert_true(eom_taylor_size(sys) <= sizeof work / sizeof work[0]);
  return sys;
}

/* q = 4 atan(e^t) - pi. */
static void known(double t, double *y) {
  y[0] = 4.0 * atan(exp(t)) - acos(-1.0);
  y[1] = 2.0 / cosh(t);
}

typedef struct run {
  eom_system *sys;
  eom_taylor series;
  eom_integrator it;
} run;

static void start(run *r, double t, double h, double tolerance) {
  double y[2];
  known(t, y);
  r->sys = system_of(&swing_model, NULL);
  assert_int_equal(eom_taylor_init(&r->series, &r->it, r->sys, t, y, h, work), EOM_OK);
  const eom_step_control control = {.rtol = tolerance, .atol = tolerance};
  if (tolerance > 0.0) assert_int_equal(eom_integrator_control(&r->it, &control), EOM_OK);
}

static double error(double t, const double *y) {
  double truth[2];
  known(t, truth);
  return fmax(fabs(y[0] - truth[0]), fabs(y[1] - truth[1]));
}

/* Measured: 0.2 to 1.5 tolerances; at 1e-15 rounding shows. */
static void tolerances(void **state) {
  (void)state;
  for (double tolerance = 1e-4; tolerance > 1e-16; tolerance *= 0.1) {
    run r;
    start(&r, -2.0, 0.0, tolerance);
    assert_int_equal(eom_integrate(&r.it, 2.0, NULL, NULL), EOM_OK);
    print_message("tolerance %.0e: error %.1e in %ld steps\n", tolerance, error(2.0, r.it.y), r.it.steps);
    assert_close(error(2.0, r.it.y), 0.0, 0.0, 10.0 * tolerance + 1e-14);
    assert_true(r.it.rejected == 0 && r.it.evaluations <= r.it.steps + 1);
    assert_true(r.it.steps <= 12); /* 14 to 16 by orders that are least work only where that is the square of the order */
    eom_system_destroy(r.sys);
  }
}

static int observe_inside(void *observer, const eom_integrator *it) {
  double y[2], *worst = observer;
  for (int j = 0; j <= 8; j++) {
    const double t = it->t_before + 0.125 * j * (it->t - it->t_before);
    assert_int_equal(eom_integrator_at(it, t, y), EOM_OK);
    *worst = fmax(*worst, error(t, y));
  }
  return 0;
}

static void inside_steps(void **state) {
  (void)state;
  run r;
  double worst = 0.0;
  start(&r, -2.0, 0.0, 1e-12);
  assert_int_equal(eom_integrate(&r.it, 2.0, observe_inside, &worst), EOM_OK);
  assert_true(worst > 0.0 && worst < 1e-11);
  eom_system_destroy(r.sys);
}

static void fixed_steps(void **state) {
  (void)state;
  run r;
  start(&r, -2.0, 0.25, 0.0);
  assert_int_equal(eom_integrate(&r.it, 2.0, NULL, NULL), EOM_OK);
  assert_int_equal(r.it.steps, 16);
  assert_close(error(2.0, r.it.y), 0.0, 0.0, 1e-14);
  eom_system_destroy(r.sys);
}

static void there_and_back(void **state) {
  (void)state;
  run r;
  start(&r, -2.0, 0.0, 1e-15);
  assert_int_equal(eom_integrate(&r.it, 1.0, NULL, NULL), EOM_OK);
  assert_int_equal(eom_integrate(&r.it, -2.0, NULL, NULL), EOM_OK);
  assert_true(r.it.t == -2.0);
  assert_close(error(-2.0, r.it.y), 0.0, 0.0, 1e-13);
  eom_system_destroy(r.sys);
}

static int lowest_point(void *user, tl_real t, const tl_real *y, tl_real *g) {
  (void)user, (void)t;
  g[0] = y[0];
  return 0;
}

static void events(void **state) {
  (void)state;
  static double event_work[64];
  run r;
  start(&r, -2.0, 0.0, 1e-13);
  eom_events watched = {.count = 1, .root = lowest_point, .work = event_work};
  assert_true(eom_events_size(1) <= 64);
  r.it.events = &watched;
  assert_int_equal(eom_integrate(&r.it, 2.0, NULL, NULL), EOM_STOPPED);
  assert_close(r.it.t, 0.0, 0.0, 1e-13);
  assert_close(error(0.0, r.it.y), 0.0, 0.0, 1e-12);
  eom_system_destroy(r.sys);
}

/* The same with its rod as a constraint, projected after each step. */
static void constrained(void **state) {
  (void)state;
  eom_system *sys = system_of(&bob_model, NULL);
  eom_taylor series;
  eom_integrator it;
  double angle[2];
  known(-2.0, angle);
  const double y[4] = {sin(angle[0]), -cos(angle[0]), cos(angle[0]) * angle[1], sin(angle[0]) * angle[1]};
  assert_int_equal(eom_taylor_init(&series, &it, sys, -2.0, y, 0.0, work), EOM_OK);
  assert_int_equal(eom_integrator_control(&it, &(eom_step_control){.rtol = 1e-12, .atol = 1e-12}), EOM_OK);
  it.correct = eom_project_state;
  assert_int_equal(eom_integrate(&it, 2.0, NULL, NULL), EOM_OK);
  known(2.0, angle);
  assert_close(it.y[0], sin(angle[0]), 0.0, 1e-11);
  assert_close(it.y[1], -cos(angle[0]), 0.0, 1e-11);
  assert_close(hypot(it.y[0], it.y[1]), 1.0, 0.0, 1e-15);
  eom_system_destroy(sys);
}

/* A motion that ends: e^q = e^q0 (1 + qd0 t) reaches 0 at t = 1. */
static void to_a_singularity(void **state) {
  (void)state;
  eom_system *sys = system_of(&exp_motion_model, NULL);
  eom_taylor series;
  eom_integrator it;
  const double y[2] = {0.0, -1.0};
  assert_int_equal(eom_taylor_init(&series, &it, sys, 0.0, y, 0.0, work), EOM_OK);
  assert_int_equal(eom_integrator_control(&it, &(eom_step_control){.rtol = 1e-10, .atol = 1e-10, .most_steps = 2000}), EOM_OK);
  assert_int_equal(eom_integrate(&it, 0.9, NULL, NULL), EOM_OK);
  assert_close(it.y[0], log(0.1), 0.0, 1e-8);
  const eom_status status = eom_integrate(&it, 2.0, NULL, NULL);
  print_message("%s at t = %.12f\n", eom_status_text(status), it.t);
  assert_int_not_equal(status, EOM_OK);
  assert_true(it.t < 1.0 + 1e-6);
  eom_system_destroy(sys);
}

static void refused(void **state) {
  (void)state;
  const double y[4] = {0.0, -1.0, 0.0, 0.0};
  eom_taylor series;
  eom_integrator it;
  for (int i = 0; i < 4; i++) {
    eom_options options = eom_options_default();
    eom_motion without = bob_motion;
    const eom_motion *const motions[] = {&without};
    eom_model model = bob_model;
    without.taylor = NULL;
    if (i == 0) options.emitter = EOM_EMITTER_CALLS;
    if (i == 1) options.baumgarte = (eom_baumgarte){.alpha = 1.0, .beta = 1.0};
    if (i == 2) options.hold.on = 1;
    if (i == 3) model.motion = motions;
    eom_system *sys = system_of(&model, &options);
    assert_int_equal(eom_taylor_init(&series, &it, sys, 0.0, y, 0.1, work), EOM_BAD_OPTION);
    eom_system_destroy(sys);
  }
}

/* ---- Lyapunov exponents along it ---- */

static eom_lyapunov *exponent_of(eom_system *sys, eom_lyapunov_options *options) {
  eom_lyapunov *ly;
  double y[2];
  known(-2.0, y);
  const double slope[2] = {y[1], -sin(y[0])};
  options->k = 1;
  options->taylor = 1;
  options->control = (eom_step_control){.rtol = 1e-14, .atol = 1e-14};
  options->start = slope;
  assert_int_equal(eom_lyapunov_create(&ly, sys, options, -2.0, y), EOM_OK);
  return ly;
}

/* y' is a tangent of the motion: it grows by |y'(t)|/|y'(t0)| with y' = (2/cosh t, -2 sinh t/cosh^2 t). Measured: at most 0.1 tolerances.
 */
static void exponents(void **state) {
  (void)state;
  for (double tolerance = 1e-3; tolerance > 1e-12; tolerance *= 0.1) {
    eom_system *sys = system_of(&swing_model, NULL);
    eom_lyapunov_options options = eom_lyapunov_options_default();
    options.interval = 0.5;
    options.tangent_tolerance = tolerance;
    eom_lyapunov *ly = exponent_of(sys, &options);
    assert_int_equal(eom_lyapunov_to(ly, 2.5, NULL, NULL), EOM_OK);
    const double growth = log(hypot(1.0, tanh(2.5)) / cosh(2.5)) - log(hypot(1.0, tanh(2.0)) / cosh(2.0));
    print_message("tolerance %.0e: error %.1e, %ld steps beside %ld\n", tolerance, ly->rho[0] - growth, ly->tangents.steps, ly->it.steps);
    assert_close(ly->rho[0], growth, 0.0, 10.0 * tolerance);
    assert_close(error(2.5, ly->y), 0.0, 0.0, 1e-12);
    assert_true(ly->energy_error < 1e-14);
    eom_lyapunov_destroy(ly);
    eom_system_destroy(sys);
  }
}

/* Between marks nothing is kept that a checkpoint has not. */
static void exponents_go_on(void **state) {
  (void)state;
  eom_system *sys = system_of(&swing_model, NULL);
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.interval = 0.3;
  eom_lyapunov *whole = exponent_of(sys, &options), *other = exponent_of(sys, &options);
  const size_t bytes = eom_lyapunov_image_bytes(whole);
  char *image = malloc(3 * bytes);
  assert_non_null(image);
  assert_int_equal(eom_lyapunov_to(whole, 0.0, NULL, NULL), EOM_OK);
  eom_lyapunov_save(whole, image);
  assert_int_equal(eom_lyapunov_to(whole, 3.0, NULL, NULL), EOM_OK);
  assert_int_equal(eom_lyapunov_restore(other, image, bytes), EOM_OK);
  assert_int_equal(eom_lyapunov_to(other, 3.0, NULL, NULL), EOM_OK);
  eom_lyapunov_save(whole, image + bytes);
  eom_lyapunov_save(other, image + 2 * bytes);
  assert_memory_equal(image + bytes, image + 2 * bytes, bytes);
  free(image);
  eom_lyapunov_destroy(other);
  eom_lyapunov_destroy(whole);
  options.start = NULL;
  options.h = 0.1;
  const double y[2] = {0.0, 2.0};
  assert_int_equal(eom_lyapunov_create(&other, sys, &options, 0.0, y), EOM_BAD_OPTION);
  eom_system_destroy(sys);
}

#ifdef HAVE_TRAJECTORY
static void by_name(void **state) {
  (void)state;
  eom_system *sys = system_of(&swing_model, NULL);
  eom_trajectory *trajectory;
  double y[2];
  known(-2.0, y);
  const eom_trajectory_options options = {.method = "taylor", .control = {.rtol = 1e-12, .atol = 1e-12}};
  assert_int_equal(eom_trajectory_create(&trajectory, sys, &options, -2.0, y), EOM_OK);
  assert_int_equal(eom_trajectory_to(trajectory, 2.0, NULL, NULL), EOM_OK);
  assert_close(error(2.0, eom_trajectory_state(trajectory)), 0.0, 0.0, 1e-11);
  eom_trajectory_destroy(trajectory);
  eom_system_destroy(sys);
}
#endif

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(tolerances),       cmocka_unit_test(inside_steps), cmocka_unit_test(fixed_steps),
      cmocka_unit_test(there_and_back),   cmocka_unit_test(events),       cmocka_unit_test(constrained),
      cmocka_unit_test(to_a_singularity), cmocka_unit_test(refused),
      cmocka_unit_test(exponents),        cmocka_unit_test(exponents_go_on),
#ifdef HAVE_TRAJECTORY
      cmocka_unit_test(by_name),
#endif
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
