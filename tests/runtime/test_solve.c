/* The solver's verdicts: dependent, scaled, permuted and contradicting rows, coordinates without inertia, input that is not finite. */
#include "close.h"
#include "constrained_models.h"
#include "pendulum_model.h"
#include "random.h"

#include "eom/eom.h"
#include "kkt_truth.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* Results that must not depend on how the constraint is written: the same to a few roundings. Measured 1e-15. */
#define SAME_MOTION 1e-14

static eom_system *start(const eom_model *model, const void *params, const eom_options *options) {
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, options), EOM_OK);
  return sys;
}

/* Accelerations and constraint force of the Cartesian pendulum at a state off the manifold, from its one constraint by hand:
 * 2 qdd = (0, -2g) + 2 (x, y) lambda, x x'' + y y'' = -(x'^2 + y'^2). */
static void pendulum_by_hand(const double *q, const double *qd, double *qdd, double *Qc) {
  const double r2 = q[0] * q[0] + q[1] * q[1], lambda = (-(qd[0] * qd[0] + qd[1] * qd[1]) + 9.81 * q[1]) / r2;
  qdd[0] = lambda * q[0];
  qdd[1] = lambda * q[1] - 9.81;
  Qc[0] = 2 * lambda * q[0];
  Qc[1] = 2 * lambda * q[1];
}

static void check_redundant(const redundancy *r, const double *weights, int rank_of_rows) {
  static const double q[2] = {0.6, -0.75}, qd[2] = {1.1, 0.3};
  double qdd[2], Qc[2];
  pendulum_by_hand(q, qd, qdd, Qc);
  eom_options options = eom_options_default();
  options.weights = weights;
  eom_system *sys = start(&redundant, r, &options), *plain = start(&cartesian_pendulum, NULL, NULL);
  assert_int_equal(eom_linearise(sys, q, qd, 0), EOM_OK);
  assert_int_equal(sys->report.rank, rank_of_rows);
  assert_int_equal(sys->report.nrow, r->rows - rank_of_rows);
  assert_all_close(sys->qdd, qdd, 2, 0, SAME_MOTION * 10);
  assert_all_close(sys->Qc, Qc, 2, 0, SAME_MOTION * 10);
  assert_int_equal(eom_linearise(plain, q, qd, 0), EOM_OK);
  assert_all_close(sys->qdd_y, plain->qdd_y, 8, 0, SAME_MOTION * 100);
  /* the sum of what each row carries is the pull of the one constraint */
  double pull = 0;
  for (int i = 0; i < r->rows; i++) pull += r->factor[i] * sys->lambda[i];
  assert_close(pull, plain->lambda[0], SAME_MOTION, 0);
  eom_system_destroy(sys);
  eom_system_destroy(plain);
}

static void scaled_rows(void **state) {
  (void)state;
  for (double scale = 1e-8; scale < 2e8; scale *= 100) {
    const redundancy r = {.rows = 1, .factor = {scale}};
    check_redundant(&r, NULL, 1);
  }
}

static void repeated_rows(void **state) {
  (void)state;
  const double weights[3] = {1e8, 1e-8, 1};
  const redundancy same = {.rows = 3, .factor = {1, 1, 1}}, scaled = {.rows = 3, .factor = {1, 1e8, -1e-8}},
                   permuted = {.rows = 3, .factor = {-1e-8, 1, 1e8}};
  check_redundant(&same, NULL, 1);
  check_redundant(&scaled, NULL, 1);
  check_redundant(&permuted, NULL, 1);
  check_redundant(&same, weights, 1);
}

/* Of equal rows each carries the same share, whatever their scale: the multiplier of least norm. */
static void equal_shares(void **state) {
  (void)state;
  const redundancy r = {.rows = 3, .factor = {1, 1000, -10}};
  eom_system *sys = start(&redundant, &r, NULL);
  assert_int_equal(eom_acceleration(sys, (const double[]){0.6, -0.75}, (const double[]){1.1, 0.3}, 0), EOM_OK);
  assert_close(sys->lambda[1] * 1000, sys->lambda[0], 1e-13, 0);
  assert_close(sys->lambda[2] * -10, sys->lambda[0], 1e-13, 0);
  eom_system_destroy(sys);
}

