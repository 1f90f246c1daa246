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

static eom_lyapunov *start_by(const eom_method *method, eom_system *sys, eom_lyapunov_scheme scheme, int every, double angle,
                              double h) {
  const eom_lyapunov_options options = {.scheme = scheme, .every = every, .method = method};
  double y[2 * MOST] = {angle};
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y, h), EOM_OK);
  return ly;
}

static eom_lyapunov *start(eom_system *sys, eom_lyapunov_scheme scheme, int every, double angle, double h) {
  return start_by(NULL, sys, scheme, every, angle, h);
}

static void run(eom_lyapunov *ly, double t_end) {
  while (ly->t < t_end - ly->it.h / 2) assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
}

/* lambda_i(t) of the reference to the bound asked of the project, at steps where the method's own error is below it. */
#define EXPONENT_TOLERANCE 1e-9

/* Runs N links to the times of the reference up to t_end and returns the worst difference. */
static double against_reference_by(const eom_method *method, int n, eom_lyapunov_scheme scheme, int every, double h, double t_end) {
  FILE *file = data_open("pendulum_lyapunov.txt");
  data_line line;
  const pendulum p = {n, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start_by(method, sys, scheme, every, START_ANGLE, h);
  double worst = 0, lambda[2 * MOST];
  int compared = 0;
  while (data_next(file, &line)) {
    if ((int)line.number[0] != n || line.number[1] > t_end) continue;
    assert_int_equal(line.count, 2 + 4 * n);
    run(ly, line.number[1]);
    eom_lyapunov_exponents(ly, lambda);
    for (int i = 0; i < 2 * n; i++) {
      assert_close(lambda[i], line.number[2 + i], 0, EXPONENT_TOLERANCE);
      assert_close(ly->y[i], line.number[2 + 2 * n + i], 0, EXPONENT_TOLERANCE);
      worst = fmax(worst, fabs(lambda[i] - line.number[2 + i]));
    }
    compared++;
  }
  fclose(file);
  assert_int_equal(compared, t_end < 5 ? 1 : 2);
  double energy;
  pendulum_truth(p.n, p.g, ly->y, ly->y + n, NULL, NULL, &energy);
  assert_close(ly->energy, energy, 1e-14, 0);
  assert_true(fabs(ly->energy - ly->energy0) < 1e-9 && (n == 1 || ly->energy != ly->energy0));
  assert_true(eom_lyapunov_sum_error(ly) < 4 * EXPONENT_TOLERANCE);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
  return worst;
}

static double against_reference(int n, eom_lyapunov_scheme scheme, int every, double h, double t_end) {
  return against_reference_by(NULL, n, scheme, every, h, t_end);
}

/* The method of order 8 does with steps of 5 and 2.5 ms what the default needs 1 ms for. */
static void by_a_method_of_higher_order(void **state) {
  (void)state;
  const int t_end = test_tries(5); /* s */
  print_message("dop853, N=2: discrete %.1e\n", against_reference_by(&eom_dop853, 2, EOM_LYAPUNOV_DISCRETE, 1, 5e-3, t_end));
  print_message("dop853, N=4: discrete %.1e\n", against_reference_by(&eom_dop853, 4, EOM_LYAPUNOV_DISCRETE, 1, 2.5e-3, t_end));
}

static void finite_times(void **state) {
  (void)state;
  const int t_end = test_tries(5); /* s */
  for (int n = 1; n <= 2; n++)
    print_message("N=%d: discrete %.1e, every 10 steps %.1e\n", n, against_reference(n, EOM_LYAPUNOV_DISCRETE, 1, 1e-3, t_end),
                  against_reference(n, EOM_LYAPUNOV_DISCRETE, 10, 1e-3, t_end));
  print_message("N=4: discrete, every 10 steps %.1e\n", against_reference(4, EOM_LYAPUNOV_DISCRETE, 10, 1e-3, t_end));
  print_message("N=6: discrete %.1e\n", against_reference(6, EOM_LYAPUNOV_DISCRETE, 1, 1e-3, 1));
  print_message("N=1: continuous %.1e, as printed %.1e\n", against_reference(1, EOM_LYAPUNOV_CONTINUOUS, 1, 1e-3, t_end),
                against_reference(1, EOM_LYAPUNOV_PAPER, 1, 1e-3, t_end));
  print_message("N=2: continuous %.1e, as printed %.1e\n", against_reference(2, EOM_LYAPUNOV_CONTINUOUS, 1, 2.5e-4, 1),
                against_reference(2, EOM_LYAPUNOV_PAPER, 1, 2.5e-4, 1));
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
    error[k] = eom_lyapunov_orthogonality(ly);
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
  assert_true(isfinite(eom_lyapunov_orthogonality(ly)) && isfinite(eom_lyapunov_sum_error(ly)) &&
              isfinite(eom_lyapunov_pairing_error(ly)));
  eom_lyapunov_destroy(ly);

  ly = start(sys, EOM_LYAPUNOV_CONTINUOUS, 1, START_ANGLE, 1e-3);
  run(ly, 1);
  assert_true(eom_lyapunov_orthogonality(ly) < 1e-14);
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
  assert_true(eom_lyapunov_pairing_error(ly) < 1e-9);
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

/* With drag the sum of the exponents is the mean divergence, not zero: trace F = -0.3 (1 + 1 + 1/3 + 1/3) without constraints, and less
 * with two of them. */
static void sum_is_the_divergence(void **state) {
  (void)state;
  eom_model free_masses = cartesian_double_pendulum;
  free_masses.nholonomic = 0;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &free_masses, NULL, NULL), EOM_OK);
  const double y[8] = {0.6, 0.8, 1.6, 0.8};
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, NULL, 0, y, 1e-2), EOM_OK);
  run(ly, 2);
  assert_close(ly->divergence / 2, -0.8, 1e-12, 0);
  assert_true(eom_lyapunov_sum_error(ly) < 1e-10);
  assert_true(eom_lyapunov_pairing_error(ly) > 0.1);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* A failure of the model ends the step with its status and report, before the step. */
