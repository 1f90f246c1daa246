// Refuses what tlgen does not accept, everywhere at once. The default is no. One of the files that see Clang.
#ifndef TLGEN_SUBSET_H
#define TLGEN_SUBSET_H

#include "Match.h"

namespace tlgen {

// Walks the model's functions and all that they call. Returns them, callees before callers; whole only where nothing was reported.
std::vector<const clang::FunctionDecl *> checkSubset(const Source &source, const Match &match);

// What the two passes over an expression must agree on: the math function that a call means, or null.
const MathFunction *mathCallee(const clang::FunctionDecl *callee, const Source &source);

} // namespace tlgen

#endif
