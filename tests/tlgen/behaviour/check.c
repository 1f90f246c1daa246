/* One model: its jet functions against the plain C and its differences in quad precision, in complete and in motion shapes. */
#include "close.h"
#include "index.h"
#include "plain.h"
#include "random.h"
#include "reference.h"

#include "taylor/taylor.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The same coefficients by other products: rounding only. */
static const double SHAPE_RTOL = 1e-12;

enum { MAX_FAULTS = 10 };

static int points = 8; /* or the program's argument */

typedef struct checked {
  const eom_function *function;
  int number; /* as in plain.h */
  int rows, n;
} checked;

static int faults;

static const char *variable_name(int n, int i, char text[16]) {
  if (i == 2 * n) return "t";
  snprintf(text, 16, i < n ? "q[%d]" : "qd[%d]", i % n);
  return text;
}

static void fault(const checked *f, int row, const char *what, int order, const int *index, double actual, double expected, double scale) {
  char text[16];
  if (++faults > MAX_FAULTS) return;
  print_error("%s (%s) row %d, %s", f->function->name, f->function->source, row, what);
  for (int i = 0; i < order; i++) print_error(" %s", variable_name(f->n, index[i], text));
  print_error(": %.17g, expected %.17g, difference %.3g, scale %.3g\n", actual, expected, actual - expected, scale);
}

/* A jet function's results in a shape, from its seeds. Every number of workspace that nobody wrote is NaN. */
typedef struct evaluation {
  tl_shape shape;
  void *tables;
  tl_real *memory, *out, *seeds;
  size_t nreal;
} evaluation;

static evaluation start(const checked *f, tl_spec spec) {
  evaluation e;
  size_t bytes = tl_shape_bytes(spec), variables = 2 * (size_t)f->n + 1;
  e.tables = malloc(bytes ? bytes : 1);
  assert_int_equal(tl_shape_init(&e.shape, spec, e.tables, bytes), 0);
  e.nreal = tl_ctx_size(&e.shape, f->function->frame(plain_params()));
  e.memory = malloc(e.nreal * sizeof(tl_real));
  e.out = malloc((size_t)f->rows * (size_t)e.shape.ncoef * sizeof(tl_real));
  e.seeds = calloc(variables * (size_t)e.shape.ncoef, sizeof(tl_real));
  return e;
}

static void finish(evaluation *e) {
  free(e->tables);
  free(e->memory);
  free(e->out);
  free(e->seeds);
}

static tl_real *seed(const evaluation *e, int i) { return e->seeds + (ptrdiff_t)i * e->shape.ncoef; }
static const tl_real *result(const evaluation *e, int row) { return e->out + (ptrdiff_t)row * e->shape.ncoef; }

static void evaluate(const checked *f, evaluation *e) {
  tl_ctx cx;
  for (size_t i = 0; i < e->nreal; i++) e->memory[i] = (tl_real)NAN;
  const tl_real preset = f->function == &plain_model()->force ? 0 : (tl_real)NAN; /* as the runtime does */
  for (int i = 0; i < f->rows * e->shape.ncoef; i++) e->out[i] = preset;
  tl_ctx_init(&cx, &e->shape, e->memory, e->nreal);
  f->function->jet(&cx, e->out, e->seeds, seed(e, f->n), seed(e, 2 * f->n), plain_params());
  if (cx.status.bits != TL_OK)
    fail_msg("%s: status %s in %s, line %d", f->function->name, tl_status_text(cx.status.bits), tl_fn_name(cx.status.function), cx.status.line);
  assert_ptr_equal(cx.top + f->function->frame(plain_params()) * (size_t)e->shape.ncoef, cx.end); /* every frame was given back */
}

/* The derivative of the results in the complete shape by x[index[0]] .. x[index[order-1]]. */
static double derivative(const evaluation *e, int row, int order, const int *index) {
  int alpha[64] = {0};
  for (int i = 0; i < order; i++) alpha[index[i]]++;
  return tl_deriv(&e->shape, result(e, row), 0, alpha);
}

static void check_values(const checked *f, const double *x, const evaluation *e) {
  double copy[64], out[16] = {0};
  memcpy(copy, x, (size_t)(2 * f->n + 1) * sizeof *x);
  plain_call(f->number, out, copy, copy + f->n, copy[2 * f->n]);
  for (int row = 0; row < f->rows; row++) {
    double actual = result(e, row)[0], scale = fmax(fabs(out[row]), 1.0);
    if (!(fabs(actual - out[row]) <= plain_limits.value * scale)) fault(f, row, "value beside the plain C in double", 0, NULL, actual, out[row], scale);
  }
}

