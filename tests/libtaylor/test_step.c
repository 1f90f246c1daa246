/* Functions with jumps: at the jump, one number beside it, and the exact rests of divisions against MPFR. */
#include "close_real.h"
#include "functions.h"
#include "reference_function.h"

#include <float.h>
#include <math.h>

typedef void one_function(tl_ctx *cx, tl_real *c, const tl_real *a);
typedef void two_function(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);

static const tl_spec SPECS[] = {{0, 1, 0}, {0, 1, 1}, {0, 1, 4}, {4, 0, 0}, {0, 3, 2}, {1, 3, 2}, {2, 1, 1}};
enum { NSPEC = sizeof SPECS / sizeof *SPECS };

static const struct {
  const char *name;
  one_function *f;
  tl_real (*value)(tl_real);
  tl_fn function;
  int halves; /* it jumps halfway between integers, not at them */
} STEPS[] = {
    {"floor", tl_floor, TL_LIBM(floor), TL_FN_floor, 0}, {"ceil", tl_ceil, TL_LIBM(ceil), TL_FN_ceil, 0},
    {"trunc", tl_trunc, TL_LIBM(trunc), TL_FN_trunc, 0}, {"round", tl_round, TL_LIBM(round), TL_FN_round, 1},
    {"rint", tl_rint, TL_LIBM(rint), TL_FN_rint, 1},
};
enum { NSTEP = sizeof STEPS / sizeof *STEPS };

/* The step at x + 2t: a constant, or a jump where one was expected. In a shape of one number always the value. */
static void assert_step(int i, tl_real x, int jumps) {
  jet_space number, line;
  jet_space_init(&number, tl_complete(1, 0), 1);
  jet_space_init(&line, tl_hessian(1), 1);
  tl_real *a = tl_push(&number.cx, 1), *b = tl_push(&line.cx, 1);
  a[0] = b[0] = x;
  b[1] = 2.0;
  b[2] = 5.0;
  STEPS[i].f(&number.cx, a, a);
  STEPS[i].f(&line.cx, b, b);
  const unsigned expected = jumps ? TL_SINGULAR : TL_OK;
  if (number.cx.status.bits != TL_OK || line.cx.status.bits != expected)
    fail_msg("%s(%.17g): status %u and %u, expected 0 and %u", STEPS[i].name, (double)x, number.cx.status.bits, line.cx.status.bits,
             expected);
  assert_real_same(a[0], STEPS[i].value(x));
  if (jumps)
    assert_int_equal(line.cx.status.function, STEPS[i].function);
  else
    assert_jet_same(b, ((tl_real[]){STEPS[i].value(x), 0.0, 0.0}), 3);
  jet_space_free(&line);
  jet_space_free(&number);
}

/* Where the functions of this family jump, to the bit: at the point, not at its two neighbours. */
static void steps_jump_at_one_number_only(void **state) {
  (void)state;
  for (int i = 0; i < NSTEP; i++)
    for (int k = -9; k <= 9; k++) { /* integers and halves from -4.5 to 4.5 */
      const tl_real x = TL_C(0.5) * (tl_real)k;
      const int is_half = k % 2 != 0, at_zero_of_trunc = k == 0 && STEPS[i].f == tl_trunc;
      assert_step(i, x, is_half == STEPS[i].halves && !at_zero_of_trunc);
      assert_step(i, TL_LIBM(nextafter)(x, 2 * TL_C(9.0)), 0);
      assert_step(i, TL_LIBM(nextafter)(x, -2 * TL_C(9.0)), 0);
    }
}

/* From two52 = 2^52, or what it is for another significand, up every number is an integer, so that floor, ceil and trunc always stand
 * on a jump and the others never do. */
static void large_numbers_are_integers(void **state) {
  (void)state;
  const tl_real two52 = 1 / TL_EPSILON, values[] = {two52, -two52 - 1, 2 * two52, TL_MAX / 16, -TL_MAX};
  for (int i = 0; i < NSTEP; i++) {
    for (int k = 0; k < 5; k++) assert_step(i, values[k], !STEPS[i].halves);
    assert_step(i, two52 - TL_C(0.5), STEPS[i].halves);
    assert_step(i, two52 / 2 + TL_C(0.5), STEPS[i].halves);
    assert_step(i, -two52 / 2 - 1, !STEPS[i].halves);
  }
}

