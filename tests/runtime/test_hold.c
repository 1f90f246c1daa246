/* Rank held between projections: hysteresis, events, rows left out, and singular positions passed without a jump, or a stop with a
 * report. */
#include "close.h"
#include "constrained_models.h"
#include "linkage.h"
#include "linkage_tl.h"
#include "slider_crank.h"
#include "slider_crank_tl.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static eom_system *start_with(const eom_model *model, const void *params, eom_hold hold) {
  eom_options options = eom_options_default();
  options.hold = hold;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  return sys;
}

static eom_system *start(const eom_model *model, const void *params, int on) {
  eom_hold hold = eom_options_default().hold;
  hold.on = on;
  return start_with(model, params, hold);
}

/* The largest change of a velocity by a projection, and of the energy. */
typedef struct watch {
  eom_system *sys;
  double energy, drift, jump;
} watch;

static int correct(void *user, double t, double *y) {
  watch *w = user;
  eom_projection p = {.after_step = 1};
  const eom_status status = eom_project(w->sys, y, y + w->sys->n, t, &p);
  w->jump = fmax(w->jump, p.change_qd);
  return (int)status;
}

static int rhs(void *user, double t, const double *y, double *ydot) { return eom_rhs(((watch *)user)->sys, t, y, ydot); }

static int observe(void *user, const eom_integrator *it) {
  watch *w = user;
  if (eom_energy(w->sys, it->y, it->y + w->sys->n, it->t) != EOM_OK) return 1;
  w->drift = fmax(w->drift, fabs(w->sys->energy - w->energy));
  return 0;
}

/* Goes from y to time t, projected after each step. What stopped it: rhs_code; 0 for nothing. */
static int run(watch *w, double t, double step, double *y) {
  const int n = w->sys->n;
  double *work = malloc(eom_integrator_size(&eom_dp5, 2 * n) * sizeof *work);
  assert_non_null(work);
  assert_int_equal(eom_project(w->sys, y, y + n, 0, NULL), EOM_OK);
  assert_int_equal(eom_energy(w->sys, y, y + n, 0), EOM_OK);
  w->energy = w->sys->energy;
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, rhs, w, 2 * n, 0, y, step, work);
  it.correct = correct;
  const eom_status status = eom_integrate(&it, t, observe, w);
  assert_true(status == EOM_OK || (status == EOM_RHS_FAILED && it.rhs_code != 0));
  memcpy(y, it.y, 2 * (size_t)n * sizeof(double));
  free(work);
  return status == EOM_OK ? 0 : it.rhs_code;
}

/* ---- slider-crank ---- */

/* The motion where the slider goes through: x = r cos a + sqrt(l^2 - r^2 sin^2 a), at r = l 2 r cos a; da/dt = 1. */
static void at_angle(const slider_crank *p, double a, double *y) {
  const double r = p->crank, l = p->rod, s = sin(a), c = cos(a);
  const double root = r == l ? r * c : sqrt(l * l - r * r * s * s);
  y[0] = r * c, y[1] = r * s, y[2] = r * c + root;
  y[3] = -r * s, y[4] = r * c;
  y[5] = r == l ? -2 * r * s : -r * s - r * r * s * c / root;
}

/* Twice the kinetic energy at da/dt = 1. */
static double inertia(const slider_crank *p, double a) {
  double y[6];
  at_angle(p, a, y);
  return p->pin_mass * (y[3] * y[3] + y[4] * y[4]) + p->slider_mass * y[5] * y[5];
}

/* Time from angle a on with da/dt = 1 there to angle b: the integral of sqrt(inertia(x)/inertia(a)) by Simpson's rule. */
static double time_between(const slider_crank *p, double a, double b) {
  const int n = 20000;
  const double h = (b - a) / n;
  double sum = 0;
  for (int i = 0; i <= n; i++) sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * sqrt(inertia(p, a + i * h) / inertia(p, a));
  return sum * h / 3;
}

/* Where crank and slider are after 15 rad, by the time that takes, on the way through four or five dead points. From 1/3 rad, from a
 * dead point itself and from beside it. Bounds: about ten times what is measured. */
