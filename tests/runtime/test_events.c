/* Events and output inside steps, against closed forms: times, order, directions, restarts, and states at given times. */
#include "close.h"
#include "random.h"

#include "eom/events.h"

#include <math.h>
#include <string.h>

enum { MOST_DIM = 2, MOST_WORK = 32 * 4, MOST_EVENTS = 4, MOST_SEEN = 64 };

static const double pi = 3.14159265358979323846;
static const eom_method *const methods[] = {&eom_rk4, &eom_dp5, &eom_dop853};
enum { METHODS = sizeof methods / sizeof methods[0] };

/* A run and what it saw. */
typedef struct run {
  eom_integrator it;
  eom_events events;
  int seen;
  int event[MOST_SEEN];
  double t[MOST_SEEN], y[MOST_SEEN][MOST_DIM];
  eom_event_action action; /* of note */
  double level;            /* of the roots that have one */
  int other;
} run;

static eom_event_action note(void *user, int event, double t, double *y) {
  run *r = user;
  assert_true(r->seen < MOST_SEEN);
  r->event[r->seen] = event;
  r->t[r->seen] = t;
  memcpy(r->y[r->seen++], y, sizeof r->y[0]);
  return r->action;
}

static void start(run *r, const eom_method *method, eom_rhs_fn *rhs, double t, const double *y, double tol, int count,
                  eom_root_fn *root) {
  static double work[MOST_WORK], event_work[8 * MOST_EVENTS];
  assert_true(eom_integrator_size(method, MOST_DIM) <= MOST_WORK && eom_events_size(count) <= 8 * MOST_EVENTS);
  for (int i = 0; i < 8 * MOST_EVENTS; i++) event_work[i] = (double)NAN; /* as memory of the caller's may be */
  *r = (run){.events = {.count = count, .root = root, .handle = note, .user = r, .work = event_work}};
  eom_integrator_init(&r->it, method, rhs, r, MOST_DIM, t, y, 0, work);
  assert_int_equal(eom_integrator_control(&r->it, &(eom_step_control){.rtol = tol, .atol = tol}), EOM_OK);
  r->it.events = &r->events;
}

/* y = (cos t, -sin t) from (1, 0). */
static int oscillator(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  ydot[0] = y[1];
  ydot[1] = -y[0];
  return 0;
}

/* Zero where t is (k + 1/2) pi, and where it is k pi. */
static int both_components(void *user, double t, const double *y, double *g) {
  (void)user, (void)t;
  g[0] = y[0];
  g[1] = y[1];
  return 0;
}

/* ---- times ---- */

/* Every zero of both components over ten turns in order, none at the start where the second is zero; the times are as good as the
 * integration. Forwards and backwards. */
static void every_zero_in_order(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    const double y[2] = {1, 0}, way = k % 2 ? -1 : 1;
    double worst = 0;
    run r;
    start(&r, methods[k / 2], oscillator, 0, y, 1e-12, 2, both_components);
    assert_int_equal(eom_integrate(&r.it, 20 * pi * way + 0.1 * way, NULL, NULL), EOM_OK);
    assert_int_equal(r.seen, 40);
    assert_int_equal(r.events.found, 40);
    for (int i = 0; i < 40; i++) {
      assert_int_equal(r.event[i], i % 2);
      worst = fmax(worst, fabs(r.t[i] - (i + 1) * pi / 2 * way));
      assert_true(fabs(r.y[i][i % 2]) < 1e-12);
    }
    print_message("%s %s: times within %.1e s, %ld steps\n", methods[k / 2]->name, k % 2 ? "backwards" : "forwards", worst, r.it.steps);
    assert_true(worst < 2e-9);
    assert_close(r.it.y[0], cos(20 * pi + 0.1), 0, 2e-9);
  }
}

/* g = t - level: the time is exact but for the tolerance, on the far side, and there is one step or part that holds it. */
static int of_time(void *user, double t, const double *y, double *g) {
  (void)y;
  g[0] = t - ((run *)user)->level;
  return 0;
}

/* Steeper than any line at its root, and flat elsewhere. */
static int of_time_steep(void *user, double t, const double *y, double *g) {
  of_time(user, t, y, g);
  g[0] = cbrt(g[0]);
  return 0;
}

static int of_time_flat(void *user, double t, const double *y, double *g) {
  of_time(user, t, y, g);
  g[0] = pow(g[0], 9);
  return 0;
}

