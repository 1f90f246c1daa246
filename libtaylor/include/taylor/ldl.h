/* Solution of M x = b with a symmetric positive definite M of constant size: M = L D L', L unit lower triangular, D diagonal.
 *
 *     u_kj = d_k L_jk        u_ij = M_ij - sum_k<i L_ik u_kj    (j >= i)        d_i = u_ii        L_ji = u_ij / d_i
 *
 * A division takes longer than anything else here, and each pivot waits for the one before. So pivots are found in pairs, with
 *
 *     1/d_i = 1/a        1/d_i+1 = a 1/(a c - b^2)        from a, b, c = M_ii, M_i,i+1, M_i+1,i+1 less their sums over k < i,
 *
 * whose two divisions do not wait for each other. Two forms serve: up to n = TL_LDL_SCALAR straight-line code for numbers one by one,
 * which leaves nothing in memory where the arrays are local; above, blocks of four rows and vectors of four columns.
 *
 * Everywhere: n is a constant at the place of the call. w is an n x ld array (row-major), ld >= TL_LDL_ROW(n), and holds M's upper
 * triangle: M_ij at w[i*ld + j] for i <= j < n; the rest need not be set. d has TL_LDL_DIAGONAL(n) numbers. What tl_ldl_factor leaves
 * in w and d is for the other functions. Fastest is a w that was written by vectors for n > TL_LDL_SCALAR, by numbers for smaller n. */
#ifndef TAYLOR_LDL_H
#define TAYLOR_LDL_H

#include <stddef.h>
#include <string.h>

#include "taylor/kernel.h"

#define TL_LDL_ROW(n) TL_ROW(n)
#define TL_LDL_DIAGONAL(n) (2 * TL_ROW(n))

/* The largest n for straight-line code: of eight and more numbers a processor cannot hold the triangle in registers. */
#ifndef TL_LDL_SCALAR
#if TL_VECTORS
#define TL_LDL_SCALAR 8
#else
#define TL_LDL_SCALAR 6
#endif
#endif

/* Without vectors: the most n^2 k for which the columns of B are straight-line code too. */
#ifndef TL_LDL_STRAIGHT
#define TL_LDL_STRAIGHT 64
#endif

/* The largest n for which the loops over blocks are unrolled. */
#ifndef TL_LDL_UNROLLED
#define TL_LDL_UNROLLED 16
#endif

/* ---- straight-line code ---- */
#define TL_T tl_real
#define TL_T_NAME(name) name
#define TL_T_OF(x) (x)
#define TL_T_WHERE(condition, a, b) ((condition) ? (a) : (b))
#define TL_T_UNROLL TL_UNROLL
#include "taylor/ldl_straight.h"

/* ---- the same as loops, for more numbers where there are no vectors ---- */
#if !TL_VECTORS
#define TL_T tl_real
#define TL_T_NAME(name) name##_by_loops
#define TL_T_OF(x) (x)
#define TL_T_WHERE(condition, a, b) ((condition) ? (a) : (b))
#define TL_T_UNROLL
#include "taylor/ldl_straight.h"
#endif

/* ---- blocks ---- */
#if TL_VECTORS

/* Four rows and four columns of numbers. Only the first `rows` of a block's rows are there at the end of a matrix. */
typedef struct tl_ldl_tile {
  tl_v4 r0, r1, r2, r3;
} tl_ldl_tile;

/* A block on the diagonal: L_ik as l_ik, 1/d_i as d_i. */
typedef struct tl_ldl_block {
  tl_real d0, d1, d2, d3, l10, l20, l30, l21, l31, l32;
} tl_ldl_block;

/* Four numbers of a vector. */
typedef struct tl_ldl_quad {
  tl_real x0, x1, x2, x3;
} tl_ldl_quad;

TL_INLINE void tl_ldl_load(int rows, tl_ldl_tile *t, const tl_real *w, int ld) {
  t->r0 = TL_V4_CONST(w);
  if (rows > 1) t->r1 = TL_V4_CONST(w + ld);
  if (rows > 2) t->r2 = TL_V4_CONST(w + 2 * ld);
  if (rows > 3) t->r3 = TL_V4_CONST(w + 3 * ld);
}

