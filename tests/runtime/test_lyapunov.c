/* Lyapunov exponents: finite-time values of the pendulum by all schemes, the checks, what orthogonality is lost and where, failures. */
#include "close.h"
#include "constrained_models.h"
#include "data.h"
#include "pen.h"
#include "pendulum_model.h"
#include "pendulum_truth.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <string.h>

#define MOST 6
#define START_ANGLE 1.3089969389957472 /* 75 degrees */

static eom_system *pendulum_system(const pendulum *p) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &pendulum_model, p, NULL), EOM_OK);
  return sys;
}

/* By steps of h, from which marks are `every` steps apart; h = 0: chosen. */
static eom_lyapunov_options fixed_steps(eom_lyapunov_scheme scheme, int every, double h) {
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.scheme = scheme;
  options.method = &eom_dp5;
  options.h = h;
  options.interval = every * h;
  return options;
}

static eom_lyapunov *start_with(eom_system *sys, const eom_lyapunov_options *options, double angle) {
  const double y[2 * MOST] = {angle};
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, options, 0, y), EOM_OK);
  return ly;
}

static eom_lyapunov *start(eom_system *sys, eom_lyapunov_scheme scheme, int every, double angle, double h) {
  const eom_lyapunov_options options = fixed_steps(scheme, every, h);
  return start_with(sys, &options, angle);
}

static void run(eom_lyapunov *ly, double t_end) { assert_int_equal(eom_lyapunov_to(ly, t_end, NULL, NULL), EOM_OK); }

static eom_lyapunov_checks check(const eom_lyapunov *ly) {
  eom_lyapunov_checks checks;
  eom_lyapunov_check(ly, &checks);
  return checks;
}

static int one(const void *params) {
  (void)params;
  return 1;
}
static size_t frame(const void *params) {
  (void)params;
  return 8;
}

/* lambda_i(t) of the reference to the bound asked of the project, at steps where the method's own error is below it. */
#define EXPONENT_TOLERANCE 1e-9