static void times_to_the_tolerance(void **state) {
  (void)state;
  static eom_root_fn *const roots[] = {of_time, of_time_steep, of_time_flat};
  for (int k = 0; k < 3; k++)
    for (int way = -1; way <= 1; way += 2)
      for (int i = 1; i <= 20; i++) {
        const double y[2] = {1, 0};
        const double tolerance = i % 2 ? 1e-6 : 0, allowed = i % 2 ? 1e-6 : 4 * 2.3e-16 * 14;
        run r;
        start(&r, &eom_dop853, oscillator, 10, y, 1e-9, 1, roots[k]);
        r.level = 10 + way * 3.7 * i / 20;
        r.events.tolerance = tolerance;
        assert_int_equal(eom_integrate(&r.it, 10 + way * 3.8, NULL, NULL), EOM_OK);
        assert_int_equal(r.seen, 1);
        assert_true((r.t[0] - r.level) * way >= 0);
        assert_close(r.t[0], r.level, 0, allowed);
      }
}

/* An event that is only a few tolerances behind the start is one: nothing was there before. */
static void soon_after_the_start(void **state) {
  (void)state;
  const double y[2] = {1, 0};
  run r;
  start(&r, &eom_dop853, oscillator, 10, y, 1e-9, 1, of_time);
  r.events.tolerance = 1e-6;
  r.level = 10 + 5e-6;
  assert_int_equal(eom_integrate(&r.it, 11, NULL, NULL), EOM_OK);
  assert_int_equal(r.seen, 1);
  assert_close(r.t[0], r.level, 0, 1e-6);
}

/* Directions are those of growing time, whichever way it is integrated: y0 = cos t falls at pi/2 and rises at 3 pi/2. */
static void directions(void **state) {
  (void)state;
  for (int direction = -1; direction <= 1; direction++)
    for (int backwards = 0; backwards < 2; backwards++) {
      const double y[2] = {1, 0};
      const int wanted[2] = {direction, 1};
      run r;
      start(&r, &eom_dp5, oscillator, 0, y, 1e-10, 2, both_components);
      r.events.direction = wanted;
      const double begin = 0.1, end = 2 * pi - 0.1;
      r.it.events = NULL; /* until the way begins */
      assert_int_equal(eom_integrate(&r.it, backwards ? end : begin, NULL, NULL), EOM_OK);
      r.it.events = &r.events;
      assert_int_equal(eom_integrate(&r.it, backwards ? begin : end, NULL, NULL), EOM_OK);
      double expected[3];
      int count = 0; /* y1 = -sin t rises at pi */
      if (direction <= 0) expected[count++] = pi / 2;
      expected[count++] = pi;
      if (direction >= 0) expected[count++] = 3 * pi / 2;
      assert_int_equal(r.seen, count);
      for (int i = 0; i < count; i++) assert_close(r.t[i], expected[backwards ? count - 1 - i : i], 0, 1e-8);
    }
}

/* A step that holds several zeros of one function: as many parts as tell them apart. y1 is constant, y0 = t in one step. */
static int drift(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t, (void)y;
  ydot[0] = 1;
  ydot[1] = 0;
  return 0;
}

static int wave(void *user, double t, const double *y, double *g) {
  (void)user, (void)t;
  g[0] = sin(pi * (y[0] + 0.25));
  return 0;
}

static void several_in_a_step(void **state) {
  (void)state;
  for (int parts = 1; parts <= 16; parts *= 2) {
    const double y[2] = {0, 0};
    run r;
    start(&r, &eom_dop853, drift, 0, y, 1e-6, 1, wave);
    r.it.h = 4;
    r.events.parts = parts;
    assert_int_equal(eom_integrate(&r.it, 4, NULL, NULL), EOM_OK);
    assert_int_equal(r.it.steps, 1);
    assert_int_equal(r.seen, parts >= 4 ? 4 : 0); /* signs at 0, 4 and at 0, 2, 4 are the same */
    for (int i = 0; i < r.seen; i++) assert_close(r.t[i], 0.75 + i, 0, 1e-14);
  }
}

