/* Length and angle of a vector of the plane: hypot and atan2. */
#include "block.h"
#include "taylor/elementary.h"
#include "wide.h"

/* A point (x,y) brought to the size of 1, by its length and the cosine and sine of its angle. */
typedef struct polar {
  tl_wide r, u, v;
} polar;

static polar polar_of(tl_real x, tl_real y) {
  const tl_wide r = tl_wide_sqrt(tl_wide_add(tl_wide_product(x, x), tl_wide_product(y, y)));
  return (polar){.r = r, .u = tl_wide_div(tl_widen(x), r), .v = tl_wide_div(tl_widen(y), r)};
}

enum { NPLACE = (TL_WIDE_DEGREE + 1) * (TL_WIDE_DEGREE + 2) / 2 };

/* Two numbers of which one is beyond the other's last place in size: long is the longer, (x,y) = (long, short) or, turned, (short,
 * long). Both are brought to the size of 1 by themselves; apart is the binary logarithm of the ratio of the factors. */
typedef struct unequal {
  tl_real longer, shorter;
  int apart, turned;
} unequal;

/* The coefficients of h^(k-j) g^j of a function of (x+h, y+g), of the parts k = 0..degree, at k (k+1)/2 + j. They belong to (x,y)
 * brought to the size of 1, but for a factor 2^-apart to the power of slight. */
typedef struct plane_series {
  tl_real f[NPLACE];
  int slight[NPLACE];
} plane_series;

static int place_of(int k, int j) { return k * (k + 1) / 2 + j; }

/* c = a b, forms of degree p and q: coefficient j belongs to h^(p+q-j) g^j. */
static void multiply_forms(tl_wide *c, const tl_wide *a, int p, const tl_wide *b, int q) {
  for (int j = 0; j <= p + q; j++) c[j] = tl_widen(TL_C(0.0));
  for (int i = 0; i <= p; i++)
    for (int j = 0; j <= q; j++) c[i + j] = tl_wide_add(c[i + j], tl_wide_mul(a[i], b[j]));
}

static void set_part(plane_series *f, int k, const tl_wide *form, tl_wide factor) {
  for (int j = 0; j <= k; j++) f->f[place_of(k, j)] = tl_narrow(tl_wide_mul(form[j], factor));
}

/* c += x a, forms of degree p. */
static void add_form(tl_wide *c, tl_real x, const tl_wide *a, int p) {
  for (int j = 0; j <= p; j++) c[j] = tl_wide_add(c[j], tl_wide_mul(tl_widen(x), a[j]));
}

/* hypot(x+h, y+g) = r |1 + a + i b|, a = (u h + v g)/r, b = (u g - v h)/r: part k > 1 is r b^2 q_k with
 *     q_2 = 1/2,   k q_k = (3 - 2k) a q_(k-1) + (3 - k) (a^2 + b^2) q_(k-2).
 * It is a product, in which no digits are lost where one side is much longer than the other. The forms here go without 1/r. */
static void length_series(plane_series *f, int degree, const polar *z) {
  const tl_wide along[2] = {z->u, z->v}, across[2] = {tl_wide_neg(z->v), z->u}, one = tl_widen(TL_C(1.0));
  const tl_wide both[3] = {one, tl_widen(TL_C(0.0)), one}, over_r = tl_wide_div(one, z->r);
  tl_wide square[3], q[TL_WIDE_DEGREE + 1][TL_WIDE_DEGREE - 1] = {{tl_widen(TL_C(0.0))}}, form[TL_WIDE_DEGREE + 1], factor = one;
  if (degree >= 1) set_part(f, 1, along, one);
  multiply_forms(square, across, 1, across, 1);
  for (int k = 2; k <= degree; k++) {
    if (k == 2) q[2][0] = tl_widen(TL_C(0.5));
    if (k > 2) {
      multiply_forms(form, along, 1, q[k - 1], k - 3);
      add_form(q[k], (tl_real)(3 - 2 * k), form, k - 2);
    }
    if (k > 3) {
      multiply_forms(form, both, 2, q[k - 2], k - 4);
      add_form(q[k], (tl_real)(3 - k), form, k - 2);
    }
    if (k > 2)
      for (int j = 0; j <= k - 2; j++) q[k][j] = tl_wide_div(q[k][j], tl_widen((tl_real)k));
    factor = tl_wide_mul(factor, over_r);
    multiply_forms(form, square, 2, q[k], k - 2);
    set_part(f, k, form, factor);
  }
}

/* binomial(p, k) of any p. */
static tl_real binomial(tl_real p, int k) {
  tl_real b = TL_C(1.0);
  for (int i = 0; i < k; i++) b = b * (p - (tl_real)i) / (tl_real)(i + 1);
  return b;
}