/* Runs N links to the times of the reference up to t_end and returns the worst difference of the exponents that the options ask for. */
static double against_reference(int n, const eom_lyapunov_options *options, double t_end) {
  FILE *file = data_open("pendulum_lyapunov.txt");
  data_line line;
  const pendulum p = {n, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start_with(sys, options, START_ANGLE);
  double worst = 0, lambda[2 * MOST];
  int compared = 0;
  while (data_next(file, &line)) {
    if ((int)line.number[0] != n || line.number[1] > t_end) continue;
    assert_int_equal(line.count, 2 + 4 * n);
    run(ly, line.number[1]);
    eom_lyapunov_exponents(ly, lambda);
    for (int i = 0; i < ly->k; i++) {
      assert_close(lambda[i], line.number[2 + i], 0, EXPONENT_TOLERANCE);
      worst = fmax(worst, fabs(lambda[i] - line.number[2 + i]));
    }
    assert_all_close(ly->y, line.number + 2 + 2 * n, 2 * n, 0, EXPONENT_TOLERANCE);
    compared++;
  }
  fclose(file);
  assert_int_equal(compared, t_end < 5 ? 1 : 2);
  double energy;
  pendulum_truth(p.n, p.g, ly->y, ly->y + n, NULL, NULL, &energy);
  assert_close(ly->energy, energy, 1e-14, 0);
  assert_true(ly->energy_error < 1e-9 && (n == 1 || ly->energy != ly->energy0));
  const eom_lyapunov_checks c = check(ly);
  assert_close(c.energy_error, ly->energy_error, 0, 0);
  if (ly->k == 2 * n) assert_true(c.sum_error >= 0 && c.sum_error < 4 * EXPONENT_TOLERANCE);
  if (ly->k < 2 * n) assert_true(c.sum_error == -1 && c.pairing_error == -1 && c.zero[0] == -1);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
  return worst;
}

static double by_fixed_steps(int n, eom_lyapunov_scheme scheme, int every, double h, double t_end) {
  const eom_lyapunov_options options = fixed_steps(scheme, every, h);
  return against_reference(n, &options, t_end);
}

static void finite_times(void **state) {
  (void)state;
  const int t_end = test_tries(5); /* s */
  for (int n = 1; n <= 2; n++)
    print_message("N=%d: discrete %.1e, every 10 steps %.1e\n", n, by_fixed_steps(n, EOM_LYAPUNOV_DISCRETE, 1, 1e-3, t_end),
                  by_fixed_steps(n, EOM_LYAPUNOV_DISCRETE, 10, 1e-3, t_end));
  print_message("N=4: discrete, every 10 steps %.1e\n", by_fixed_steps(4, EOM_LYAPUNOV_DISCRETE, 10, 1e-3, t_end));
  print_message("N=6: discrete %.1e\n", by_fixed_steps(6, EOM_LYAPUNOV_DISCRETE, 1, 1e-3, 1));
  print_message("N=1: continuous %.1e, as printed %.1e\n", by_fixed_steps(1, EOM_LYAPUNOV_CONTINUOUS, 1, 1e-3, t_end),
                by_fixed_steps(1, EOM_LYAPUNOV_PAPER, 1, 1e-3, t_end));
  print_message("N=2: continuous %.1e, as printed %.1e\n", by_fixed_steps(2, EOM_LYAPUNOV_CONTINUOUS, 1, 2.5e-4, 1),
                by_fixed_steps(2, EOM_LYAPUNOV_PAPER, 1, 2.5e-4, 1));
}

/* The method of order 8 by chosen steps, marks far apart: QRs come where growth asks for them. */
static eom_lyapunov_options chosen_steps(eom_lyapunov_scheme scheme) {
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.scheme = scheme;
  options.interval = 1;
  options.control.rtol = options.control.atol = 1e-13;
  options.tangent_tolerance = 1e-12;
  return options;
}

static void by_chosen_steps(void **state) {
  (void)state;
  const int t_end = test_tries(5); /* s */
  const eom_lyapunov_options discrete = chosen_steps(EOM_LYAPUNOV_DISCRETE), continuous = chosen_steps(EOM_LYAPUNOV_CONTINUOUS);
  for (int n = 1; n <= 2; n++)
    print_message("N=%d, chosen steps: discrete %.1e, continuous %.1e\n", n, against_reference(n, &discrete, t_end),
                  against_reference(n, &continuous, t_end));
  print_message("N=4, chosen steps: discrete %.1e\n", against_reference(4, &discrete, t_end));
  print_message("N=6, chosen steps: discrete %.1e, continuous %.1e\n", against_reference(6, &discrete, 1),
                against_reference(6, &continuous, 1));
}

/* Tangents in steps of their own, along the motion by its interpolation: as good as their tolerance says. Parted only where it pays. */
#define PARTED_TOLERANCE 1e-6

static void parted(int n, eom_lyapunov_scheme scheme, double tolerance, double interval, double t_end) {
  const pendulum p = {n, 9.81};
  eom_lyapunov_options options = chosen_steps(scheme);
  options.interval = interval;
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *together = start_with(sys, &options, START_ANGLE), *apart;
  assert_int_equal(together->tangents.dim, 0);
  run(together, t_end);
  options.tangent_tolerance = tolerance;
  apart = start_with(sys, &options, START_ANGLE);
  assert_true(apart->tangents.dim > 0 && apart->it.dim == 2 * n);
  run(apart, t_end);
  assert_all_close(apart->y, together->y, 2 * n, 0, 1e-11);
  assert_all_close(apart->rho, together->rho, 2 * n, 0, PARTED_TOLERANCE * fabs(t_end));
  assert_true(apart->tangents.steps < apart->it.steps && check(apart).sum_error < PARTED_TOLERANCE);
  double worst = 0;
  for (int i = 0; i < 2 * n; i++) worst = fmax(worst, fabs(apart->rho[i] - together->rho[i]));
  print_message("N=%d, scheme %d: %ld steps of the motion, %ld of the tangents; rho differ by %.1e\n", n, scheme, apart->it.steps,
                apart->tangents.steps, worst);
  eom_lyapunov_destroy(together);
  eom_lyapunov_destroy(apart);
  eom_system_destroy(sys);
}

static void tangents_in_steps_of_their_own(void **state) {
  (void)state;
  const int t_end = test_tries(2); /* s */
  parted(6, EOM_LYAPUNOV_DISCRETE, 1e-7, 0.25, t_end);
  parted(4, EOM_LYAPUNOV_DISCRETE, 1e-7, -1, -t_end);
  parted(4, EOM_LYAPUNOV_CONTINUOUS, 1e-7, 1, t_end);
}

/* Tangents so inexact that their steps would pass all steps of the motion that are kept: they are tried again, shorter. */
/* What the motion has lost by rounding is not lost at marks. */
static void marks_leave_the_motion_alone(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  const double tolerance = 1e-13, y[4] = {1.3089969389957472};
  static double work[EOM_INTEGRATOR_SIZE(12, 3, 4)]; /* of eom_dop853 */
  eom_lyapunov_options options = eom_lyapunov_options_default();
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly;
  eom_integrator it;
  options.interval = 0.25;
  options.tangent_tolerance = 1e-3;
  options.control = (eom_step_control){.rtol = tolerance, .atol = tolerance};
  eom_integrator_init(&it, &eom_dop853, eom_rhs, sys, 4, 0, y, 0, work);
  assert_int_equal(eom_integrator_control(&it, &options.control), EOM_OK);
  for (int mark = 1; mark <= 20; mark++) assert_int_equal(eom_integrate(&it, mark * options.interval, NULL, NULL), EOM_OK);
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
  run(ly, 5);
  assert_true(ly->tangents.steps > 0 && ly->it.steps == it.steps);
  assert_memory_equal(ly->y, it.y, sizeof y);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

static void path_is_long_enough(void **state) {
  (void)state;
  const pendulum p = {4, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE);
  options.tangent_tolerance = 1;
  eom_lyapunov *ly = start_with(sys, &options, START_ANGLE);
  run(ly, test_tries(5));
  assert_true(ly->it.steps > 4 * ly->tangents.steps);
  eom_lyapunov_destroy(ly);
  options.control.most_steps = 50;
  ly = start_with(sys, &options, START_ANGLE);
  assert_int_equal(eom_lyapunov_step(ly), EOM_TOO_MUCH_WORK);
  assert_close(ly->t, 0, 0, 0);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* The motion ahead of tangents that need few digits costs its stages and nothing to interpolate; its own steps say how long those of
 * the tangents may be, so that few are refused. */
static void little_is_wasted(void **state) {
  (void)state;
  const pendulum p = {4, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE);
  options.tangent_tolerance = 1e-4;
  eom_lyapunov *ly = start_with(sys, &options, START_ANGLE);
  const int marks = 8; /* too few tell nothing: the first steps have no step before them */
  run(ly, marks);
  print_message("%ld steps of the motion, %ld of the tangents and %ld refused\n", ly->it.steps, ly->tangents.steps,
                ly->tangents.rejected);
  const long stages = eom_dop853.stages;
  assert_true(ly->it.evaluations <= stages * (ly->it.steps + ly->it.rejected) + 2 * marks);
  assert_true(8 * ly->tangents.rejected < ly->tangents.steps && 4 * ly->tangents.steps < ly->it.steps);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* A damped oscillator, x'' + 2 z x' + w^2 x = 0: exponents -z +- sqrt(z^2 - w^2), or twice -z where it turns. At rest the motion asks
 * for no steps, but its tangents do. */
static void oscillator_lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)t, (void)params;
  pen p = {cx, 0};
  pen_result(&p, out, times(&p, 0.5, sub(&p, square(&p, qd), times(&p, 9, square(&p, q)))));
  pen_lift(&p);
}
static void oscillator_drag(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)q, (void)t;
  pen p = {cx, 0};
  pen_result(&p, out, times(&p, -2 * *(const double *)params, qd));
  pen_lift(&p);
}

static void damped_oscillator(void **state) {
  (void)state;
  const eom_model model = {.name = "oscillator",
                           .dof = one,
                           .params_size = sizeof(double),
                           .lagrangian = {"lagrangian", "", oscillator_lagrangian, one, frame},
                           .force = {"drag", "", oscillator_drag, one, frame}};
  const double damping[] = {5, 0.5}, fast[] = {-1, -0.5}, slow[] = {-9, -0.5};
  for (int k = 0; k < 2; k++)
    for (int moving = 0; moving < 2; moving++) {
      eom_system *sys;
      assert_int_equal(eom_system_create(&sys, &model, &damping[k], NULL), EOM_OK);
      eom_lyapunov_options options = eom_lyapunov_options_default();
      options.interval = acos(-1.0) / sqrt(9 - 0.25); /* half a turn of the slow one */
      options.tangent_tolerance = 1e-8;
      const double y[2] = {moving};
      eom_lyapunov *ly;
      assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
      for (int i = 0; i < 8; i++) assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
      const double rho[2] = {ly->rho[0], ly->rho[1]}, t = ly->t;
      for (int i = 0; i < 8; i++) assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
      assert_close((ly->rho[0] - rho[0]) / (ly->t - t), fast[k], 0, 1e-6);
      assert_close((ly->rho[1] - rho[1]) / (ly->t - t), slow[k], 0, 1e-6);
      const eom_lyapunov_checks c = check(ly);
      assert_close(c.divergence, -2 * damping[k], 1e-9, 0);
      assert_true(c.sum_error < 1e-6);
      eom_lyapunov_destroy(ly);
      eom_system_destroy(sys);
    }
}

/* Continuous QR keeps the order of its method, here 8: what R the orthonormalisation after each step throws away is of the order of the
 * step's error. That is larger than for the tangents themselves, whose R is integrated with them: Q turns fast where exponents cross.
 */
static void continuous_scheme_keeps_the_order(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  double rho[3][4];
  for (int k = 0; k < 3; k++) {
    eom_lyapunov_options options = fixed_steps(EOM_LYAPUNOV_CONTINUOUS, 1, k == 2 ? 6.25e-4 : k == 1 ? 2.5e-3 : 5e-3);
    options.method = &eom_dop853;
    eom_lyapunov *ly = start_with(sys, &options, START_ANGLE);
    run(ly, 1);
    memcpy(rho[k], ly->rho, sizeof rho[k]);
    eom_lyapunov_destroy(ly);
  }
  double error[2] = {0};
  for (int k = 0; k < 2; k++)
    for (int i = 0; i < 4; i++) error[k] = fmax(error[k], fabs(rho[k][i] - rho[2][i]));
  print_message("continuous by dop853: errors %.1e at 5 ms, %.1e at 2.5 ms\n", error[0], error[1]);
  assert_true(error[0] / error[1] > 128 && error[0] / error[1] < 1024);
  eom_system_destroy(sys);
}

/* The first k of d, with which the references begin. */
static const double *unit_vectors(int d, int k) {
  static double start[12 * 12];
  memset(start, 0, sizeof start);
  for (int i = 0; i < k; i++) start[i * k + i] = 1;
  assert_true(d <= 12);
  return start;
}

/* The first k exponents are those of the whole spectrum, whichever way F X is computed. */
static void first_exponents(void **state) {
  (void)state;
  const int t_end = test_tries(5); /* s */
  for (int k = 1; k <= 4; k++)
    for (int scheme = EOM_LYAPUNOV_DISCRETE; scheme <= EOM_LYAPUNOV_CONTINUOUS; scheme++) {
      eom_lyapunov_options options = chosen_steps((eom_lyapunov_scheme)scheme);
      options.k = k;
      options.start = unit_vectors(4, k);
      against_reference(2, &options, t_end);
    }
  for (int i = 0; i < test_tries(4); i++) {
    eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE);
    options.k = 1 + 3 * i;
    options.start = unit_vectors(12, options.k);
    against_reference(6, &options, 1);
  }
}