/* Parts of a length, in steps of any: sin(pi (t + 1/4)) is zero at 3/4, 7/4, .. */
static void parts_of_a_length(void **state) {
  (void)state;
  for (int steps = 1; steps <= 16; steps *= 4)
    for (int way = -1; way <= 1; way += 2) {
      const double y[2] = {0, 0};
      run r;
      start(&r, &eom_dop853, drift, 0, y, 1e-6, 1, wave);
      r.it.h = way * 16.0 / steps;
      r.it.control.h_max = 16.0 / steps;
      r.events.apart = 0.9;
      assert_int_equal(eom_integrate(&r.it, way * 16, NULL, NULL), EOM_OK);
      assert_int_equal(r.seen, 16);
      for (int i = 0; i < r.seen; i++) assert_close(r.t[i], way > 0 ? 0.75 + i : -0.25 - i, 0, 1e-13);
    }
}

/* Random sums of sines, as found by a scan of the closed form; handlers that let go on or begin anew at random. */
enum { SINES = 4 };
typedef struct sines {
  run r; /* first: what the callbacks are given */
  double a[SINES], w[SINES], p[SINES];
} sines;

static double sum_of_sines(const sines *s, double t, double y0) {
  double sum = 0.3 * y0 - 0.1;
  for (int i = 0; i < SINES; i++) sum += s->a[i] * sin(s->w[i] * t + s->p[i]);
  return sum;
}

static int random_root(void *user, double t, const double *y, double *g) {
  g[0] = sum_of_sines(user, t, y[0]);
  return 0;
}

static eom_event_action at_random(void *user, int event, double t, double *y) {
  note(user, event, t, y);
  return (long)(t * 1e6) % 2 ? EOM_EVENT_CHANGED : EOM_EVENT_GO_ON;
}

static void random_functions(void **state) {
  (void)state;
  const int points = 4000;
  rng random = {7};
  int events = 0;
  for (int tries = test_tries(150); tries > 0; tries--) {
    const double y[2] = {1, 0}, end = 20 * rng_sign(&random);
    sines s;
    start(&s.r, methods[tries % METHODS], oscillator, 0, y, 1e-10, 1, random_root);
    s.r.events.handle = at_random;
    s.r.it.control.h_max = 0.5;
    for (int i = 0; i < SINES; i++) {
      s.a[i] = rng_uniform(&random, 0, 1);
      s.w[i] = rng_uniform(&random, 0, 1.5);
      s.p[i] = rng_uniform(&random, 0, 6);
    }
    assert_int_equal(eom_integrate(&s.r.it, end, NULL, NULL), EOM_OK);
    int seen = 0;
    double before = sum_of_sines(&s, 0, 1);
    for (int i = 1; i <= points; i++) {
      const double t = end * i / points, g = sum_of_sines(&s, t, cos(t));
      if (before * g < 0) {
        assert_true(seen < s.r.seen);
        assert_close(s.r.t[seen++], t, 0, fabs(end) / points);
      }
      before = g;
    }
    assert_int_equal(seen, s.r.seen);
    events += seen;
  }
  print_message("%d events of random functions\n", events);
  assert_true(events > 3 * test_tries(150));
}

/* ---- what events do ---- */

/* A null handler stops: at the event, not beyond it; going on does not stop there again. */
static void stops_and_goes_on(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const double y[2] = {1, 0};
    run r;
    start(&r, methods[k], oscillator, 0, y, 1e-11, 2, both_components);
    r.events.handle = NULL;
    for (int i = 1; i <= 8; i++) {
      assert_int_equal(eom_integrate(&r.it, 100, NULL, NULL), EOM_STOPPED);
      assert_int_equal(r.events.last, (i - 1) % 2);
      assert_close(r.it.t, i * pi / 2, 0, 1e-8);
      assert_close(r.it.y[0], cos(r.it.t), 0, 1e-8);
    }
    r.it.events = NULL;
    assert_int_equal(eom_integrate(&r.it, 20, NULL, NULL), EOM_OK);
    assert_close(r.it.y[0], cos(20), 0, 1e-8);
  }
}

/* A root function that rounding makes uneven, far above the last place of times near zero: its event changes nothing but says so, and
 * is not found again behind itself. */
static int rounded(void *user, double t, const double *y, double *g) {
  g[0] = (t - ((run *)user)->level) / 10 + 100 * (y[0] * y[0] + y[1] * y[1] - 1);
  return 0;
}

static void no_second_event_from_rounding(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++)
    for (int i = 1; i <= 40; i++) {
      const double y[2] = {1, 0}, way = i % 2 ? 1 : -1;
      run r;
      start(&r, methods[k], oscillator, 0, y, 1e-11, 1, rounded);
      r.level = 0.0007 * i * way;
      r.action = EOM_EVENT_CHANGED;
      assert_int_equal(eom_integrate(&r.it, 0.5 * way, NULL, NULL), EOM_OK);
      assert_int_equal(r.seen, 1);
      assert_close(r.t[0], r.level, 0, 1e-5);
    }
}

