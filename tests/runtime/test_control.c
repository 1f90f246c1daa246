/* Steps chosen by their error: tolerances against closed forms, exact statistics, and what ends a run that cannot go on. */
#include "close.h"

#include "eom/integrate.h"

#include <math.h>
#include <string.h>

enum { MOST_DIM = 4, MOST_WORK = 32 * MOST_DIM };

static const eom_method *const methods[] = {&eom_rk4, &eom_dp5, &eom_dop853};
enum { METHODS = sizeof methods / sizeof methods[0] };

/* Starts an integrator in memory of its own, with steps of its choice. */
static void start(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, const double *y,
                  const eom_step_control *control) {
  static double work[MOST_WORK];
  assert_true(eom_integrator_size(method, dim) <= MOST_WORK);
  eom_integrator_init(it, method, rhs, user, dim, 0, y, 0, work);
  assert_int_equal(eom_integrator_control(it, control), EOM_OK);
}

/* ---- the Kepler problem, of period 2 pi, from the pericentre ---- */

static int kepler(void *user, double t, const double *y, double *ydot) {
  (void)t;
  if (user) ++*(long *)user;
  const double r2 = y[0] * y[0] + y[1] * y[1], r3 = r2 * sqrt(r2);
  ydot[0] = y[2];
  ydot[1] = y[3];
  ydot[2] = -y[0] / r3;
  ydot[3] = -y[1] / r3;
  return 0;
}

static void pericentre(double e, double *y) {
  y[0] = 1 - e;
  y[1] = y[2] = 0;
  y[3] = sqrt((1 + e) / (1 - e));
}

/* At the eccentric anomaly E, at time E - e sin E. */
static void ellipse(double e, double E, double *y) {
  const double root = sqrt(1 - e * e), rate = 1 / (1 - e * cos(E));
  y[0] = cos(E) - e;
  y[1] = root * sin(E);
  y[2] = -sin(E) * rate;
  y[3] = root * cos(E) * rate;
}

static double distance(const double *a, const double *b, int n) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sqrt(sum);
}

/* The error after so many revolutions of a run that is left in *it. */
static double kepler_error(const eom_method *method, double e, double revolutions, double tol, eom_integrator *it) {
  double y[4], end[4];
  pericentre(e, y);
  start(it, method, kepler, NULL, 4, y, &(eom_step_control){.rtol = tol, .atol = tol});
  const double E = 2 * acos(-1.0) * revolutions;
  assert_int_equal(eom_integrate(it, E - e * sin(E), NULL, NULL), EOM_OK);
  ellipse(e, E, end);
  return distance(it->y, end, 4);
}

/* Seven decades of tolerance are seven decades of error; measured 7.1 (rk4), 7.6 (dp5), 7.1 (dop853), at 20 to 300 times the tolerance.
 */
static void error_follows_the_tolerance(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    eom_integrator it;
    double error[2];
    for (int i = 0; i < 2; i++) {
      const double tol = i == 0 ? 1e-5 : 1e-12;
      error[i] = kepler_error(methods[k], 0.5, 1.7, tol, &it);
      print_message("%s, tolerance %.0e: error %.1e, %ld steps, %ld rejected\n", methods[k]->name, tol, error[i], it.steps,
                    it.rejected);
      assert_true(error[i] < 500 * tol);
    }
    assert_close(log10(error[0] / error[1]), 7, 0, 0.7);
  }
}

/* The step follows the motion through the pericentre: 5.5 revolutions to the apocentre. A relative error there is 1/(1-e) times as
 * large in the energy; measured at most 140 times that. */
static void narrow_orbits(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++)
    for (double narrow = 0.1; narrow > 0.0005; narrow /= 10)
      for (double tol = 1e-6; tol > 1e-13; tol /= 1000) {
        eom_integrator it;
        const double error = kepler_error(methods[k], 1 - narrow, 5.5, tol, &it);
        print_message("%s, e %g, tolerance %.0e: error %.1e, %ld steps, %ld rejected\n", methods[k]->name, 1 - narrow, tol, error,
                      it.steps, it.rejected);
        assert_true(error < 200 * tol / narrow);
        assert_true(it.rejected < it.steps / 2);
      }
}

/* Forwards and back again, with steps chosen anew. */
static void returns_to_the_start(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    eom_integrator it;
    double y[4];
    pericentre(0.5, y);
    kepler_error(methods[k], 0.5, 1.7, 1e-10, &it);
    assert_true(it.h > 0);
    assert_int_equal(eom_integrate(&it, 0, NULL, NULL), EOM_OK);
    assert_true(it.h < 0);
    assert_same(it.t, 0);
    print_message("%s: %.1e from the start\n", methods[k]->name, distance(it.y, y, 4));
    assert_true(distance(it.y, y, 4) < 1000 * 1e-10);
  }
}

