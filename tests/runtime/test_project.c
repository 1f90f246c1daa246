/* Projection onto the constraints: consistent afterwards, the least change in the mass metric, what is kept stays, contradictions are
 * named, and a long run on a rod does not drift. */
#include "close.h"
#include "constrained_models.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8, TRIES = 50 };

static eom_system *start(const eom_model *model, const void *params) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, NULL), EOM_OK);
  assert_true(sys->n <= MOST && sys->m <= MOST);
  return sys;
}

/* Any state, near enough to the constraints of every model here. */
static void draw(rng *r, int n, double *q, double *qd) {
  for (int i = 0; i < n; i++) q[i] = rng_uniform(r, 0.4, 1.2), qd[i] = rng_uniform(r, -1, 1);
}

static void assert_consistent(eom_system *sys, const double *q, const double *qd, double t, double tolerance) {
  assert_int_equal(eom_assemble(sys, q, qd, t), EOM_OK);
  for (int r = 0; r < sys->m1; r++) assert_close(sys->phi[r], 0, 0, tolerance), assert_close(sys->phi_dot[r], 0, 0, tolerance);
  for (int r = 0; r < sys->m2; r++) assert_close(sys->psi[r], 0, 0, tolerance);
}

/* Every model from random states, those too whose mass matrix is singular; a second projection changes nothing but the last digit. */
static void every_model_is_made_consistent(void **state) {
  (void)state;
  rng r = {1};
  for (int i = 0; i < nconstrained_models; i++) {
    eom_system *sys = start(constrained_models[i], NULL);
    for (int k = 0; k < TRIES; k++) {
      double q[MOST], qd[MOST], q2[MOST], qd2[MOST];
      const double t = rng_uniform(&r, 0, 1);
      draw(&r, sys->n, q, qd);
      eom_projection done = {0};
      const eom_status status = eom_project(sys, q, qd, t, &done);
      if (status == EOM_NO_INERTIA) continue; /* of a point where nothing holds a coordinate without mass */
      if (status != EOM_OK) print_error("model %s: %s\n", constrained_models[i]->name, eom_status_text(status));
      assert_int_equal(status, EOM_OK);
      assert_consistent(sys, q, qd, t, 1e-13);
      memcpy(q2, q, sizeof q), memcpy(qd2, qd, sizeof qd);
      assert_int_equal(eom_project(sys, q2, qd2, t, NULL), EOM_OK);
      for (int j = 0; j < sys->n; j++) assert_close(q2[j], q[j], 1e-14, 1e-14), assert_close(qd2[j], qd[j], 1e-13, 1e-13);
    }
    eom_system_destroy(sys);
  }
}

/* Beside the constraints, as a step of integration ends: one factorisation leads to the same state as many. */
static void steps_are_brought_back_by_one_factorisation(void **state) {
  (void)state;
  const double beside = 1e-6, same = 1e-11; /* they differ by the square of beside */
  rng r = {3};
  int by_one = 0;
  for (int i = 0; i < nconstrained_models; i++) {
    eom_system *sys = start(constrained_models[i], NULL);
    int once = 0;
    for (int k = 0; k < TRIES; k++) {
      double q[MOST], qd[MOST], q2[MOST], qd2[MOST];
      const double t = rng_uniform(&r, 0, 1);
      draw(&r, sys->n, q, qd);
      if (eom_project(sys, q, qd, t, NULL) == EOM_NO_INERTIA) continue;
      for (int j = 0; j < sys->n; j++) q[j] += beside * rng_uniform(&r, -1, 1), qd[j] += beside * rng_uniform(&r, -1, 1);
      memcpy(q2, q, sizeof q), memcpy(qd2, qd, sizeof qd);
      eom_projection step = {.after_step = 1}, anew = {0};
      assert_int_equal(eom_project(sys, q, qd, t, &step), EOM_OK);
      once += sys->report.condition == -1;
      assert_consistent(sys, q, qd, t, 1e-13);
      assert_int_equal(eom_project(sys, q2, qd2, t, &anew), EOM_OK);
      assert_true(sys->report.condition != -1);
      for (int j = 0; j < sys->n; j++) assert_close(q[j], q2[j], same, same), assert_close(qd[j], qd2[j], same, same);
      assert_close(step.change_q, anew.change_q, 0, same), assert_close(step.change_qd, anew.change_qd, 0, same);
    }
    print_message("%s: %d of %d\n", constrained_models[i]->name, once, TRIES);
    by_one += once >= TRIES - 5;
    eom_system_destroy(sys);
  }
  assert_true(by_one >= 7); /* three have a mass matrix that is singular */
}

