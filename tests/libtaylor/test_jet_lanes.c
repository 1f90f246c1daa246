/* Jets with lanes: each lane has the bits that the same operation gives on its jet alone; a failure is that of the first lane that
 * fails.
 */
#include "close.h"
#include "one_lane.h"
#include "random.h"
#include "taylor/taylor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tl_spec SPECS[] = {{0, 1, 0},  {0, 1, 1}, {0, 3, 1}, {0, 3, 2}, {0, 3, 3}, {0, 2, 8}, {5, 0, 0},
                                {12, 0, 0}, {0, 1, 7}, {1, 5, 1}, {2, 6, 1}, {8, 3, 1}, {2, 2, 3}};
enum { NSPEC = sizeof SPECS / sizeof *SPECS, TRIES = 12, WHOLE = 3 };

/* A shape with memory for jets with lanes, and for one lane of each. */
typedef struct workplace {
  tl_shape shape;
  tl_ctx cx;
  void *tables;
  tl_real *memory, *a, *b, *c, *d, x;
  tl_number *one_a, *one_b, *one_c, *one_d;
} workplace;

static void *allocate(size_t bytes) {
  void *memory = malloc(bytes + 1);
  if (memory == NULL) abort();
  return memory;
}

static void start(workplace *w, tl_spec spec) {
  const size_t bytes = tl_shape_bytes(spec);
  w->tables = allocate(bytes);
  assert_int_equal(tl_shape_init(&w->shape, spec, w->tables, bytes), 0);
  const size_t size = tl_ctx_size(&w->shape, 4), n = (size_t)w->shape.ncoef;
  w->memory = allocate(size * sizeof *w->memory);
  tl_ctx_init(&w->cx, &w->shape, w->memory, size);
  w->a = tl_push(&w->cx, 1), w->b = tl_push(&w->cx, 1), w->c = tl_push(&w->cx, 1), w->d = tl_push(&w->cx, 1);
  w->one_a = allocate(4 * n * sizeof(tl_number));
  w->one_b = w->one_a + n, w->one_c = w->one_b + n, w->one_d = w->one_c + n;
}

static void end(workplace *w) {
  free(w->tables);
  free(w->memory);
  free(w->one_a);
}

/* Ordinary values, or those where functions fail, at the ends of the range, no numbers at all. */
static tl_number draw_value(rng *r, int is_wild) {
  static const tl_number wild[] = {
      0, 1, -1, 2, -3, TL_MAX, -TL_MAX, TL_MIN, -TL_MIN * TL_EPSILON, 100, (tl_number)INFINITY, (tl_number)NAN};
  if (is_wild && rng_below(r, 3) == 0) return wild[rng_below(r, sizeof wild / sizeof *wild)];
  return (tl_number)rng_uniform(r, 0.1, 0.9);
}

static void draw(workplace *w, rng *r, int is_wild) {
  for (int lane = 0; lane < TL_REAL_LANES; lane++) {
    for (int i = 0; i < w->shape.ncoef; i++) {
      w->a[i][lane] = i == 0 ? draw_value(r, is_wild) : (tl_number)rng_uniform(r, -0.5, 0.5);
      w->b[i][lane] = i == 0 ? draw_value(r, is_wild) : (tl_number)rng_uniform(r, -0.5, 0.5);
      w->c[i][lane] = w->d[i][lane] = (tl_number)rng_uniform(r, -0.5, 0.5);
    }
    w->x[lane] = draw_value(r, is_wild);
  }
}

static void load(const workplace *w, tl_number *to, const tl_real *from, int lane) {
  for (int i = 0; i < w->shape.ncoef; i++) to[i] = from[i][lane];
}

static int same_number(tl_number a, tl_number b) { return a == b || (a != a && b != b); }

/* a, b and the old c in lanes against the same alone. */
static int assert_operation(workplace *w, int which) {
  const int ncoef = w->shape.ncoef;
  tl_number *alone = allocate(2 * (size_t)ncoef * TL_REAL_LANES * sizeof *alone);
  int failed = -1, function = TL_FN_none;
  unsigned bits = TL_OK;
  for (int lane = 0; lane < TL_REAL_LANES; lane++) {
    int its_function;
    load(w, w->one_a, w->a, lane), load(w, w->one_b, w->b, lane), load(w, w->one_c, w->c, lane);
    const unsigned its = one_lane(which, &w->shape, w->one_c, w->one_d, w->one_a, w->one_b, w->x[lane], WHOLE, &its_function);
    if (its != TL_OK && failed < 0) failed = lane, bits = its, function = its_function;
    memcpy(alone + 2 * lane * ncoef, w->one_c, (size_t)ncoef * sizeof *alone);
    memcpy(alone + (2 * lane + 1) * ncoef, w->one_d, (size_t)ncoef * sizeof *alone);
  }
  tl_ctx_clear(&w->cx);
  tl_ctx *cx = &w->cx;
  tl_real *c = w->c, *d = w->d, x = w->x;
  const tl_real *a = w->a, *b = w->b;
  const long long n = WHOLE;
  LANE_TEST_CASES(cx, which, c, d, a, b, a, x, n)
  if (failed >= 0) {
    if (cx->status.bits != bits || (int)cx->status.function != function || cx->status.lane != failed)
      fail_msg("operation %d: status %u of %s in lane %d, alone %u of %s in lane %d", which, cx->status.bits,
               tl_fn_name(cx->status.function), cx->status.lane, bits, tl_fn_name((tl_fn)function), failed);
  } else {
    assert_int_equal(cx->status.bits, TL_OK);
    for (int lane = 0; lane < TL_REAL_LANES; lane++)
      for (int i = 0; i < ncoef * (which == LANE_TEST_sincos ? 2 : 1); i++) {
        const tl_number in_lanes = i < ncoef ? c[i][lane] : d[i - ncoef][lane], expected = alone[2 * lane * ncoef + i];
        if (!same_number(in_lanes, expected))
          fail_msg("operation %d, shape {%d,%d,%d}, lane %d, coefficient %d: %.17g, alone %.17g", which, w->shape.curve, w->shape.nvar,
                   w->shape.order, lane, i, (double)in_lanes, (double)expected);
      }
  }
  free(alone);
  return failed < 0;
}

static void for_each_operation(int is_wild, int *right, int *wrong) {
  rng r = {(uint64_t)is_wild};
  for (int k = 0; k < NSPEC; k++) {
    workplace w;
    start(&w, SPECS[k]);
    for (int which = 0; which < LANE_TESTS; which++) {
      if (is_wild && which == LANE_TEST_compose) continue; /* it looks at all values first */
      for (int i = 0; i < test_tries(TRIES); i++) {
        draw(&w, &r, is_wild);
        ++*(assert_operation(&w, which) ? right : wrong);
      }
    }
    end(&w);
  }
}

static void each_lane_has_the_bits_of_its_jet_alone(void **state) {
  (void)state;
  int right = 0, wrong = 0;
  for_each_operation(0, &right, &wrong);
  assert_true(right > 10 * wrong); /* acosh has no values here */
}

static void the_first_lane_that_fails_is_reported(void **state) {
  (void)state;
  int right = 0, wrong = 0;
  for_each_operation(1, &right, &wrong);
  assert_true(wrong > right / 4 && right > wrong / 64);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(each_lane_has_the_bits_of_its_jet_alone),
      cmocka_unit_test(the_first_lane_that_fails_is_reported),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
