/* Lanes against the same functions on one number: math.h, masks, finiteness, sines and cosines, solutions of M x = b. */
#include "close.h"
#include "random.h"
#include "taylor/ldl.h"
#include "taylor/ldl_lanes.h"
#include "taylor/sincos_lanes.h"

#include <string.h>

enum { TRIES = 200, LARGEST = 12 };

static tl_lanes draw(rng *r, double low, double high) {
  tl_lanes x = tl_lanes_of(TL_C(0.0));
  for (int l = 0; l < TL_LANES; l++) TL_LANE(x, l) = (tl_real)rng_uniform(r, low, high);
  return x;
}

/* Whether both are the same number, or both none. */
static void assert_lane(tl_real actual, tl_real expected, const char *what, int lane) {
  if (actual != expected && (actual == actual || expected == expected)) {
    print_error("%s, lane %d: %.17g, alone %.17g\n", what, lane, (double)actual, (double)expected);
    fail();
  }
}

#define CHECK_ONE(name, low, high)                                                                                                     \
  for (int k = 0; k < TRIES; k++) {                                                                                                    \
    const tl_lanes x = draw(&r, low, high), y = tl_lanes_##name(x);                                                                    \
    for (int l = 0; l < TL_LANES; l++) assert_lane(TL_LANE(y, l), TL_LIBM(name)(TL_LANE(x, l)), #name, l);                             \
  }
#define CHECK_TWO(name)                                                                                                                \
  for (int k = 0; k < TRIES; k++) {                                                                                                    \
    const tl_lanes x = draw(&r, -2.0, 2.0), y = draw(&r, 0.5, 2.0), z = tl_lanes_##name(x, y);                                         \
    for (int l = 0; l < TL_LANES; l++) assert_lane(TL_LANE(z, l), TL_LIBM(name)(TL_LANE(x, l), TL_LANE(y, l)), #name, l);              \
  }

static void functions_of_math_h_go_lane_by_lane(void **state) {
  (void)state;
  rng r = {1};
  CHECK_ONE(sqrt, -1.0, 9.0)
  CHECK_ONE(cbrt, -9.0, 9.0)
  CHECK_ONE(exp, -9.0, 9.0)
  CHECK_ONE(exp2, -9.0, 9.0)
  CHECK_ONE(expm1, -9.0, 9.0)
  CHECK_ONE(log, -1.0, 9.0)
  CHECK_ONE(log2, -1.0, 9.0)
  CHECK_ONE(log10, -1.0, 9.0)
  CHECK_ONE(log1p, -1.5, 9.0)
  CHECK_ONE(sin, -9.0, 9.0)
  CHECK_ONE(cos, -9.0, 9.0)
  CHECK_ONE(tan, -9.0, 9.0)
  CHECK_ONE(asin, -1.2, 1.2)
  CHECK_ONE(acos, -1.2, 1.2)
  CHECK_ONE(atan, -9.0, 9.0)
  CHECK_ONE(sinh, -9.0, 9.0)
  CHECK_ONE(cosh, -9.0, 9.0)
  CHECK_ONE(tanh, -9.0, 9.0)
  CHECK_ONE(asinh, -9.0, 9.0)
  CHECK_ONE(acosh, 0.0, 9.0)
  CHECK_ONE(atanh, -1.2, 1.2)
  CHECK_ONE(erf, -4.0, 4.0)
  CHECK_ONE(erfc, -4.0, 4.0)
  CHECK_ONE(tgamma, 0.5, 9.0)
  CHECK_ONE(lgamma, 0.5, 9.0)
  CHECK_ONE(fabs, -9.0, 9.0)
  CHECK_ONE(floor, -9.0, 9.0)
  CHECK_ONE(ceil, -9.0, 9.0)
  CHECK_ONE(trunc, -9.0, 9.0)
  CHECK_ONE(round, -9.0, 9.0)
  CHECK_ONE(rint, -9.0, 9.0)
  CHECK_ONE(nearbyint, -9.0, 9.0)
  CHECK_TWO(hypot)
  CHECK_TWO(pow)
  CHECK_TWO(atan2)
  CHECK_TWO(fmin)
  CHECK_TWO(fmax)
  CHECK_TWO(fdim)
  CHECK_TWO(fmod)
  CHECK_TWO(remainder)
  CHECK_TWO(copysign)
}

static void powers_and_others_go_lane_by_lane(void **state) {
  (void)state;
  rng r = {2};
  for (int k = 0; k < TRIES; k++) {
    const int order = k % 4;
    tl_lanes x = draw(&r, -2.0, 2.0), e = draw(&r, -2.0, 4.0), z = draw(&r, -1.0, 1.0);
    TL_LANE(e, k % TL_LANES) = (tl_real)(k % 5 - 2);
    if (k % 3 == 0) TL_LANE(x, k % TL_LANES) = TL_C(0.0);
    const tl_lanes power = tl_lanes_power(x, e, order), product = tl_lanes_fma(x, e, z), scaled = tl_lanes_scalbn(x, order);
    const tl_lanes exists = tl_lanes_select(tl_lanes_power_exists(x, e, order), tl_lanes_of(TL_C(1.0)), tl_lanes_of(TL_C(0.0)));
    for (int l = 0; l < TL_LANES; l++) {
      assert_lane(TL_LANE(power, l), tl_power(TL_LANE(x, l), TL_LANE(e, l), order), "power", l);
      assert_lane(TL_LANE(exists, l), (tl_real)tl_power_exists(TL_LANE(x, l), TL_LANE(e, l), order), "power_exists", l);
      assert_lane(TL_LANE(product, l), TL_LIBM(fma)(TL_LANE(x, l), TL_LANE(e, l), TL_LANE(z, l)), "fma", l);
      assert_lane(TL_LANE(scaled, l), TL_LIBM(scalbn)(TL_LANE(x, l), order), "scalbn", l);
    }
  }
}

static void masks_are_truth_values_of_lanes(void **state) {
  (void)state;
  const tl_lanes zero = tl_lanes_of(TL_C(0.0));
  assert_false(tl_lanes_any(zero > TL_C(0.0)));
  assert_true(tl_lanes_all(zero <= TL_C(0.0)));
  assert_true(tl_lanes_all(tl_lanes_truth(1)) && !tl_lanes_any(tl_lanes_truth(0)));
  for (int l = 0; l < TL_LANES; l++) {
    tl_lanes x = zero;
    TL_LANE(x, l) = TL_C(1.0);
    const tl_mask mask = x > TL_C(0.5);
    assert_true(tl_lanes_any(mask));
    assert_int_equal(tl_lanes_all(mask), TL_LANES == 1);
    assert_int_equal(tl_lanes_any(tl_lanes_not(mask)), TL_LANES > 1);
    assert_true(tl_lanes_all(mask | tl_lanes_not(mask)) && !tl_lanes_any(mask & tl_lanes_not(mask)));
    const tl_lanes chosen = tl_lanes_select(mask, tl_lanes_of(TL_C(2.0)), x);
    for (int i = 0; i < TL_LANES; i++) assert_lane(TL_LANE(chosen, i), i == l ? TL_C(2.0) : TL_C(0.0), "select", i);
  }
}

static void one_number_decides_on_finiteness(void **state) {
  (void)state;
  const tl_real bad[] = {(tl_real)INFINITY, -(tl_real)INFINITY, (tl_real)NAN};
  tl_lanes x[LARGEST + 1];
  for (int n = 0; n <= LARGEST; n++) {
    for (int i = 0; i < n; i++) x[i] = tl_lanes_of(i % 2 ? TL_C(0.0) : TL_MAX);
    x[n] = tl_lanes_of((tl_real)NAN); /* behind the array */
    assert_true(tl_lanes_finite(n, x));
    for (int i = 0; i < n * TL_LANES; i++)
      for (int k = 0; k < 3; k++) {
        const tl_lanes was = x[i / TL_LANES];
        TL_LANE(x[i / TL_LANES], i % TL_LANES) = bad[k];
        assert_false(tl_lanes_finite(n, x));
        x[i / TL_LANES] = was;
      }
  }
}

/* Ordinary angles, and in some lanes those that go to the C library. */
static void sines_and_cosines_are_those_of_arrays(void **state) {
  (void)state;
  rng r = {3};
  for (int k = 0; k < TRIES; k++) {
    const int n = k % LARGEST + 1;
    tl_lanes x[LARGEST], s[LARGEST], c[LARGEST];
    for (int i = 0; i < n; i++) {
      x[i] = draw(&r, -50.0, 50.0);
      if (k % 4 == 0) TL_LANE(x[i], rng_below(&r, TL_LANES)) = (tl_real)(rng_sign(&r) * rng_exponent(&r, 15.0, 60.0));
      if (k % 64 == 0) TL_LANE(x[i], rng_below(&r, TL_LANES)) = (tl_real)INFINITY;
    }
    tl_sincos_lanes(n, x, s, c);
    for (int i = 0; i < n; i++)
      for (int l = 0; l < TL_LANES; l++) {
        tl_real sine, cosine;
        const tl_real angle = TL_LANE(x[i], l);
        tl_sincos_array(1, &angle, &sine, &cosine);
        assert_lane(TL_LANE(s[i], l), sine, "sine", l);
        assert_lane(TL_LANE(c[i], l), cosine, "cosine", l);
      }
  }
}

/* M = G'G + 1/2 with columns of [-1,1), and in one lane of some tries a pivot that is not positive. */
static void draw_matrix(rng *r, int n, tl_lanes *w, int bad) {
  tl_lanes g[LARGEST][LARGEST];
  for (int i = 0; i < n; i++)
    for (int j = 0; j < n; j++) g[i][j] = draw(r, -1.0, 1.0);
  for (int i = 0; i < n; i++)
    for (int j = i; j < n; j++) {
      tl_lanes sum = tl_lanes_of(i == j ? TL_C(0.5) : TL_C(0.0));
      for (int k = 0; k < n; k++) sum += g[k][i] * g[k][j];
      w[i * TL_LDL_ROW(n) + j] = sum;
    }
  if (bad) TL_LANE(w[(n - 1) * (TL_LDL_ROW(n) + 1)], bad % TL_LANES) = bad % 2 ? (tl_real)NAN : -TL_C(1.0);
}

/* One lane of an array. */
static void take(int count, tl_real *to, const tl_lanes *from, int lane) {
  for (int i = 0; i < count; i++) to[i] = TL_LANE(from[i], lane);
}

/* The largest difference in parts of the largest number; 0 where both are no numbers. */
static void assert_near(int n, const tl_lanes *x, int step, int lane, const tl_real *alone, const char *what) {
  double size = 0.0, apart = 0.0;
  for (int i = 0; i < n; i++) {
    size = fmax(size, fabs((double)alone[i]));
    apart = fmax(apart, fabs((double)(TL_LANE(x[i * step], lane) - alone[i])));
  }
  if (!(apart <= 1e3 * (double)TL_EPSILON * size)) {
    print_error("%s: %g apart, size %g, n = %d, lane %d\n", what, apart, size, n, lane);
    fail();
  }
}

enum { MANY = 3 };

/* n is a constant in each call, as it is meant. */
TL_INLINE void check_solution(int n, rng *r, int bad) {
  enum { LD = TL_LDL_ROW(LARGEST) };
  tl_lanes m[LARGEST * LD], w[LARGEST * LD], d[TL_LDL_DIAGONAL(LARGEST)], b[LARGEST], x[LARGEST], again[LARGEST], many[LARGEST * MANY];
  tl_real alone[LARGEST * LD], dinv[TL_LDL_DIAGONAL(LARGEST)], y[LARGEST], right[LARGEST];
  const int ld = TL_LDL_ROW(n);
  memset(m, 0, sizeof m);
  draw_matrix(r, n, m, bad);
  memcpy(w, m, sizeof w);
  for (int i = 0; i < n; i++) {
    b[i] = draw(r, -1.0, 1.0);
    for (int j = 0; j < MANY; j++) many[i * MANY + j] = tl_lanes_of((tl_real)(j + 1)) * b[i];
  }
  const tl_lanes ratio = tl_ldl_factor_solve_lanes(n, x, w, ld, d, b);
  tl_ldl_solve_lanes(n, again, w, ld, d, b);
  tl_ldl_solve_many_lanes(n, MANY, many, MANY, w, ld, d);
  for (int l = 0; l < TL_LANES; l++) {
    take(n * ld, alone, m, l);
    take(n, right, b, l);
    const tl_real expected = tl_ldl_factor_solve(n, y, alone, ld, dinv, right);
    assert_int_equal(TL_LANE(ratio, l) <= TL_MAX, expected <= TL_MAX);
    if (!(expected <= TL_MAX)) continue;
    assert_close((double)TL_LANE(ratio, l), (double)expected, 1e3 * (double)TL_EPSILON, 0.0);
    assert_near(n, x, 1, l, y, "factor and solve");
    assert_near(n, again, 1, l, y, "solve");
    assert_near(n, many, MANY, l, y, "solve many");
  }
}

static void solutions_are_those_of_one_matrix(void **state) {
  (void)state;
  rng r = {4};
  for (int k = 0; k < TRIES; k++) {
    const int bad = k % 5 == 4 ? k : 0;
    check_solution(1, &r, bad);
    check_solution(2, &r, bad);
    check_solution(3, &r, bad);
    check_solution(6, &r, bad);
    check_solution(7, &r, bad);
    check_solution(LARGEST, &r, bad);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(functions_of_math_h_go_lane_by_lane),   cmocka_unit_test(powers_and_others_go_lane_by_lane),
      cmocka_unit_test(masks_are_truth_values_of_lanes),       cmocka_unit_test(one_number_decides_on_finiteness),
      cmocka_unit_test(sines_and_cosines_are_those_of_arrays), cmocka_unit_test(solutions_are_those_of_one_matrix),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
