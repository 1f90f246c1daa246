/* Solution of M x = b with a symmetric positive definite M of constant size: M = L D L', L unit lower triangular, D diagonal.
 *
 *     d_i = M_ii - sum_k<i L_ik^2 d_k        L_ji d_i = M_ji - sum_k<i L_jk d_k L_ik    (j > i)
 *
 * M is given by its upper triangle in an n x ld array w (row-major), right-hand sides may stand beside it: row i of w is
 *
 *     columns 0..i-1: anything    i..n-1: M_ii .. M_i,n-1    n..n+nb-1: right-hand sides b_i    up to ld: anything, need not be set
 *
 * with ld >= TL_LDL_ROW(n, nb). The inverse pivots dinv take TL_ROW(n) numbers. What tl_ldl_factor leaves in w and dinv is for the
 * other functions here, with the same n. n and nb (and k below, where it can) are constants at the place of the call. */
#ifndef TAYLOR_LDL_H
#define TAYLOR_LDL_H

#include "taylor/kernel.h"

/* Row length of an array [M | nb right-hand sides]. */
#define TL_LDL_ROW(n, nb) TL_ROW((n) + (nb))

/* Factors the M in w and applies (L D)^-1 to its nb right-hand sides. Returns the pivot ratio 1/max_i(M_ii/d_i): 1 for a diagonal M, of
 * the size of 1/condition number or larger otherwise; 0 where a pivot is not positive or not finite, M is then not positive definite to
 * working precision and nothing in w and dinv is of use. Never a NaN. */
TL_INLINE tl_real tl_ldl_factor(int n, int nb, tl_real *w, int ld, tl_real *dinv) {
  tl_real largest = TL_C(0.0);
  int positive = 1;
  for (int i = 0; i < n; i++) dinv[i] = w[i * ld + i];
  for (int i = 0; i < n; i++) {
    tl_real *wi = w + i * ld;
    const tl_real pivot = wi[i], diagonal = dinv[i];
    positive &= pivot > TL_C(0.0) && TL_ISFINITE(pivot);
    dinv[i] = TL_C(1.0) / pivot;
    largest = diagonal * dinv[i] > largest ? diagonal * dinv[i] : largest;
    for (int p = i + 1; p < n; p++) {
      const tl_real m = wi[p] * dinv[i];
      for (int j = p; j < n + nb; j++) w[p * ld + j] -= m * wi[j];
    }
    for (int j = i + 1; j < n + nb; j++) wi[j] *= dinv[i];
  }
  return positive ? TL_C(1.0) / largest : TL_C(0.0);
}

/* x = M^-1 b for the right-hand side that stood in column n + column of w. */
TL_INLINE void tl_ldl_appended(int n, tl_real *x, const tl_real *w, int ld, int column) {
  for (int i = n - 1; i >= 0; i--) {
    tl_real sum = w[i * ld + n + column];
    for (int j = i + 1; j < n; j++) sum -= w[i * ld + j] * x[j];
    x[i] = sum;
  }
}

/* x = M^-1 b for one more right-hand side of n numbers; x may be b. */
TL_INLINE void tl_ldl_solve(int n, tl_real *x, const tl_real *w, int ld, const tl_real *dinv, const tl_real *b) {
  for (int i = 0; i < n; i++) {
    tl_real sum = b[i];
    for (int k = 0; k < i; k++) sum -= w[k * ld + i] * x[k];
    x[i] = sum;
  }
  for (int i = n - 1; i >= 0; i--) {
    tl_real sum = x[i] * dinv[i];
    for (int j = i + 1; j < n; j++) sum -= w[i * ld + j] * x[j];
    x[i] = sum;
  }
}

/* B = M^-1 B for k right-hand sides: b is n x ldb, row i holds the i-th numbers of all of them; ldb >= TL_ROW(k). Numbers of b beyond
 * column k need not be set and keep no value. */
TL_INLINE void tl_ldl_solve_many(int n, int k, tl_real *b, int ldb, const tl_real *w, int ld, const tl_real *dinv) {
  for (int i = 1; i < n; i++)
    for (int p = 0; p < i; p++)
      for (int j = 0; j < k; j++) b[i * ldb + j] -= w[p * ld + i] * b[p * ldb + j];
  for (int i = n - 1; i >= 0; i--) {
    for (int j = 0; j < k; j++) b[i * ldb + j] *= dinv[i];
    for (int p = i + 1; p < n; p++)
      for (int j = 0; j < k; j++) b[i * ldb + j] -= w[i * ld + p] * b[p * ldb + j];
  }
}

#endif
