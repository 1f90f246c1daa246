/* Lyapunov exponents on constraint manifolds: those of the same mechanism in minimal coordinates, the divergence, redundant rows. */
#include "close.h"
#include "constrained_models.h"
#include "pen.h"
#include "pendulum_model.h"

#include "eom/eom.h"

#include <math.h>

enum { MOST = 2 };

/* ---- the pendulum of pendulum_model.c by the positions of its masses, q = (x_1, y_1, x_2, ..), y up ---- */

static int twice(const void *params) { return 2 * ((const pendulum *)params)->n; }
static int links(const void *params) { return ((const pendulum *)params)->n; }
static int one(const void *params) {
  (void)params;
  return 1;
}
static size_t frame(const void *params) {
  (void)params;
  return PEN_FRAME;
}

static void positions_lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)t;
  const pendulum *chain = params;
  pen p = {cx, 0};
  jet sum = times(&p, 0, at(&p, q, 0));
  for (int i = 0; i < 2 * chain->n; i++) sum = add(&p, sum, times(&p, 0.5, square(&p, at(&p, qd, i))));
  for (int i = 0; i < chain->n; i++) sum = sub(&p, sum, times(&p, chain->g, at(&p, q, 2 * i + 1)));
  pen_result(&p, out, sum);
  pen_lift(&p);
}

static void rods(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  (void)qd, (void)t;
  const pendulum *chain = params;
  for (int i = 0; i < chain->n; i++) {
    pen p = {cx, 0};
    jet x = at(&p, q, 2 * i), y = at(&p, q, 2 * i + 1);
    if (i > 0) x = sub(&p, x, at(&p, q, 2 * i - 2)), y = sub(&p, y, at(&p, q, 2 * i - 1));
    pen_result(&p, out + i * cx->shape->ncoef, plus(&p, add(&p, square(&p, x), square(&p, y)), -1));
    pen_lift(&p);
  }
}

static const eom_function rod_list[] = {{.name = "rods", .source = "test.c:1", .jet = rods, .rows = links, .frame = frame}};
static const eom_model positions = {
    .name = "positions",
    .dof = twice,
    .params_size = sizeof(pendulum),
    .lagrangian = {.name = "lagrangian", .source = "test.c:1", .jet = positions_lagrangian, .rows = one, .frame = frame},
    .holonomic = rod_list,
    .nholonomic = 1};

/* ---- from angles to positions ---- */

/* x = h(y) for y = (theta, theta'), x = (q, qd) of 4n numbers, and J = dh/dy: 4n x 2n. */
static void to_positions(int n, const double *y, double *x, double *J) {
  const int d = 2 * n;
  for (int i = 0; i < 4 * n; i++) x[i] = 0;
  for (int i = 0; i < 4 * n * d; i++) J[i] = 0;
  for (int k = 0; k < n; k++)
    for (int i = 0; i <= k; i++) {
      const double s = sin(y[i]), c = cos(y[i]), w = y[n + i];
      const int at = 2 * k, v = 2 * n + 2 * k;
      x[at] += s, x[at + 1] -= c;
      x[v] += c * w, x[v + 1] += s * w;
      J[at * d + i] = J[v * d + n + i] = c;
      J[(at + 1) * d + i] = J[(v + 1) * d + n + i] = s;
      J[v * d + i] = -s * w;
      J[(v + 1) * d + i] = c * w;
    }
}

/* log R_ii of X = Q R for k columns of length rows, by modified Gram-Schmidt; X becomes Q. */
static void log_lengths(int rows, int k, double *X, double *log_R) {
  for (int j = 0; j < k; j++) {
    for (int i = 0; i < j; i++) {
      double along = 0;
      for (int l = 0; l < rows; l++) along += X[l * k + i] * X[l * k + j];
      for (int l = 0; l < rows; l++) X[l * k + j] -= along * X[l * k + i];
    }
    double size = 0;
    for (int l = 0; l < rows; l++) size += X[l * k + j] * X[l * k + j];
    log_R[j] = log(size) / 2;
    for (int l = 0; l < rows; l++) X[l * k + j] /= sqrt(size);
  }
}

