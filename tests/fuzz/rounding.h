/* Points at which rounding in double says more than the model does. */
#ifndef FUZZ_ROUNDING_H
#define FUZZ_ROUNDING_H

#include "reference.h"

/* What the main of a test program calls that is compiled with double in the place of __float128: keeps the model's functions. */
int fuzz_keep_rounded(int argc, char **argv, const tlgen_selftest *test);

/* True where some function of the source, as plain C in double, is further than that from itself in quad precision, relative to the
 * scale of its group: it lies on the other side of a jump, or large numbers cancel. Generated code cannot do better, and is not asked.
 */
bool rounding_prevails(const fuzz_model *m, const fuzz_point *p, double tolerance, const double scale[FUZZ_GROUP_COUNT]);

#endif
