/* The number type of the algebra and its mathematics: the one place to change both. */
#ifndef TAYLOR_REAL_H
#define TAYLOR_REAL_H

#include "taylor/config.h"

#include <float.h>
#include TL_MATH_HEADER

/* Compile everything with -DTL_REAL=TL_FLOAT for single precision, TL_LONG_DOUBLE for C's widest, or TL_FLOAT128 for the 113 bits of
 * gcc's __float128, a reference rather than a tool: it needs libquadmath. No other file of the project names a C floating type. */
#define TL_FLOAT 1
#define TL_DOUBLE 2
#define TL_LONG_DOUBLE 3
#define TL_FLOAT128 4
/* With -DTL_REAL_LANES=2, 4 or 8 besides, tl_real is that many numbers side by side: see real_lanes.h.
 *
 * TL_C(x): the number x, written as a constant of type double. TL_LIBM(sin)(x) calls the C library's function for tl_real. */
#if TL_REAL == TL_FLOAT
#define TL_REAL_FLOAT
typedef float tl_number;
#define TL_NUMBER(x) x##f
#ifndef TL_LIBM
#define TL_LIBM(name) name##f
#endif
#define TL_LIMIT(name) FLT_##name
#elif TL_REAL == TL_DOUBLE
typedef double tl_number;
#define TL_NUMBER(x) x
#ifndef TL_LIBM
#define TL_LIBM(name) name
#endif
#define TL_LIMIT(name) DBL_##name
#elif TL_REAL == TL_LONG_DOUBLE
typedef long double tl_number;
#define TL_NUMBER(x) x##L
#ifndef TL_LIBM
#define TL_LIBM(name) name##l
#endif
#define TL_LIMIT(name) LDBL_##name
#elif TL_REAL == TL_FLOAT128
#include <quadmath.h>
typedef __float128 tl_number;
#define TL_NUMBER(x) x##Q
#ifndef TL_LIBM
#define TL_LIBM(name) name##q
#endif
#define TL_LIMIT(name) FLT128_##name
#else
#error "TL_REAL is none of TL_FLOAT, TL_DOUBLE, TL_LONG_DOUBLE and TL_FLOAT128"
#endif

/* tl_number is one number; tl_real one too, or several beside each other. TL_FROM(n): an integer as a tl_real. Conditions on numbers:
 * true in some lane, in every lane; the first lane where true. */
#ifdef TL_REAL_LANES
#include "taylor/real_lanes.h"
#else
typedef tl_number tl_real;
#define TL_FROM(n) ((tl_real)(n))
#define TL_C(x) TL_NUMBER(x)
#define TL_SOME(condition) (condition)
#define TL_EVERY(condition) (condition)
#define TL_FIRST(condition) 0
#endif

#define TL_EPSILON TL_LIMIT(EPSILON)   /* from 1 to the next larger number */
#define TL_MANT_DIG TL_LIMIT(MANT_DIG) /* bits of a significand */
#define TL_MAX TL_LIMIT(MAX)
#define TL_MIN TL_LIMIT(MIN)         /* the smallest number that has all its bits */
#define TL_MIN_EXP TL_LIMIT(MIN_EXP) /* TL_MIN is 2^(TL_MIN_EXP - 1), TL_MAX below 2^TL_MAX_EXP */
#define TL_MAX_EXP TL_LIMIT(MAX_EXP)

/* x rounded to C's float. */
#define TL_TO_SINGLE(x) ((tl_real)(float)(x))

/* A finite value is one whose difference with itself is zero. */
#define TL_ISFINITE(x) ((x) - (x) == TL_C(0.0))

#endif