TL_INLINE void tl_ldl_store(int rows, const tl_ldl_tile *t, tl_real *w, int ld) {
  TL_V4(w) = t->r0;
  if (rows > 1) TL_V4(w + ld) = t->r1;
  if (rows > 2) TL_V4(w + 2 * ld) = t->r2;
  if (rows > 3) TL_V4(w + 3 * ld) = t->r3;
}

/* gcc would load a vector that four sums use four times, and loads are what limits them. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__AVX512VL__)
#define TL_LDL_IN_REGISTER(vector) __asm__("" : "+v"(vector))
#elif defined(__GNUC__) && !defined(__clang__) && defined(__AVX__)
#define TL_LDL_IN_REGISTER(vector) __asm__("" : "+x"(vector))
#else
#define TL_LDL_IN_REGISTER(vector) ((void)0)
#endif

/* t -= l x: row i less l[i*step] times the row x. */
TL_INLINE void tl_ldl_less_row(int rows, tl_ldl_tile *t, const tl_real *l, int step, const tl_real *x) {
  tl_v4 row = TL_V4_CONST(x);
  TL_LDL_IN_REGISTER(row);
  t->r0 -= l[0] * row;
  if (rows > 1) t->r1 -= l[step] * row;
  if (rows > 2) t->r2 -= l[2 * step] * row;
  if (rows > 3) t->r3 -= l[3 * step] * row;
}

/* (t, t right of it) -= l x over k rows of x; l_ik is at l[i*row_step + k*step]. right: null where there is none. */
TL_INLINE void tl_ldl_less_rows(int unrolled, int rows, tl_ldl_tile *t, tl_ldl_tile *right, const tl_real *l, int row_step, int step,
                                const tl_real *x, int ldx, int k) {
  if (unrolled) {
    TL_UNROLL for (int i = 0; i < k; i++) {
      tl_ldl_less_row(rows, t, l + i * step, row_step, x + i * ldx);
      if (right) tl_ldl_less_row(rows, right, l + i * step, row_step, x + i * ldx + 4);
    }
  } else {
    for (int i = 0; i < k; i++) {
      tl_ldl_less_row(rows, t, l + i * step, row_step, x + i * ldx);
      if (right) tl_ldl_less_row(rows, right, l + i * step, row_step, x + i * ldx + 4);
    }
  }
}

/* Pivots of the block whose tile on the diagonal is t, already less the rows above. */
TL_INLINE tl_ldl_block tl_ldl_pivots(int rows, tl_ldl_tile *t) {
  tl_ldl_block f = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  tl_real a = t->r0[0];
  f.d0 = TL_C(1.0) / a;
  if (rows > 1) {
    const tl_real b = t->r0[1], c = t->r1[1];
    f.d1 = a * (TL_C(1.0) / (a * c - b * b));
    f.l10 = b * f.d0;
    t->r1 -= f.l10 * t->r0;
  }
  if (rows > 2) {
    const tl_real u0 = t->r0[2], u1 = t->r1[2];
    t->r2 -= u0 * t->r0 * f.d0;
    t->r2 -= u1 * t->r1 * f.d1;
    f.l20 = u0 * f.d0;
    f.l21 = u1 * f.d1;
    a = t->r2[2];
    f.d2 = TL_C(1.0) / a;
  }
  if (rows > 3) {
    const tl_real u0 = t->r0[3], u1 = t->r1[3];
    t->r3 -= u0 * t->r0 * f.d0;
    t->r3 -= u1 * t->r1 * f.d1;
    f.l30 = u0 * f.d0;
    f.l31 = u1 * f.d1;
    const tl_real b = t->r2[3], c = t->r3[3];
    f.d3 = a * (TL_C(1.0) / (a * c - b * b));
    f.l32 = b * f.d2;
  }
  return f;
}

/* The block's numbers into d and, as L, into w at its place on the diagonal. */
TL_INLINE void tl_ldl_keep(int rows, const tl_ldl_block *f, tl_real *w, int ld, tl_real *d) {
  d[0] = f->d0;
  if (rows > 1) d[1] = f->d1, w[ld] = f->l10;
  if (rows > 2) d[2] = f->d2, w[2 * ld] = f->l20, w[2 * ld + 1] = f->l21;
  if (rows > 3) d[3] = f->d3, w[3 * ld] = f->l30, w[3 * ld + 1] = f->l31, w[3 * ld + 2] = f->l32;
}