/* What is left of a change is allowed by the rows, what was taken stands across all that is allowed. */
static void changes_lose_what_the_rows_forbid(void **state) {
  (void)state;
  rng r = {4};
  for (int i = 0; i < nconstrained_models; i++) {
    eom_system *sys = start(constrained_models[i], NULL);
    const int n = sys->n;
    for (int k = 0; k < TRIES; k++) {
      double q[MOST], qd[MOST], d[2][MOST], was[2][MOST], scale = 0;
      const double t = rng_uniform(&r, 0, 1);
      draw(&r, n, q, qd), draw(&r, n, d[0], d[1]);
      if (eom_project(sys, q, qd, t, NULL) == EOM_NO_INERTIA) continue;
      memcpy(was, d, sizeof d);
      assert_int_equal(eom_project_change(sys, d[0], d[1], q, qd, t), EOM_OK);
      assert_int_equal(eom_assemble(sys, q, qd, t), EOM_OK);
      for (int j = 0; j < n * n; j++) scale = fmax(scale, fabs(sys->M[j]));
      for (int half = 0; half < 2; half++) {
        double across = 0;
        for (int c = 0; c < (half ? sys->m : sys->m1); c++) {
          double miss = 0;
          for (int j = 0; j < n; j++) miss += sys->A[c * n + j] * d[half][j];
          assert_close(miss, 0, 0, 1e-12);
        }
        for (int j = 0; j < n; j++)
          for (int l = 0; l < n; l++) across += d[half][j] * sys->M[j * n + l] * (d[half][l] - was[half][l]);
        assert_close(across, 0, 0, 1e-11 * fmax(scale, 1));
      }
    }
    eom_system_destroy(sys);
  }
}

/* The nearest point of the circle and the velocity along it, in closed form. */
static void a_point_goes_to_the_nearest_place(void **state) {
  (void)state;
  rng r = {2};
  eom_system *sys = start(&cartesian_pendulum, NULL);
  for (int k = 0; k < TRIES; k++) {
    double q[2], qd[2];
    draw(&r, 2, q, qd);
    assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
    const double length = hypot(q[0], q[1]), x = q[0] / length, y = q[1] / length, along = y * qd[0] - x * qd[1];
    const double radius = sqrt(length * length - sys->phi[0]); /* phi = x^2 + y^2 - radius^2 */
    assert_int_equal(eom_project(sys, q, qd, 0, NULL), EOM_OK);
    assert_close(q[0], radius * x, 1e-14, 0), assert_close(q[1], radius * y, 1e-14, 0);
    assert_close(qd[0], y * along, 0, 1e-14), assert_close(qd[1], -x * along, 0, 1e-14);
  }
  eom_system_destroy(sys);
}

/* The change of velocities is A' times multipliers in the mass metric: no other change to consistent ones is shorter. */
static void the_change_is_the_least(void **state) {
  (void)state;
  rng r = {3};
  eom_system *sys = start(&cartesian_double_pendulum, NULL);
  for (int k = 0; k < TRIES; k++) {
    double q[4], qd[4], was[4], impulse[4];
    draw(&r, 4, q, qd);
    assert_int_equal(eom_project(sys, q, qd, 0, NULL), EOM_OK);
    for (int i = 0; i < 4; i++) was[i] = qd[i] = rng_uniform(&r, -1, 1);
    assert_int_equal(eom_project(sys, q, qd, 0, NULL), EOM_OK);
    assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
    for (int i = 0; i < 4; i++) {
      impulse[i] = 0;
      for (int j = 0; j < 4; j++) impulse[i] += sys->M[i * 4 + j] * (qd[j] - was[j]);
    }
    double v[4] = {rng_uniform(&r, -1, 1), rng_uniform(&r, -1, 1), rng_uniform(&r, -1, 1), rng_uniform(&r, -1, 1)}, work = 0, size = 0;
    assert_int_equal(eom_project(sys, q, v, 0, NULL), EOM_OK); /* phi does not depend on t: v is a virtual displacement */
    for (int i = 0; i < 4; i++) work += impulse[i] * v[i], size += fabs(impulse[i] * v[i]);
    assert_close(work, 0, 0, 1e-13 * (1 + size));
  }
  eom_system_destroy(sys);
}

