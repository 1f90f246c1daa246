/* Rows with a prefix in use: every length, every number of the row. */
#include "close.h"
#include "random.h"
#include "taylor/row.h"

#include <stdlib.h>

enum { LONGEST = 70, GUARD = 3 };

static void draw(rng *r, tl_real *row, int n) {
  for (int j = 0; j < n; j++) row[j] = (tl_real)rng_uniform(r, -1.0, 1.0);
}

static void prefix_is_added_and_the_rest_kept(void **state) {
  (void)state;
  rng r = {1};
  for (int n = 0; n <= LONGEST; n++) {
    tl_real d[TL_ROW(LONGEST) + GUARD], before[TL_ROW(LONGEST) + GUARD], x[TL_ROW(LONGEST) + GUARD];
    const int all = TL_ROW(LONGEST) + GUARD;
    draw(&r, d, all);
    draw(&r, x, all);
    for (int j = n; j < all; j++) x[j] = (tl_real)NAN;
    for (int j = 0; j < all; j++) before[j] = d[j];
    const tl_real m = (tl_real)rng_uniform(&r, -2.0, 2.0);
    tl_row_add_prefix(d, x, m, n);
    for (int j = 0; j < n; j++) assert_close(d[j], before[j] + m * x[j], 0.0, 4.0 * TL_EPSILON);
    for (int j = n; j < all; j++) assert_same(d[j], before[j]);
  }
}

static void row_may_be_added_to_itself(void **state) {
  (void)state;
  tl_real d[TL_ROW_PAD + TL_ROW_PAD];
  for (int j = 0; j < 2 * TL_ROW_PAD; j++) d[j] = (tl_real)j;
  tl_row_add_prefix(d, d, TL_C(2.0), TL_ROW_PAD + 1);
  for (int j = 0; j < 2 * TL_ROW_PAD; j++) assert_same(d[j], j < TL_ROW_PAD + 1 ? 3.0 * j : 1.0 * j);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(prefix_is_added_and_the_rest_kept),
      cmocka_unit_test(row_may_be_added_to_itself),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
