/* M = L D L' by rows of vectors, blocks of four rows updated in registers. See kernels.h. */
#ifndef BENCH_HAND_ROWS_H
#define BENCH_HAND_ROWS_H

#define EACH_ENTRY
typedef vector cell, entry;
enum { CELLS = LANES, ENTRIES = LANES };
INLINE entry smaller(double a, entry b) {
  const entry x = (entry){0} + a;
  const integers mask = x < b;
  return (entry)(((integers)x & mask) | ((integers)b & ~mask));
}

enum { BLOCK = 4 };

/* Y[r][c] -= sum_k l[r*sr + k*sk] X[k][c] for k0 <= k < k1, rb rows and nb vectors of columns. */
INLINE void update_block(int rb, int nb, double *Y, int ld, const double *l, int sr, int sk, const double *X, int k0, int k1) {
  vector sum[BLOCK][BLOCK];
  UNROLL for (int r = 0; r < rb; r++) UNROLL for (int c = 0; c < nb; c++) sum[r][c] = *(vector *)(Y + r * ld + c * LANES);
  for (int k = k0; k < k1; k++) {
    vector x[BLOCK];
    UNROLL for (int c = 0; c < nb; c++) x[c] = *(const vector *)(X + k * ld + c * LANES);
    UNROLL for (int r = 0; r < rb; r++) UNROLL for (int c = 0; c < nb; c++) sum[r][c] -= x[c] * l[r * sr + k * sk];
  }
  UNROLL for (int r = 0; r < rb; r++) UNROLL for (int c = 0; c < nb; c++) * (vector *)(Y + r * ld + c * LANES) = sum[r][c];
}

/* The same for the columns c0..c1, whole vectors. */
INLINE void update_rows(int rb, double *Y, int ld, const double *l, int sr, int sk, const double *X, int k0, int k1, int c0, int c1) {
  int c = c0;
  for (; c + BLOCK * LANES <= c1; c += BLOCK * LANES) update_block(rb, BLOCK, Y + c, ld, l, sr, sk, X + c, k0, k1);
  if ((c1 - c) / LANES == 3) update_block(rb, 3, Y + c, ld, l, sr, sk, X + c, k0, k1);
  if ((c1 - c) / LANES == 2) update_block(rb, 2, Y + c, ld, l, sr, sk, X + c, k0, k1);
  if ((c1 - c) / LANES == 1) update_block(rb, 1, Y + c, ld, l, sr, sk, X + c, k0, k1);
}

/* x where the column is beyond i, else 0; c: column of the first lane. */
INLINE vector beyond(vector x, int c, int i) {
  integers column;
  UNROLL for (int l = 0; l < LANES; l++) column[l] = c + l;
  return (vector)((integers)x & (column > (integers){0} + i));
}

/* Factors of the rows i0..i0+rb: w keeps D L', and l becomes L' with zeros up to the diagonal, (L D)^-1 b in column n. */
INLINE void factor_block(int rb, int i0, int n, double *w, double *l, int ld, double *dinv) {
  int c0 = i0 / LANES * LANES, end = (n + LANES) / LANES * LANES;
  if (i0 > 0) update_rows(rb, w + i0 * ld, ld, l + i0, 1, ld, w, 0, i0, c0, end);
  UNROLL for (int r = 0; r < rb; r++) {
    int i = i0 + r;
    double d = dinv[i] = 1.0 / w[i * ld + i];
    vector m[BLOCK];
    UNROLL for (int p = r + 1; p < rb; p++) m[p] = (vector){0} + w[i * ld + i0 + p] * d;
    for (int c = c0; c < end; c += LANES) {
      vector row = *(vector *)(w + i * ld + c);
      *(vector *)(l + i * ld + c) = c <= i ? beyond(row * d, c, i) : row * d;
      UNROLL for (int p = r + 1; p < rb; p++) * (vector *)(w + (i0 + p) * ld + c) -= m[p] * row;
    }
  }
}

INLINE void factor(int n, double *w, double *l, int ld, double *dinv) {
  int i = 0;
  for (; i + BLOCK <= n; i += BLOCK) factor_block(BLOCK, i, n, w, l, ld, dinv);
  if (n % BLOCK == 1) factor_block(1, i, n, w, l, ld, dinv);
  if (n % BLOCK == 2) factor_block(2, i, n, w, l, ld, dinv);
  if (n % BLOCK == 3) factor_block(3, i, n, w, l, ld, dinv);
}

