/* Variational steps: orders, constraints, reversal, energy and momenta, events, refusals. */
#include "close.h"
#include "constrained_models.h"
#include "pendulum_model.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8 /* numbers of a state */ };

typedef struct run {
  eom_system *sys;
  eom_variational v;
  eom_integrator it;
  double *work;
} run;

static void start(run *r, const eom_model *model, const void *params, int order, double t, const double *y, double h) {
  assert_int_equal(eom_system_create(&r->sys, model, params, NULL), EOM_OK);
  r->work = malloc(eom_variational_size(r->sys, order) * sizeof *r->work);
  assert_int_equal(eom_variational_init(&r->v, &r->it, r->sys, order, t, y, h, r->work), EOM_OK);
}

static void finish(run *r) {
  eom_system_destroy(r->sys);
  free(r->work);
}

static const pendulum two = {.n = 2, .g = 9.81};

/* ---- orders ---- */

typedef struct motion {
  const char *name;
  const eom_model *model;
  const void *params;
  int n;
  double t0, t1, y[MOST]; /* brought onto the constraints */
} motion;

static const motion motions[] = {
    {"pendulum", &pendulum_model, &two, 2, 0, 1, {1.0, -0.5, 0.3, 0.7}},
    {"cartesian_pendulum", &cartesian_pendulum, NULL, 2, 0, 1, {0.8, -0.6, 0.3, 0.4}},
    {"cartesian_double_pendulum", &cartesian_double_pendulum, NULL, 4, 0, 1, {0.8, -0.6, 1.6, -1.2, 0.3, 0.4, 0.1, -0.2}}, /* drag */
    {"rotating_hoop", &rotating_hoop, NULL, 3, 0.1, 1.1, {0.7, 0.1, 0.5, 0, 0, 0.2}},               /* explicit time */
    {"relativistic", &relativistic, NULL, 3, 0.2, 1.2, {0.6, 0.4, 0.5, 0.5, -0.5, 0.4}},            /* not quadratic in velocity */
    {"quaternion_top", &quaternion_top, NULL, 4, 0, 0.5, {0.8, 0.3, 0.2, 0.4, 0.5, 1.0, 0.3, 0.2}}, /* singular M */
};

static void truth_of(const motion *m, double *y) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, m->model, m->params, NULL), EOM_OK);
  memcpy(y, m->y, 2 * (size_t)m->n * sizeof *y);
  assert_int_equal(eom_project(sys, y, y + m->n, m->t0, NULL), EOM_OK);
  double *work = malloc(eom_integrator_size(&eom_dop853, 2 * m->n) * sizeof *work);
  eom_integrator it;
  eom_integrator_init(&it, &eom_dop853, eom_rhs, sys, 2 * m->n, m->t0, y, 0, work);
  const eom_step_control control = {.rtol = 1e-14, .atol = 1e-14};
  assert_int_equal(eom_integrator_control(&it, &control), EOM_OK);
  it.correct = eom_project_state;
  assert_int_equal(eom_integrate(&it, m->t1, NULL, NULL), EOM_OK);
  memcpy(y, it.y, 2 * (size_t)m->n * sizeof *y);
  free(work);
  eom_system_destroy(sys);
}

static double error_of(const motion *m, int order, int steps, const double *truth) {
  run r;
  start(&r, m->model, m->params, order, m->t0, m->y, (m->t1 - m->t0) / steps);
  assert_int_equal(eom_integrate(&r.it, m->t1, NULL, NULL), EOM_OK);
  assert_int_equal(r.it.steps, steps);
  double error = 0;
  for (int i = 0; i < 2 * m->n; i++) error = fmax(error, fabs(r.it.y[i] - truth[i]));
  finish(&r);
  return error;
}

/* Errors of fewer units of the last place show no order: order 6 on two of the motions, whose errors are below 1e-12. */
#define VISIBLE 1e-11

