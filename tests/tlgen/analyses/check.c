/* Motion functions of one model at random states, each variant beside the one with all analyses. */
#include "check.h"

#include "close.h"
#include "random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 16, STATES = 40, DIRECTIONS = 2 };

/* Of the largest number of a result: the same formulas, rounded in another order. */
static const double ROUNDING = 1e-12;

typedef struct inputs {
  double q[MOST], qd[MOST], t, qdd[MOST], lambda[MOST], w[2 * MOST * DIRECTIONS];
} inputs;

typedef struct result {
  const char *name;
  int code, count;
  double numbers[2 * MOST * MOST];
} result;

enum { RESULTS = 24 };
typedef struct results {
  int count;
  result of[RESULTS];
} results;

static inputs draw(rng *r, const eom_motion *f) {
  inputs x = {.t = rng_uniform(r, 0, 1)};
  const int m = f->m1 + f->m2;
  for (int i = 0; i < f->n; i++) {
    x.q[i] = rng_uniform(r, -1, 1);
    x.qd[i] = rng_uniform(r, -1, 1);
    x.qdd[i] = rng_uniform(r, -1, 1);
  }
  for (int i = 0; i < m; i++) x.lambda[i] = rng_uniform(r, -1, 1);
  for (int i = 0; i < 2 * f->n * DIRECTIONS; i++) x.w[i] = rng_uniform(r, -1, 1);
  return x;
}

/* Room for a result of so many numbers. */
static double *room(results *to, const char *name, int count) {
  assert_true(to->count < RESULTS && count <= 2 * MOST * MOST);
  result *r = &to->of[to->count++];
  *r = (result){.name = name, .count = count};
  return r->numbers;
}

/* The code of the results from number first on. */
static void set_code(results *to, int first, int code) {
  for (int i = first; i < to->count; i++) to->of[i].code = code;
}

static void simulate(const eom_motion *f, const inputs *x, double *work, results *to) {
  const int n = f->n, m = f->m1 + f->m2, first = to->count;
  eom_parts out = {.M = room(to, "M", n * n), .Q = room(to, "Q", n)};
  out.phi = room(to, "phi", f->m1);
  out.phi_dot = room(to, "phi_dot", f->m1);
  out.psi = room(to, "psi", f->m2);
  out.A = room(to, "A", m * n);
  out.b = room(to, "b", m);
  set_code(to, first, f->simulate(motion_params, x->q, x->qd, x->t, &out, work));
}

static void evaluate(const eom_motion *f, const inputs *x, double *work, results *to) {
  const int n = f->n, m = f->m1 + f->m2, k = DIRECTIONS;
  const void *p = motion_params;
  to->count = 0;
  int first = 0;
  double *momentum = room(to, "momentum", n), *lagrangian = room(to, "L", 1), *energy = room(to, "E", 1);
  set_code(to, first, f->energy(p, x->q, x->qd, x->t, momentum, lagrangian, energy, work));
  simulate(f, x, work, to);
  first = to->count;
  set_code(to, first, f->residual(p, x->q, x->qd, x->t, x->qdd, room(to, "r", n), work));
  first = to->count;
  double *r = room(to, "r_y", 2 * n * n), *g = room(to, "g_y", 2 * m * n);
  set_code(to, first, f->linearise(p, x->q, x->qd, x->t, x->qdd, x->lambda, r, g, work));
  first = to->count;
  r = room(to, "r_w", n * k), g = room(to, "g_w", m * k);
  set_code(to, first, f->tangent(p, x->q, x->qd, x->t, x->qdd, x->lambda, k, x->w, r, g, work));
  if (f->parameters) {
    first = to->count;
    r = room(to, "r_p", n * f->np), g = room(to, "g_p", m * f->np);
    set_code(to, first, f->parameters(p, x->q, x->qd, x->t, x->qdd, x->lambda, r, g, work));
  }
  if (!f->jacobian) return;
  first = to->count;
  r = room(to, "qdd", n), g = room(to, "qdd_y", 2 * n * n);
  set_code(to, first, f->jacobian(p, x->q, x->qd, x->t, r, g, work));
  first = to->count;
  r = room(to, "qdd of a direction", n), g = room(to, "dqdd", n * k);
  set_code(to, first, f->directional(p, x->q, x->qd, x->t, k, x->w, r, g, work));
}

static double *workspace(const eom_motion *f) {
  const size_t bytes = (f->work + 1) * sizeof(double), lines = (bytes + EOM_MOTION_ALIGNMENT - 1) / EOM_MOTION_ALIGNMENT;
  double *work = aligned_alloc(EOM_MOTION_ALIGNMENT, lines * EOM_MOTION_ALIGNMENT);
  assert_non_null(work);
  return work;
}

/* How many results there are numbers of. */
static int compare(const struct variant *v, const results *actual, const results *expected) {
  int compared = 0;
  assert_int_equal(actual->count, expected->count);
  for (int i = 0; i < expected->count; i++) {
    const result *a = &actual->of[i], *e = &expected->of[i];
    assert_int_equal(a->code != 0, e->code != 0);
    if (e->code) continue;
    double scale = 0;
    for (int k = 0; k < e->count; k++) scale = fmax(scale, fabs(e->numbers[k]));
    for (int k = 0; k < e->count; k++)
      assert_close_case(a->numbers[k], e->numbers[k], ROUNDING * scale, __FILE__, __LINE__, "%s in %s without %s, number %d", e->name,
                        v->form, v->without, k);
    compared++;
  }
  return compared;
}

static void test_numbers(void **state) {
  (void)state;
  static results expected, actual;
  const struct variant *with = NULL;
  for (int i = 0; i < nvariant; i++) {
    const struct variant *v = &variants[i];
    if (strcmp(v->without, "none") == 0) {
      with = v;
      continue;
    }
    double *work = workspace(v->motion), *work_with = workspace(with->motion);
    rng r = {1};
    int compared = 0;
    for (int k = 0; k < STATES; k++) {
      const inputs x = draw(&r, v->motion);
      evaluate(with->motion, &x, work_with, &expected);
      evaluate(v->motion, &x, work, &actual);
      compared += compare(v, &actual, &expected);
    }
    assert_true(compared > STATES * expected.count / 2);
    free(work);
    free(work_with);
  }
}

/* What is proved is claimed in both forms, and without the proof it is not claimed. */
static void test_claims(void **state) {
  (void)state;
  for (int i = 0; i < nvariant; i++) {
    const eom_motion *f = variants[i].motion, *first = variants[0].motion;
    const int proved = strcmp(variants[i].without, "constant-mass,time") != 0;
    assert_int_equal(f->autonomous, proved && first->autonomous);
    assert_int_equal(f->constant_mass, proved && first->constant_mass);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(test_numbers), cmocka_unit_test(test_claims)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
