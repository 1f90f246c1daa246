/* One model of a real mechanism: L, its derivatives up to the third, accelerations, multipliers, constraint functions and the
 * linearisation beside the high-precision reference. With --table it prints one line of markdown per kind of point besides checking, with
 * --time one line of what a linearisation takes by jets and by motion functions; bench/mechanisms runs that. */
#define _POSIX_C_SOURCE 200112L /* clock_gettime */
#include "index.h"
#include "mechanics.h"
#include "reference.h"

#include "eom/eom.h"
#include "taylor/taylor.h"

#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* The largest error of a block of numbers relative to the largest of them: some thousand roundings. At points that were chosen to be
 * ill-conditioned, condition * DBL_EPSILON is the limit where it is more. */
static const double BLOCK_RTOL = 1e-12;

/* The columns of the table. */
enum { VALUE, GRADIENT, HESSIAN, THIRD, QDD, QDD_Y, LAMBDA, LAMBDA_Y, ROWS, COLUMNS };
static const char *const names[COLUMNS] = {"L", "gradient", "hessian", "third", "qdd", "qdd_y", "lambda", "lambda_y", "rows"};

typedef struct errors {
  double error[COLUMNS];     /* relative; negative where there is nothing */
  double condition[COLUMNS]; /* largest */
} errors;

static int faults;

static double largest(const block *b) {
  double scale = 0.0;
  for (int i = 0; i < b->count; i++) scale = fmax(scale, fabs(b->numbers[i]));
  return scale;
}

/* What the errors of a block are relative to: its largest number; for derivatives that are all zero that of the order below. */
static double scale_of(const point *p, int column) {
  double scale = largest(reference_block(p, names[column]));
  return scale == 0.0 && column > VALUE && column <= THIRD ? scale_of(p, column - 1) : scale;
}

static double relative(double difference, double scale) {
  if (isnan(difference)) return (double)INFINITY;
  return difference == 0.0 ? 0.0 : difference / scale;
}

static bool is_generic(const char *kind) { return strcmp(kind, "generic") == 0; }

static double limit_of(const point *p, double condition) {
  return is_generic(p->kind) ? BLOCK_RTOL : fmax(BLOCK_RTOL, condition * DBL_EPSILON);
}

/* Reports a number that is too far off, and remembers the largest error of the column. */
static void compare(errors *e, const point *p, int column, const char *source, int index, double actual, double expected) {
  double condition = reference_block(p, names[column])->condition;
  double error = relative(fabs(actual - expected), scale_of(p, column));
  e->error[column] = fmax(e->error[column], error);
  e->condition[column] = fmax(e->condition[column], condition);
  if (error <= limit_of(p, condition)) return;
  faults++;
  fprintf(stderr, "%s, %s point: %s[%d] of the %s: %.17g, expected %.17g, relative error %.3g, limit %.3g\n", mechanics_model()->name,
          p->kind, names[column], index, source, actual, expected, error, limit_of(p, condition));
}

static void compare_all(errors *e, const point *p, int column, const char *source, const double *actual, int count) {
  const block *b = reference_block(p, names[column]);
  if (b->count != count) {
    faults++;
    fprintf(stderr, "%s: %d numbers in %s, expected %d\n", mechanics_model()->name, count, names[column], b->count);
    return;
  }
  for (int i = 0; i < count; i++) compare(e, p, column, source, i, actual[i], b->numbers[i]);
}

static void *claim(size_t bytes) {
  void *memory = malloc(bytes ? bytes : 1);
  if (!memory) exit(EXIT_FAILURE);
  return memory;
}

static void compare_order(errors *e, const point *p, const tl_shape *shape, const tl_real *out, int order) {
  int index[3] = {0}, alpha[64], number = 0;
  const block *b = reference_block(p, names[order]);
  do {
    memset(alpha, 0, sizeof alpha);
    for (int i = 0; i < order; i++) alpha[index[i]]++;
    compare(e, p, order, "jet", number, tl_deriv(shape, out, 0, alpha), b->numbers[number]);
    number++;
  } while (next_index(index, order, shape->nvar));
}