/* A derivative that is no number is not made a zero. */
static void steps_do_not_hide_a_nan(void **state) {
  (void)state;
  for (int i = 0; i < NSTEP; i++) {
    jet_space space;
    jet_space_init(&space, tl_jacobian(1), 1);
    tl_real *a = tl_push(&space.cx, 1);
    a[0] = 1.25;
    STEPS[i].f(&space.cx, a, a); /* its other number is still NaN */
    assert_int_equal(space.cx.status.bits, TL_NONFINITE);
    assert_int_equal(space.cx.status.function, STEPS[i].function);
    jet_space_free(&space);
  }
}

/* A number that a tl_real holds too: what the reference has for its operands. */
static double held(double x) { return (double)(tl_real)x; }

/* A point of the function's domain whose quotient is exact. */
static void draw_point(const ref_function *f, rng *r, double *x, double *y) {
  do {
    ref_draw(f, r, x, y);
    *x = held(*x);
    *y = held(*y);
  } while (!(f->reach(*x, *y) > 0.0 && f->reach_y(*x, *y) > 0.0 && fabs(*x / *y) < 1.0 / (double)TL_EPSILON));
}

/* The rests against differences of MPFR's values. Values are exact; a derivative da - n db is rounded once. */
static void rests_agree_with_mpfr(void **state) {
  (void)state;
  const struct {
    const char *name;
    two_function *f;
  } rests[] = {{"fmod", tl_fmod}, {"remainder", tl_remainder}};
  const tl_real one_rounding = TL_C(0.51);
  const int samples = 40;
  rng r = {11};
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < NSPEC; k++) {
      const ref_function *ref = ref_lookup(rests[i].name);
      static ref_shape s;
      static double a_held[REF_MAX_COEF], b_held[REF_MAX_COEF];
      ref_shape_init(&s, SPECS[k].curve, SPECS[k].nvar, SPECS[k].order);
      jet_space space;
      jet_space_init(&space, SPECS[k], 2);
      tl_real *a = tl_push(&space.cx, 1), *b = tl_push(&space.cx, 1);
      ref_jet result = ref_new(&s), size = ref_new(&s);
      for (int j = 0; j < samples; j++) {
        double x, y;
        draw_point(ref, &r, &x, &y);
        for (int m = 0; m < s.n; m++) {
          a_held[m] = m ? held(rng_uniform(&r, -1.0, 1.0)) : x;
          b_held[m] = m ? held(rng_below(&r, 3) == 0 ? 0.0 : rng_uniform(&r, -1.0, 1.0)) : y;
          a[m] = (tl_real)a_held[m];
          b[m] = (tl_real)b_held[m];
        }
        ref_apply(ref, &s, &result, &size, a_held, b_held);
        rests[i].f(&space.cx, a, a, b);
        assert_int_equal(space.cx.status.bits, TL_OK);
        for (int m = 0; m < s.n; m++) {
          const tl_real expected = real_from_mpfr(result.c[m]);
          assert_real_case(a[m], expected, (m ? one_rounding : 0) * real_ulp(expected), __FILE__, __LINE__,
                           "%s(%.17g, %.17g), shape {%d,%d,%d}, coefficient %d", rests[i].name, x, y, s.curve, s.nvar, s.order, m);
        }
      }
      ref_free(&result);
      ref_free(&size);
      jet_space_free(&space);
    }
}

