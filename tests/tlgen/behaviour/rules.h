/* exp(-x^2/2) and sin(x) cosh(y), as functions without a body for tlgen. */
#ifndef RULES_H
#define RULES_H

#include "taylor/tlgen.h"

#ifdef QUAD
#include <math.h>
static inline double rules_bump(double x) { return exp(-x * x / 2); }
static inline double rules_saddle(double x, double y) { return sin(x) * cosh(y); }
#else
double rules_bump(double x);
TLGEN(rule:rules_saddle_taylor) double rules_saddle(double x, double y);
#endif

#endif
