/* Rows with a prefix in use: every length, every number of the row. */
#include "close.h"
#include "random.h"
#include "taylor/row.h"

#include <stdlib.h>

enum { LONGEST = 70, GUARD = 3 };

static void draw(rng *r, tl_real *row, int n) {
  for (int j = 0; j < n; j++) row[j] = (tl_real)rng_uniform(r, -1.0, 1.0);
}

enum { ALL = TL_ROW(LONGEST) + GUARD };

/* Rows d, x, y of ALL numbers, x and y NaN from n on, and d as it was. */
typedef struct rows {
  tl_real d[ALL], before[ALL], x[ALL], y[ALL], a, b;
} rows;

static void draw_rows(rows *z, rng *r, int n) {
  draw(r, z->d, ALL);
  draw(r, z->x, ALL);
  draw(r, z->y, ALL);
  for (int j = n; j < ALL; j++) z->x[j] = z->y[j] = (tl_real)NAN;
  for (int j = 0; j < ALL; j++) z->before[j] = z->d[j];
  z->a = (tl_real)rng_uniform(r, -2.0, 2.0);
  z->b = (tl_real)rng_uniform(r, -2.0, 2.0);
}

static const double ROUNDING = 8.0 * TL_EPSILON; /* of three products below 2 and their sum */

static void prefix_is_changed_and_the_rest_kept(void **state) {
  (void)state;
  static rows z;
  rng r = {1};
  for (int n = 0; n <= LONGEST; n++)
    for (int what = 0; what < 3; what++) {
      draw_rows(&z, &r, n);
      if (what == 0) tl_row_add_prefix(z.d, z.x, z.a, n);
      if (what == 1) tl_row_set_prefix(z.d, z.x, z.a, n);
      if (what == 2) tl_row_add_two(z.d, z.x, z.a, z.y, z.b, n);
      for (int j = 0; j < n; j++) {
        const double sum = (what == 1 ? 0.0 : z.before[j]) + (double)z.a * z.x[j] + (what == 2 ? (double)z.b * z.y[j] : 0.0);
        assert_close(z.d[j], sum, 0.0, ROUNDING);
      }
      for (int j = n; j < ALL; j++) assert_same(z.d[j], z.before[j]);
    }
}

static void row_may_be_added_to_itself(void **state) {
  (void)state;
  tl_real d[TL_ROW_PAD + TL_ROW_PAD];
  for (int j = 0; j < 2 * TL_ROW_PAD; j++) d[j] = (tl_real)j;
  tl_row_add_prefix(d, d, TL_C(2.0), TL_ROW_PAD + 1);
  for (int j = 0; j < 2 * TL_ROW_PAD; j++) assert_same(d[j], j < TL_ROW_PAD + 1 ? 3.0 * j : 1.0 * j);
}

/* Each number that is not finite is seen, and none behind the rows. */
static void pairs_are_taken_apart(void **state) {
  (void)state;
  enum { ROWS = 3, LDX = 2 * LONGEST + GUARD };
  static tl_real x[ROWS * LDX], even[ROWS * ALL], odd[ROWS * ALL];
  const tl_real bad[] = {(tl_real)INFINITY, -(tl_real)INFINITY, (tl_real)NAN};
  rng r = {2};
  for (int n = 0; n <= LONGEST; n++) {
    for (int k = 0; k < ROWS * LDX; k++) x[k] = k % LDX < 2 * n ? (tl_real)rng_uniform(&r, -1.0, 1.0) : (tl_real)NAN;
    for (int k = 0; k < ROWS * ALL; k++) even[k] = odd[k] = TL_C(9.0);
    assert_true(tl_rows_unpair(ROWS, even, odd, ALL, x, LDX, TL_C(-1.0), n));
    for (int k = 0; k < ROWS * ALL; k++) {
      const int j = k % ALL;
      const tl_real *pair = x + k / ALL * LDX + 2 * j;
      assert_same(even[k], j < n ? -(double)pair[0] : 9.0);
      assert_same(odd[k], j < n ? -(double)pair[1] : 9.0);
    }
    for (int k = 0; k < ROWS * LDX; k++) {
      const tl_real was = x[k];
      x[k] = bad[k % 3];
      assert_int_equal(tl_rows_unpair(ROWS, even, odd, ALL, x, LDX, TL_C(1.0), n), k % LDX >= 2 * n);
      x[k] = was;
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(prefix_is_changed_and_the_rest_kept),
      cmocka_unit_test(row_may_be_added_to_itself),
      cmocka_unit_test(pairs_are_taken_apart),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
