/* The dense linear algebra: defining identities of each factorisation, and the two implementations against each other. */
#include "close.h"
#include "random.h"

#include "linalg.h"

#include <math.h>
#include <string.h>

#define MOST 40
#define WORK 8192

/* Rounding of a factorisation of order 40 of numbers near 1. Measured below 2e-14. */
#define FACTOR_TOLERANCE 1e-12

static double random_matrix[MOST * MOST];

static void fill(rng *r, double *a, int count) {
  for (int i = 0; i < count; i++) a[i] = rng_uniform(r, -1, 1);
}

/* a = X X' + 1/10. */
static void fill_positive(rng *r, int n, double *a) {
  fill(r, random_matrix, n * n);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      a[i * n + j] = i == j ? 0.1 : 0.0;
      for (int k = 0; k < n; k++) a[i * n + j] += random_matrix[i * n + k] * random_matrix[j * n + k];
    }
}

static void check_cholesky(const eom_linalg *la, int n) {
  rng r = {(uint64_t)n};
  static double a[MOST * MOST], l[MOST * MOST], x[2 * MOST], b[2 * MOST];
  fill_positive(&r, n, a);
  memcpy(l, a, sizeof a);
  assert_int_equal(la->cholesky(n, l), 0);
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      double sum = 0;
      for (int k = 0; k <= j; k++) sum += l[i * n + k] * l[j * n + k];
      assert_close(sum, a[i * n + j], 0, FACTOR_TOLERANCE * n);
    }
  fill(&r, b, 2 * n);
  memcpy(x, b, sizeof b);
  la->solve_lower(n, l, 2, x);
  la->solve_lower_transposed(n, l, 2, x);
  for (int v = 0; v < 2; v++)
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int j = 0; j < n; j++) sum += a[i * n + j] * x[v * n + j];
      assert_close(sum, b[v * n + i], 0, FACTOR_TOLERANCE * 100);
    }
}

/* Q R P' gives B back, Q is orthogonal, pivots fall. */
static void check_qr(const eom_linalg *la, int n, int m, int exchange) {
  rng r = {(uint64_t)(100 * n + m)};
  static double b[MOST * MOST], f[MOST * MOST], tau[MOST], work[WORK], x[MOST];
  int pivot[MOST];
  const int least = n < m ? n : m;
  assert_true(eom_linalg_work(n, m) <= WORK);
  fill(&r, b, n * m);
  if (m > 2)
    for (int i = 0; i < n; i++) b[2 * n + i] = b[i] - 2 * b[n + i]; /* a dependent vector */
  memcpy(f, b, sizeof b);
  for (int j = 0; j < m; j++) pivot[j] = j;
  la->qr(n, m, f, exchange ? pivot : NULL, tau, work, eom_linalg_work(n, m));
  for (int j = 0; j < m; j++) {
    memset(x, 0, sizeof x);
    for (int i = 0; i <= j && i < n; i++) x[i] = f[j * n + i];
    la->apply_q(n, least, f, tau, x, work, WORK);
    assert_all_close(x, b + pivot[j] * n, n, 0, FACTOR_TOLERANCE);
    if (exchange && j > 0 && j < least) assert_true(fabs(f[j * n + j]) <= fabs(f[(j - 1) * n + j - 1]) * (1 + 1e-12));
  }
  if (exchange && m > 2 && m <= n) assert_true(fabs(f[(m - 1) * n + m - 1]) < FACTOR_TOLERANCE);
  double y[MOST], back[MOST];
  fill(&r, y, n);
  memcpy(back, y, sizeof y);
  la->apply_qt(n, least, f, tau, back, work, WORK);
  la->apply_q(n, least, f, tau, back, work, WORK);
  assert_all_close(back, y, n, 0, FACTOR_TOLERANCE);
}