static void halving_the_step_shows_the_order(void **state) {
  (void)state;
  static const int steps[] = {160, 80, 40};
  for (size_t k = 0; k < sizeof motions / sizeof motions[0]; k++) {
    double truth[MOST];
    truth_of(&motions[k], truth);
    for (int order = 2; order <= 6; order += 2) {
      const int count = steps[order / 2 - 1];
      const double once = error_of(&motions[k], order, count, truth), twice = error_of(&motions[k], order, 2 * count, truth);
      print_message("%-26s order %d: %.2e, %.2e: falls by %.1f\n", motions[k].name, order, once, twice, once / twice);
      if (once > VISIBLE) assert_close(once / twice, pow(2, order), 0.15, 0);
    }
  }
}

/* ---- what steps keep ---- */

/* Newton's steps on positions and velocities end at rounding, also where rows are repeated. */
static void constraints_hold_to_rounding(void **state) {
  (void)state;
  static const redundancy repeated = {3, {1, -2, 0.5}, {0}};
  static const motion more = {"redundant", &redundant, &repeated, 2, 0, 1, {0.8, -0.6, 0.3, 0.4}};
  for (size_t k = 1; k <= sizeof motions / sizeof motions[0]; k++) {
    const motion *m = k < sizeof motions / sizeof motions[0] ? &motions[k] : &more;
    for (int order = 2; order <= 6; order += 2) {
      run r;
      double phi = 0, rate = 0;
      start(&r, m->model, m->params, order, m->t0, m->y, 0.01);
      for (int i = 0; i < 100; i++) {
        assert_int_equal(eom_integrator_step(&r.it), EOM_OK);
        assert_int_equal(eom_assemble(r.sys, r.it.y, r.it.y + m->n, r.it.t), EOM_OK);
        for (int c = 0; c < r.sys->m1; c++) phi = fmax(phi, fabs(r.sys->phi[c])), rate = fmax(rate, fabs(r.sys->phi_dot[c]));
      }
      print_message("%-26s order %d: phi %.1e, phi' %.1e, %.1f iterations per step\n", m->name, order, phi, rate,
                    (double)r.v.iterations / 100);
      assert_true(phi <= 2e-15 && rate <= 1e-14);
      finish(&r);
    }
  }
}

/* Forwards and back by as many steps: what is left is rounding, which the motion enlarges. */
static void steps_back_undo_steps(void **state) {
  (void)state;
  for (size_t k = 0; k < sizeof motions / sizeof motions[0]; k++)
    for (int order = 2; order <= 6; order += 2) {
      const motion *m = &motions[k];
      const double h = 0.01, end = m->t0 + 300 * h;
      double y0[MOST], error = 0;
      run there, back;
      start(&there, m->model, m->params, order, m->t0, m->y, h);
      memcpy(y0, there.it.y, sizeof(double) * 2 * (size_t)m->n);
      assert_int_equal(eom_integrate(&there.it, end, NULL, NULL), EOM_OK);
      start(&back, m->model, m->params, order, end, there.it.y, -h);
      assert_int_equal(eom_integrate(&back.it, m->t0, NULL, NULL), EOM_OK);
      for (int i = 0; i < 2 * m->n; i++) error = fmax(error, fabs(back.it.y[i] - y0[i]));
      print_message("%-26s order %d: %.1e after 300 steps and back\n", m->name, order, error);
      assert_true(error < 1e-10);
      finish(&there);
      finish(&back);
    }
}

/* Without gravity the sum of the momenta of the angles is kept. */
static void momenta_of_symmetries_are_kept(void **state) {
  (void)state;
  static const pendulum floating_chain = {.n = 2, .g = 0};
  const double y0[4] = {1.0, -0.5, 0.3, 2.0};
  for (int order = 2; order <= 6; order += 2) {
    run r;
    start(&r, &pendulum_model, &floating_chain, order, 0, y0, 0.02);
    double first = 0, worst = 0;
    for (int i = 0; i < 2000; i++) {
      assert_int_equal(eom_energy(r.sys, r.it.y, r.it.y + 2, r.it.t), EOM_OK);
      const double sum = r.sys->momentum[0] + r.sys->momentum[1];
      if (i == 0) first = sum;
      worst = fmax(worst, fabs(sum - first));
      assert_int_equal(eom_integrator_step(&r.it), EOM_OK);
    }
    print_message("order %d: sum of momenta changes by %.1e of %.1f\n", order, worst, first);
    assert_true(worst < 1e-14);
    finish(&r);
  }
}

