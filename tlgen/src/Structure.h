// What is proved of a model's equations of motion at all states: that t occurs nowhere, that the mass matrix is constant.
#ifndef TLGEN_STRUCTURE_H
#define TLGEN_STRUCTURE_H

#include "Needs.h"

namespace tlgen {

// The values that the named result is computed from, indices and loops included; none where there is no such result.
std::vector<Node *> valuesOf(const Results &results, const std::string &name);

// The values of all functions, likewise.
std::vector<Node *> valuesOf(const Equations &equations);

// Whether some of the values depend on an input of one of the kinds, conditions and indices included.
bool dependOn(const std::vector<Node *> &values, const std::set<Slot::Kind> &kinds);

// What is known of a matrix's rows before they are computed: a row is zero, has entries in the columns of one coordinate, in the first
// coordinates' columns, or anywhere. entries: that can be other than zero, of all.
struct RowClasses {
  long zero = 0, local = 0, prefix = 0, dense = 0;
  long entries = 0, all = 0;
};

// Of a matrix with so many columns, of n coordinates.
RowClasses classesOf(const Results &results, const std::string &name, long columns, long n);

// Whether M, of simulate, depends on parameters alone.
bool isMassConstant(const Results &simulate);

// Whether neither L, nor a force, dissipation or constraint, depends on t.
bool isAutonomous(const Equations &equations);

} // namespace tlgen

#endif
