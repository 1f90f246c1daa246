/* Coefficients of motions in time against closed forms, which libtaylor expands, at every order. */
#include "arc_motion_tl.h"
#include "attracted_tl.h"
#include "bob_tl.h"
#include "cbrt_motion_tl.h"
#include "close.h"
#include "cube_motion_tl.h"
#include "exp_motion_tl.h"
#include "forced_motion_tl.h"
#include "log_motion_tl.h"
#include "polar_in_plane_tl.h"
#include "polar_motion_tl.h"
#include "power_motion_tl.h"
#include "root_motion_tl.h"
#include "sinh_motion_tl.h"
#include "swing_tl.h"
#include "tangent_motion_tl.h"

#include "eom/motion.h"
#include "taylor/taylor.h"

#include <math.h>
#include <string.h>

enum { MOST = EOM_TAYLOR_MOST, SIZE = MOST + 1, JETS = 8 };

/* ---- series in t, from libtaylor ---- */

static char tables[1 << 16];
static tl_real memory[1 << 14];
static tl_shape shape;
static tl_ctx context;

static void open_series(void) {
  const tl_spec spec = tl_univariate(MOST);
  assert_true(tl_ncoef(spec) == SIZE && tl_shape_bytes(spec) <= sizeof tables);
  assert_int_equal(tl_shape_init(&shape, spec, tables, sizeof tables), 0);
  tl_ctx_init(&context, &shape, memory, sizeof memory / sizeof memory[0]);
}

/* a + b t. */
static void line(tl_real *x, tl_real a, tl_real b) {
  memset(x, 0, SIZE * sizeof *x);
  x[0] = a;
  x[1] = b;
}

/* ---- one coordinate: x = g(q) = a + b t ---- */

typedef struct free_motion {
  const eom_motion *motion;
  double (*g)(double q), (*slope)(double q);
  void (*inverse)(tl_real *q, const tl_real *x);
} free_motion;

static double g_log(double q) { return log(log(q)); }
static double slope_log(double q) { return 1.0 / (q * log(q)); }
static double g_power(double q) { return pow(q, 2.5); }
static double slope_power(double q) { return 2.5 * pow(q, 1.5); }
static double g_root(double q) { return pow(q, 1.5); }
static double slope_root(double q) { return 1.5 * sqrt(q); }
static double g_cube(double q) { return q * q * q; }
static double slope_cube(double q) { return 3.0 * q * q; }
static double slope_tan(double q) { return 1.0 + tan(q) * tan(q); }
static double g_arc(double q) { return exp(atan(q)); }
static double slope_arc(double q) { return exp(atan(q)) / (1.0 + q * q); }
static double g_cbrt(double q) { return q * cbrt(q); }
static double slope_cbrt(double q) { return 4.0 / 3.0 * cbrt(q); }

static void by_log(tl_real *q, const tl_real *x) { tl_log(&context, q, x); }
static void by_exp_exp(tl_real *q, const tl_real *x) {
  tl_real e[SIZE];
  tl_exp(&context, e, x);
  tl_exp(&context, q, e);
}
static void by_power(tl_real *q, const tl_real *x) { tl_powc(&context, q, x, 0.4); }
static void by_root(tl_real *q, const tl_real *x) { tl_powc(&context, q, x, 2.0 / 3.0); }
static void by_cube(tl_real *q, const tl_real *x) { tl_cbrt(&context, q, x); }
static void by_atan(tl_real *q, const tl_real *x) { tl_atan(&context, q, x); }
static void by_tan_log(tl_real *q, const tl_real *x) {
  tl_real l[SIZE];
  tl_log(&context, l, x);
  tl_tan(&context, q, l);
}
static void by_asinh(tl_real *q, const tl_real *x) { tl_asinh(&context, q, x); }
static void by_cbrt(tl_real *q, const tl_real *x) { tl_powc(&context, q, x, 0.75); }

/* Every coefficient to 1e-12 of the largest that its neighbours' growth allows, rho^-k. */
static void compare(const char *name, const tl_real *coef, const tl_real *truth, int order, double rho) {
  for (int k = 0; k <= order; k++) {
    const double unit = fmax(pow(rho, -k), fabs(truth[k]));
    if (!(fabs(coef[k] - truth[k]) <= 1e-12 * unit))
      fail_msg("%s: coefficient %d of order %d is %.17g, not %.17g", name, k, order, coef[k], truth[k]);
  }
}

static tl_real work[1 << 14];

static void free_motions(void **state) {
  (void)state;
  static const free_motion all[] = {
      {&exp_motion_motion, exp, exp, by_log},
      {&log_motion_motion, g_log, slope_log, by_exp_exp},
      {&power_motion_motion, g_power, slope_power, by_power},
      {&root_motion_motion, g_root, slope_root, by_root},
      {&cube_motion_motion, g_cube, slope_cube, by_cube},
      {&tangent_motion_motion, tan, slope_tan, by_atan},
      {&arc_motion_motion, g_arc, slope_arc, by_tan_log},
      {&sinh_motion_motion, sinh, cosh, by_asinh},
      {&cbrt_motion_motion, g_cbrt, slope_cbrt, by_cbrt},
  };
  open_series();
  for (size_t i = 0; i < sizeof all / sizeof all[0]; i++)
    for (int order = 2; order <= MOST; order++) {
      const tl_real q = all[i].inverse == by_exp_exp ? 2.5 : 0.8, qd = 0.7;
      tl_real coef[SIZE], x[SIZE], truth[SIZE];
      assert_true(all[i].motion->work <= sizeof work / sizeof work[0]);
      assert_int_equal(all[i].motion->taylor(NULL, &q, &qd, 0.0, order, coef, work), 0);
      line(x, all[i].g(q), all[i].slope(q) * qd);
      all[i].inverse(truth, x);
      assert_int_equal(context.status.bits, TL_OK);
      compare("free motion", coef, truth, order, 0.5);
    }
}