/* x^n, n of either sign. */
static tl_wide integer_power(tl_real x, int n) {
  tl_wide p = tl_widen(TL_C(1.0));
  for (int i = 0; i < (n < 0 ? -n : n); i++) p = tl_wide_mul(p, tl_widen(x));
  return n < 0 ? tl_wide_div(tl_widen(TL_C(1.0)), p) : p;
}

/* The leading term of each coefficient of hypot(l + h, s + g) = sum_n binomial(1/2, n) (s+g)^2n (l+h)^(1-2n), l > 0. */
static void unequal_length(plane_series *f, int degree, const unequal *z) {
  for (int k = 1; k <= degree; k++)
    for (int j = 0; j <= k; j++) { /* h^i g^j */
      const int i = k - j, n = j > 0 ? (j + 1) / 2 : i > 1, p = 2 * n - j, at = place_of(k, z->turned ? i : j);
      const tl_real factor = binomial(TL_C(0.5), n) * binomial((tl_real)(2 * n), j) * binomial((tl_real)(1 - 2 * n), i);
      const tl_wide powers = tl_wide_mul(integer_power(z->shorter, p), integer_power(TL_LIBM(fabs)(z->longer), 1 - 2 * n - i));
      f->f[at] = tl_narrow(tl_wide_mul(powers, tl_widen(z->longer < TL_C(0.0) && i % 2 ? -factor : factor)));
      f->slight[at] = p;
    }
}

/* The leading term of each coefficient of atan2(s + g, l + h) = Im log(l + h + i (s + g)): of (-1)^(k-1)/k (h + i g)^k (l + i s)^-k, of
 * which the last factor is l^-k - i k s l^(-k-1). Turned, atan2(l + h, s + g) = const - Im log(l + h + i (s + g)). */
static void unequal_angle(plane_series *f, int degree, const unequal *z) {
  for (int k = 1; k <= degree; k++)
    for (int j = 0; j <= k; j++) {
      const int p = j % 2 == 0, at = place_of(k, z->turned ? k - j : j);
      tl_wide term = integer_power(z->longer, p ? -k - 1 : -k);
      if (p) term = tl_wide_mul(term, tl_wide_product(-(tl_real)k, z->shorter)); /* Im i^j (-i), Im i^j */
      term = tl_wide_div(tl_wide_mul(term, tl_widen(binomial((tl_real)k, j))), tl_widen((tl_real)k));
      const int negative = (j % 4 >= 2) != (k % 2 == 0) ? !z->turned : z->turned;
      f->f[at] = negative ? -tl_narrow(term) : tl_narrow(term);
      f->slight[at] = p;
    }
}

/* atan2(y+g, x+h) = angle + Im log(1 + w), w = (h + i g)/(x + i y): part k is Im((-1)^(k-1)/k (u - i v)^k (h + i g)^k) / r^k. */
static void angle_series(plane_series *f, int degree, const polar *z) {
  tl_wide re = tl_widen(-TL_C(1.0)), im = tl_widen(TL_C(0.0)); /* -(-1/(x + i y))^k */
  const tl_wide u = tl_wide_div(z->u, z->r), v = tl_wide_div(z->v, z->r);
  for (int k = 1; k <= degree; k++) {
    const tl_wide old = re;
    re = tl_wide_neg(tl_wide_add(tl_wide_mul(old, u), tl_wide_mul(im, v)));
    im = tl_wide_add(tl_wide_mul(old, v), tl_wide_neg(tl_wide_mul(im, u)));
    tl_real binomial = TL_C(1.0);
    for (int j = 0; j <= k; j++) { /* Im(i^j (re + i im)) */
      const tl_wide part = j % 2 ? re : im, weight = tl_wide_div(tl_widen(j % 4 < 2 ? binomial : -binomial), tl_widen((tl_real)k));
      f->f[place_of(k, j)] = tl_narrow(tl_wide_mul(part, weight));
      binomial = binomial * (tl_real)(k - j) / (tl_real)(j + 1);
    }
  }
}

/* c = the series of (a,b), whose coefficients grow with the length to the power of 1 - k (grade 1, hypot) or -k (grade 0, atan2). Far
 * from 1, jets whose derivatives are smaller than the point are brought to the size of 1 with it, where no power of them is out of
 * range; otherwise they stay as they are, and the coefficients take the powers of the size. */
