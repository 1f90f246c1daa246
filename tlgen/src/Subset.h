// Refuses what tlgen does not accept, everywhere at once. The default is no. One of the files that see Clang.
#ifndef TLGEN_SUBSET_H
#define TLGEN_SUBSET_H

#include "Calls.h"

namespace tlgen {

// The id of the message that refuses a type, or null where it is accepted as a variable's. Behind a pointer a struct may have members
// of types that are not accepted themselves: those are refused where they are used.
const char *refusedType(clang::QualType type);

// The same for a member of a struct behind a pointer: where that is a struct, it may be a step to its members.
const char *refusedMember(const clang::FieldDecl *field);

// Walks the model's functions and all that they call. Returns them, callees before callers; whole only where nothing was reported.
std::vector<Instance> checkSubset(const Source &source, const Match &match);

} // namespace tlgen

#endif
