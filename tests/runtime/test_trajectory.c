/* Trajectories: every method against the same truth, with constraints, events, output and failures. */
#include "close.h"
#include "constrained_models.h"
#include "pendulum_model.h"

#include "eom/eom.h"
#include "eom/trajectory.h"

#include <math.h>
#include <string.h>

static eom_system *start(const eom_model *model, const void *params) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  return sys;
}

/* Method i of those that need no more of a model than its functions on jets. */
static const eom_trajectory_method *method_on_jets(int i) {
  for (int k = 0;; k++) {
    const eom_trajectory_method *method = eom_trajectory_method_at(k);
    if (method && strcmp(method->name, "taylor") == 0) continue;
    if (!method || i-- == 0) return method;
  }
}

/* Tolerances; where steps cannot be chosen by them, a length whose error is like that. */
static eom_trajectory_options options_for(const eom_trajectory_method *method, double tolerance) {
  if (!method->chosen) return (eom_trajectory_options){.method = method->name, .h = 0.3 * pow(tolerance, 1.0 / method->order)};
  return (eom_trajectory_options){.method = method->name, .control = {.rtol = tolerance, .atol = tolerance}};
}

/* A double pendulum in angles. */
static const pendulum two = {.n = 2, .g = 9.81};

/* The state after 2 s by small fixed steps of order 8: two lengths of step agree to 1e-13. */
static void truth_of(eom_system *sys, double t, const double *y0, double *y) {
  eom_trajectory *r;
  const eom_trajectory_options options = {.method = "dop853", .h = t / 1000};
  assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_OK);
  assert_int_equal(eom_trajectory_to(r, t, NULL, NULL), EOM_OK);
  memcpy(y, eom_trajectory_state(r), 2 * (size_t)sys->n * sizeof *y);
  eom_trajectory_destroy(r);
}

static void every_method_follows_the_motion(void **state) {
  (void)state;
  eom_system *sys = start(&pendulum_model, &two);
  const double y0[4] = {1.0, -0.5, 0.3, 0.7};
  double truth[4];
  truth_of(sys, 2.0, y0, truth);
  const eom_trajectory_method *method;
  for (int i = 0; (method = method_on_jets(i)); i++) {
    double last = 1;
    for (double tolerance = 1e-4; tolerance > (method->chosen ? 1e-9 : 1e-7); tolerance /= 100) {
      const eom_trajectory_options options = options_for(method, tolerance);
      eom_trajectory *r;
      assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_OK);
      assert_int_equal(eom_trajectory_to(r, 2.0, NULL, NULL), EOM_OK);
      assert_true(eom_trajectory_time(r) == 2.0);
      double error = 0;
      for (int k = 0; k < 4; k++) error = fmax(error, fabs(eom_trajectory_state(r)[k] - truth[k]));
      const eom_trajectory_work work = eom_trajectory_worked(r);
      print_message("%-16s tolerance %.0e: error %.1e, %ld steps, %ld refused, %ld evaluations, %ld Jacobians\n", method->name,
                    tolerance, error, work.steps, work.rejected, work.evaluations, work.jacobians);
      assert_true(error < 2000 * tolerance && error < last);
      assert_true(work.steps > 0 && work.evaluations >= work.steps && (work.jacobians > 0) == (method->implicit != 0));
      last = error;
      /* and back: a fixed step does not lead there */
      assert_int_equal(eom_trajectory_to(r, 2.0, NULL, NULL), EOM_OK);
      if (!method->chosen) {
        assert_int_equal(eom_trajectory_to(r, 0.0, NULL, NULL), EOM_BAD_OPTION);
        eom_trajectory_destroy(r);
        continue;
      }
      assert_int_equal(eom_trajectory_to(r, 0.0, NULL, NULL), EOM_OK);
      for (int k = 0; k < 4; k++) assert_close(eom_trajectory_state(r)[k], y0[k], 0, 20000 * tolerance);
      eom_trajectory_destroy(r);
    }
  }
  eom_system_destroy(sys);
}

static void projected_steps_stay_on_the_constraints(void **state) {
  (void)state;
  eom_system *sys = start(&cartesian_pendulum, NULL);
  const double off[4] = {1.01, 0, 0.1, 0.2};
  const eom_trajectory_method *method;
  for (int i = 0; (method = method_on_jets(i)); i++) {
    eom_trajectory_options options = options_for(method, 1e-5);
    options.project = 1;
    eom_trajectory *r;
    if (!method->projects) {
      assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, off), EOM_BAD_OPTION);
      assert_null(r);
      continue;
    }
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, off), EOM_OK);
    for (int k = 1; k <= 10; k++) {
      assert_int_equal(eom_trajectory_to(r, k, NULL, NULL), EOM_OK);
      const double *y = eom_trajectory_state(r);
      assert_close(y[0] * y[0] + y[1] * y[1], 1, 0, 1e-13);
      assert_close(y[0] * y[2] + y[1] * y[3], 0, 0, 1e-12);
    }
    eom_trajectory_destroy(r);
  }
  eom_system_destroy(sys);
}

/* ---- events and output ---- */

typedef struct record {
  int count;
  double t[8], value[8];
  double written[5];
  int writes;
} record;

/* The first angle, and the second one. */
static int angles(void *user, double t, const double *y, double *g) {
  (void)user, (void)t;
  g[0] = y[0];
  g[1] = y[1] - 10;
  return 0;
}

static eom_event_action bounce(void *user, int event, double t, double *y) {
  record *seen = user;
  assert_int_equal(event, 0);
  assert_true(seen->count < 8);
  seen->t[seen->count] = t;
  seen->value[seen->count++] = y[0];
  if (seen->count == 3) return EOM_EVENT_STOP;
  y[2] = -y[2];
  return EOM_EVENT_CHANGED;
}

