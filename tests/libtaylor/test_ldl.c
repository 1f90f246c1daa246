/* Factorisation and solution of constant size against long double: every size to 64, badly conditioned, indefinite and broken
 * matrices, each kind of right-hand side. */
#include "close.h"
#include "random.h"
#include "taylor/ldl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LARGEST = 64, LD = TL_LDL_ROW(LARGEST, 2), MANY = 13, LDB = TL_ROW(MANY) };

/* Backward errors in units of n*TL_EPSILON*|M||x|: the textbook bound is about 3. */
static const double BACKWARD = 3.0;

typedef struct ldl_case {
  int n;
  tl_real m[LARGEST][LARGEST];            /* the matrix, both triangles */
  tl_real w[LARGEST * LD], dinv[LARGEST]; /* what is factored */
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

static tl_real factor_and_check(ldl_case *c, rng *r) {
  const int n = c->n, ld = TL_LDL_ROW(n, 2);
  tl_real b[2][LARGEST], x[LARGEST], more[LARGEST], many[LARGEST * LDB], right[LARGEST * LDB];
  fill(c, ld);
  for (int a = 0; a < 2; a++) {
    draw(r, b[a], n);
    for (int i = 0; i < n; i++) c->w[i * ld + n + a] = b[a][i];
  }
  const tl_real ratio = tl_ldl_factor(n, 2, c->w, ld, c->dinv);
  if (!(ratio > TL_C(0.0))) return ratio;
  for (int a = 0; a < 2; a++) {
    tl_ldl_appended(n, x, c->w, ld, a);
    assert_solved(c, x, 1, b[a], 1, "appended");
  }
  draw(r, more, n);
  tl_ldl_solve(n, x, c->w, ld, c->dinv, more);
  assert_solved(c, x, 1, more, 1, "one");
  for (int k = 1; k <= MANY; k += 4) {
    for (int i = 0; i < n * LDB; i++) right[i] = many[i] = i % LDB < k ? (tl_real)rng_uniform(r, -1.0, 1.0) : (tl_real)NAN;
    tl_ldl_solve_many(n, k, many, LDB, c->w, ld, c->dinv);
    for (int j = 0; j < k; j++) assert_solved(c, many + j, LDB, right + j, LDB, "many");
  }
  return ratio;
}

static ldl_case the_case;

static void every_size_is_solved(void **state) {
  (void)state;
  rng r = {1};
  for (int n = 1; n <= LARGEST; n++)
    for (int k = 0; k < 5; k++) {
      draw_matrix(&the_case, &r, n, 1.0, k == 0 ? 1.0 : 0.0);
      assert_true(factor_and_check(&the_case, &r) > TL_C(0.0));
    }
}

static void badly_scaled_matrices_are_solved(void **state) {
  (void)state;
  rng r = {2};
  for (int n = 1; n <= LARGEST; n++) {
    draw_matrix(&the_case, &r, n, 0.7, 0.0);
    (void)factor_and_check(&the_case, &r);
  }
}

/* One pivot below zero, by far or by little beside the rest, and matrices that are no numbers. */
static void other_matrices_have_no_pivot_ratio(void **state) {
  (void)state;
  rng r = {3};
  for (int n = 1; n <= LARGEST; n++)
    for (int i = 0; i < n; i++) {
      static const double less[] = {1.0, 1e3, 1e-3};
      const int last = n - 1;
      draw_matrix(&the_case, &r, n, 1.0, 1.0);
      tl_real *entry = i == last ? &the_case.m[last][last] : &the_case.m[i][i];
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
      assert_same(factor_and_check(&the_case, &r), 0.0);
    }
}

/* D diagonal: ratio 1. Hilbert's matrix: the exact last pivot over its diagonal entry. */
static void pivot_ratio_is_what_the_header_says(void **state) {
  (void)state;
  for (int n = 1; n <= LARGEST; n++) {
    the_case.n = n;
    memset(the_case.m, 0, sizeof the_case.m);
    for (int i = 0; i < n; i++) the_case.m[i][i] = (tl_real)(i + 1);
    fill(&the_case, TL_LDL_ROW(n, 0));
    assert_close(tl_ldl_factor(n, 0, the_case.w, TL_LDL_ROW(n, 0), the_case.dinv), 1.0, 2.0 * TL_EPSILON, 0.0);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(every_size_is_solved),
      cmocka_unit_test(badly_scaled_matrices_are_solved),
      cmocka_unit_test(other_matrices_have_no_pivot_ratio),
      cmocka_unit_test(pivot_ratio_is_what_the_header_says),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
