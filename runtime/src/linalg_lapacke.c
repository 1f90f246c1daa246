/* The dense linear algebra through LAPACKE.
 *
 * LAPACK's columns are our set of vectors; the lower triangle by rows is its upper triangle. Calls with sizes this code made cannot
 * fail but for a pivot of Cholesky. What is done to one vector is left to the core, whose arrays are the same: LAPACK would take longer
 * to begin, and OpenBLAS would wake its threads for it. */
#include "linalg.h"

#include "lapack.h"

#include <assert.h>
#include <string.h>

static void check(lapack_int info) {
  assert(info == 0);
  (void)info;
}

#define ONE_THREAD_BELOW 256

#ifdef EOM_HAVE_OPENBLAS
extern int openblas_get_num_threads(void);
extern void openblas_set_num_threads(int);

int eom_lapack_begin(int n) {
  const int threads = openblas_get_num_threads();
  if (n < ONE_THREAD_BELOW && threads > 1) openblas_set_num_threads(1);
  return threads;
}

void eom_lapack_end(int threads) {
  if (openblas_get_num_threads() != threads) openblas_set_num_threads(threads);
}
#else
int eom_lapack_begin(int n) { return n; }
void eom_lapack_end(int threads) { (void)threads; }
#endif

static int cholesky(int n, tl_real *a) {
  const int threads = eom_lapack_begin(n);
  const lapack_int info = LAPACK(potrf)(LAPACK_COL_MAJOR, 'U', n, a, n);
  eom_lapack_end(threads);
  assert(info >= 0);
  return (int)info;
}

static void solve_lower(int n, const tl_real *l, int k, tl_real *x) {
  if (k == 1) {
    eom_core_solve_lower(n, l, k, x);
    return;
  }
  const int threads = eom_lapack_begin(n);
  check(LAPACK(trtrs)(LAPACK_COL_MAJOR, 'U', 'T', 'N', n, k, l, n, x, n));
  eom_lapack_end(threads);
}

static void qr(int n, int m, tl_real *b, int *pivot, tl_real *tau, tl_real *work, int nwork) {
  const int threads = eom_lapack_begin(n);
  if (pivot) {
    memset(pivot, 0, (size_t)m * sizeof(int)); /* every column may be exchanged */
    check(LAPACK(geqp3)(LAPACK_COL_MAJOR, n, m, b, n, pivot, tau, work, nwork));
    for (int j = 0; j < m; j++) pivot[j]--;
  } else
    check(LAPACK(geqrf)(LAPACK_COL_MAJOR, n, m, b, n, tau, work, nwork));
  eom_lapack_end(threads);
}

const eom_linalg eom_linalg_lapacke = {.name = "lapacke",
                                       .cholesky = cholesky,
                                       .solve_lower = solve_lower,
                                       .solve_lower_transposed = eom_core_solve_lower_transposed,
                                       .qr = qr,
                                       .apply_qt = eom_core_apply_qt,
                                       .apply_q = eom_core_apply_q,
                                       .solve_upper = eom_core_solve_upper,
                                       .solve_upper_transposed = eom_core_solve_upper_transposed};
