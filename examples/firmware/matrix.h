/* Small dense matrices in the caller's arrays: row-major, square of order n unless said. Outputs overlap no inputs. Functions are
 * inline, so that an order that is a constant where they are called gives code without inner loops. */
#ifndef MATRIX_H
#define MATRIX_H

#include "taylor/real.h"

#define MATRIX_UNROLLED _Pragma("GCC unroll 12")

static inline tl_real matrix_dot(int n, const tl_real *a, const tl_real *b, int stride) {
  tl_real sum = TL_C(0.0);
  MATRIX_UNROLLED
  for (int k = 0; k < n; k++) sum += a[k] * b[stride * k];
  return sum;
}

/* C = A B. */
static inline void matrix_multiply(int n, tl_real *restrict C, const tl_real *restrict A, const tl_real *restrict B) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) C[n * i + j] = matrix_dot(n, A + n * i, B + j, n);
}

/* C += A B' for a product that is symmetric: half of it is computed. */
static inline void matrix_add_symmetric(int n, tl_real *restrict C, const tl_real *restrict A, const tl_real *restrict B) {
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j++) C[n * j + i] = C[n * i + j] += matrix_dot(n, A + n * i, B + n * j, 1);
}

/* C = A'. */
static inline void matrix_transpose(int n, tl_real *C, const tl_real *A) {
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) C[n * j + i] = A[n * i + j];
}

static inline tl_real matrix_size(tl_real x) { return x < TL_C(0.0) ? -x : x; }

static inline void matrix_exchange(int k, tl_real *a, tl_real *b) {
  for (int j = 0; j < k; j++) {
    const tl_real held = a[j];
    a[j] = b[j];
    b[j] = held;
  }
}

/* row -= factor * pivot's row. */
static inline void matrix_subtract(int k, tl_real *restrict row, tl_real factor, const tl_real *restrict pivot) {
  MATRIX_UNROLLED
  for (int j = 0; j < k; j++) row[j] -= factor * pivot[j];
}

static inline int matrix_largest_below(int n, const tl_real *A, int i) {
  int best = i;
  for (int r = i + 1; r < n; r++)
    if (matrix_size(A[n * r + i]) > matrix_size(A[n * best + i])) best = r;
  return best;
}

/* X = A^-1 X for k columns, X: n x k, by elimination with row exchanges, which leaves nothing usable in A. 0 where A is singular. */
static inline int matrix_solve(int n, int k, tl_real *A, tl_real *X) {
  for (int i = 0; i < n; i++) {
    const int best = matrix_largest_below(n, A, i);
    if (!(matrix_size(A[n * best + i]) > TL_C(0.0))) return 0;
    matrix_exchange(n, A + n * i, A + n * best);
    matrix_exchange(k, X + k * i, X + k * best);
    const tl_real inverse = TL_C(1.0) / A[n * i + i];
    for (int r = i + 1; r < n; r++) {
      const tl_real factor = A[n * r + i] * inverse;
      matrix_subtract(n - i, A + n * r + i, factor, A + n * i + i);
      matrix_subtract(k, X + k * r, factor, X + k * i);
    }
  }
  for (int i = n - 1; i >= 0; i--) {
    for (int r = i + 1; r < n; r++) matrix_subtract(k, X + k * i, A[n * i + r], X + k * r);
    const tl_real inverse = TL_C(1.0) / A[n * i + i];
    for (int j = 0; j < k; j++) X[k * i + j] *= inverse;
  }
  return 1;
}

#endif
