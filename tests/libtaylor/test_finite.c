/* Arrays with one number at any place that is not finite, and without. */
#include "close.h"
#include "taylor/finite.h"

enum { LONGEST = 80 };

static void one_number_decides(void **state) {
  (void)state;
  const tl_real bad[] = {(tl_real)INFINITY, -(tl_real)INFINITY, (tl_real)NAN};
  tl_real x[LONGEST + 1];
  for (int n = 0; n <= LONGEST; n++) {
    for (int i = 0; i < n; i++) x[i] = i % 2 ? TL_C(0.0) : i % 4 ? -TL_MAX : TL_MAX;
    x[n] = (tl_real)NAN; /* behind the array */
    assert_true(tl_finite_array(n, x));
    for (int i = 0; i < n; i++)
      for (int k = 0; k < 3; k++) {
        const tl_real was = x[i];
        x[i] = bad[k];
        assert_false(tl_finite_array(n, x));
        x[i] = was;
      }
  }
}

static void numbers_whose_sum_is_infinite_are_finite(void **state) {
  (void)state;
  tl_real x[LONGEST];
  for (int i = 0; i < LONGEST; i++) x[i] = TL_MAX;
  for (int n = 0; n <= LONGEST; n++) assert_true(tl_finite_array(n, x));
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(one_number_decides),
      cmocka_unit_test(numbers_whose_sum_is_infinite_are_finite),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
