/* Taylor coefficients of the elementary functions by their differential equations and closed forms in high precision: a hundred times
 * faster than the differences of reference_function.h, which know no formula and by which a test checks these. */
#ifndef TEST_REFERENCE_SERIES_H
#define TEST_REFERENCE_SERIES_H

#include "reference_function.h"

/* As ref_taylor, degree <= REF_MAX_DEGREE; takes the differences where a function, or a point, has no series here. */
void ref_series(const ref_function *function, double x, double y, int degree, mpfr_t *f);

#endif
