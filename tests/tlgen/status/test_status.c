/* A failure names function, line and file, in a helper of another file and behind a call of it. */
#include "taylor/taylor.h"
#include "well_tl.h"

#include "close.h"

static tl_status evaluate(double x, double y) {
  tl_shape shape;
  tl_ctx cx;
  tl_real memory[512], tables[64], out[2], seeds[4][2] = {{x, 1.0}, {y, 0.0}};
  assert_int_equal(tl_shape_init(&shape, tl_univariate(1), tables, sizeof tables), 0);
  assert_true(tl_ctx_size(&shape, well_model.lagrangian.frame(NULL)) <= 512);
  tl_ctx_init(&cx, &shape, memory, 512);
  well_model.lagrangian.jet(&cx, out, seeds[0], seeds[2], seeds[0], NULL);
  return cx.status;
}

static void names_the_helper(void **state) {
  (void)state;
  tl_status s = evaluate(-1.0, 1.0);
  assert_true(s.bits & TL_DOMAIN);
  assert_int_equal(s.function, TL_FN_sqrt);
  assert_int_equal(s.line, 10);
  assert_string_equal(s.file, "wall.c");
}

static void names_the_caller_after_it(void **state) {
  (void)state;
  tl_status s = evaluate(1.0, -1.0);
  assert_true(s.bits & TL_DOMAIN);
  assert_int_equal(s.function, TL_FN_log);
  assert_int_equal(s.line, 8);
  assert_string_equal(s.file, "well.c");
}

static void says_nothing_where_all_is_well(void **state) {
  (void)state;
  tl_status s = evaluate(1.0, 1.0);
  assert_int_equal(s.bits, TL_OK);
  assert_null(s.file);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(names_the_helper), cmocka_unit_test(names_the_caller_after_it),
                                     cmocka_unit_test(says_nothing_where_all_is_well)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
