/* Systems: sizes, memory, validation of models and options, needs, reports. */
#include "close.h"
#include "constrained_models.h"
#include "pendulum_model.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static eom_status create_and_destroy(const eom_model *model, const void *params, const eom_options *options) {
  eom_system *sys = (eom_system *)1;
  const eom_status status = eom_system_create(&sys, model, params, options);
  assert_true((sys != NULL) == (status == EOM_OK));
  eom_system_destroy(sys);
  assert_true((eom_system_bytes(model, params, options) > 0) == (status == EOM_OK));
  return status;
}

static int minus_one(const void *params) {
  (void)params;
  return -1;
}
static int two_rows(const void *params) {
  (void)params;
  return 2;
}
static size_t huge_frame(const void *params) {
  (void)params;
  return (size_t)-1 / 4;
}

static void impossible_models(void **state) {
  (void)state;
  const pendulum none = {0, 9.81}, one = {1, 9.81};
  assert_int_equal(create_and_destroy(NULL, NULL, NULL), EOM_BAD_MODEL);
  assert_int_equal(create_and_destroy(&pendulum_model, NULL, NULL), EOM_NO_PARAMS);
  assert_int_equal(create_and_destroy(&pendulum_model, &none, NULL), EOM_BAD_MODEL);
  eom_model m = pendulum_model;
  m.dof = minus_one;
  assert_int_equal(create_and_destroy(&m, &one, NULL), EOM_BAD_MODEL);
  m = pendulum_model;
  m.lagrangian.jet = NULL;
  assert_int_equal(create_and_destroy(&m, &one, NULL), EOM_BAD_MODEL);
  m = pendulum_model;
  m.lagrangian.rows = two_rows;
  assert_int_equal(create_and_destroy(&m, &one, NULL), EOM_BAD_MODEL);
  m = pendulum_model;
  m.force = m.lagrangian;
  m.force.rows = two_rows; /* one coordinate */
  assert_int_equal(create_and_destroy(&m, &one, NULL), EOM_BAD_MODEL);
  m = cartesian_pendulum;
  m.holonomic = NULL;
  assert_int_equal(create_and_destroy(&m, NULL, NULL), EOM_BAD_MODEL);
  eom_function phi = cartesian_pendulum.holonomic[0];
  phi.rows = minus_one;
  m.holonomic = &phi;
  assert_int_equal(create_and_destroy(&m, NULL, NULL), EOM_BAD_MODEL);
  m = pendulum_model;
  m.lagrangian.frame = huge_frame;
  assert_int_equal(create_and_destroy(&m, &one, NULL), EOM_NO_MEMORY);
  const pendulum enormous = {2000000, 9.81};
  assert_int_equal(create_and_destroy(&pendulum_model, &enormous, NULL), EOM_NO_MEMORY);
}

static void impossible_options(void **state) {
  (void)state;
  const double zero = 0, negative = -1, no_number = nan(""), fine = 1;
  const double *bad_weights[] = {&zero, &negative, &no_number};
  eom_options o = eom_options_default();
  for (int i = 0; i < 3; i++) {
    o.weights = bad_weights[i];
    assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
  }
  o.weights = &fine;
  assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_OK);
  const double bad_tolerance[] = {-1e-9, 1, nan(""), HUGE_VAL};
  for (int i = 0; i < 4; i++) {
    o = eom_options_default();
    o.rank_tolerance = bad_tolerance[i];
    assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
    o = eom_options_default();
    o.consistency_tolerance = bad_tolerance[i];
    assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
  }
  o = eom_options_default();
  o.needs = EOM_NEED_ALL + 1;
  assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
  o = eom_options_default();
  o.linalg = (eom_linalg_choice)9;
  assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
#ifndef EOM_HAVE_LAPACKE
  o.linalg = EOM_LINALG_LAPACK;
  assert_int_equal(create_and_destroy(&cartesian_pendulum, NULL, &o), EOM_BAD_OPTION);
#endif
}

