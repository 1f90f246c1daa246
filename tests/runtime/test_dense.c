/* Interpolation inside steps: its order, the ends, what it costs, and times that are not in the step. */
#include "close.h"

#include "eom/integrate.h"
#include "step.h"

enum { MOST_DIM = 2, MOST_WORK = 32 * 4 };

static const eom_method *const methods[] = {&eom_rk4, &eom_dp5, &eom_dop853};
enum { METHODS = sizeof methods / sizeof methods[0] };

static void start(eom_integrator *it, const eom_method *method, eom_rhs_fn *rhs, void *user, int dim, const tl_real *y, tl_real h) {
  static tl_real work[MOST_WORK];
  assert_true(eom_integrator_size(method, dim) <= MOST_WORK);
  eom_integrator_init(it, method, rhs, user, dim, 0, y, h, work);
}

/* The pendulum's equation with a driven length scale: nonlinear, and explicit in t. */
static int swing(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  (void)user;
  ydot[0] = y[1];
  ydot[1] = -TL_LIBM(sin)(y[0]) * (1 + TL_LIBM(cos)(t) / 4);
  return 0;
}

/* The largest error inside one step of h, against steps of h/64 of the method of order 8. */
static tl_real worst_inside(const eom_method *method, tl_real h) {
  enum { PARTS = 8, FINE = 8 };
  static tl_real work[MOST_WORK];
  const tl_real y[2] = {1, TL_C(0.5)};
  tl_real worst = 0;
  eom_integrator it, truth;
  start(&it, method, swing, NULL, 2, y, h);
  assert_int_equal(eom_integrator_step(&it), EOM_OK);
  eom_integrator_init(&truth, &eom_dop853, swing, NULL, 2, 0, y, h / (PARTS * FINE), work);
  for (int part = 1; part < PARTS; part++) {
    tl_real inside[2];
    for (int i = 0; i < FINE; i++) assert_int_equal(eom_integrator_step(&truth), EOM_OK);
    assert_int_equal(eom_integrator_at(&it, truth.t, inside), EOM_OK);
    for (int i = 0; i < 2; i++) worst = TL_LIBM(fmax)(worst, TL_LIBM(fabs)(inside[i] - truth.y[i]));
  }
  return worst;
}

/* Half the step divides the error inside it by 2^(r+1), up to the next order's share at the steps that double precision allows. */
static void order_inside_a_step(void **state) {
  (void)state;
  if (TL_MANT_DIG < 50) skip(); /* float: rounding hides what the higher orders leave */
  for (int k = 0; k < METHODS; k++) {
    const eom_method *m = methods[k];
    tl_real h = TL_LIBM(pow)(TL_EPSILON, (tl_real)0.4 / (tl_real)(m->dense_order + 1));
    const double ratio = (double)(worst_inside(m, h) / worst_inside(m, h / 2)), expected = (double)(1 << (m->dense_order + 1));
    print_message("%s, h = %.2g: error %.1e, at half the step %.1f times less\n", m->name, (double)h, (double)worst_inside(m, h),
                  ratio);
    assert_close(ratio, expected, TL_MANT_DIG > 100 ? 0.02 : 0.2, 0);
  }
}

/* y' = r t^(r-1): a polynomial of the interpolation's degree, in steps forwards and backwards. */
static int power(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  const int r = *(const int *)user;
  (void)y;
  ydot[0] = (tl_real)r * TL_LIBM(pow)(t, (tl_real)(r - 1));
  return 0;
}

static void exact_for_polynomials(void **state) {
  (void)state;
  for (int k = 0; k < 2 * METHODS; k++) {
    const eom_method *m = methods[k / 2];
    const tl_real zero = 0, step = k % 2 ? -1 : 1;
    const double rounding = fmax(1e4 * (double)TL_EPSILON, 1e-25); /* 30 digits of the table; results to 2^7 */
    int r = m->dense_order;
    eom_integrator it;
    start(&it, m, power, &r, 1, &zero, step);
    for (int steps = 1; steps <= 2; steps++) {
      assert_int_equal(eom_integrator_step(&it), EOM_OK);
      for (int part = 0; part <= 8; part++) {
        const tl_real t = step * ((tl_real)(8 * (steps - 1) + part) / 8);
        tl_real y;
        assert_int_equal(eom_integrator_at(&it, t, &y), EOM_OK);
        assert_close((double)(y - TL_LIBM(pow)(t, (tl_real)r)), 0, 0, rounding);
      }
    }
  }
}

static int double_it(void *user, tl_real t, tl_real *y) {
  (void)user, (void)t;
  y[0] *= 2;
  return 0;
}

/* Both ends are met to the bit, the start of the step and the corrected state. */
static void meets_both_ends(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const tl_real y0[2] = {1, 0};
    tl_real y[2];
    eom_integrator it;
    start(&it, methods[k], swing, NULL, 2, y0, TL_C(0.1));
    it.correct = double_it;
    assert_int_equal(eom_integrator_step(&it), EOM_OK);
    assert_int_equal(eom_integrator_at(&it, 0, y), EOM_OK);
    assert_memory_equal(y, y0, sizeof y);
    assert_int_equal(eom_integrator_at(&it, it.t, y), EOM_OK);
    assert_memory_equal(y, it.y, sizeof y);
    assert_int_equal(eom_integrator_at(&it, it.t - it.t * TL_C(1e-6), y), EOM_OK);
    for (int i = 0; i < 2; i++) assert_close((double)y[i], (double)it.y[i], 0, 1e-5);
  }
}