static void write_angle(void *user, double t, const double *y) {
  record *seen = user;
  assert_true(seen->writes < 5);
  assert_close(t, 0.1 * seen->writes, 1e-15, 0);
  seen->written[seen->writes++] = y[0];
}

static void events_and_output_are_the_same_by_all(void **state) {
  (void)state;
  eom_system *sys = start(&pendulum_model, &two);
  const double y0[4] = {1.0, -0.5, 0.3, 0.7};
  const int falling[2] = {-1, 0};
  record first = {0};
  const eom_trajectory_method *method;
  for (int i = 0; (method = method_on_jets(i)); i++) {
    record seen = {0};
    double work[64];
    eom_events events = {.count = 2, .root = angles, .handle = bounce, .user = &seen, .direction = falling, .work = work};
    eom_outputs outputs = {.write = write_angle, .user = &seen, .every = 0.1, .count = 5};
    assert_true(eom_events_size(2) <= 64);
    eom_trajectory_options options = options_for(method, method->chosen ? 1e-11 : 1e-7);
    options.events = &events;
    options.outputs = &outputs;
    eom_trajectory *r;
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_OK);
    assert_int_equal(eom_trajectory_to(r, 20, NULL, NULL), EOM_STOPPED);
    assert_true(eom_trajectory_time(r) == seen.t[2]);
    assert_int_equal(seen.count, 3);
    assert_int_equal(events.found, 3);
    assert_int_equal(seen.writes, 5);
    if (i == 0) first = seen;
    for (int k = 0; k < 3; k++) {
      assert_close(seen.value[k], 0, 0, 1e-8);
      assert_close(seen.t[k], first.t[k], 0, 1e-5);
    }
    for (int k = 0; k < 5; k++) assert_close(seen.written[k], first.written[k], 0, 1e-6);
    eom_trajectory_destroy(r);
  }
  eom_system_destroy(sys);
}

/* ---- failures ---- */

static int stop_at_once(void *observer, const eom_trajectory *trajectory) {
  (void)trajectory;
  return ++*(int *)observer == 2;
}

static void failures_have_a_status(void **state) {
  (void)state;
  eom_system *sys = start(&cartesian_pendulum, NULL), *no_derivatives;
  const double y0[4] = {1, 0, 0, 0}, nowhere[4] = {0, 0, 1, 0};
  eom_options simple = eom_options_default();
  simple.needs = EOM_NEED_SIMULATE;
  assert_int_equal(eom_system_create(&no_derivatives, &cartesian_pendulum, NULL, &simple), EOM_OK);
  const eom_trajectory_options unknown = {.method = "euler", .h = 0.1};
  eom_trajectory *r;
  assert_int_equal(eom_trajectory_create(&r, sys, &unknown, 0, y0), EOM_BAD_OPTION);
  const eom_trajectory_options series = {.method = "taylor", .control = {.rtol = 1e-6}};
  assert_int_equal(eom_trajectory_create(&r, sys, &series, 0, y0), EOM_BAD_OPTION); /* the model has no motion functions */
  const eom_trajectory_method *method;
  for (int i = 0; (method = method_on_jets(i)); i++) {
    eom_trajectory_options options = options_for(method, 1e-6);
    int calls = 0;
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_OK);
    assert_int_equal(eom_trajectory_to(r, (double)INFINITY, NULL, NULL), EOM_BAD_OPTION);
    assert_int_equal(eom_trajectory_to(r, 10, stop_at_once, &calls), EOM_STOPPED);
    assert_int_equal(calls, 2);
    assert_int_equal(eom_trajectory_to(r, 1, NULL, NULL), EOM_OK);
    eom_trajectory_destroy(r);

    options.control.most_steps = 3;
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_OK);
    assert_int_equal(eom_trajectory_to(r, 10, NULL, NULL), EOM_TOO_MUCH_WORK);
    assert_true(eom_trajectory_time(r) > 0 && eom_trajectory_time(r) < 10);
    eom_trajectory_destroy(r);

    options.control.most_steps = 0; /* the rod has no direction at the centre: its row is zero and asks for an acceleration */
    if (method->chosen) {
      assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, nowhere), EOM_OK);
      assert_int_equal(eom_trajectory_to(r, 1, NULL, NULL), EOM_RHS_FAILED);
      assert_true(eom_trajectory_time(r) == 0);
      eom_trajectory_destroy(r);
    } else { /* variational methods begin on the constraints */
      assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, nowhere), EOM_INCONSISTENT);
    }
    assert_int_equal(sys->report.status, EOM_INCONSISTENT);

    options.control = (eom_step_control){.rtol = -1};
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), EOM_BAD_OPTION);
    options.control = (eom_step_control){0};
    options.h = 0.1;
    assert_int_equal(eom_trajectory_create(&r, sys, &options, 0, y0), method->fixed ? EOM_OK : EOM_BAD_OPTION);
    eom_trajectory_destroy(r);
    options = options_for(method, 1e-6);
    assert_int_equal(eom_trajectory_create(&r, no_derivatives, &options, 0, y0), method->implicit ? EOM_BAD_OPTION : EOM_OK);
    eom_trajectory_destroy(r);
  }
  eom_trajectory_destroy(NULL);
  eom_system_destroy(sys);
  eom_system_destroy(no_derivatives);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_method_follows_the_motion),
                                     cmocka_unit_test(projected_steps_stay_on_the_constraints),
                                     cmocka_unit_test(events_and_output_are_the_same_by_all), cmocka_unit_test(failures_have_a_status)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
