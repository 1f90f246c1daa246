/* Factorisation and solution of constant size against long double: every size to 64, badly conditioned, indefinite and broken
 * matrices, each kind of right-hand side. */
#include "close.h"
#include "random.h"
#include "taylor/ldl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 64, LD = TL_LDL_ROW(LARGEST) };

/* Backward errors in units of n*TL_EPSILON*|M||x|: the textbook bound is about 3. */
static const double BACKWARD = 3.0;

typedef struct ldl_case {
  int n;
  tl_real m[LARGEST][LARGEST];                          /* the matrix, both triangles */
  tl_real w[LARGEST * LD], d[TL_LDL_DIAGONAL(LARGEST)]; /* what is factored */
} ldl_case;

/* M = G'G + shift with n columns of numbers in [-1,1), column i times scale^i. */
static void draw_matrix(ldl_case *c, rng *r, int n, double scale, double shift) {
  static double g[LARGEST][LARGEST];
  c->n = n;
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) g[i][j] = rng_uniform(r, -1.0, 1.0) * pow(scale, j);
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) {
      double sum = i == j ? shift : 0.0;
      for (int k = 0; k < n; k++) sum += g[k][i < j ? i : j] * g[k][i < j ? j : i];
      c->m[i][j] = (tl_real)sum;
    }
}

/* What ldl.h says need not be set is NaN. */
static void fill(ldl_case *c, int ld) {
  for (int i = 0; i < c->n; i++)
    for (int j = 0; j < ld; j++) c->w[i * ld + j] = j >= i && j < c->n ? c->m[i][j] : (tl_real)NAN;
}

static void draw(rng *r, tl_real *b, int n) {
  for (int i = 0; i < n; i++) b[i] = (tl_real)rng_uniform(r, -1.0, 1.0);
}

/* |b - M x| <= BACKWARD n eps (|M| |x| + |b|), row by row in the norm of M. */
static void assert_solved(const ldl_case *c, const tl_real *x, int xs, const tl_real *b, int bs, const char *what) {
  long double norm = 0.0L, size = 0.0L;
  for (int i = 0; i < c->n; i++) {
    long double row = 0.0L;
    for (int j = 0; j < c->n; j++) row += fabsl((long double)c->m[i][j]);
    norm = fmaxl(norm, row);
    size = fmaxl(size, fabsl((long double)x[i * xs]));
  }
  for (int i = 0; i < c->n; i++) {
    long double sum = 0.0L;
    for (int j = 0; j < c->n; j++) sum += (long double)c->m[i][j] * (long double)x[j * xs];
    const double atol = BACKWARD * c->n * (double)(TL_EPSILON * (norm * size + fabsl((long double)b[i * bs])));
    assert_close_case((double)sum, (double)b[i * bs], atol, __FILE__, __LINE__, "%s, n = %d, row %d", what, c->n, i);
  }
}

/* The functions with each size as a constant, as they are meant to be called. Above TL_LDL_UNROLLED only n % 8 matters. */
enum { MANY = 13, FEW = 3, LDB = TL_ROW(MANY) };
#define SIZES(X) X(1) X(2) X(3) X(4) X(5) X(6) X(7) X(8) X(9) X(11) X(12) X(14) X(17) X(19) X(64)

typedef struct ldl_functions {
  int n;
  tl_real (*factor_solve)(tl_real *x, tl_real *w, tl_real *d, const tl_real *b);
  tl_real (*factor)(tl_real *w, tl_real *d);
  void (*solve)(tl_real *x, const tl_real *w, tl_real *d, const tl_real *b);
  void (*solve_few)(tl_real *b, const tl_real *w, tl_real *d);
  void (*solve_many)(tl_real *b, const tl_real *w, tl_real *d);
  void (*negated)(tl_real *x, tl_real *b, const tl_real *w, tl_real *d);
} ldl_functions;

#define INSTANCE(n)                                                                                                                    \
  static tl_real factor_solve_##n(tl_real *x, tl_real *w, tl_real *d, const tl_real *b) {                                              \
    return tl_ldl_factor_solve(n, x, w, TL_LDL_ROW(n), d, b);                                                                          \
  }                                                                                                                                    \
  static tl_real factor_##n(tl_real *w, tl_real *d) { return tl_ldl_factor(n, w, TL_LDL_ROW(n), d); }                                  \
  static void solve_##n(tl_real *x, const tl_real *w, tl_real *d, const tl_real *b) { tl_ldl_solve(n, x, w, TL_LDL_ROW(n), d, b); }    \
  static void solve_few_##n(tl_real *b, const tl_real *w, tl_real *d) { tl_ldl_solve_many(n, FEW, b, LDB, w, TL_LDL_ROW(n), d); }      \
  static void solve_many_##n(tl_real *b, const tl_real *w, tl_real *d) { tl_ldl_solve_many(n, MANY, b, LDB, w, TL_LDL_ROW(n), d); }    \
  static void negated_##n(tl_real *x, tl_real *b, const tl_real *w, tl_real *d) {                                                      \
    tl_ldl_solve_negated(n, FEW, x, b, LDB, w, TL_LDL_ROW(n), d);                                                                      \
  }
SIZES(INSTANCE)

#define ENTRY(n) {n, factor_solve_##n, factor_##n, solve_##n, solve_few_##n, solve_many_##n, negated_##n},
static const ldl_functions functions[] = {SIZES(ENTRY)};
enum { NSIZE = sizeof functions / sizeof *functions };