/* L as the generated jet function has it, all derivatives at once. */
static void check_jet(errors *e, const point *p, int n) {
  const eom_function *f = &mechanics_model()->lagrangian;
  int count = 2 * n + 1;
  tl_spec spec = tl_third_order(count);
  tl_shape shape;
  tl_ctx cx;
  void *tables = claim(tl_shape_bytes(spec));
  tl_shape_init(&shape, spec, tables, tl_shape_bytes(spec));
  size_t coefficients = (size_t)shape.ncoef, room = tl_ctx_size(&shape, f->frame(mechanics_params()));
  tl_real *memory = claim(room * sizeof *memory), *out = claim(coefficients * sizeof *out);
  tl_real *seeds = claim((size_t)count * coefficients * sizeof *seeds);
  tl_ctx_init(&cx, &shape, memory, room);
  for (int i = 0; i < count; i++) tl_seed(&cx, seeds + (size_t)i * coefficients, p->state[i], i);
  f->jet(&cx, out, seeds, seeds + (size_t)n * coefficients, seeds + (size_t)(2 * n) * coefficients, mechanics_params());
  if (cx.status.bits != TL_OK) {
    faults++;
    fprintf(stderr, "%s: status %s in line %d\n", f->name, tl_status_text(cx.status.bits), cx.status.line);
  }
  for (int order = 0; order <= 3; order++) compare_order(e, p, &shape, out, order);
  free(tables);
  free(memory);
  free(out);
  free(seeds);
}

/* M of the runtime is the block of velocities in the Hessian. */
static void check_mass(errors *e, const point *p, const eom_system *sys) {
  const block *b = reference_block(p, names[HESSIAN]);
  int index[2] = {0}, number = 0, n = sys->n;
  do {
    int i = index[0] - n, j = index[1] - n;
    if (i >= 0 && j < n) compare(e, p, HESSIAN, "runtime", number, sys->M[i * n + j], b->numbers[number]);
    number++;
  } while (next_index(index, 2, 2 * n + 1));
}

/* phi, then psi. */
static void check_rows(errors *e, const point *p, const eom_system *sys) {
  tl_real rows[64];
  if (sys->m == 0) return;
  for (int i = 0; i < sys->m; i++) rows[i] = i < sys->m1 ? sys->phi[i] : sys->psi[i - sys->m1];
  compare_all(e, p, ROWS, "runtime", rows, sys->m);
}

/* Whether an evaluation went well. */
static bool succeeded(const eom_system *sys, eom_status status) {
  char text[512];
  if (status == EOM_OK) return true;
  faults++;
  eom_report_text(&sys->report, text, sizeof text);
  fprintf(stderr, "%s: %s\n", sys->model->name, text);
  return false;
}

static void check_motion(errors *e, const point *p, eom_system *sys) {
  const block *gradient = reference_block(p, names[GRADIENT]);
  int n = sys->n;
  const double *q = p->state, *qd = q + n, t = p->state[2 * n];
  if (!succeeded(sys, eom_assemble(sys, q, qd, t))) return;
  compare_all(e, p, VALUE, "runtime", &sys->lagrangian, 1);
  for (int i = 0; i < n; i++) compare(e, p, GRADIENT, "runtime", n + i, sys->momentum[i], gradient->numbers[n + i]);
  check_mass(e, p, sys);
  check_rows(e, p, sys);
  if (!succeeded(sys, eom_linearise(sys, q, qd, t))) return;
  compare_all(e, p, QDD, "runtime", sys->qdd, n);
  compare_all(e, p, QDD_Y, "runtime", sys->qdd_y, 2 * n * n);
  compare_all(e, p, LAMBDA, "runtime", sys->lambda, sys->m);
  if (sys->m > 0) compare_all(e, p, LAMBDA_Y, "runtime", sys->lambda_y, 2 * n * sys->m);
}

