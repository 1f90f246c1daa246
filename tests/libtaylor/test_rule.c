/* Functions with a rule of the user's, of one argument and of several. */
#include "close_real.h"
#include "functions.h"
#include "random.h"
#include "reference_jet.h"

#include <math.h>

static const tl_spec SPECS[] = {
    {0, 1, 0}, {0, 1, 4}, {5, 0, 0}, {0, 5, 1}, {0, 4, 2}, {0, 3, 3}, {1, 4, 1}, {1, 4, 2}, {2, 3, 1}, {2, 2, 2},
};
enum { NSPEC = sizeof SPECS / sizeof *SPECS };

static void draw_integers(rng *r, tl_real *a, int n) {
  for (int i = 0; i < n; i++) a[i] = (tl_real)(rng_below(r, 9) - 4);
}

static unsigned reciprocal_rule(tl_real *f, tl_real x, int degree, const void *user) {
  if (x == 0.0) return TL_DOMAIN;
  f[0] = *(const tl_real *)user / x;
  for (int k = 1; k <= degree; k++) f[k] = -f[k - 1] / x;
  return TL_OK;
}

static void a_rule_of_one_argument_composes(void **state) {
  (void)state;
  const tl_real numerator = 3.0;
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 3);
    tl_ctx *cx = &space.cx;
    tl_real *a = tl_push(cx, 1), *c = tl_push(cx, 1), *expected = tl_push(cx, 1);
    rng r = {(uint64_t)k};
    draw_integers(&r, a, space.shape.ncoef);
    a[0] = 1.0;
    tl_rdiv(cx, expected, numerator, a);
    tl_apply(cx, c, a, reciprocal_rule, &numerator);
    assert_jet_same(c, expected, space.shape.ncoef);
    assert_int_equal(cx->status.bits, TL_OK);
    jet_space_free(&space);
  }
}

/* Places by counting through all monomials, without libtaylor's code. */
static void places_are_those_of_the_complete_shape(void **state) {
  (void)state;
  for (int nargs = 1; nargs <= TL_RULE_ARGS; nargs++)
    for (int degree = 0; degree <= 6; degree++) {
      static ref_shape s;
      ref_shape_init(&s, 0, nargs, degree);
      assert_int_equal(tl_rule_size(nargs, degree), s.n);
      assert_int_equal(tl_rule_size(nargs, degree), tl_ncoef(tl_complete(nargs, degree)));
      for (int i = 0; i < s.n; i++) assert_int_equal(tl_rule_index(nargs, &s.exponent[i][1]), i);
    }
  assert_int_equal(tl_rule_size(4, TL_MAX_CURVE + TL_MAX_ORDER), 1929501); /* binomial(84,4) */
  assert_int_equal(tl_rule_index(2, (int[]){1, 1}), 4);                    /* the example in the header */
}

/* A polynomial around the point (x_0, x_1, ..) by its coefficients. */
typedef struct polynomial {
  int nargs;
  tl_real x[TL_RULE_ARGS];
  tl_real f[1001];
} polynomial;

static unsigned polynomial_rule(tl_real *f, const tl_real *x, int degree, const void *user) {
  const polynomial *p = user;
  for (int i = 0; i < p->nargs; i++) assert_real_same(x[i], p->x[i]);
  for (int i = 0; i < tl_rule_size(p->nargs, degree); i++) f[i] = p->f[i];
  return TL_OK;
}

/* expected = sum f_alpha prod (args_i - x_i)^alpha_i, every power by repeated products: exact for integers. */
static void expand(tl_ctx *cx, tl_real *expected, const polynomial *p, tl_real *const *args, tl_real *h, tl_real *term) {
  static ref_shape monomials;
  ref_shape_init(&monomials, 0, p->nargs, cx->shape->degree);
  tl_const(cx, expected, 0.0);
  for (int k = 0; k < monomials.n; k++) {
    tl_const(cx, term, p->f[k]);
    for (int i = 0; i < p->nargs; i++) {
      tl_shift(cx, h, args[i], -p->x[i]);
      for (int e = 0; e < monomials.exponent[k][i + 1]; e++) tl_mul(cx, term, term, h);
    }
    tl_add(cx, expected, expected, term);
  }
}

static void polynomials_of_several_arguments_are_exact(void **state) {
  (void)state;
  rng r = {12};
  for (int k = 0; k < NSPEC; k++)
    for (int nargs = 1; nargs <= TL_RULE_ARGS; nargs++) {
      jet_space space;
      jet_space_init(&space, SPECS[k], 4 + TL_RULE_ARGS);
      tl_ctx *cx = &space.cx;
      const int n = space.shape.ncoef;
      tl_real *expected = tl_push(cx, 1), *c = tl_push(cx, 1), *h = tl_push(cx, 1), *term = tl_push(cx, 1), *args[TL_RULE_ARGS];
      polynomial p = {.nargs = nargs};
      draw_integers(&r, p.f, tl_rule_size(nargs, space.shape.degree));
      for (int i = 0; i < nargs; i++) {
        args[i] = tl_push(cx, 1);
        draw_integers(&r, args[i], n);
        p.x[i] = args[i][0];
      }
      expand(cx, expected, &p, args, h, term);
      tl_apply_n(cx, c, nargs, (const tl_real *const *)args, polynomial_rule, &p);
      assert_jet_same(c, expected, n);
      const int last = nargs - 1; /* the result takes the place of an argument */
      tl_apply_n(cx, args[last], nargs, (const tl_real *const *)args, polynomial_rule, &p);
      assert_jet_same(args[last], expected, n);
      assert_int_equal(cx->status.bits, TL_OK);
      jet_space_free(&space);
    }
}

