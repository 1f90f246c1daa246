/* One lane of an operation on jets with lanes: what lanes/elementary.c asks of the library for one number. Means the same to both, and
 * names no tl_real. Private to the library. */
#ifndef TAYLOR_LANE_H
#define TAYLOR_LANE_H

#include "taylor/real.h"
#include "taylor/shape.h"

/* Functions of one jet, of two, of one and a whole number; and of their own kind. */
/* clang-format off */
#define TL_LANE_ONE(X)                                                                                                                 \
  X(sqrt) X(cbrt) X(exp) X(expm1) X(exp2) X(log) X(log1p) X(log2) X(log10) X(sin) X(cos) X(tan) X(asin) X(acos) X(atan) X(sinh)       \
  X(cosh) X(tanh) X(asinh) X(acosh) X(atanh) X(erf) X(erfc) X(tgamma) X(lgamma) X(fabs) X(floor) X(ceil) X(trunc) X(round) X(rint)    \
  X(float)
#define TL_LANE_TWO(X)                                                                                                                 \
  X(div) X(pow) X(hypot) X(atan2) X(fmin) X(fmax) X(fdim) X(copysign) X(fmod) X(remainder)
/* clang-format on */

typedef enum tl_lane_function {
#define TL_X(name) TL_LANE_##name,
  TL_LANE_ONE(TL_X) TL_LANE_TWO(TL_X)
#undef TL_X
      TL_LANE_powi,
  TL_LANE_scalbn,
  TL_LANE_powc,
  TL_LANE_divc,
  TL_LANE_rdiv,
  TL_LANE_rpow,
  TL_LANE_fma,
  TL_LANE_sincos
} tl_lane_function;

typedef struct tl_lane_task {
  tl_lane_function function;
  const tl_shape *shape;
  tl_number *memory;   /* TL_LANE_JETS * ncoef numbers */
  tl_number *operands; /* the jets one behind the other: at most 3 */
  tl_number x;         /* the constant of powc, divc, rdiv and rpow */
  int n;               /* of powi and scalbn */
  tl_number *results;  /* one jet; two for sincos */
} tl_lane_task;

enum { TL_LANE_JETS = 8 };

/* Runs the task; the status bits, and with these *failed is the tl_fn that set them first. */
unsigned tl_lane_run(const tl_lane_task *task, int *failed);

#endif
