/* Sensitivities against derivatives of whole motions in 40 digits; tolerances of their own; constraints; times of events. */
#include "close.h"
#include "constrained_models.h"
#include "data.h"
#include "sensitive_models.h"

#include "chain_tl.h"
#include "planet_tl.h"
#include "rod_tl.h"
#include "spring_pendulum_tl.h"

#include "eom/eom.h"
#ifdef WITH_TRAJECTORIES
#include "eom/trajectory.h"
#endif

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A line of tests/data/sensitivity.txt. */
typedef struct motion {
  const eom_model *model;
  int n, k, np, directions;
  double t;
  double params[8], y0[8], S0[80], y[8], S[80];
} motion;

static const eom_model *model_of(const char *name) {
  static const struct {
    const char *name;
    const eom_model *model;
  } models[] = {{"chain", &chain_model}, {"planet", &planet_model}, {"spring", &spring_pendulum_model}, {"rod", &rod_model}};
  for (size_t i = 0; i < sizeof models / sizeof models[0]; i++)
    if (strcmp(models[i].name, name) == 0) return models[i].model;
  fail_msg("no model %s", name);
  return NULL;
}

static const double *take(double *to, const double *from, int count) {
  memcpy(to, from, (size_t)count * sizeof *to);
  return from + count;
}

static int read_motion(FILE *file, motion *m) {
  data_line line;
  if (!data_next(file, &line)) return 0;
  const double *x = line.number + 4;
  m->model = model_of(line.name);
  m->n = (int)line.number[0], m->k = (int)line.number[1], m->np = (int)line.number[2], m->t = line.number[3];
  m->directions = m->k - m->np;
  x = take(m->params, x, m->np);
  x = take(m->y0, x, 2 * m->n);
  x = take(m->S0, x, 2 * m->n * m->k);
  x = take(m->y, x, 2 * m->n);
  x = take(m->S, x, 2 * m->n * m->k);
  assert_int_equal(x - line.number, line.count);
  return 1;
}

static void find_motion(const eom_model *model, motion *m) {
  FILE *file = data_open("sensitivity.txt");
  do assert_true(read_motion(file, m));
  while (m->model != model);
  fclose(file);
}

/* A motion with its first k columns, being integrated. */
typedef struct run {
  eom_system *sys;
  eom_sensitivity s;
  eom_integrator it;
  double *work, *columns;
} run;

static void start(run *r, const motion *m, eom_emitter emitter, unsigned needs, int parameters, const eom_method *method, double h) {
  eom_options options = eom_options_default();
  options.emitter = emitter;
  options.needs = needs;
  assert_int_equal(eom_system_create(&r->sys, m->model, m->params, &options), EOM_OK);
  r->columns = malloc(eom_sensitivity_size(r->sys, m->directions, parameters) * sizeof *r->columns);
  assert_int_equal(eom_sensitivity_init(&r->s, r->sys, m->directions, parameters, NULL, r->columns), EOM_OK);
  double z[128];
  const int d = 2 * m->n, k = r->s.k;
  assert_int_equal(r->s.dim, d * (1 + k));
  memcpy(z, m->y0, (size_t)d * sizeof *z);
  for (int i = 0; i < d; i++) memcpy(z + d + i * k, m->S0 + i * m->k, (size_t)k * sizeof *z);
  r->work = malloc(eom_integrator_size(method, r->s.dim) * sizeof *r->work);
  eom_integrator_init(&r->it, method, eom_sensitivity_rhs, &r->s, r->s.dim, 0, z, h, r->work);
}

static void finish(run *r) {
  eom_system_destroy(r->sys);
  free(r->work);
  free(r->columns);
}

/* The largest difference of a column from the reference, in parts of the column's largest number. */
static double error_of(const run *r, const motion *m) {
  const int d = 2 * m->n, k = r->s.k;
  double worst = 0;
  for (int j = 0; j < k; j++) {
    double difference = 0, size = 0;
    for (int i = 0; i < d; i++) {
      difference = fmax(difference, fabs(r->it.y[d + i * k + j] - m->S[i * m->k + j]));
      size = fmax(size, fabs(m->S[i * m->k + j]));
    }
    worst = fmax(worst, size > 0 ? difference / size : difference);
  }
  return worst;
}