/* At x = n y/2 the status of fmod and remainder, and at the two neighbours of x the values of C and the slopes in x and in y. */
static void rests_jump_at_one_number_only(void **state) {
  (void)state;
  const tl_real divisors[] = {1, 3, TL_C(-0.75), 16 * TL_MIN * TL_EPSILON, real_power_of_two(TL_MAX_EXP - 24)};
  jet_space space;
  jet_space_init(&space, tl_jacobian(2), 3);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  for (int i = 0; i < 2; i++)
    for (int d = 0; d < 5; d++)
      for (int n = -7; n <= 7; n++)
        for (int side = -1; side <= 1; side++) {
          const tl_real y = divisors[d], at = TL_C(0.5) * (tl_real)n * y;
          const tl_real x = side ? TL_LIBM(nextafter)(at, (tl_real)side * TL_MAX) : at;
          const int even = n % 2 == 0, jumps = side == 0 && (i == 0 ? even && n != 0 : !even);
          tl_ctx_clear(cx);
          tl_seed(cx, a, x, 0);
          tl_seed(cx, b, y, 1);
          (i == 0 ? tl_fmod : tl_remainder)(cx, c, a, b);
          if (cx->status.bits != (jumps ? TL_SINGULAR : TL_OK))
            fail_msg("%s(%.17g, %.17g): status %u", i == 0 ? "fmod" : "remainder", (double)x, (double)y, cx->status.bits);
          if (jumps) continue;
          const tl_real value = i == 0 ? TL_LIBM(fmod)(x, y) : TL_LIBM(remainder)(x, y), quotient = (x - value) / y;
          assert_real_same(c[0], value);
          assert_real_same(c[1], 1.0);
          assert_real_same(c[2], -quotient); /* exact: a small multiple of y */
        }
  jet_space_free(&space);
}

/* Quotients that are no tl_real any more: right to two ulp; and beyond the range an error, unless the divisor is constant. */
static void huge_quotients_are_rounded(void **state) {
  (void)state;
  const tl_real x = TL_C(1.07111110434) / (TL_EPSILON * TL_EPSILON), y = TL_C(0.24944444444444), two_ulp = 2 * TL_EPSILON;
  jet_space space;
  jet_space_init(&space, tl_jacobian(2), 3);
  tl_ctx *cx = &space.cx;
  tl_real *a = tl_push(cx, 1), *b = tl_push(cx, 1), *c = tl_push(cx, 1);
  tl_seed(cx, a, x, 0);
  tl_seed(cx, b, y, 1);
  tl_fmod(cx, c, a, b);
  assert_real_same(c[0], TL_LIBM(fmod)(x, y));
  assert_real_close(c[2], -x / y, two_ulp, 0.0);
  assert_int_equal(cx->status.bits, TL_OK);
  tl_seed(cx, a, TL_MAX, 0);
  tl_const(cx, b, TL_C(0.7));
  tl_remainder(cx, c, a, b);
  assert_jet_same(c, ((tl_real[]){TL_LIBM(remainder)(TL_MAX, TL_C(0.7)), 1.0, 0.0}), 3);
  assert_int_equal(cx->status.bits, TL_OK);
  tl_seed(cx, b, TL_C(0.7), 1);
  tl_remainder(cx, c, a, b);
  assert_int_equal(cx->status.bits, TL_NONFINITE);
  assert_int_equal(cx->status.function, TL_FN_remainder);
  jet_space_free(&space);
}

static void rounding_to_float_keeps_derivatives(void **state) {
  (void)state;
  jet_space space;
  jet_space_init(&space, tl_hessian(1), 1);
  tl_real *a = tl_push(&space.cx, 1);
  a[0] = TL_C(0.1);
  a[1] = TL_C(0.2);
  a[2] = TL_MAX;
  tl_float(&space.cx, a, a);
  assert_jet_same(a, ((tl_real[]){(tl_real)0.1f, TL_C(0.2), TL_MAX}), 3);
  tl_seed(&space.cx, a, (tl_real)FLT_MAX, 0);
  tl_float(&space.cx, a, a);
  assert_int_equal(space.cx.status.bits, TL_OK);
#if TL_REAL != TL_FLOAT
  const tl_real above_float = (tl_real)FLT_MAX * (1 + (tl_real)FLT_EPSILON);
  tl_seed(&space.cx, a, above_float, 0);
  tl_float(&space.cx, a, a);
  assert_int_equal(space.cx.status.bits, TL_NONFINITE);
  assert_int_equal(space.cx.status.function, TL_FN_float);
#endif
  jet_space_free(&space);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(steps_jump_at_one_number_only),
      cmocka_unit_test(large_numbers_are_integers),
      cmocka_unit_test(steps_do_not_hide_a_nan),
      cmocka_unit_test(rests_agree_with_mpfr),
      cmocka_unit_test(rests_jump_at_one_number_only),
      cmocka_unit_test(huge_quotients_are_rounded),
      cmocka_unit_test(rounding_to_float_keeps_derivatives),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