static void compose(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, plane_series *f, int size, int apart, int grade) {
  tl_real *x = tl_scratch(cx, 2), *y = tl_scratch(cx, 3), largest = TL_C(0.0);
  const int degree = cx->shape->degree;
  for (int i = 1; i < cx->shape->ncoef; i++) largest = TL_LIBM(fmax)(largest, TL_LIBM(fmax)(TL_LIBM(fabs)(a[i]), TL_LIBM(fabs)(b[i])));
  const int far = -TL_MIN_EXP / (2 * TL_WIDE_DEGREE), room = size > 0 ? 2 : 0; /* for what is nearly the largest number */
  const int taken = (size > far || size < -far) && largest <= TL_LIBM(ldexp)(TL_C(1.0), size) ? size - room : 0;
  for (int i = 0; i < cx->shape->ncoef; i++) {
    x[i] = TL_LIBM(ldexp)(a[i], -taken);
    y[i] = TL_LIBM(ldexp)(b[i], -taken);
  }
  for (int k = 1; k <= degree; k++)
    for (int j = 0; j <= k; j++) {
      const int at = place_of(k, j);
      f->f[at] = TL_LIBM(ldexp)(f->f[at], grade * size + k * (taken - size) - f->slight[at] * apart);
    }
  tl_compose_n_blocks(cx, c, 2, (const tl_real *const[]){x, y}, f->f);
}

/* The series by degree and point; c's value is f[0]. */
typedef void wide_rule(plane_series *f, int degree, const polar *z);
typedef void unequal_rule(plane_series *f, int degree, const unequal *z);

/* c = a function of the plane at (a,b), not the origin, degree at most TL_WIDE_DEGREE. */
static void apply(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, tl_real value, wide_rule *rule, unequal_rule *leading,
                  int grade) {
  plane_series f = {.f = {value}};
  int size_x = 0, size_y = 0;
  const tl_real x = TL_LIBM(frexp)(a[0], &size_x), y = TL_LIBM(frexp)(b[0], &size_y);
  const int apart = size_x > size_y ? size_x - size_y : size_y - size_x;
  if (a[0] != TL_C(0.0) && b[0] != TL_C(0.0) && apart > TL_MANT_DIG) {
    const unequal z = size_x > size_y ? (unequal){x, y, apart, 0} : (unequal){y, x, apart, 1};
    leading(&f, cx->shape->degree, &z);
    compose(cx, c, a, b, &f, size_x > size_y ? size_x : size_y, apart, grade);
  } else {
    const int size = b[0] == TL_C(0.0) || (a[0] != TL_C(0.0) && size_x > size_y) ? size_x : size_y;
    const polar z = polar_of(TL_LIBM(ldexp)(a[0], -size), TL_LIBM(ldexp)(b[0], -size));
    rule(&f, cx->shape->degree, &z);
    compose(cx, c, a, b, &f, size, 0, grade);
  }
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
static void length_by_recurrence(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b) {
  const tl_real *x = tl_unaliased(cx, a, c, 0), *y = a == b ? x : tl_unaliased(cx, b, c, 1);
  const tl_real scale = tl_normaliser(TL_LIBM(fmax)(TL_LIBM(fabs)(a[0]), TL_LIBM(fabs)(b[0])));
  const polar z = polar_of(scale * a[0], scale * b[0]);
  tl_real *angle = tl_scratch(cx, 2), *u = tl_scratch(cx, 3), *v = tl_scratch(cx, 4);
  u[0] = tl_narrow(z.u);
  v[0] = tl_narrow(z.v);
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
  if (cx->shape->degree == 0)
    c[0] = value;
  else if (cx->shape->degree <= TL_WIDE_DEGREE)
    apply(cx, c, a, b, value, length_series, unequal_length, 1);
  else
    length_by_recurrence(cx, c, a, b);
  tl_check(cx, c, TL_FN_hypot);
}

/* (x^2 + y^2) E angle = x E y - y E x:
 *     |B| d_0 c_B = |B| (x_0 y_B - y_0 x_B) + sum_{B1,B2>0} (|B2| - |B1|) x_B1 y_B2 - |B1| c_B1 d_B2,    d = x^2 + y^2,
 * with both sides scaled to about 1, which leaves the angle as it is. */
static void angle_by_recurrence(tl_ctx *cx, tl_real *c, tl_real value, const tl_real *x, const tl_real *y) {
  const tl_shape *s = cx->shape;
  const tl_real scale = tl_normaliser(TL_LIBM(fmax)(TL_LIBM(fabs)(x[0]), TL_LIBM(fabs)(y[0])));
  tl_real *d = tl_scratch(cx, 0), *u = tl_scratch(cx, 2), *v = tl_scratch(cx, 3);
  for (int i = 0; i < s->ncoef; i++) {
    u[i] = scale * x[i];
    v[i] = scale * y[i];
  }
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
  if (cx->shape->degree == 0)
    c[0] = value;
  else if (cx->shape->degree <= TL_WIDE_DEGREE)
    apply(cx, c, x, y, value, angle_series, unequal_angle, 0);
  else
    angle_by_recurrence(cx, c, value, x, y);
  tl_check(cx, c, TL_FN_atan2);
}