/* x = L^-1 x inside of a block. */
TL_INLINE tl_ldl_quad tl_ldl_forward(int rows, const tl_ldl_block *f, const tl_real *y) {
  tl_ldl_quad x = {y[0], 0, 0, 0};
  if (rows > 1) x.x1 = y[1] - f->l10 * x.x0;
  if (rows > 2) x.x2 = y[2] - f->l20 * x.x0 - f->l21 * x.x1;
  if (rows > 3) x.x3 = y[3] - f->l30 * x.x0 - f->l31 * x.x1 - f->l32 * x.x2;
  return x;
}

TL_INLINE void tl_ldl_put(int rows, tl_real *y, const tl_ldl_quad *x) {
  y[0] = x->x0;
  if (rows > 1) y[1] = x->x1;
  if (rows > 2) y[2] = x->x2;
  if (rows > 3) y[3] = x->x3;
}

/* D^-1 x */
TL_INLINE tl_ldl_quad tl_ldl_divide(const tl_ldl_block *f, const tl_ldl_quad *x) {
  const tl_ldl_quad y = {x->x0 * f->d0, x->x1 * f->d1, x->x2 * f->d2, x->x3 * f->d3};
  return y;
}

/* y -= x' t for four numbers y. */
TL_INLINE void tl_ldl_less_product(tl_real *y, const tl_ldl_quad *x, const tl_ldl_tile *t) {
  tl_v4 sum = TL_V4(y);
  sum -= t->r0 * x->x0;
  sum -= t->r1 * x->x1;
  sum -= t->r2 * x->x2;
  sum -= t->r3 * x->x3;
  TL_V4(y) = sum;
}

/* Tile t of columns `column`.. right of the block of rows i..i+3: u into its place, L into the transposed place. */
TL_INLINE void tl_ldl_finish(int n, tl_ldl_tile *t, const tl_ldl_block *f, tl_real *w, int ld, int i, int column) {
  t->r1 -= f->l10 * t->r0;
  t->r2 -= f->l20 * t->r0;
  t->r3 -= f->l30 * t->r0;
  t->r2 -= f->l21 * t->r1;
  t->r3 -= f->l31 * t->r1;
  t->r3 -= f->l32 * t->r2;
  tl_ldl_store(4, t, w + i * ld + column, ld);
  const tl_v4 a = t->r0 * f->d0, b = t->r1 * f->d1, c = t->r2 * f->d2, e = t->r3 * f->d3;
  const tl_v4 even_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), odd_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const tl_v4 even_ce = __builtin_shufflevector(c, e, 0, 4, 2, 6), odd_ce = __builtin_shufflevector(c, e, 1, 5, 3, 7);
  const tl_ldl_tile l = {__builtin_shufflevector(even_ab, even_ce, 0, 1, 4, 5), __builtin_shufflevector(odd_ab, odd_ce, 0, 1, 4, 5),
                         __builtin_shufflevector(even_ab, even_ce, 2, 3, 6, 7), __builtin_shufflevector(odd_ab, odd_ce, 2, 3, 6, 7)};
  tl_ldl_store(n - column, &l, w + column * ld + i, ld);
}

/* Two tiles of the block of rows i..i+3, from column to column + 7; or one. y: null, or the right-hand side less what the rows above i
 * contribute; z = D^-1 L^-1 b of the block. */
TL_INLINE void tl_ldl_two_tiles(int n, const tl_ldl_block *f, tl_real *w, int ld, int i, int column, tl_real *y, const tl_ldl_quad *z) {
  tl_ldl_tile t, right;
  tl_ldl_load(4, &t, w + i * ld + column, ld);
  tl_ldl_load(4, &right, w + i * ld + column + 4, ld);
  tl_ldl_less_rows(n <= TL_LDL_UNROLLED, 4, &t, &right, w + i * ld, ld, 1, w + column, ld, i);
  tl_ldl_finish(n, &t, f, w, ld, i, column);
  tl_ldl_finish(n, &right, f, w, ld, i, column + 4);
  if (y) tl_ldl_less_product(y + column, z, &t);
  if (y) tl_ldl_less_product(y + column + 4, z, &right);
}

