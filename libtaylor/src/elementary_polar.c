/* Length and angle of a vector of the plane: hypot and atan2. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

/* A point by its length and the cosine and sine of its angle. */
typedef struct polar {
  tl_wide r, u, v;
} polar;

static polar polar_of(tl_real x, tl_real y) {
  const tl_wide r = tl_wide_sqrt(tl_wide_add(tl_wide_product(x, x), tl_wide_product(y, y)));
  return (polar){.r = r, .u = tl_wide_div(tl_widen(x), r), .v = tl_wide_div(tl_widen(y), r)};
}

/* The places of h^k, h^(k-1) g, .., g^k in a series in (h,g). */
static tl_real *part_of_degree(tl_real *f, int k) { return f + k * (k + 1) / 2; }

/* c = a b, forms of degree p and q: coefficient j belongs to h^(p+q-j) g^j. */
static void multiply_forms(tl_wide *c, const tl_wide *a, int p, const tl_wide *b, int q) {
  for (int j = 0; j <= p + q; j++) c[j] = tl_widen(TL_C(0.0));
  for (int i = 0; i <= p; i++)
    for (int j = 0; j <= q; j++) c[i + j] = tl_wide_add(c[i + j], tl_wide_mul(a[i], b[j]));
}

static void set_part(tl_real *f, int k, const tl_wide *form, tl_wide factor) {
  for (int j = 0; j <= k; j++) part_of_degree(f, k)[j] = tl_narrow(tl_wide_mul(form[j], factor));
}

/* hypot(x+h, y+g) = r |1 + a + i b| = r (1 + a + b^2 (1/2 - a/2 + (4 a^2 - b^2)/8)) to degree 4, a = (u h + v g)/r, b = (u g - v h)/r.
 * Every part is a product, in which no digits are lost where one side is much longer than the other. */
static void length_series(tl_real *f, int degree, const polar *z) {
  const tl_wide along[2] = {z->u, z->v}, across[2] = {tl_wide_neg(z->v), z->u};
  const tl_wide over_r = tl_wide_div(tl_widen(TL_C(1.0)), z->r), half = tl_widen(TL_C(0.5));
  tl_wide square[3], form[TL_WIDE_DEGREE + 1], along2[3], factor = tl_wide_mul(half, over_r);
  if (degree >= 1) set_part(f, 1, along, tl_widen(TL_C(1.0)));
  multiply_forms(square, across, 1, across, 1);
  if (degree >= 2) set_part(f, 2, square, factor);
  factor = tl_wide_neg(tl_wide_mul(factor, over_r));
  multiply_forms(form, square, 2, along, 1);
  if (degree >= 3) set_part(f, 3, form, factor);
  if (degree < 4) return;
  multiply_forms(along2, along, 1, along, 1);
  for (int j = 0; j < 3; j++) {
    along2[j] = tl_wide_add(along2[j], tl_wide_mul(square[j], tl_widen(-TL_C(0.25))));
  }
  multiply_forms(form, square, 2, along2, 2);
  set_part(f, 4, form, tl_wide_neg(tl_wide_mul(factor, over_r)));
}

/* atan2(y+g, x+h) = angle + Im log(1 + w), w = (h + i g)/(x + i y): part k is Im((-1)^(k-1)/k (u - i v)^k (h + i g)^k) / r^k. */
static void angle_series(tl_real *f, int degree, const polar *z) {
  tl_wide re = tl_widen(-TL_C(1.0)), im = tl_widen(TL_C(0.0)); /* -(-1/(x + i y))^k */
  const tl_wide u = tl_wide_div(z->u, z->r), v = tl_wide_div(z->v, z->r);
  for (int k = 1; k <= degree; k++) {
    const tl_wide old = re;
    re = tl_wide_neg(tl_wide_add(tl_wide_mul(old, u), tl_wide_mul(im, v)));
    im = tl_wide_add(tl_wide_mul(old, v), tl_wide_neg(tl_wide_mul(im, u)));
    tl_real binomial = TL_C(1.0);
    for (int j = 0; j <= k; j++) { /* Im(i^j (re + i im)) */
      const tl_wide part = j % 2 ? re : im, weight = tl_wide_div(tl_widen(j % 4 < 2 ? binomial : -binomial), tl_widen((tl_real)k));
      part_of_degree(f, k)[j] = tl_narrow(tl_wide_mul(part, weight));
      binomial = binomial * (tl_real)(k - j) / (tl_real)(j + 1);
    }
  }
}

