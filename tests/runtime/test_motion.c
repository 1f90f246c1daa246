/* Systems with motion functions: the same numbers and the same verdicts as by calls, for whatever part of the needs they serve. */
#include "close.h"
#include "constrained_models.h"
#include "echo_motion.h"
#include "pendulum_motion.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Two ways to the same numbers, in parts of the largest of them: some ten roundings times the condition of M, which is below 100.
 * Measured: 4e-15. */
#define SAME_NUMBERS 1e-13

enum { MOST = 4, LINKS = 3 };

static eom_system *start(const eom_model *model, const void *params, unsigned needs, eom_emitter emitter) {
  eom_options options = eom_options_default();
  options.needs = needs;
  options.emitter = emitter;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, model, params, &options), EOM_OK);
  return sys;
}

static eom_status creation(const eom_model *model, const void *params, unsigned needs, eom_emitter emitter) {
  eom_options options = eom_options_default();
  options.needs = needs;
  options.emitter = emitter;
  eom_system *sys;
  const eom_status status = eom_system_create(&sys, model, params, &options);
  eom_system_destroy(sys);
  return status;
}

static void same(const double *actual, const double *expected, int count) {
  double size = 0;
  for (int i = 0; i < count; i++) size = fmax(size, fabs(expected[i]));
  assert_all_close(actual, expected, count, 0, SAME_NUMBERS * fmax(size, 1));
}

static void random_state(rng *r, int n, double *q, double *qd) {
  for (int i = 0; i < n; i++) {
    q[i] = rng_uniform(r, 0.2, 0.9);
    qd[i] = rng_uniform(r, -0.8, 0.8);
  }
}

/* ---- both emitters ---- */

static void compare_assembled(eom_system *a, eom_system *b, const double *q, const double *qd, double t) {
  const int n = a->n, m = a->m;
  assert_int_equal(eom_energy(a, q, qd, t), EOM_OK);
  assert_int_equal(eom_energy(b, q, qd, t), EOM_OK);
  same(&a->energy, &b->energy, 1);
  same(a->momentum_rate, b->momentum_rate, n);
  a->energy = a->momentum_rate[0] = 0;
  assert_int_equal(eom_assemble(a, q, qd, t), EOM_OK);
  assert_int_equal(eom_assemble(b, q, qd, t), EOM_OK);
  same(a->momentum, b->momentum, n);
  same(a->momentum_rate, b->momentum_rate, n);
  same(&a->lagrangian, &b->lagrangian, 1);
  same(&a->energy, &b->energy, 1);
  same(a->M, b->M, n * n);
  same(a->Q, b->Q, n);
  same(a->A, b->A, m * n);
  same(a->b, b->b, m);
  same(a->phi, b->phi, a->m1);
  same(a->phi_dot, b->phi_dot, a->m1);
  same(a->psi, b->psi, a->m2);
}

static void compare_solved(eom_system *a, eom_system *b, const double *q, const double *qd, double t) {
  const int n = a->n, m = a->m;
  assert_int_equal(eom_acceleration(a, q, qd, t), EOM_OK);
  assert_int_equal(eom_acceleration(b, q, qd, t), EOM_OK);
  same(a->qdd, b->qdd, n);
  same(a->lambda, b->lambda, m);
  same(a->Qc, b->Qc, n);
  assert_int_equal(a->report.rank, b->report.rank);
  a->qdd[0] = 0;
  assert_int_equal(eom_linearise(a, q, qd, t), EOM_OK);
  assert_int_equal(eom_linearise(b, q, qd, t), EOM_OK);
  same(a->qdd, b->qdd, n);
  same(a->qdd_y, b->qdd_y, 2 * n * n);
  same(a->lambda_y, b->lambda_y, 2 * m * n);
}

static void compare_directions(eom_system *a, eom_system *b, rng *r, const double *q, const double *qd, double t) {
  enum { K = 2 };
  const int n = a->n, m = a->m;
  double qdd[MOST] = {0}, one[MOST], other[MOST], w[2 * MOST * K] = {0}, dqdd[2][MOST * K], dlambda[2][MOST * K];
  for (int i = 0; i < n; i++) qdd[i] = rng_uniform(r, -3, 3);
  for (int i = 0; i < 2 * n * K; i++) w[i] = rng_uniform(r, -1, 1);
  assert_int_equal(eom_residual(a, one, qdd, q, qd, t), EOM_OK);
  assert_int_equal(eom_residual(b, other, qdd, q, qd, t), EOM_OK);
  same(one, other, n);
  assert_int_equal(eom_tangent(a, dqdd[0], dlambda[0], K, w, q, qd, t), EOM_OK);
  assert_int_equal(eom_tangent(b, dqdd[1], dlambda[1], K, w, q, qd, t), EOM_OK);
  same(a->qdd, b->qdd, n);
  same(dqdd[0], dqdd[1], n * K);
  same(dlambda[0], dlambda[1], m * K);
}