TL_INLINE void tl_ldl_last_tile(int n, const tl_ldl_block *f, tl_real *w, int ld, int i, int column, tl_real *y, const tl_ldl_quad *z) {
  tl_ldl_tile t;
  tl_ldl_load(4, &t, w + i * ld + column, ld);
  tl_ldl_less_rows(n <= TL_LDL_UNROLLED, 4, &t, NULL, w + i * ld, ld, 1, w + column, ld, i);
  tl_ldl_finish(n, &t, f, w, ld, i, column);
  if (y) tl_ldl_less_product(y + column, z, &t);
}

/* Rows i..i+rows-1, given those above. The tile on the diagonal goes along with the one right of it, where there is one. */
TL_INLINE void tl_ldl_rows(int n, int rows, tl_real *w, int ld, tl_real *d, int i, tl_real *y, tl_ldl_range *range) {
  tl_real *wi = w + i * ld;
  const int more = rows == 4 && i + 4 < n;
  const tl_real entry0 = wi[i], entry1 = rows > 1 ? wi[ld + i + 1] : entry0, entry2 = rows > 2 ? wi[2 * ld + i + 2] : entry0;
  const tl_real entry3 = rows > 3 ? wi[3 * ld + i + 3] : entry0;
  tl_ldl_tile t, right;
  tl_ldl_load(rows, &t, wi + i, ld);
  tl_ldl_load(rows, &right, wi + (more ? i + 4 : i), ld); /* not used where there is none: compilers cannot tell */
  if (more)
    tl_ldl_less_rows(n <= TL_LDL_UNROLLED, 4, &t, &right, wi, ld, 1, w + i, ld, i);
  else
    tl_ldl_less_rows(n <= TL_LDL_UNROLLED, rows, &t, NULL, wi, ld, 1, w + i, ld, i);
  const tl_ldl_block f = tl_ldl_pivots(rows, &t);
  tl_ldl_keep(rows, &f, wi + i, ld, d + i);
  tl_ldl_extend(range, &f.d0, &entry0);
  if (rows > 1) tl_ldl_extend(range, &f.d1, &entry1);
  if (rows > 2) tl_ldl_extend(range, &f.d2, &entry2);
  if (rows > 3) tl_ldl_extend(range, &f.d3, &entry3);
  tl_ldl_quad z = {0, 0, 0, 0};
  if (y) {
    z = tl_ldl_forward(rows, &f, y + i);
    z = tl_ldl_divide(&f, &z);
    tl_ldl_put(rows, y + i, &z);
  }
  if (!more) return;
  tl_ldl_finish(n, &right, &f, w, ld, i, i + 4);
  if (y) tl_ldl_less_product(y + i + 4, &z, &right);
  int column = i + 8;
  if (n <= TL_LDL_UNROLLED) {
    TL_UNROLL for (; column + 4 < n; column += 8) tl_ldl_two_tiles(n, &f, w, ld, i, column, y, &z);
  } else {
    for (; column + 4 < n; column += 8) tl_ldl_two_tiles(n, &f, w, ld, i, column, y, &z);
  }
  if (column < n) tl_ldl_last_tile(n, &f, w, ld, i, column, y, &z);
}

/* y: null, or TL_ROW(n) numbers, the first n of which are a right-hand side b before and D^-1 L^-1 b afterwards. */
TL_INLINE tl_real tl_ldl_factor_blocks(int n, tl_real *w, int ld, tl_real *d, tl_real *y) {
  tl_ldl_range range = {TL_C(0.0), TL_MAX};
  const int end = n / 4 * 4;
  if (n <= TL_LDL_UNROLLED) {
    TL_UNROLL for (int i = 0; i < end; i += 4) tl_ldl_rows(n, 4, w, ld, d, i, y, &range);
  } else {
    for (int i = 0; i < end; i += 4) tl_ldl_rows(n, 4, w, ld, d, i, y, &range);
  }
  if (n % 4 == 1) tl_ldl_rows(n, 1, w, ld, d, end, y, &range);
  if (n % 4 == 2) tl_ldl_rows(n, 2, w, ld, d, end, y, &range);
  if (n % 4 == 3) tl_ldl_rows(n, 3, w, ld, d, end, y, &range);
  return tl_ldl_ratio(&range);
}