static void dead_points_are_passed(void **state) {
  (void)state;
  static const struct {
    double rod, from, jump, place;
  } cases[] = {
      {1, 1.0 / 3, 1e-5, 1e-10}, {1, 1.5707963267948966, 1e-5, 1e-10}, {1, 1.570795, 1e-5, 1e-10}, {1.5, 1.0 / 3, 1e-13, 1e-12}};
  for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
    const slider_crank p = {.crank = 1, .rod = cases[k].rod, .pin_mass = 1, .slider_mass = 0.7};
    const double end = cases[k].from + 15;
    watch w = {.sys = start(&slider_crank_model, &p, 1)};
    double y[6], truth[6];
    at_angle(&p, cases[k].from, y);
    assert_int_equal(run(&w, time_between(&p, cases[k].from, end), 2e-3, y), 0);
    at_angle(&p, end, truth);
    print_message("rod %g from %.7g: jump %.1e, energy %.1e, place %.1e, rank changed %ld times\n", p.rod, cases[k].from, w.jump,
                  w.drift, hypot(y[0] - truth[0], y[1] - truth[1]), w.sys->rank_changes);
    assert_true(w.jump <= cases[k].jump && w.drift <= 1e-10);
    for (int i = 0; i < 3; i++) assert_close(y[i], truth[i], 0, cases[k].place);
    assert_true(p.rod == 1 || (w.sys->rank_changes == 0 && w.sys->held_rank == 2)); /* a longer rod has no singular position */
    eom_system_destroy(w.sys);
  }
}

typedef struct decision {
  double pivot; /* the smaller one, which is sqrt(5) a at pi/2 + a */
  int rank;
} decision;

/* States one after another, as after steps. */
static void assert_decisions(eom_hold hold, const decision *d, int count) {
  const slider_crank p = {.crank = 1, .rod = 1, .pin_mass = 1, .slider_mass = 1};
  eom_system *sys = start_with(&slider_crank_model, &p, hold);
  int events = 0;
  assert_int_equal(sys->held_rank, -1);
  for (int k = 0; k < count; k++) {
    double y[6];
    at_angle(&p, acos(-1) / 2 + d[k].pivot / sqrt(5), y);
    eom_projection step = {.after_step = k > 0};
    assert_int_equal(eom_project(sys, y, y + 3, 0, &step), EOM_OK);
    events += k > 0 && d[k].rank != d[k - 1].rank;
    assert_int_equal(sys->held_rank, d[k].rank);
    assert_int_equal(sys->report.rank, d[k].rank);
    assert_int_equal(sys->rank_changes, events);
    assert_int_equal(sys->report.nrow, 2 - d[k].rank);
    if (d[k].rank == 2) continue;
    assert_string_equal(sys->report.row[0].name, "slider_crank_rods");
    assert_int_equal(sys->report.row[0].kind, EOM_ROW_DEPENDENT);
  }
  eom_system_destroy(sys);
}

static void rank_has_hysteresis(void **state) {
  (void)state;
  static const decision d[] = {{1e-3, 2},  {2e-4, 2},    {0.5e-4, 1}, {2e-4, 1}, {1e-3, 2},
                               {-2e-4, 2}, {-0.5e-4, 1}, {0, 1},      {2e-4, 1}, {-4e-4, 2}};
  assert_decisions((eom_hold){.on = 1, .drop = 1e-4, .take = 3e-4}, d, sizeof d / sizeof d[0]);
}

/* A row is dropped before the step that takes it through zero, and not where it falls too slowly for that, grows, or falls by more than
 * ahead. */
static void rank_looks_ahead(void **state) {
  (void)state;
  static const decision d[] = {{9e-3, 2},  {4.9e-3, 1}, {1e-3, 1},  {-3e-3, 2}, {-8e-3, 2},
                               {-7e-3, 2}, {-6e-3, 2},  {-2e-3, 1}, {2e-3, 2}};
  assert_decisions((eom_hold){.on = 1, .drop = 1e-4, .take = 3e-4, .ahead = 1e-2}, d, sizeof d / sizeof d[0]);
  static const decision far[] = {{4e-2, 2}, {1.5e-2, 2}, {-1e-2, 2}};
  assert_decisions((eom_hold){.on = 1, .drop = 1e-4, .take = 3e-4, .ahead = 1e-2}, far, sizeof far / sizeof far[0]);
}