static eom_lyapunov_options chosen_steps(eom_lyapunov_scheme scheme, eom_lyapunov_product product) {
  eom_lyapunov_options options = eom_lyapunov_options_default();
  options.scheme = scheme;
  options.product = product;
  options.interval = 0.5;
  options.control.rtol = options.control.atol = 1e-12;
  options.tangent_tolerance = 1e-11;
  return options;
}

static eom_system *system_of(const eom_model *model, const void *params, double baumgarte) {
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_LINEARISE | EOM_NEED_TANGENT;
  options.baumgarte = (eom_baumgarte){baumgarte, baumgarte};
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  return sys;
}

/* With Phi the tangent map of the angles, that of the positions is J(t) Phi J(0)^-1 on what the rods allow. From the start directions
 * of J(0) = Q_0 R_0 and J(t) Q = Q' R' the growth of direction i is that of the angles and log R'_ii - log R_0,ii. To the tolerance of
 * the two integrations. */
#define GROWTH_TOLERANCE 2e-9

static void as_in_angles(int n, eom_lyapunov_scheme scheme, eom_lyapunov_product product, double baumgarte, double t_end) {
  const pendulum p = {n, 9.81};
  const int d = 2 * n;
  const double y[2 * MOST] = {1.3, -0.4};
  double x[4 * MOST], J[8 * MOST * MOST], log_R0[2 * MOST], log_R1[2 * MOST];
  eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_BY_JACOBIAN);
  options.interval = copysign(options.interval, t_end);
  eom_system *by_angle = system_of(&pendulum_model, &p, 0), *by_position = system_of(&positions, &p, baumgarte);
  eom_lyapunov *angles, *ly;
  assert_int_equal(eom_lyapunov_create(&angles, by_angle, &options, 0, y), EOM_OK);

  to_positions(n, y, x, J);
  options = chosen_steps(scheme, product);
  options.interval = copysign(options.interval, t_end);
  options.start = J;
  assert_int_equal(eom_lyapunov_create(&ly, by_position, &options, 0, x), EOM_OK);
  assert_int_equal(ly->d, d);
  assert_int_equal(ly->k, d);
  log_lengths(2 * d, d, J, log_R0);
  assert_all_close(ly->Q, J, 2 * d * d, 0, 1e-14);

  assert_int_equal(eom_lyapunov_to(angles, t_end, NULL, NULL), EOM_OK);
  assert_int_equal(eom_lyapunov_to(ly, t_end, NULL, NULL), EOM_OK);
  to_positions(n, angles->y, x, J);
  assert_all_close(ly->y, x, 2 * d, 0, GROWTH_TOLERANCE);
  double turned[8 * MOST * MOST];
  for (int i = 0; i < 2 * d; i++)
    for (int j = 0; j < d; j++) {
      turned[i * d + j] = 0;
      for (int l = 0; l < d; l++) turned[i * d + j] += J[i * d + l] * angles->Q[l * d + j];
    }
  log_lengths(2 * d, d, turned, log_R1);
  for (int i = 0; i < d; i++) assert_close(ly->rho[i], angles->rho[i] + log_R1[i] - log_R0[i], 0, GROWTH_TOLERANCE);
  assert_all_close(ly->Q, turned, 2 * d * d, 0, 1e-7);

  eom_lyapunov_checks c;
  eom_lyapunov_check(ly, &c);
  assert_true(c.orthogonality < 1e-14);
  assert_true(c.energy_error < 1e-9);
  if (product == EOM_LYAPUNOV_BY_JACOBIAN) assert_true(c.sum_error >= 0 && c.sum_error < GROWTH_TOLERANCE);
  if (product == EOM_LYAPUNOV_BY_DIRECTIONS) assert_true(c.sum_error == -1);
  eom_lyapunov_destroy(angles);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(by_angle);
  eom_system_destroy(by_position);
}

static void spectrum_is_that_of_minimal_coordinates(void **state) {
  (void)state;
  for (int n = 1; n <= MOST; n++)
    for (int scheme = EOM_LYAPUNOV_DISCRETE; scheme <= EOM_LYAPUNOV_CONTINUOUS; scheme++) {
      as_in_angles(n, (eom_lyapunov_scheme)scheme, EOM_LYAPUNOV_BY_JACOBIAN, 0, 3);
      as_in_angles(n, (eom_lyapunov_scheme)scheme, EOM_LYAPUNOV_BY_DIRECTIONS, 0, 3);
    }
  as_in_angles(2, EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_BY_JACOBIAN, 5, 3);
  as_in_angles(2, EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_BY_JACOBIAN, 0, -3);
}

