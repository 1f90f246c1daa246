/* What a build may choose, in one place: a program for a small processor replaces this file, or defines the same names on the command
 * line. Everything that is linked together must agree on them. */
#ifndef TAYLOR_CONFIG_H
#define TAYLOR_CONFIG_H

/* The number type: TL_FLOAT, TL_DOUBLE, TL_LONG_DOUBLE or TL_FLOAT128 (see real.h). */
#ifndef TL_REAL
#define TL_REAL TL_DOUBLE
#endif

/* The header with the mathematics. What takes the place of math.h declares its functions for the number type, and HUGE_VAL and NAN;
 * TL_LIBM(sin) is by default the function that math.h has for the number type, and may be defined here as any other. Where there are no
 * vectors, sines and cosines are libtaylor's own, unless the header is another or TL_OTHER_MATHEMATICS is defined. */
#ifndef TL_MATH_HEADER
#define TL_MATH_HEADER <math.h>
#elif !defined(TL_OTHER_MATHEMATICS)
#define TL_OTHER_MATHEMATICS
#endif

/* The largest order in t and the largest power of s of a shape. The runtime needs 2 and 2. */
#ifndef TL_MAX_ORDER
#define TL_MAX_ORDER 16
#endif
#ifndef TL_MAX_CURVE
#define TL_MAX_CURVE 64
#endif

/* Bytes at whose multiples arrays start: a power of two, enough for every type. 64 is a cache line, and any vector register. */
#ifndef TL_ALIGNMENT
#define TL_ALIGNMENT 64
#endif

#endif