/* At a dead point: rows that are held there as two. */
static void a_rank_that_falls_in_between_is_reported(void **state) {
  (void)state;
  const slider_crank p = {.crank = 1, .rod = 1, .pin_mass = 1, .slider_mass = 1};
  eom_system *sys = start(&slider_crank_model, &p, 1);
  double y[6], dead[6] = {0, 1, 0, -1, 0, -2};
  at_angle(&p, 1, y);
  assert_int_equal(eom_project(sys, y, y + 3, 0, NULL), EOM_OK);
  assert_int_equal(eom_acceleration(sys, dead, dead + 3, 0), EOM_RANK_FELL);
  assert_int_equal(sys->report.nrow, 1);
  assert_string_equal(sys->report.row[0].name, "slider_crank_rods");
  assert_int_equal(eom_project(sys, dead, dead + 3, 0, NULL), EOM_OK); /* decides afresh */
  assert_int_equal(eom_acceleration(sys, dead, dead + 3, 0), EOM_OK);
  eom_system_destroy(sys);
}

/* ---- rows left out ---- */

/* Two equal rows, one of them held: the numbers of the model with one row, and no multiplier for the other. */
static void rows_that_are_dropped_are_left_out(void **state) {
  (void)state;
  const redundancy once = {.rows = 1, .factor = {3}}, twice = {.rows = 2, .factor = {1, 3}};
  eom_system *one = start(&redundant, &once, 0), *two = start(&redundant, &twice, 1);
  double q[2] = {0.6, -0.8}, qd[2] = {0.4, 0.3};
  assert_int_equal(eom_project(two, q, qd, 0, NULL), EOM_OK);
  assert_int_equal(two->held_rank, 1);
  const double beside[2] = {q[0] + 1e-3, q[1]}; /* as at a stage of a step */
  assert_int_equal(eom_linearise(one, beside, qd, 0), EOM_OK);
  assert_int_equal(eom_linearise(two, beside, qd, 0), EOM_OK);
  const int kept = two->row_kind[0] == EOM_ROW_INDEPENDENT ? 0 : 1;
  assert_true(two->lambda[1 - kept] == 0);
  assert_all_close(two->qdd, one->qdd, 2, 1e-14, 1e-14);
  assert_all_close(two->Qc, one->Qc, 2, 1e-14, 1e-14);
  assert_all_close(two->qdd_y, one->qdd_y, 8, 1e-13, 1e-13);
  for (int j = 0; j < 4; j++) assert_true(two->lambda_y[(1 - kept) * 4 + j] == 0);
  eom_system_destroy(one), eom_system_destroy(two);
}

/* ---- a linkage on one line ---- */

/* Pin C of the elbow that is up before the bars lie on one line at pi, and down after it. */
static void pin_of(double bx, double by, double *c) {
  const double dx = LINKAGE_GROUND - bx, dy = -by, d = hypot(dx, dy);
  const double along = (LINKAGE_COUPLER * LINKAGE_COUPLER - LINKAGE_ROCKER * LINKAGE_ROCKER + d * d) / (2 * d);
  const double up = sqrt(fmax(0, LINKAGE_COUPLER * LINKAGE_COUPLER - along * along)) * (by > 0 ? 1 : -1);
  c[0] = bx + along * dx / d - up * dy / d;
  c[1] = by + along * dy / d + up * dx / d;
}

#define CHORD 1e-4 /* rad */