/* An oscillator and a saddle that know nothing of each other: L = (qd0^2 + qd1^2 - q0^2 + q1^2)/2. */
static void apart(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)t, (void)params;
  pen p = {cx, 0};
  tl_real *square = pen_new(&p);
  if (!square) return;
  tl_const(cx, out, 0);
  for (int i = 0; i < 2; i++) {
    tl_mul(cx, square, at(&p, qd, i), at(&p, qd, i));
    tl_axpy(cx, out, 0.5, square);
    tl_mul(cx, square, at(&p, q, i), at(&p, q, i));
    tl_axpy(cx, out, i == 0 ? -0.5 : 0.5, square);
  }
  pen_lift(&p);
}

static int always_two(const void *params) { return (void)params, 2; }
static int always_one(const void *params) { return (void)params, 1; }
static size_t one_jet(const void *params) { return (void)params, 1; }

/* The first exponent is the saddle's, 1, though the first coordinate is the oscillator's. */
static void first_exponent_of_parts(void **state) {
  (void)state;
  static const eom_model model = {
      .name = "apart",
      .dof = always_two,
      .lagrangian = {.name = "apart", .source = "apart.c:1", .jet = apart, .rows = always_one, .frame = one_jet}};
  eom_system *sys;
  eom_lyapunov *ly;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_OK);
  for (int k = 1; k <= 3; k++) {
    const double y[4] = {0.1};
    double lambda[3];
    eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE);
    options.k = k;
    assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
    run(ly, 40);
    eom_lyapunov_exponents(ly, lambda);
    assert_close(lambda[0], 1, 0, 0.1); /* until the direction is found costs some e-foldings in 40 */
    assert_true(k < 2 || fabs(lambda[1]) < 0.1);
    eom_lyapunov_destroy(ly);
  }
  eom_system_destroy(sys);
}