/* Without force and with terms of b that cancel to rounding (x' = sqrt 2 y'), rounding is not taken for a contradiction. */
static void rounding_is_no_contradiction(void **state) {
  (void)state;
  eom_system *sys = start(&saddle, NULL, NULL);
  for (int k = 1; k < 50; k++) {
    const double v = 0.37 * k, q[2] = {0.9 * sqrt(2.0), 0.9}, qd[2] = {v * sqrt(2.0), v};
    assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
    assert_int_equal(sys->report.rank, 1);
    assert_true(fabs(sys->qdd[0]) <= 1e-14 * v * v);
  }
  eom_system_destroy(sys);
}

/* Equations set by hand, of two coordinates and one row. */
static eom_system *by_hand(const double *M, const double *A, const double *Q, double b, const eom_options *options) {
  eom_system *sys = start(&cartesian_pendulum, NULL, options);
  memcpy(sys->M, M, 4 * sizeof(double));
  memcpy(sys->A, A, 2 * sizeof(double));
  memcpy(sys->Q, Q, 2 * sizeof(double));
  sys->b[0] = b;
  return sys;
}

/* M may be indefinite where the constraint forbids to move: y'' = 3, x'' = 5, lambda = -1000 y'' - 7. */
static void indefinite_where_forbidden(void **state) {
  (void)state;
  eom_system *sys = by_hand((const double[]){1, 0, 0, -1000}, (const double[]){0, 1}, (const double[]){5, 7}, 3, NULL);
  assert_int_equal(eom_solve(sys), EOM_OK);
  assert_close(sys->qdd[0], 5, 1e-15, 0);
  assert_close(sys->qdd[1], 3, 1e-15, 0);
  assert_close(sys->lambda[0], -3007, 1e-12, 0);
  eom_system_destroy(sys);
}

/* Weights so large that they would bury M are cut: M = diag(2, 3), x'' + y'' = 1, so lambda = (1 - 5/2 - 7/3)/(1/2 + 1/3). */
static void weights_that_spoil(void **state) {
  (void)state;
  const double w = 1e30, lambda = (1 - 5 / 2.0 - 7 / 3.0) / (1 / 2.0 + 1 / 3.0);
  eom_options options = eom_options_default();
  options.weights = &w;
  eom_system *sys = by_hand((const double[]){2, 0, 0, 3}, (const double[]){1, 1}, (const double[]){5, 7}, 1, &options);
  assert_int_equal(eom_solve(sys), EOM_OK);
  assert_close(sys->lambda[0], lambda, 1e-14, 0);
  assert_close(sys->qdd[0], (5 + lambda) / 2, 1e-14, 0);
  assert_true(sys->report.pivot > 1e-4);
  eom_system_destroy(sys);
}

static void overflow_of_a_result(void **state) {
  (void)state;
  eom_system *sys = by_hand((const double[]){1e-200, 0, 0, 1}, (const double[]){0, 1}, (const double[]){1e200, 0}, 0, NULL);
  assert_int_equal(eom_solve(sys), EOM_NOT_FINITE);
  eom_system_destroy(sys);
  sys = by_hand((const double[]){1, 0, 0, 1e200}, (const double[]){0, 1}, (const double[]){1, 0}, 1e200, NULL);
  assert_int_equal(eom_solve(sys), EOM_NOT_FINITE);
  eom_system_destroy(sys);
}

static void overflow_without_constraints(void **state) {
  (void)state;
  eom_system *sys = start(&floating, NULL, NULL);
  memcpy(sys->M, (const double[]){1e-200, 0, 0, 1}, 4 * sizeof(double));
  memcpy(sys->Q, (const double[]){1e200, 0}, 2 * sizeof(double));
  assert_int_equal(eom_solve(sys), EOM_NOT_FINITE);
  assert_string_equal(sys->report.function, "acceleration");
  eom_system_destroy(sys);
}

/* Three rows a, b, a + b in the plane fix qdd; of all multipliers with A' lambda = M qdd - Q the one returned has the least
 * sum lambda_i^2 a_i M^-1 a_i', so it is orthogonal in that metric to (1, 1, -1), which A' takes to zero. */