INLINE double lane_sum(vector x) {
#if LANES == 8
  typedef double half __attribute__((vector_size(32)));
  half h = __builtin_shufflevector(x, x, 0, 1, 2, 3) + __builtin_shufflevector(x, x, 4, 5, 6, 7);
#else
  vector h = x;
#endif
  typedef double pair __attribute__((vector_size(16)));
  pair p = __builtin_shufflevector(h, h, 0, 1) + __builtin_shufflevector(h, h, 2, 3);
  return p[0] + p[1];
}

/* L' x = y, eight rows at a time: y[i*stride] -> x. */
INLINE void back_rows(int n, double *x, const double *l, int ld, const double *y, int stride) {
  double ALIGNED z[PADDED(N)];
  for (int b = (n - 1) / 8 * 8; b >= 0; b -= 8) {
    int e = b + 8 < n ? b + 8 : n;
    double part[8];
    UNROLL for (int r = 0; r < 8; r++) part[r] = b + r < n ? y[(b + r) * stride] : 0.0;
    if (e < n) {
      vector sum[8] = {{0}};
      for (int c = e; c < PADDED(n); c += LANES)
        UNROLL for (int r = 0; r < 8; r++) sum[r] += *(vector *)(z + c) * *(const vector *)(l + (b + r) * ld + c);
      UNROLL for (int r = 0; r < 8; r++) part[r] -= lane_sum(sum[r]);
    }
    UNROLL for (int p = 7; p > 0; p--) UNROLL for (int r = 0; r < p; r++) if (b + p < n) part[r] -= l[(b + r) * ld + b + p] * part[p];
    UNROLL for (int r = 0; r < 8; r++) z[b + r] = part[r];
  }
  for (int i = 0; i < n; i++) x[i] = z[i];
}

/* The solution for the right-hand side that stood beside M. */
INLINE void solve_appended(int n, double *x, const double *l, int ld) { back_rows(n, x, l, ld, l + n, ld); }

/* One more right-hand side, in place: forward by rows of L'. */
INLINE void solve_one(int n, double *x, const double *l, int ld, const double *dinv) {
  double ALIGNED t[PADDED(N)];
  for (int i = 0; i < PADDED(n); i++) t[i] = i < n ? x[i] : 0.0;
  for (int k = 0; k < n; k++) {
    double y = t[k];
    for (int c = (k + 1) / LANES * LANES; c < PADDED(n); c += LANES) *(vector *)(t + c) -= *(const vector *)(l + k * ld + c) * y;
  }
  for (int i = 0; i < n; i++) t[i] *= dinv[i];
  back_rows(n, x, l, ld, t, 1);
}

INLINE void forward_block(int rb, int i0, int end, double *b, int ldb, const double *l, int ld) {
  if (i0 > 0) update_rows(rb, b + i0 * ldb, ldb, l + i0, 1, ld, b, 0, i0, 0, end);
  UNROLL for (int r = 1; r < rb; r++) update_rows(1, b + (i0 + r) * ldb, ldb, l + i0 + r, 1, ld, b, i0, i0 + r, 0, end);
}

INLINE void backward_block(int rb, int i0, int n, int end, double *b, int ldb, const double *l, int ld) {
  if (i0 + rb < n) update_rows(rb, b + i0 * ldb, ldb, l + i0 * ld, ld, 1, b, i0 + rb, n, 0, end);
  UNROLL for (int r = rb - 2; r >= 0; r--)
      update_rows(1, b + (i0 + r) * ldb, ldb, l + (i0 + r) * ld, ld, 1, b, i0 + r + 1, i0 + rb, 0, end);
}

/* k right-hand sides in the rows of b, in place. */
INLINE void solve_many(int n, int k, double *b, int ldb, const double *l, int ld, const double *dinv) {
  int i0 = 0, end = (k + LANES - 1) / LANES * LANES, rest = n % BLOCK;
  for (; i0 + BLOCK <= n; i0 += BLOCK) forward_block(BLOCK, i0, end, b, ldb, l, ld);
  if (rest == 1) forward_block(1, i0, end, b, ldb, l, ld);
  if (rest == 2) forward_block(2, i0, end, b, ldb, l, ld);
  if (rest == 3) forward_block(3, i0, end, b, ldb, l, ld);
  for (int i = 0; i < n; i++)
    for (int c = 0; c < end; c += LANES) *(vector *)(b + i * ldb + c) *= dinv[i];
  if (rest == 1) backward_block(1, i0, n, end, b, ldb, l, ld);
  if (rest == 2) backward_block(2, i0, n, end, b, ldb, l, ld);
  if (rest == 3) backward_block(3, i0, n, end, b, ldb, l, ld);
  for (i0 -= BLOCK; i0 >= 0; i0 -= BLOCK) backward_block(BLOCK, i0, n, end, b, ldb, l, ld);
}

#endif