static void in_time(void **state) {
  (void)state;
  open_series();
  const tl_real q = 0.3, qd = -0.2, t = 1.1;
  tl_real coef[SIZE], time[SIZE], truth[SIZE], sine[SIZE];
  line(time, t, 1.0);
  tl_cos(&context, truth, time);
  tl_sin(&context, sine, time);
  assert_int_equal(forced_motion_motion.taylor(NULL, &q, &qd, t, MOST, coef, work), 0);
  for (int k = 0; k < SIZE; k++) truth[k] = -truth[k];
  truth[0] += q + cos(t); /* q + (qd - sin t) s + cos t - cos(t + s) */
  truth[1] += qd - sin(t);
  compare("forced", coef, truth, MOST, 1.0);
}

static void compare_polar(const eom_motion *motion) {
  open_series();
  const tl_real x = 0.6, y = -0.5, vx = 0.3, vy = 0.9, r = hypot(x, y);
  const tl_real q[2] = {r, atan2(y, x)}, qd[2] = {(x * vx + y * vy) / r, (x * vy - y * vx) / (r * r)};
  tl_real coef[2 * SIZE], lx[SIZE], ly[SIZE], radius[SIZE], angle[SIZE];
  line(lx, x, vx);
  line(ly, y, vy);
  tl_hypot(&context, radius, lx, ly);
  tl_atan2(&context, angle, ly, lx);
  assert_int_equal(motion->taylor(NULL, q, qd, 0.0, MOST, coef, work), 0);
  compare("radius", coef, radius, MOST, 0.7);
  compare("angle", coef + SIZE, angle, MOST, 0.7);
}

/* Velocities along fixed axes make no more work than those along moving ones. */
static void two_coordinates(void **state) {
  (void)state;
  compare_polar(&polar_motion_motion);
  compare_polar(&polar_in_plane_motion);
  assert_true(polar_in_plane_motion.work <= polar_motion_motion.work);
}

/* Away from the centre so that it comes to rest nowhere: r' = sqrt(2/r), r^(3/2) = r0^(3/2) + 3/sqrt(2) t. */
static void escape(void **state) {
  (void)state;
  open_series();
  const tl_real r = 0.8, c = cos(0.4), s = sin(0.4), speed = sqrt(2.0 / r);
  const tl_real q[2] = {r * c, r * s}, qd[2] = {speed * c, speed * s};
  tl_real coef[2 * SIZE], base[SIZE], truth[SIZE];
  assert_int_equal(attracted_motion.taylor(NULL, q, qd, 0.0, MOST, coef, work), 0);
  for (int i = 0; i < 2; i++) {
    line(base, r * sqrt(r), 3.0 / sqrt(2.0));
    tl_powc(&context, truth, base, 2.0 / 3.0);
    for (int k = 0; k < SIZE; k++) truth[k] *= i == 0 ? c : s;
    compare("escape", coef + i * SIZE, truth, MOST, 0.337);
  }
}

/* q = 4 atan(e^t) - pi: qd = 2/cosh t; as x = sin q, y = -cos q, in time from 0.4 s on. */
static void pendulum(void **state) {
  (void)state;
  open_series();
  const tl_real t = 0.4;
  tl_real coef[2 * SIZE], time[SIZE], e[SIZE], truth[SIZE], sine[SIZE], cosine[SIZE];
  line(time, t, 1.0);
  tl_exp(&context, e, time);
  tl_atan(&context, truth, e);
  for (int k = 0; k < SIZE; k++) truth[k] *= 4.0;
  truth[0] -= acos(-1.0);
  tl_sin(&context, sine, truth);
  tl_cos(&context, cosine, truth);
  for (int k = 0; k < SIZE; k++) cosine[k] = -cosine[k];
  const tl_real q = truth[0], qd = truth[1];
  assert_int_equal(swing_motion.taylor(NULL, &q, &qd, 0.0, MOST, coef, work), 0);
  compare("pendulum", coef, truth, MOST, 1.0);
  const tl_real xy[2] = {sine[0], cosine[0]}, rates[2] = {sine[1], cosine[1]};
  assert_int_equal(bob_motion.taylor(NULL, xy, rates, 0.0, MOST, coef, work), 0);
  compare("x", coef, sine, MOST, 1.0);
  compare("y", coef + SIZE, cosine, MOST, 1.0);
}

static void overflow_is_told(void **state) {
  (void)state;
  const tl_real q = 1e-300, qd = 1e300;
  tl_real coef[SIZE];
  assert_int_equal(log_motion_motion.taylor(NULL, &q, &qd, 0.0, MOST, coef, work), EOM_MOTION_NOT_FINITE);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(free_motions), cmocka_unit_test(in_time),          cmocka_unit_test(two_coordinates),
      cmocka_unit_test(escape), cmocka_unit_test(pendulum),     cmocka_unit_test(overflow_is_told),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