/* Each task at random states, by the motion functions of a model and by its calls. */
static void compare(const eom_model *model, const void *params) {
  const unsigned needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT;
  eom_system *a = start(model, params, needs, EOM_EMITTER_MOTION), *b = start(model, params, needs, EOM_EMITTER_CALLS);
  rng r = {1};
  for (int k = 0; k < 20; k++) {
    double q[MOST], qd[MOST];
    random_state(&r, a->n, q, qd);
    compare_assembled(a, b, q, qd, 0.1 * k);
    compare_solved(a, b, q, qd, 0.1 * k);
    compare_directions(a, b, &r, q, qd, 0.1 * k);
  }
  eom_system_destroy(a);
  eom_system_destroy(b);
}

static void pendulums_agree(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  const pendulum one = {1, 9.81}, three = {LINKS, 9.81};
  compare(&model, &one);
  compare(&model, &three);
}

/* Without solved forms the runtime solves. */
static void unsolved_forms_agree(void **state) {
  (void)state;
  eom_motion unsolved = pendulum_motion_3;
  unsolved.acceleration = NULL;
  unsolved.jacobian = NULL;
  unsolved.directional = NULL;
  const eom_motion *const list[] = {&unsolved};
  eom_model model = pendulum_model;
  model.motion = list;
  model.nmotion = 1;
  const pendulum p = {LINKS, 9.81};
  compare(&model, &p);
}

static void constrained_models_agree(void **state) {
  (void)state;
  for (int i = 0; i < nconstrained_models; i++) {
    echo e;
    echo_start(&e, constrained_models[i], NULL);
    compare(&e.model, NULL);
    echo_end(&e);
  }
}

/* qdd is linear in g, so that d qdd/dg is the difference of accelerations at g = 1 and g = 0. */
static void parameter_derivative(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  pendulum p = {LINKS, 9.81};
  eom_system *sys = start(&model, &p, EOM_NEED_PARAMETERS, EOM_EMITTER_AUTO);
  const double q[LINKS] = {0.3, -0.5, 1.2}, qd[LINKS] = {1, 0.5, -2};
  double by_g[LINKS], difference[LINKS];
  assert_int_equal(sys->motion->np, 1);
  assert_string_equal(sys->motion->parameter[0], "p->g");
  assert_int_equal(eom_parameter_derivatives(sys, by_g, NULL, q, qd, 0), EOM_OK);
  p.g = 1;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  memcpy(difference, sys->qdd, sizeof difference);
  p.g = 0;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  for (int i = 0; i < LINKS; i++) difference[i] -= sys->qdd[i];
  same(by_g, difference, LINKS);
  eom_system_destroy(sys);
}

static void integrals_agree(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  const pendulum p = {LINKS, 9.81};
  const double y[2 * LINKS] = {1, 0.5};
  double rho[2][2 * LINKS], energy[2];
  for (int k = 0; k < 2; k++) {
    eom_system *sys = start(&model, &p, EOM_NEED_LINEARISE, k == 0 ? EOM_EMITTER_MOTION : EOM_EMITTER_CALLS);
    eom_lyapunov_options options = eom_lyapunov_options_default();
    options.method = &eom_dp5;
    options.interval = options.h = 0.01;
    eom_lyapunov *ly;
    assert_int_equal(eom_lyapunov_create(&ly, sys, &options, 0, y), EOM_OK);
    for (int i = 0; i < 50; i++) assert_int_equal(eom_lyapunov_step(ly), EOM_OK);
    memcpy(rho[k], ly->rho, sizeof rho[k]);
    energy[k] = ly->energy;
    eom_lyapunov_destroy(ly);
    eom_system_destroy(sys);
  }
  same(rho[0], rho[1], 2 * LINKS);
  same(&energy[0], &energy[1], 1);
}

/* ---- the choice ---- */

static void assert_emitters(const eom_system *sys, const eom_emitter *expected) {
  for (int task = 0; task < EOM_TASK_COUNT; task++) assert_int_equal(eom_system_emitter(sys, (eom_task)task), expected[task]);
}

#define NONE EOM_EMITTER_AUTO
#define CALLS EOM_EMITTER_CALLS
#define MOTION EOM_EMITTER_MOTION

