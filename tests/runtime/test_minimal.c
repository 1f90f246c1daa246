/* Linear models in minimal coordinates: a basis of what constraints allow, unique whoever does the linear algebra, and errors. */
#include "close.h"
#include "constrained_models.h"
#include "evaluation.h"
#include "pen.h"
#include "random.h"

#include "eom/eom.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MOST = 4, ROWS = 2, TRIES = 20 };

/* Entries of bases at these states, whose conditions are below 1e3. */
#define BASIS_TOLERANCE 1e-12

static evaluation start(const eom_model *model, eom_linalg_choice linalg, const double *weights) {
  eom_options options = eom_options_default();
  options.linalg = linalg;
  options.weights = weights;
  evaluation e = evaluation_start(model, NULL, &options, eom_minimal_bytes);
  assert_true(e.sys->n <= MOST && e.sys->m <= ROWS);
  return e;
}

/* ---- models for one purpose ---- */

static int one(const void *params) { return (void)params, 1; }
static int two(const void *params) { return (void)params, 2; }
static int three(const void *params) { return (void)params, 3; }
static size_t frame(const void *params) { return (void)params, PEN_FRAME; }

/* L = x'^2/2 - 2 x^2 of q = (x, turn): the turn has no inertia. */
static void spring_lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)t, (void)params;
  pen_result(&p, out, sub(&p, times(&p, 0.5, square(&p, at(&p, qd, 0))), times(&p, 2, square(&p, at(&p, q, 0)))));
  pen_lift(&p);
}

/* turn' = 3 x'. */
static void wheel(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)q, (void)t, (void)params;
  pen_result(&p, out, sub(&p, at(&p, qd, 1), times(&p, 3, at(&p, qd, 0))));
  pen_lift(&p);
}

/* x = 0, turn = 0, with what 0.1 + 0.2 - 0.3 leaves. */
static void pins(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)qd, (void)t, (void)params;
  for (int i = 0; i < 2; i++) pen_result(&p, row(&p, out, i), plus(&p, at(&p, q, i), 5.5e-17));
  pen_lift(&p);
}

/* L = (x'^2 + y'^2 + z'^2)/2. */
static void free_lagrangian(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)q, (void)t, (void)params;
  jet flat = add(&p, square(&p, at(&p, qd, 0)), square(&p, at(&p, qd, 1)));
  pen_result(&p, out, times(&p, 0.5, add(&p, flat, square(&p, at(&p, qd, 2)))));
  pen_lift(&p);
}

/* z = x y twice, of quite different size. */
static void saddle_rows(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)qd, (void)t, (void)params;
  jet miss = sub(&p, at(&p, q, 2), mul(&p, at(&p, q, 0), at(&p, q, 1)));
  for (int i = 0; i < 2; i++) pen_result(&p, row(&p, out, i), times(&p, i ? 1e6 : 1, miss));
  pen_lift(&p);
}

/* y' = z x'. */
static void contact(tl_ctx *cx, tl_real *out, const tl_real *q, const tl_real *qd, const tl_real *t, const void *params) {
  pen p = {cx, 0};
  (void)t, (void)params;
  pen_result(&p, out, sub(&p, at(&p, qd, 1), mul(&p, at(&p, q, 2), at(&p, qd, 0))));
  pen_lift(&p);
}

static const eom_function saddle_list[] = {{.name = "saddle", .jet = saddle_rows, .rows = two, .frame = frame}};
static const eom_function contact_list[] = {{.name = "contact", .jet = contact, .rows = one, .frame = frame}};
static const eom_model saddle_twice = {.name = "saddle_twice",
                                       .dof = three,
                                       .lagrangian = {.name = "free", .jet = free_lagrangian, .rows = one, .frame = frame},
                                       .holonomic = saddle_list,
                                       .nholonomic = 1,
                                       .nonholonomic = contact_list,
                                       .nnonholonomic = 1};