/* The scheme as printed loses orthogonality: by step halving its |Q'Q - I| falls with the fifth order at first, and at the printed step
 * of 0.05 s two links overflow within half a second, with everything left as before the step that failed. */
static void printed_scheme_loses_orthogonality(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  double error[2];
  for (int k = 0; k < 2; k++) {
    eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_PAPER, 1, START_ANGLE, k ? 5e-4 : 1e-3);
    run(ly, 1);
    error[k] = check(ly).orthogonality;
    eom_lyapunov_destroy(ly);
  }
  print_message("|Q'Q - I| at 1 s: %.2e, at half the step %.2e\n", error[0], error[1]);
  assert_true(error[0] / error[1] > 24 && error[0] / error[1] < 40);

  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_PAPER, 1, START_ANGLE, 0.05);
  eom_status status = EOM_OK;
  double before[4] = {0}, t = 0;
  while (status == EOM_OK && ly->t < 1) {
    memcpy(before, ly->y, sizeof before);
    t = ly->t;
    status = eom_lyapunov_step(ly);
  }
  assert_int_equal(status, EOM_NOT_FINITE);
  assert_true(t <= 0.5);
  assert_close(ly->t, t, 0, 0);
  assert_all_close(ly->y, before, 4, 0, 0);
  double lambda[4];
  eom_lyapunov_exponents(ly, lambda);
  for (int i = 0; i < 4; i++) assert_true(isfinite(lambda[i]));
  const eom_lyapunov_checks c = check(ly);
  assert_true(isfinite(c.orthogonality) && isfinite(c.sum_error) && isfinite(c.pairing_error));
  eom_lyapunov_destroy(ly);

  ly = start(sys, EOM_LYAPUNOV_CONTINUOUS, 1, START_ANGLE, 1e-3);
  run(ly, 1);
  assert_true(check(ly).orthogonality < 1e-14);
  assert_int_equal(ly->it.evaluations, 7000); /* the first stage again after each QR */
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* At the stable rest of one link the tangents rotate: exponents 0, 0; at the unstable one they are +-sqrt(g), whose directions are
 * found from any start after a few seconds. */