static void chosen_by_size(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  const pendulum two = {2, 9.81}, three = {LINKS, 9.81};
  const eom_emitter calls[] = {CALLS, CALLS, CALLS, NONE, NONE, NONE}, motion[] = {MOTION, MOTION, MOTION, NONE, NONE, NONE};
  eom_system *sys = start(&model, &two, EOM_NEED_LINEARISE, EOM_EMITTER_AUTO);
  assert_emitters(sys, calls);
  assert_null(sys->motion);
  eom_system_destroy(sys);
  sys = start(&model, &three, EOM_NEED_LINEARISE, EOM_EMITTER_AUTO);
  assert_emitters(sys, motion);
  assert_ptr_equal(sys->motion, &pendulum_motion_3);
  eom_system_destroy(sys);
  sys = start(&model, &three, EOM_NEED_LINEARISE, EOM_EMITTER_CALLS);
  assert_emitters(sys, calls);
  assert_null(sys->motion);
  eom_system_destroy(sys);
  assert_int_equal(creation(&model, &two, EOM_NEED_LINEARISE, EOM_EMITTER_MOTION), EOM_BAD_OPTION);
  assert_int_equal(creation(&model, &two, EOM_NEED_PARAMETERS, EOM_EMITTER_AUTO), EOM_BAD_OPTION);
  assert_int_equal(creation(&model, &three, EOM_NEED_PARAMETERS, EOM_EMITTER_CALLS), EOM_BAD_OPTION);
  assert_int_equal(creation(&model, &three, EOM_NEED_ALL, EOM_EMITTER_MOTION), EOM_OK);
  assert_int_equal(creation(&model, &three, EOM_NEED_ALL, (eom_emitter)9), EOM_BAD_OPTION);
}

/* Where the motion functions serve some needs, calls serve the rest, with the same numbers. */
static void missing_functions(void **state) {
  (void)state;
  echo e;
  echo_start(&e, &mixed, NULL);
  const unsigned needs = EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT;
  const double q[3] = {0.3, 0.4, 0.1}, qd[3] = {0.1, 0.2, 0.3};
  eom_system *calls = start(&e.model, NULL, needs, EOM_EMITTER_CALLS);
  const eom_motion all = e.motion;
  for (int missing = 0; missing < EOM_TASK_PARAMETERS; missing++) {
    e.motion = all;
    if (missing == EOM_TASK_ENERGY) e.motion.energy = NULL;
    if (missing == EOM_TASK_ASSEMBLE) e.motion.simulate = NULL;
    if (missing == EOM_TASK_LINEARISE) e.motion.linearise = NULL;
    if (missing == EOM_TASK_RESIDUAL) e.motion.residual = NULL;
    if (missing == EOM_TASK_TANGENT) e.motion.tangent = NULL;
    assert_int_equal(creation(&e.model, NULL, needs, EOM_EMITTER_MOTION), EOM_BAD_OPTION);
    eom_system *sys = start(&e.model, NULL, needs, EOM_EMITTER_AUTO);
    eom_emitter expected[] = {MOTION, MOTION, MOTION, MOTION, MOTION, NONE};
    expected[missing] = CALLS;
    assert_emitters(sys, expected);
    rng r = {3};
    compare_assembled(sys, calls, q, qd, 0.5);
    compare_solved(sys, calls, q, qd, 0.5);
    compare_directions(sys, calls, &r, q, qd, 0.5);
    eom_system_destroy(sys);
  }
  eom_system_destroy(calls);
  echo_end(&e);
}

/* Jets that no evaluation needs take no memory, and what is asked for is enough at any alignment (the sanitizer watches the ends). */
static void memory(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  const pendulum p = {LINKS, 9.81};
  eom_options calls = eom_options_default();
  calls.emitter = EOM_EMITTER_CALLS;
  const size_t with_jets = eom_system_bytes(&model, &p, &calls), bytes = eom_system_bytes(&model, &p, NULL);
  print_message("three links: %zu bytes by calls, %zu by motion functions\n", with_jets, bytes);
  assert_true(bytes * 2 < with_jets);
  echo e;
  echo_start(&e, &mixed, NULL);
  eom_options all = eom_options_default();
  all.needs = EOM_NEED_ALL & ~EOM_NEED_PARAMETERS;
  const double q[3] = {0.3, 0.4, 0.1}, qd[3] = {0.1, 0.2, 0.3}, w[6] = {1};
  double dqdd[3], dlambda[2];
  const size_t need = eom_system_bytes(&e.model, NULL, &all);
  for (size_t shift = 0; shift < 64; shift += 9) {
    char *block = malloc(need + shift);
    memset(block, 0xff, need + shift);
    eom_system sys;
    assert_int_equal(eom_system_init(&sys, &e.model, NULL, &all, block + shift, need), EOM_OK);
    assert_int_equal(eom_assemble(&sys, q, qd, 0), EOM_OK);
    assert_int_equal(eom_linearise(&sys, q, qd, 0), EOM_OK);
    assert_int_equal(eom_tangent(&sys, dqdd, dlambda, 1, w, q, qd, 0), EOM_OK);
    assert_int_equal(eom_residual(&sys, dqdd, q, q, qd, 0), EOM_OK);
    free(block);
  }
  echo_end(&e);
}

