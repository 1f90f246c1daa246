/* Blocks: products of homogeneous parts, and the recurrences that several functions share. */
#include "block.h"
#include "taylor/kernel.h"

/* Blocks of one number are those of a jet along a curve, and many: they take no loop. */
void tl_row_zero(int n, tl_real *c) {
  if (n == 1)
    *c = TL_C(0.0);
  else
    for (int i = 0; i < n; i++) c[i] = TL_C(0.0);
}

void tl_row_scale(int n, tl_real *c, tl_real x) {
  if (n == 1)
    *c *= x;
  else
    for (int i = 0; i < n; i++) c[i] *= x;
}

void tl_row_divide(int n, tl_real *c, tl_real d) {
  if (n == 1)
    *c /= d;
  else
    for (int i = 0; i < n; i++) c[i] /= d;
}

/* Division by 1, 2 or 4 is exact multiplication by the reciprocal, several times faster. */
void tl_row_divide_weight(int n, tl_real *c, int w) {
  if (w == 1) return;
  if ((w & (w - 1)) == 0)
    tl_row_scale(n, c, TL_C(1.0) / TL_FROM(w));
  else
    tl_row_divide(n, c, TL_FROM(w));
}

void tl_row_add(int n, tl_real *restrict c, tl_real x, const tl_real *restrict a) {
  if (n == 1)
    *c += x * *a;
  else
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

/* The same for two blocks of order p > 1, whose products i and j, and j and i, have one place table[i*n + j]. */
static void add_square_by_table(tl_real *restrict c, tl_real x, int n, const tl_real *a, const tl_real *b, const unsigned *table) {
  for (int i = 0; i < n; i++, table += n) {
    const tl_real ai = x * a[i], bi = x * b[i];
    c[table[i]] += ai * b[i];
    for (int j = i + 1; j < n; j++) c[table[j]] += ai * b[j] + bi * a[j];
  }
}

/* Two products that go to the same places. */
typedef struct pair {
  int p, q;                      /* orders of their factors, p <= q */
  tl_real x, y;                  /* x * low_a (x) high_b + y * low_b (x) high_a */
  const tl_real *low_a, *high_b; /* blocks of order p and q */
  const tl_real *low_b, *high_a;
} pair;

static void add_pair_by_table(tl_real *restrict c, const pair *t, int nlow, int nhigh, const unsigned *table) {
  const tl_real *a = t->high_a, *b = t->high_b;
  for (int i = 0; i < nlow; i++, table += nhigh) {
    const tl_real ai = t->x * t->low_a[i], bi = t->y * t->low_b[i];
    for (int j = 0; j < nhigh; j++) c[table[j]] += ai * b[j] + bi * a[j];
  }
}

static void add_pair(const tl_shape *s, tl_real *out, const pair *t) {
  if (t->q == 1) {
    add_outer(s->nvar, out, t->x, t->low_a, t->high_b);
    add_outer(s->nvar, out, t->y, t->low_b, t->high_a);
  } else {
    add_pair_by_table(out, t, s->nhom[t->p], s->nhom[t->q], s->product[t->p][t->q]);
  }
}

/* A product of blocks of the same order and the same power of s. */
static void add_square(const tl_shape *s, tl_real *out, tl_real x, int p, const tl_real *a, const tl_real *b) {
  if (p == 1)
    add_outer(s->nvar, out, x, a, b);
  else
    add_square_by_table(out, x, s->nhom[p], a, b, s->product[p][p]);
}

#if TL_VECTORS
/* Adds the terms of four powers of s at a time from *i on, as long as there are four; a[*i ..] against g[k - *i ..] downwards. */
static void add_curve_by_four(int k, int *i, tl_real *sum, tl_factor f, const tl_real *a, const tl_real *g) {
  tl_v4 total = {TL_C(0.0)}, first = {TL_C(1.0), TL_C(2.0), TL_C(3.0), TL_C(4.0)}, second = TL_FROM(k) - first;
  for (; *i + 4 <= k; *i += 4) {
    const tl_v4 ahead = TL_V4_CONST(g + k - *i - 3), back = __builtin_shufflevector(ahead, ahead, 3, 2, 1, 0);
    total += (f.z + f.u * first + f.v * second) * TL_V4_CONST(a + *i) * back;
    first += TL_C(4.0);
    second -= TL_C(4.0);
  }
  *sum += (total[0] + total[1]) + (total[2] + total[3]);
}
#endif

/* The interior sum of a scalar block: plain convolution over the powers of s. */
static void add_interior_curve(int k, tl_real *out, tl_factor f, const tl_real *a, const tl_real *g) {
  tl_real sum = TL_C(0.0);
  int i = 1;
#if TL_VECTORS
  if (k > 4) add_curve_by_four(k, &i, &sum, f, a, g);
#endif
  for (; i < k; i++) sum += (f.z + f.u * TL_FROM(i) + f.v * TL_FROM(k - i)) * a[i] * g[k - i];
  *out += sum;
}

/* The terms with a scalar: out += sum over k > 0 of (z + u k + v (p+l)) a_k g_(p,l) and the other way round, l = b.k - k. */
static void add_scalars(const tl_shape *s, tl_block b, tl_real *restrict out, tl_factor f, const tl_real *a, const tl_real *g) {
  enum { AT_ONCE = 4 };
  tl_real x[TL_MAX_CURVE + 1], y[TL_MAX_CURVE + 1];
  const int n = b.n;
  for (int k = 1; k <= b.k; k++) {
    const tl_real low = TL_FROM(k), high = TL_FROM(b.weight - k);
    x[k] = (f.z + f.u * low + f.v * high) * a[k];
    y[k] = (f.z + f.u * high + f.v * low) * g[k];
  }
  int i = 0;
  for (; i + AT_ONCE <= n; i += AT_ONCE) {
    const tl_real *ai = a + s->start[b.p] + i, *gi = g + s->start[b.p] + i;
    tl_real sum[AT_ONCE];
    for (int j = 0; j < AT_ONCE; j++) sum[j] = out[i + j];
    for (int k = 1; k <= b.k; k++)
      for (int j = 0; j < AT_ONCE; j++) sum[j] += x[k] * gi[(b.k - k) * n + j] + y[k] * ai[(b.k - k) * n + j];
    for (int j = 0; j < AT_ONCE; j++) out[i + j] = sum[j];
  }
  for (; i < n; i++) {
    const tl_real *ai = a + s->start[b.p] + i, *gi = g + s->start[b.p] + i;
    for (int k = 1; k <= b.k; k++) out[i] += x[k] * gi[(b.k - k) * n] + y[k] * ai[(b.k - k) * n];
  }
}

/* For each two blocks (p,k) and (q,l) that make up B, p <= q, both products: a's first with g's second, and the other way round. */
void tl_add_interior(const tl_shape *s, tl_block b, tl_real *out, tl_factor f, const tl_real *a, const tl_real *g) {
  if (b.p == 0) {
    add_interior_curve(b.k, out, f, a, g);
    return;
  }
  if (b.k > 0) add_scalars(s, b, out, f, a, g);
  for (int p = 1; 2 * p <= b.p; p++) {
    const int q = b.p - p, last = p == q ? b.k / 2 : b.k;
    for (int k = 0; k <= last; k++) {
      const int l = b.k - k, low = s->start[p] + k * s->nhom[p], high = s->start[q] + l * s->nhom[q];
      const tl_real w1 = TL_FROM(p + k), w2 = TL_FROM(q + l);
      const tl_real x = f.z + f.u * w1 + f.v * w2, y = f.z + f.u * w2 + f.v * w1;
      if (p == q && k == l)
        add_square(s, out, x, p, a + low, g + low);
      else
        add_pair(s, out,
                 &(pair){.p = p, .q = q, .x = x, .y = y, .low_a = a + low, .high_b = g + high, .low_b = g + low, .high_a = a + high});
    }
  }
}

void tl_reject(tl_ctx *cx, tl_real *c, unsigned bits, tl_fn function) { tl_reject_in_lane(cx, c, bits, function, 0); }

void tl_reject_in_lane(tl_ctx *cx, tl_real *c, unsigned bits, tl_fn function, int lane) {
  tl_fail_in_lane(cx, bits, function, lane);
  for (int i = 0; i < cx->shape->ncoef; i++) c[i] = TL_FROM(NAN);
}

int tl_accept(tl_ctx *cx, tl_real *c, tl_real x, tl_fn function) {
  if (TL_EVERY(TL_ISFINITE(x))) return 1;
  tl_reject_in_lane(cx, c, TL_NONFINITE, function, TL_FIRST(x - x != TL_C(0.0)));
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
  const tl_real total = sum[0] + sum[1] + sum[2] + sum[3];
  if (TL_SOME(total != TL_C(0.0))) tl_fail_in_lane(cx, TL_NONFINITE, function, TL_FIRST(total != TL_C(0.0)));
}

const tl_real *tl_unaliased(tl_ctx *cx, const tl_real *a, const tl_real *c, int i) {
  if (a != c) return a;
  tl_real *copy = tl_scratch(cx, i);
  for (int j = 0; j < cx->shape->ncoef; j++) copy[j] = a[j];
  return copy;
}

#ifndef TL_REAL_LANES
tl_real tl_normaliser(tl_real x) {
  int e = 0;
  if (x == TL_C(0.0)) return TL_C(1.0);
  (void)TL_LIBM(frexp)(x, &e);
  const int limit = -TL_MIN_EXP;
  const int shift = e - 1 < -limit ? limit : e - 1 > limit ? -limit : 1 - e;
  return TL_LIBM(ldexp)(TL_C(1.0), shift);
}
#endif

/* In a univariate series a recurrence adds what a coefficient contributes to all later ones as soon as it is known: unlike a sum over
 * all earlier ones that is a loop over numbers beside each other, and nothing waits for its last term. Until then c holds such sums. */

/* k c_k = u sum_{i>0} i a_i c_(k-i). */
static void exp_series(int n, tl_real *c, tl_real u, const tl_real *a) {
  tl_real slope[TL_MAX_CURVE + 1];
  const tl_real first = u * c[0];
  for (int i = 1; i < n; i++) {
    slope[i] = u * TL_FROM(i) * a[i];
    c[i] = TL_C(0.0);
  }
  for (int k = 1; k < n; k++) {
    c[k] = c[k] / TL_FROM(k) + first * a[k];
    const tl_real x = c[k];
    for (int i = 1; i < n - k; i++) c[k + i] += x * slope[i];
  }
}

/* The same for E s = c E a, E c = sign s E a; the terms with s_0 and c_0 are taken out of the sums, as in tl_exp_blocks. */
static void circle_series(int n, tl_real *sine, tl_real *cosine, tl_real sign, const tl_real *a) {
  tl_real slope[TL_MAX_CURVE + 1];
  for (int i = 1; i < n; i++) {
    slope[i] = TL_FROM(i) * a[i];
    sine[i] = cosine[i] = TL_C(0.0);
  }
  for (int k = 1; k < n; k++) {
    const tl_real s = sine[k] / TL_FROM(k) + cosine[0] * a[k], c = sign * (cosine[k] / TL_FROM(k) + sine[0] * a[k]);
    sine[k] = s;
    cosine[k] = c;
    for (int i = 1; i < n - k; i++) {
      sine[k + i] += c * slope[i];
      cosine[k + i] += s * slope[i];
    }
  }
}

void tl_circle_blocks(const tl_shape *s, tl_real *sine, tl_real *cosine, tl_real sign, const tl_real *a) {
  if (tl_is_series(s)) {
    circle_series(s->ncoef, sine, cosine, sign, a);
    return;
  }
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    tl_real *sB = sine + b.at, *cB = cosine + b.at;
    tl_row_zero(b.n, sB);
    tl_row_zero(b.n, cB);
    tl_add_interior(s, b, sB, (tl_factor){.u = TL_C(1.0)}, a, cosine);
    tl_add_interior(s, b, cB, (tl_factor){.u = sign}, a, sine);
    tl_row_divide_weight(b.n, sB, b.weight);
    tl_row_divide_weight(b.n, cB, b.weight);
    tl_row_add(b.n, sB, cosine[0], a + b.at);
    tl_row_add(b.n, cB, sign * sine[0], a + b.at);
  }
}

