/* Times libtaylor's header-only kernels beside what a library does for the same: LDL' of constant size beside LAPACK's Cholesky, sines
 * and cosines of arrays beside libm's, row prefixes beside a plain loop. bench/kernels/run builds and runs it.
 *
 * Each figure is the least of REPEATS slices. Throughput: matrices that do not depend on each other, some of them at a time in flight.
 * Latency: a number of each matrix depends on the last solution. Both ways copy the matrix first, for it is factored in place. */
#define _POSIX_C_SOURCE 200809L
#include <cblas.h>
#include <lapacke.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "taylor/ldl.h"
#include "taylor/row.h"
#include "taylor/sincos_array.h"

#ifdef QUICK /* does it run */
enum { REPEATS = 2, SLICE = 1000 };
#else
enum { REPEATS = 25, SLICE = 200000 /* ns */ };
#endif
enum { STATES = 8, LARGEST = 256, LD = TL_LDL_ROW(LARGEST), MANY = 2 * LARGEST };

/* Of one state: M (upper triangle, row length ld), b, x, and n x k right-hand sides. */
typedef struct state {
  double m[LARGEST * LD], w[LARGEST * LD], d[TL_LDL_DIAGONAL(LARGEST)], b[LD], x[LD], many[LARGEST * MANY];
} state;

static state states[STATES];

typedef void task(state *z, double change);

typedef struct tasks {
  int n;
  task *factor_solve, *solve, *solve_many;
} tasks;

/* As a caller has them: in vectors, row by row from the one that holds the diagonal; where all is scalar, number by number. */
TL_INLINE void copy_matrix(int n, int ld, state *z, double change) {
#if TL_VECTORS
  for (int i = 0; n > TL_LDL_SCALAR && i < n; i++)
    for (int j = i / 4 * 4; j < ld; j += 4) TL_V4(z->w + i * ld + j) = TL_V4_CONST(z->m + i * ld + j) + change;
  if (n > TL_LDL_SCALAR) return;
#endif
  TL_UNROLL for (int i = 0; i < n; i++) TL_UNROLL for (int j = i; j < n; j++) z->w[i * ld + j] = z->m[i * ld + j] + change;
}

#define OURS(n)                                                                                                                        \
  static void factor_solve_##n(state *z, double change) {                                                                              \
    copy_matrix(n, TL_LDL_ROW(n), z, change);                                                                                          \
    (void)tl_ldl_factor_solve(n, z->x, z->w, TL_LDL_ROW(n), z->d, z->b);                                                               \
  }                                                                                                                                    \
  static void solve_##n(state *z, double change) {                                                                                     \
    z->b[0] += change;                                                                                                                 \
    tl_ldl_solve(n, z->x, z->w, TL_LDL_ROW(n), z->d, z->b);                                                                            \
  }                                                                                                                                    \
  static void solve_many_##n(state *z, double change) {                                                                                \
    z->many[0] += change;                                                                                                              \
    tl_ldl_solve_many(n, 2 * n, z->many, TL_ROW(2 * n), z->w, TL_LDL_ROW(n), z->d);                                                    \
    z->x[0] = z->many[0];                                                                                                              \
  }
#ifdef QUICK
#define SIZES(X) X(2) X(9)
#else
#define SIZES(X)                                                                                                                       \
  X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(10) X(12) X(14) X(16) X(20) X(24) X(32) X(48) X(64) X(96) X(128) X(192) X(256)
#endif
SIZES(OURS)
#define ENTRY(n) {n, factor_solve_##n, solve_##n, solve_many_##n},
static const tasks ours[] = {SIZES(ENTRY)};
enum { NSIZE = sizeof ours / sizeof *ours };

/* LAPACK: a row-major upper triangle is a column-major lower one, so that nothing is transposed; the _work functions check nothing.
 * Many right-hand sides in rows are for BLAS, which knows row-major. */
static int size;

static void lapack_factor_solve(state *z, double change) {
  const int ld = TL_LDL_ROW(size);
  for (int i = 0; i < size; i++)
    for (int j = i; j < size; j++) z->w[i * ld + j] = z->m[i * ld + j] + change;
  memcpy(z->x, z->b, (size_t)size * sizeof(double));
  if (LAPACKE_dpotrf_work(LAPACK_COL_MAJOR, 'L', size, z->w, ld) != 0) abort();
  LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', size, 1, z->w, ld, z->x, size);
}

static void lapack_solve(state *z, double change) {
  memcpy(z->x, z->b, (size_t)size * sizeof(double));
  z->x[0] += change;
  LAPACKE_dpotrs_work(LAPACK_COL_MAJOR, 'L', size, 1, z->w, TL_LDL_ROW(size), z->x, size);
}

static void blas_solve_many(state *z, double change) {
  const int ld = TL_LDL_ROW(size), k = 2 * size, ldb = TL_ROW(k);
  z->many[0] += change;
  cblas_dtrsm(CblasRowMajor, CblasLeft, CblasUpper, CblasTrans, CblasNonUnit, size, k, 1.0, z->w, ld, z->many, ldb);
  cblas_dtrsm(CblasRowMajor, CblasLeft, CblasUpper, CblasNoTrans, CblasNonUnit, size, k, 1.0, z->w, ld, z->many, ldb);
  z->x[0] = z->many[0];
}

static const tasks lapack = {0, lapack_factor_solve, lapack_solve, blas_solve_many};

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