/* ---- the divergence ---- */

/* The sum of the exponents is the mean divergence on the manifold, with friction, time and nonholonomic rows too. */
static void sum_is_the_divergence(void **state) {
  (void)state;
  const double y[3][8] = {{0.6, 0.8, 1.6, 0.8}, {0.1, 0.2, 0.3, 0.4, 0.1, 0.5}, {0}};
  const eom_model *const model[] = {&cartesian_double_pendulum, &sleigh};
  const int exponents[] = {4, 5};
  for (int k = 0; k < 2; k++) {
    const eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_BY_JACOBIAN);
    eom_system *sys = system_of(model[k], NULL, 0);
    eom_lyapunov *ly;
    assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y[k]), EOM_OK);
    assert_int_equal(ly->d, exponents[k]);
    assert_int_equal(eom_lyapunov_to(ly, 2, NULL, NULL), EOM_OK);
    eom_lyapunov_checks c;
    eom_lyapunov_check(ly, &c);
    print_message("%s: sum %.6f, divergence %.6f\n", model[k]->name, c.sum, c.divergence);
    assert_true(fabs(c.divergence) > 1e-3);
    assert_true(c.sum_error >= 0 && c.sum_error < 1e-9);
    eom_lyapunov_destroy(ly);
    eom_system_destroy(sys);
  }
}

/* ---- rows that depend on each other ---- */

/* A rod written once, twice and twice with a factor has the same exponents. */
static void redundant_rows_change_nothing(void **state) {
  (void)state;
  const redundancy rods_written[] = {{.rows = 1, .factor = {1}}, {.rows = 2, .factor = {1, 3}}};
  const double y[4] = {0.6, 0.8, 0.8, -0.6};
  double lambda[2][2];
  for (int k = 0; k < 2; k++) {
    const eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_DISCRETE, EOM_LYAPUNOV_BY_JACOBIAN);
    eom_system *sys = system_of(&redundant, &rods_written[k], 0);
    eom_lyapunov *ly;
    assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
    assert_int_equal(ly->d, 2);
    assert_int_equal(eom_lyapunov_to(ly, 2, NULL, NULL), EOM_OK);
    eom_lyapunov_exponents(ly, lambda[k]);
    eom_lyapunov_checks c;
    eom_lyapunov_check(ly, &c);
    assert_true(k == 0 ? c.sum_error >= 0 && c.sum_error < 1e-9 : c.sum_error == -1);
    eom_lyapunov_destroy(ly);
    eom_system_destroy(sys);
  }
  assert_close(lambda[0][0] + lambda[0][1], lambda[1][0] + lambda[1][1], 0, 1e-9);
}

static void bad_options(void **state) {
  (void)state;
  const double y[4] = {0.6, 0.8};
  eom_lyapunov_options options = chosen_steps(EOM_LYAPUNOV_PAPER, EOM_LYAPUNOV_BY_JACOBIAN);
  eom_system *sys = system_of(&cartesian_pendulum, NULL, 0);
  eom_lyapunov *ly;
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_BAD_OPTION); /* constraints are not in the printed scheme */
  options.scheme = EOM_LYAPUNOV_DISCRETE;
  options.k = 3; /* of two */
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_BAD_OPTION);
  options.k = 1;
  const double off[4] = {0.7, 0.8}; /* is brought onto the circle */
  assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, off), EOM_OK);
  assert_close(hypot(ly->y[0], ly->y[1]), 1, 1e-15, 0);
  eom_lyapunov_destroy(ly);
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(spectrum_is_that_of_minimal_coordinates), cmocka_unit_test(sum_is_the_divergence),
                                     cmocka_unit_test(redundant_rows_change_nothing), cmocka_unit_test(bad_options)};
  return cmocka_run_group_tests_name("lyapunov_constrained", tests, NULL, NULL);
}
