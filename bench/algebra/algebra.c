/* Times libtaylor's operations on jets, shape by shape, beside the multiply-adds that the shape's product takes at the processor's
 * peak, and beside rivals. bench/algebra/run builds and runs it: algebra CSV [RIVAL.so[=ARGUMENT]..]
 *
 * Each result is compared with libtaylor's, which the tests check, before its time counts; one that is off has none, and the program
 * fails. All contenders of a cell take turns, REPEATS times a slice each; the table shows minima, the CSV file medians too. */
#define _POSIX_C_SOURCE 200809L
#include "contender.h"
#include "taylor/taylor.h"

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#ifdef QUICK /* does it run */
enum { REPEATS = 2 };
static const double SLICE = 2e-5; /* s */
#else
enum { REPEATS = 15 };
static const double SLICE = 1e-3;
#endif
enum { MOST_RIVALS = 4 };

/* Rivals sum in another order: errors of some hundred roundings, seen from the largest coefficient. */
static const double TOLERANCE = 1e-10;

static const struct {
  const char *name;
  tl_spec spec;
} SHAPES[] = {
#ifdef QUICK
    {"J(8)", {0, 8, 1}}, {"H(8)", {0, 8, 2}}, {"T3(8)", {0, 8, 3}}, {"T(1,6)", {6, 0, 0}}, {"{1,s}x8", {1, 8, 1}},
#else
    {"J(8)", {0, 8, 1}},         {"J(32)", {0, 32, 1}},      {"H(8)", {0, 8, 2}},     {"H(32)", {0, 32, 2}},   {"T3(8)", {0, 8, 3}},
    {"T3(16)", {0, 16, 3}},      {"T(1,6)", {6, 0, 0}},      {"T(1,12)", {12, 0, 0}}, {"T(1,20)", {20, 0, 0}}, {"T(2,12)", {0, 2, 12}},
    {"T(4,6)", {0, 4, 6}},       {"T(8,4)", {0, 8, 4}},      {"T(8,6)", {0, 8, 6}},   {"{1,s}x8", {1, 8, 1}},  {"{1,s}x32", {1, 32, 1}},
    {"{1,s,s2}x16", {2, 16, 1}}, {"{1..s12}x4", {12, 4, 1}},
#endif
};
enum { NSHAPE = sizeof SHAPES / sizeof *SHAPES };

static const struct {
  const char *name;
  int operands, products; /* jets it takes; products of jets that its recurrence takes */
} OPERATIONS[ALGEBRA_OPERATIONS] = {{"mul", 2, 1}, {"div", 2, 1}, {"sqrt", 1, 1}, {"exp", 1, 1}, {"sincos", 1, 2}, {"pow", 1, 1}};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void *allocate(size_t bytes) {
  void *memory = aligned_alloc(64, (bytes + 64) / 64 * 64);
  if (memory == NULL) abort();
  memset(memory, 0, (bytes + 64) / 64 * 64);
  return memory;
}

/* Multiply-adds per nanosecond of as many independent sums as hide the latency, in the widest vectors. */
static double peak(void) {
  enum { SUMS = 12, ROUNDS = 20000 };
  typedef double vector __attribute__((vector_size(64)));
  static volatile double start = 1.0;
  double best = HUGE_VAL;
  for (int k = 0; k < REPEATS; k++) {
    vector sum[SUMS];
    const vector x = start - (vector){0}, y = 1e-9 * x;
    for (int i = 0; i < SUMS; i++) sum[i] = (double)i * x;
    const double begin = now();
    for (int r = 0; r < ROUNDS; r++)
#pragma GCC unroll 12
      for (int i = 0; i < SUMS; i++) sum[i] = sum[i] * y + x;
    const double lasted = now() - begin;
    for (int i = 1; i < SUMS; i++) sum[0] += sum[i];
    start = sum[0][0] > 0.0 ? 1.0 : 2.0;
    best = fmin(best, lasted);
  }
  return 8.0 * SUMS * ROUNDS / (1e9 * best);
}

/* Pairs of monomials whose product is in the shape. */
static double product_size(const tl_shape *s) {
  double pairs = 0.0;
  for (int p = 0; p <= s->order; p++)
    for (int q = 0; p + q <= s->order; q++) pairs += (double)s->nhom[p] * (double)s->nhom[q];
  return pairs * (s->curve + 1) * (s->curve + 2) / 2;
}

