/* M = L D L' as straight-line scalars; with COLUMNS > 1 the right-hand sides of J are vectors. See kernels.h. */
#ifndef BENCH_HAND_REGISTERS_H
#define BENCH_HAND_REGISTERS_H

#ifndef COLUMNS
#define COLUMNS 1 /* right-hand sides that are solved for at a time */
#endif
#if COLUMNS == 1
#define EACH_ENTRY UNROLL
typedef double entry;
INLINE entry smaller(double a, entry b) { return a < b ? a : b; }
#else
#define EACH_ENTRY
typedef double entry __attribute__((vector_size(8 * COLUMNS)));
typedef long long entry_mask __attribute__((vector_size(8 * COLUMNS)));
INLINE entry smaller(double a, entry b) {
  const entry x = (entry){0} + a;
  const entry_mask mask = x < b;
  return (entry)(((entry_mask)x & mask) | ((entry_mask)b & ~mask));
}
#endif
typedef double cell;
enum { CELLS = 1, ENTRIES = COLUMNS };

/* [M | b], upper triangle, in w: L' (unit) with (L D)^-1 b beside it in l. */
INLINE void factor(int n, double *w, double *l, int ld, double *dinv) {
  UNROLL for (int i = 0; i < n; i++) {
    dinv[i] = 1.0 / w[i * ld + i];
    UNROLL for (int j = i + 1; j <= n; j++) l[i * ld + j] = w[i * ld + j] * dinv[i];
    UNROLL for (int p = i + 1; p < n; p++) UNROLL for (int j = p; j <= n; j++) w[p * ld + j] -= l[i * ld + p] * w[i * ld + j];
  }
}

INLINE void back(int n, double *x, const double *l, int ld) {
  UNROLL for (int i = n - 1; i > 0; i--) UNROLL for (int j = 0; j < i; j++) x[j] -= l[j * ld + i] * x[i];
}

/* The solution for the right-hand side that stood beside M. */
INLINE void solve_appended(int n, double *x, const double *l, int ld) {
  UNROLL for (int i = 0; i < n; i++) x[i] = l[i * ld + n];
  back(n, x, l, ld);
}

/* One more right-hand side, in place. */
INLINE void solve_one(int n, double *x, const double *l, int ld, const double *dinv) {
  UNROLL for (int i = 0; i < n; i++) UNROLL for (int j = i + 1; j < n; j++) x[j] -= l[i * ld + j] * x[i];
  UNROLL for (int i = 0; i < n; i++) x[i] *= dinv[i];
  back(n, x, l, ld);
}

/* COLUMNS of the k right-hand sides at a time. */
INLINE void solve_many(int n, int k, double *b, int ldb, const double *l, int ld, const double *dinv) {
  EACH_ENTRY for (int column = 0; column < k; column += COLUMNS) {
    entry x[N];
    UNROLL for (int i = 0; i < n; i++) memcpy(&x[i], b + i * ldb + column, sizeof x[i]);
    UNROLL for (int i = 0; i < n; i++) UNROLL for (int j = i + 1; j < n; j++) x[j] -= l[i * ld + j] * x[i];
    UNROLL for (int i = 0; i < n; i++) x[i] *= dinv[i];
    UNROLL for (int i = n - 1; i > 0; i--) UNROLL for (int j = 0; j < i; j++) x[j] -= l[j * ld + i] * x[i];
    UNROLL for (int i = 0; i < n; i++) memcpy(b + i * ldb + column, &x[i], sizeof x[i]);
  }
}

#endif
