/* Constrained accelerations, multipliers and their derivatives against 40-digit references, for automatic and for any given weights,
 * without and with Baumgarte's terms. */
#include "close.h"
#include "constrained_models.h"
#include "data.h"

#include "eom/eom.h"

#include <math.h>
#include <string.h>

/* Errors in parts of the largest number of a result. Measured: below 1e-15 for every model and weight; these states are well
 * conditioned, so a bound of ten times that leaves room for another compiler only. */
#define MOTION_TOLERANCE 1e-14
#define DERIVATIVE_TOLERANCE 1e-14

typedef struct reference {
  const eom_model *model;
  int n, m;
  const double *q, *qd, *qdd, *lambda, *qdd_y, *lambda_y;
  double t;
} reference;

static const eom_model *model_named(const char *name) {
  for (int i = 0; i < nconstrained_models; i++)
    if (strcmp(constrained_models[i]->name, name) == 0) return constrained_models[i];
  fail_msg("no model %s", name);
  return NULL;
}

static reference reference_of(const data_line *line) {
  const int n = (int)line->number[0], m = (int)line->number[1];
  reference r = {.model = model_named(line->name), .n = n, .m = m, .t = line->number[2], .q = line->number + 3};
  r.qd = r.q + n;
  r.qdd = r.qd + n;
  r.lambda = r.qdd + n;
  r.qdd_y = r.lambda + m;
  r.lambda_y = r.qdd_y + 2 * n * n;
  assert_ptr_equal(r.lambda_y + 2 * n * m, line->number + line->count);
  return r;
}

/* The worst error in parts of the largest number of the truth, but at least 1: the size of states and constants here, for results that
 * are zero. */
static double error_of(const char *what, const reference *r, const double *actual, const double *truth, int count, double tolerance) {
  double size = 1, worst = 0;
  for (int i = 0; i < count; i++) size = fmax(size, fabs(truth[i]));
  for (int i = 0; i < count; i++) {
    assert_close_case(actual[i], truth[i], tolerance * size, __FILE__, __LINE__, "%s of %s, number %d", what, r->model->name, i);
    worst = fmax(worst, fabs(actual[i] - truth[i]) / size);
  }
  return worst;
}

/* Linearises at the reference's state with weights w (0: automatic) and returns the worst errors in error[4]. */
static void check(const reference *r, double w, eom_baumgarte gains, double *error) {
  double weights[8];
  for (int i = 0; i < 8; i++) weights[i] = w;
  eom_options options = eom_options_default();
  if (w > 0) options.weights = weights;
  options.baumgarte = gains;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, r->model, NULL, &options), EOM_OK);
  assert_int_equal(sys->n, r->n);
  assert_int_equal(sys->m, r->m);
  assert_int_equal(eom_linearise(sys, r->q, r->qd, r->t), EOM_OK);
  assert_int_equal(sys->report.rank, r->m);
  if (w > 0) assert_true(sys->report.weighted);
  const int n = r->n, m = r->m;
  error[0] = fmax(error[0], error_of("qdd", r, sys->qdd, r->qdd, n, MOTION_TOLERANCE));
  error[1] = fmax(error[1], error_of("lambda", r, sys->lambda, r->lambda, m, MOTION_TOLERANCE));
  error[2] = fmax(error[2], error_of("dqdd/dy", r, sys->qdd_y, r->qdd_y, 2 * n * n, DERIVATIVE_TOLERANCE));
  error[3] = fmax(error[3], error_of("dlambda/dy", r, sys->lambda_y, r->lambda_y, 2 * n * m, DERIVATIVE_TOLERANCE));
  eom_system_destroy(sys);
}

static void agree(const char *data, eom_baumgarte gains, const double *weights, int count) {
  FILE *file = data_open(data);
  data_line line;
  int lines = 0;
  double error[4] = {0};
  const char *last = "";
  while (data_next(file, &line)) {
    const reference r = reference_of(&line);
    if (lines++ % 4 == 0) memset(error, 0, sizeof error);
    for (int i = 0; i < count; i++) check(&r, weights[i], gains, error);
    last = r.model->name;
    if (lines % 4 == 0)
      print_message("%-26s qdd %.1e  lambda %.1e  dqdd/dy %.1e  dlambda/dy %.1e\n", last, error[0], error[1], error[2], error[3]);
  }
  fclose(file);
  assert_int_equal(lines, 4 * nconstrained_models);
}

static void automatic_weights(void **state) {
  (void)state;
  agree("constrained_motion.txt", (eom_baumgarte){0, 0}, (const double[]){0}, 1);
}

static void any_weights(void **state) {
  (void)state;
  agree("constrained_motion.txt", (eom_baumgarte){0, 0}, (const double[]){1e-8, 1e-4, 1, 1e4, 1e8}, 5);
}

/* At states far from the constraints, where the terms are as large as the rest. */
static void stabilised(void **state) {
  (void)state;
  agree("stabilised_motion.txt", (eom_baumgarte){3, 5}, (const double[]){0, 1e-4, 1e4}, 3);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(automatic_weights), cmocka_unit_test(any_weights), cmocka_unit_test(stabilised)};
  return cmocka_run_group_tests_name("constrained", tests, NULL, NULL);
}