static const eom_function wheel_list[] = {{.name = "wheel", .jet = wheel, .rows = one, .frame = frame}};
static const eom_function pin_list[] = {{.name = "pins", .jet = pins, .rows = two, .frame = frame}};
#define SPRING .dof = two, .lagrangian = {.name = "spring", .jet = spring_lagrangian, .rows = one, .frame = frame}
static const eom_model massless_wheel = {.name = "massless_wheel", SPRING, .nonholonomic = wheel_list, .nnonholonomic = 1};
static const eom_model pinned = {.name = "pinned", SPRING, .holonomic = pin_list, .nholonomic = 1};

/* A state on the constraints; false where there is none near. */
static bool draw(rng *r, eom_system *sys, double *q, double *qd, double t) {
  for (int i = 0; i < sys->n; i++) q[i] = rng_uniform(r, 0.4, 1.2), qd[i] = rng_uniform(r, -1, 1);
  return eom_project(sys, q, qd, t, NULL) == EOM_OK;
}

static eom_minimal linearise(evaluation *f, const double *q, const double *qd, double t) {
  eom_minimal m;
  assert_int_equal(eom_linearise_minimal(f->sys, &m, q, qd, t, f->memory, f->bytes), EOM_OK);
  return m;
}

/* phi, phi_dot and psi at y + h times column k of Z. */
static void rows_beside(eom_system *sys, const eom_minimal *m, int k, double h, const double *q, const double *qd, double t,
                        double *rows) {
  double x[MOST], u[MOST];
  for (int i = 0; i < m->n; i++) x[i] = q[i] + h * m->Z[i * m->d + k], u[i] = qd[i] + h * m->Z[(m->n + i) * m->d + k];
  assert_int_equal(eom_assemble(sys, x, u, t), EOM_OK);
  for (int i = 0; i < sys->m1; i++) rows[i] = sys->phi[i], rows[sys->m1 + i] = sys->phi_dot[i];
  for (int i = 0; i < sys->m2; i++) rows[2 * sys->m1 + i] = sys->psi[i];
}

/* By central differences: no row changes along any column of Z, to first order. */
static void assert_tangent(eom_system *sys, const eom_minimal *m, const double *q, const double *qd, double t) {
  const double h = 1e-5, tolerance = 1e-8; /* truncation of h^2 times third derivatives, and rounding of 1e-16/h */
  for (int k = 0; k < m->d; k++) {
    double above[2 * ROWS], below[2 * ROWS], length = 0;
    rows_beside(sys, m, k, h, q, qd, t, above), rows_beside(sys, m, k, -h, q, qd, t, below);
    for (int i = 0; i < 2 * m->n; i++) length = fmax(length, fabs(m->Z[i * m->d + k]));
    for (int r = 0; r < 2 * sys->m1 + sys->m2; r++)
      assert_close((above[r] - below[r]) / (2 * h), 0, 0, tolerance * (1 + pow(length, 3)));
  }
}

static double product(const double *a, int stride_a, const double *b, int stride_b, int count) {
  double sum = 0;
  for (int i = 0; i < count; i++) sum += a[i * stride_a] * b[i * stride_b];
  return sum;
}

/* S Z = 1. */
static void assert_inverse(const eom_minimal *m) {
  for (int i = 0; i < m->d; i++)
    for (int j = 0; j < m->d; j++) assert_close(product(m->S + i * 2 * m->n, 1, m->Z + j, m->d, 2 * m->n), i == j, 0, BASIS_TOLERANCE);
}

/* Of the positions, and of the velocities, vector k alone of 0..k moves coordinate[k]. */
static void assert_ordered(const eom_minimal *m) {
  for (int k = 0; k < m->d; k++) {
    const int first = k < m->nq ? 0 : m->nq, base = k < m->nq ? 0 : m->n;
    const double *row = m->Z + (base + m->coordinate[k]) * m->d;
    assert_true(row[k] > 0);
    for (int j = k + 1; j < (k < m->nq ? m->nq : m->d); j++) assert_true(row[j] == 0);
    for (int j = first; j < k; j++) assert_true(m->coordinate[j] != m->coordinate[k]);
  }
}