/* What is asked of sensitivities at a tolerance of 1e-12. Measured: 1e-11 at most, 2e-10 where steps are those of y alone. */
#define RELATIVE 1e-9

static double error_at(const motion *m, eom_emitter emitter, unsigned needs, int parameters, int included) {
  run r;
  start(&r, m, emitter, needs, parameters, &eom_dop853, 0);
  const eom_step_control control = {.rtol = 1e-12, .atol = 1e-12, .tested = included ? 0 : 2 * m->n};
  assert_int_equal(eom_integrator_control(&r.it, &control), EOM_OK);
  assert_int_equal(eom_integrate(&r.it, m->t, NULL, NULL), EOM_OK);
  const double error = error_of(&r, m);
  print_message("%-16s %s, %2d columns%s: %.1e in %ld steps\n", m->model->name, emitter == EOM_EMITTER_CALLS ? "calls " : "motion",
                r.s.k, included ? "" : ", steps by y", error, r.it.steps);
  finish(&r);
  return error;
}

static void motions_match_the_reference(void **state) {
  (void)state;
  FILE *file = data_open("sensitivity.txt");
  motion m;
  int motions = 0;
  const unsigned by_factors = EOM_NEED_TANGENT | EOM_NEED_PARAMETERS;
  for (; read_motion(file, &m); motions++)
    for (int included = 0; included < 2; included++) {
      assert_true(error_at(&m, EOM_EMITTER_MOTION, by_factors, m.np, included) <= RELATIVE);
      assert_true(error_at(&m, EOM_EMITTER_MOTION, by_factors | EOM_NEED_LINEARISE, m.np, included) <= RELATIVE);
      assert_true(error_at(&m, EOM_EMITTER_MOTION, EOM_NEED_TANGENT, 0, included) <= RELATIVE);
      assert_true(error_at(&m, EOM_EMITTER_MOTION, EOM_NEED_LINEARISE, 0, included) <= RELATIVE);
      assert_true(error_at(&m, EOM_EMITTER_CALLS, EOM_NEED_LINEARISE, 0, included) <= RELATIVE);
    }
  fclose(file);
  assert_int_equal(motions, 4);
}

/* Fixed steps: columns have the order of the method. Measured: 32.8 for 2^5. */
static void columns_have_the_order_of_the_method(void **state) {
  (void)state;
  motion m;
  find_motion(&chain_model, &m);
  double error[2];
  for (int i = 0; i < 2; i++) {
    run r;
    start(&r, &m, EOM_EMITTER_AUTO, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS, m.np, &eom_dp5, m.t / (i ? 2000 : 1000));
    assert_int_equal(eom_integrate(&r.it, m.t, NULL, NULL), EOM_OK);
    error[i] = error_of(&r, &m);
    finish(&r);
  }
  print_message("errors %.2e %.2e\n", error[0], error[1]);
  assert_close(error[0] / error[1], 32, 0.15, 0);
}

/* With tested = 2n the steps are those of the motion alone. */
static void steps_can_leave_columns_out(void **state) {
  (void)state;
  motion m;
  find_motion(&spring_pendulum_model, &m);
  const eom_step_control control = {.rtol = 1e-9, .atol = 1e-9, .tested = 4};
  run r;
  start(&r, &m, EOM_EMITTER_AUTO, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS, m.np, &eom_dop853, 0);
  eom_integrator alone;
  double *work = malloc(eom_integrator_size(&eom_dop853, 4) * sizeof *work);
  eom_integrator_init(&alone, &eom_dop853, eom_rhs, r.sys, 4, 0, m.y0, 0, work);
  assert_int_equal(eom_integrator_control(&alone, &control), EOM_OK);
  assert_int_equal(eom_integrate(&alone, m.t, NULL, NULL), EOM_OK);
  assert_int_equal(eom_integrator_control(&r.it, &control), EOM_OK);
  assert_int_equal(eom_integrate(&r.it, m.t, NULL, NULL), EOM_OK);
  assert_int_equal(r.it.steps, alone.steps);
  assert_all_close(r.it.y, alone.y, 4, 1e-12, 1e-12); /* the solver of all columns rounds otherwise */
  const eom_step_control more = {.rtol = 1e-9, .tested = r.s.dim + 1}, fewer = {.rtol = 1e-9, .tested = -1};
  assert_int_equal(eom_integrator_control(&r.it, &more), EOM_BAD_OPTION);
  assert_int_equal(eom_integrator_control(&r.it, &fewer), EOM_BAD_OPTION);
  finish(&r);
  free(work);
}