static void rest_positions(void **state) {
  (void)state;
  const pendulum p = {1, 9.81};
  eom_system *sys = pendulum_system(&p);
  double lambda[2];
  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_DISCRETE, 1, acos(-1.0), 1e-2);
  run(ly, 4); /* the double nearest pi leaves the rest after 8 s */
  eom_lyapunov_exponents(ly, lambda);
  assert_close(lambda[0], sqrt(9.81), 0, 0.5); /* the first turn of the directions counts like 1/t */
  assert_close(lambda[0] + lambda[1], 0, 0, 1e-9);
  assert_true(check(ly).pairing_error < 1e-9);
  const double growth = ly->rho[0];
  run(ly, 5);
  assert_close(ly->rho[0] - growth, sqrt(9.81), 1e-9, 0);
  eom_lyapunov_destroy(ly);
  ly = start(sys, EOM_LYAPUNOV_DISCRETE, 1, 0, 1e-2);
  run(ly, 50);
  eom_lyapunov_exponents(ly, lambda);
  assert_true(fabs(lambda[0]) < 0.05 && fabs(lambda[1]) < 0.05);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* With drag the sum of the exponents is the mean divergence, not zero: trace F = -0.3 (1 + 1 + 1/3 + 1/3) without constraints. */
static void sum_is_the_divergence(void **state) {
  (void)state;
  eom_model free_masses = cartesian_double_pendulum;
  free_masses.nholonomic = 0;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &free_masses, NULL, NULL), EOM_OK);
  const double y[8] = {0.6, 0.8, 1.6, 0.8};
  const eom_lyapunov_options options = fixed_steps(EOM_LYAPUNOV_DISCRETE, 1, 1e-2);
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
  run(ly, 2);
  const eom_lyapunov_checks c = check(ly);
  assert_close(c.divergence, -0.8, 1e-12, 0);
  assert_true(c.sum_error < 1e-10);
  assert_true(c.pairing_error > 0.1);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* A failure of the model ends the step with its status and report, as at the last mark. */