/* ---- failures ---- */

static void assert_text(const eom_system *sys, const char *expected) {
  char text[400];
  eom_report_text(&sys->report, text, sizeof text);
  assert_string_equal(text, expected);
}

/* Each evaluation hands on a refusal that jets do not see: the place is the motion function's. */
static void refusals(void **state) {
  (void)state;
  echo e;
  echo_start(&e, &mixed, NULL);
  eom_system *sys = start(&e.model, NULL, EOM_NEED_LINEARISE | EOM_NEED_RESIDUAL | EOM_NEED_TANGENT, EOM_EMITTER_MOTION);
  const double q[3] = {0.3, 0.4, 0.1}, qd[3] = {0.1, 0.2, 0.3}, w[6] = {1};
  double dqdd[3], dlambda[2];
  static const struct {
    int code;
    eom_status status;
  } all[] = {{1, EOM_DOMAIN}, {EOM_MOTION_NOT_FINITE, EOM_NOT_FINITE}, {EOM_MOTION_SIZE, EOM_SIZES_CHANGED}};
  for (size_t k = 0; k < sizeof all / sizeof all[0]; k++) {
    e.refusal = all[k].code;
    assert_int_equal(eom_energy(sys, q, qd, 0), all[k].status);
    assert_int_equal(eom_assemble(sys, q, qd, 0), all[k].status);
    assert_int_equal(eom_acceleration(sys, q, qd, 0), all[k].status);
    assert_int_equal(eom_linearise(sys, q, qd, 0), all[k].status);
    assert_int_equal(eom_residual(sys, dqdd, q, q, qd, 0), all[k].status);
    assert_int_equal(eom_tangent(sys, dqdd, dlambda, 1, w, q, qd, 0), all[k].status);
    assert_string_equal(sys->report.function, "mixed");
  }
  e.refusal = 1;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_DOMAIN);
  assert_text(sys, "a model function does not exist, or has no derivative, at this state\n  in mixed\n"
                   "  no value or no derivative in fabs, line 7 of model.c\n");
  e.refusal = 0;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  eom_system_destroy(sys);
  echo_end(&e);
}

/* A failure that jets see is reported as by calls: the model's function, its source, the elementary function. */
static void located_as_by_calls(void **state) {
  (void)state;
  echo e;
  echo_start(&e, &central_field, NULL);
  const double q[4] = {0, 1, 0, 0}, qd[4] = {0};
  eom_system *a = start(&e.model, NULL, EOM_NEED_LINEARISE, EOM_EMITTER_MOTION);
  eom_system *b = start(&e.model, NULL, EOM_NEED_LINEARISE, EOM_EMITTER_CALLS);
  assert_int_equal(eom_linearise(a, q, qd, 0), EOM_DOMAIN);
  assert_int_equal(eom_linearise(b, q, qd, 0), EOM_DOMAIN);
  char text[400];
  eom_report_text(&b->report, text, sizeof text);
  assert_text(a, text);
  const double no_number[4] = {nan(""), 1, 0, 0};
  assert_int_equal(eom_energy(a, no_number, qd, 0), EOM_NOT_FINITE);
  assert_string_equal(a->report.function, "argument q");
  eom_system_destroy(a);
  eom_system_destroy(b);
  echo_end(&e);
}

/* The parameters may change, their sizes may not. */
static void changed_size(void **state) {
  (void)state;
  const eom_model model = pendulum_with_motion();
  pendulum p = {LINKS, 9.81};
  eom_system *sys = start(&model, &p, EOM_NEED_SIMULATE, EOM_EMITTER_AUTO);
  const double q[LINKS] = {0.3, -0.5, 1.2}, qd[LINKS] = {1, 0.5, -2};
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  const double before = sys->qdd[0];
  p.g = 1.62;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
  assert_true(fabs(sys->qdd[0] - before) > 1);
  p.n = 2;
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_SIZES_CHANGED);
  assert_text(sys, "the parameters no longer have the sizes that the system was started with\n  in pendulum\n");
  eom_system_destroy(sys);
}

