/* libtaylor's operations on jets, by number: what test_jet_lanes.c compares on jets with lanes and on jets of one number, and what
 * through_lanes.h sends the other tests through. Means the same to files with lanes and without, and names no tl_real. */
#ifndef TEST_ONE_LANE_H
#define TEST_ONE_LANE_H

#include "lane.h"

/* Operations of one jet and of two; those with a constant x or a whole number; without an operand. Beside them fma, sincos, and the
 * composition with b's coefficients as a series. */
/* clang-format off */
#define LANE_TEST_ONE(X) TL_LANE_ONE(X) X(neg) X(copy)
#define LANE_TEST_TWO(X) TL_LANE_TWO(X) X(add) X(sub) X(mul) X(muladd) X(compose)
#define LANE_TEST_CONSTANT(X) X(powc) X(scale) X(shift) X(divc)
#define LANE_TEST_BEFORE(X) X(rpow) X(rsub) X(rdiv) X(axpy)
#define LANE_TEST_WHOLE(X) X(powi) X(scalbn)
/* clang-format on */

enum {
#define X(name) LANE_TEST_##name,
  LANE_TEST_ONE(X) LANE_TEST_TWO(X) LANE_TEST_CONSTANT(X) LANE_TEST_BEFORE(X) LANE_TEST_WHOLE(X)
#undef X
      LANE_TEST_fma,
  LANE_TEST_sincos,
  LANE_TEST_const,
  LANE_TEST_integer,
  LANE_TESTS,
  LANE_TEST_seed = LANE_TESTS, /* only where the shape has a variable n */
  LANE_OPERATIONS
};

/* Calls the operation with those of the arguments that it has, which are variables of these names: results c and d, operands a, b and
 * e, a number x, a whole one n. */
#define LANE_TEST_CASES(cx, which, c, d, a, b, e, x, n)                                                                                \
  switch (which) {                                                                                                                     \
    LANE_TEST_ONE(LANE_TEST_CASE_ONE)                                                                                                  \
    LANE_TEST_TWO(LANE_TEST_CASE_TWO)                                                                                                  \
    LANE_TEST_CONSTANT(LANE_TEST_CASE_CONSTANT)                                                                                        \
    LANE_TEST_BEFORE(LANE_TEST_CASE_BEFORE)                                                                                            \
    LANE_TEST_WHOLE(LANE_TEST_CASE_WHOLE)                                                                                              \
    LANE_TEST_CASE(fma, tl_fma(cx, c, a, b, e))                                                                                        \
    LANE_TEST_CASE(const, tl_const(cx, c, x))                                                                                          \
    LANE_TEST_CASE(integer, tl_integer(cx, c, n))                                                                                      \
    LANE_TEST_CASE(seed, tl_seed(cx, c, x, (int)(n)))                                                                                  \
  default:                                                                                                                             \
    tl_sincos(cx, c, d, a);                                                                                                            \
  }
#define LANE_TEST_CASE(name, call)                                                                                                     \
  case LANE_TEST_##name:                                                                                                               \
    call;                                                                                                                              \
    break;
#define LANE_TEST_CASE_ONE(name) LANE_TEST_CASE(name, tl_##name(cx, c, a))
#define LANE_TEST_CASE_TWO(name) LANE_TEST_CASE(name, tl_##name(cx, c, a, b))
#define LANE_TEST_CASE_CONSTANT(name) LANE_TEST_CASE(name, tl_##name(cx, c, a, x))
#define LANE_TEST_CASE_BEFORE(name) LANE_TEST_CASE(name, tl_##name(cx, c, x, a))
#define LANE_TEST_CASE_WHOLE(name) LANE_TEST_CASE(name, tl_##name(cx, c, a, (int)(n)))

/* Operation `which` on one lane: c, and d for sincos; e is a. Returns the status bits, and in *function the tl_fn that set them first.
 */
unsigned one_lane(int which, const tl_shape *shape, tl_number *c, tl_number *d, const tl_number *a, const tl_number *b, tl_number x,
                  long long n, int *function);

#endif
