/* Shapes: sizes, ranks both ways, product tables, and what is refused, against a plain list of monomials. */
#include "close.h"
#include "functions.h"
#include "reference_jet.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const tl_spec SPECS[] = {
    {0, 0, 0}, {0, 1, 0}, {0, 3, 0}, {3, 2, 0}, {0, 1, 1}, {0, 5, 1}, {0, 1, 4}, {0, 3, 2}, {0, 4, 3}, {0, 3, 6},
    {0, 8, 2}, {6, 0, 0}, {1, 3, 1}, {1, 3, 2}, {2, 1, 1}, {2, 4, 1}, {3, 2, 3}, {1, 6, 3}, {2, 2, 5}, {0, 2, 16},
};
enum { NSPEC = sizeof SPECS / sizeof *SPECS };

static ref_shape plain; /* too large for the stack */

static void load(jet_space *space, tl_spec spec) {
  jet_space_init(space, spec, 0);
  ref_shape_init(&plain, spec.curve, spec.nvar, spec.order);
}

static void named_shapes_are_the_documented_members(void **state) {
  (void)state;
  const struct {
    tl_spec spec;
    int curve, nvar, order, ncoef;
  } cases[] = {
      {tl_jacobian(4), 0, 4, 1, 5},       {tl_hessian(4), 0, 4, 2, 15},       {tl_third_order(4), 0, 4, 3, 35},
      {tl_complete(8, 6), 0, 8, 6, 3003}, {tl_complete(1, 12), 0, 1, 12, 13}, {tl_univariate(7), 7, 0, 0, 8},
      {tl_motion(2, 5), 2, 5, 1, 18},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    assert_int_equal(cases[i].spec.curve, cases[i].curve);
    assert_int_equal(cases[i].spec.nvar, cases[i].nvar);
    assert_int_equal(cases[i].spec.order, cases[i].order);
    assert_int_equal(tl_ncoef(cases[i].spec), cases[i].ncoef);
  }
}

static void sizes_agree_with_the_list(void **state) {
  (void)state;
  for (int i = 0; i < NSPEC; i++) {
    jet_space space;
    load(&space, SPECS[i]);
    assert_int_equal(tl_ncoef(SPECS[i]), plain.n);
    assert_int_equal(space.shape.ncoef, plain.n);
    assert_int_equal(space.shape.degree, plain.degree);
    assert_int_equal(space.shape.nblock, (plain.curve + 1) * (plain.order + 1));
    jet_space_free(&space);
  }
}

static void positions_agree_with_the_list_both_ways(void **state) {
  (void)state;
  for (int i = 0; i < NSPEC; i++) {
    jet_space space;
    load(&space, SPECS[i]);
    for (int at = 0; at < plain.n; at++) {
      int k = -1, alpha[REF_MAX_VAR] = {0};
      assert_int_equal(tl_index(&space.shape, plain.exponent[at][0], plain.exponent[at] + 1), at);
      tl_monomial(&space.shape, at, &k, alpha);
      assert_int_equal(k, plain.exponent[at][0]);
      assert_memory_equal(alpha, plain.exponent[at] + 1, (size_t)plain.nvar * sizeof *alpha);
    }
    jet_space_free(&space);
  }
}

static void short_indices_agree_with_the_long_one(void **state) {
  (void)state;
  jet_space space;
  load(&space, (tl_spec){.curve = 1, .nvar = 4, .order = 2});
  for (int k = 0; k <= 2; k++)
    for (int i = 0; i < 4; i++) {
      int alpha[4] = {0};
      alpha[i] = 1;
      assert_int_equal(tl_index1(&space.shape, k, i), tl_index(&space.shape, k, alpha));
      for (int j = 0; j < 4; j++) {
        alpha[j]++;
        assert_int_equal(tl_index2(&space.shape, k, i, j), tl_index(&space.shape, k, alpha));
        alpha[j]--;
      }
    }
  assert_int_equal(tl_index(&space.shape, 1, NULL), 1);
  jet_space_free(&space);
}

static void monomials_outside_have_no_position(void **state) {
  (void)state;
  jet_space space;
  load(&space, (tl_spec){.curve = 1, .nvar = 2, .order = 2});
  assert_int_equal(tl_index(&space.shape, 2, (int[]){0, 0}), -1);
  assert_int_equal(tl_index(&space.shape, -1, (int[]){0, 0}), -1);
  assert_int_equal(tl_index(&space.shape, 0, (int[]){2, 1}), -1);
  assert_int_equal(tl_index(&space.shape, 1, (int[]){0, 3}), -1);
  jet_space_free(&space);
  load(&space, (tl_spec){.curve = 1, .nvar = 2, .order = 1});
  assert_int_equal(tl_index2(&space.shape, 0, 0, 1), -1);
  assert_int_equal(tl_index1(&space.shape, 2, 0), -1);
  jet_space_free(&space);
}

/* Every divisor of a monomial of the shape is in the shape. */
static void shapes_are_downward_closed(void **state) {
  (void)state;
  for (int i = 0; i < NSPEC; i++) {
    jet_space space;
    load(&space, SPECS[i]);
    for (int at = 0; at < plain.n; at++) {
      int k, alpha[REF_MAX_VAR] = {0};
      tl_monomial(&space.shape, at, &k, alpha);
      if (k > 0) assert_true(tl_index(&space.shape, k - 1, alpha) >= 0);
      for (int v = 0; v < plain.nvar; v++) {
        if (alpha[v]-- > 0) assert_true(tl_index(&space.shape, k, alpha) >= 0);
        alpha[v]++;
      }
    }
    jet_space_free(&space);
  }
}

