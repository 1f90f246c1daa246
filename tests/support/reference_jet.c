/* Truncated power series in high precision. */
#include "reference_jet.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

static int order_of(const ref_shape *s, const int *e) {
  int p = 0;
  for (int i = 1; i <= s->nvar; i++) p += e[i];
  return p;
}

/* Lower order in t first, then lower power of s; within a block the list of factors in lexicographic order, which means the larger
 * exponent of the first variable that differs comes first. */
static int comes_before(const ref_shape *s, const int *a, const int *b) {
  const int p = order_of(s, a), q = order_of(s, b);
  if (p != q) return p < q;
  if (a[0] != b[0]) return a[0] < b[0];
  for (int i = 1; i <= s->nvar; i++)
    if (a[i] != b[i]) return a[i] > b[i];
  return 0;
}

static void insert(ref_shape *s, const int *e) {
  assert(s->n < REF_MAX_COEF);
  int at = s->n++;
  for (; at > 0 && comes_before(s, e, s->exponent[at - 1]); at--) memcpy(s->exponent[at], s->exponent[at - 1], sizeof s->exponent[at]);
  memcpy(s->exponent[at], e, sizeof s->exponent[at]);
}

void ref_shape_init(ref_shape *s, int curve, int nvar, int order) {
  assert(nvar <= REF_MAX_VAR);
  memset(s, 0, sizeof *s);
  s->curve = curve;
  s->nvar = nvar;
  s->order = nvar == 0 ? 0 : order;
  s->degree = s->curve + s->order;
  int e[REF_MAX_VAR + 1] = {0};
  for (;;) { /* count through the box of exponents */
    if (order_of(s, e) <= s->order) insert(s, e);
    int i = 0;
    while (i <= nvar && e[i] == (i == 0 ? s->curve : s->order)) e[i++] = 0;
    if (i > nvar) return;
    e[i]++;
  }
}

int ref_find(const ref_shape *s, const int *e) {
  for (int i = 0; i < s->n; i++)
    if (memcmp(s->exponent[i], e, ((size_t)s->nvar + 1) * sizeof *e) == 0) return i;
  return -1;
}

static int product_place(const ref_shape *s, int i, int j) {
  int e[REF_MAX_VAR + 1];
  for (int k = 0; k <= s->nvar; k++) e[k] = s->exponent[i][k] + s->exponent[j][k];
  return ref_find(s, e);
}

ref_jet ref_new(const ref_shape *s) {
  ref_jet a = {.n = s->n, .c = malloc((size_t)s->n * sizeof(mpfr_t))};
  if (!a.c) abort();
  for (int i = 0; i < a.n; i++) {
    mpfr_init2(a.c[i], REF_PRECISION);
    mpfr_set_zero(a.c[i], 1);
  }
  return a;
}

void ref_free(ref_jet *a) {
  for (int i = 0; i < a->n; i++) mpfr_clear(a->c[i]);
  free(a->c);
  a->c = NULL;
}

void ref_set(ref_jet *c, const double *a) {
  for (int i = 0; i < c->n; i++) mpfr_set_d(c->c[i], a[i], MPFR_RNDN);
}

static void copy(ref_jet *c, const ref_jet *a) {
  for (int i = 0; i < c->n; i++) mpfr_set(c->c[i], a->c[i], MPFR_RNDN);
}

void ref_mul(const ref_shape *s, ref_jet *c, const ref_jet *a, const ref_jet *b) {
  ref_jet sum = ref_new(s);
  for (int i = 0; i < s->n; i++)
    for (int j = 0; j < s->n; j++) {
      if (mpfr_zero_p(a->c[i]) || mpfr_zero_p(b->c[j])) continue;
      const int at = product_place(s, i, j);
      if (at >= 0) mpfr_fma(sum.c[at], a->c[i], b->c[j], sum.c[at], MPFR_RNDN);
    }
  copy(c, &sum);
  ref_free(&sum);
}

void ref_add_scaled(ref_jet *c, mpfr_srcptr x, const ref_jet *a) {
  for (int i = 0; i < c->n; i++) mpfr_fma(c->c[i], x, a->c[i], c->c[i], MPFR_RNDN);
}

void ref_compose2(const ref_shape *s, ref_jet *c, const ref_jet *a, const ref_jet *b, mpfr_t *f, int degree) {
  ref_jet h = ref_new(s), g = ref_new(s), hi = ref_new(s), term = ref_new(s), sum = ref_new(s);
  copy(&h, a);
  copy(&g, b);
  mpfr_set_zero(h.c[0], 1);
  mpfr_set_zero(g.c[0], 1);
  mpfr_set_ui(hi.c[0], 1, MPFR_RNDN);
  for (int i = 0; i <= degree; i++) {
    copy(&term, &hi);
    for (int j = 0; i + j <= degree; j++) {
      ref_add_scaled(&sum, f[i * (degree + 1) + j], &term);
      ref_mul(s, &term, &term, &g);
    }
    ref_mul(s, &hi, &hi, &h);
  }
  copy(c, &sum);
  ref_free(&h);
  ref_free(&g);
  ref_free(&hi);
  ref_free(&term);
  ref_free(&sum);
}

void ref_add_sensitivity(const ref_shape *s, ref_jet *size, const ref_jet *a, const ref_jet *d) {
  mpfr_t x;
  mpfr_init2(x, REF_PRECISION);
  for (int i = 0; i < s->n; i++)
    for (int j = 0; j < s->n; j++) {
      const int at = product_place(s, i, j);
      if (at < 0) continue;
      mpfr_mul(x, a->c[i], d->c[j], MPFR_RNDN);
      mpfr_abs(x, x, MPFR_RNDN);
      mpfr_add(size->c[at], size->c[at], x, MPFR_RNDN);
    }
  mpfr_clear(x);
}
