/* Blocks: products of homogeneous parts, and the recurrences that several functions share. */
#include "block.h"

void tl_row_zero(int n, tl_real *c) {
  for (int i = 0; i < n; i++) c[i] = TL_C(0.0);
}

void tl_row_scale(int n, tl_real *c, tl_real x) {
  for (int i = 0; i < n; i++) c[i] *= x;
}

void tl_row_divide(int n, tl_real *c, tl_real d) {
  for (int i = 0; i < n; i++) c[i] /= d;
}

/* Division by 1, 2 or 4 is exact multiplication by the reciprocal, several times faster. */
void tl_row_divide_weight(int n, tl_real *c, int w) {
  if (w == 1) return;
  if ((w & (w - 1)) == 0)
    tl_row_scale(n, c, TL_C(1.0) / (tl_real)w);
  else
    tl_row_divide(n, c, (tl_real)w);
}

void tl_row_add(int n, tl_real *restrict c, tl_real x, const tl_real *restrict a) {
  for (int i = 0; i < n; i++) c[i] += x * a[i];
}

void tl_row_combine(int n, tl_real *c, tl_real x, const tl_real *a, tl_real y, const tl_real *b) {
  for (int i = 0; i < n; i++) c[i] = x * a[i] + y * b[i];
}

/* c += x * a (x) b for two rows of first order: t_i t_j collects a_i b_j and, off the diagonal, a_j b_i. */
static void add_outer(int n, tl_real *restrict c, tl_real x, const tl_real *a, const tl_real *b) {
  for (int i = 0; i < n; i++) {
    const tl_real ai = x * a[i], bi = x * b[i];
    *c += ai * b[i];
    for (int j = 1; j < n - i; j++) c[j] += ai * b[i + j] + bi * a[i + j];
    c += n - i;
  }
}

/* c += x * a (x) b through the places table[i*nb + j] of the products. */
static void add_by_table(tl_real *restrict c, tl_real x, int na, const tl_real *a, int nb, const tl_real *b, const unsigned *table) {
  for (int i = 0; i < na; i++, table += nb) {
    const tl_real ai = x * a[i];
    for (int j = 0; j < nb; j++) c[table[j]] += ai * b[j];
  }
}

/* out += x * a (x) b for a block a of order p and a block b of order q. */
static void add_product(const tl_shape *s, tl_real *out, tl_real x, const tl_real *a, int p, const tl_real *b, int q) {
  if (p == 0)
    tl_row_add(s->nhom[q], out, x * a[0], b);
  else if (q == 0)
    tl_row_add(s->nhom[p], out, x * b[0], a);
  else if (p == 1 && q == 1)
    add_outer(s->nvar, out, x, a, b);
  else if (p <= q)
    add_by_table(out, x, s->nhom[p], a, s->nhom[q], b, s->product[p][q]);
  else
    add_by_table(out, x, s->nhom[q], b, s->nhom[p], a, s->product[q][p]);
}

/* The interior sum of a scalar block: plain convolution over the powers of s. */
static void add_interior_curve(int k, tl_real *out, tl_factor f, const tl_real *a, const tl_real *g) {
  tl_real sum = *out;
  for (int i = 1; i < k; i++) sum += (f.z + f.u * (tl_real)i + f.v * (tl_real)(k - i)) * a[i] * g[k - i];
  *out = sum;
}

void tl_add_interior(const tl_shape *s, tl_block b, tl_real *out, tl_factor f, const tl_real *a, const tl_real *g) {
  if (b.p == 0) {
    add_interior_curve(b.k, out, f, a, g);
    return;
  }
  for (int p = 0; p <= b.p; p++) {
    const int q = b.p - p;
    for (int k = p == 0; k <= b.k - (q == 0); k++) {
      const int l = b.k - k;
      const tl_real x = f.z + f.u * (tl_real)(p + k) + f.v * (tl_real)(q + l);
      add_product(s, out, x, a + s->start[p] + k * s->nhom[p], p, g + s->start[q] + l * s->nhom[q], q);
    }
  }
}

void tl_reject(tl_ctx *cx, tl_real *c, unsigned bits, tl_fn function) {
  tl_fail(cx, bits, function);
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = (tl_real)NAN;
}

int tl_accept(tl_ctx *cx, tl_real *c, tl_real x, tl_fn function) {
  if (TL_ISFINITE(x)) return 1;
  tl_reject(cx, c, TL_NONFINITE, function);
  return 0;
}

/* x - x is zero for a finite x and NaN for any other, and a sum of these keeps the NaN. */
void tl_check(tl_ctx *cx, const tl_real *c, tl_fn function) {
  enum { LANES = 4 }; /* sums that the compiler may keep in one vector */
  tl_real sum[LANES] = {TL_C(0.0)};
  const int n = cx->shape->ncoef;
  int i = 0;
  for (; i + LANES <= n; i += LANES)
    for (int j = 0; j < LANES; j++) sum[j] += c[i + j] - c[i + j];
  for (; i < n; i++) sum[0] += c[i] - c[i];
  if (sum[0] + sum[1] + sum[2] + sum[3] != TL_C(0.0)) tl_fail(cx, TL_NONFINITE, function);
}