/* One jet in the place of two arguments, and of the result: x y at (a,a) is a^2. */
static unsigned product_rule(tl_real *f, const tl_real *x, int degree, const void *user) {
  (void)user;
  for (int i = 0; i < tl_rule_size(2, degree); i++) f[i] = 0.0;
  f[0] = x[0] * x[1];
  if (degree < 1) return TL_OK;
  f[tl_rule_index(2, (int[]){1, 0})] = x[1];
  f[tl_rule_index(2, (int[]){0, 1})] = x[0];
  if (degree >= 2) f[tl_rule_index(2, (int[]){1, 1})] = 1.0;
  return TL_OK;
}

static void one_jet_may_be_several_arguments(void **state) {
  (void)state;
  rng r = {13};
  for (int k = 0; k < NSPEC; k++) {
    jet_space space;
    jet_space_init(&space, SPECS[k], 2);
    tl_real *a = tl_push(&space.cx, 1), *expected = tl_push(&space.cx, 1);
    draw_integers(&r, a, space.shape.ncoef);
    tl_mul(&space.cx, expected, a, a);
    tl_apply_n(&space.cx, a, 2, (const tl_real *const[]){a, a}, product_rule, NULL);
    assert_jet_same(a, expected, space.shape.ncoef);
    jet_space_free(&space);
  }
}

static unsigned refusing_rule(tl_real *f, const tl_real *x, int degree, const void *user) {
  (void)f, (void)x, (void)degree;
  return *(const unsigned *)user;
}
static unsigned forgetful_rule(tl_real *f, const tl_real *x, int degree, const void *user) {
  (void)x;
  const int *forgotten = user;
  for (int i = 0; i < tl_rule_size(2, degree); i++)
    if (i != *forgotten) f[i] = 1.0;
  return TL_OK;
}
static unsigned never_called(tl_real *f, const tl_real *x, int degree, const void *user) {
  (void)f, (void)x, (void)degree, (void)user;
  fail_msg("the rule was called");
  return TL_OK;
}

static void assert_failure(const tl_ctx *cx, const tl_real *c, unsigned bits) {
  assert_int_equal(cx->status.bits, bits);
  assert_int_equal(cx->status.function, TL_FN_compose);
  assert_int_equal(cx->status.line, 7);
  int numbers = 0; /* an unusable result shows */
  for (int i = 0; i < cx->shape->ncoef; i++) numbers += isfinite(c[i]) != 0;
  assert_true(numbers < cx->shape->ncoef);
}

static void failures_are_recorded(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_hessian(2), 3);
  tl_ctx *cx = &space.cx;
  tl_real *x = tl_push(cx, 1), *y = tl_push(cx, 1), *c = tl_push(cx, 1);
  const tl_real *const args[] = {x, y};
  const tl_real one = 1.0;
  tl_seed(cx, x, 0.0, 0);
  tl_seed(cx, y, 2.0, 1);
  cx->line = 7;
  tl_apply(cx, c, x, reciprocal_rule, &one);
  assert_failure(cx, c, TL_DOMAIN);
  for (unsigned bits = TL_DOMAIN; bits <= TL_NONFINITE; bits *= 2) {
    tl_ctx_clear(cx);
    tl_apply_n(cx, c, 2, args, refusing_rule, &bits);
    assert_failure(cx, c, bits);
  }
  for (int forgotten = 0; forgotten < 6; forgotten++) {
    tl_ctx_clear(cx);
    tl_apply_n(cx, c, 2, args, forgetful_rule, &forgotten);
    assert_failure(cx, c, TL_NONFINITE);
  }
  y[0] = (tl_real)INFINITY;
  tl_ctx_clear(cx);
  tl_apply_n(cx, c, 2, args, never_called, NULL);
  assert_failure(cx, c, TL_NONFINITE);
  jet_space_free(&space);
}

/* The last degree that TL_RULE_MAX numbers hold for each number of arguments, and the next one. */
static void too_many_coefficients_are_refused(void **state) {
  (void)state;
  const struct {
    int nargs, degree;
  } last[] = {{2, 43}, {3, 16}, {4, 10}};
  for (int i = 0; i < 3; i++)
    for (int more = 0; more < 2; more++) {
      jet_space space;
      jet_space_init(&space, tl_univariate(last[i].degree + more), 2);
      tl_ctx *cx = &space.cx;
      tl_real *a = tl_push(cx, 1), *c = tl_push(cx, 1);
      const tl_real *const args[] = {a, a, a, a};
      polynomial p = {.nargs = last[i].nargs, .f = {1.0, 1.0}};
      tl_const(cx, a, 0.0);
      cx->line = 7;
      tl_apply_n(cx, c, p.nargs, args, more ? never_called : polynomial_rule, &p);
      if (more)
        assert_failure(cx, c, TL_NO_SPACE);
      else
        assert_int_equal(cx->status.bits, TL_OK);
      jet_space_free(&space);
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_rule_of_one_argument_composes),
      cmocka_unit_test(places_are_those_of_the_complete_shape),
      cmocka_unit_test(polynomials_of_several_arguments_are_exact),
      cmocka_unit_test(one_jet_may_be_several_arguments),
      cmocka_unit_test(failures_are_recorded),
      cmocka_unit_test(too_many_coefficients_are_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