/* L of the block on the diagonal at w, and its 1/d. */
TL_INLINE tl_ldl_block tl_ldl_block_at(int rows, const tl_real *w, int ld, const tl_real *d) {
  tl_ldl_block f = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
  f.d0 = d[0];
  if (rows > 1) f.d1 = d[1], f.l10 = w[ld];
  if (rows > 2) f.d2 = d[2], f.l20 = w[2 * ld], f.l21 = w[2 * ld + 1];
  if (rows > 3) f.d3 = d[3], f.l30 = w[3 * ld], f.l31 = w[3 * ld + 1], f.l32 = w[3 * ld + 2];
  return f;
}

/* y -= x' l of the first four columns of `rows` rows at l. */
TL_INLINE void tl_ldl_less_quad(int rows, tl_ldl_quad *y, const tl_ldl_quad *x, const tl_real *l, int ld) {
  if (rows > 3)
    y->x0 -= l[3 * ld] * x->x3, y->x1 -= l[3 * ld + 1] * x->x3, y->x2 -= l[3 * ld + 2] * x->x3, y->x3 -= l[3 * ld + 3] * x->x3;
  if (rows > 2)
    y->x0 -= l[2 * ld] * x->x2, y->x1 -= l[2 * ld + 1] * x->x2, y->x2 -= l[2 * ld + 2] * x->x2, y->x3 -= l[2 * ld + 3] * x->x2;
  if (rows > 1) y->x0 -= l[ld] * x->x1, y->x1 -= l[ld + 1] * x->x1, y->x2 -= l[ld + 2] * x->x1, y->x3 -= l[ld + 3] * x->x1;
  if (rows > 0) y->x0 -= l[0] * x->x0, y->x1 -= l[1] * x->x0, y->x2 -= l[2] * x->x0, y->x3 -= l[3] * x->x0;
}

/* x = L'^-1 x inside of the block at w. */
TL_INLINE void tl_ldl_backward(int rows, tl_ldl_quad *x, const tl_real *w, int ld) {
  if (rows > 3) x->x2 -= w[3 * ld + 2] * x->x3, x->x1 -= w[3 * ld + 1] * x->x3, x->x0 -= w[3 * ld] * x->x3;
  if (rows > 2) x->x1 -= w[2 * ld + 1] * x->x2, x->x0 -= w[2 * ld] * x->x2;
  if (rows > 1) x->x0 -= w[ld] * x->x1;
}

TL_INLINE tl_ldl_quad tl_ldl_get(int rows, const tl_real *y) {
  const tl_ldl_quad x = {rows > 0 ? y[0] : TL_C(0.0), rows > 1 ? y[1] : TL_C(0.0), rows > 2 ? y[2] : TL_C(0.0),
                         rows > 3 ? y[3] : TL_C(0.0)};
  return x;
}

/* Rows i..i+3 of L' x = y, given those from i+4 on: the `rows` rows behind them, whose solution is behind, still have to be taken from
 * y[0..i+3]. Those of y[i..i+3] go first, for the next block waits for them. */
TL_INLINE void tl_ldl_back_rows(int rows, tl_real *x, tl_real *y, const tl_real *w, int ld, int i, tl_ldl_quad *behind) {
  const tl_real *l = w + (i + 4) * ld;
  tl_ldl_quad here = tl_ldl_get(4, y + i);
  tl_ldl_less_quad(rows, &here, behind, l + i, ld);
  tl_ldl_backward(4, &here, w + i * ld + i, ld);
  for (int k = 0; rows > 0 && k < i; k += 4) {
    tl_v4 sum = TL_V4(y + k);
    if (rows > 3) sum -= TL_V4_CONST(l + 3 * ld + k) * behind->x3;
    if (rows > 2) sum -= TL_V4_CONST(l + 2 * ld + k) * behind->x2;
    if (rows > 1) sum -= TL_V4_CONST(l + ld + k) * behind->x1;
    sum -= TL_V4_CONST(l + k) * behind->x0;
    TL_V4(y + k) = sum;
  }
  tl_ldl_put(4, x + i, &here);
  *behind = here;
}