enum { NPLACE = (TL_WIDE_DEGREE + 1) * (TL_WIDE_DEGREE + 2) / 2 };

/* Scratch jets 2 and 3 = (a,b) brought to the size of 1 by this factor. */
static tl_real load(tl_ctx *cx, const tl_real *a, const tl_real *b) {
  tl_real *x = tl_scratch(cx, 2), *y = tl_scratch(cx, 3);
  const tl_real scale = tl_normaliser(TL_LIBM(fmax)(TL_LIBM(fabs)(a[0]), TL_LIBM(fabs)(b[0])));
  for (int i = 0; i < cx->shape->ncoef; i++) {
    x[i] = scale * a[i];
    y[i] = scale * b[i];
  }
  return scale;
}

/* The length r and the angle of (a,b) with its unit vector (u,v) = (a,b)/r carried along:
 *     E r = u E a + v E b,    r E angle = u E b - v E a,    E u = -v E angle,    E v = u E angle.
 * Unlike r = sqrt(a^2 + b^2) this squares nothing, and loses no digits where one side is much longer than the other. From the values of
 * r, u and v; r may be neither a nor b. */
static void polar_blocks(const tl_shape *s, tl_real *r, tl_real *angle, tl_real *u, tl_real *v, const tl_real *a, const tl_real *b) {
  const tl_factor first = {.u = TL_C(1.0)}, minus_first = {.u = -TL_C(1.0)};
  for (tl_block B = tl_first_block(s); B.n; B = tl_next_block(s, B)) {
    const int n = B.n, at = B.at;
    tl_row_zero(n, r + at);
    tl_add_interior(s, B, r + at, first, a, u);
    tl_add_interior(s, B, r + at, first, b, v);
    tl_row_divide_weight(n, r + at, B.weight);
    tl_row_add(n, r + at, u[0], a + at);
    tl_row_add(n, r + at, v[0], b + at);

    tl_row_zero(n, angle + at);
    tl_add_interior(s, B, angle + at, first, b, u);
    tl_add_interior(s, B, angle + at, minus_first, a, v);
    tl_add_interior(s, B, angle + at, minus_first, angle, r);
    tl_row_divide_weight(n, angle + at, B.weight);
    tl_row_add(n, angle + at, u[0], b + at);
    tl_row_add(n, angle + at, -v[0], a + at);
    tl_row_divide(n, angle + at, r[0]);

    tl_row_zero(n, u + at);
    tl_add_interior(s, B, u + at, minus_first, angle, v);
    tl_row_divide_weight(n, u + at, B.weight);
    tl_row_add(n, u + at, -v[0], angle + at);

    tl_row_zero(n, v + at);
    tl_add_interior(s, B, v + at, first, angle, u);
    tl_row_divide_weight(n, v + at, B.weight);
    tl_row_add(n, v + at, u[0], angle + at);
  }
}

/* The same from the unit vector of (a,b). */
static void length_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const polar *z) {
  const tl_real *x = tl_unaliased(cx, a, c, 0), *y = a == b ? x : tl_unaliased(cx, b, c, 1);
  tl_real *angle = tl_scratch(cx, 2), *u = tl_scratch(cx, 3), *v = tl_scratch(cx, 4);
  u[0] = tl_narrow(z->u);
  v[0] = tl_narrow(z->v);
  angle[0] = TL_C(0.0); /* only its derivatives are used */
  c[0] = TL_LIBM(hypot)(x[0], y[0]);
  polar_blocks(cx->shape, c, angle, u, v, x, y);
}