static void sum_of_two_rows(void **state) {
  (void)state;
  const redundancy r = {.rows = 3, .factor = {1, 1, 1}};
  eom_system *sys = start(&redundant, &r, NULL);
  const double A[6] = {1, 2, 3, -1, 4, 1}, b[3] = {1, 10, 11}; /* x'' = 3, y'' = -1 */
  memcpy(sys->M, (const double[]){2, 0.5, 0.5, 1}, 4 * sizeof(double));
  memcpy(sys->Q, (const double[]){4, 7}, 2 * sizeof(double));
  memcpy(sys->A, A, sizeof A);
  memcpy(sys->b, b, sizeof b);
  assert_int_equal(eom_solve(sys), EOM_OK);
  assert_int_equal(sys->report.rank, 2);
  assert_close(sys->qdd[0], 3, 1e-14, 0);
  assert_close(sys->qdd[1], -1, 1e-14, 0);
  assert_close(sys->Qc[0], 2 * 3 - 0.5 - 4, 0, 1e-13);
  assert_close(sys->Qc[1], 0.5 * 3 - 1 - 7, 1e-14, 0);
  double along = 0;
  for (int i = 0; i < 3; i++) { /* M^-1 = [1 -0.5; -0.5 2]/1.75 */
    const double *a = A + 2 * i, length2 = (a[0] * a[0] - a[0] * a[1] + 2 * a[1] * a[1]) / 1.75;
    along += (i < 2 ? 1 : -1) * sys->lambda[i] * length2;
  }
  assert_close(along, 0, 0, 1e-13);
  sys->b[2] = 12;
  assert_int_equal(eom_solve(sys), EOM_INCONSISTENT);
  assert_int_equal(sys->report.nrow, 3);
  eom_system_destroy(sys);
}

/* More rows than a report has room for. */
static void many_dependent_rows(void **state) {
  (void)state;
  const redundancy r = {.rows = 12, .factor = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};
  eom_system *sys = start(&redundant, &r, NULL);
  assert_int_equal(eom_acceleration(sys, (const double[]){0.6, -0.75}, (const double[]){1.1, 0.3}, 0), EOM_OK);
  assert_int_equal(sys->report.nrow, 11);
  char text[2048];
  eom_report_text(&sys->report, text, sizeof text);
  assert_non_null(strstr(text, "and 3 more rows"));
  eom_system_destroy(sys);
}

static void contradiction_is_named(void **state) {
  (void)state;
  const redundancy r = {.rows = 3, .factor = {1, 2, 1}, .bend = {0, 0, 0.5}};
  eom_system *sys = start(&redundant, &r, NULL);
  assert_int_equal(eom_acceleration(sys, (const double[]){0.6, -0.75}, (const double[]){1.1, 0.3}, 1), EOM_INCONSISTENT);
  assert_int_equal(sys->report.rank, 1);
  char text[1024];
  eom_report_text(&sys->report, text, sizeof text);
  assert_non_null(strstr(text, "constraints contradict each other"));
  assert_non_null(strstr(text, "circles[2] (model.c:20): inconsistent with the others"));
  double y[4] = {0.6, -0.75, 1.1, 0.3}, ydot[4];
  assert_int_equal(eom_rhs(sys, 1, y, ydot), EOM_INCONSISTENT);
  eom_system_destroy(sys);
}

/* The same rows agree where the contradiction is below the tolerance, and the tolerance is the user's. */
static void consistency_tolerance(void **state) {
  (void)state;
  const redundancy r = {.rows = 2, .factor = {1, 1}, .bend = {0, 1e-5}};
  eom_options options = eom_options_default();
  for (int loose = 0; loose < 2; loose++) {
    options.consistency_tolerance = loose ? 1e-4 : 1e-8;
    eom_system *sys = start(&redundant, &r, &options);
    assert_int_equal(eom_acceleration(sys, (const double[]){0.6, -0.75}, (const double[]){1.1, 0.3}, 1),
                     loose ? EOM_OK : EOM_INCONSISTENT);
    eom_system_destroy(sys);
  }
}

/* With the hoop's plane through its axis the two constraints of a bead at (1,0,0) become parallel as the plane turns into the sphere's
 * tangent: rank is decided by the tolerance asked for. Rows (2,0,0) and (s,-c,0) at s = 1 - d^2/2, c = d. */