static void what_is_kept_stays(void **state) {
  (void)state;
  eom_system *sys = start(&cartesian_double_pendulum, NULL);
  const unsigned char keep[4] = {1, 0, 0, 1};
  double q[4] = {0.6, -0.7, 1.1, -1.4}, qd[4] = {0.3, 0.2, -0.5, 0.1};
  eom_projection p = {.keep_q = keep, .keep_qd = keep};
  assert_int_equal(eom_project(sys, q, qd, 0, &p), EOM_OK);
  assert_true(q[0] == 0.6 && q[3] == -1.4 && qd[0] == 0.3 && qd[3] == 0.1);
  assert_true(p.steps_q > 0 && p.steps_qd > 0 && (p.most_q == 1 || p.most_q == 2) && p.change_q > 0 && p.change_qd > 0);
  assert_consistent(sys, q, qd, 0, 1e-14);
  const unsigned char all[4] = {1, 1, 1, 1};
  double fixed[4] = {0.6, -0.7, 1.1, -1.4};
  p = (eom_projection){.keep_q = all};
  assert_int_equal(eom_project(sys, fixed, qd, 0, &p), EOM_INCONSISTENT);
  assert_int_equal(sys->report.nrow, 2);
  assert_true(fixed[1] == -0.7 && p.most_q == -1 && p.change_q == 0);
  eom_system_destroy(sys);
}

static void agreeing_rows_are_no_difficulty_and_contradictions_are_named(void **state) {
  (void)state;
  redundancy rows = {.rows = 3, .factor = {1, 1e8, -1e-8}};
  eom_system *sys = start(&redundant, &rows);
  double q[2] = {0.9, -0.8}, qd[2] = {0.4, 0.3};
  assert_int_equal(eom_project(sys, q, qd, 1, NULL), EOM_OK);
  assert_close(hypot(q[0], q[1]), 1, 1e-14, 0);
  assert_close(q[0] * qd[0] + q[1] * qd[1], 0, 0, 1e-14);
  rows.bend[0] = 0.5; /* another circle than the other rows */
  double p[2] = {0.9, -0.8}, pd[2] = {0.4, 0.3};
  const eom_status status = eom_project(sys, p, pd, 1, NULL);
  assert_true(status == EOM_INCONSISTENT || status == EOM_NO_CONSISTENT_STATE);
  assert_true(p[0] == 0.9 && p[1] == -0.8 && pd[0] == 0.4);
  const double bad[2] = {(double)NAN, 0};
  memcpy(p, bad, sizeof p);
  assert_int_equal(eom_project(sys, p, pd, 1, NULL), EOM_NOT_FINITE);
  eom_system_destroy(sys);
}

/* Each with the name of what is wrong, and the state as it was. */
static void bad_input_is_named(void **state) {
  (void)state;
  static const struct {
    double q[2], qd[2], t;
    eom_status status;
    const char *function;
    int index;
  } cases[] = {
      {{(double)NAN, 1}, {0, 0}, 0, EOM_NOT_FINITE, "argument q", 0},
      {{0.6, (double)INFINITY}, {0, 0}, 0, EOM_NOT_FINITE, "argument q", 1},
      {{0.6, 0.8}, {0, (double)NAN}, 0, EOM_NOT_FINITE, "argument qd", 1},
      {{0.6, 0.8}, {0, 0}, (double)NAN, EOM_NOT_FINITE, "argument t", 0},
      {{1e200, 0.8}, {0, 0}, 0, EOM_NOT_FINITE, "circle", -1}, /* its square overflows */
      {{0, 0}, {1, 0}, 0, EOM_INCONSISTENT, NULL, -1},         /* no direction leads to the circle from its centre */
  };
  eom_system *sys = start(&cartesian_pendulum, NULL);
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    double q[2], qd[2];
    memcpy(q, cases[k].q, sizeof q), memcpy(qd, cases[k].qd, sizeof qd);
    eom_projection p = {.most_q = 7};
    assert_int_equal(eom_project(sys, q, qd, cases[k].t, &p), cases[k].status);
    if (cases[k].function) assert_string_equal(sys->report.function, cases[k].function);
    assert_int_equal(sys->report.index, cases[k].index);
    assert_memory_equal(q, cases[k].q, sizeof q);
    assert_memory_equal(qd, cases[k].qd, sizeof qd);
    if (cases[k].status == EOM_INCONSISTENT) assert_string_equal(sys->report.row[0].name, "circle");
  }
  eom_system_destroy(sys);
}

