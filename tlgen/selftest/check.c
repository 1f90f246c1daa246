/* One jet function in the complete shape against differences of its C in quad precision.
 *
 * An error is relative to the row's scale at that order: the largest derivative of that order or below, or the change of one by a
 * relative change 1 of a variable, which is what rounding of the variables can do to a sum that cancels. */
#include "check.h"

#include "taylor/taylor.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct work {
  int rows, count; /* results; variables */
  tl_shape shape;
  void *tables;
  tl_real *memory, *jets, *seeds;
  size_t nreal;
  int *alpha; /* count */
  __float128 *x, *step, *twice, *coarse, *fine, *scratch;
  double *expected; /* rows x ncoef */
  double *doubt;    /* rows x ncoef: how far the differences with two steps disagree */
} work;

static void start(work *w, const input *in, const eom_function *f, int order) {
  const tl_spec spec = tl_complete(2 * in->n + 1, order);
  const size_t bytes = tl_shape_bytes(spec);
  w->count = 2 * in->n + 1;
  w->rows = f->rows(in->params);
  w->tables = input_memory(bytes, 1);
  if (tl_shape_init(&w->shape, spec, w->tables, bytes) != 0) {
    fprintf(stderr, "%d variables are too many for order %d: say --order %d\n", w->count, order, order - 1);
    exit(2);
  }
  const size_t ncoef = (size_t)w->shape.ncoef, rows = (size_t)w->rows, count = (size_t)w->count;
  w->nreal = tl_ctx_size(&w->shape, f->frame(in->params));
  w->memory = input_memory(w->nreal, sizeof *w->memory);
  w->jets = input_memory(rows * ncoef, sizeof *w->jets);
  w->seeds = input_memory(count * ncoef, sizeof *w->seeds);
  w->alpha = input_memory(count, sizeof *w->alpha);
  w->x = input_memory(3 * count + 2 * rows + (MAX_ORDER + 1) * rows + count, sizeof *w->x);
  w->step = w->x + count;
  w->twice = w->step + count;
  w->coarse = w->twice + count;
  w->fine = w->coarse + rows;
  w->scratch = w->fine + rows;
  w->expected = input_memory(rows * ncoef, sizeof *w->expected);
  w->doubt = input_memory(rows * ncoef, sizeof *w->doubt);
}

static void finish(work *w) {
  free(w->tables);
  free(w->memory);
  free(w->jets);
  free(w->seeds);
  free(w->alpha);
  free(w->x);
  free(w->expected);
  free(w->doubt);
}

/* The jets at x. False where a derivative does not exist. */
static int evaluate(work *w, const input *in, const eom_function *f, const double *x, double preset, int point) {
  tl_ctx cx;
  const ptrdiff_t nc = w->shape.ncoef;
  for (size_t i = 0; i < w->nreal; i++) w->memory[i] = (tl_real)NAN;
  for (ptrdiff_t i = 0; i < w->rows * nc; i++) w->jets[i] = (tl_real)preset;
  tl_ctx_init(&cx, &w->shape, w->memory, w->nreal);
  for (int i = 0; i < w->count; i++) tl_seed(&cx, w->seeds + i * nc, (tl_real)x[i], i);
  f->jet(&cx, w->jets, w->seeds, w->seeds + in->n * nc, w->seeds + 2 * in->n * nc, in->params);
  if (cx.status.bits == TL_OK) return 1;
  printf("%s (%s), point %d: %s in %s, line %d\n", f->name, f->source, point + 1, tl_status_text(cx.status.bits),
         tl_fn_name(cx.status.function), cx.status.line);
  return 0;
}

/* The variables of the monomial at a position, each as often as its exponent says; returns the order. */
static int variables(work *w, int position, int index[MAX_ORDER]) {
  int k, order = 0;
  tl_monomial(&w->shape, position, &k, w->alpha);
  for (int i = 0; i < w->count; i++)
    for (int a = 0; a < w->alpha[i]; a++) index[order++] = i;
  return order;
}

static void set_steps(work *w, const settings *s, const double *x, int relative) {
  for (int i = 0; i < w->count; i++) {
    w->step[i] = (__float128)(s->step * (relative ? fmax(1.0, fabs(x[i])) : 1.0));
    w->twice[i] = 2 * w->step[i];
  }
}