static errors no_errors(void) {
  errors e;
  for (int i = 0; i < COLUMNS; i++) e.error[i] = e.condition[i] = -1.0;
  return e;
}

static void print_row(const eom_system *sys, const char *kind, const errors *e) {
  double condition = 1.0;
  printf("| %s | %s | %d | %d |", sys->model->name, is_generic(kind) ? mechanics_about : kind, sys->n, sys->m);
  for (int i = 0; i < COLUMNS; i++) {
    if (e->error[i] < 0.0)
      printf(" |");
    else
      printf(" %.0e |", e->error[i]);
    condition = fmax(condition, e->condition[i]);
  }
  printf(" %.0e |\n", condition);
}

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Nanoseconds that eom_linearise takes at a point, minimum and median of REPEATS; false where the emitter cannot. */
static bool time_linearise(eom_emitter emitter, const point *p, double *minimum, double *median) {
  enum { REPEATS = 15, PER_REPEAT = 200 };
  eom_options options = eom_options_default();
  eom_system *sys;
  double times[REPEATS];
  options.emitter = emitter;
  if (eom_system_create(&sys, mechanics_model(), mechanics_params(), &options)) return false;
  const int n = sys->n;
  bool fine = true;
  for (int r = 0; r < REPEATS; r++) {
    const double start = seconds();
    for (int k = 0; k < PER_REPEAT; k++) fine = eom_linearise(sys, p->state, p->state + n, p->state[2 * n]) == EOM_OK && fine;
    times[r] = 1e9 / (double)PER_REPEAT * (seconds() - start);
  }
  qsort(times, REPEATS, sizeof times[0], ascending);
  *minimum = times[0];
  *median = times[REPEATS / 2];
  eom_system_destroy(sys);
  return fine;
}

/* One line of markdown: the model, n, m, jets and motion functions in ns (minimum, median), the ratio of the minima. */
static void print_times(const reference *r, int constraints) {
  double calls[2], motion[2];
  const point *p = &r->points[0];
  if (!time_linearise(EOM_EMITTER_CALLS, p, &calls[0], &calls[1])) return;
  printf("| %s | %d | %d | %.0f (%.0f) |", mechanics_model()->name, r->n, constraints, calls[0], calls[1]);
  if (time_linearise(EOM_EMITTER_MOTION, p, &motion[0], &motion[1]))
    printf(" %.0f (%.0f) | %.1f |\n", motion[0], motion[1], calls[0] / motion[0]);
  else
    printf(" - | - |\n");
}

int main(int argc, char **argv) {
  bool table = argc == 2 && strcmp(argv[1], "--table") == 0, timed = argc == 2 && strcmp(argv[1], "--time") == 0;
  reference r = reference_read(mechanics_reference);
  eom_system *sys;
  if (argc > 1 && !table && !timed) {
    fprintf(stderr, "usage: %s [--table | --time]\n", argv[0]);
    return 2;
  }
  if (eom_system_create(&sys, mechanics_model(), mechanics_params(), NULL) || sys->n != r.n || 2 * r.n + 1 > 64) {
    fprintf(stderr, "%s: no system of %d coordinates\n", mechanics_model()->name, r.n);
    return EXIT_FAILURE;
  }
  errors e = no_errors();
  if (timed) print_times(&r, sys->m);
  for (int i = 0; i < r.npoint; i++) { /* neighbouring points of one kind make one row */
    check_jet(&e, &r.points[i], r.n);
    check_motion(&e, &r.points[i], sys);
    if (i + 1 < r.npoint && strcmp(r.points[i].kind, r.points[i + 1].kind) == 0) continue;
    if (table) print_row(sys, r.points[i].kind, &e);
    e = no_errors();
  }
  eom_system_destroy(sys);
  reference_free(&r);
  return faults ? EXIT_FAILURE : EXIT_SUCCESS;
}
