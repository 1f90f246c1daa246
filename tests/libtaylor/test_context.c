/* Contexts: workspace, frames, status. */
#include "close.h"
#include "functions.h"

#include <string.h>

static tl_shape shape_of(tl_spec spec) {
  tl_shape s;
  assert_int_equal(tl_shape_init(&s, spec, NULL, 0), 0);
  return s;
}

static void frames_are_a_stack(void **state) {
  (void)state;
  const tl_shape s = shape_of(tl_jacobian(2));
  tl_real memory[(TL_NSCRATCH + 5) * 3];
  tl_ctx cx;
  assert_int_equal(tl_ctx_size(&s, 5), sizeof memory / sizeof *memory);
  tl_ctx_init(&cx, &s, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 2), *b = tl_push(&cx, 3);
  assert_ptr_equal(a, memory + TL_NSCRATCH * 3);
  assert_ptr_equal(b, a + 6);
  tl_pop(&cx, 3);
  assert_ptr_equal(tl_push(&cx, 1), b);
  assert_int_equal(cx.status.bits, TL_OK);
}

static void a_full_stack_is_a_failure_and_leaves_the_stack_as_it_was(void **state) {
  (void)state;
  const tl_shape s = shape_of(tl_jacobian(2));
  tl_real memory[(TL_NSCRATCH + 2) * 3];
  tl_ctx cx;
  tl_ctx_init(&cx, &s, memory, sizeof memory / sizeof *memory);
  cx.line = 7;
  assert_null(tl_push(&cx, 3));
  assert_null(tl_push(&cx, SIZE_MAX / 2));
  assert_int_equal(cx.status.bits, TL_NO_SPACE);
  assert_int_equal(cx.status.function, TL_FN_frame);
  assert_int_equal(cx.status.line, 7);
  assert_non_null(tl_push(&cx, 2));
}

static void memory_too_small_for_scratch_is_a_failure(void **state) {
  (void)state;
  const tl_shape s = shape_of(tl_jacobian(2));
  tl_real memory[TL_NSCRATCH * 3];
  tl_ctx cx;
  tl_ctx_init(&cx, &s, memory, sizeof memory / sizeof *memory - 1);
  assert_int_equal(cx.status.bits, TL_NO_SPACE);
  assert_null(tl_push(&cx, 1));
  tl_ctx_init(&cx, &s, memory, sizeof memory / sizeof *memory);
  assert_int_equal(cx.status.bits, TL_OK);
}

static void sizes_do_not_wrap_round(void **state) {
  (void)state;
  const tl_shape s = shape_of(tl_jacobian(9));
  assert_true(tl_ctx_size(&s, SIZE_MAX) == SIZE_MAX);
  assert_true(tl_ctx_size(&s, SIZE_MAX / 10) == SIZE_MAX);
}

static void the_first_failure_keeps_function_and_line(void **state) {
  (void)state;
  const tl_shape s = shape_of(tl_jacobian(1));
  tl_real memory[(TL_NSCRATCH + 2) * 2];
  tl_ctx cx;
  tl_ctx_init(&cx, &s, memory, sizeof memory / sizeof *memory);
  tl_real *a = tl_push(&cx, 1), *c = tl_push(&cx, 1);
  tl_seed(&cx, a, -1.0, 0);
  cx.line = 12;
  tl_log(&cx, c, a);
  cx.line = 13;
  tl_const(&cx, a, 0.0);
  tl_sqrt(&cx, c, a);
  assert_int_equal(cx.status.bits, TL_DOMAIN | TL_SINGULAR);
  assert_int_equal(cx.status.function, TL_FN_log);
  assert_int_equal(cx.status.line, 12);
  tl_ctx_clear(&cx);
  assert_int_equal(cx.status.bits, TL_OK);
  assert_int_equal(cx.status.function, TL_FN_none);
  assert_int_equal(cx.status.line, 0);
}

static void names_and_texts_are_there_for_all(void **state) {
  (void)state;
  assert_string_equal(tl_fn_name(TL_FN_none), "none");
  assert_string_equal(tl_fn_name(TL_FN_atan2), "atan2");
#define CHECK(name) assert_string_equal(tl_fn_name(TL_FN_##name), #name);
  TL_FUNCTIONS(CHECK)
#undef CHECK
  const unsigned kinds[] = {TL_OK, TL_NONFINITE, TL_SINGULAR, TL_DOMAIN, TL_NO_SPACE}; /* in order of severity */
  for (size_t i = 0; i < 5; i++)
    for (size_t j = 0; j < 5; j++) {
      const char *text = tl_status_text(kinds[i] | kinds[j]);
      assert_string_equal(text, tl_status_text(kinds[i > j ? i : j]));
      if (i != j) assert_string_not_equal(tl_status_text(kinds[i]), tl_status_text(kinds[j]));
    }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(frames_are_a_stack),
      cmocka_unit_test(a_full_stack_is_a_failure_and_leaves_the_stack_as_it_was),
      cmocka_unit_test(memory_too_small_for_scratch_is_a_failure),
      cmocka_unit_test(sizes_do_not_wrap_round),
      cmocka_unit_test(the_first_failure_keeps_function_and_line),
      cmocka_unit_test(names_and_texts_are_there_for_all),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