/* Seven rows for two coordinates: the same circle in every row, then a contradiction in the last. */
static void more_rows_than_coordinates(void **state) {
  (void)state;
  redundancy rows = {.rows = 7, .factor = {1, 2, -3, 1e-4, 1e4, 5, 6}};
  eom_system *sys = start(&redundant, &rows);
  double q[2] = {0.9, -0.8}, qd[2] = {0.4, 0.3};
  assert_int_equal(eom_project(sys, q, qd, 1, NULL), EOM_OK);
  assert_close(hypot(q[0], q[1]), 1, 1e-14, 0);
  assert_int_equal(eom_acceleration(sys, q, qd, 1), EOM_OK);
  assert_int_equal(sys->report.rank, 1);
  assert_int_equal(sys->report.nrow, 6);
  rows.bend[6] = 1e-2;
  assert_int_equal(eom_acceleration(sys, q, qd, 1), EOM_INCONSISTENT);
  assert_true(eom_project(sys, q, qd, 1, NULL) != EOM_OK);
  eom_system_destroy(sys);
}

/* x^2 + y^2 + 1 = 0: no state anywhere. */
static void a_constraint_without_solution_is_named(void **state) {
  (void)state;
  redundancy rows = {.rows = 1, .factor = {1}, .bend = {4}};
  eom_system *sys = start(&redundant, &rows);
  double q[2] = {0.9, -0.8}, qd[2] = {0.4, 0.3};
  assert_int_equal(eom_project(sys, q, qd, 1, NULL), EOM_NO_CONSISTENT_STATE);
  assert_int_equal(sys->report.nrow, 1);
  assert_string_equal(sys->report.row[0].name, "circles");
  assert_true(q[0] == 0.9 && q[1] == -0.8 && qd[0] == 0.4 && qd[1] == 0.3);
  eom_system_destroy(sys);
}

typedef struct drift {
  eom_system *sys;
  double phi, phi_dot, energy, energy0;
} drift;

static int observe(void *user, const eom_integrator *it) {
  drift *d = user;
  if (eom_assemble(d->sys, it->y, it->y + 2, it->t) != EOM_OK) return 1;
  d->phi = fmax(d->phi, fabs(d->sys->phi[0])), d->phi_dot = fmax(d->phi_dot, fabs(d->sys->phi_dot[0]));
  d->energy = fmax(d->energy, fabs(d->sys->energy - d->energy0));
  return 0;
}

/* Ten thousand steps, with and without: energy suffers less with. */
static void projected_steps_do_not_drift(void **state) {
  (void)state;
  drift with = {.sys = start(&cartesian_pendulum, NULL)}, without;
  double y0[4] = {0.8, -0.6, 0, 0}, *work = malloc(eom_integrator_size(&eom_dp5, 4) * sizeof *work);
  assert_non_null(work);
  assert_int_equal(eom_project(with.sys, y0, y0 + 2, 0, NULL), EOM_OK);
  assert_int_equal(eom_energy(with.sys, y0, y0 + 2, 0), EOM_OK);
  with.energy0 = with.sys->energy;
  without = with;
  for (int corrected = 0; corrected < 2; corrected++) {
    eom_integrator it;
    eom_integrator_init(&it, &eom_dp5, eom_rhs, with.sys, 4, 0, y0, 0.02, work);
    if (corrected) it.correct = eom_project_state;
    assert_int_equal(eom_integrate(&it, 200, observe, corrected ? &with : &without), EOM_OK);
  }
  print_message("|phi| %.1e and %.1e, energy %.1e and %.1e\n", with.phi, without.phi, with.energy, without.energy);
  assert_true(with.phi < 1e-14 && with.phi_dot < 1e-13);
  assert_true(with.energy <= without.energy);
  assert_true(without.phi > 1e-9); /* so that there is something to project */
  free(work);
  eom_system_destroy(with.sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_model_is_made_consistent),
      cmocka_unit_test(steps_are_brought_back_by_one_factorisation),
      cmocka_unit_test(changes_lose_what_the_rows_forbid),
      cmocka_unit_test(a_point_goes_to_the_nearest_place),
      cmocka_unit_test(the_change_is_the_least),
      cmocka_unit_test(what_is_kept_stays),
      cmocka_unit_test(agreeing_rows_are_no_difficulty_and_contradictions_are_named),
      cmocka_unit_test(bad_input_is_named),
      cmocka_unit_test(more_rows_than_coordinates),
      cmocka_unit_test(a_constraint_without_solution_is_named),
      cmocka_unit_test(projected_steps_do_not_drift),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