/* Every partial derivative of one order; scale[row] is the largest derivative so far. */
static void check_order(const checked *f, const double *x, const evaluation *e, int order, double *scale) {
  int index[3] = {0}, count = 2 * f->n + 1, number = 0;
  double(*expected)[16] = calloc((size_t)e->shape.ncoef, sizeof *expected);
  do {
    reference_derivative(expected[number], f->rows, f->number, f->n, x, order, index);
    for (int row = 0; row < f->rows; row++) scale[row] = fmax(scale[row], fabs(expected[number][row]));
    number++;
  } while (next_index(index, order, count));
  memset(index, 0, sizeof index);
  number = 0;
  do {
    for (int row = 0; row < f->rows; row++) {
      double actual = derivative(e, row, order, index);
      if (!(fabs(actual - expected[number][row]) <= plain_limits.derivative * scale[row]))
        fault(f, row, order ? "derivative by" : "value beside the plain C in quad", order, index, actual, expected[number][row], scale[row]);
    }
    number++;
  } while (next_index(index, order, count));
  free(expected);
}

/* (d.grad)^k of the derivative by index[0..order-1], from the complete shape. */
static double along(const evaluation *complete, int row, const double *d, int count, int k, int order, int *index) {
  if (k == 0) return derivative(complete, row, order, index);
  double sum = 0.0;
  for (int i = 0; i < count; i++) {
    index[order] = i;
    sum += d[i] * along(complete, row, d, count, k - 1, order + 1, index);
  }
  return sum;
}

/* Seeds x_i + s d_i + t_i in a motion shape: its s^k t^alpha is (d.grad)^k D^alpha f/(k! alpha!), |alpha| + k <= 3. */
static void check_motion(const checked *f, const double *x, const double *d, const evaluation *complete, tl_spec spec) {
  evaluation e = start(f, spec);
  int count = 2 * f->n + 1;
  for (int i = 0; i < count; i++) {
    int tangent = spec.nvar > 0 && i < spec.nvar ? tl_index1(&e.shape, 0, i) : -1;
    seed(&e, i)[0] = x[i];
    seed(&e, i)[tl_index(&e.shape, 1, NULL)] = d[i];
    if (tangent >= 0) seed(&e, i)[tangent] = 1.0;
  }
  evaluate(f, &e);
  for (int row = 0; row < f->rows; row++)
    for (int position = 0; position < e.shape.ncoef; position++) {
      int k, alpha[64] = {0}, index[3] = {0}, order = 0;
      double factor = 1.0, bound = 1.0;
      tl_monomial(&e.shape, position, &k, alpha);
      for (int i = 0; i < spec.nvar; i++)
        for (int a = 1; a <= alpha[i]; a++) index[order++] = i, factor /= a;
      for (int a = 2; a <= k; a++) factor /= a;
      for (int i = 0; i < complete->shape.ncoef; i++) bound = fmax(bound, fabs(result(complete, row)[i]));
      double expected = factor * along(complete, row, d, count, k, order, index), actual = result(&e, row)[position];
      char what[64];
      snprintf(what, sizeof what, "shape {%d,%d,%d}, coefficient of s^%d", spec.curve, spec.nvar, spec.order, k);
      if (!(fabs(actual - expected) <= SHAPE_RTOL * bound)) fault(f, row, what, order, index, actual, expected, bound);
    }
  finish(&e);
}

static void check_function(void **state) {
  const checked *f = *state;
  int count = 2 * f->n + 1;
  rng r = {20160829};
  evaluation complete = start(f, tl_third_order(count));
  for (int point = 0; point < points; point++) {
    double x[64], d[64], scale[16] = {0};
    for (int i = 0; i < count; i++) {
      x[i] = rng_uniform(&r, -1.0, 1.0);
      d[i] = rng_uniform(&r, -1.0, 1.0);
      tl_ctx cx;
      tl_ctx_init(&cx, &complete.shape, complete.memory, complete.nreal);
      tl_seed(&cx, seed(&complete, i), x[i], i);
    }
    evaluate(f, &complete);
    check_values(f, x, &complete);
    for (int order = 0; order <= 3; order++) check_order(f, x, &complete, order, scale);
    check_motion(f, x, d, &complete, (tl_spec){1, 2 * f->n, 2});
    check_motion(f, x, d, &complete, tl_motion(2, 2 * f->n));
    check_motion(f, x, d, &complete, tl_univariate(3));
  }
  finish(&complete);
  if (faults) fail_msg("%d numbers of %s differ", faults, f->function->name);
}

int main(int argc, char **argv) {
  points = test_tries(argc > 1 ? atoi(argv[1]) : points);
  const eom_model *m = plain_model();
  const void *params = plain_params();
  checked list[16];
  struct CMUnitTest tests[16];
  int count = 0, constraints = m->nholonomic + m->nnonholonomic;
  const eom_function *functions[16] = {&m->lagrangian, &m->force, &m->dissipation};

  for (int i = 0; i < constraints; i++)
    functions[3 + i] = i < m->nholonomic ? &m->holonomic[i] : &m->nonholonomic[i - m->nholonomic];
  for (int i = 0; i < 3 + constraints; i++) {
    if (!functions[i]->jet) continue;
    list[count] = (checked){functions[i], count, functions[i]->rows(params), m->dof(params)};
    tests[count] = (struct CMUnitTest){functions[i]->name, check_function, NULL, NULL, &list[count]};
    count++;
  }
  return _cmocka_run_group_tests(m->name, tests, (size_t)count, NULL, NULL);
}
