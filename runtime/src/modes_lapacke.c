/* Modes through LAPACKE's geevx. */
#include "eom/modes.h"

#include "lapack.h"
#include "linalg.h"

#include <assert.h>
#include <stdbool.h>

/* Workspace of geevx for both sets of eigenvectors and the conditions of eigenvalues. */
static size_t geevx_work(size_t d) { return d * (d + 6); }

/* F, left and right eigenvectors; re, im, scale, conditions of eigenvalues and of eigenvectors, an imaginary part. */
size_t eom_modes_work(int d) {
  const size_t k = (size_t)d;
  return 3 * k * k + 6 * k + geevx_work(k);
}

/* One mode as geevx leaves it: v1 the real part of its eigenvector, v2 the imaginary part, null where it has none. */
typedef struct raw {
  tl_real re, im, reciprocal;
  const tl_real *v1, *v2;
  tl_real sign; /* of v2 */
} raw;

/* All eigenvalues in LAPACK's order: d of each. */
typedef struct spectrum {
  int d;
  tl_real *re, *im, *reciprocal;
  tl_real *vectors; /* d vectors of d: a real one, or real and imaginary part of a pair */
  tl_real *spare;   /* d */
} spectrum;

static bool is_finite(int count, const tl_real *a) {
  for (int i = 0; i < count; i++)
    if (!TL_ISFINITE(a[i])) return false;
  return true;
}

static eom_status solve(spectrum *out, int d, const tl_real *F, tl_real *work) {
  tl_real *a = work, *left = a + d * d, *right = left + d * d, *re = right + d * d, *im = re + d, *scale = im + d,
          *reciprocal = scale + d;
  tl_real *unused = reciprocal + d, *spare = unused + d, *rest = spare + d;
  if (!is_finite(d * d, F)) return EOM_NOT_FINITE;
  for (int i = 0; i < d; i++)
    for (int j = 0; j < d; j++) a[j * d + i] = F[i * d + j];
  lapack_int low, high, no_integers;
  tl_real norm;
  const int threads = eom_lapack_begin(d);
  const lapack_int info = LAPACK(geevx)(LAPACK_COL_MAJOR, 'B', 'V', 'V', 'E', d, a, d, re, im, left, d, right, d, &low, &high, scale,
                                        &norm, reciprocal, unused, rest, (lapack_int)geevx_work((size_t)d), &no_integers);
  eom_lapack_end(threads);
  assert(info >= 0);
  *out = (spectrum){d, re, im, reciprocal, right, spare};
  return info == 0 ? EOM_OK : EOM_NO_EIGENVALUES;
}

/* Mode i: of a pair, which LAPACK puts side by side with im > 0 first, both vectors serve both. */
static raw mode_at(const spectrum *s, int i) {
  const tl_real *v = s->vectors + i * s->d;
  raw r = {s->re[i], s->im[i], s->reciprocal[i], v, NULL, TL_C(1.0)};
  if (r.im > TL_C(0.0)) r.v2 = v + s->d;
  if (r.im < TL_C(0.0)) r.v1 = v - s->d, r.v2 = v, r.sign = TL_C(-1.0);
  return r;
}

static bool comes_first(const raw *a, const raw *b) {
  const tl_real x = TL_LIBM(fabs)(a->im), y = TL_LIBM(fabs)(b->im);
  if (x != y) return x < y;
  if (a->re != b->re) return a->re < b->re;
  return a->im > b->im;
}

/* How many modes come before mode i in the order that is promised. */
static int place_of(const spectrum *s, int i) {
  const raw r = mode_at(s, i);
  int before = 0;
  for (int k = 0; k < s->d; k++) {
    const raw other = mode_at(s, k);
    before += comes_first(&other, &r) || (k < i && !comes_first(&r, &other));
  }
  return before;
}

static eom_mode describe(const raw *r) {
  const tl_real pi = TL_C(3.14159265358979323846), size = TL_LIBM(hypot)(r->re, r->im);
  return (eom_mode){.re = r->re,
                    .im = r->im,
                    .frequency = TL_LIBM(fabs)(r->im) / (TL_C(2.0) * pi),
                    .damping = size > TL_C(0.0) ? -r->re / size : TL_C(0.0),
                    .condition = TL_C(1.0) / r->reciprocal};
}

/* Divides a complex vector of count numbers by the largest of the first few; the first of those that are so to rounding. */
static void scale_shape(int count, int few, tl_real *x, tl_real *y) {
  const tl_real equal = TL_C(1.0) - TL_LIBM(sqrt)(TL_EPSILON);
  tl_real most = TL_C(0.0);
  int at = 0;
  for (int i = 0; i < few; i++) most = TL_LIBM(fmax)(most, TL_LIBM(hypot)(x[i], y[i]));
  if (most == TL_C(0.0)) return;
  while (TL_LIBM(hypot)(x[at], y[at]) < equal * most) at++;
  const tl_real c = x[at] / most, s = y[at] / most, by = most * (c * c + s * s);
  for (int i = 0; i < count; i++) {
    const tl_real re = (x[i] * c + y[i] * s) / by, im = (y[i] * c - x[i] * s) / by;
    x[i] = re;
    y[i] = im;
  }
  x[at] = TL_C(1.0);
  y[at] = TL_C(0.0);
}

/* A shape of rows numbers: Z v, or v where Z is null. */
static void fill_shape(const spectrum *s, const raw *r, int rows, int few, const tl_real *Z, tl_real *shape) {
  const int d = s->d;
  tl_real *x = shape, *y = shape + rows, *v2 = s->spare;
  for (int i = 0; i < d; i++) v2[i] = r->v2 ? r->sign * r->v2[i] : TL_C(0.0);
  for (int i = 0; i < rows; i++) {
    x[i] = Z ? TL_C(0.0) : r->v1[i];
    y[i] = Z ? TL_C(0.0) : v2[i];
    for (int k = 0; Z && k < d; k++) {
      x[i] += Z[i * d + k] * r->v1[k];
      y[i] += Z[i * d + k] * v2[k];
    }
  }
  scale_shape(rows, few, x, y);
}

static eom_status find(eom_mode *modes, tl_real *shapes, int d, const tl_real *F, int rows, int few, const tl_real *Z, tl_real *work) {
  spectrum s;
  const eom_status status = solve(&s, d, F, work);
  if (status != EOM_OK) return status;
  for (int i = 0; i < d; i++) {
    const raw r = mode_at(&s, i);
    const int place = place_of(&s, i);
    modes[place] = describe(&r);
    if (shapes) fill_shape(&s, &r, rows, few, Z, shapes + place * 2 * rows);
  }
  return EOM_OK;
}

eom_status eom_modes(eom_mode *modes, tl_real *shapes, int d, const tl_real *F, tl_real *work) {
  assert(modes && d > 0 && F && work);
  return find(modes, shapes, d, F, d, d, NULL, work);
}

eom_status eom_minimal_modes(eom_mode *modes, tl_real *shapes, const eom_minimal *minimal, tl_real *work) {
  assert(modes && minimal && work);
  if (minimal->d == 0) return EOM_OK;
  return find(modes, shapes, minimal->d, minimal->F, 2 * minimal->n, minimal->n, minimal->Z, work);
}