/* R x and R' x give the right-hand side back. */
static void check_upper(const eom_linalg *la, int n, int r_order) {
  rng r = {(uint64_t)(n + 7)};
  static double f[MOST * MOST], tau[MOST], work[WORK];
  double x[MOST], b[MOST];
  int pivot[MOST];
  fill(&r, f, n * n);
  la->qr(n, n, f, pivot, tau, work, WORK);
  for (int transposed = 0; transposed < 2; transposed++) {
    fill(&r, b, r_order);
    memcpy(x, b, sizeof b);
    (transposed ? la->solve_upper_transposed : la->solve_upper)(n, r_order, f, x);
    for (int i = 0; i < r_order; i++) {
      double sum = 0;
      for (int j = 0; j < r_order; j++)
        if (transposed ? j <= i : j >= i) sum += (transposed ? f[i * n + j] : f[j * n + i]) * x[j];
      assert_close(sum, b[i], 0, FACTOR_TOLERANCE * 1000);
    }
  }
}

static void check_all(const eom_linalg *la) {
  for (int n = 1; n <= MOST; n = n * 2 + 1) {
    check_cholesky(la, n);
    check_upper(la, n, (n + 1) / 2);
    for (int m = 1; m <= MOST; m = m * 3 + 1) {
      check_qr(la, n, m, 0);
      check_qr(la, n, m, 1);
    }
  }
  double indefinite[9] = {2, 0, 0, 0, -1, 0, 0, 0, 3};
  assert_int_equal(la->cholesky(3, indefinite), 2);
}

static void core(void **state) {
  (void)state;
  check_all(&eom_linalg_core);
}

#ifdef EOM_HAVE_LAPACKE
static void lapacke(void **state) {
  (void)state;
  check_all(&eom_linalg_lapacke);
}

/* The factors are unique but for signs, which both choose alike; without ties the exchanges are the same too. */
static void alike(void **state) {
  (void)state;
  static double a[2][MOST * MOST], tau[2][MOST], work[WORK];
  int pivot[2][MOST];
  const eom_linalg *la[2] = {&eom_linalg_core, &eom_linalg_lapacke};
  for (int n = 2; n <= MOST; n += 6) {
    const int m = n / 2 + 1;
    for (int k = 0; k < 2; k++) {
      rng r = {(uint64_t)n};
      fill(&r, a[k], n * m);
      la[k]->qr(n, m, a[k], pivot[k], tau[k], work, WORK);
    }
    for (int j = 0; j < m; j++) assert_int_equal(pivot[0][j], pivot[1][j]);
    assert_all_close(a[0], a[1], n * m, 0, FACTOR_TOLERANCE);
    assert_all_close(tau[0], tau[1], m, 0, FACTOR_TOLERANCE);
    for (int k = 0; k < 2; k++) {
      rng r = {(uint64_t)n};
      fill_positive(&r, n, a[k]);
      assert_int_equal(la[k]->cholesky(n, a[k]), 0);
    }
    for (int i = 0; i < n; i++) assert_all_close(a[0] + i * n, a[1] + i * n, i + 1, 0, FACTOR_TOLERANCE * 10);
  }
}
#endif

/* Lengths whose squares overflow or vanish. */
static void extreme_lengths(void **state) {
  (void)state;
  const double scales[] = {1e-300, 1e-170, 1e170, 1e300};
  for (int s = 0; s < 4; s++) {
    double b[4] = {3 * scales[s], 4 * scales[s], 4 * scales[s], 3 * scales[s]}, tau[2];
    int pivot[2];
    eom_linalg_core.qr(2, 2, b, pivot, tau, NULL, 0);
    assert_close(fabs(b[0]), 5 * scales[s], 1e-14, 0);
    assert_close(fabs(b[3]), 1.4 * scales[s], 1e-13, 0); /* |9 - 16|/5 */
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(core), cmocka_unit_test(extreme_lengths),
#ifdef EOM_HAVE_LAPACKE
                                     cmocka_unit_test(lapacke), cmocka_unit_test(alike)
#endif
  };
  return cmocka_run_group_tests_name("linalg", tests, NULL, NULL);
}
