/* Static equilibria: found from afar, with what is kept in place, redundant rows, singular M; and errors where there are none. */
#include "close.h"
#include "constrained_models.h"
#include "evaluation.h"
#include "pen.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <string.h>

enum { MOST = 4, TRIES = 40 };

/* Of accelerations beside forces of some 10 m/s^2, and of places that these determine at unit stiffness. */
#define BALANCE 1e-13

static evaluation start(const eom_model *model, const void *params) {
  return evaluation_start(model, params, NULL, eom_equilibrium_bytes);
}

static eom_status find(evaluation *f, double *q, double *qd, eom_equilibrium *e) {
  return eom_find_equilibrium(f->sys, q, qd, 0, e, f->memory, f->bytes);
}

/* Both masses on the vertical through the pivot, above or below each other, from anywhere. */
static void double_pendulum(void **state) {
  (void)state;
  evaluation f = start(&cartesian_double_pendulum, NULL);
  rng r = {1};
  int seen[2][2] = {{0}};
  for (int k = 0; k < TRIES; k++) {
    double q[4], qd[4] = {0};
    for (int i = 0; i < 4; i++) q[i] = rng_uniform(&r, -1, 1);
    eom_equilibrium e = {0};
    assert_int_equal(find(&f, q, qd, &e), EOM_OK);
    assert_close(q[0], 0, 0, BALANCE), assert_close(q[2], 0, 0, BALANCE);
    const int up = q[1] > 0, on = q[3] > q[1];
    assert_close(q[1], up ? 1 : -1, 0, BALANCE), assert_close(q[3], q[1] + (on ? 1 : -1), 0, BALANCE);
    assert_true(e.residual < BALANCE * 10 && e.steps < 60 && e.most_q >= 0 && e.change_qd == 0 && e.most_qd == -1);
    assert_int_equal(e.linear.d, 4);
    for (int i = 0; i < 4; i++) assert_true(qd[i] == 0), assert_close(f.sys->qdd[i], 0, 0, BALANCE * 10);
    seen[up][on]++;
  }
  assert_true(seen[0][0] > 0 && seen[0][0] + seen[0][1] + seen[1][0] + seen[1][1] == TRIES);
  evaluation_stop(&f);
}

/* The circle written three times, and the lowest point. */
static void redundant_rows(void **state) {
  (void)state;
  const redundancy rows = {.rows = 3, .factor = {1, 1e8, -1e-8}};
  evaluation f = start(&redundant, &rows);
  double q[2] = {0.4, -0.7}, qd[2] = {0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_OK);
  assert_close(q[0], 0, 0, BALANCE), assert_close(q[1], -1, 0, BALANCE);
  evaluation_stop(&f);
}

/* L = 2 w^2 - 2 z of the axis (M of rank 3 of 4): the axis hangs or stands; the turn about it does not matter and stays nearly as it
 * is. */
static void quaternion(void **state) {
  (void)state;
  evaluation f = start(&quaternion_top, NULL);
  rng r = {2};
  for (int k = 0; k < TRIES; k++) {
    double q[4], qd[4] = {0};
    for (int i = 0; i < 4; i++) q[i] = rng_uniform(&r, -1, 1);
    eom_equilibrium e = {0};
    assert_int_equal(find(&f, q, qd, &e), EOM_OK);
    const double along = q[0] * q[0] + q[3] * q[3], across = q[1] * q[1] + q[2] * q[2];
    assert_close(along + across, 1, 1e-14, 0);
    assert_close(fmin(along, across), 0, 0, BALANCE);
    assert_int_equal(e.linear.d, 6);
  }
  evaluation_stop(&f);
}

/* A point without mass on the parabola y = x + x^2/2 + .. of another, pulled down: its lowest place x = -1. */
static void coordinate_without_mass(void **state) {
  (void)state;
  evaluation f = start(&massless, NULL);
  double q[2] = {0.3, 0.1}, qd[2] = {0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_OK);
  assert_close(q[0], -1, 0, BALANCE), assert_close(q[1], -0.5, 0, BALANCE);
  assert_int_equal(e.most_q, 0);
  assert_close(e.change_q, 1.3, 0, BALANCE);
  evaluation_stop(&f);
}