/* ---- statistics ---- */

typedef struct watch {
  long calls, corrected, observed;
  double corrected_t, observed_t;
} watch;

static int watched_kepler(void *user, double t, const double *y, double *ydot) { return kepler(&((watch *)user)->calls, t, y, ydot); }

/* Corrections belong to good steps alone: their times only grow. */
static int note_correction(void *user, double t, double *y) {
  watch *w = user;
  (void)y;
  assert_true(t > w->corrected_t);
  w->corrected_t = t;
  w->corrected++;
  return 0;
}

static int note_step(void *observer, const eom_integrator *it) {
  watch *w = observer;
  assert_true(it->error <= 1);
  assert_true(it->t > w->observed_t && it->t_before == w->observed_t);
  w->observed_t = it->t;
  w->observed++;
  return 0;
}

/* Every trial costs its stages, and one more at the end of a good one where the estimate does not need that; the start costs two. */
static void statistics_are_exact(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    const eom_method *m = methods[k / 2];
    const int corrects = k % 2;
    watch w = {0};
    eom_integrator it;
    double y[4];
    pericentre(0.9, y);
    start(&it, m, watched_kepler, &w, 4, y, &(eom_step_control){.rtol = 1e-5, .atol = 1e-5});
    if (corrects) it.correct = note_correction;
    assert_int_equal(eom_integrate(&it, 10, note_step, &w), EOM_OK);
    assert_true(it.rejected > 3);
    assert_int_equal(it.failed, 0);
    assert_int_equal(w.calls, it.evaluations);
    assert_int_equal(w.observed, it.steps);
    assert_int_equal(w.corrected, corrects ? it.steps : 0);
    const int end_counts = m->error[m->stages] != 0;
    const long trials = it.steps + it.rejected;
    const long of_trials = end_counts ? m->stages * trials + (corrects ? it.steps : 0) : (m->stages - 1) * trials + it.steps;
    assert_int_equal(it.evaluations, 2 + of_trials);
  }
}

static int stop_at_ten(void *observer, const eom_integrator *it) { return (void)observer, it->steps == 10; }

/* The same bits again, also where the run was interrupted. */
static void runs_repeat(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    double y[4], end[3][4];
    eom_integrator it;
    pericentre(0.9, y);
    for (int run = 0; run < 3; run++) {
      start(&it, methods[k], kepler, NULL, 4, y, &(eom_step_control){.rtol = 1e-7, .atol = 1e-7});
      if (run == 2) assert_int_equal(eom_integrate(&it, 10, stop_at_ten, NULL), EOM_STOPPED);
      assert_int_equal(eom_integrate(&it, 10, NULL, NULL), EOM_OK);
      memcpy(end[run], it.y, sizeof end[run]);
    }
    assert_memory_equal(end[0], end[1], sizeof end[0]);
    assert_memory_equal(end[0], end[2], sizeof end[0]);
  }
}

/* ---- tolerances and bounds ---- */

/* Two oscillators, the second of amplitude 1e-8. */
static int oscillators(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  ydot[0] = y[1];
  ydot[1] = -y[0];
  ydot[2] = 3 * y[3];
  ydot[3] = -3 * y[2];
  return 0;
}

/* A tolerance of its own holds the small component to as many digits as the large one. */
static void tolerances_by_component(void **state) {
  (void)state;
  const double y[4] = {1, 0, 1e-8, 0}, atol[4] = {1e-7, 1e-7, 1e-15, 1e-15}, rtol[4] = {0};
  eom_integrator it;
  start(&it, &eom_dop853, oscillators, NULL, 4, y, &(eom_step_control){.atol = 1e-7});
  assert_int_equal(eom_integrate(&it, 20, NULL, NULL), EOM_OK);
  const double loose = fabs(it.y[2] / 1e-8 - cos(60));
  start(&it, &eom_dop853, oscillators, NULL, 4, y, &(eom_step_control){.rtol_each = rtol, .atol_each = atol});
  assert_int_equal(eom_integrate(&it, 20, NULL, NULL), EOM_OK);
  const double tight = fabs(it.y[2] / 1e-8 - cos(60));
  print_message("relative error of the small oscillator: %.1e with one tolerance, %.1e with its own\n", loose, tight);
  assert_true(loose > 1e-4);
  assert_true(tight < 1e-7);
}

static int longest(void *observer, const eom_integrator *it) {
  double *most = observer;
  *most = fmax(*most, fabs(it->t - it->t_before));
  return 0;
}