/* A ball that keeps half of its velocity: from height 1 under g = 8 it lands at 1/2 s, then after 1/2 s, 1/4 s, .. */
static int ball(void *user, double t, const double *y, double *ydot) {
  (void)user, (void)t;
  ydot[0] = y[1];
  ydot[1] = -8;
  return 0;
}

static int height(void *user, double t, const double *y, double *g) {
  (void)user, (void)t;
  g[0] = y[0];
  return 0;
}

static eom_event_action bounce(void *user, int event, double t, double *y) {
  note(user, event, t, y);
  y[1] *= -0.5;
  return EOM_EVENT_CHANGED;
}

/* Between two calls the caller puts the ball below the level: what g was before is forgotten, and the only event is the next one. */
static void state_set_from_outside(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) { /* steps that are chosen, and fixed ones */
    const double y[2] = {1, 0};
    run r;
    start(&r, methods[k / 2], ball, 0, y, 1e-10, 1, height);
    if (k % 2) r.it.controlled = NULL, r.it.h = 0.015625;
    assert_int_equal(eom_integrate(&r.it, 0.25, NULL, NULL), EOM_OK);
    r.it.y[0] = -1;
    r.it.y[1] = 5;
    eom_integrator_restart(&r.it);
    assert_int_equal(eom_integrate(&r.it, 0.75, NULL, NULL), EOM_OK);
    assert_int_equal(r.seen, 1); /* up at -1 + 5 x - 4 x^2 = 0 */
    assert_close(r.t[0], 0.5, 0, 1e-9);
  }
}

static void bouncing_ball(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) { /* steps that are chosen, and fixed ones */
    const double y[2] = {1, 0};
    run r;
    start(&r, methods[k / 2], ball, 0, y, 1e-10, 1, height);
    r.events.handle = bounce;
    if (k % 2) r.it.controlled = NULL, r.it.h = 0.015625;
    assert_int_equal(eom_integrate(&r.it, 1.495, NULL, NULL), EOM_OK);
    assert_same(r.it.t, 1.495);
    double landing = 0.5;
    assert_int_equal(r.seen, 8);
    for (int i = 0; i < 8; i++) {
      assert_close(r.t[i], landing, 0, 1e-12);
      assert_close(r.y[i][1], -4 * pow(0.5, i), 1e-10, 0);
      landing += 0.5 * pow(0.5, i);
    }
  }
}

/* Two events at one time: both are handled there, once, though the first changes the state. */
static int twins(void *user, double t, const double *y, double *g) {
  g[0] = y[0];
  g[1] = 3 * y[0];
  return (void)user, (void)t, 0;
}

static void simultaneous_events(void **state) {
  (void)state;
  const double y[2] = {1, 0};
  run r;
  start(&r, &eom_dop853, ball, 0, y, 1e-10, 2, twins);
  r.action = EOM_EVENT_STOP;
  assert_int_equal(eom_integrate(&r.it, 2, NULL, NULL), EOM_STOPPED);
  assert_int_equal(r.seen, 2);
  assert_true(r.event[0] != r.event[1]);
  assert_int_equal(eom_integrate(&r.it, 2, NULL, NULL), EOM_OK);
  assert_int_equal(r.seen, 2);
}

static int fails(void *user, double t, const double *y, double *g) {
  of_time(user, t, y, g);
  const run *r = user;
  if (r->other == 0) g[0] = (double)NAN;
  return r->other;
}

static void failures_of_roots(void **state) {
  (void)state;
  for (int code = 0; code <= 5; code += 5) {
    const double y[2] = {1, 0};
    run r;
    start(&r, &eom_dp5, oscillator, 0, y, 1e-6, 1, fails);
    r.other = code;
    assert_int_equal(eom_integrate(&r.it, 1, NULL, NULL), code ? EOM_RHS_FAILED : EOM_NOT_FINITE);
    assert_int_equal(r.it.rhs_code, code);
  }
}

/* ---- output ---- */

static void note_output(void *user, double t, const double *y) {
  run *r = user;
  assert_true(r->seen < MOST_SEEN);
  r->t[r->seen] = t;
  memcpy(r->y[r->seen++], y, sizeof r->y[0]);
}