/* Exactly the bytes asked for are enough at any alignment (the sanitizer watches the ends), one fewer is refused. */
static void callers_memory(void **state) {
  (void)state;
  const double q[3] = {0.3, 0.4, 0.1}, qd[3] = {0.1, 0.2, 0.3};
  const size_t bytes = eom_system_bytes(&mixed, NULL, NULL);
  for (size_t shift = 0; shift < 64; shift += 9) {
    char *memory = malloc(bytes + shift);
    memset(memory, 0xff, bytes + shift);
    eom_system sys;
    assert_int_equal(eom_system_init(&sys, &mixed, NULL, NULL, memory + shift, bytes - 1), EOM_NO_MEMORY);
    assert_int_equal(eom_system_init(&sys, &mixed, NULL, NULL, memory + shift, bytes), EOM_OK);
    assert_int_equal(eom_linearise(&sys, q, qd, 0), EOM_OK);
    free(memory);
  }
}

static void needs_decide_memory(void **state) {
  (void)state;
  const pendulum p = {6, 9.81};
  eom_options o = eom_options_default();
  const size_t linearise = eom_system_bytes(&pendulum_model, &p, &o);
  o.needs = EOM_NEED_SIMULATE;
  const size_t simulate = eom_system_bytes(&pendulum_model, &p, &o);
  print_message("six links: %zu bytes to simulate, %zu to linearise\n", simulate, linearise);
  assert_true(simulate * 2 < linearise);
  eom_system *sys;
  const double q[6] = {0.3}, qd[6] = {0};
  assert_int_equal(eom_system_create(&sys, &pendulum_model, &p, &o), EOM_OK);
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  assert_null(sys->qdd_y);
  eom_system_destroy(sys);
}

/* Weights are copied: the caller's array may go. */
static void weights_are_copied(void **state) {
  (void)state;
  double w = 100;
  eom_options o = eom_options_default();
  o.weights = &w;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &cartesian_pendulum, NULL, &o), EOM_OK);
  w = -1;
  assert_true(sys->options.weights != &w);
  assert_close(sys->options.weights[0], 100, 0, 0);
  eom_system_destroy(sys);
}

static void rows_have_names(void **state) {
  (void)state;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &mixed, NULL, NULL), EOM_OK);
  assert_string_equal(eom_system_row(sys, 0).name, "bowl");
  assert_string_equal(eom_system_row(sys, 1).name, "steering");
  eom_system_destroy(sys);
  assert_int_equal(eom_system_create(&sys, &cartesian_double_pendulum, NULL, NULL), EOM_OK);
  assert_int_equal(eom_system_row(sys, 1).row, 1);
  assert_string_equal(eom_system_row(sys, 1).source, "model.c:20");
  eom_system_destroy(sys);
}

/* Fields of assemble with closed forms: M symmetric to the bit, phi and its derivative, momentum and energy. */
static void assembled_fields(void **state) {
  (void)state;
  eom_system *sys;
  const double q[4] = {0.3, -0.4, 0.5, 0.6}, qd[4] = {1, 2, -1, 0.5};
  assert_int_equal(eom_system_create(&sys, &cartesian_double_pendulum, NULL, NULL), EOM_OK);
  assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
  const double M[4] = {1, 1, 3, 3};
  for (int i = 0; i < 16; i++) assert_close(sys->M[i], i / 4 == i % 4 ? M[i / 4] : 0, 0, 0);
  assert_close(sys->phi[0], 0.09 + 0.16 - 1, 1e-15, 0);
  assert_close(sys->phi[1], 0.04 + 1 - 1, 0, 1e-15);
  assert_close(sys->phi_dot[0], 2 * (0.3 * 1 - 0.4 * 2), 1e-15, 0);
  assert_close(sys->phi_dot[1], 2 * (0.2 * -2 + 1 * -1.5), 1e-15, 0);
  assert_close(sys->b[1], -2 * (4 + 2.25), 1e-15, 0);
  const double Q[4] = {-0.3, -9.81 - 0.6, 0.3, -3 * 9.81 - 0.15};
  assert_all_close(sys->Q, Q, 4, 1e-15, 0);
  assert_close(sys->momentum[2], -3, 1e-15, 0);
  const double kinetic = 0.5 * (1 + 4) + 1.5 * (1 + 0.25), potential = 9.81 * (-0.4 + 3 * 0.6);
  assert_close(sys->energy, kinetic + potential, 1e-15, 0);
  assert_close(sys->lagrangian, kinetic - potential, 1e-14, 0);
  const double energy = sys->energy;
  sys->energy = 0;
  assert_int_equal(eom_energy(sys, q, qd, 0), EOM_OK);
  assert_close(sys->energy, energy, 1e-15, 0);
  eom_system_destroy(sys);

  assert_int_equal(eom_system_create(&sys, &quaternion_top, NULL, NULL), EOM_OK);
  assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) assert_true(sys->M[4 * i + j] == sys->M[4 * j + i]);
  eom_system_destroy(sys);
}

