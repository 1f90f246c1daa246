/* libtaylor's operations on jets of one number, by number: what test_jet_lanes.c compares those on jets with lanes with. Means the same
 * to both, and names no tl_real. */
#ifndef TEST_ONE_LANE_H
#define TEST_ONE_LANE_H

#include "lane.h"

/* Operations of one jet and of two; those with a constant x or the whole number 3; and the composition with a's coefficients as a
 * series. */
/* clang-format off */
#define LANE_TEST_ONE(X) TL_LANE_ONE(X) X(neg) X(copy)
#define LANE_TEST_TWO(X) TL_LANE_TWO(X) X(add) X(sub) X(mul) X(muladd) X(compose)
#define LANE_TEST_CONSTANT(X) X(powc) X(scale) X(shift) X(axpy) X(divc)
#define LANE_TEST_BEFORE(X) X(rpow) X(rsub) X(rdiv)
#define LANE_TEST_WHOLE(X) X(powi) X(scalbn)
/* clang-format on */

enum {
#define X(name) LANE_TEST_##name,
  LANE_TEST_ONE(X) LANE_TEST_TWO(X) LANE_TEST_CONSTANT(X) LANE_TEST_BEFORE(X) LANE_TEST_WHOLE(X)
#undef X
      LANE_TEST_fma,
  LANE_TEST_sincos,
  LANE_TESTS
};

#define LANE_TEST_WHOLE_NUMBER 3

/* Calls the operation where it has arguments of these names. */
#define LANE_TEST_CASES(cx, which, c, d, a, b, x)                                                                                      \
  switch (which) {                                                                                                                     \
    LANE_TEST_ONE(LANE_TEST_CASE_ONE)                                                                                                  \
    LANE_TEST_TWO(LANE_TEST_CASE_TWO)                                                                                                  \
    LANE_TEST_CONSTANT(LANE_TEST_CASE_CONSTANT)                                                                                        \
    LANE_TEST_BEFORE(LANE_TEST_CASE_BEFORE)                                                                                            \
    LANE_TEST_WHOLE(LANE_TEST_CASE_WHOLE)                                                                                              \
  case LANE_TEST_fma:                                                                                                                  \
    tl_fma(cx, c, a, b, a);                                                                                                            \
    break;                                                                                                                             \
  default:                                                                                                                             \
    tl_sincos(cx, c, d, a);                                                                                                            \
  }
#define LANE_TEST_CASE(name, call)                                                                                                     \
  case LANE_TEST_##name:                                                                                                               \
    call;                                                                                                                              \
    break;
#define LANE_TEST_CASE_ONE(name) LANE_TEST_CASE(name, tl_##name(cx, c, a))
#define LANE_TEST_CASE_TWO(name) LANE_TEST_CASE(name, tl_##name(cx, c, a, b))
#define LANE_TEST_CASE_CONSTANT(name) LANE_TEST_CASE(name, tl_##name LANE_TEST_ORDER_##name)
#define LANE_TEST_CASE_BEFORE(name) LANE_TEST_CASE(name, tl_##name(cx, c, x, a))
#define LANE_TEST_CASE_WHOLE(name) LANE_TEST_CASE(name, tl_##name(cx, c, a, LANE_TEST_WHOLE_NUMBER))
#define LANE_TEST_ORDER_powc (cx, c, a, x)
#define LANE_TEST_ORDER_scale (cx, c, a, x)
#define LANE_TEST_ORDER_shift (cx, c, a, x)
#define LANE_TEST_ORDER_divc (cx, c, a, x)
#define LANE_TEST_ORDER_axpy (cx, c, x, a)

/* Operation `which` on one lane: c, and d for sincos. Returns the status bits, and in *function the tl_fn that set them first. */
unsigned one_lane(int which, const tl_shape *shape, tl_number *c, tl_number *d, const tl_number *a, const tl_number *b, tl_number x,
                  int *function);

#endif