/* The error of the energy swings within bounds, and its mean stays where it is. test_long_motion.c follows it for longer. */
static void energy_errors_are_bounded(void **state) {
  (void)state;
  enum { STEPS = 10000, PARTS = 2 };
  const double y0[4] = {0.5, -0.3, 0, 0};
  for (int order = 2; order <= 6; order += 2) {
    run r;
    start(&r, &pendulum_model, &two, order, 0, y0, 0.02);
    assert_int_equal(eom_energy(r.sys, y0, y0 + 2, 0), EOM_OK);
    const double first = r.sys->energy;
    double most[PARTS] = {0}, mean[PARTS] = {0};
    for (int i = 0; i < STEPS; i++) {
      assert_int_equal(eom_integrator_step(&r.it), EOM_OK);
      assert_int_equal(eom_energy(r.sys, r.it.y, r.it.y + 2, r.it.t), EOM_OK);
      const double error = r.sys->energy - first;
      const int part = i / (STEPS / PARTS);
      most[part] = fmax(most[part], fabs(error));
      mean[part] += error / (STEPS / PARTS);
    }
    print_message("order %d: at most %.2e J, then %.2e J; mean %.2e J, then %.2e J\n", order, most[0], most[1], mean[0], mean[1]);
    assert_true(most[1] < 1.1 * most[0] && fabs(mean[1] - mean[0]) < 0.05 * most[0]);
    finish(&r);
  }
}

/* ---- inside a step ---- */

/* At three quarters of the last step: the largest difference from a run one of whose steps ends there. */
static double dense_error(const motion *m, double h, int steps) {
  run r, fine;
  double y[MOST], error = 0;
  start(&r, m->model, m->params, 6, m->t0, m->y, h);
  start(&fine, m->model, m->params, 6, m->t0, m->y, h / 4);
  for (int i = 0; i < steps; i++) assert_int_equal(eom_integrator_step(&r.it), EOM_OK);
  for (int i = 0; i < 4 * steps - 1; i++) assert_int_equal(eom_integrator_step(&fine.it), EOM_OK);
  assert_int_equal(eom_integrator_at(&r.it, fine.it.t, y), EOM_OK);
  for (int i = 0; i < 2 * m->n; i++) error = fmax(error, fabs(y[i] - fine.it.y[i]));
  finish(&r);
  finish(&fine);
  return error;
}

/* Measured: 31.8 for 2^5. */
static void states_inside_a_step(void **state) {
  (void)state;
  const double once = dense_error(&motions[1], 0.02, 10), twice = dense_error(&motions[1], 0.01, 20);
  print_message("errors %.2e, %.2e: falls by %.1f\n", once, twice, once / twice);
  assert_close(once / twice, 32, 0.15, 0);
}

static int falling_through_zero(void *user, double t, const double *y, double *g) { return (void)user, (void)t, g[0] = y[0], 0; }

static void ignore_output(void *user, double t, const double *y) { (void)t, (void)y, ++*(int *)user; }

static eom_event_action go_on(void *user, int event, double t, double *y) {
  (void)event, (void)t;
  assert_close(hypot(y[0], y[1]), 1, 0, 1e-15); /* brought onto the circle */
  ++*(int *)user;
  return EOM_EVENT_GO_ON;
}