/* A chosen parameter has the column that it has among all. */
static void parameters_can_be_chosen(void **state) {
  (void)state;
  motion m;
  find_motion(&chain_model, &m);
  eom_options options = eom_options_default();
  options.needs = EOM_NEED_TANGENT | EOM_NEED_PARAMETERS;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &chain_model, m.params, &options), EOM_OK);
  const int chosen[2] = {4, 1}, missing[1] = {5};
  double work[256], z[12], zdot[12], all[24], all_dot[24];
  eom_sensitivity some, every;
  assert_true(eom_sensitivity_size(sys, 0, 5) <= 128);
  assert_int_equal(eom_sensitivity_init(&some, sys, 0, 2, chosen, work), EOM_OK);
  assert_int_equal(eom_sensitivity_init(&every, sys, 0, 5, NULL, work + 128), EOM_OK);
  eom_sensitivity_start(&some, z, m.y0);
  eom_sensitivity_start(&every, all, m.y0);
  assert_int_equal(eom_sensitivity_rhs(&some, 0, z, zdot), EOM_OK);
  assert_int_equal(eom_sensitivity_rhs(&every, 0, all, all_dot), EOM_OK);
  assert_string_equal(sys->motion->parameter[4], "p->gravity");
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 2; j++) assert_close(zdot[4 + i * 2 + j], all_dot[4 + i * 5 + chosen[j]], 1e-14, 1e-14);
  assert_int_equal(eom_sensitivity_init(&some, sys, 0, 1, missing, work), EOM_BAD_OPTION);
  assert_int_equal(eom_sensitivity_init(&some, sys, 0, 6, NULL, work), EOM_BAD_OPTION);
  assert_int_equal(eom_sensitivity_init(&some, sys, 0, 0, NULL, work), EOM_BAD_OPTION);
  assert_int_equal(eom_sensitivity_init(&some, sys, -1, 2, NULL, work), EOM_BAD_OPTION);
  eom_system_destroy(sys);
  options.needs = EOM_NEED_SIMULATE;
  assert_int_equal(eom_system_create(&sys, &chain_model, m.params, &options), EOM_OK);
  assert_int_equal(eom_sensitivity_init(&some, sys, 4, 0, NULL, work), EOM_BAD_OPTION);
  eom_system_destroy(sys);
}

/* Directions that leave the circle lose what leads off it: x dx + y dy = 0 and dx vx + x dvx + dy vy + y dvy = 0 are left. */
static void directions_are_brought_onto_the_constraints(void **state) {
  (void)state;
  motion m;
  find_motion(&rod_model, &m);
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &rod_model, m.params, NULL), EOM_OK);
  double *work = malloc(eom_sensitivity_size(sys, 4, 0) * sizeof *work), z[20], before[20];
  eom_sensitivity s;
  assert_int_equal(eom_sensitivity_init(&s, sys, 4, 0, NULL, work), EOM_OK);
  eom_sensitivity_start(&s, z, m.y0);
  assert_int_equal(eom_sensitivity_project(&s, 0, z), EOM_OK);
  print_message("the largest change is %g, in column %d\n", s.change, s.column);
  assert_true(s.change > 0.1 && s.column >= 0);
  const double *S = z + 4;
  for (int j = 0; j < 4; j++) {
    const double x = z[0], y = z[1], vx = z[2], vy = z[3];
    assert_close(x * S[j] + y * S[4 + j], 0, 0, 1e-15);
    assert_close(S[j] * vx + x * S[8 + j] + S[4 + j] * vy + y * S[12 + j], 0, 0, 1e-15);
  }
  memcpy(before, z, sizeof before);
  assert_int_equal(eom_sensitivity_project(&s, 0, z), EOM_OK); /* nothing is left to do */
  assert_all_close(z, before, 20, 1e-14, 1e-15);
  assert_true(s.change < 1e-14);
  eom_system_destroy(sys);
  free(work);
}