static void rank_tolerance(void **state) {
  (void)state;
  const double d = 1e-6, t = (acos(-1.0) / 2 - d) / 2;
  eom_options options = eom_options_default();
  for (int coarse = 0; coarse < 2; coarse++) {
    options.rank_tolerance = coarse ? 1e-4 : 1e-8;
    options.consistency_tolerance = 0.5;
    eom_system *sys = start(&rotating_hoop, NULL, &options);
    assert_int_equal(eom_acceleration(sys, (const double[]){1, 0, 0}, (const double[]){0, 0, 0}, t), EOM_OK);
    assert_int_equal(sys->report.rank, coarse ? 1 : 2);
    if (!coarse) assert_close(sys->report.condition, 1 / d, 0.01, 0);
    assert_int_equal(sys->row_kind[0] + sys->row_kind[1], coarse ? EOM_ROW_DEPENDENT : EOM_ROW_INDEPENDENT);
    eom_system_destroy(sys);
  }
}

static void coordinate_without_inertia(void **state) {
  (void)state;
  eom_system *sys = start(&floating, NULL, NULL);
  assert_int_equal(eom_acceleration(sys, (const double[]){0.6, -0.75}, (const double[]){1.1, 0.3}, 0), EOM_NO_INERTIA);
  assert_int_equal(sys->report.index, 1);
  char text[1024];
  eom_report_text(&sys->report, text, sizeof text);
  assert_non_null(strstr(text, "coordinate 1 "));
  eom_system_destroy(sys);

  /* the central field without its constraint: (r', u') = (-r, u) is a motion without inertia; in units of the root of each coordinate's
   * own inertia r moves most, then u_1 and u_2 */
  eom_model free_field = central_field;
  free_field.nholonomic = 0;
  sys = start(&free_field, NULL, NULL);
  const double q[4] = {3.9, 0.8, 0.6, 0}, qd[4] = {0.1, 0.2, 0.3, 0.4};
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_NO_INERTIA);
  assert_int_equal(sys->report.index, 0);
  eom_system_destroy(sys);
}

static void input_that_is_not_finite(void **state) {
  (void)state;
  eom_system *sys = start(&cartesian_pendulum, NULL, NULL);
  const double good[2] = {0.6, 0.8}, bad[2] = {0.6, nan("")}, big[2] = {HUGE_VAL, 0};
  char text[512];
  assert_int_equal(eom_acceleration(sys, bad, good, 0), EOM_NOT_FINITE);
  assert_int_equal(sys->report.index, 1);
  eom_report_text(&sys->report, text, sizeof text);
  assert_non_null(strstr(text, "argument q, number 1"));
  assert_int_equal(eom_acceleration(sys, good, big, 0), EOM_NOT_FINITE);
  assert_string_equal(sys->report.function, "argument qd");
  assert_int_equal(eom_energy(sys, good, good, nan("")), EOM_NOT_FINITE);
  assert_string_equal(sys->report.function, "argument t");
  const double huge[2] = {1e200, 1e200}; /* finite, but its square is not */
  assert_int_equal(eom_acceleration(sys, huge, good, 0), EOM_NOT_FINITE);
  assert_int_equal(eom_acceleration(sys, good, good, 0), EOM_OK);
  eom_system_destroy(sys);
}

/* What a caller puts into the parts of the equations. */
static void parts_that_are_not_finite(void **state) {
  (void)state;
  static const char *const names[] = {"mass matrix", "generalized force", "constraint matrix", "constraint vector b"};
  static const int index[] = {3, 1, 1, 0};
  for (int part = 0; part < 4; part++)
    for (int choice = EOM_LINALG_CORE; choice <= EOM_LINALG_LAPACK; choice++) {
      eom_options options = eom_options_default();
      options.linalg = (eom_linalg_choice)choice;
      eom_system *sys;
      if (eom_system_create(&sys, &cartesian_pendulum, NULL, &options) != EOM_OK) continue; /* a build without LAPACK */
      assert_int_equal(eom_assemble(sys, (const double[]){0.6, 0.8}, (const double[]){0.1, 0.2}, 0), EOM_OK);
      double *const parts[] = {sys->M, sys->Q, sys->A, sys->b};
      parts[part][index[part]] = choice == EOM_LINALG_CORE ? nan("") : HUGE_VAL;
      assert_int_equal(eom_solve(sys), EOM_NOT_FINITE);
      assert_string_equal(sys->report.function, names[part]);
      assert_int_equal(sys->report.index, index[part]);
      eom_system_destroy(sys);
    }
}