const tl_real *tl_unaliased(tl_ctx *cx, const tl_real *a, const tl_real *c, int i) {
  if (a != c) return a;
  tl_real *copy = tl_scratch(cx, i);
  for (int j = 0; j < cx->shape->ncoef; j++) copy[j] = a[j];
  return copy;
}

tl_real tl_normaliser(tl_real x) {
  int e = 0;
  if (x == TL_C(0.0)) return TL_C(1.0);
  (void)TL_LIBM(frexp)(x, &e);
  const int limit = -TL_MIN_EXP;
  const int shift = e - 1 < -limit ? limit : e - 1 > limit ? -limit : 1 - e;
  return TL_LIBM(ldexp)(TL_C(1.0), shift);
}

/* |B| c_B = u sum_{B1>0} |B1| a_B1 c_B2; the term B1 = B is taken out of the sum, so that it is not rounded by the weight. */
void tl_exp_blocks(const tl_shape *s, tl_real *c, tl_real u, const tl_real *a) { tl_integral_blocks(s, c, u, c, a); }

/* |B| c_B = x sum_{B1>0} |B1| a_B1 g_B2; g may be c because only blocks of g below B enter. */
void tl_integral_blocks(const tl_shape *s, tl_real *c, tl_real x, const tl_real *g, const tl_real *a) {
  const tl_real g0 = x * g[0];
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_real *cB = c + b.at;
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, cB, (tl_factor){.u = x}, a, g);
    tl_row_divide_weight(b.n, cB, b.weight);
    tl_row_add(b.n, cB, g0, a + b.at);
  }
}

/* |B| q a_0 c_B = sum_{B1>0} (p|B1| - q|B2|) a_B1 c_B2. */
void tl_power_blocks(const tl_shape *s, tl_real *c, tl_real p, tl_real q, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    const tl_real w = (tl_real)b.weight;
    tl_real *cB = c + b.at;
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, cB, (tl_factor){.u = p, .v = -q}, a, c);
    tl_row_add(b.n, cB, p * w * c[0], a + b.at);
    tl_row_divide(b.n, cB, q * w * a[0]);
  }
}

/* a E c = rate E a:  |B| a_0 c_B = rate |B| a_B - sum_{B1,B2>0} |B1| c_B1 a_B2. Only ratios of a's coefficients enter, which is why a
 * may carry any constant factor. c may not be a. */
void tl_log_blocks(const tl_shape *s, tl_real *c, tl_real rate, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    const tl_real w = (tl_real)b.weight;
    tl_row_zero(b.n, c + b.at);
    tl_add_interior(s, b, c + b.at, (tl_factor){.u = -TL_C(1.0)}, c, a);
    tl_row_add(b.n, c + b.at, rate * w, a + b.at);
    tl_row_divide(b.n, c + b.at, w * a[0]);
  }
}

/* c_B = x (2 a_0 a_B + sum_{B1,B2>0} a_B1 a_B2). */
void tl_square_blocks(const tl_shape *s, tl_real *c, tl_real x, const tl_real *a) {
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_row_zero(b.n, c + b.at);
    tl_add_interior(s, b, c + b.at, (tl_factor){.z = x}, a, a);
    tl_row_add(b.n, c + b.at, TL_C(2.0) * x * a[0], a + b.at);
  }
}

/* c_B = a_0 b_B + b_0 a_B + sum_{B1,B2>0} a_B1 b_B2. Descending order: a block of the product needs no higher block of the operands,
 * so that c may be an operand. */
void tl_product_blocks(const tl_shape *s, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int p = s->order; p >= 0; p--)
    for (int k = s->curve; k >= 0 && p + k > 0; k--) {
      const tl_block B = tl_make_block(s, p, k);
      tl_row_combine(B.n, c + B.at, a[0], b + B.at, b[0], a + B.at);
      tl_add_interior(s, B, c + B.at, (tl_factor){.z = TL_C(1.0)}, a, b);
    }
}

/* c_B <- c_0 h_B + sum_{B1,B2>0} c_B1 h_B2, in descending order so that every c_B1 is still the old one. */
void tl_horner_step(const tl_shape *s, tl_real *c, const tl_real *h, tl_real f, int top) {
  for (int p = s->order; p >= 0; p--)
    for (int k = s->curve; k >= 0; k--) {
      if (p + k == 0 || p + k > top) continue;
      const tl_block b = tl_make_block(s, p, k);
      for (int i = 0; i < b.n; i++) c[b.at + i] = c[0] * h[b.at + i];
      tl_add_interior(s, b, c + b.at, (tl_factor){.z = TL_C(1.0)}, c, h);
    }
  c[0] = f;
}

/* Horner: c = ((f_top h + f_(top-1)) h + ..) h + f_0. After j steps only blocks of weight at most j can be other than zero, and of
 * these only weights at most degree - top + j reach the result. */
void tl_compose_blocks(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *f, int top, int i) {
  const tl_shape *s = cx->shape;
  assert(top >= 0);
  const tl_real *h = tl_unaliased(cx, a, c, i);
  tl_row_zero(s->ncoef, c);
  c[0] = f[top];
  for (int k = top - 1; k >= 0; k--) tl_horner_step(s, c, h, f[k], s->degree - k);
}
