/* Small dense linear algebra in plain C11: Cholesky, Householder QR with column exchange, triangular solves. */
#include "linalg.h"

#include <stddef.h>

#define LANES 8 /* partial sums: one vector register of them, so that a compiler need not keep the order of one long sum */

static tl_real dot(int n, const tl_real *a, const tl_real *b) {
  tl_real sum = TL_C(0.0);
  int i = 0;
  if (n >= 2 * LANES) {
    tl_real part[LANES] = {TL_C(0.0)};
    for (; i + LANES <= n; i += LANES)
      for (int k = 0; k < LANES; k++) part[k] += a[i + k] * b[i + k];
    for (int k = 0; k < LANES; k++) sum += part[k];
  }
  for (; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* y += a x. */
static void axpy(int n, tl_real a, const tl_real *x, tl_real *y) {
  for (int i = 0; i < n; i++) y[i] += a * x[i];
}

/* |x|, without overflow or underflow of the squares: where they would, x is scaled by a power of two near its largest number. */
static tl_real norm(int n, const tl_real *x) {
  const tl_real plain = dot(n, x, x);
  if (plain >= TL_MIN / TL_EPSILON && plain <= TL_MAX) return TL_LIBM(sqrt)(plain);
  tl_real largest = TL_C(0.0);
  for (int i = 0; i < n; i++) {
    const tl_real a = TL_LIBM(fabs)(x[i]);
    if (!(a <= largest)) largest = a;
  }
  if (largest == TL_C(0.0) || !TL_ISFINITE(largest)) return largest;
  const int e = TL_LIBM(ilogb)(largest);
  const tl_real down = TL_LIBM(ldexp)(TL_C(1.0), -e / 2), up = TL_LIBM(ldexp)(TL_C(1.0), e / 2);
  tl_real sum = TL_C(0.0);
  for (int i = 0; i < n; i++) {
    const tl_real a = x[i] * down * down;
    sum += a * a;
  }
  return TL_LIBM(sqrt)(sum) * up * up;
}

/* L_ij = (a_ij - sum_k<j L_ik L_jk) / L_jj,  L_ii = sqrt(a_ii - sum_k<i L_ik^2). */
static int cholesky(int n, tl_real *a) {
  for (int i = 0; i < n; i++) {
    tl_real *row = a + (size_t)i * (size_t)n;
    for (int j = 0; j < i; j++) {
      const tl_real *other = a + (size_t)j * (size_t)n;
      row[j] = (row[j] - dot(j, row, other)) / other[j];
    }
    const tl_real pivot = row[i] - dot(i, row, row);
    if (!(pivot > TL_C(0.0))) return i + 1;
    row[i] = TL_LIBM(sqrt)(pivot);
  }
  return 0;
}

void eom_core_solve_lower(int n, const tl_real *l, int k, tl_real *x) {
  for (int v = 0; v < k; v++, x += n)
    for (int i = 0; i < n; i++) {
      const tl_real *row = l + (size_t)i * (size_t)n;
      x[i] = (x[i] - dot(i, row, x)) / row[i];
    }
}

void eom_core_solve_lower_transposed(int n, const tl_real *l, int k, tl_real *x) {
  for (int v = 0; v < k; v++, x += n)
    for (int i = n - 1; i >= 0; i--) {
      const tl_real *row = l + (size_t)i * (size_t)n;
      x[i] /= row[i];
      axpy(i, -x[i], row, x);
    }
}

/* H = 1 - tau (1,v)(1,v)' with H x = (beta, 0, .., 0): x becomes (beta, v). Returns tau, 0 where x is already of that form. */
static tl_real reflector(int n, tl_real *x) {
  const tl_real below = norm(n - 1, x + 1);
  if (below == TL_C(0.0)) return TL_C(0.0);
  const tl_real beta = -TL_LIBM(copysign)(TL_LIBM(hypot)(x[0], below), x[0]);
  const tl_real tau = (beta - x[0]) / beta, divisor = x[0] - beta;
  for (int i = 1; i < n; i++) x[i] /= divisor;
  x[0] = beta;
  return tau;
}

/* x = H x; v holds the reflector below its first number. */
static void reflect(int n, const tl_real *v, tl_real tau, tl_real *x) {
  const tl_real s = tau * (x[0] + dot(n - 1, v + 1, x + 1));
  x[0] -= s;
  axpy(n - 1, -s, v + 1, x + 1);
}

static void exchange(int n, tl_real *a, tl_real *b) {
  for (int i = 0; i < n; i++) {
    const tl_real keep = a[i];
    a[i] = b[i];
    b[i] = keep;
  }
}

/* Brings the longest of the vectors j.. (their part below row j) to place j. Lengths are computed anew at each step: an update would
 * lose them where a vector is nearly dependent, which is where they matter. */
static void bring_longest(int n, int m, tl_real *b, int *pivot, int j) {
  int best = j;
  tl_real longest = TL_C(-1.0);
  for (int c = j; c < m; c++) {
    const tl_real length = norm(n - j, b + (size_t)c * (size_t)n + j);
    if (length > longest) {
      longest = length;
      best = c;
    }
  }
  if (best == j) return;
  exchange(n, b + (size_t)j * (size_t)n, b + (size_t)best * (size_t)n);
  const int keep = pivot[j];
  pivot[j] = pivot[best];
  pivot[best] = keep;
}

static void qr(int n, int m, tl_real *b, int *pivot, tl_real *tau, tl_real *work, int nwork) {
  (void)work;
  (void)nwork;
  if (pivot)
    for (int j = 0; j < m; j++) pivot[j] = j;
  for (int j = 0; j < n && j < m; j++) {
    if (pivot) bring_longest(n, m, b, pivot, j);
    tl_real *v = b + (size_t)j * (size_t)n + j;
    tau[j] = reflector(n - j, v);
    for (int c = j + 1; c < m; c++) reflect(n - j, v, tau[j], b + (size_t)c * (size_t)n + j);
  }
}

void eom_core_apply_qt(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork) {
  (void)work;
  (void)nwork;
  for (int j = 0; j < r; j++) reflect(n - j, b + (size_t)j * (size_t)n + j, tau[j], x + j);
}

void eom_core_apply_q(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork) {
  (void)work;
  (void)nwork;
  for (int j = r - 1; j >= 0; j--) reflect(n - j, b + (size_t)j * (size_t)n + j, tau[j], x + j);
}

void eom_core_solve_upper(int n, int r, const tl_real *b, tl_real *x) {
  for (int j = r - 1; j >= 0; j--) {
    const tl_real *column = b + (size_t)j * (size_t)n;
    x[j] /= column[j];
    axpy(j, -x[j], column, x);
  }
}

void eom_core_solve_upper_transposed(int n, int r, const tl_real *b, tl_real *x) {
  for (int j = 0; j < r; j++) {
    const tl_real *column = b + (size_t)j * (size_t)n;
    x[j] = (x[j] - dot(j, column, x)) / column[j];
  }
}

const eom_linalg eom_linalg_core = {.name = "core",
                                    .cholesky = cholesky,
                                    .solve_lower = eom_core_solve_lower,
                                    .solve_lower_transposed = eom_core_solve_lower_transposed,
                                    .qr = qr,
                                    .apply_qt = eom_core_apply_qt,
                                    .apply_q = eom_core_apply_q,
                                    .solve_upper = eom_core_solve_upper,
                                    .solve_upper_transposed = eom_core_solve_upper_transposed};

int eom_linalg_work(int n, int m) { return EOM_LINALG_WORK(n, m); }

void eom_multiply(int rows, int k, int columns, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < rows; i++)
    for (int j = 0; j < columns; j++) {
      tl_real sum = TL_C(0.0);
      for (int l = 0; l < k; l++) sum += a[i * k + l] * b[l * columns + j];
      c[i * columns + j] = sum;
    }
}