/* F = S F_y Z. */
static void assert_reduced(const eom_system *sys, const eom_minimal *m) {
  const int n = m->n, d = m->d;
  double F[4 * MOST * MOST], FZ[4 * MOST * MOST], largest = 1;
  eom_state_matrix(sys, F);
  for (int i = 0; i < 2 * n; i++)
    for (int j = 0; j < d; j++)
      FZ[i * d + j] = product(F + i * 2 * n, 1, m->Z + j, d, 2 * n), largest = fmax(largest, fabs(FZ[i * d + j]));
  for (int i = 0; i < d; i++)
    for (int j = 0; j < d; j++)
      assert_close(product(m->S + i * 2 * n, 1, FZ + j, d, 2 * n), m->F[i * d + j], 0, BASIS_TOLERANCE * largest);
}

static void every_model_has_a_basis(void **state) {
  (void)state;
  rng r = {1};
  for (int i = 0; i < nconstrained_models; i++) {
    evaluation f = start(constrained_models[i], EOM_LINALG_AUTO, NULL);
    int drawn = 0;
    for (int k = 0; k < TRIES; k++) {
      double q[MOST], qd[MOST];
      const double t = rng_uniform(&r, 0, 1);
      if (!draw(&r, f.sys, q, qd, t)) continue;
      drawn++;
      const eom_minimal m = linearise(&f, q, qd, t);
      assert_int_equal(m.nq, f.sys->n - f.sys->m1);
      assert_int_equal(m.d, 2 * f.sys->n - 2 * f.sys->m1 - f.sys->m2);
      assert_reduced(f.sys, &m), assert_inverse(&m), assert_ordered(&m), assert_tangent(f.sys, &m, q, qd, t);
    }
    assert_true(drawn > TRIES / 2);
    evaluation_stop(&f);
  }
}

#ifdef EOM_HAVE_LAPACKE
static void the_basis_does_not_depend_on_who_computes_it(void **state) {
  (void)state;
  rng r = {2};
  for (int i = 0; i < nconstrained_models; i++) {
    evaluation core = start(constrained_models[i], EOM_LINALG_CORE, NULL),
               lapack = start(constrained_models[i], EOM_LINALG_LAPACK, NULL);
    for (int k = 0; k < TRIES; k++) {
      double q[MOST], qd[MOST];
      const double t = rng_uniform(&r, 0, 1);
      if (!draw(&r, core.sys, q, qd, t)) continue;
      const eom_minimal a = linearise(&core, q, qd, t), b = linearise(&lapack, q, qd, t);
      assert_int_equal(a.d, b.d);
      assert_memory_equal(a.coordinate, b.coordinate, (size_t)a.d * sizeof(int));
      for (int e = 0; e < 2 * a.n * a.d; e++) assert_close(a.Z[e], b.Z[e], BASIS_TOLERANCE, BASIS_TOLERANCE);
    }
    evaluation_stop(&core), evaluation_stop(&lapack);
  }
}
#endif

/* A mass on a circle: x at the bottom, y at the side, x where both are as free to rounding. */
static void coordinates_are_the_most_free(void **state) {
  (void)state;
  evaluation e = start(&cartesian_pendulum, EOM_LINALG_AUTO, NULL);
  const double place[3][2] = {{0.6, -0.8}, {0.8, -0.6}, {0.7071067811865476, -0.7071067811865475}}, rest[2] = {0, 0};
  const int free[3] = {0, 1, 0};
  for (int i = 0; i < 3; i++) {
    const eom_minimal m = linearise(&e, place[i], rest, 0);
    assert_int_equal(m.coordinate[0], free[i]), assert_int_equal(m.coordinate[1], free[i]);
  }
  evaluation_stop(&e);
}