/* libtaylor as a contender. */
static tl_ctx context;
static tl_real *ours_result;
static const algebra_task *ours_task;

static int ours_prepare(const algebra_task *task) {
  ours_task = task;
  return 0;
}

static void ours_run(void) {
  const double *a = ours_task->a, *b = ours_task->b;
  switch (ours_task->operation) {
  case ALGEBRA_MUL:
    tl_mul(&context, ours_result, a, b);
    break;
  case ALGEBRA_DIV:
    tl_div(&context, ours_result, a, b);
    break;
  case ALGEBRA_SQRT:
    tl_sqrt(&context, ours_result, a);
    break;
  case ALGEBRA_EXP:
    tl_exp(&context, ours_result, a);
    break;
  case ALGEBRA_SINCOS:
    tl_sincos(&context, ours_result, ours_result + context.shape->ncoef, a);
    break;
  default:
    tl_powc(&context, ours_result, a, ALGEBRA_EXPONENT);
  }
}

static double ours_difference(const double *c) {
  (void)c;
  return context.status.bits == TL_OK ? 0.0 : HUGE_VAL;
}

/* One contender in one cell of the table. */
typedef struct entry {
  algebra_contender contender;
  double error, times[REPEATS]; /* ns */
  long calls;                   /* in a slice */
} entry;

static double duration(const entry *e, long calls) {
  const double begin = now();
  for (long k = 0; k < calls; k++) e->contender.run();
  return now() - begin;
}

/* Calls that fill a slice; doubled until half of it is measured, which also warms all up. */
static void calibrate(entry *e) {
  double lasted;
  for (e->calls = 1; (lasted = duration(e, e->calls)) < SLICE / 2; e->calls *= 2) continue;
  e->calls = (long)fmax(1.0, (double)e->calls * SLICE / lasted);
}

