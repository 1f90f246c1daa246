// The sparse solution of M qdd = Q + A' lambda, A qdd = b as values of straight-line code.
#ifndef TLGEN_ELIMINATION_H
#define TLGEN_ELIMINATION_H

#include "Needs.h"

namespace tlgen {

// From the results of simulate with explicit columns: LDL' of [M A'; A 0], where zeros that are known are no operations. Coordinates
// are eliminated before constraint rows, so that no pivot can vanish where M is positive definite and the rows are independent; of
// several, the one that leaves the fewest others to change, and whose own numbers are ready first.
//
//   qdd: n   lambda: m   Qc: n, A' lambda
//   inverse: one over each pivot of a coordinate, each once: positive where M is
//   growth: what a pivot was before others were eliminated, over what it is; of coordinates those that change. Between 0 and 1/c where
//   the equations are at least c away from singular, in the sense of EOM_MOTION_SAFE_PIVOT.
//
// Throws Unsuitable where the matrices are not known element by element, or the code would be too long.
Results eliminated(Graph &graph, const Results &simulate, long n, long m1, long m2);

} // namespace tlgen

#endif