static int no_pivot_acceleration(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *qdd, tl_real *work) {
  (void)params, (void)q, (void)qd, (void)t, (void)qdd, (void)work;
  return EOM_MOTION_PIVOT;
}
static int no_pivot_jacobian(const void *params, const tl_real *q, const tl_real *qd, tl_real t, tl_real *qdd, tl_real *qdd_y,
                             tl_real *work) {
  (void)qdd_y;
  return no_pivot_acceleration(params, q, qd, t, qdd, work);
}
static int no_pivot_directional(const void *params, const tl_real *q, const tl_real *qd, tl_real t, int k, const tl_real *w,
                                tl_real *qdd, tl_real *dqdd, tl_real *work) {
  (void)k, (void)w, (void)dqdd;
  return no_pivot_acceleration(params, q, qd, t, qdd, work);
}

/* Solved forms that find no safe pivot leave it to the general solver: it finds the solution, or the coordinate without inertia. */
static void unsafe_pivots(void **state) {
  (void)state;
  eom_motion careful = pendulum_motion_3;
  careful.acceleration = no_pivot_acceleration;
  careful.jacobian = no_pivot_jacobian;
  careful.directional = no_pivot_directional;
  const eom_motion *const list[] = {&careful};
  eom_model model = pendulum_model;
  model.motion = list;
  model.nmotion = 1;
  const pendulum p = {LINKS, 9.81};
  compare(&model, &p);

  echo e;
  echo_start(&e, &floating, NULL);
  e.motion.acceleration = no_pivot_acceleration;
  e.motion.jacobian = no_pivot_jacobian;
  eom_system *a = start(&e.model, NULL, EOM_NEED_LINEARISE, EOM_EMITTER_MOTION);
  const double q[2] = {0.1, 0.2}, qd[2] = {0};
  assert_int_equal(eom_acceleration(a, q, qd, 0), EOM_NO_INERTIA);
  assert_int_equal(a->report.index, 1);
  assert_int_equal(eom_linearise(a, q, qd, 0), EOM_NO_INERTIA);
  assert_int_equal(a->report.index, 1);
  eom_system_destroy(a);
  echo_end(&e);
}

/* ---- dependent rows ---- */

/* Without force and with terms of b that cancel to rounding: what motion functions do not say about b must not turn rounding into a
 * contradiction, nor hide one. */
static void dependent_rows(void **state) {
  (void)state;
  echo e;
  echo_start(&e, &saddle, NULL);
  eom_system *sys = start(&e.model, NULL, EOM_NEED_LINEARISE, EOM_EMITTER_MOTION);
  for (int k = 1; k < 50; k++) {
    const double v = 0.37 * k, q[2] = {0.9 * sqrt(2.0), 0.9}, qd[2] = {v * sqrt(2.0), v};
    assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_OK);
    assert_int_equal(sys->report.rank, 1);
    assert_int_equal(eom_assemble(sys, q, qd, 0), EOM_OK);
    assert_int_equal(eom_solve(sys), EOM_OK);
  }
  eom_system_destroy(sys);
  echo_end(&e);

  const redundancy r = {.rows = 2, .factor = {1, 1}, .bend = {0, 1}};
  const double q[2] = {0.6, -0.75}, qd[2] = {1.1, 0.3};
  echo_start(&e, &redundant, &r);
  sys = start(&e.model, &r, EOM_NEED_LINEARISE, EOM_EMITTER_MOTION);
  assert_int_equal(eom_acceleration(sys, q, qd, 0), EOM_INCONSISTENT);
  assert_int_equal(sys->report.nrow, 2);
  eom_system_destroy(sys);
  echo_end(&e);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(pendulums_agree),
                                     cmocka_unit_test(unsolved_forms_agree),
                                     cmocka_unit_test(constrained_models_agree),
                                     cmocka_unit_test(parameter_derivative),
                                     cmocka_unit_test(integrals_agree),
                                     cmocka_unit_test(chosen_by_size),
                                     cmocka_unit_test(missing_functions),
                                     cmocka_unit_test(memory),
                                     cmocka_unit_test(refusals),
                                     cmocka_unit_test(located_as_by_calls),
                                     cmocka_unit_test(changed_size),
                                     cmocka_unit_test(unsafe_pivots),
                                     cmocka_unit_test(dependent_rows)};
  return cmocka_run_group_tests_name("motion", tests, NULL, NULL);
}
