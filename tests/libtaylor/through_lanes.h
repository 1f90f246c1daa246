/* Sends a test of libtaylor through jets with lanes: its operations get the names of functions that put the jet in one of TEST_LANES
 * lanes and other jets in the others (through_lanes.c). functions.h includes this where TEST_LANES is defined. */
#ifndef TEST_THROUGH_LANES_H
#define TEST_THROUGH_LANES_H

#include "one_lane.h"
#include "taylor/taylor.h"

#define X(name) void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a);
LANE_TEST_ONE(X)
#undef X
#define X(name) void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b);
LANE_TEST_TWO(X)
#undef X
#define X(name) void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, tl_real x);
LANE_TEST_CONSTANT(X)
#undef X
#define X(name) void through_lanes_##name(tl_ctx *cx, tl_real *c, tl_real x, const tl_real *a);
LANE_TEST_BEFORE(X)
#undef X
#define X(name) void through_lanes_##name(tl_ctx *cx, tl_real *c, const tl_real *a, int n);
LANE_TEST_WHOLE(X)
#undef X
void through_lanes_fma(tl_ctx *cx, tl_real *c, const tl_real *a, const tl_real *b, const tl_real *e);
void through_lanes_sincos(tl_ctx *cx, tl_real *sine, tl_real *cosine, const tl_real *a);
void through_lanes_const(tl_ctx *cx, tl_real *c, tl_real x);
void through_lanes_integer(tl_ctx *cx, tl_real *c, long long n);
void through_lanes_seed(tl_ctx *cx, tl_real *c, tl_real x, int i);

#define tl_acos through_lanes_acos
#define tl_acosh through_lanes_acosh
#define tl_add through_lanes_add
#define tl_asin through_lanes_asin
#define tl_asinh through_lanes_asinh
#define tl_atan through_lanes_atan
#define tl_atan2 through_lanes_atan2
#define tl_atanh through_lanes_atanh
#define tl_axpy through_lanes_axpy
#define tl_cbrt through_lanes_cbrt
#define tl_ceil through_lanes_ceil
#define tl_compose through_lanes_compose
#define tl_const through_lanes_const
#define tl_copy through_lanes_copy
#define tl_copysign through_lanes_copysign
#define tl_cos through_lanes_cos
#define tl_cosh through_lanes_cosh
#define tl_div through_lanes_div
#define tl_divc through_lanes_divc
#define tl_erf through_lanes_erf
#define tl_erfc through_lanes_erfc
#define tl_exp through_lanes_exp
#define tl_exp2 through_lanes_exp2
#define tl_expm1 through_lanes_expm1
#define tl_fabs through_lanes_fabs
#define tl_fdim through_lanes_fdim
#define tl_float through_lanes_float
#define tl_floor through_lanes_floor
#define tl_fma through_lanes_fma
#define tl_fmax through_lanes_fmax
#define tl_fmin through_lanes_fmin
#define tl_fmod through_lanes_fmod
#define tl_hypot through_lanes_hypot
#define tl_integer through_lanes_integer
#define tl_lgamma through_lanes_lgamma
#define tl_log through_lanes_log
#define tl_log10 through_lanes_log10
#define tl_log1p through_lanes_log1p
#define tl_log2 through_lanes_log2
#define tl_mul through_lanes_mul
#define tl_muladd through_lanes_muladd
#define tl_neg through_lanes_neg
#define tl_pow through_lanes_pow
#define tl_powc through_lanes_powc
#define tl_powi through_lanes_powi
#define tl_rdiv through_lanes_rdiv
#define tl_remainder through_lanes_remainder
#define tl_rint through_lanes_rint
#define tl_round through_lanes_round
#define tl_rpow through_lanes_rpow
#define tl_rsub through_lanes_rsub
#define tl_scalbn through_lanes_scalbn
#define tl_scale through_lanes_scale
#define tl_seed through_lanes_seed
#define tl_shift through_lanes_shift
#define tl_sin through_lanes_sin
#define tl_sincos through_lanes_sincos
#define tl_sinh through_lanes_sinh
#define tl_sqrt through_lanes_sqrt
#define tl_sub through_lanes_sub
#define tl_tan through_lanes_tan
#define tl_tanh through_lanes_tanh
#define tl_tgamma through_lanes_tgamma
#define tl_trunc through_lanes_trunc

#endif
