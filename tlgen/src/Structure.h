// What is proved of a model's equations of motion at all states: that t occurs nowhere, that the mass matrix is constant.
#ifndef TLGEN_STRUCTURE_H
#define TLGEN_STRUCTURE_H

#include "Needs.h"

namespace tlgen {

// The values that the named result is computed from; none where there is no such result.
std::vector<Node *> valuesOf(const Results &results, const std::string &name);

// Whether some of the values depend on an input of one of the kinds, conditions and indices included.
bool dependOn(const std::vector<Node *> &values, const std::set<Slot::Kind> &kinds);

// Whether M, of simulate, depends on parameters alone.
bool isMassConstant(const Results &simulate);

// Whether neither L, nor a force or constraint, depends on t.
bool isAutonomous(const Equations &equations);

} // namespace tlgen

#endif