/* To the bit. */
static void looking_changes_nothing(void **state) {
  (void)state;
  const motion *m = &motions[1];
  run plain, watched;
  int outputs = 0, passages = 0;
  double work[8];
  start(&plain, m->model, m->params, 4, 0, m->y, 0.01);
  start(&watched, m->model, m->params, 4, 0, m->y, 0.01);
  eom_events events = {.count = 1, .root = falling_through_zero, .handle = go_on, .user = &passages, .work = work};
  eom_outputs output = {.write = ignore_output, .user = &outputs, .every = 0.013, .count = 200};
  assert_true(eom_events_size(1) <= 8);
  watched.it.events = &events;
  watched.it.outputs = &output;
  assert_int_equal(eom_integrate(&plain.it, 5, NULL, NULL), EOM_OK);
  assert_int_equal(eom_integrate(&watched.it, 5, NULL, NULL), EOM_OK);
  assert_true(passages > 3 && outputs == 200);
  assert_memory_equal(plain.it.y, watched.it.y, 4 * sizeof(double));
  finish(&plain);
  finish(&watched);
}

/* ---- refusals ---- */

static void what_cannot_be_is_refused(void **state) {
  (void)state;
  const double y0[4] = {1.0, -0.5, 0.3, 0.7}, y6[6] = {0.4, -0.3, 0.2, 0.5, 0.1, 0.3};
  eom_system *sys;
  eom_variational v;
  eom_integrator it;
  double work[4096], y[4];
  assert_int_equal(eom_system_create(&sys, &sleigh, NULL, NULL), EOM_OK); /* nonholonomic */
  assert_true(eom_variational_size(sys, 6) <= 4096);
  assert_int_equal(eom_variational_init(&v, &it, sys, 4, 0, y6, 0.01, work), EOM_BAD_OPTION);
  eom_system_destroy(sys);
  assert_int_equal(eom_system_create(&sys, &pendulum_model, &two, NULL), EOM_OK);
  assert_int_equal(eom_variational_size(sys, 3), 0);
  assert_int_equal(eom_variational_init(&v, &it, sys, 3, 0, y0, 0.01, work), EOM_BAD_OPTION);
  assert_int_equal(eom_variational_init(&v, &it, sys, 4, 0, y0, 2.0, work), EOM_OK);
  assert_int_equal(eom_integrator_control(&it, &(eom_step_control){.rtol = 1e-6}), EOM_BAD_OPTION);
  /* a step that Newton's method does not solve leaves the state where it was */
  memcpy(y, it.y, sizeof y);
  char text[200];
  assert_int_equal(eom_integrator_step(&it), EOM_NO_STEP);
  assert_int_equal(sys->report.status, EOM_NO_STEP);
  assert_true(eom_report_text(&sys->report, text, sizeof text) > 0 && strstr(text, "not settled"));
  assert_memory_equal(it.y, y, sizeof y);
  assert_true(it.t == 0 && it.steps == 0);
  it.h = 0.001;
  assert_int_equal(eom_integrator_step(&it), EOM_OK);
  eom_system_destroy(sys);
}

/* A model function that fails on the way is the system's to name. */
static void failures_of_the_model_are_named(void **state) {
  (void)state;
  const motion *m = &motions[4]; /* no value beyond the speed 5 */
  const double fast[6] = {0.6, 0.4, 0.5, 0.5, -0.5, 0.4};
  run r;
  start(&r, m->model, m->params, 2, 0, fast, 0.01);
  r.it.y[3] = r.it.y[4] = 4;
  assert_int_equal(eom_integrator_step(&r.it), EOM_RHS_FAILED);
  assert_int_equal(r.it.rhs_code, EOM_DOMAIN);
  assert_int_equal(r.sys->report.status, EOM_DOMAIN);
  assert_non_null(r.sys->report.function);
  finish(&r);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(halving_the_step_shows_the_order),
      cmocka_unit_test(constraints_hold_to_rounding),
      cmocka_unit_test(steps_back_undo_steps),
      cmocka_unit_test(momenta_of_symmetries_are_kept),
      cmocka_unit_test(energy_errors_are_bounded),
      cmocka_unit_test(states_inside_a_step),
      cmocka_unit_test(looking_changes_nothing),
      cmocka_unit_test(what_cannot_be_is_refused),
      cmocka_unit_test(failures_of_the_model_are_named),
  };
  return cmocka_run_group_tests_name("variational", tests, NULL, NULL);
}