/* x = L'^-1 y; y is lost. */
TL_INLINE void tl_ldl_back(int n, tl_real *x, tl_real *y, const tl_real *w, int ld) {
  const int rows = n % 4, end = n - rows;
  tl_ldl_quad behind = tl_ldl_get(rows, y + end);
  tl_ldl_backward(rows, &behind, w + end * ld + end, ld);
  if (rows > 0) tl_ldl_put(rows, x + end, &behind);
  if (end > 0) tl_ldl_back_rows(rows, x, y, w, ld, end - 4, &behind);
  if (n <= TL_LDL_UNROLLED) {
    TL_UNROLL for (int i = end - 8; i >= 0; i -= 4) tl_ldl_back_rows(4, x, y, w, ld, i, &behind);
  } else {
    for (int i = end - 8; i >= 0; i -= 4) tl_ldl_back_rows(4, x, y, w, ld, i, &behind);
  }
}

/* Rows i..i+rows-1 of y = D^-1 L^-1 y, and what they contribute to the rows below. */
TL_INLINE void tl_ldl_forward_rows(int n, int rows, tl_real *y, const tl_real *w, int ld, const tl_real *d, int i) {
  const tl_ldl_block f = tl_ldl_block_at(rows, w + i * ld + i, ld, d + i);
  tl_ldl_quad x = tl_ldl_forward(rows, &f, y + i);
  x = tl_ldl_divide(&f, &x);
  tl_ldl_put(rows, y + i, &x);
  for (int k = i + 4; k < n; k += 4) {
    tl_ldl_tile t;
    tl_ldl_load(4, &t, w + i * ld + k, ld);
    tl_ldl_less_product(y + k, &x, &t);
  }
}

TL_INLINE void tl_ldl_solve_blocks(int n, tl_real *x, tl_real *y, const tl_real *w, int ld, const tl_real *d) {
  const int end = n / 4 * 4;
  if (n <= TL_LDL_UNROLLED) {
    TL_UNROLL for (int i = 0; i < end; i += 4) tl_ldl_forward_rows(n, 4, y, w, ld, d, i);
  } else {
    for (int i = 0; i < end; i += 4) tl_ldl_forward_rows(n, 4, y, w, ld, d, i);
  }
  if (n % 4 == 1) tl_ldl_forward_rows(n, 1, y, w, ld, d, end);
  if (n % 4 == 2) tl_ldl_forward_rows(n, 2, y, w, ld, d, end);
  if (n % 4 == 3) tl_ldl_forward_rows(n, 3, y, w, ld, d, end);
  tl_ldl_back(n, x, y, w, ld);
}

/* Rows i..i+rows-1 of B = L^-1 B, of four columns or eight. */
TL_INLINE void tl_ldl_forward_tiles(int rows, int tiles, tl_real *b, int ldb, const tl_real *w, int ld, int i) {
  const tl_real *l = w + i * ld + i;
  tl_ldl_tile t[2];
  tl_ldl_load(rows, &t[0], b + i * ldb, ldb);
  if (tiles > 1) tl_ldl_load(rows, &t[1], b + i * ldb + 4, ldb);
  tl_ldl_less_rows(0, rows, &t[0], tiles > 1 ? &t[1] : NULL, w + i * ld, ld, 1, b, ldb, i);
  TL_UNROLL for (int k = 0; k < tiles; k++) {
    if (rows > 1) t[k].r1 -= l[ld] * t[k].r0;
    if (rows > 2) t[k].r2 -= l[2 * ld] * t[k].r0, t[k].r2 -= l[2 * ld + 1] * t[k].r1;
    if (rows > 3) t[k].r3 -= l[3 * ld] * t[k].r0, t[k].r3 -= l[3 * ld + 1] * t[k].r1, t[k].r3 -= l[3 * ld + 2] * t[k].r2;
    tl_ldl_store(rows, &t[k], b + i * ldb + 4 * k, ldb);
  }
}

