/* Accelerations where the rows of A are nearly dependent, against quadruple precision: their error grows with the condition of A in the
 * mass metric, not with its square, which is what forming A M^-1 A' costs. Prints both. */
#include "close.h"
#include "constrained_models.h"
#include "kkt_truth.h"
#include "random.h"

#include "eom/eom.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { ROWS = 4, N = 7, TRIALS = 200 };

/* The error of qdd may be this many epsilons times the condition. */
#define ALLOWED 100

/* ---- linear algebra of the test's own ---- */

/* L L' = a in the lower triangle. Returns 0 where a pivot is not positive. */
static int cholesky(int n, double *a) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j <= i; j++) {
      double sum = a[i * n + j];
      for (int k = 0; k < j; k++) sum -= a[i * n + k] * a[j * n + k];
      if (i == j && !(sum > 0)) return 0;
      a[i * n + j] = i == j ? sqrt(sum) : sum / a[j * n + j];
    }
  return 1;
}

/* x = (L L')^-1 x. */
static void cholesky_solve(int n, const double *l, double *x) {
  for (int i = 0; i < n; i++) {
    for (int k = 0; k < i; k++) x[i] -= l[i * n + k] * x[k];
    x[i] /= l[i * n + i];
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int k = i + 1; k < n; k++) x[i] -= l[k * n + i] * x[k];
    x[i] /= l[i * n + i];
  }
}

/* k orthonormal vectors of n, by Gram and Schmidt twice. */
static void orthonormal(rng *r, int k, int n, double *v) {
  for (int i = 0; i < k; i++) {
    double *x = v + i * n;
    for (int j = 0; j < n; j++) x[j] = rng_uniform(r, -1, 1);
    for (int pass = 0; pass < 2; pass++)
      for (int other = 0; other < i; other++) {
        double along = 0;
        for (int j = 0; j < n; j++) along += x[j] * v[other * n + j];
        for (int j = 0; j < n; j++) x[j] -= along * v[other * n + j];
      }
    double length = 0;
    for (int j = 0; j < n; j++) length += x[j] * x[j];
    for (int j = 0; j < n; j++) x[j] /= sqrt(length);
  }
}

/* ---- equations of a given condition ---- */

/* M = L L' with a condition of some tens, A = U diag(1 .. 1/condition) V' L': A L^-T has that condition. */
static void make_equations(rng *r, double condition, eom_system *sys) {
  double L[N][N] = {{0}}, U[ROWS * ROWS], V[ROWS * N], B[ROWS][N] = {{0}};
  for (int i = 0; i < N; i++)
    for (int j = 0; j <= i; j++) L[i][j] = i == j ? 1 + rng_uniform(r, 0, 1) : rng_uniform(r, -0.5, 0.5);
  orthonormal(r, ROWS, ROWS, U);
  orthonormal(r, ROWS, N, V);
  for (int k = 0; k < ROWS; k++) {
    const double sigma = pow(condition, -(double)k / (ROWS - 1));
    for (int i = 0; i < ROWS; i++)
      for (int j = 0; j < N; j++) B[i][j] += U[k * ROWS + i] * sigma * V[k * N + j];
  }
  memset(sys->M, 0, N * N * sizeof *sys->M);
  memset(sys->A, 0, ROWS * N * sizeof *sys->A);
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      for (int k = 0; k <= i && k <= j; k++) sys->M[i * N + j] += L[i][k] * L[j][k];
      for (int row = 0; row < ROWS && j <= i; row++) sys->A[row * N + i] += B[row][j] * L[i][j];
    }
  for (int i = 0; i < N; i++) sys->Q[i] = rng_uniform(r, -1, 1);
  for (int i = 0; i < ROWS; i++) sys->b[i] = rng_uniform(r, -1, 1);
}

/* qdd through A M^-1 A', formed and factored. Not finite where that is not positive definite any more. */
static void by_forming(const eom_system *sys, double *qdd) {
  double L[N * N], X[ROWS][N], S[ROWS * ROWS], free[N], z[ROWS];
  memcpy(L, sys->M, sizeof L);
  assert_true(cholesky(N, L));
  memcpy(free, sys->Q, sizeof free);
  cholesky_solve(N, L, free);
  memcpy(X, sys->A, sizeof X);
  for (int i = 0; i < ROWS; i++) cholesky_solve(N, L, X[i]);
  for (int i = 0; i < ROWS; i++) {
    z[i] = sys->b[i];
    for (int k = 0; k < N; k++) z[i] -= sys->A[i * N + k] * free[k];
    for (int j = 0; j < ROWS; j++) {
      S[i * ROWS + j] = 0;
      for (int k = 0; k < N; k++) S[i * ROWS + j] += sys->A[i * N + k] * X[j][k];
    }
  }
  if (cholesky(ROWS, S))
    cholesky_solve(ROWS, S, z);
  else
    z[0] = (double)INFINITY;
  for (int k = 0; k < N; k++) {
    qdd[k] = free[k];
    for (int i = 0; i < ROWS; i++) qdd[k] += X[i][k] * z[i];
  }
}

static double error_of(const double *x, const double *truth) {
  double error = 0, size = 0;
  for (int i = 0; i < N; i++) {
    const double miss = fabs(x[i] - truth[i]);
    error = miss <= error ? error : miss;
    size = fmax(size, fabs(truth[i]));
  }
  return error / size;
}

static int coordinates(const void *params) {
  (void)params;
  return N;
}
static int rows(const void *params) {
  (void)params;
  return ROWS;
}

static void error_grows_with_the_condition(void **state) {
  (void)state;
  eom_function row = cartesian_pendulum.holonomic[0];
  row.rows = rows;
  eom_model model = cartesian_pendulum; /* for its sizes alone: M, Q, A and b are made here */
  model.dof = coordinates;
  model.holonomic = &row;
  eom_system *sys;
  assert_int_equal(eom_system_create(&sys, &model, NULL, NULL), EOM_OK);
  rng r = {2026};
  print_message("worst relative error of qdd of %d random equations, n = %d, m = %d\n", TRIALS, N, ROWS);
  print_message("condition of A   eom_solve  in eps*condition   A M^-1 A' formed  in eps*condition\n");
  for (double condition = 1; condition < 2e7; condition *= 10) {
    double ours = 0, formed = 0, report = 0;
    for (int k = 0; k < TRIALS; k++) {
      double truth[N + ROWS], qdd[N];
      make_equations(&r, condition, sys);
      kkt_truth(N, ROWS, sys->M, sys->A, sys->Q, sys->b, truth);
      assert_int_equal(eom_solve(sys), EOM_OK);
      assert_int_equal(sys->report.rank, ROWS);
      by_forming(sys, qdd);
      ours = fmax(ours, error_of(sys->qdd, truth));
      const double other = error_of(qdd, truth);
      formed = other <= formed ? formed : other;
      report = fmax(report, sys->report.condition);
    }
    const double unit = DBL_EPSILON * condition;
    print_message("%14.0e  %10.1e  %16.1f  %17.1e  %16.1f\n", condition, ours, ours / unit, formed, formed / unit);
    assert_true(ours <= ALLOWED * unit);
    assert_true(report <= 10 * condition); /* of rows that are brought to one length first */
  }
  eom_system_destroy(sys);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(error_grows_with_the_condition)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