/* Least time of one call, ns. */
static double measure(task *f, int chained) {
  double least = INFINITY;
  long calls = STATES;
  for (int repeat = 0; repeat < REPEATS; repeat++) {
    double change = 0.0;
    const double start = now();
    for (long k = 0; k < calls; k++) {
      state *z = &states[k % STATES];
      f(z, change);
      if (chained) change = 1e-300 * z->x[0];
    }
    const double elapsed = now() - start;
    least = fmin(least, elapsed / (double)calls);
    if (elapsed < SLICE / 2) repeat = -1, calls *= 2, least = INFINITY;
  }
  return least;
}

/* A matrix with eigenvalues from about n/2 to 3n/2, and right-hand sides. */
static void fill(int n) {
  const int ld = TL_LDL_ROW(n);
  srand(1);
  for (int s = 0; s < STATES; s++) {
    state *z = &states[s];
    for (int i = 0; i < n * ld; i++) z->m[i] = rand() / (double)RAND_MAX - 0.5;
    for (int i = 0; i < n; i++) z->m[i * ld + i] = n, z->b[i] = rand() / (double)RAND_MAX;
    for (int i = 0; i < n * TL_ROW(2 * n); i++) z->many[i] = i % 7;
  }
}

/* |b - M x|, largest. */
static double residual(int n, const state *z) {
  const int ld = TL_LDL_ROW(n);
  double largest = 0.0;
  for (int i = 0; i < n; i++) {
    double sum = z->b[i];
    for (int j = 0; j < n; j++) sum -= z->m[i < j ? i * ld + j : j * ld + i] * z->x[j];
    largest = fmax(largest, fabs(sum));
  }
  return largest;
}

static void compare_solvers(void) {
  int from[3] = {0, 0, 0};
  printf("LDL' and LAPACK's Cholesky, ns; k = 2n right-hand sides\n%4s | %33s | %15s | %17s | %s\n", "", "factor and solve  (latency)",
         "one more", "k more", "residual");
  printf("%4s | %8s %8s %7s %7s | %7s %7s | %8s %8s |\n", "n", "LDL'", "", "LAPACK", "", "LDL'", "LAPACK", "LDL'", "BLAS");
  for (int s = 0; s < NSIZE; s++) {
    const int n = size = ours[s].n;
    double time[2][4];
    fill(n);
    ours[s].factor_solve(&states[0], 0.0);
    const double error = residual(n, &states[0]);
    for (int who = 0; who < 2; who++) {
      const tasks *t = who == 0 ? &ours[s] : &lapack;
      time[who][0] = measure(t->factor_solve, 0);
      time[who][1] = measure(t->factor_solve, 1);
      time[who][2] = measure(t->solve, 1);
      time[who][3] = measure(t->solve_many, 1);
    }
    printf("%4d | %8.1f %8.1f %7.0f %7.0f | %7.1f %7.0f | %8.1f %8.0f | %.1e\n", n, time[0][0], time[0][1], time[1][0], time[1][1],
           time[0][2], time[1][2], time[0][3], time[1][3], error);
    const int column[3] = {0, 2, 3};
    for (int k = 0; k < 3; k++) {
      if (time[0][column[k]] <= time[1][column[k]])
        from[k] = 0;
      else if (from[k] == 0)
        from[k] = n;
    }
  }
  const char *what[3] = {"to factor and solve", "for one more right-hand side", "for 2n more"};
  for (int k = 0; k < 3; k++) {
    if (from[k] == 0)
      printf("LAPACK is not faster up to n = %d %s.\n", ours[NSIZE - 1].n, what[k]);
    else
      printf("LAPACK is faster from n = %d on %s.\n", from[k], what[k]);
  }
}

/* ---- sines and cosines, rows ---- */
static int length;

/* As a vector, for it is read as one: a processor waits where a vector is read of which a number has just been written. */
TL_INLINE void change_first(state *z, double change) {
#if TL_VECTORS
  TL_V4(z->b) += change;
#else
  z->b[0] += change;
#endif
}

#define SINCOS(n)                                                                                                                      \
  static void sincos_##n(state *z, double change) {                                                                                    \
    change_first(z, change);                                                                                                           \
    tl_sincos_array(n, z->b, z->x, z->d);                                                                                              \
  }
#define LENGTHS(X) X(1) X(2) X(3) X(4) X(6) X(8) X(12) X(16) X(32) X(64)
LENGTHS(SINCOS)
#define LENGTH(n) {n, sincos_##n},
static const struct {
  int n;
  task *f;
} lengths[] = {LENGTHS(LENGTH)};

static void libm_sincos(state *z, double change) {
  z->b[0] += change;
  for (int i = 0; i < length; i++) z->x[i] = sin(z->b[i]), z->d[i] = cos(z->b[i]);
}

static void row_prefix(state *z, double change) { tl_row_add_prefix(z->x, z->b, 1e-9 + change, length); }

static void row_loop(state *z, double change) {
  const double m = 1e-9 + change;
  for (int j = 0; j < length; j++) z->x[j] += m * z->b[j];
}

static void compare_arrays(void) {
  printf("\nsines and cosines, and d += m x, ns of n numbers\n%4s | %8s %8s %8s | %8s %8s\n", "n", "array", "latency", "libm", "row",
         "loop");
  for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
    length = lengths[k].n;
    fill(length);
    printf("%4d | %8.1f %8.1f %8.1f |", length, measure(lengths[k].f, 0), measure(lengths[k].f, 1), measure(libm_sincos, 0));
    printf(" %8.1f %8.1f\n", measure(row_prefix, 0), measure(row_loop, 0));
  }
}

int main(void) {
  compare_solvers();
  compare_arrays();
  return 0;
}