static void steps_stay_below_the_bound(void **state) {
  (void)state;
  for (int direction = -1; direction <= 1; direction += 2) {
    const double y[4] = {1, 0, 0, 0};
    double most = 0;
    eom_integrator it;
    start(&it, &eom_dop853, oscillators, NULL, 4, y, &(eom_step_control){.rtol = 1e-3, .atol = 1e-3, .h_max = 0.125});
    assert_int_equal(eom_integrate(&it, 2 * direction, longest, &most), EOM_OK);
    assert_close(most, 0.125, 1e-14, 0);
    assert_int_equal(it.steps, 16);
  }
}

static int constant(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t, (void)y;
  ydot[0] = 1;
  return 0;
}

/* From rest, where nothing tells a length of the first step; and with no way to go. */
static void starts_from_zero(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const double y = 0;
    eom_integrator it;
    start(&it, methods[k], constant, NULL, 1, &y, &(eom_step_control){.rtol = 1e-6});
    assert_int_equal(eom_integrate(&it, 0, NULL, NULL), EOM_OK);
    assert_int_equal(it.evaluations, 0);
    assert_int_equal(eom_integrate(&it, 100, NULL, NULL), EOM_OK);
    assert_close(it.y[0], 100, 1e-14, 0);
    assert_true(it.steps < 20);
  }
}

/* A component that is zero at the start has no scale of its own without atol: the others choose the first step. */
static void starts_with_a_zero_and_no_atol(void **state) {
  (void)state;
  const double y[4] = {0, 1, 1, 0};
  for (int m = 0; m < METHODS; m++) {
    eom_integrator it;
    start(&it, methods[m], kepler, NULL, 4, y, &(eom_step_control){.rtol = 1e-6}); /* a circle */
    assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_OK);
    assert_true(it.evaluations < 400);
    assert_close(it.y[0], sin(1), 0, 1e-4);
    assert_close(it.y[3], -sin(1), 0, 1e-4);
  }
}

static void bad_options(void **state) {
  (void)state;
  static double work[MOST_WORK];
  const double y[4] = {1, 0, 0, 0}, negative[4] = {0, 0, 0, -1}, nan = (double)NAN;
  const eom_step_control bad[] = {{0},
                                  {.rtol = -1e-3},
                                  {.rtol = nan},
                                  {.rtol = 1e-3, .atol = (double)INFINITY},
                                  {.rtol = 1e-3, .h_min = -1},
                                  {.rtol = 1e-3, .h_max = nan},
                                  {.rtol = 1e-3, .most_steps = -1},
                                  {.atol_each = negative}};
  eom_integrator it;
  eom_integrator_init(&it, &eom_dp5, oscillators, NULL, 4, 0, y, 0.1, work);
  for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) assert_int_equal(eom_integrator_control(&it, &bad[i]), EOM_BAD_OPTION);
  assert_int_equal(eom_integrator_control(&it, &(eom_step_control){.rtol = 1e-3}), EOM_OK);
  assert_int_equal(eom_integrate(&it, nan, NULL, NULL), EOM_BAD_OPTION);
  assert_int_equal(eom_integrate(&it, (double)INFINITY, NULL, NULL), EOM_BAD_OPTION);
  assert_int_equal(it.steps, 0);
}

/* ---- runs that cannot go on ---- */

/* A decay a million times as fast as what is followed. */
static int stiff(void *user, double t, const double *y, double *ydot) {
  (void)user;
  ydot[0] = -1e6 * (y[0] - cos(t)) - sin(t);
  return 0;
}

/* Explicit methods need steps of some 1e-6: the work is bounded, what was computed until then is right. */
static void stiffness_ends_in_work(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const double y = 1;
    eom_integrator it;
    start(&it, methods[k], stiff, NULL, 1, &y, &(eom_step_control){.rtol = 1e-6, .atol = 1e-6, .most_steps = 1000});
    assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_TOO_MUCH_WORK);
    assert_int_equal(it.steps + it.rejected, 1000);
    assert_close(it.y[0], cos(it.t), 0, 1e-5);
    start(&it, methods[k], stiff, NULL, 1, &y, &(eom_step_control){.rtol = 1e-6, .atol = 1e-6, .h_min = 1e-4});
    assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_STEP_TOO_SMALL);
    assert_int_equal(it.worst, 0);
    assert_close(it.y[0], cos(it.t), 0, 1e-5);
  }
}

/* The second component has no solution beyond t = 1. */
static int explosion(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  assert_true(isfinite(y[0]) && isfinite(y[1]));
  ydot[0] = 1;
  ydot[1] = y[1] * y[1];
  return 0;
}

