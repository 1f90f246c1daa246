/* The number type of the algebra and its mathematics: the one place to change both. */
#ifndef TAYLOR_REAL_H
#define TAYLOR_REAL_H

#include <float.h>
#include <math.h>

/* Compile with -DTL_REAL_FLOAT for single precision. No other file of the project names a C floating type. */
#ifdef TL_REAL_FLOAT
typedef float tl_real;
#define TL_C(x) x##f
#define TL_EPSILON FLT_EPSILON
#define TL_MAX FLT_MAX
#define TL_MIN FLT_MIN
#define TL_MIN_EXP FLT_MIN_EXP
#define TL_LIBM(name) name##f
#else
typedef double tl_real;
#define TL_C(x) x
#define TL_EPSILON DBL_EPSILON
#define TL_MAX DBL_MAX
#define TL_MIN DBL_MIN
#define TL_MIN_EXP DBL_MIN_EXP
#define TL_LIBM(name) name
#endif

/* x rounded to C's float. */
#define TL_TO_SINGLE(x) ((tl_real)(float)(x))

/* TL_LIBM(sin)(x) calls the C library's function for tl_real. A finite value is one whose difference with itself is zero. */
#define TL_ISFINITE(x) ((x) - (x) == TL_C(0.0))

#endif
