/* Shapes: sizes, ranks of monomials, product tables. */
#include "taylor/shape.h"

#include <assert.h>
#include <limits.h>
#include <stdint.h>

/* binomial(n, r) by the partial products binomial(n-r+i, i), each a count of monomials of a lower order. Callers have made sure that
 * these fit an int, or go up through the orders and stop at the first that does not; so no product reaches 2^64. */
static uint64_t binomial(int64_t n, int r) {
  uint64_t c = 1;
  for (int i = 1; i <= r; i++) c = c * (uint64_t)(n - r + i) / (uint64_t)i;
  return c;
}

/* Monomials of order p in nvar variables. */
static uint64_t count_monomials(int nvar, int p) { return p == 0 ? 1 : nvar == 0 ? 0 : binomial((int64_t)nvar + p - 1, p); }

static int effective_order(tl_spec spec) { return spec.nvar == 0 ? 0 : spec.order; }

static int is_spec(tl_spec spec) {
  return spec.curve >= 0 && spec.curve <= TL_MAX_CURVE && spec.nvar >= 0 && spec.order >= 0 && spec.order <= TL_MAX_ORDER;
}

tl_spec tl_jacobian(int nvar) { return (tl_spec){.curve = 0, .nvar = nvar, .order = 1}; }
tl_spec tl_hessian(int nvar) { return (tl_spec){.curve = 0, .nvar = nvar, .order = 2}; }
tl_spec tl_third_order(int nvar) { return (tl_spec){.curve = 0, .nvar = nvar, .order = 3}; }
tl_spec tl_complete(int nvar, int order) { return (tl_spec){.curve = 0, .nvar = nvar, .order = order}; }
tl_spec tl_univariate(int order) { return (tl_spec){.curve = order, .nvar = 0, .order = 0}; }
tl_spec tl_motion(int curve, int ntangent) { return (tl_spec){.curve = curve, .nvar = ntangent, .order = 1}; }

int tl_ncoef(tl_spec spec) {
  if (!is_spec(spec)) return 0;
  uint64_t n = 0;
  for (int p = 0; p <= effective_order(spec); p++) {
    n += (uint64_t)(spec.curve + 1) * count_monomials(spec.nvar, p);
    if (n > INT_MAX) return 0;
  }
  return (int)n;
}

/* A pair of orders has a table where neither is a scalar, they are not two rows, and their product is in the shape. */
static int has_table(int order, int p, int q) { return 1 <= p && p <= q && q >= 2 && p + q <= order; }

size_t tl_shape_bytes(tl_spec spec) {
  if (tl_ncoef(spec) == 0) return 0;
  const int order = effective_order(spec);
  size_t bytes = 0;
  for (int p = 1; p <= order; p++)
    for (int q = p; p + q <= order; q++) {
      if (!has_table(order, p, q)) continue;
      const size_t row = (size_t)count_monomials(spec.nvar, q) * sizeof(unsigned), rows = (size_t)count_monomials(spec.nvar, p);
      if (row > (SIZE_MAX - bytes) / rows) return SIZE_MAX;
      bytes += rows * row;
    }
  return bytes;
}

/* Rank of t_i1 .. t_ip, i1 <= .. <= ip, among the monomials of order p in lexicographic order. With r factors to follow,
 * binomial(nvar-i+r-1, r) monomials share the prefix that ends in i; summed over i = last .. x-1 these are
 * binomial(nvar-last+r, r+1) - binomial(nvar-x+r, r+1). */
static unsigned rank_factors(int nvar, int p, const int *factor) {
  uint64_t rank = 0;
  int last = 0;
  for (int j = 0; j < p; j++) {
    const int r = p - 1 - j;
    rank += binomial((int64_t)nvar - last + r, r + 1) - binomial((int64_t)nvar - factor[j] + r, r + 1);
    last = factor[j];
  }
  return (unsigned)rank;
}