static void point_outside_the_domain(void **state) {
  (void)state;
  eom_system *sys = start(&central_field, NULL, NULL);
  assert_int_equal(eom_acceleration(sys, (const double[]){0, 1, 0, 0}, (const double[]){0, 0, 0, 0}, 0), EOM_DOMAIN);
  char text[512];
  eom_report_text(&sys->report, text, sizeof text);
  assert_non_null(strstr(text, "in lagrangian (model.c:1)"));
  assert_non_null(strstr(text, "in div"));
  eom_system_destroy(sys);
}

/* Random equations whose two rows differ by little: the error of qdd against quadruple precision may grow with the condition of the
 * rows, not with its square, over the root of the smallest pivot. Forming A M^-1 A' would lose sixteen digits at 1e8. Allowed: this
 * many epsilons times that; measured 0.9, and 1.8 where M is singular. */
#define CONDITION_FACTOR 20

static double ill_conditioned(rng *r, bool singular_mass) {
  eom_system *sys = start(&cartesian_double_pendulum, NULL, NULL);
  double y[4] = {0.6, 0.8, 1, 1}, truth[6], worst = 0;
  assert_int_equal(eom_assemble(sys, y, y, 0), EOM_OK);
  for (int k = 0; k < 200; k++) {
    const double apart = exp(log(10) * rng_uniform(r, -8, 0));
    double X[4][4];
    for (int i = 0; i < 16; i++) X[i / 4][i % 4] = i / 4 == 3 && singular_mass ? 0 : rng_uniform(r, -1, 1);
    for (int i = 0; i < 4; i++) {
      sys->Q[i] = rng_uniform(r, -1, 1);
      sys->A[i] = rng_uniform(r, -1, 1);
      sys->A[4 + i] = sys->A[i] + apart * rng_uniform(r, -1, 1);
      for (int j = 0; j < 4; j++) {
        sys->M[4 * i + j] = singular_mass || i != j ? 0 : 1;
        for (int l = 0; l < 4; l++) sys->M[4 * i + j] += X[l][i] * X[l][j];
      }
    }
    sys->b[0] = rng_uniform(r, -1, 1);
    sys->b[1] = rng_uniform(r, -1, 1);
    assert_int_equal(eom_solve(sys), EOM_OK);
    assert_int_equal(sys->report.rank, 2);
    kkt_truth(4, 2, sys->M, sys->A, sys->Q, sys->b, truth);
    double size = 0, error = 0;
    for (int i = 0; i < 4; i++) {
      size = fmax(size, fabs(truth[i]));
      error = fmax(error, fabs(sys->qdd[i] - truth[i]));
    }
    const double condition = sys->report.condition / sqrt(sys->report.pivot);
    worst = fmax(worst, error / size / (2.2e-16 * condition));
  }
  eom_system_destroy(sys);
  return worst;
}

static void ill_conditioned_rows(void **state) {
  (void)state;
  rng r = {77};
  const double regular = ill_conditioned(&r, false), singular = ill_conditioned(&r, true);
  print_message("worst error of qdd in epsilon times condition: %.2g, with singular M %.2g\n", regular, singular);
  assert_true(regular < CONDITION_FACTOR && singular < CONDITION_FACTOR);
}

/* Both implementations of the linear algebra give the same motion. */
static void same_motion_from_lapack(void **state) {
  (void)state;
  eom_options options = eom_options_default();
  options.linalg = EOM_LINALG_LAPACK;
  eom_system *lapack;
  const eom_status status = eom_system_create(&lapack, &cartesian_double_pendulum, NULL, &options);
  if (status == EOM_BAD_OPTION) skip();
  assert_int_equal(status, EOM_OK);
  options.linalg = EOM_LINALG_CORE;
  eom_system *core = start(&cartesian_double_pendulum, NULL, &options);
  rng r = {7};
  for (int k = 0; k < 20; k++) {
    double q[4], qd[4];
    for (int i = 0; i < 4; i++) {
      q[i] = rng_uniform(&r, -1, 1);
      qd[i] = rng_uniform(&r, -1, 1);
    }
    assert_int_equal(eom_linearise(lapack, q, qd, 0), EOM_OK);
    assert_int_equal(eom_linearise(core, q, qd, 0), EOM_OK);
    assert_all_close(lapack->qdd, core->qdd, 4, 1e-11, 1e-11);
    assert_all_close(lapack->qdd_y, core->qdd_y, 32, 1e-10, 1e-10);
  }
  eom_system_destroy(lapack);
  eom_system_destroy(core);
}