/* Rows i..i+rows-1 of B = L'^-1 D^-1 B. */
TL_INLINE void tl_ldl_backward_tiles(int n, int rows, int tiles, tl_real *b, int ldb, const tl_real *w, int ld, const tl_real *d,
                                     int i) {
  const tl_real *l = w + i * ld + i;
  tl_ldl_tile t[2];
  TL_UNROLL for (int k = 0; k < tiles; k++) {
    tl_ldl_load(rows, &t[k], b + i * ldb + 4 * k, ldb);
    t[k].r0 *= d[i];
    if (rows > 1) t[k].r1 *= d[i + 1];
    if (rows > 2) t[k].r2 *= d[i + 2];
    if (rows > 3) t[k].r3 *= d[i + 3];
  }
  const int next = i + rows;
  tl_ldl_less_rows(0, rows, &t[0], tiles > 1 ? &t[1] : NULL, w + next * ld + i, 1, ld, b + next * ldb, ldb, n - next);
  TL_UNROLL for (int k = 0; k < tiles; k++) {
    if (rows > 3) t[k].r2 -= l[3 * ld + 2] * t[k].r3, t[k].r1 -= l[3 * ld + 1] * t[k].r3, t[k].r0 -= l[3 * ld] * t[k].r3;
    if (rows > 2) t[k].r1 -= l[2 * ld + 1] * t[k].r2, t[k].r0 -= l[2 * ld] * t[k].r2;
    if (rows > 1) t[k].r0 -= l[ld] * t[k].r1;
    tl_ldl_store(rows, &t[k], b + i * ldb + 4 * k, ldb);
  }
}

/* Rows i..i+rows-1, all of k columns, of either direction. */
TL_INLINE void tl_ldl_many_rows(int forward, int n, int rows, int k, tl_real *b, int ldb, const tl_real *w, int ld, const tl_real *d,
                                int i) {
  int column = 0;
  for (; column + 4 < k; column += 8) {
    if (forward)
      tl_ldl_forward_tiles(rows, 2, b + column, ldb, w, ld, i);
    else
      tl_ldl_backward_tiles(n, rows, 2, b + column, ldb, w, ld, d, i);
  }
  if (column >= k) return;
  if (forward)
    tl_ldl_forward_tiles(rows, 1, b + column, ldb, w, ld, i);
  else
    tl_ldl_backward_tiles(n, rows, 1, b + column, ldb, w, ld, d, i);
}

/* The rows that are no block of four, if there are any. */
TL_INLINE void tl_ldl_many_last(int forward, int n, int k, tl_real *b, int ldb, const tl_real *w, int ld, const tl_real *d) {
  if (n % 4 == 1) tl_ldl_many_rows(forward, n, 1, k, b, ldb, w, ld, d, n - 1);
  if (n % 4 == 2) tl_ldl_many_rows(forward, n, 2, k, b, ldb, w, ld, d, n - 2);
  if (n % 4 == 3) tl_ldl_many_rows(forward, n, 3, k, b, ldb, w, ld, d, n - 3);
}

TL_INLINE void tl_ldl_solve_many_blocks(int n, int k, tl_real *b, int ldb, const tl_real *w, int ld, const tl_real *d) {
  const int end = n / 4 * 4;
  for (int i = 0; i < end; i += 4) tl_ldl_many_rows(1, n, 4, k, b, ldb, w, ld, d, i);
  tl_ldl_many_last(1, n, k, b, ldb, w, ld, d);
  tl_ldl_many_last(0, n, k, b, ldb, w, ld, d);
  for (int i = end - 4; i >= 0; i -= 4) tl_ldl_many_rows(0, n, 4, k, b, ldb, w, ld, d, i);
}

#endif

/* ---- what a caller uses ---- */

/* Factors the M in w. Returns the pivot ratio max_i(M_ii/d_i): 1 for a diagonal M, and never much more than the condition number of M
 * scaled to a diagonal of ones; infinite or no number where a pivot is not positive or out of range (M is then not positive definite to
 * working precision, or its numbers are beyond the square root of the range of numbers), and nothing in w and d is of use: so what
 * serves has a ratio <= TL_MAX. */
TL_INLINE tl_real tl_ldl_factor(int n, tl_real *w, int ld, tl_real *d) {
#if TL_VECTORS
  if (n > TL_LDL_SCALAR) return tl_ldl_factor_blocks(n, w, ld, d, NULL);
#else
  if (n > TL_LDL_SCALAR) return tl_ldl_factor_scalar_by_loops(n, w, ld, d);
#endif
  return tl_ldl_factor_scalar(n, w, ld, d);
}