/* The next monomial of order p in lexicographic order. */
static void next_factors(int nvar, int p, int *factor) {
  int j = p - 1;
  while (j > 0 && factor[j] == nvar - 1) j--;
  const int i = factor[j] + 1;
  for (; j < p; j++) factor[j] = i;
}

/* m = the factors of a and of b in ascending order. */
static void merge_factors(int *m, const int *a, int p, const int *b, int q) {
  int i = 0, j = 0;
  while (i + j < p + q) {
    const int take_a = j == q || (i < p && a[i] <= b[j]);
    m[i + j] = take_a ? a[i] : b[j];
    if (take_a)
      i++;
    else
      j++;
  }
}

static void fill_table(const tl_shape *s, int p, int q, unsigned *table) {
  int a[TL_MAX_ORDER] = {0}, b[TL_MAX_ORDER], m[2 * TL_MAX_ORDER];
  for (int i = 0; i < s->nhom[p]; i++) {
    for (int f = 0; f < q; f++) b[f] = 0;
    for (int j = 0; j < s->nhom[q]; j++) {
      merge_factors(m, a, p, b, q);
      *table++ = rank_factors(s->nvar, p + q, m);
      next_factors(s->nvar, q, b);
    }
    next_factors(s->nvar, p, a);
  }
}

int tl_shape_init(tl_shape *s, tl_spec spec, void *memory, size_t bytes) {
  const int ncoef = tl_ncoef(spec);
  if (ncoef == 0 || bytes < tl_shape_bytes(spec)) return -1;
  *s = (tl_shape){.curve = spec.curve, .nvar = spec.nvar, .order = effective_order(spec), .ncoef = ncoef};
  s->nblock = (s->curve + 1) * (s->order + 1);
  s->degree = s->curve + s->order;
  for (int p = 0, at = 0; p <= s->order; p++) {
    s->nhom[p] = (int)count_monomials(s->nvar, p);
    s->start[p] = at;
    at += (s->curve + 1) * s->nhom[p];
  }
  unsigned *table = memory;
  for (int p = 1; p <= s->order; p++)
    for (int q = p; p + q <= s->order; q++) {
      if (!has_table(s->order, p, q)) continue;
      fill_table(s, p, q, table);
      s->product[p][q] = table;
      table += (size_t)s->nhom[p] * (size_t)s->nhom[q];
    }
  return 0;
}

/* Position of s^k times the p factors; -1 outside the shape. */
static int position(const tl_shape *s, int k, int p, const int *factor) {
  if (k < 0 || k > s->curve || p > s->order) return -1;
  return s->start[p] + k * s->nhom[p] + (int)rank_factors(s->nvar, p, factor);
}

int tl_index(const tl_shape *s, int k, const int *alpha) {
  int factor[TL_MAX_ORDER] = {0}, p = 0;
  for (int i = 0; alpha && i < s->nvar; i++)
    for (int e = 0; e < alpha[i]; e++) {
      if (p == s->order) return -1;
      factor[p++] = i;
    }
  return position(s, k, p, factor);
}

int tl_index1(const tl_shape *s, int k, int i) {
  assert(i >= 0 && i < s->nvar);
  return position(s, k, 1, &i);
}

int tl_index2(const tl_shape *s, int k, int i, int j) {
  assert(i >= 0 && i < s->nvar && j >= 0 && j < s->nvar);
  return position(s, k, 2, (int[2]){i < j ? i : j, i < j ? j : i});
}

void tl_monomial(const tl_shape *s, int at, int *k, int *alpha) {
  assert(at >= 0 && at < s->ncoef);
  int p = s->order;
  while (at < s->start[p]) p--;
  *k = (at - s->start[p]) / s->nhom[p];
  uint64_t rank = (uint64_t)((at - s->start[p]) % s->nhom[p]);
  for (int i = 0; i < s->nvar; i++) alpha[i] = 0;
  for (int i = 0, r = p - 1; r >= 0; r--) {
    for (uint64_t n; rank >= (n = count_monomials(s->nvar - i, r)); i++) rank -= n;
    alpha[i]++;
  }
}