/* k q a_0 c_k = sum_{i>0} (p i - q (k-i)) a_i c_(k-i). */
static void power_series(int n, tl_real *c, tl_real p, tl_real q, const tl_real *a) {
  for (int i = 1; i < n; i++) c[i] = TL_C(0.0);
  for (int k = 0; k < n; k++) {
    if (k > 0) c[k] /= q * TL_FROM(k) * a[0];
    const tl_real x = c[k], qk = q * TL_FROM(k);
    for (int i = 1; i < n - k; i++) c[k + i] += (p * TL_FROM(i) - qk) * x * a[i];
  }
}

/* |B| c_B = u sum_{B1>0} |B1| a_B1 c_B2; the term B1 = B is taken out of the sum, so that it is not rounded by the weight. */
void tl_exp_blocks(const tl_shape *s, tl_real *c, tl_real u, const tl_real *a) {
  if (tl_is_series(s))
    exp_series(s->ncoef, c, u, a);
  else
    tl_integral_blocks(s, c, u, c, a);
}

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
  if (tl_is_series(s)) {
    power_series(s->ncoef, c, p, q, a);
    return;
  }
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    const tl_real w = TL_FROM(b.weight);
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
    const tl_real w = TL_FROM(b.weight);
    tl_row_zero(b.n, c + b.at);
    tl_add_interior(s, b, c + b.at, (tl_factor){.u = -TL_C(1.0)}, c, a);
    tl_row_add(b.n, c + b.at, rate * w, a + b.at);
    tl_row_divide(b.n, c + b.at, w * a[0]);
  }
}