/* Coefficients but the first of the characteristic polynomial, by the traces of powers (Newton's identities). */
static void characteristic(const eom_minimal *m, double *c) {
  double power[64] = {0}, next[64], trace[8];
  const int d = m->d;
  assert_true(d <= 8);
  for (int i = 0; i < d; i++) power[i * d + i] = 1;
  for (int k = 0; k < d; k++) {
    for (int i = 0; i < d; i++)
      for (int j = 0; j < d; j++) next[i * d + j] = product(power + i * d, 1, m->F + j, d, d);
    memcpy(power, next, sizeof power);
    trace[k] = 0;
    for (int i = 0; i < d; i++) trace[k] += power[i * d + i];
    c[k] = -trace[k];
    for (int j = 0; j < k; j++) c[k] -= c[j] * trace[k - 1 - j];
    c[k] /= k + 1;
  }
}

/* At any state where all rows are holonomic; where they are not, calM is the metric of positions, which matters away from equilibria.
 */
static void eigenvalues_do_not_depend_on_weights(void **state) {
  (void)state;
  rng r = {3};
  const double weights[2][ROWS] = {{1e-2, 1e-2}, {1e2, 1e2}};
  for (int i = 0; i < nconstrained_models; i++) {
    if (constrained_models[i]->nnonholonomic > 0) continue;
    evaluation automatic = start(constrained_models[i], EOM_LINALG_AUTO, NULL);
    double q[MOST], qd[MOST], truth[8], c[8];
    while (!draw(&r, automatic.sys, q, qd, 0.5)) {
    }
    const eom_minimal m = linearise(&automatic, q, qd, 0.5);
    characteristic(&m, truth);
    for (int w = 0; w < 2; w++) {
      evaluation weighted = start(constrained_models[i], EOM_LINALG_AUTO, weights[w]);
      const eom_minimal mw = linearise(&weighted, q, qd, 0.5);
      assert_int_equal(mw.d, m.d);
      characteristic(&mw, c);
      double largest = 1;
      for (int k = 0; k < m.d; k++) largest = fmax(largest, fabs(truth[k]));
      assert_all_close(c, truth, m.d, 0, 1e-10 * largest);
      evaluation_stop(&weighted);
    }
    evaluation_stop(&automatic);
  }
}

/* The circle three times at quite different scales is one constraint. */
static void repeated_rows_count_once(void **state) {
  (void)state;
  redundancy rows = {.rows = 3, .factor = {1, 1e8, -1e-8}};
  evaluation a = start(&cartesian_pendulum, EOM_LINALG_AUTO, NULL), b = evaluation_start(&redundant, &rows, NULL, eom_minimal_bytes);
  const double q[2] = {0.6, -0.8}, qd[2] = {0.4, 0.3};
  const eom_minimal x = linearise(&a, q, qd, 0), y = linearise(&b, q, qd, 0);
  assert_int_equal(x.d, 2), assert_int_equal(y.d, 2);
  assert_all_close(y.F, x.F, 4, 1e-13, 1e-13);
  evaluation_stop(&a), evaluation_stop(&b);
}

/* A coordinate whose inertia only a nonholonomic row knows of: s (s^2 + 4) = 0, the zero for the turn. */
static void positions_without_inertia(void **state) {
  (void)state;
  evaluation e = start(&massless_wheel, EOM_LINALG_AUTO, NULL);
  const double q[2] = {0.2, 0.4}, qd[2] = {-0.3, -0.9}, truth[3] = {0, 4, 0};
  double c[8];
  const eom_minimal m = linearise(&e, q, qd, 0);
  assert_int_equal(e.sys->report.weighted, 1);
  assert_int_equal(m.nq, 2), assert_int_equal(m.d, 3);
  assert_inverse(&m), assert_ordered(&m), assert_tangent(e.sys, &m, q, qd, 0);
  characteristic(&m, c);
  assert_all_close(c, truth, 3, 0, 1e-13);
  evaluation_stop(&e);
}