static int is_tabled(const tl_shape *s, int p, int q) { return p >= 1 && p <= q && q >= 2 && p + q <= s->order; }

static void product_tables_agree_with_added_exponents(void **state) {
  (void)state;
  for (int i = 0; i < NSPEC; i++) {
    jet_space space;
    load(&space, SPECS[i]);
    const tl_shape *s = &space.shape;
    for (int p = 0; p <= TL_MAX_ORDER; p++)
      for (int q = 0; q <= TL_MAX_ORDER; q++) {
        if (!is_tabled(s, p, q)) {
          assert_null(s->product[p][q]);
          continue;
        }
        for (int m = 0; m < s->nhom[p] * s->nhom[q]; m++) {
          int sum[REF_MAX_VAR + 1] = {0};
          const int *a = plain.exponent[s->start[p] + m / s->nhom[q]], *b = plain.exponent[s->start[q] + m % s->nhom[q]];
          for (int v = 0; v <= plain.nvar; v++) sum[v] = a[v] + b[v];
          assert_int_equal((int)s->product[p][q][m], ref_find(&plain, sum) - s->start[p + q]);
        }
      }
    jet_space_free(&space);
  }
}

static void hot_shapes_need_no_tables(void **state) {
  (void)state;
  assert_int_equal(tl_shape_bytes(tl_univariate(20)), 0);
  assert_int_equal(tl_shape_bytes(tl_motion(2, 32)), 0);
  assert_int_equal(tl_shape_bytes(tl_hessian(32)), 0);
  assert_int_equal(tl_shape_bytes(tl_third_order(3)), 3 * 6 * sizeof(unsigned));
  tl_shape s;
  assert_int_equal(tl_shape_init(&s, tl_motion(2, 32), NULL, 0), 0);
}

static void invalid_specifications_are_refused(void **state) {
  (void)state;
  const tl_spec invalid[] = {
      {-1, 1, 1},      {0, -1, 1},      {0, 1, -1},     {TL_MAX_CURVE + 1, 1, 1}, {0, 1, TL_MAX_ORDER + 1},
      {0, INT_MAX, 2}, {0, INT_MAX, 1}, {0, 100000, 3}, {64, INT_MAX / 64, 1},    {0, 1000, 16},
  };
  for (size_t i = 0; i < sizeof invalid / sizeof *invalid; i++) {
    tl_shape s;
    assert_int_equal(tl_ncoef(invalid[i]), 0);
    assert_int_equal(tl_shape_bytes(invalid[i]), 0);
    assert_int_equal(tl_shape_init(&s, invalid[i], NULL, SIZE_MAX), -1);
  }
}

/* The largest shapes that fit an int are sized without wrapping round. */
static void sizes_near_the_limit_are_exact(void **state) {
  (void)state;
  assert_int_equal(tl_ncoef((tl_spec){0, INT_MAX - 1, 1}), INT_MAX);
  assert_int_equal(tl_ncoef(tl_hessian(65534)), 2147450880);   /* 65536*65535/2 */
  assert_int_equal(tl_ncoef(tl_hessian(65535)), 0);            /* 65537*65536/2 = INT_MAX + 65537 */
  assert_int_equal(tl_ncoef(tl_complete(17, 16)), 1166803110); /* binomial(33,16) */
  assert_int_equal(tl_ncoef(tl_complete(18, 16)), 0);          /* binomial(34,16) = 2203961430 */
  assert_true(tl_shape_bytes(tl_complete(17, 16)) > (size_t)UINT_MAX);
}

static void too_little_memory_is_refused(void **state) {
  (void)state;
  unsigned memory[3 * 6];
  tl_shape s;
  assert_int_equal(tl_shape_init(&s, tl_third_order(3), memory, sizeof memory - 1), -1);
  assert_int_equal(tl_shape_init(&s, tl_third_order(3), memory, sizeof memory), 0);
}

static void a_shape_without_variables_has_no_order(void **state) {
  (void)state;
  tl_shape s;
  assert_int_equal(tl_shape_init(&s, (tl_spec){.curve = 3, .nvar = 0, .order = 5}, NULL, 0), 0);
  assert_int_equal(s.order, 0);
  assert_int_equal(s.ncoef, 4);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(named_shapes_are_the_documented_members),
      cmocka_unit_test(sizes_agree_with_the_list),
      cmocka_unit_test(positions_agree_with_the_list_both_ways),
      cmocka_unit_test(short_indices_agree_with_the_long_one),
      cmocka_unit_test(monomials_outside_have_no_position),
      cmocka_unit_test(shapes_are_downward_closed),
      cmocka_unit_test(product_tables_agree_with_added_exponents),
      cmocka_unit_test(hot_shapes_need_no_tables),
      cmocka_unit_test(invalid_specifications_are_refused),
      cmocka_unit_test(sizes_near_the_limit_are_exact),
      cmocka_unit_test(too_little_memory_is_refused),
      cmocka_unit_test(a_shape_without_variables_has_no_order),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