void tl_hypot(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  if (!tl_accept(cx, c, a[0], TL_FN_hypot) || !tl_accept(cx, c, b[0], TL_FN_hypot)) return;
  const tl_real value = TL_LIBM(hypot)(a[0], b[0]);
  if (value == TL_C(0.0) && cx->shape->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, TL_FN_hypot);
    return;
  }
  const tl_real scale = load(cx, a, b);
  const tl_real *const args[] = {tl_scratch(cx, 2), tl_scratch(cx, 3)};
  const polar z = polar_of(args[0][0], args[1][0]);
  if (cx->shape->degree <= TL_WIDE_DEGREE) {
    tl_real f[NPLACE] = {TL_C(0.0)};
    length_series(f, cx->shape->degree, &z);
    tl_compose_n_blocks(cx, c, 2, args, f);
    tl_row_scale(cx->shape->ncoef, c, TL_C(1.0) / scale);
    c[0] = value;
  } else {
    length_by_recurrence(cx, c, a, b, &z);
  }
  tl_check(cx, c, TL_FN_hypot);
}

/* (x^2 + y^2) E angle = x E y - y E x:
 *     |B| d_0 c_B = |B| (x_0 y_B - y_0 x_B) + sum_{B1,B2>0} (|B2| - |B1|) x_B1 y_B2 - |B1| c_B1 d_B2,    d = x^2 + y^2,
 * with both sides scaled to about 1, which leaves the angle as it is. */
static void angle_by_recurrence(tl_ctx *cx, tl_real *c, tl_real value, const tl_real *u, const tl_real *v) {
  const tl_shape *s = cx->shape;
  tl_real *d = tl_scratch(cx, 0);
  c[0] = value;
  d[0] = u[0] * u[0] + v[0] * v[0];
  tl_square_blocks(s, d, TL_C(1.0), u);
  for (tl_block b = tl_first_block(s); b.n; b = tl_next_block(s, b)) {
    const tl_real w = (tl_real)b.weight;
    tl_add_interior(s, b, d + b.at, (tl_factor){.z = TL_C(1.0)}, v, v);
    tl_row_add(b.n, d + b.at, TL_C(2.0) * v[0], v + b.at);
    tl_row_combine(b.n, c + b.at, w * u[0], v + b.at, -w * v[0], u + b.at);
    tl_add_interior(s, b, c + b.at, (tl_factor){.u = -TL_C(1.0), .v = TL_C(1.0)}, u, v);
    tl_add_interior(s, b, c + b.at, (tl_factor){.u = -TL_C(1.0)}, c, d);
    tl_row_divide(b.n, c + b.at, w * d[0]);
  }
}

void tl_atan2(tl_ctx *cx, tl_real *c, const tl_real *y, const tl_real *x) {
  if (!tl_accept(cx, c, y[0], TL_FN_atan2) || !tl_accept(cx, c, x[0], TL_FN_atan2)) return;
  const tl_real value = TL_LIBM(atan2)(y[0], x[0]);
  if (x[0] == TL_C(0.0) && y[0] == TL_C(0.0) && cx->shape->degree > 0) {
    tl_reject(cx, c, TL_SINGULAR, TL_FN_atan2);
    return;
  }
  (void)load(cx, x, y); /* the angle does not depend on the size */
  const tl_real *const args[] = {tl_scratch(cx, 2), tl_scratch(cx, 3)};
  if (cx->shape->degree <= TL_WIDE_DEGREE) {
    const polar z = polar_of(args[0][0], args[1][0]);
    tl_real f[NPLACE] = {value};
    angle_series(f, cx->shape->degree, &z);
    tl_compose_n_blocks(cx, c, 2, args, f);
  } else {
    angle_by_recurrence(cx, c, value, args[0], args[1]);
  }
  tl_check(cx, c, TL_FN_atan2);
}