static int ascending(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static int disagreements; /* results that were off */

/* Moves the contenders that can do the task, and do it right, to the front; their number. */
static int select_entries(entry *entries, int count, const algebra_task *task, const double *expected) {
  int chosen = 0;
  for (int i = 0; i < count; i++) {
    entry e = entries[i];
    if (e.contender.prepare(task) != 0) continue;
    e.contender.run();
    e.error = e.contender.difference(expected);
    if (e.error <= TOLERANCE) {
      entries[chosen++] = e;
    } else {
      fprintf(stderr, "%s is %.2g off in operation %s\n", e.contender.name, e.error, OPERATIONS[task->operation].name);
      disagreements++;
    }
  }
  return chosen;
}

static void race(entry *entries, int count) {
  for (int i = 0; i < count; i++) calibrate(&entries[i]);
  for (int k = 0; k < REPEATS; k++)
    for (int i = 0; i < count; i++) {
      (void)duration(&entries[i], entries[i].calls / 16 + 1);
      entries[i].times[k] = 1e9 * duration(&entries[i], entries[i].calls) / (double)entries[i].calls;
    }
  for (int i = 0; i < count; i++) qsort(entries[i].times, REPEATS, sizeof(double), ascending);
}

/* Coefficients as a computation has them: those of higher order are smaller, and none is zero. */
static void draw(const tl_shape *s, const int *exponents, double *jet, double value, unsigned seed) {
  for (int i = 0; i < s->ncoef; i++) {
    seed = seed * 1664525u + 1013904223u;
    double size = 0.25 + 0.5 * (double)(seed >> 8) / 16777216.0;
    for (int v = 0; v <= s->nvar; v++)
      for (int e = 0; e < exponents[i * (s->nvar + 1) + v]; e++) size *= 0.5 / (s->nvar + 1);
    jet[i] = seed & 128u ? size : -size;
  }
  jet[0] = value;
}

static int *list_exponents(const tl_shape *s) {
  int *exponents = allocate((size_t)s->ncoef * (size_t)(s->nvar + 1) * sizeof(int));
  for (int i = 0; i < s->ncoef; i++) tl_monomial(s, i, &exponents[i * (s->nvar + 1)], &exponents[i * (s->nvar + 1) + 1]);
  return exponents;
}

/* One row of the table: libtaylor's time, its share of the peak, and the rivals' times over it. */
static void print_row(FILE *csv, int shape, int operation, const entry *entries, int count, const algebra_contender *rivals, int nrival,
                      double multiply_adds, double top) {
  printf("%-12s %-7s %9.0f", SHAPES[shape].name, OPERATIONS[operation].name, multiply_adds);
  const double ours = count > 0 ? entries[0].times[0] : HUGE_VAL;
  printf(" %10.1f %7.1f%%", ours, 100.0 * multiply_adds / ours / top);
  for (int k = 0; k < nrival; k++) {
    const entry *found = NULL;
    for (int i = 1; i < count; i++)
      if (strcmp(entries[i].contender.name, rivals[k].name) == 0) found = &entries[i];
    if (found)
      printf(" %7.1fx", found->times[0] / ours);
    else
      printf(" %8s", "-");
  }
  printf("\n");
  for (int i = 0; i < count; i++)
    fprintf(csv, "\"%s\",%s,%s,%.0f,%.2f,%.2f,%d,%.2g\n", SHAPES[shape].name, OPERATIONS[operation].name, entries[i].contender.name,
            multiply_adds, entries[i].times[0], entries[i].times[REPEATS / 2], REPEATS, entries[i].error);
}

static void run_shape(FILE *csv, int which, const algebra_contender *rivals, int nrival, double top) {
  tl_shape shape;
  const size_t bytes = tl_shape_bytes(SHAPES[which].spec);
  void *tables = allocate(bytes);
  if (tl_shape_init(&shape, SHAPES[which].spec, tables, bytes) != 0) abort();
  const size_t n = (size_t)shape.ncoef, numbers = tl_ctx_size(&shape, 6);
  tl_real *memory = allocate(numbers * sizeof(tl_real));
  tl_ctx_init(&context, &shape, memory, numbers);
  int *exponents = list_exponents(&shape);
  double *a = tl_push(&context, 1), *b = tl_push(&context, 1), *expected = tl_push(&context, 2);
  ours_result = tl_push(&context, 2);
  draw(&shape, exponents, a, 1.3, 1);
  draw(&shape, exponents, b, 0.7, 2);
  for (int operation = 0; operation < ALGEBRA_OPERATIONS; operation++) {
    const algebra_task task = {&shape, exponents, operation, a, OPERATIONS[operation].operands == 2 ? b : NULL};
    entry entries[MOST_RIVALS + 1] = {{.contender = {"libtaylor", ours_prepare, ours_run, ours_difference}}};
    for (int i = 0; i < nrival; i++) entries[i + 1].contender = rivals[i];
    ours_prepare(&task);
    ours_run();
    memcpy(expected, ours_result, 2 * n * sizeof *expected);
    const int count = select_entries(entries, nrival + 1, &task, expected);
    race(entries, count);
    print_row(csv, which, operation, entries, count, rivals, nrival, OPERATIONS[operation].products * product_size(&shape), top);
  }
  free(exponents);
  free(memory);
  free(tables);
}

static void open_rival(const char *text, algebra_contender *rival) {
  char path[4096];
  const char *argument = strchr(text, '=');
  snprintf(path, sizeof path, "%.*s", argument ? (int)(argument - text) : (int)strlen(text), text);
  void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL), *symbol = library ? dlsym(library, "algebra_open") : NULL;
  algebra_open_function *start;
  memcpy(&start, &symbol, sizeof start);
  if (symbol == NULL || start(argument ? argument + 1 : "", rival) != 0) {
    fprintf(stderr, "cannot open %s\n", text);
    exit(1);
  }
}

int main(int argc, char **argv) {
  algebra_contender rivals[MOST_RIVALS];
  const int nrival = argc - 2;
  FILE *csv = nrival >= 0 && nrival <= MOST_RIVALS ? fopen(argv[1], "w") : NULL;
  if (csv == NULL) {
    fprintf(stderr, "usage: algebra CSV [RIVAL.so[=ARGUMENT]..]\n");
    return 2;
  }
  for (int i = 0; i < nrival; i++) open_rival(argv[i + 2], &rivals[i]);
  const double top = peak();
  printf("peak: %.1f multiply-adds per ns\n%-12s %-7s %9s %10s %8s", top, "shape", "", "mul-adds", "ns", "of peak");
  for (int i = 0; i < nrival; i++) printf(" %8s", rivals[i].name);
  printf("\n");
  fprintf(csv, "shape,operation,contender,multiply_adds,min_ns,median_ns,repeats,check_error\n");
  for (int i = 0; i < NSHAPE; i++) run_shape(csv, i, rivals, nrival, top);
  return fclose(csv) == 0 && disagreements == 0 ? 0 : 1;
}