static void model_failure(void **state) {
  (void)state;
  const redundancy r = {.rows = 2, .factor = {1, 1}, .bend = {0, 1}}; /* contradict each other at once */
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &redundant, &r, NULL), EOM_OK);
  const double y[4] = {0.6, 0.8, 0, 0};
  const eom_lyapunov_options options = fixed_steps(EOM_LYAPUNOV_DISCRETE, 1, 1e-2);
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
  assert_int_equal(eom_lyapunov_step(ly), EOM_INCONSISTENT);
  assert_int_equal(sys->report.nrow, 2);
  assert_close(ly->t, 0, 0, 0);
  eom_lyapunov_destroy(ly);
  const double bad[4] = {nan("")};
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, bad), EOM_NOT_FINITE);
  assert_null(ly);
  eom_system_destroy(sys);
}

static void bad_option(eom_system *sys, const eom_lyapunov_options *options) {
  const double y[4] = {1};
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, options, 0, y), EOM_BAD_OPTION);
  assert_null(ly);
}

static void bad_options(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  const eom_lyapunov_options good = chosen_steps(EOM_LYAPUNOV_DISCRETE);
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov_options o;
#define BAD(field, value)                                                                                                              \
  o = good;                                                                                                                            \
  o.field = value;                                                                                                                     \
  bad_option(sys, &o);
  bad_option(sys, NULL); /* no interval */
  BAD(scheme, (eom_lyapunov_scheme)9)
  BAD(product, (eom_lyapunov_product)9)
  BAD(product, EOM_LYAPUNOV_BY_DIRECTIONS) /* the system was not asked for tangents */
  BAD(k, -1)
  BAD(k, 5)
  BAD(interval, 0)
  BAD(interval, nan(""))
  BAD(interval, HUGE_VAL)
  BAD(h, -1e-3)
  BAD(h, nan(""))
  BAD(control.rtol, -1)
  BAD(control, ((eom_step_control){0}))
  BAD(tangent_tolerance, 0)
  BAD(tangent_tolerance, nan(""))
  BAD(stop_half_width, -1)
  BAD(stop_after, nan(""))
  o = good;
  o.k = 2;
  o.stop_half_width = 0.1;
  o.stop_exponent = 2;
  bad_option(sys, &o);
  o = good;
  o.scheme = EOM_LYAPUNOV_PAPER;
  o.k = 3;
  bad_option(sys, &o);
  assert_int_equal(eom_lyapunov_bytes(sys, &o), 0);
  const double twice[8] = {1, 1, 2, 2, 3, 3, 4, 4}; /* two directions that are one */
  eom_lyapunov *ly;
  o = good;
  o.k = 2;
  o.start = twice;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &o, 0, twice), EOM_NOT_FINITE);
  ly = start_with(sys, &good, 1);
  assert_int_equal(eom_lyapunov_to(ly, -1, NULL, NULL), EOM_BAD_OPTION);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* Directions turn, they do not flip; backwards in time what grew falls. */