/* b_0 c_k = a_k - sum_{i>0} c_(k-i) b_i for univariate series. */
static void quotient_series(int n, tl_real *c, const tl_real *a, const tl_real *b) {
  for (int i = 1; i < n; i++) c[i] = a[i];
  for (int k = 0; k < n; k++) {
    if (k > 0) c[k] /= b[0];
    const tl_real x = c[k];
    for (int i = 1; i < n - k; i++) c[k + i] -= x * b[i];
  }
}

/* b_0 c_B = a_B - sum_{B2>0} c_B1 b_B2, from c_0 = a_0/b_0. c may be a, whose blocks are each read once, just before c's is written;
 * c may not be b. */
void tl_quotient_blocks(const tl_shape *s, tl_real *c, const tl_real *a, const tl_real *b) {
  if (tl_is_series(s)) {
    quotient_series(s->ncoef, c, a, b);
    return;
  }
  for (tl_block B = tl_first_block(s); B.n; B = tl_next_block(s, B)) {
    tl_real *cB = c + B.at;
    const tl_real *aB = a + B.at, *bB = b + B.at;
    for (int i = 0; i < B.n; i++) cB[i] = aB[i] - c[0] * bB[i];
    tl_add_interior(s, B, cB, (tl_factor){.z = -TL_C(1.0)}, c, b);
    tl_row_divide(B.n, cB, b[0]);
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

/* c_k = sum_i a_i b_(k-i) for univariate series, some powers at a time: b is read from behind zeros. */
static void convolve(int n, tl_real *c, const tl_real *a, const tl_real *b) {
  enum { AT_ONCE = 8, ZEROS = AT_ONCE - 1 };
  tl_real padded[ZEROS + TL_MAX_CURVE + AT_ONCE] = {TL_C(0.0)}, factor[TL_MAX_CURVE + 1], sum[AT_ONCE];
  for (int i = 0; i < n; i++) {
    padded[ZEROS + i] = b[i];
    factor[i] = a[i];
  }
  for (int k = 0; k < n; k += AT_ONCE) {
    const int top = k + AT_ONCE < n ? k + AT_ONCE : n;
    for (int j = 0; j < AT_ONCE; j++) sum[j] = TL_C(0.0);
    for (int i = 0; i < top; i++)
      for (int j = 0; j < AT_ONCE; j++) sum[j] += factor[i] * padded[ZEROS + k - i + j];
    for (int j = 0; k + j < top; j++) c[k + j] = sum[j];
  }
}

/* c_B = a_0 b_B + b_0 a_B + sum_{B1,B2>0} a_B1 b_B2. Descending order: a block of the product needs no higher block of the operands,
 * so that c may be an operand. */
void tl_product_blocks(const tl_shape *s, tl_real *c, const tl_real *a, const tl_real *b) {
  if (tl_is_series(s)) {
    convolve(s->ncoef, c, a, b);
    return;
  }
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
      tl_row_zero(b.n, c + b.at);
      tl_add_interior(s, b, c + b.at, (tl_factor){.z = TL_C(1.0)}, c, h);
      tl_row_add(b.n, c + b.at, c[0], h + b.at); /* often the largest term: it is rounded once */
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