/* Rows of both kinds, by calls: the columns are then derivatives of states that satisfy the constraints. */
static void directions_of_both_kinds_of_rows(void **state) {
  (void)state;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &mixed, NULL, NULL), EOM_OK);
  double *work = malloc(eom_sensitivity_size(sys, 6, 0) * sizeof *work), z[42], near[6], y[6] = {0.4, -0.3, 0.2, 0.5, 0.1, 0.3};
  const double t = 0.3, step = 1e-5;
  assert_int_equal(eom_project(sys, y, y + 3, t, NULL), EOM_OK);
  eom_sensitivity s;
  assert_int_equal(eom_sensitivity_init(&s, sys, 6, 0, NULL, work), EOM_OK);
  eom_sensitivity_start(&s, z, y);
  assert_int_equal(eom_sensitivity_project(&s, t, z), EOM_OK);
  for (int j = 0; j < 6; j++) {
    for (int i = 0; i < 6; i++) near[i] = y[i] + step * z[6 + i * 6 + j];
    assert_int_equal(eom_assemble(sys, near, near + 3, t), EOM_OK);
    assert_close(sys->phi[0], 0, 0, 20 * step * step); /* curvature of the rows */
    assert_close(sys->phi_dot[0], 0, 0, 20 * step * step);
    assert_close(sys->psi[0], 0, 0, 20 * step * step);
  }
  eom_system_destroy(sys);
  free(work);
}

/* Projected steps: columns stay within tolerance of the reference. */
static void projected_steps_keep_the_columns(void **state) {
  (void)state;
  motion m;
  find_motion(&rod_model, &m);
  run r;
  start(&r, &m, EOM_EMITTER_AUTO, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS, m.np, &eom_dop853, 0);
  const eom_step_control control = {.rtol = 1e-12, .atol = 1e-12};
  assert_int_equal(eom_integrator_control(&r.it, &control), EOM_OK);
  r.it.correct = eom_sensitivity_correct;
  assert_int_equal(eom_integrate(&r.it, m.t, NULL, NULL), EOM_OK);
  const double *y = r.it.y, *S = y + 4;
  for (int j = 0; j < m.directions; j++) assert_close(y[0] * S[j] + y[1] * S[r.s.k + j], 0, 0, 1e-14);
  assert_true(error_of(&r, &m) <= RELATIVE);
  finish(&r);
}

static int lowest(void *user, double t, const double *z, double *g) { return (void)user, (void)t, g[0] = z[0], 0; }

/* The time at which the rod first passes its lowest point, and the state there with its columns. */
static double time_of_passage(const motion *m, double *z, double *dt, double *dy) {
  run r;
  start(&r, m, EOM_EMITTER_AUTO, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS, m->np, &eom_dop853, 0);
  const eom_step_control control = {.rtol = 1e-13, .atol = 1e-13};
  assert_int_equal(eom_integrator_control(&r.it, &control), EOM_OK);
  double work[8];
  assert_true(eom_events_size(1) <= 8);
  eom_events events = {.count = 1, .root = lowest, .work = work};
  r.it.events = &events;
  assert_int_equal(eom_integrate(&r.it, 10, NULL, NULL), EOM_STOPPED);
  const double g_y[4] = {1, 0, 0, 0};
  if (dt) assert_int_equal(eom_sensitivity_event(&r.s, dt, dy, g_y, 0, r.it.t, r.it.y), EOM_OK);
  memcpy(z, r.it.y, (size_t)r.s.dim * sizeof *z);
  const double t = r.it.t;
  finish(&r);
  return t;
}