/* Forwards and backwards, both ends included; the steps are those of a run without output. */
static void output_at_given_times(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    const double y[2] = {1, 0}, way = k % 2 ? -1 : 1;
    double end[2];
    run r;
    start(&r, methods[k / 2], oscillator, 0, y, 1e-10, 1, height);
    r.it.events = NULL;
    assert_int_equal(eom_integrate(&r.it, 3 * way, NULL, NULL), EOM_OK);
    memcpy(end, r.it.y, sizeof end);
    start(&r, methods[k / 2], oscillator, 0, y, 1e-10, 1, height);
    r.it.events = NULL;
    eom_outputs out = {.write = note_output, .user = &r, .every = 0.1 * way, .count = 31};
    r.it.outputs = &out;
    assert_int_equal(eom_integrate(&r.it, 3 * way, NULL, NULL), EOM_OK);
    assert_int_equal(r.seen, 31);
    for (int i = 0; i < 31; i++) {
      assert_close(r.t[i], 0.1 * i * way, 1e-15, 0);
      assert_close(r.y[i][0], cos(r.t[i]), 0, 1e-8);
      assert_close(r.y[i][1], -sin(r.t[i]), 0, 1e-8);
    }
    assert_memory_equal(r.y[30], end, sizeof end);
    assert_memory_equal(r.it.y, end, sizeof end);
  }
}

/* Times that are listed, in two runs; one that was before the start is an error. */
static void output_from_a_list(void **state) {
  (void)state;
  const double y[2] = {1, 0}, times[] = {0.25, 0.5, 0.500001, 2}, early[] = {-0.1};
  run r;
  start(&r, &eom_dop853, oscillator, 0, y, 1e-10, 1, height);
  r.it.events = NULL;
  eom_outputs out = {.write = note_output, .user = &r, .times = times, .count = 4};
  r.it.outputs = &out;
  assert_int_equal(eom_integrate(&r.it, 1, NULL, NULL), EOM_OK);
  assert_int_equal(r.seen, 3);
  assert_int_equal(out.next, 3);
  assert_int_equal(eom_integrate(&r.it, 3, NULL, NULL), EOM_OK);
  assert_int_equal(r.seen, 4);
  for (int i = 0; i < 4; i++) {
    assert_same(r.t[i], times[i]);
    assert_close(r.y[i][0], cos(times[i]), 0, 1e-9);
  }
  out = (eom_outputs){.write = note_output, .user = &r, .times = early, .count = 1};
  assert_int_equal(eom_integrate(&r.it, 4, NULL, NULL), EOM_NOT_IN_STEP);
}

/* Output between bounces: before an event from the motion before it, after it from the one after. */
static void output_across_events(void **state) {
  (void)state;
  const double y[2] = {1, 0};
  run events, outputs = {0};
  start(&events, &eom_dop853, ball, 0, y, 1e-10, 1, height);
  events.events.handle = bounce;
  eom_outputs out = {.write = note_output, .user = &outputs, .every = 0.0625, .count = 16};
  events.it.outputs = &out;
  assert_int_equal(eom_integrate(&events.it, 0.9375, NULL, NULL), EOM_OK);
  assert_int_equal(outputs.seen, 16);
  for (int i = 0; i < 16; i++) {
    const double t = 0.0625 * i, since = t - 0.5;
    const double expected = t <= 0.5 ? 1 - 4 * t * t : 2 * since - 4 * since * since;
    assert_close(outputs.y[i][0], expected, 0, 1e-12);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(every_zero_in_order),
                                     cmocka_unit_test(times_to_the_tolerance),
                                     cmocka_unit_test(soon_after_the_start),
                                     cmocka_unit_test(directions),
                                     cmocka_unit_test(several_in_a_step),
                                     cmocka_unit_test(parts_of_a_length),
                                     cmocka_unit_test(random_functions),
                                     cmocka_unit_test(stops_and_goes_on),
                                     cmocka_unit_test(no_second_event_from_rounding),
                                     cmocka_unit_test(bouncing_ball),
                                     cmocka_unit_test(simultaneous_events),
                                     cmocka_unit_test(failures_of_roots),
                                     cmocka_unit_test(output_at_given_times),
                                     cmocka_unit_test(output_from_a_list),
                                     cmocka_unit_test(output_across_events),
                                     cmocka_unit_test(state_set_from_outside)};
  return cmocka_run_group_tests_name("events", tests, NULL, NULL);
}