/* What a system was not asked for it does not do; nor does it go on with other sizes than it began with. */
static void what_was_not_asked_for(void **state) {
  (void)state;
  pendulum p = {.n = 2, .g = 9.81};
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_SIMULATE;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &pendulum_model, &p, &options), EOM_OK);
  const double q[3] = {0.1, 0.2, 0.3}, w[4] = {1, 0, 0, 0};
  double out[4];
  assert_int_equal(eom_linearise(sys, q, q, 0), EOM_BAD_OPTION);
  assert_string_equal(sys->report.function, "options.needs");
  assert_int_equal(eom_residual(sys, out, q, q, q, 0), EOM_BAD_OPTION);
  assert_int_equal(eom_tangent(sys, out, NULL, 1, w, q, q, 0), EOM_BAD_OPTION);
  assert_int_equal(eom_parameter_derivatives(sys, out, NULL, q, q, 0), EOM_BAD_OPTION);
  eom_minimal minimal;
  assert_int_equal(eom_linearise_minimal(sys, &minimal, q, q, 0, NULL, 0), EOM_BAD_OPTION);
  assert_int_equal(eom_acceleration(sys, q, q, 0), EOM_OK);
  p.n = 3;
  assert_int_equal(eom_acceleration(sys, q, q, 0), EOM_SIZES_CHANGED);
  assert_string_equal(sys->report.function, "pendulum");
  assert_int_equal(eom_energy(sys, q, q, 0), EOM_SIZES_CHANGED);
  p.n = 2;
  assert_int_equal(eom_acceleration(sys, q, q, 0), EOM_OK);
  eom_system_destroy(sys);
}

/* A report is cut to the room there is, and says how much it needs. */
static void report_text(void **state) {
  (void)state;
  for (int i = 0; i <= EOM_STOPPED; i++) assert_true(strlen(eom_status_text((eom_status)i)) > 5);
  assert_string_equal(eom_status_text((eom_status)99), "unknown status");
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &floating, NULL, NULL), EOM_OK);
  const double q[2] = {0};
  assert_int_equal(eom_acceleration(sys, q, q, 0), EOM_NO_INERTIA);
  char text[400], small[20];
  const int length = eom_report_text(&sys->report, text, sizeof text);
  assert_int_equal(length, (int)strlen(text));
  assert_int_equal(eom_report_text(&sys->report, small, sizeof small), length);
  assert_int_equal(strlen(small), sizeof small - 1);
  assert_memory_equal(small, text, sizeof small - 1);
  assert_int_equal(eom_report_text(&sys->report, NULL, 0), length);
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(impossible_models),   cmocka_unit_test(impossible_options), cmocka_unit_test(callers_memory),
      cmocka_unit_test(needs_decide_memory), cmocka_unit_test(weights_are_copied), cmocka_unit_test(rows_have_names),
      cmocka_unit_test(assembled_fields),    cmocka_unit_test(report_text),        cmocka_unit_test(what_was_not_asked_for)};
  return cmocka_run_group_tests_name("system", tests, NULL, NULL);
}