/* Against differences of whole runs, whose own error is of the order of their step squared: 1e-8. */
static void times_of_events_have_derivatives(void **state) {
  (void)state;
  motion m;
  find_motion(&rod_model, &m);
  double z[64], dt[8], dy[32], after[64], before[64];
  const double step = 1e-4;
  time_of_passage(&m, z, dt, dy);
  for (int j = 0; j < m.directions; j++) { /* angle, rate */
    double t[2];
    for (int side = 0; side < 2; side++) {
      motion moved = m;
      const double angle = atan2(m.y0[0], -m.y0[1]) + (j == 0 ? (side ? step : -step) : 0), l = m.params[1];
      const double rate = (m.y0[2] * -m.y0[1] + m.y0[3] * m.y0[0]) / (l * l) + (j == 1 ? (side ? step : -step) : 0);
      moved.y0[0] = l * sin(angle), moved.y0[1] = -l * cos(angle);
      moved.y0[2] = -moved.y0[1] * rate, moved.y0[3] = moved.y0[0] * rate;
      t[side] = time_of_passage(&moved, side ? after : before, NULL, NULL);
    }
    assert_close(dt[j], (t[1] - t[0]) / (2 * step), 1e-6, 1e-6);
    for (int i = 0; i < 4; i++) assert_close(dy[i * m.k + j], (after[i] - before[i]) / (2 * step), 1e-6, 1e-6);
  }
}

#ifdef WITH_TRAJECTORIES
/* A state with its columns where y is, to the end and through an output in the last step. */
typedef struct kept {
  int dim;
  double z[64];
} kept;

static void keep(void *user, double t, const double *z) {
  kept *k = user;
  (void)t;
  memcpy(k->z, z, (size_t)k->dim * sizeof *z);
}

/* By every method that has them, CVODES' columns among these. */
static void trajectories_carry_columns(void **state) {
  (void)state;
  motion m;
  find_motion(&chain_model, &m);
  const eom_trajectory_method *method;
  int followed = 0;
  for (int i = 0; (method = eom_trajectory_method_at(i)); i++)
    for (int included = 0; included < 2; included++) {
      run r;
      start(&r, &m, EOM_EMITTER_AUTO, EOM_NEED_TANGENT | EOM_NEED_PARAMETERS | EOM_NEED_LINEARISE, m.np, &eom_dop853, 0);
      const double just_before = m.t * (1 - 1e-9);
      kept inside = {.dim = r.s.dim};
      eom_outputs outputs = {.write = keep, .user = &inside, .times = &just_before, .count = 1};
      eom_trajectory_options options = {.method = method->name, .sensitivity = &r.s, .outputs = &outputs};
      options.control = (eom_step_control){.rtol = 1e-11, .atol = 1e-11, .tested = included ? 0 : 4};
      eom_trajectory *t;
      const eom_status made = eom_trajectory_create(&t, r.sys, &options, 0, r.it.y);
      if (made == EOM_OK) {
        assert_int_equal(eom_trajectory_to(t, m.t, NULL, NULL), EOM_OK);
        memcpy(r.it.y, eom_trajectory_state(t), (size_t)r.s.dim * sizeof *r.it.y);
        const double error = error_of(&r, &m);
        print_message("%-16s%s: %.1e in %ld steps\n", method->name, included ? "" : ", steps by y", error,
                      eom_trajectory_worked(t).steps);
        assert_true(error < 1e-6);
        assert_all_close(inside.z, r.it.y, r.s.dim, 1e-7, 1e-6);
        followed++;
      } else { /* without columns, or SUNDIALS without a choice of what counts in the error */
        assert_int_equal(made, EOM_BAD_OPTION);
        assert_true(!included || !method->columns);
      }
      eom_trajectory_destroy(t);
      finish(&r);
    }
  assert_true(followed >= 6);
}
#endif

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(motions_match_the_reference),
      cmocka_unit_test(columns_have_the_order_of_the_method),
      cmocka_unit_test(steps_can_leave_columns_out),
      cmocka_unit_test(parameters_can_be_chosen),
      cmocka_unit_test(directions_are_brought_onto_the_constraints),
      cmocka_unit_test(directions_of_both_kinds_of_rows),
      cmocka_unit_test(projected_steps_keep_the_columns),
      cmocka_unit_test(times_of_events_have_derivatives),
#ifdef WITH_TRAJECTORIES
      cmocka_unit_test(trajectories_carry_columns),
#endif
  };
  return cmocka_run_group_tests_name("sensitivity", tests, NULL, NULL);
}