/* The equations of motion once more beside other right-hand sides: the same solution; the others satisfy their equations. */
static void more_right_hand_sides(void **state) {
  (void)state;
  enum { COLUMNS = 11 }; /* more than what is solved for together */
  rng r = {8};
  for (int i = 0; i < nconstrained_models; i++) {
    eom_system *sys = start(constrained_models[i], NULL, NULL);
    double q[4], qd[4], x[4 * COLUMNS], y[2 * COLUMNS], R[4 * COLUMNS], G[2 * COLUMNS], largest = 1;
    const int n = sys->n, m = sys->m;
    for (int j = 0; j < n; j++) q[j] = rng_uniform(&r, 0.4, 1.2), qd[j] = rng_uniform(&r, -1, 1);
    assert_int_equal(eom_assemble(sys, q, qd, 0.5), EOM_OK);
    assert_int_equal(eom_solve(sys), EOM_OK);
    for (int j = 0; j < n * COLUMNS; j++) x[j] = R[j] = j % COLUMNS ? rng_uniform(&r, -1, 1) : sys->Q[j / COLUMNS];
    for (int j = 0; j < m * COLUMNS; j++) y[j] = G[j] = j % COLUMNS ? rng_uniform(&r, -1, 1) : sys->b[j / COLUMNS];
    assert_int_equal(eom_solve_more(sys, COLUMNS, x, y), EOM_OK);
    for (int j = 0; j < n * COLUMNS; j++) largest = fmax(largest, fabs(x[j]));
    for (int j = 0; j < m * COLUMNS; j++) largest = fmax(largest, fabs(y[j]));
    for (int j = 0; j < n; j++) assert_close(x[j * COLUMNS], sys->qdd[j], 1e-13, 1e-13 * largest);
    for (int j = 0; j < m; j++) assert_close(y[j * COLUMNS], sys->lambda[j], 1e-13, 1e-13 * largest);
    for (int c = 0; c < COLUMNS; c++) {
      for (int j = 0; j < n; j++) {
        double left = 0, right = R[j * COLUMNS + c];
        for (int k = 0; k < n; k++) left += sys->M[j * n + k] * x[k * COLUMNS + c];
        for (int k = 0; k < m; k++) right += sys->A[k * n + j] * y[k * COLUMNS + c];
        assert_close(left, right, 0, 1e-13 * largest);
      }
      for (int j = 0; j < m; j++) {
        double left = 0;
        for (int k = 0; k < n; k++) left += sys->A[j * n + k] * x[k * COLUMNS + c];
        assert_close(left, G[j * COLUMNS + c], 0, 1e-13 * largest);
      }
    }
    x[n * COLUMNS - 1] = (double)INFINITY;
    assert_int_equal(eom_solve_more(sys, COLUMNS, x, y), EOM_NOT_FINITE);
    assert_string_equal(sys->report.function, "right-hand side");
    eom_system_destroy(sys);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(scaled_rows),
                                     cmocka_unit_test(repeated_rows),
                                     cmocka_unit_test(equal_shares),
                                     cmocka_unit_test(contradiction_is_named),
                                     cmocka_unit_test(rounding_is_no_contradiction),
                                     cmocka_unit_test(indefinite_where_forbidden),
                                     cmocka_unit_test(weights_that_spoil),
                                     cmocka_unit_test(overflow_of_a_result),
                                     cmocka_unit_test(many_dependent_rows),
                                     cmocka_unit_test(overflow_without_constraints),
                                     cmocka_unit_test(sum_of_two_rows),
                                     cmocka_unit_test(consistency_tolerance),
                                     cmocka_unit_test(rank_tolerance),
                                     cmocka_unit_test(coordinate_without_inertia),
                                     cmocka_unit_test(input_that_is_not_finite),
                                     cmocka_unit_test(parts_that_are_not_finite),
                                     cmocka_unit_test(point_outside_the_domain),
                                     cmocka_unit_test(ill_conditioned_rows),
                                     cmocka_unit_test(more_right_hand_sides),
                                     cmocka_unit_test(same_motion_from_lapack)};
  return cmocka_run_group_tests_name("solve", tests, NULL, NULL);
}