static void model_failure(void **state) {
  (void)state;
  const redundancy r = {.rows = 2, .factor = {1, 1}, .bend = {0, 1}}; /* contradict each other at once */
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &redundant, &r, NULL), EOM_OK);
  const double y[4] = {0.6, 0.8, 0, 0};
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, NULL, 0, y, 1e-2), EOM_OK);
  assert_int_equal(eom_lyapunov_step(ly), EOM_INCONSISTENT);
  assert_int_equal(sys->report.nrow, 2);
  assert_close(ly->t, 0, 0, 0);
  eom_lyapunov_destroy(ly);
  const double bad[4] = {nan("")};
  assert_int_equal(eom_lyapunov_create(&ly, sys, NULL, 0, bad, 1e-2), EOM_NOT_FINITE);
  assert_null(ly);
  assert_int_equal(eom_lyapunov_create(&ly, sys, NULL, 0, y, 0), EOM_BAD_OPTION);
  const eom_lyapunov_options never = {.scheme = EOM_LYAPUNOV_DISCRETE, .every = 0};
  assert_int_equal(eom_lyapunov_create(&ly, sys, &never, 0, y, 0.1), EOM_BAD_OPTION);
  assert_int_equal(eom_lyapunov_bytes(sys, &never), 0);
  eom_system_destroy(sys);
}

/* Between two QRs rho and the directions stay those of the last one, and say so by t_rho. */
static void time_and_directions_between_two_qrs(void **state) {
  (void)state;
  const pendulum p = {1, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_DISCRETE, 4, 1, 0.01);
  for (int k = 1; k <= 4; k++) {
    double lambda[2];
    assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
    assert_close(ly->t, 0.01 * k, 1e-15, 0);
    assert_close(ly->t_rho, k < 4 ? 0 : 0.04, 1e-15, 0);
    assert_true(eom_lyapunov_orthogonality(ly) < 1e-14);
    eom_lyapunov_exponents(ly, lambda);
    assert_true(k == 4 ? lambda[0] != 0 : lambda[0] == 0);
    assert_true(ly->Q[0] > 0.9 && ly->Q[3] > 0.9); /* directions turn, they do not flip */
  }
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* The same run twice gives the same bits, in memory of any content and alignment. */
static void repeats_to_the_bit(void **state) {
  (void)state;
  const pendulum p = {2, 9.81};
  eom_system *sys = pendulum_system(&p);
  const eom_lyapunov_options options = eom_lyapunov_options_default();
  double rho[2][4];
  for (int k = 0; k < 2; k++) {
    static char memory[60000];
    memset(memory, k ? 0xff : 0x33, sizeof memory);
    const size_t bytes = eom_lyapunov_bytes(sys, &options);
    assert_true(bytes + 1 <= sizeof memory);
    const double y[4] = {START_ANGLE};
    eom_lyapunov ly;
    assert_int_equal(eom_lyapunov_init(&ly, sys, &options, 0, y, 1e-3, memory + k, bytes), EOM_OK);
    run(&ly, 0.1);
    memcpy(rho[k], ly.rho, sizeof rho[k]);
    memcpy(ly.rho, (const double[]){3, 1, -3, -1.5}, sizeof rho[k]); /* pairs +-3 and 1, -1.5 once sorted */
    assert_close(eom_lyapunov_pairing_error(&ly), 0.5 / 0.1, 1e-12, 0);
    assert_int_equal(eom_lyapunov_init(&ly, sys, &options, 0, y, 1e-3, memory, bytes - 1), EOM_NO_MEMORY);
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
static int one(const void *params) {
  (void)params;
  return 1;
}
static size_t frame(const void *params) {
  (void)params;
  return 8;
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
  assert_int_equal(eom_lyapunov_create(&ly, sys, NULL, 0, y, 1e-2), EOM_OK);
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
  assert_int_equal(ly->block_steps, 4);
  for (int i = 0; i < 2; i++) {
    double sum = 0;
    for (int b = 0; b < ly->nblock; b++) sum += ly->block[b * 2 + i];
    assert_close(sum, ly->rho[i], 0, 1e-13);
  }
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

/* Tangents that have become dependent have no QR with R_ii > 0: a status, and everything as before the step. */
static void dependent_tangents(void **state) {
  (void)state;
  const pendulum p = {1, 9.81};
  eom_system *sys = pendulum_system(&p);
  eom_lyapunov *ly = start(sys, EOM_LYAPUNOV_DISCRETE, 1, 1, 0.01);
  run(ly, 0.05);
  for (int i = 2; i < 6; i++) ly->it.y[i] = 0;
  double before[7], rho[2];
  memcpy(before, ly->it.y, sizeof before);
  memcpy(rho, ly->rho, sizeof rho);
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
                                     cmocka_unit_test(by_a_method_of_higher_order),
                                     cmocka_unit_test(printed_scheme_loses_orthogonality),
                                     cmocka_unit_test(rest_positions),
                                     cmocka_unit_test(sum_is_the_divergence),
                                     cmocka_unit_test(model_failure),
                                     cmocka_unit_test(time_dependent_rest),
                                     cmocka_unit_test(blocks_hold_the_growth),
                                     cmocka_unit_test(dependent_tangents),
                                     cmocka_unit_test(time_and_directions_between_two_qrs),
                                     cmocka_unit_test(repeats_to_the_bit)};
  return cmocka_run_group_tests_name("lyapunov", tests, NULL, NULL);
}