static void there_and_back(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE);
  options.k = 1;
  options.start = unit_vectors(4, 1);
  eom_lyapunov *ly = start_with(sys, &options, START_ANGLE), *back;
  run(ly, 2);
  double start_of_back[4];
  for (int i = 0; i < 4; i++) start_of_back[i] = ly->Q[i];
  options.start = start_of_back;
  options.interval = -1;
  assert_int_equal(eom_lyapunov_create(&back, sys, &options, ly->t, ly->y), EOM_OK);
  run(back, 0);
  assert_close(back->t, 0, 0, 0);
  assert_close(back->rho[0], -ly->rho[0], 0, 1e-8);
  assert_all_close(back->Q, ((const double[]){1, 0, 0, 0}), 4, 0, 1e-8);
  eom_lyapunov_destroy(ly);
  eom_lyapunov_destroy(back);
  eom_system_destroy(sys);
}

/* The observer sees each mark and may stop; the stop rule ends a run where its exponent is known well enough. */
static int count_marks(void *observer, const eom_lyapunov *ly) {
  int *left = observer;
  assert_close(ly->t, 0.5 * (double)ly->marks, 0, 0);
  return --*left == 0;
}

static void ends_of_runs(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.interval = 0.5;
  eom_lyapunov *ly = start_with(sys, &options, START_ANGLE);
  int left = 7;
  assert_int_equal(eom_lyapunov_to(ly, 10, count_marks, &left), EOM_STOPPED);
  assert_int_equal(ly->marks, 7);
  assert_int_equal(eom_lyapunov_to(ly, 10, count_marks, &left), EOM_OK);
  assert_close(ly->t, 10, 0, 0);
  assert_int_equal(eom_lyapunov_settled(ly), 0);
  double mean, half_width;
  assert_true(eom_lyapunov_interval(ly, 0, &mean, &half_width) >= 8);
  eom_lyapunov_destroy(ly);

  options.stop_half_width = half_width;
  ly = start_with(sys, &options, START_ANGLE);
  run(ly, 20);
  assert_true(ly->t <= 10 && eom_lyapunov_settled(ly));
  eom_lyapunov_destroy(ly);
  options.stop_after = 11;
  ly = start_with(sys, &options, START_ANGLE);
  run(ly, 10.5);
  assert_close(ly->t, 10.5, 0, 0);
  assert_int_equal(eom_lyapunov_settled(ly), 0);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* The same run twice gives the same bits, in memory of any content and alignment. */
static void repeats_to_the_bit(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  const eom_lyapunov_options options = fixed_steps(EOM_LYAPUNOV_DISCRETE, 1, 1e-3);
  double rho[2][4];
  for (int k = 0; k < 2; k++) {
    static char memory[60000];
    memset(memory, k ? 0xff : 0x33, sizeof memory);
    const size_t bytes = eom_lyapunov_bytes(sys, &options);
    assert_true(bytes + 1 <= sizeof memory);
    const double y[4] = {START_ANGLE};
    eom_lyapunov ly;
    assert_int_equal(eom_lyapunov_init(&ly, sys, &options, 0, y, memory + k, bytes), EOM_OK);
    run(&ly, 0.1);
    memcpy(rho[k], ly.rho, sizeof rho[k]);
    memcpy(ly.rho, (const double[]){3, 1, -3, -1.5}, sizeof rho[k]); /* pairs +-3 and 1, -1.5 once sorted */
    assert_close(check(&ly).pairing_error, 0.5 / 0.1, 1e-12, 0);
    assert_close(check(&ly).zero[0], 1 / 0.1, 1e-12, 0);
    assert_close(check(&ly).zero[1], 1.5 / 0.1, 1e-12, 0);
    assert_int_equal(eom_lyapunov_init(&ly, sys, &options, 0, y, memory, bytes - 1), EOM_NO_MEMORY);
  }
  assert_memory_equal(rho[0], rho[1], sizeof rho[0]);
  eom_system_destroy(sys);
}

/* L = x'^2/2 - cos t x^2/2 at rest: y stays and F changes with t. rho_1 = log |P e_1| of P'' = -cos t P, by small Runge-Kutta 4 steps.
 */
static void parametric(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)params;
  pen p = {cx, 0};
  pen_result(&p, out, times(&p, 0.5, sub(&p, square(&p, qd), mul(&p, cosine(&p, t), square(&p, q)))));
  pen_lift(&p);
}
static void mathieu(double t_end, double *x) {
  const int steps = 20000;
  const double h = t_end / steps;
  for (int k = 0; k < steps; k++) {
    const double c0 = cos(k * h), c1 = cos((k + 0.5) * h), c2 = cos((k + 1) * h);
    const double a1 = x[1], b1 = -c0 * x[0], a2 = x[1] + h / 2 * b1, b2 = -c1 * (x[0] + h / 2 * a1);
    const double a3 = x[1] + h / 2 * b2, b3 = -c1 * (x[0] + h / 2 * a2), a4 = x[1] + h * b3, b4 = -c2 * (x[0] + h * a3);
    x[0] += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    x[1] += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
  }
}