/* One derivative by differences, kept where its steps h and 2h agree better than what is there. */
static void refer(work *w, const input *in, tlgen_quad_fn *quad, int position) {
  int index[MAX_ORDER] = {0};
  const int order = variables(w, position, index);
  tlgen_difference(w->fine, w->rows, quad, in->n, w->x, in->quad_params, w->step, order, index, w->scratch);
  tlgen_difference(w->coarse, w->rows, quad, in->n, w->x, in->quad_params, w->twice, order, index, w->scratch);
  for (int row = 0; row < w->rows; row++) {
    const int at = row * w->shape.ncoef + position;
    const double doubt = fabs((double)(w->fine[row] - w->coarse[row]));
    if (!(doubt < w->doubt[at])) continue;
    w->expected[at] = (double)w->fine[row];
    w->doubt[at] = doubt;
  }
}

/* Fills expected and doubt. Of a large variable nobody knows whether it is an angle or a length, so both kinds of steps are tried. */
static void reference(work *w, const input *in, const settings *s, tlgen_quad_fn *quad, const double *x) {
  double largest = 0.0;
  for (int i = 0; i < w->count; i++) {
    w->x[i] = (__float128)x[i];
    largest = fmax(largest, fabs(x[i]));
  }
  for (int i = 0; i < w->rows * w->shape.ncoef; i++) {
    w->expected[i] = (double)NAN;
    w->doubt[i] = HUGE_VAL;
  }
  for (int relative = 0; relative < (largest > 1.0 ? 2 : 1); relative++) {
    set_steps(w, s, x, relative);
    for (int position = 0; position < w->shape.ncoef; position++) refer(w, in, quad, position);
  }
}

static double larger(double a, double b) { return b > a ? b : a; } /* keeps a where b is NaN */

/* The scale of one row at each order. */
static void scales(work *w, const double *x, int row, double scale[MAX_ORDER + 1]) {
  for (int order = 0; order <= MAX_ORDER; order++) scale[order] = 0.0;
  for (int position = 0; position < w->shape.ncoef; position++) {
    int index[MAX_ORDER] = {0};
    const int order = variables(w, position, index);
    const double size = fabs(w->expected[row * w->shape.ncoef + position]);
    for (int higher = order; higher <= MAX_ORDER; higher++) scale[higher] = larger(scale[higher], size);
    for (int i = 0; i < order; i++) scale[order - 1] = larger(scale[order - 1], size * fabs(x[index[i]]));
  }
}

static void compare(work *w, const settings *s, const double *x, int point, verdict *verdicts) {
  for (int row = 0; row < w->rows; row++) {
    double scale[MAX_ORDER + 1];
    scales(w, x, row, scale);
    for (int position = 0; position < w->shape.ncoef; position++) {
      int index[MAX_ORDER] = {0};
      const int order = variables(w, position, index), at = row * w->shape.ncoef + position;
      verdict *v = &verdicts[order];
      const double actual = (double)tl_deriv(&w->shape, w->jets + (ptrdiff_t)row * w->shape.ncoef, 0, w->alpha);
      const double difference = fabs(actual - w->expected[at]);
      const double error = difference == 0.0 ? 0.0 : isnan(difference) ? HUGE_VAL : difference / scale[order];
      v->compared++;
      if (!(w->doubt[at] <= s->rtol * scale[order])) {
        v->unsettled++;
        continue;
      }
      if (v->compared - v->unsettled > 1 && !(error > v->error)) continue;
      *v = (verdict){v->compared, v->unsettled, error, row, point, {index[0], index[1], index[2]}, actual, w->expected[at]};
    }
  }
}

int check_function(const input *in, const settings *s, const eom_function *f, tlgen_quad_fn *quad, double preset, verdict *verdicts) {
  work w;
  int good = 1;
  start(&w, in, f, s->max_order);
  for (int point = 0; point < in->npoints; point++) {
    if (!evaluate(&w, in, f, in->points[point], preset, point)) {
      good = 0;
      continue;
    }
    reference(&w, in, s, quad, in->points[point]);
    compare(&w, s, in->points[point], point, verdicts);
  }
  finish(&w);
  return good;
}