/* A double pendulum whose lower mass may not move sideways has no equilibrium but below the pivot; kept elsewhere it accelerates. */
static void what_is_kept_stays(void **state) {
  (void)state;
  evaluation f = start(&cartesian_double_pendulum, NULL);
  const unsigned char keep[4] = {0, 0, 1, 0};
  double q[4] = {0.2, -0.9, 0, -1.9}, qd[4] = {0};
  eom_equilibrium e = {.keep_q = keep};
  assert_int_equal(find(&f, q, qd, &e), EOM_OK);
  assert_true(q[2] == 0);
  assert_close(q[0], 0, 0, BALANCE), assert_close(q[3], -2, 0, BALANCE);
  double p[4] = {0.2, -0.9, 0.5, -1.8};
  assert_int_equal(find(&f, p, qd, &e), EOM_NO_EQUILIBRIUM);
  assert_true(p[0] == 0.2 && p[1] == -0.9 && p[2] == 0.5 && p[3] == -1.8);
  assert_true(e.residual > 0.1 && e.change_q == 0);
  double far[4] = {0.2, -0.9, 2.5, -0.5}; /* out of reach */
  const eom_status status = find(&f, far, qd, &e);
  assert_true(status == EOM_INCONSISTENT || status == EOM_NO_CONSISTENT_STATE);
  assert_true(e.residual == 0 && e.most_qdd == -1); /* nothing was looked at */
  evaluation_stop(&f);
}

/* A weaker and weaker pull, the farther: what the method runs after is no equilibrium, and the coordinate is named. */
static void nothing_holds(void **state) {
  (void)state;
  evaluation f = start(&central_field, NULL);
  double q[4] = {1, 1, 0, 0}, qd[4] = {0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_NO_EQUILIBRIUM);
  assert_int_equal(f.sys->report.index, 0);
  assert_true(f.sys->report.nrow == 0 && !f.sys->report.function);
  char text[1000];
  eom_report_text(&f.sys->report, text, sizeof text);
  assert_non_null(strstr(text, "coordinate 0 (counted from 0) still accelerates"));
  evaluation_stop(&f);
}

/* A circular orbit is steady, but not in these coordinates: its direction has an acceleration. */
static void a_turning_direction_accelerates(void **state) {
  (void)state;
  evaluation f = start(&central_field, NULL);
  double q[4] = {1, 1, 0, 0}, qd[4] = {0, 0, 1.3, 0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_NO_EQUILIBRIUM);
  evaluation_stop(&f);
}

static int one(const void *params) { return (void)params, 1; }
static size_t frame(const void *params) { return (void)params, PEN_FRAME; }

/* L = x'^2/2 - x + 2 sqrt(x). */
static void well_lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)t, (void)params;
  jet rest = sub(&p, times(&p, 2, root(&p, q)), q);
  pen_result(&p, out, add(&p, times(&p, 0.5, square(&p, qd)), rest));
  pen_lift(&p);
}

static const eom_model well = {
    .name = "well", .dof = one, .lagrangian = {.name = "well", .jet = well_lagrangian, .rows = one, .frame = frame}};

/* At x = 1; the first step of Newton's method from 4 goes to -4, where there is no state. */
static void steps_that_leave_the_domain_are_shortened(void **state) {
  (void)state;
  evaluation f = start(&well, NULL);
  double q[1] = {4}, qd[1] = {0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_OK);
  assert_close(q[0], 1, 0, BALANCE);
  evaluation_stop(&f);
}

static void bad_input(void **state) {
  (void)state;
  evaluation f = start(&cartesian_pendulum, NULL);
  double q[2] = {(double)NAN, 0}, qd[2] = {0};
  eom_equilibrium e = {0};
  assert_int_equal(find(&f, q, qd, &e), EOM_NOT_FINITE);
  q[0] = 0.1;
  assert_int_equal(eom_find_equilibrium(f.sys, q, qd, 0, &e, f.memory, f.bytes - 1), EOM_NO_MEMORY);
  qd[0] = 1; /* all velocities stay, and this one leaves the circle */
  q[0] = 1;
  assert_int_equal(find(&f, q, qd, &e), EOM_INCONSISTENT);
  assert_string_equal(f.sys->report.row[0].name, "circle");
  evaluation_stop(&f);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(double_pendulum),
      cmocka_unit_test(redundant_rows),
      cmocka_unit_test(quaternion),
      cmocka_unit_test(coordinate_without_mass),
      cmocka_unit_test(what_is_kept_stays),
      cmocka_unit_test(nothing_holds),
      cmocka_unit_test(a_turning_direction_accelerates),
      cmocka_unit_test(steps_that_leave_the_domain_are_shortened),
      cmocka_unit_test(bad_input),
  };
  return cmocka_run_group_tests_name("equilibrium", tests, NULL, NULL);
}
