/* The dense linear algebra of the runtime: one small interface, two implementations (linalg_core.c, linalg_lapacke.c).
 *
 * A set of k vectors of length n is stored vector after vector. Nothing allocates. A triangular factor stands in the array of the
 * matrix it comes from. */
#ifndef EOM_LINALG_H
#define EOM_LINALG_H

#include "eom/bytes.h"

typedef struct eom_linalg {
  const char *name;

  /* a = L L' for the symmetric n x n matrix a, row-major: reads and overwrites the lower triangle. Returns 0, or k+1 where pivot k is
   * not positive. */
  int (*cholesky)(int n, tl_real *a);

  /* x = L^-1 x and x = L^-T x for k vectors of n. */
  void (*solve_lower)(int n, const tl_real *l, int k, tl_real *x);
  void (*solve_lower_transposed)(int n, const tl_real *l, int k, tl_real *x);

  /* B P = Q R for the m vectors of n in b: R stands in the first j+1 numbers of vector j, the reflectors below. Column j of B P is
   * vector pivot[j] of B; pivot null: no exchange, P = 1. Pivots fall: |R_jj| is the greatest that was left. tau: min(n,m). work: nwork
   * numbers, at least eom_linalg_work(n, m). */
  void (*qr)(int n, int m, tl_real *b, int *pivot, tl_real *tau, tl_real *work, int nwork);

  /* x = Q' x and x = Q x for one vector of n, with the first r reflectors. */
  void (*apply_qt)(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork);
  void (*apply_q)(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork);

  /* x = R^-1 x and x = R^-T x with the leading r x r part of the R above; x: r. */
  void (*solve_upper)(int n, int r, const tl_real *b, tl_real *x);
  void (*solve_upper_transposed)(int n, int r, const tl_real *b, tl_real *x);
} eom_linalg;

/* Numbers of workspace for qr and apply of m vectors of n. */
int eom_linalg_work(int n, int m);

/* c = a b for row-major a (rows x k) and b (k x columns). */
void eom_multiply(int rows, int k, int columns, tl_real *c, const tl_real *a, const tl_real *b);

extern const eom_linalg eom_linalg_core;

/* Its parts that others use too. */
void eom_core_solve_lower(int n, const tl_real *l, int k, tl_real *x);
void eom_core_solve_lower_transposed(int n, const tl_real *l, int k, tl_real *x);
void eom_core_apply_qt(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork);
void eom_core_apply_q(int n, int r, const tl_real *b, const tl_real *tau, tl_real *x, tl_real *work, int nwork);
void eom_core_solve_upper(int n, int r, const tl_real *b, tl_real *x);
void eom_core_solve_upper_transposed(int n, int r, const tl_real *b, tl_real *x);

#ifdef EOM_HAVE_LAPACKE
extern const eom_linalg eom_linalg_lapacke;
#endif

#endif