/* What a method needs besides its stages is evaluated once a step, and only where it is asked for; steps do not notice. */
static void costs_once(void **state) {
  (void)state;
  for (int k = 0; k < METHODS; k++) {
    const eom_method *m = methods[k];
    const tl_real y0[2] = {1, 0};
    tl_real y[2], end[2][2];
    eom_integrator it;
    for (int looks = 0; looks < 2; looks++) {
      start(&it, m, swing, NULL, 2, y0, TL_C(0.125));
      for (int step = 1; step <= 4; step++) {
        assert_int_equal(eom_integrator_step(&it), EOM_OK);
        for (int i = 1; looks && i < 4; i++) assert_int_equal(eom_integrator_at(&it, it.t - it.h * (tl_real)i / 4, y), EOM_OK);
        assert_int_equal(it.evaluations, 1 + step * (m->stages + looks * m->dense_stages));
      }
      for (int i = 0; i < 2; i++) end[looks][i] = it.y[i];
    }
    assert_memory_equal(end[0], end[1], sizeof end[0]);
  }
}

/* Fails with code 7 at the times between two steps that only the interpolation asks for. */
static int fails_between(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  swing(NULL, t, y, ydot);
  return *(const int *)user ? 7 : 0;
}

static void other_times_are_refused(void **state) {
  (void)state;
  const tl_real y0[2] = {1, 0};
  tl_real y[2];
  eom_integrator it;
  int fails = 0;
  start(&it, &eom_dop853, fails_between, &fails, 2, y0, TL_C(0.1));
  assert_int_equal(eom_integrator_at(&it, 0, y), EOM_OK);
  assert_int_equal(eom_integrator_at(&it, TL_C(0.01), y), EOM_NOT_IN_STEP);
  assert_int_equal(eom_integrator_step(&it), EOM_OK);
  assert_int_equal(eom_integrator_at(&it, TL_C(-0.01), y), EOM_NOT_IN_STEP);
  assert_int_equal(eom_integrator_at(&it, TL_C(0.11), y), EOM_NOT_IN_STEP);
  assert_int_equal(eom_integrator_at(&it, (tl_real)NAN, y), EOM_NOT_IN_STEP);
  fails = 1;
  assert_int_equal(eom_integrator_at(&it, TL_C(0.05), y), EOM_RHS_FAILED);
  assert_int_equal(it.rhs_code, 7);
  assert_int_equal(eom_integrator_step(&it), EOM_RHS_FAILED); /* its slopes are in the place of the last step's */
  fails = 0;
  assert_int_equal(eom_integrator_at(&it, TL_C(0.05), y), EOM_NOT_IN_STEP);
  assert_int_equal(eom_integrator_at(&it, it.t, y), EOM_OK);
  assert_int_equal(eom_integrator_step(&it), EOM_OK);
  eom_integrator_restart(&it); /* another f, perhaps */
  assert_int_equal(eom_integrator_at(&it, TL_C(0.15), y), EOM_NOT_IN_STEP);
}

/* q'' = 20 t^3 + 30 c t^4: q = t^5 + c t^6. */
static int fall(void *user, tl_real t, const tl_real *y, tl_real *ydot) {
  ydot[0] = y[1];
  ydot[1] = t * t * t * (20 + 30 * *(const tl_real *)user * t);
  return 0;
}

/* The quintic from the ends of a step is t^5; of t^6 it leaves h^6 x^3 (1-x)^3, a defect of 0.288 h^5 at x = 0.6, and at most 0.0537
 * h^5 in qd. Forwards and backwards, without an evaluation. */
static void motion_from_its_ends(void **state) {
  (void)state;
  for (int k = 0; k < 4; k++) {
    const tl_real h = k % 2 ? -2 : 2, zero[2] = {0};
    tl_real sixth = (tl_real)(k / 2), kept[2 * EOM_MOTION_ROWS];
    eom_integrator it;
    start(&it, &eom_dop853, fall, &sixth, 2, zero, h);
    assert_int_equal(eom_integrator_step(&it), EOM_OK);
    const long evaluations = it.evaluations;
    eom_keep_motion(&it, kept);
    const double tolerance = fmax(1e4 * (double)TL_EPSILON, 1e-25); /* of the table, in quad precision */
    assert_close((double)eom_motion_defect(&it, kept), (double)(sixth * TL_C(0.288) * 32), 0, tolerance);
    assert_int_equal(it.evaluations, evaluations);
    for (int part = 0; part <= 8; part++) {
      const tl_real x = (tl_real)part / 8, t = x * h, r = x * (1 - x), h3 = h * h * h;
      tl_real y[2];
      eom_kept_at(EOM_MOTION_ROWS, 2, kept, x, y);
      const tl_real error = sixth * r * r * h3 * h;
      assert_close((double)y[0], (double)(t * t * t * t * t * (1 + sixth * t) + error * r * h * h), 0, tolerance);
      assert_close((double)y[1], (double)(t * t * t * t * (5 + 6 * sixth * t) + error * 3 * (1 - 2 * x) * h), 0, tolerance);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(order_inside_a_step),     cmocka_unit_test(exact_for_polynomials),
                                     cmocka_unit_test(meets_both_ends),         cmocka_unit_test(costs_once),
                                     cmocka_unit_test(other_times_are_refused), cmocka_unit_test(motion_from_its_ends)};
  return cmocka_run_group_tests_name("dense", tests, NULL, NULL);
}
