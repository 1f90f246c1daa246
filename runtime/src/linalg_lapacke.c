/* The dense linear algebra through LAPACKE: the only file that includes it.
 *
 * LAPACK stores columns one after the other, which is our set of vectors; the lower triangle by rows is its upper triangle. The _work
 * functions allocate nothing. Calls with sizes this code made cannot fail but for a pivot of Cholesky. */
#include "linalg.h"

#include <assert.h>
#include <lapacke.h>
#include <string.h>

#if TL_REAL == TL_FLOAT
#define LAPACK(name) LAPACKE_s##name##_work
#else
#define LAPACK(name) LAPACKE_d##name##_work
#endif

static void check(lapack_int info) {
  assert(info == 0);
  (void)info;
}

/* OpenBLAS wakes its other threads for matrices of order 2 already (measured: 18 us for 0.2 us of work). It is kept to one thread
 * during a call up to this order, and given back what the program had set. */
#define ONE_THREAD_BELOW 256

#ifdef EOM_HAVE_OPENBLAS
extern int openblas_get_num_threads(void);
extern void openblas_set_num_threads(int);

static int begin(int n) {
  const int threads = openblas_get_num_threads();
  if (n < ONE_THREAD_BELOW && threads > 1) openblas_set_num_threads(1);
  return threads;
}

static void end(int threads) {
  if (openblas_get_num_threads() != threads) openblas_set_num_threads(threads);
}
#else
static int begin(int n) { return n; }
static void end(int threads) { (void)threads; }
#endif

static int cholesky(int n, tl_real *a) {
  const int threads = begin(n);
  const lapack_int info = LAPACK(potrf)(LAPACK_COL_MAJOR, 'U', n, a, n);
  end(threads);
  assert(info >= 0);
  return (int)info;
}

static void solve_lower(int n, const tl_real *l, int k, tl_real *x) {
  const int threads = begin(n);
  check(LAPACK(trtrs)(LAPACK_COL_MAJOR, 'U', 'T', 'N', n, k, l, n, x, n));
  end(threads);
}

static void solve_lower_transposed(int n, const tl_real *l, int k, tl_real *x) {
  const int threads = begin(n);
  check(LAPACK(trtrs)(LAPACK_COL_MAJOR, 'U', 'N', 'N', n, k, l, n, x, n));
  end(threads);
}

static void qr(int n, int m, tl_real *b, int *pivot, tl_real *tau, tl_real *work, int nwork) {
  const int threads = begin(n);
  if (pivot) {
    memset(pivot, 0, (size_t)m * sizeof(int)); /* every column may be exchanged */
    check(LAPACK(geqp3)(LAPACK_COL_MAJOR, n, m, b, n, pivot, tau, work, nwork));
    for (int j = 0; j < m; j++) pivot[j]--;
  } else
    check(LAPACK(geqrf)(LAPACK_COL_MAJOR, n, m, b, n, tau, work, nwork));
  end(threads);
}

static void apply_qt(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork) {
  if (r > 0) check(LAPACK(ormqr)(LAPACK_COL_MAJOR, 'L', 'T', n, 1, r, b, n, tau, x, n, work, nwork));
}

static void apply_q(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork) {
  if (r > 0) check(LAPACK(ormqr)(LAPACK_COL_MAJOR, 'L', 'N', n, 1, r, b, n, tau, x, n, work, nwork));
}

static void solve_upper(int n, int r, const tl_real *b, tl_real *x) {
  if (r > 0) check(LAPACK(trtrs)(LAPACK_COL_MAJOR, 'U', 'N', 'N', r, 1, b, n, x, r));
}

static void solve_upper_transposed(int n, int r, const tl_real *b, tl_real *x) {
  if (r > 0) check(LAPACK(trtrs)(LAPACK_COL_MAJOR, 'U', 'T', 'N', r, 1, b, n, x, r));
}

const eom_linalg eom_linalg_lapacke = {.name = "lapacke",
                                       .cholesky = cholesky,
                                       .solve_lower = solve_lower,
                                       .solve_lower_transposed = solve_lower_transposed,
                                       .qr = qr,
                                       .apply_qt = apply_qt,
                                       .apply_q = apply_q,
                                       .solve_upper = solve_upper,
                                       .solve_upper_transposed = solve_upper_transposed};