static void check_many(const ldl_case *c, rng *r, int k, void (*solve)(tl_real *, const tl_real *, tl_real *), tl_real *d) {
  static tl_real many[LARGEST * LDB], right[LARGEST * LDB];
  for (int i = 0; i < c->n * LDB; i++) right[i] = many[i] = i % LDB < k ? (tl_real)rng_uniform(r, -1.0, 1.0) : (tl_real)NAN;
  solve(many, c->w, d);
  for (int j = 0; j < k; j++) assert_solved(c, many + j, LDB, right + j, LDB, "many");
}

static void check_negated(const ldl_case *c, rng *r, const ldl_functions *f, tl_real *d) {
  static tl_real x[LARGEST * FEW + 1], b[LARGEST * LDB], right[LARGEST * LDB];
  for (int i = 0; i < c->n * LDB; i++) b[i] = i % LDB < FEW ? (tl_real)rng_uniform(r, -1.0, 1.0) : (tl_real)NAN, right[i] = -b[i];
  x[c->n * FEW] = TL_C(7.0);
  f->negated(x, b, c->w, d);
  for (int j = 0; j < FEW; j++) assert_solved(c, x + j, FEW, right + j, LDB, "negated");
  assert_true(x[c->n * FEW] == TL_C(7.0)); /* behind the array */
}

/* How far apart, relatively, the ratios of two compilations are. Where products may be fused with sums, each of the n products that d_i
 * is less than M_ii by may be rounded otherwise. */
static double apart(int n, double ratio) {
#ifdef __FMA__
  return n * (double)TL_EPSILON * ratio;
#else
  (void)n, (void)ratio;
  return 4.0 * (double)TL_EPSILON;
#endif
}

/* All that ldl.h does, with one matrix; the pivot ratio. */
static tl_real factor_and_check(ldl_case *c, rng *r, const ldl_functions *f) {
  const int n = c->n, ld = TL_LDL_ROW(n);
  tl_real b[LARGEST], x[LARGEST];
  draw(r, b, n);
  fill(c, ld);
  const tl_real both = f->factor_solve(x, c->w, c->d, b);
  if (both <= TL_MAX) assert_solved(c, x, 1, b, 1, "factor and solve");
  fill(c, ld);
  const tl_real ratio = f->factor(c->w, c->d);
  assert_int_equal(both <= TL_MAX, ratio <= TL_MAX);
  if (!(ratio <= TL_MAX)) return ratio;
  assert_close(both, ratio, apart(n, (double)ratio), 0.0);
  for (int again = 0; again < 2; again++) {
    draw(r, b, n);
    memcpy(x, b, sizeof x);
    f->solve(x, c->w, c->d, x);
    assert_solved(c, x, 1, b, 1, "solve");
  }
  check_many(c, r, FEW, f->solve_few, c->d);
  check_many(c, r, MANY, f->solve_many, c->d);
  check_negated(c, r, f, c->d);
  return ratio;
}

static ldl_case the_case;

static void every_size_is_solved(void **state) {
  (void)state;
  rng r = {1};
  for (int i = 0; i < NSIZE; i++)
    for (int k = 0; k < 5; k++) {
      draw_matrix(&the_case, &r, functions[i].n, 1.0, k == 0 ? 1.0 : 0.0);
      assert_true(factor_and_check(&the_case, &r, &functions[i]) <= TL_MAX);
    }
}

static void badly_scaled_matrices_are_solved(void **state) {
  (void)state;
  rng r = {2};
  for (int i = 0; i < NSIZE; i++) {
    draw_matrix(&the_case, &r, functions[i].n, 0.7, 0.0);
    (void)factor_and_check(&the_case, &r, &functions[i]);
  }
}

/* One pivot below zero, by far or by little beside the rest, and matrices that are no numbers. */
static void other_matrices_have_no_finite_pivot_ratio(void **state) {
  (void)state;
  rng r = {3};
  for (int s = 0; s < NSIZE; s++)
    for (int i = 0; i < functions[s].n; i++) {
      static const double less[] = {1.0, 1e3, 1e-3};
      const int n = functions[s].n;
      draw_matrix(&the_case, &r, n, 1.0, 1.0);
      tl_real *entry = &the_case.m[i][i];
      switch (rng_below(&r, 4)) {
      case 0:
        *entry = (tl_real)(-less[rng_below(&r, 3)] * fabs((double)*entry));
        break;
      case 1:
        *entry = (tl_real)NAN;
        break;
      case 2:
        *entry = (tl_real)INFINITY;
        break;
      default:
        for (int j = 0; j < n; j++) the_case.m[i][j] = the_case.m[j][i] = TL_C(0.0);
      }
      assert_false(factor_and_check(&the_case, &r, &functions[s]) <= TL_MAX);
    }
}

/* 1 for a diagonal matrix. */
static void pivot_ratio_is_what_the_header_says(void **state) {
  (void)state;
  for (int s = 0; s < NSIZE; s++) {
    const int n = the_case.n = functions[s].n;
    memset(the_case.m, 0, sizeof the_case.m);
    for (int i = 0; i < n; i++) the_case.m[i][i] = (tl_real)(i + 1);
    fill(&the_case, TL_LDL_ROW(n));
    assert_close(functions[s].factor(the_case.w, the_case.d), 1.0, 2.0 * TL_EPSILON, 0.0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_size_is_solved),
      cmocka_unit_test(badly_scaled_matrices_are_solved),
      cmocka_unit_test(other_matrices_have_no_finite_pivot_ratio),
      cmocka_unit_test(pivot_ratio_is_what_the_header_says),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