/* x = M^-1 b from the factors. x may be b. */
TL_INLINE void tl_ldl_solve(int n, tl_real *x, const tl_real *w, int ld, tl_real *d, const tl_real *b) {
#if TL_VECTORS
  if (n > TL_LDL_SCALAR) {
    tl_real *y = d + TL_ROW(n);
    for (int i = 0; i < n; i++) y[i] = b[i];
    tl_ldl_solve_blocks(n, x, y, w, ld, d);
    return;
  }
#else
  if (n > TL_LDL_SCALAR) {
    if (x != b) memcpy(x, b, (size_t)n * sizeof *x);
    tl_ldl_solve_scalar_by_loops(n, x, w, ld, d);
    return;
  }
#endif
  tl_real y[TL_LDL_SCALAR];
  TL_UNROLL for (int i = 0; i < n; i++) y[i] = b[i];
  tl_ldl_solve_scalar(n, y, w, ld, d);
  TL_UNROLL for (int i = 0; i < n; i++) x[i] = y[i];
}

/* Both at once, which is faster. x has no meaning where the ratio is not finite. */
TL_INLINE tl_real tl_ldl_factor_solve(int n, tl_real *x, tl_real *w, int ld, tl_real *d, const tl_real *b) {
#if TL_VECTORS
  if (n > TL_LDL_SCALAR) {
    tl_real *y = d + TL_ROW(n);
    for (int i = 0; i < n; i++) y[i] = b[i];
    const tl_real ratio = tl_ldl_factor_blocks(n, w, ld, d, y);
    tl_ldl_back(n, x, y, w, ld);
    return ratio;
  }
#endif
  const tl_real ratio = tl_ldl_factor(n, w, ld, d);
  tl_ldl_solve(n, x, w, ld, d, b);
  return ratio;
}

/* The same for a column of B, or its negative. x may be b. */
TL_INLINE void tl_ldl_solve_column(int negated, int n, tl_real *x, int ldx, const tl_real *b, int ldb, const tl_real *w, int ld,
                                   const tl_real *d) {
  tl_real y[TL_LDL_SCALAR];
  TL_UNROLL for (int i = 0; i < n; i++) y[i] = b[i * ldb];
  tl_ldl_solve_scalar(n, y, w, ld, d);
  TL_UNROLL for (int i = 0; i < n; i++) x[i * ldx] = negated ? -y[i] : y[i];
}

/* For k columns, one after the other. */
TL_INLINE void tl_ldl_solve_columns(int negated, int n, int k, tl_real *x, int ldx, const tl_real *b, int ldb, const tl_real *w, int ld,
                                    tl_real *d) {
#if !TL_VECTORS
  if (n > TL_LDL_SCALAR) {
    tl_real *y = d + TL_ROW(n);
    for (int j = 0; j < k; j++) {
      for (int i = 0; i < n; i++) y[i] = b[i * ldb + j];
      tl_ldl_solve_scalar_by_loops(n, y, w, ld, d);
      for (int i = 0; i < n; i++) x[i * ldx + j] = negated ? -y[i] : y[i];
    }
    return;
  }
  if (n * n * k > TL_LDL_STRAIGHT) {
    for (int j = 0; j < k; j++) tl_ldl_solve_column(negated, n, x + j, ldx, b + j, ldb, w, ld, d);
    return;
  }
#endif
  TL_UNROLL for (int j = 0; j < k; j++) tl_ldl_solve_column(negated, n, x + j, ldx, b + j, ldb, w, ld, d);
}

/* B = M^-1 B for k right-hand sides: row i of b, of length ldb >= TL_ROW(k), holds the i-th numbers of all of them. What b holds from
 * column k on need not be set and is lost. */
TL_INLINE void tl_ldl_solve_many(int n, int k, tl_real *b, int ldb, const tl_real *w, int ld, tl_real *d) {
#if TL_VECTORS
  if (n * k > TL_LDL_SCALAR * TL_LDL_SCALAR / 2 || n > TL_LDL_SCALAR) {
    tl_ldl_solve_many_blocks(n, k, b, ldb, w, ld, d);
    return;
  }
#endif
  tl_ldl_solve_columns(0, n, k, b, ldb, b, ldb, w, ld, d);
}

/* X = -M^-1 B, with rows of x k numbers apart. B is lost. */
TL_INLINE void tl_ldl_solve_negated(int n, int k, tl_real *x, tl_real *b, int ldb, const tl_real *w, int ld, tl_real *d) {
#if TL_VECTORS
  tl_ldl_solve_many(n, k, b, ldb, w, ld, d);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < k; j++) x[i * k + j] = -b[i * ldb + j];
#else
  tl_ldl_solve_columns(1, n, k, x, k, b, ldb, w, ld, d);
#endif
}

#endif