static void explosions_are_located(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const double y[2] = {0, 1};
    eom_integrator it;
    start(&it, methods[k], explosion, NULL, 2, y, &(eom_step_control){.rtol = 1e-9, .atol = 1e-9});
    assert_int_equal(eom_integrate(&it, 3, NULL, NULL), EOM_STEP_TOO_SMALL);
    assert_int_equal(it.worst, 1);
    assert_close(it.t, 1, 0, 1e-7);
    assert_true(isfinite(it.y[1]) && it.y[1] > 1e7);
    assert_true(it.evaluations < 100000);
  }
}

/* There is no f where y is beyond a limit: code 42, or not a number. */
typedef struct edge {
  double limit;
  int code;
} edge;

static int decay(void *user, double t, const double *y, double *ydot) {
  const edge *e = user;
  (void)t;
  ydot[0] = -50 * y[0];
  if (fabs(y[0]) <= e->limit) return 0;
  ydot[0] = (double)NAN;
  return e->code;
}

/* Trial steps that overshoot are shortened until they do not. */
static void failures_of_trials_shorten_the_step(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    edge e = {1, k % 2 ? 42 : 0};
    const double y = 1;
    eom_integrator it;
    start(&it, methods[k / 2], decay, &e, 1, &y, &(eom_step_control){.rtol = 1e-6, .atol = 1e-6});
    it.h = 1;
    assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_OK);
    assert_true(it.failed > 0);
    assert_close(it.y[0], exp(-50), 0, 1e-5);
  }
}

/* A correction that holds for short steps only, as a projection from far away does. */
static int near_only(void *user, double t, double *y) {
  (void)user, (void)y;
  static double before;
  if (t - before > 0.01) return 9;
  before = t;
  return 0;
}

static void failures_of_corrections_shorten_the_step(void **state) {
  (void)state;
  const double y[4] = {1, 0, 0, 0};
  eom_integrator it;
  start(&it, &eom_dop853, oscillators, NULL, 4, y, &(eom_step_control){.rtol = 1e-6, .atol = 1e-6});
  it.correct = near_only;
  assert_int_equal(eom_integrate(&it, 1, NULL, NULL), EOM_OK);
  assert_true(it.steps >= 100 && it.failed > 0);
  assert_int_equal(it.rejected, 0);
  assert_close(it.y[0], cos(1), 0, 1e-6);
}

static int growth(void *user, double t, const double *y, double *ydot) {
  const int code = decay(user, t, y, ydot);
  ydot[0] = -ydot[0];
  return code;
}

/* Where the solution itself comes to the limit, the rhs's own code says why; after it is moved the run goes on. */
static void failures_of_the_motion_are_reported(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    edge e = {exp(5), k % 2 ? 42 : 0};
    const double y = 1;
    eom_integrator it;
    start(&it, methods[k / 2], growth, &e, 1, &y, &(eom_step_control){.rtol = 1e-9, .atol = 1e-9});
    assert_int_equal(eom_integrate(&it, 0.2, NULL, NULL), k % 2 ? EOM_RHS_FAILED : EOM_NOT_FINITE);
    assert_int_equal(it.rhs_code, e.code);
    assert_close(it.t, 0.1, 0, 1e-8);
    assert_true(it.y[0] <= e.limit);
    assert_true(it.evaluations < 10000);
    e.limit = exp(20);
    assert_int_equal(eom_integrate(&it, 0.2, NULL, NULL), EOM_OK);
    assert_close(it.y[0], exp(10), 1e-6, 0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(error_follows_the_tolerance),
                                     cmocka_unit_test(narrow_orbits),
                                     cmocka_unit_test(returns_to_the_start),
                                     cmocka_unit_test(statistics_are_exact),
                                     cmocka_unit_test(runs_repeat),
                                     cmocka_unit_test(tolerances_by_component),
                                     cmocka_unit_test(steps_stay_below_the_bound),
                                     cmocka_unit_test(starts_from_zero),
                                     cmocka_unit_test(starts_with_a_zero_and_no_atol),
                                     cmocka_unit_test(bad_options),
                                     cmocka_unit_test(stiffness_ends_in_work),
                                     cmocka_unit_test(explosions_are_located),
                                     cmocka_unit_test(failures_of_trials_shorten_the_step),
                                     cmocka_unit_test(failures_of_corrections_shorten_the_step),
                                     cmocka_unit_test(failures_of_the_motion_are_reported)};
  return cmocka_run_group_tests_name("control", tests, NULL, NULL);
}