static void repeated_rows_count_once_beside_others(void **state) {
  (void)state;
  evaluation e = evaluation_start(&saddle_twice, NULL, NULL, eom_minimal_bytes);
  rng r = {5};
  double q[3], qd[3];
  while (!draw(&r, e.sys, q, qd, 0)) {
  }
  const eom_minimal m = linearise(&e, q, qd, 0);
  assert_int_equal(e.sys->report.rank, 2);
  assert_int_equal(m.nq, 2), assert_int_equal(m.nv, 1);
  assert_inverse(&m), assert_ordered(&m);
  for (int k = 0; k < m.d; k++) { /* of z = x y, its rate, and y' = z x', by hand */
    double c[6];
    for (int i = 0; i < 6; i++) c[i] = m.Z[i * m.d + k];
    assert_close(c[2], c[0] * q[1] + q[0] * c[1], 0, BASIS_TOLERANCE);
    assert_close(c[5], c[3] * q[1] + qd[0] * c[1] + c[0] * qd[1] + q[0] * c[4], 0, BASIS_TOLERANCE);
    assert_close(c[4], c[2] * qd[0] + q[2] * c[3], 0, BASIS_TOLERANCE);
  }
  evaluation_stop(&e);
}

static void nothing_is_left_to_move(void **state) {
  (void)state;
  evaluation e = start(&pinned, EOM_LINALG_AUTO, NULL);
  const double q[2] = {0, 0}, qd[2] = {0, 0};
  assert_int_equal(linearise(&e, q, qd, 0).d, 0);
  evaluation_stop(&e);
}

static void states_beside_the_constraints_are_refused(void **state) {
  (void)state;
  evaluation f = start(&mixed, EOM_LINALG_AUTO, NULL);
  rng r = {4};
  double q[3], qd[3];
  eom_minimal m;
  while (!draw(&r, f.sys, q, qd, 0.5)) {
  }
  q[2] += 1e-3;
  assert_int_equal(eom_linearise_minimal(f.sys, &m, q, qd, 0.5, f.memory, f.bytes), EOM_OFF_CONSTRAINTS);
  assert_string_equal(f.sys->report.row[0].name, "bowl");
  assert_int_equal(f.sys->report.row[0].kind, EOM_ROW_VIOLATED);
  char text[1000];
  eom_report_text(&f.sys->report, text, sizeof text);
  assert_non_null(strstr(text, "bowl[0] (model.c:20): not satisfied"));
  q[2] -= 1e-3;
  const double off = 1e-3 / hypot(1, q[2]); /* of the steering alone: along the bowl, whose rate is (-x, -2 y, 1) qd */
  qd[1] += off, qd[2] += 2 * q[1] * off;
  assert_int_equal(eom_linearise_minimal(f.sys, &m, q, qd, 0.5, f.memory, f.bytes), EOM_OFF_CONSTRAINTS);
  assert_int_equal(f.sys->report.nrow, 1);
  assert_string_equal(f.sys->report.row[0].name, "steering");
  assert_int_equal(eom_linearise_minimal(f.sys, &m, q, qd, 0.5, f.memory, f.bytes - 1), EOM_NO_MEMORY);
  qd[0] = (double)NAN;
  assert_int_equal(eom_linearise_minimal(f.sys, &m, q, qd, 0.5, f.memory, f.bytes), EOM_NOT_FINITE);
  evaluation_stop(&f);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_model_has_a_basis),
#ifdef EOM_HAVE_LAPACKE
      cmocka_unit_test(the_basis_does_not_depend_on_who_computes_it),
#endif
      cmocka_unit_test(coordinates_are_the_most_free),
      cmocka_unit_test(eigenvalues_do_not_depend_on_weights),
      cmocka_unit_test(repeated_rows_count_once),
      cmocka_unit_test(positions_without_inertia),
      cmocka_unit_test(repeated_rows_count_once_beside_others),
      cmocka_unit_test(nothing_is_left_to_move),
      cmocka_unit_test(states_beside_the_constraints_are_refused),
  };
  return cmocka_run_group_tests_name("minimal", tests, NULL, NULL);
}