/* From 1e-6 rad before all bars lie on one line. Without a held rank the first step makes velocities of any size: it is refused. */
static void a_linkage_passes_its_line(void **state) {
  (void)state;
  const double turn = acos(-1) - 1e-6;
  for (int hold = 0; hold < 2; hold++) {
    watch w = {.sys = start(&linkage_model, NULL, hold)};
    double y[8] = {2 * cos(turn), 2 * sin(turn)}, c[2];
    pin_of(y[0], y[1], y + 2);
    /* velocities that nearly fit: a chord of the motion through the line */
    const double next[2] = {2 * cos(turn + CHORD), 2 * sin(turn + CHORD)};
    pin_of(next[0], next[1], c);
    for (int i = 0; i < 2; i++) y[4 + i] = (next[i] - y[i]) / CHORD, y[6 + i] = (c[i] - y[2 + i]) / CHORD;
    const int stopped = run(&w, 1, 1e-3, y);
    if (!hold) {
      print_message("without: %s\n", eom_status_text((eom_status)stopped));
      assert_true(stopped == EOM_VELOCITY_JUMP || stopped == EOM_NO_CONSISTENT_STATE || stopped == EOM_INCONSISTENT);
    } else {
      print_message("held: jump %.1e, energy %.1e, rank changed %ld times\n", w.jump, w.drift, w.sys->rank_changes);
      assert_int_equal(stopped, 0);
      assert_int_equal(w.sys->rank_changes, 1);
      assert_true(w.jump < 1e-3 && w.drift < 1e-6);
      pin_of(y[0], y[1], c);
      assert_close(y[2], c[0], 0, 1e-12), assert_close(y[3], c[1], 0, 1e-12);
      assert_true(y[1] < -0.5); /* well past it */
    }
    eom_system_destroy(w.sys);
  }
}

/* ---- jumps and options ---- */

static void a_jump_is_refused_after_a_step_only(void **state) {
  (void)state;
  eom_system *sys = start(&cartesian_pendulum, NULL, 0);
  double y[4] = {0.6, -0.8, 0.8, 0.6};
  assert_int_equal(eom_project_state(sys, 0, y), EOM_OK);
  const double was = y[3] += 0.5;
  assert_int_equal(eom_project_state(sys, 0, y), EOM_VELOCITY_JUMP);
  assert_true(y[3] == was);
  assert_int_equal(sys->report.index, 3 - 2);
  assert_int_equal(eom_project(sys, y, y + 2, 0, NULL), EOM_OK);
  double rest[4] = {0, -1, 0, 1e-300}; /* rounding of a system at rest */
  assert_int_equal(eom_project(sys, rest, rest + 2, 0, NULL), EOM_OK);
  rest[3] = 1e-20;
  assert_int_equal(eom_project_state(sys, 0, rest), EOM_OK);
  eom_system_destroy(sys);
}

static eom_status try_options(eom_hold hold, double most_jump) {
  eom_options o = eom_options_default();
  o.hold = hold;
  o.most_jump = most_jump;
  eom_system *sys;
  const eom_status status = eom_system_create(&sys, &cartesian_pendulum, NULL, &o);
  eom_system_destroy(sys);
  return status;
}

static void impossible_options(void **state) {
  (void)state;
  assert_int_equal(try_options((eom_hold){1, 1e-6, 1e-5, 0}, HUGE_VAL), EOM_OK);
  assert_int_equal(try_options((eom_hold){1, 1e-5, 1e-6, 0}, 0.1), EOM_BAD_OPTION);
  assert_int_equal(try_options((eom_hold){1, 1e-12, 1e-6, 0}, 0.1), EOM_BAD_OPTION); /* below rank_tolerance */
  assert_int_equal(try_options((eom_hold){1, 1e-5, 1, 0}, 0.1), EOM_BAD_OPTION);
  assert_int_equal(try_options((eom_hold){1, nan(""), 1e-3, 0}, 0.1), EOM_BAD_OPTION);
  assert_int_equal(try_options((eom_hold){1, 1e-6, 1e-5, nan("")}, 0.1), EOM_BAD_OPTION);
  assert_int_equal(try_options((eom_hold){0, 0, 0, 0}, 0), EOM_BAD_OPTION);
  assert_int_equal(try_options((eom_hold){0, 0, 0, 0}, nan("")), EOM_BAD_OPTION);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(dead_points_are_passed),
      cmocka_unit_test(rank_has_hysteresis),
      cmocka_unit_test(rank_looks_ahead),
      cmocka_unit_test(a_rank_that_falls_in_between_is_reported),
      cmocka_unit_test(rows_that_are_dropped_are_left_out),
      cmocka_unit_test(a_linkage_passes_its_line),
      cmocka_unit_test(a_jump_is_refused_after_a_step_only),
      cmocka_unit_test(impossible_options),
  };
  return cmocka_run_group_tests_name("hold", tests, NULL, NULL);
}
