// The reverse sweep: derivatives of a value with respect to elements of its inputs, as values of the same graph.
//
// Every loop that the value was computed in gets a loop that runs the other way. What it needs of the forward loop is made again, or
// read from a tape: see Tapes.h. Which values get adjoints at all: see Varied.h.
#ifndef TLGEN_REVERSE_H
#define TLGEN_REVERSE_H

#include "Analyses.h"
#include "Graph.h"

#include <set>

namespace tlgen {

// adjoint is to be seeded into value. Both belong to the same loop, or to none.
struct Seed {
  Node *value, *adjoint;
};

// value is a part of the derivative with respect to element indices of a slot; in a loop, once for each iteration.
struct Contribution {
  Loop *loop;
  std::vector<Node *> indices;
  Node *value;
};

struct Adjoints {
  std::map<const Slot *, std::vector<Contribution>> of;
  const Node *noFormula = nullptr; // a function without a formula for its derivative, where one was met; then of is not complete
};

// The derivatives of sum(adjoint * value) with respect to the wanted slots.
Adjoints reverse(Graph &graph, const std::vector<Seed> &seeds, const std::set<const Slot *> &wanted, const Analyses &analyses = {});

} // namespace tlgen

#endif
