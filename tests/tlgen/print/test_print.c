/* Functions that GraphPrinter printed, against the same computations written by hand. */
#include "taylor/sincos_array.h"

#include "close.h"

#include <math.h>

#include "printed.h"

#define ROUNDING 1e-14 /* a few operations, and the sines */

static const double x[6] = {0.7, -1.3, 0.4, 2.1, -0.2, 0.9}, v[6] = {0.3, 1.1, -0.6, 0.8, 1.7, -0.4};

static void test_straight(void **state) {
  (void)state;
  double out[6];
  assert_int_equal(straight(x, v, NULL, out, NULL), 0);
  const double a = x[0], b = x[1], c = x[2], twice = (a - b) * (a - 2 * c);
  const double expected[6] = {twice - cos(a - b) * v[1],      twice / b + sin(sin(a - b)) * sin(a), -(a * (b - c) - 3 * b * c),
                              -0.1 * (-(a * b) - exp(-c)), 1 - (a - (b + c * c)),                1 / (a * a * a * a)};
  assert_all_close(out, expected, 6, ROUNDING, 0);
}

static void test_carried(void **state) {
  (void)state;
  double out[3];
  assert_int_equal(fibonacci(x, v, NULL, out, NULL), 0);
  assert_close(out[0], 34 * x[0] + 55 * x[1], ROUNDING, 0);
  assert_close(out[1], 55 * x[0] + 89 * x[1], ROUNDING, 0);
  assert_same(out[2], 45);
  assert_int_equal(swap(x, v, NULL, out, NULL), 0);
  assert_close(out[0], 2 * 3 * 2 * x[1], ROUNDING, 0);
  assert_close(out[1], 3 * 2 * 3 * x[0], ROUNDING, 0);
}

static void test_arrays(void **state) {
  (void)state;
  double out[8], kept[5], sum = 0, total = 0;
  assert_int_equal(tape(x, v, NULL, out, NULL), 0);
  for (int i = 0; i < 5; i++) kept[i] = sum += cos(x[i]) * v[i];
  for (int i = 4; i >= 0; i--) {
    total += kept[i];
    assert_close(out[i], total * (cos(x[i]) - sin(x[i])), ROUNDING, 0);
  }
  assert_close(out[5], sum * total, ROUNDING, 0);
  assert_int_equal(triangle(x, v, NULL, out, NULL), 0);
  for (int i = 0; i < 4; i++) {
    double row = 0, column = 0;
    for (int j = 0; j <= i; j++) row += x[i] * v[j];
    for (int k = i; k < 4; k++) column += x[k] * v[i];
    assert_close(out[i], column, ROUNDING, 0);
    assert_close(out[4 + i], row, ROUNDING, 0);
  }
}

static void test_condition(void **state) {
  (void)state;
  double out[2];
  assert_int_equal(newton(x, v, NULL, out, NULL), 0);
  assert_close(out[0], sqrt(x[0]), ROUNDING, 0);
  assert_same(out[1], 5);
}

/* Sites are numbered in the order of printing: the root of q[1], then the division. */
static void test_sites(void **state) {
  (void)state;
  double out[3];
  const double fine[3] = {-1, 4, 2}, no_root[3] = {0.5, -1, 2}, no_quotient[3] = {0.5, 1, 0};
  assert_int_equal(guarded(fine, v, NULL, out, NULL), 0);
  assert_same(out[0], -1);
  assert_same(out[1], 1);
  const int root = guarded(no_root, v, NULL, out, NULL), quotient = guarded(no_quotient, v, NULL, out, NULL);
  assert_true(root > 0 && quotient > 0 && root != quotient);
}

static void test_phases(void **state) {
  (void)state;
  double out[3], qdd[3], squares = 0, weighted = 0;
  assert_int_equal(phases(x, v, qdd, out, NULL), 0);
  for (int i = 0; i < 3; i++) squares += x[i] * x[i];
  for (int i = 0; i < 3; i++) weighted += x[i] * x[i] * (exp(x[0]) * squares + i);
  const double expected[3] = {exp(x[0]) * squares, exp(x[0]) * weighted, squares};
  assert_all_close(out, expected, 3, ROUNDING, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(test_straight),  cmocka_unit_test(test_carried), cmocka_unit_test(test_arrays),
      cmocka_unit_test(test_condition), cmocka_unit_test(test_sites),   cmocka_unit_test(test_phases),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
