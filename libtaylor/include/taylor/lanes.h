/* Several states side by side: tl_lanes is TL_LANES numbers, one of each state, and arithmetic on it is arithmetic on each of them.
 *
 * What tlgen prints for many states at once (--lanes) is written in these terms. Where there are no vectors TL_LANES is 1 and tl_lanes
 * a number; so no lane is addressed but by TL_LANE. Files that hand lanes to each other must agree on TL_LANES: be compiled for the
 * same processor, or with the same -DTL_LANES=.. */
#ifndef TAYLOR_LANES_H
#define TAYLOR_LANES_H

#include "taylor/kernel.h"

/* States per call: 1, 2, 4 or 8; as many as a register of the processor holds that the compiler is told of. */
#ifndef TL_LANES
#if !TL_VECTORS || defined(TL_REAL_FLOAT)
#define TL_LANES 1
#elif defined(__AVX512F__)
#define TL_LANES 8
#elif defined(__AVX__)
#define TL_LANES 4
#else
#define TL_LANES 2
#endif
#endif

/* tl_mask: a truth value for each lane, what comparisons of tl_lanes are. & and | combine masks. */
#if TL_LANES > 1
typedef tl_real tl_lanes __attribute__((vector_size(TL_LANES * sizeof(tl_real))));
#ifdef TL_REAL_FLOAT
typedef int tl_lane_bits;
#else
typedef long long tl_lane_bits;
#endif
typedef tl_lane_bits tl_mask __attribute__((vector_size(TL_LANES * sizeof(tl_lane_bits))));
#define TL_LANE(x, lane) ((x)[lane])
#else
typedef tl_real tl_lanes;
typedef int tl_mask;
#define TL_LANE(x, lane) (*((void)(lane), &(x)))
#endif

#ifdef __cplusplus
#define TL_LANES_ZERO tl_lanes()
#else
#define TL_LANES_ZERO ((tl_lanes){TL_C(0.0)})
#endif

#endif