static void time_dependent_rest(void **state) {
  (void)state;
  const eom_model model = {.name = "parametric", .dof = one, .lagrangian = {"parametric", "", parametric, one, frame}};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_OK);
  const double y[2] = {0};
  double x[2] = {1, 0};
  mathieu(6, x);
  eom_lyapunov *ly;
  const eom_lyapunov_options options = fixed_steps(EOM_LYAPUNOV_DISCRETE, 1, 1e-2);
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
  run(ly, 6);
  assert_close(ly->rho[0], log(hypot(x[0], x[1])), 1e-10, 0);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* 200 steps: 64 blocks of one step become 32 of two, then 32 of four; 50 are full at the end and hold all of rho. */
static void blocks_hold_the_growth(void **state) {
  (void)state;
  const pendulum p = {1, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_DISCRETE, 1, 1, 0.01);
  run(ly, 2);
  assert_int_equal(ly->nblock, 50);
  assert_int_equal(ly->block_marks, 4);
  for (int i = 0; i < 2; i++) {
    double sum = 0;
    for (int b = 0; b < ly->nblock; b++) sum += ly->block[b * 2 + i];
    assert_close(sum, ly->rho[i], 0, 1e-13);
  }
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* Tangents that have become dependent have no QR with R_ii > 0: a status, and everything as at the last mark. */
static void dependent_tangents(void **state) {
  (void)state;
  const pendulum p = {1, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_DISCRETE, 1, 1, 0.01);
  run(ly, 0.05);
  double before[7], rho[2];
  memcpy(before, ly->it.y, sizeof before);
  memcpy(rho, ly->rho, sizeof rho);
  for (int i = 2; i < 6; i++) ly->it.y[i] = 0;
  assert_int_equal(eom_lyapunov_step(ly), EOM_NOT_FINITE);
  assert_all_same(ly->it.y, before, 7);
  assert_all_same(ly->rho, rho, 2);
  assert_close(ly->t, 0.05, 1e-15, 0);
  assert_int_equal(ly->it.steps, 5);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(finite_times),
                                     cmocka_unit_test(by_chosen_steps),
                                     cmocka_unit_test(tangents_in_steps_of_their_own),
                                     cmocka_unit_test(marks_leave_the_motion_alone),
                                     cmocka_unit_test(path_is_long_enough),
                                     cmocka_unit_test(little_is_wasted),
                                     cmocka_unit_test(damped_oscillator),
                                     cmocka_unit_test(continuous_scheme_keeps_the_order),
                                     cmocka_unit_test(first_exponents),
                                     cmocka_unit_test(first_exponent_of_parts),
                                     cmocka_unit_test(printed_scheme_loses_orthogonality),
                                     cmocka_unit_test(rest_positions),
                                     cmocka_unit_test(sum_is_the_divergence),
                                     cmocka_unit_test(model_failure),
                                     cmocka_unit_test(time_dependent_rest),
                                     cmocka_unit_test(blocks_hold_the_growth),
                                     cmocka_unit_test(dependent_tangents),
                                     cmocka_unit_test(there_and_back),
                                     cmocka_unit_test(ends_of_runs),
                                     cmocka_unit_test(bad_options),
                                     cmocka_unit_test(repeats_to_the_bit)};
  return cmocka_run_group_tests_name("lyapunov", tests, NULL, NULL);
}
